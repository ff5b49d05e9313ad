#include "io/vertical_unit.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(VerticalUnit, KnowsWhatRastersSay) {
    for (const char* const name : {"m", "M", "metre", "Meter", "metres"})
        EXPECT_EQ(vertical_unit_named(name), (VerticalUnit{"m", 1.0})) << name;
    for (const char* const name : {"ft", "foot", "Feet"})
        EXPECT_EQ(vertical_unit_named(name), (VerticalUnit{"ft", 0.3048})) << name;
    for (const char* const name : {"us-ft", "US survey foot", "Foot_US", "ftUS"})
        EXPECT_EQ(vertical_unit_named(name), (VerticalUnit{"us-ft", 1200.0 / 3937.0})) << name;
    EXPECT_EQ(vertical_unit_named("km")->metres, 1000.0);
}

TEST(VerticalUnit, GuessesNothing) {
    for (const char* const name : {"", " ", "degree", "furlong", "m/s", "meters above sea level"})
        EXPECT_FALSE(vertical_unit_named(name).has_value()) << name;
}

}  // namespace
}  // namespace overfly
