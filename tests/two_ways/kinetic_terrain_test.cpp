#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "core/parallel.h"
#include "trace/kinetic.h"
#include "two_ways/terrain_flights.h"

namespace overfly {
namespace {

using namespace testing;

constexpr unsigned kSeed = 41;
constexpr int kWidth_px = 1920;
constexpr int kHeight_px = 1080;
constexpr std::size_t kPieces = 3;   // of each flight
constexpr std::size_t kTiles = 192;  // in each piece, each of so many random samples: a million in the seven flights
constexpr std::size_t kSamplesInTile = 256;
constexpr double kTile_px = 16.0;

// Where the flights are about, in shares of the extent.
constexpr double kMiddle = 0.45;

// A DEM, what its file doesn't say, and where in it there is data to fly over.
struct Dem {
    const char* file;
    const char* crs = "";
    double east = kMiddle, north = kMiddle;  // in shares of the extent
    double scale = 1.0;                      // of the flight
};
void PrintTo(const Dem& dem, std::ostream* out) { *out << dem.file; }

struct NamedFlight {
    const char* name;
    ShareFlight flight;
};

std::vector<NamedFlight> flights() {
    const auto turning = [](double by_deg) {
        return ShareFlight{{{0.0, 0.45, 0.45, 0.03, attitude(20, -25, 0)},
                            {0.5, 0.452, 0.452, 0.03, attitude(20 + 0.5 * by_deg, -25, 0)},
                            {1.0, 0.454, 0.454, 0.03, attitude(20 + by_deg, -25, 0)}}};
    };
    return {{"level", level_flight()},
            {"a steep dive",
             {{{0.0, 0.50, 0.45, 0.15, attitude(10, -70, 0)},
               {0.5, 0.50, 0.47, 0.07, attitude(10, -60, 0)},
               {1.0, 0.50, 0.49, 0.02, attitude(10, -30, 0)}}}},
            {"a fast pan", turning(80.0)},
            {"a barrel roll",
             {{{0.0, 0.45, 0.42, 0.03, attitude(20, -20, 0)},
               {0.5, 0.46, 0.44, 0.03, attitude(20, -20, 60)},
               {1.0, 0.47, 0.46, 0.03, attitude(20, -20, 120)}}}},
            {"five metres above the ground",
             {{{0.0, 0.45, 0.45, 0.002, attitude(40, -5, 0)},
               {0.5, 0.452, 0.452, 0.0, attitude(40, -5, 0)},
               {1.0, 0.454, 0.454, 0.002, attitude(40, -5, 0)}}}},
            {"a hover", turning(0.0)},
            {"straight down",
             {{{0.0, 0.45, 0.45, 0.05, attitude(0, -90, 0)},
               {0.5, 0.46, 0.46, 0.05, attitude(0, -90, 0)},
               {1.0, 0.47, 0.47, 0.05, attitude(0, -90, 0)}}}}};
}

constexpr double kTouch_m = 5.0;

FlightDocument document_of(const ElevationReport& report, const Dem& dem, const NamedFlight& named) {
    ShareFlight flight = named.flight;
    for (ShareFlight::Key& key : flight.keys) {
        key.east = dem.east + dem.scale * (key.east - kMiddle);
        key.north = dem.north + dem.scale * (key.north - kMiddle);
        key.height *= dem.scale;
    }
    FlightDocument document = flight_over(report, flight);
    for (Keyframe& key : document.keyframes) key.place.height_m += kTouch_m;
    return document;
}

// What the tracer itself finds when it checks every sample of some tiles of the picture.
TraceCounters checked(const Stage& stage, const MotionPiece& piece, unsigned seed) {
    const double film_per_px = 2.0 / kWidth_px;
    const KineticTracer tracer(stage.rays(), TraceCheck(stage.rays(), 1, kWidth_px));
    const KineticPiece prepared =
        tracer.prepare(piece, {-1.0, 1.0, -kHeight_px / (1.0 * kWidth_px), kHeight_px / (1.0 * kWidth_px)});
    std::vector<TraceCounters> counters(kTiles);
    parallel_for(kTiles, [&](std::size_t i) {
        std::mt19937 generator(seed + static_cast<unsigned>(i));
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        const double left = -1.0 + film_per_px * unit(generator) * (kWidth_px - kTile_px);
        const double top = film_per_px * (unit(generator) * (kHeight_px - kTile_px) - 0.5 * kHeight_px);
        std::vector<ImageSample> samples(kSamplesInTile);
        for (ImageSample& s : samples)
            s = {left + film_per_px * kTile_px * unit(generator), top + film_per_px * kTile_px * unit(generator), 0.0};
        SegmentLists lists;
        tracer.trace(prepared, samples, std::vector<TimeRange>{piece.when}, lists, counters[i]);
    });
    TraceCounters all;
    for (const TraceCounters& c : counters) all += c;
    return all;
}

class KineticTerrain : public ::testing::TestWithParam<Dem> {};

INSTANTIATE_TEST_SUITE_P(Flights, KineticTerrain,
                         ::testing::Values(Dem{"bigtujunga_srtm30m_utm11n.tif"}, Dem{"sthelens_usgs30m_nad27utm10.dem"},
                                           Dem{"zion_srtm90m_wgs84.tif"}, Dem{"rmnp_dem_wgs84_nonsquare.tif"},
                                           Dem{"N42E001.hgt"}, Dem{"N41E001.hgt"}, Dem{"pyrenees_mosaic.vrt"},
                                           Dem{"N48W125.hgt.zip", "", 0.65, 0.15},
                                           Dem{"rainier_adams_srtm90m_cog_lerc.tif"}, Dem{"n35e138_fuji.dt1"},
                                           Dem{"n35e138_fuji.dt0"}, Dem{"trinidad_usgs1deg_feet.tif"},
                                           Dem{"hawaii_etopo5_antimeridian_km.nc", "EPSG:4326"},
                                           Dem{"vanderford_multibeam_64m_epsg3031_cog.tif", "", 0.56, 0.217, 0.1},
                                           Dem{"nrw_lidar_dsm1m_utm32n.tif"}, Dem{"tirol_wog_5m_mgi_lambert.asc"}));

// In 99.99 % of random (sample, time) pairs a ray sees the triangle that the tracer told of; the others are within a
// thousandth of a pixel of an edge, but for one in a hundred thousand. In no flight it is less than 99.98 %: where 13
// million samples reach to the horizon, triangles are so small that many points are that near to an edge.
TEST_P(KineticTerrain, AgreesWithRays) {
    TerrainDocument document = terrain_of(std::filesystem::path(OVERFLY_SHARED_DATA) / "dem" / GetParam().file);
    if (*GetParam().crs != '\0') document.source.crs = GetParam().crs;
    const std::filesystem::path cache = std::filesystem::path(::testing::TempDir()) / "overfly-no-cache";
    PreparedTerrain terrain = prepare_terrain(document, cache / GetParam().file);
    const ElevationReport report = terrain.scene.report;
    const Stage stage(std::move(terrain), middle_of(document_of(report, GetParam(), flights().front())));
    TraceCounters total;
    for (const NamedFlight& named : flights()) {
        const FlightDocument flight = document_of(report, GetParam(), named);
        const Motion motion = motion_over(flight, stage, {0.01, kWidth_px, kHeight_px, 1.0 / 3.0});
        TraceCounters part;
        for (std::size_t k = 0; k < kPieces; ++k)
            part += checked(stage, motion.pieces[(2 * k + 1) * motion.pieces.size() / (2 * kPieces)],
                            kSeed + 1000U * static_cast<unsigned>(k));
        std::cout << "  " << named.name << ": " << part.checked << " checked, " << part.differed << " differ, "
                  << part.differed_by_edge << " by an edge\n";
        EXPECT_LE(part.differed * 5'000, part.checked) << named.name << ", seed " << kSeed;
        total += part;
    }
    EXPECT_LE(total.differed * 10'000, total.checked) << "seed " << kSeed;
    EXPECT_LE((total.differed - total.differed_by_edge) * 100'000, total.checked) << "seed " << kSeed;
}

}  // namespace
}  // namespace overfly
