#include <gtest/gtest.h>

#include "shot/shot_sight.h"
#include "two_ways/frame_laws.h"

namespace overfly {
namespace {

using namespace testing;

// A slab that tumbles past the camera, and a lake that it and the mountains are mirrored in.
std::vector<BodyDocument> tumbling_slab_and_lake(const FlightPlace& slab_place, const FlightPlace& lake_place) {
    BodyDocument slab;
    slab.name = "slab";
    const auto face = [](double z) { return Polygon{{-60, -250, z}, {60, -250, z}, {60, 250, z}, {-60, 250, z}}; };
    slab.shape = std::vector<Polygon>{face(-8.0), face(8.0)};
    slab.motion = BodyPolynomials{slab_place, {{0, 300}}, {{0, -120}}, {{0, 40, -20}}, {{30, 150}}, {{10}}, {{0, 500}}};
    slab.albedo = {0.8F, 0.2F, 0.1F};
    BodyDocument lake;
    lake.name = "lake";
    lake.shape = std::vector<Polygon>{{{-3000, -3000, 0}, {3000, -3000, 0}, {3000, 3000, 0}, {-3000, 3000, 0}}};
    lake.motion = BodyPolynomials{lake_place, {}, {}, {}, {}, {}, {}};
    lake.albedo = {0.02F, 0.05F, 0.08F};
    lake.mirror = 0.6;
    return {slab, lake};
}

class BodyFrames : public ::testing::Test {
  protected:
    BodyFrames() {
        shot_.flight = flight_.document;
        shot_.image = {kSize.width, kSize.height, false};
        shot_.look.look.sun_elevation = Angle::degrees(12.0);
        shot_.look.sun_shadows = SunShadows::Exact;
        const Keyframe& k = shot_.flight.keyframes[1];
        const CameraPath path = make_path(shot_.flight, stage_);
        const Geodetic camera = path.place_at(k.time_s);
        // 2.5 km ahead, and below.
        const auto ahead = [&](double north_m, double east_m, double up_m) {
            return FlightPlace{camera.lon + Angle::degrees(east_m / 88'000.0),
                               camera.lat + Angle::degrees(north_m / 111'000.0), camera.height_m + up_m,
                               HeightAbove::Ellipsoid};
        };
        shot_.bodies = tumbling_slab_and_lake(ahead(2200.0, 500.0, -350.0), ahead(4500.0, 1800.0, -900.0));
        shot_.frames.rate = {24, 1};
        bodies_ = make_bodies(shot_, stage_);
    }

    [[nodiscard]] FrameMaker maker(const Sight& sight) const {
        return {stage_, sight, kSize, kExposure, shot_, bodies_};
    }
    [[nodiscard]] Sight sight() const {
        const CameraPath path = make_path(shot_.flight, stage_);
        const Daylight day(shot_.look.look);
        return make_sight(shot_, path, flight_.sight(kSize).motions.front(), {stage_, bodies_, day.to_sun()});
    }

    static constexpr PictureSize kSize = {96, 54};
    static constexpr TimeRange kExposure = half_a_frame(1.0);

    SampleFlight flight_{level_flight()};
    const Stage& stage_ = flight_.stage;
    ShotDocument shot_;
    ShotBodies bodies_;
};

// With a mirror, a body that turns, and its shadow and those of the mountains.
TEST_F(BodyFrames, SixteenLinesAreWithinFourThousandths) {
    const Sight seen = sight();
    expect_sixteen_lines_suffice(maker(seen), "bodies, mirror and shadows");
}

// The kinetic tracer follows the ground, the interval tracer bodies and what is in mirrors.
TEST_F(BodyFrames, AreTheSameWithTheKineticTracer) {
    const Sight seen = sight();
    expect_kinetic_lines_to_be_the_interval_tracers(maker(seen), 4);
}

// Without them the picture is another, so that the test above has something to see.
TEST_F(BodyFrames, BodiesMirrorsAndShadowsAreInThePicture) {
    const Sight seen = sight();
    const Frame all = maker(seen).by_lines(2);
    shot_.bodies[0].shadow = shot_.bodies[1].shadow = false;
    const Frame no_shadows = maker(seen).by_lines(2);
    shot_.sampling.mirror_depth = 0;
    const Sight blind = sight();
    const Frame no_mirror = maker(blind).by_lines(2);
    shot_.look.sun_shadows = SunShadows::Baked;
    const Frame no_mountain_shadows = maker(blind).by_lines(2);
    EXPECT_GT(root_mean_square(all, no_shadows), 0.005);
    EXPECT_GT(root_mean_square(no_shadows, no_mirror), 0.005);
    EXPECT_GT(root_mean_square(no_mirror, no_mountain_shadows), 0.002);
}

}  // namespace
}  // namespace overfly
