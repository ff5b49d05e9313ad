#include "flight/check_flight.h"

#include <gtest/gtest.h>

#include <limits>

#include "flights.h"

namespace overfly {
namespace {

using flights::deg;
using flights::keyframe;
using flights::looking;
using flights::place;

// Ground at 1000 m, from 0 to 1 degree east only.
Surroundings plateau() {
    Surroundings world = flights::bare_ellipsoid();
    world.ground_height_m = [](Angle lon, Angle) -> std::optional<double> {
        if (lon.degrees() < 0.0 || lon.degrees() > 1.0) return std::nullopt;
        return 1000.0;
    };
    return world;
}

FlightPlace above_ground(double lon_deg, double lat_deg, double height_m) {
    return {deg(lon_deg), deg(lat_deg), height_m, HeightAbove::Ground};
}

// The one problem that is expected, as a line.
std::string only_problem(const std::vector<Keyframe>& keyframes) {
    const std::vector<Place> places{{"f.yaml", 3, 5}, {"f.yaml", 9, 5}};
    const std::vector<Problem> problems = check_keyframes(keyframes, places, plateau());
    EXPECT_EQ(problems.size(), 1U);
    return problems.empty() ? "" : problems.front().text();
}

void expect_says(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(CheckFlight, ASoundFlightHasNoProblems) {
    EXPECT_TRUE(check_keyframes(flights::varied(), {}, flights::bare_ellipsoid()).empty());
    // Off the terrain, but not counted from it.
    EXPECT_TRUE(check_keyframes({keyframe(0, place(5.0, 0.0, 10.0), {})}, {}, plateau()).empty());
}

TEST(CheckFlight, NoKeyframe) { EXPECT_EQ(check_keyframes({}, {}, plateau()).size(), 1U); }

TEST(CheckFlight, NoGroundToCountFrom) {
    const std::string text = only_problem({keyframe(0, above_ground(5.0, 0.0, 10.0), {})});
    expect_says(text, "f.yaml:3:5: keyframes[0]: lon 5.000000, lat 0.000000");
    expect_says(text, "no terrain");
}

TEST(CheckFlight, BelowTheGround) {
    expect_says(only_problem({keyframe(0, place(0.5, 0.0, 987.6), {})}), "12.4 m below the ground");
    expect_says(only_problem({keyframe(0, above_ground(0.5, 0.0, -2.0), {})}), "2.0 m below the ground");
}

TEST(CheckFlight, Targets) {
    expect_says(only_problem({looking(0, place(0.5, 0.0, 2000.0), above_ground(5.0, 0.0, 0.0))}), "target at lon 5");
    expect_says(only_problem({looking(0, place(0.5, 0.0, 2000.0), place(0.5, 0.0, 2000.0))}), "where the camera is");
}

TEST(CheckFlight, TimesMustIncrease) {
    const std::string text =
        only_problem({keyframe(4, place(0.5, 0.0, 2000.0), {}), keyframe(4, place(0.6, 0.0, 2000.0), {})});
    expect_says(text, "f.yaml:9:5: keyframes[1]");
    expect_says(text, "time_s 4 is not after 4");
}

TEST(CheckFlight, NeighboursMustBeNear) {
    expect_says(only_problem({keyframe(0, place(10.0, 0.0, 2000.0), {}), keyframe(1, place(-170.0, 0.0, 2000.0), {})}),
                "a quarter of the Earth");
}

TEST(CheckFlight, NumbersMustBeFiniteAndInRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_says(only_problem({keyframe(nan, place(0.5, 0.0, 2000.0), {})}), "time_s");
    expect_says(only_problem({keyframe(0, place(0.5, 0.0, nan), {})}), "finite");
    expect_says(only_problem({keyframe(0, place(0.5, 91.0, 2000.0), {})}), "lat from -90 to 90");
    expect_says(only_problem({keyframe(0, place(0.5, 0.0, 2000.0), {deg(0), deg(-91.0), deg(0)})}), "pitch -91");
    expect_says(only_problem({keyframe(0, place(0.5, 0.0, 2000.0), {}, 180.0)}), "field of view 180");
    expect_says(only_problem({looking(0, place(0.5, 0.0, 2000.0), place(0.5, nan, 0.0))}), "target");
}

}  // namespace
}  // namespace overfly
