#include "geo/geoid.h"

#include <cstddef>

#include <gtest/gtest.h>

namespace overfly {
namespace {

// Every 30 degrees, from -180 eastwards and from the north pole southwards. The value tells the sample: column + 100 *
// row, but at the poles, where there is only one place.
Geoid coarse_geoid(int columns) {
    Geoid geoid{columns, 7, -180.0, 90.0, 30.0, 30.0, {}};
    for (int row = 0; row < geoid.rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const bool is_pole = row == 0 || row == geoid.rows - 1;
            geoid.undulation_m.push_back(static_cast<float>((is_pole ? 0 : column % 12) + 100 * row));
        }
    return geoid;
}

double at(const Geoid& geoid, double lon_deg, double lat_deg) {
    return geoid.undulation_m_at(Angle::degrees(lon_deg), Angle::degrees(lat_deg));
}

class GeoidOfColumns : public testing::TestWithParam<int> {};
// 13 columns: the last one repeats the first, as some files have it.
INSTANTIATE_TEST_SUITE_P(Both, GeoidOfColumns, testing::Values(12, 13));

TEST_P(GeoidOfColumns, GivesSamplesAndInterpolatesBetween) {
    const Geoid geoid = coarse_geoid(GetParam());
    EXPECT_NEAR(at(geoid, -180, 60), 100, 1e-9);
    EXPECT_NEAR(at(geoid, 0, 0), 306, 1e-9);
    EXPECT_NEAR(at(geoid, 15, 0), 306.5, 1e-9);
    EXPECT_NEAR(at(geoid, 15, -15), 356.5, 1e-9);
}

TEST_P(GeoidOfColumns, HasNoSeamAtTheAntimeridian) {
    const Geoid geoid = coarse_geoid(GetParam());
    // Between the last column, 11, and the first, 0.
    EXPECT_NEAR(at(geoid, 165, 60), 105.5, 1e-9);
    EXPECT_NEAR(at(geoid, 179.9999999, 60), 100, 1e-6);
    EXPECT_NEAR(at(geoid, -179.9999999, 60), 100, 1e-6);
    EXPECT_NEAR(at(geoid, 180, 60), at(geoid, -180, 60), 1e-9);
}

TEST_P(GeoidOfColumns, TakesLongitudesOfAnyTurn) {
    const Geoid geoid = coarse_geoid(GetParam());
    for (const double lon_deg : {-170.0, -3.25, 77.0, 179.5})
        for (const double turn_deg : {-720.0, -360.0, 360.0})
            EXPECT_NEAR(at(geoid, lon_deg + turn_deg, 20), at(geoid, lon_deg, 20), 1e-9) << lon_deg;
}

TEST_P(GeoidOfColumns, IsOneValueAtAPole) {
    const Geoid geoid = coarse_geoid(GetParam());
    for (const double lon_deg : {-180.0, -91.0, 0.0, 123.0}) {
        EXPECT_NEAR(at(geoid, lon_deg, 90), 0, 1e-9);
        EXPECT_NEAR(at(geoid, lon_deg, -90), 600, 1e-9);
    }
    EXPECT_NEAR(at(geoid, 0, 89.999999), 0, 1e-4);
    EXPECT_NEAR(at(geoid, 0, -89.999999), 600, 1e-4);
}

}  // namespace
}  // namespace overfly
