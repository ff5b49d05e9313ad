#include "shade/body_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shade/ground_light.h"

namespace overfly {
namespace {

const Rgb kWhite = {1.0F, 1.0F, 1.0F};

Incidence level(const Daylight& day) { return {{0, 0, 1}, day.to_sun(), {0, 0, 1}}; }

TEST(BodyLight, OfALevelSurfaceIsThatOfLevelGround) {
    const Daylight day{Look{}};
    const MattLight seen = matt_light(kWhite, level(day), day);
    EXPECT_NEAR(seen.sun.g, static_cast<float>(day.to_sun().z) * day.sun().g, 1e-5F);
    EXPECT_NEAR(seen.around.b, day.sky().b, 1e-5F);
}

TEST(BodyLight, FromBelowIsThatOfTheGround) {
    const Daylight day{Look{}};
    Incidence at = level(day);
    at.normal = {0, 0, -1};
    EXPECT_NEAR(matt_light(kWhite, at, day).around.r, ground_around(day).r, 1e-5F);
}

TEST(BodyLight, AMirrorMirrorsAllAtGrazing) {
    EXPECT_DOUBLE_EQ(mirrored_share(0.02, 1.0), 0.02);
    EXPECT_DOUBLE_EQ(mirrored_share(0.02, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(mirrored_share(1.0, 0.3), 1.0);
    EXPECT_LT(mirrored_share(0.02, 0.5), mirrored_share(0.02, 0.2));
}

}  // namespace
}  // namespace overfly
