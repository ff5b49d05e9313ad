#include "film/cryptomatte.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "film/layers.h"

namespace overfly {
namespace {

TEST(Cryptomatte, NumbersAnObjectAsItsSpecificationDoes) {
    EXPECT_EQ(cryptomatte_id("torus"), 4053562365U);
    EXPECT_FLOAT_EQ(cryptomatte_number(cryptomatte_id("torus")), -1.54943624832e+30F);
    EXPECT_EQ(cryptomatte_hex(4053562365U), "f19c73fd");
    EXPECT_EQ(cryptomatte_hex(0x00800000U), "00800000");
}

// Values of MurmurHash3_x86_32 that are published, and one for each length of the last block.
TEST(Cryptomatte, HashesTextsOfAnyLength) {
    EXPECT_EQ(cryptomatte_id("test"), 0xba6bd213U);
    EXPECT_EQ(cryptomatte_id("Hello, world!"), 0xc0363e43U);
    EXPECT_EQ(cryptomatte_id("The quick brown fox jumps over the lazy dog"), 0x2e4ff723U);
    EXPECT_EQ(cryptomatte_id("a"), 0x3c2569b2U);
    EXPECT_EQ(cryptomatte_id("aa"), 0x371091a9U);
    EXPECT_EQ(cryptomatte_id("aaa"), 0xb4d05fb7U);
    EXPECT_EQ(cryptomatte_id("aaaa"), 0x7eeed987U);
    EXPECT_EQ(cryptomatte_id("Gr\xc3\xb6\xc3\x9f"
                             "e"),
              0xe36f382eU);
}

TEST(Cryptomatte, HasOneKeyForItsLayer) {
    EXPECT_EQ(cryptomatte_key(), "3ae39a5");
    for (const std::string_view channel : kind_of(Layer::Cryptomatte).channels)
        EXPECT_TRUE(channel.starts_with(kCryptomatteType)) << channel;
}

TEST(Cryptomatte, HasNumbersThatAreFiniteAndNormal) {
    EXPECT_EQ(cryptomatte_id(""), 1U << 23U);  // its hash is 0
    for (int i = 0; i < 20000; ++i) {
        const std::string name = "object " + std::to_string(i);
        EXPECT_TRUE(std::isnormal(cryptomatte_number(cryptomatte_id(name)))) << name;
    }
}

}  // namespace
}  // namespace overfly
