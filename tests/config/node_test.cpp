#include "config/node.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace overfly::config {
namespace {

Node scalar(const std::string& text) {
    Node node;
    node.kind = Node::Kind::Scalar;
    node.scalar = text;
    return node;
}

TEST(NumberOf, ReadsDecimalNumbers) {
    EXPECT_EQ(number_of(scalar("12")), 12.0);
    EXPECT_EQ(number_of(scalar("+12.5")), 12.5);
    EXPECT_EQ(number_of(scalar("-1e-3")), -0.001);
    EXPECT_EQ(number_of(scalar(".5")), 0.5);
    EXPECT_EQ(number_of(scalar("007")), 7.0);
}

TEST(NumberOf, ReadsYamlsWordsForWhatIsNotFinite) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(number_of(scalar(".inf")), infinity);
    EXPECT_EQ(number_of(scalar("+.INF")), infinity);
    EXPECT_EQ(number_of(scalar("-.Inf")), -infinity);
    EXPECT_TRUE(std::isnan(number_of(scalar(".nan")).value()));
    EXPECT_TRUE(std::isnan(number_of(scalar("nan")).value()));
    EXPECT_TRUE(std::isinf(number_of(scalar("1e999")).value()));
}

TEST(NumberOf, RefusesAllElse) {
    for (const char* text : {"", " ", "abc", "1 2", "1,5", "12m", "0x10", "+-1", "--1", "1e", ".", "1_000", " 1"}) {
        EXPECT_EQ(number_of(scalar(text)), std::nullopt) << '"' << text << '"';
    }
    EXPECT_EQ(number_of(Node::nothing({})), std::nullopt);
}

TEST(InQuotes, IsOneHarmlessLine) {
    EXPECT_EQ(in_quotes("abc"), "'abc'");
    EXPECT_EQ(in_quotes("a\nb\x1b[31m"), "'a?b?[31m'");
    EXPECT_EQ(in_quotes("caf\xC3\xA9"), "'caf\xC3\xA9'");
    EXPECT_EQ(in_quotes(std::string(100, 'x')), '\'' + std::string(60, 'x') + "...'");
    // Cut between characters, not inside of one.
    EXPECT_EQ(in_quotes(std::string(59, 'x') + "\xC3\xA9" + "yyy"), '\'' + std::string(59, 'x') + "...'");
}

}  // namespace
}  // namespace overfly::config
