// Our way from a raster to scene metres against PROJ and GDAL, which go it without a line of ours.

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geo/scene_frame.h"
#include "io/elevation_file.h"
#include "io/geoid_file.h"
#include "io/sample_raster.h"
#include "terrain/triangulate.h"

namespace overfly {
namespace {

constexpr double kAgreement_m = 1e-3;

Geodetic place(double lon_deg, double lat_deg, double height_m) {
    return {Angle::degrees(lon_deg), Angle::degrees(lat_deg), height_m};
}

const std::string kGeoidPipeline =
    "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=vgridshift +grids=egm96_15.gtx "
    "+multiplier=1 +step +proj=unitconvert +xy_in=rad +xy_out=deg";

TEST(ProjAgreement, SceneCoordinatesWithin100kmOfAnyOrigin) {
    constexpr unsigned kSeed = 1991;
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), share(0, 1), height_m(-11'000, 20'000);
    const Geodetic origins[] = {place(-105.4249, 37.7440, 0), place(179.95, -16.8, 120), place(-179.999, 66, -40),
                                place(30, 89.7, 2800),        place(-120, -89.95, 0),    place(0, 0, 8000)};
    for (const Geodetic& origin : origins) {
        const SceneFrame frame(origin);
        const Proj proj(
            fmt::format("+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart "
                        "+ellps=WGS84 +step +proj=topocentric +ellps=WGS84 +lon_0={:.17g} +lat_0={:.17g} "
                        "+h_0={:.17g}",
                        origin.lon.degrees(), origin.lat.degrees(), origin.height_m));
        for (int i = 0; i < 500; ++i) {
            // Uniform over the disk of 100 km, laid on the tangent plane and dropped to the ellipsoid.
            const double r_m = 100'000 * std::sqrt(share(random)), phi = turn(random);
            Geodetic there = frame.geodetic({r_m * std::cos(phi), r_m * std::sin(phi), 0});
            there.height_m = height_m(random);
            const auto expected = proj({there.lon.degrees(), there.lat.degrees(), there.height_m});
            const Point<Scene> p = frame.scene(there);
            EXPECT_LT(distance(p, {expected[0], expected[1], expected[2]}), kAgreement_m)
                << "seed " << kSeed << ", origin " << origin.lon.degrees() << " " << origin.lat.degrees();
        }
    }
}

TEST(ProjAgreement, GeoidIsProjsGrid) {
    const Geoid geoid = read_egm96();
    const Proj proj(kGeoidPipeline);
    constexpr unsigned kSeed = 96;
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> lon_deg(-180, 180), lat_deg(-90, 90);
    double largest_m = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const double lon = lon_deg(random), lat = lat_deg(random);
        const double expected_m = proj({lon, lat, 0.0})[2];
        largest_m = std::max(largest_m, std::abs(expected_m));
        EXPECT_NEAR(geoid.undulation_m_at(Angle::degrees(lon), Angle::degrees(lat)), expected_m, kAgreement_m)
            << "seed " << kSeed << ", at " << lon << " " << lat;
    }
    EXPECT_GT(largest_m, 80.0) << "PROJ did not use the grid itself";
}

// NGA's test values of EGM96 (their F477 interpolation of the same 15' grid; bilinear differs by centimetres).
TEST(ProjAgreement, GeoidIsNearNgasOwnValues) {
    const Geoid geoid = read_egm96();
    EXPECT_NEAR(geoid.undulation_m_at(Angle::degrees(269.658920), Angle::degrees(38.628155)), -31.629, 0.1);
    EXPECT_NEAR(geoid.undulation_m_at(Angle::degrees(305.021114), Angle::degrees(-14.621217)), -2.966, 0.1);
    EXPECT_NEAR(geoid.undulation_m_at(Angle::degrees(102.448729), Angle::degrees(46.874319)), -43.572, 0.1);
    EXPECT_NEAR(geoid.undulation_m_at(Angle::degrees(-1.0 - 22.0 / 60), Angle::degrees(50.0)), 46.0, 3.0);
}

TEST(ProjAgreement, MeshVerticesAreWhereGdalPutsThePixelCentres) {
    const ElevationFile elevation = read_elevation({.dem = {blanca()}});
    const SceneFrame frame(elevation.centre);
    const TerrainMesh mesh = triangulate(*elevation.model, frame, elevation.locate);
    ASSERT_EQ(mesh.positions.size(), elevation.model->size()) << "no voids: vertices are samples";

    const Proj geographic("EPSG:32613", "EPSG:4326"), geocentric("EPSG:4979", "EPSG:4978"), geoid(kGeoidPipeline);
    const Transform<Ecef, Scene> ecef_from_scene = inverse(frame.scene_from_ecef());
    for (std::size_t i = 0; i < mesh.positions.size(); i += 997) {
        const double column = static_cast<double>(i % 694), row = static_cast<double>(i / 694);
        auto p = geographic({436050 + 75 * (column + 0.5), 4203000 - 75 * (row + 0.5), 0});
        p[2] = static_cast<double>(elevation.model->height_m[i]);
        p = geocentric(geoid(p));
        EXPECT_LT(distance(ecef_from_scene * mesh.positions[i], {p[0], p[1], p[2]}), kAgreement_m) << "sample " << i;
    }
}

}  // namespace
}  // namespace overfly
