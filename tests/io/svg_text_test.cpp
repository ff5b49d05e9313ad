#include "io/svg_text.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"

namespace overfly {
namespace {

TEST(SvgText, WritesNumbersShortly) {
    EXPECT_EQ(svg_number(0.0), "0");
    EXPECT_EQ(svg_number(-0.001), "0");
    EXPECT_EQ(svg_number(12.0), "12");
    EXPECT_EQ(svg_number(1.5), "1.5");
    EXPECT_EQ(svg_number(-2.345), "-2.35");
    EXPECT_EQ(svg_number(100.0), "100");
}

TEST(SvgText, RefusesWhatIsNoNumber) {
    EXPECT_THROW(static_cast<void>(svg_number(std::numeric_limits<double>::quiet_NaN())), InternalError);
    EXPECT_THROW(static_cast<void>(svg_number(std::numeric_limits<double>::infinity())), InternalError);
}

TEST(SvgText, WritesPaths) {
    EXPECT_EQ(svg_path({}), "");
    EXPECT_EQ(svg_path(std::vector<SvgPoint>{{1.0, 2.0}, {3.5, -4.0}}), "M1 2L3.5 -4");
}

TEST(SvgText, WritesADocument) {
    SvgText svg(200.0, 100.0, "a < b", ".x { fill: red }");
    svg.open("g", {{"class", "x"}});
    svg.add("rect", {{"x", 1.0}, {"fill", std::string("\"&\"")}});
    svg.add("circle", {{"r", 2.5}}, "tip & more");
    svg.text({3.0, 4.0}, "x", "words > none", {{"style", "fill:#fff"}});
    svg.close();
    EXPECT_EQ(svg.document(),
              "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\" viewBox=\"0 0 200 100\" "
              "role=\"img\">\n<title>a &lt; b</title>\n<style>.x { fill: red }</style>\n"
              "<g class=\"x\">\n"
              "<rect x=\"1\" fill=\"&quot;&amp;&quot;\"/>\n"
              "<circle r=\"2.5\"><title>tip &amp; more</title></circle>\n"
              "<text x=\"3\" y=\"4\" class=\"x\" style=\"fill:#fff\">words &gt; none</text>\n"
              "</g>\n</svg>\n");
}

TEST(SvgText, KeepsGroupsClosed) {
    SvgText svg(1.0, 1.0, "", "");
    EXPECT_THROW(svg.close(), InternalError);
    svg.open("g", {});
    EXPECT_THROW(static_cast<void>(svg.document()), InternalError);
}

}  // namespace
}  // namespace overfly
