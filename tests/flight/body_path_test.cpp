#include "flight/body_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "flight/flights.h"

namespace overfly {
namespace {

using namespace flights;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A body at the origin of the frame at (0 E, 0 N), where east, north and up are x, y and z.
BodyPolynomials at_origin() {
    BodyPolynomials motion;
    motion.place = place(0.0, 0.0, 0.0);
    return motion;
}

BodyPath body_path(const BodyMotion& motion) { return {motion, frame_at(0.0, 0.0), bare_ellipsoid()}; }

void expect_near(Vector<Scene> got, Vector<Scene> wanted, double tolerance) {
    EXPECT_NEAR(got.x, wanted.x, tolerance);
    EXPECT_NEAR(got.y, wanted.y, tolerance);
    EXPECT_NEAR(got.z, wanted.z, tolerance);
}

void expect_near(const Transform<Scene, Body>& got, const Transform<Scene, Body>& wanted, double tolerance_m) {
    expect_near(got.translation, wanted.translation, tolerance_m);
    expect_near(got.rotation.x, wanted.rotation.x, 1e-12);
    expect_near(got.rotation.y, wanted.rotation.y, 1e-12);
    expect_near(got.rotation.z, wanted.rotation.z, 1e-12);
}

// Where a body's axes point at heading, pitch and roll.
Rotation<Scene, Body> turned(double heading_deg, double pitch_deg, double roll_deg) {
    BodyPolynomials motion = at_origin();
    motion.heading_deg.coefficients = {heading_deg};
    motion.pitch_deg.coefficients = {pitch_deg};
    motion.roll_deg.coefficients = {roll_deg};
    return body_path(motion).pose_at(0.0).rotation;
}

TEST(BodyPath, HasXEastYNorthZUpWhereNothingIsSaid) {
    const BodyPath path = body_path(at_origin());
    expect_near(path.pose_at(17.0), Transform<Scene, Body>{}, 1e-9);
    EXPECT_TRUE(path.stands_still());
    EXPECT_TRUE(path.joints_s().empty());
}

TEST(BodyPath, TurnsAsKeyframesCount) {
    // Heading east: the nose (y) to the east, the right wing (x) to the south.
    expect_near(turned(90, 0, 0).y, {1, 0, 0}, 1e-15);
    expect_near(turned(90, 0, 0).x, {0, -1, 0}, 1e-15);
    // Pitch up: the nose up, the back (z) to the south.
    expect_near(turned(0, 90, 0).y, {0, 0, 1}, 1e-15);
    expect_near(turned(0, 90, 0).z, {0, -1, 0}, 1e-15);
    // Roll: the right wing down, the back to the right.
    expect_near(turned(0, 0, 90).x, {0, 0, -1}, 1e-15);
    expect_near(turned(0, 0, 90).z, {1, 0, 0}, 1e-15);
}

TEST(BodyPath, IsRightHanded) {
    const Rotation<Scene, Body> r = turned(33, -12, 50);
    expect_near(cross(r.x, r.y), r.z, 1e-15);
}

TEST(BodyPath, FollowsItsPolynomials) {
    BodyPolynomials motion = at_origin();
    motion.east_m.coefficients = {100, -20, 3};
    motion.north_m.coefficients = {0, 0, 0, 0, 0, 0, 0, 0, 1e-3};
    motion.up_m.coefficients = {7};
    motion.heading_deg.coefficients = {10, 45};
    const BodyPath path = body_path(motion);
    EXPECT_FALSE(path.stands_still());
    for (const double t : {-2.0, 0.0, 0.5, 3.0}) {
        const Transform<Scene, Body> pose = path.pose_at(t);
        expect_near(pose.translation, {100 - 20 * t + 3 * t * t, 1e-3 * std::pow(t, 8), 7}, 1e-8);
        const double heading = deg(10 + 45 * t).radians();
        expect_near(pose.rotation.y, {std::sin(heading), std::cos(heading), 0}, 1e-14);
    }
}

TEST(BodyPath, GoesStraightInTheAxesOfItsPlace) {
    // A quarter of the Earth from the scene's origin, its up is the scene's east.
    BodyPolynomials motion = at_origin();
    motion.place = place(90.0, 0.0, 0.0);
    motion.up_m.coefficients = {0, 1000};
    const BodyPath path = body_path(motion);
    const Vector<Scene> way = path.pose_at(2.0).translation - path.pose_at(0.0).translation;
    expect_near(way, {2000, 0, 0}, 1e-6);
    expect_near(path.pose_at(2.0).rotation.z, {1, 0, 0}, 1e-15);
    expect_near(path.pose_at(2.0).rotation.y, {0, 1, 0}, 1e-15);
}

TEST(BodyPath, CountsHeightFromTheGround) {
    Surroundings hills = bare_ellipsoid();
    hills.ground_height_m = [](Angle, Angle) { return 1500.0; };
    BodyPolynomials motion = at_origin();
    motion.place.above = HeightAbove::Ground;
    motion.place.height_m = 20.0;
    EXPECT_NEAR(BodyPath(motion, frame_at(0.0, 0.0), hills).pose_at(0.0).translation.z, 1520.0, 1e-8);
}

TEST(BodyPath, WithZeroCoefficientsAfterTheFirstStandsStill) {
    BodyPolynomials motion = at_origin();
    motion.east_m.coefficients = {5, 0, 0};
    EXPECT_TRUE(body_path(motion).stands_still());
    motion.roll_deg.coefficients = {0, 0, 1e-300};
    EXPECT_FALSE(body_path(motion).stands_still());
}

TEST(BodyPath, FliesAFlightLikeItsCamera) {
    const std::vector<Keyframe> keyframes = varied();
    const SceneFrame frame = frame_at(0.0, 0.0);
    const CameraPath camera(keyframes, frame, bare_ellipsoid());
    const BodyPath path(BodyFlight{keyframes, 2.5}, frame, bare_ellipsoid());
    EXPECT_FALSE(path.stands_still());
    EXPECT_EQ(path.joints_s(), (std::vector<double>{2.5, 4.5, 5.5, 8.0, 8.5, 11.5}));
    for (const double t : {-3.0, 2.5, 4.0, 8.3, 11.5, 30.0}) {  // before and after its keyframes, too
        const CameraPose seen = camera.pose_at(t - 2.5);
        const Transform<Scene, Body> pose = path.pose_at(t);
        expect_near(pose.translation, seen.position - Point<Scene>{}, 0.0);
        expect_near(pose.rotation.x, seen.orientation.x, 0.0);   // right wing: right in the picture
        expect_near(pose.rotation.y, seen.orientation.z, 0.0);   // nose: the view
        expect_near(pose.rotation.z, -seen.orientation.y, 0.0);  // back: up in the picture
    }
}

TEST(BodyPath, GoesOnStraightBeyondAFlightsEnds) {
    const BodyPath path(BodyFlight{varied(), 0.0}, frame_at(0.0, 0.0), bare_ellipsoid());
    const auto at = [&](double t) { return path.pose_at(t).translation; };
    for (const double t : {10.0, -5.0}) expect_near(at(t + 1.0) - at(t), at(t) - at(t - 1.0), 1e-8);
}

TEST(BodyPath, OfOneKeyframeStandsStill) {
    const BodyPath path(BodyFlight{{varied().front()}, 1.0}, frame_at(0.0, 0.0), bare_ellipsoid());
    EXPECT_TRUE(path.stands_still());
    EXPECT_TRUE(path.joints_s().empty());
    EXPECT_EQ(path.pose_at(-50.0), path.pose_at(50.0));
}

std::string faults(const BodyMotion& motion, const Surroundings& surroundings = bare_ellipsoid()) {
    const BodyPlaces places{{"shot.yaml", 7, 5}, {{"flight.yaml", 3, 5}, {"flight.yaml", 4, 5}}};
    std::string text;
    for (const Problem& p : check_body_motion("kite", motion, places, surroundings)) text += p.text() + '\n';
    return text;
}

TEST(CheckBodyMotion, FindsNothingWrongWithWhatMoves) {
    BodyPolynomials motion = at_origin();
    motion.roll_deg.coefficients = {0, 720};
    EXPECT_EQ(faults(motion), "");
    EXPECT_EQ(faults(BodyFlight{varied(), -3.0}), "");
}

TEST(CheckBodyMotion, NamesABodyAboveGroundThatIsNotThere) {
    Surroundings sea = bare_ellipsoid();
    sea.ground_height_m = [](Angle, Angle) { return std::nullopt; };
    BodyPolynomials motion = at_origin();
    motion.place = {deg(7.5), deg(46.25), 10.0, HeightAbove::Ground};
    EXPECT_EQ(
        faults(motion, sea),
        "shot.yaml:7:5: body 'kite': lon 7.500000, lat 46.250000: height is counted from the ground, but there is "
        "no terrain; move the body onto the terrain or count from sea level or the ellipsoid\n");
    Keyframe keyframe = varied().front();
    keyframe.place.above = HeightAbove::Ground;
    EXPECT_TRUE(faults(BodyFlight{{keyframe}, 0.0}, sea)
                    .starts_with("flight.yaml:3:5: keyframes[0]: lon 0.000000, lat 0.000000: height is counted from"));
}

TEST(CheckBodyMotion, NamesNumbersThatAreNotFinite) {
    for (const double bad : {kNan, kInf, -kInf}) {
        BodyPolynomials motion = at_origin();
        motion.pitch_deg.coefficients = {0, bad};
        EXPECT_EQ(faults(motion), "shot.yaml:7:5: body 'kite': a coefficient is not a finite number\n");
        motion = at_origin();
        motion.place.height_m = bad;
        EXPECT_EQ(faults(motion),
                  "shot.yaml:7:5: body 'kite': lon, lat and height must be finite numbers, lat from -90 to 90\n");
        EXPECT_EQ(faults(BodyFlight{varied(), bad}), "shot.yaml:7:5: body 'kite': delay_s is not a finite number\n");
    }
    BodyPolynomials motion = at_origin();
    motion.place.lat = deg(91.0);
    EXPECT_NE(faults(motion), "");
}

TEST(CheckBodyMotion, FindsWhatIsWrongWithKeyframes) {
    std::vector<Keyframe> keyframes = varied();
    keyframes[1].time_s = keyframes[0].time_s;
    EXPECT_EQ(faults(BodyFlight{keyframes, 0.0}),
              "flight.yaml:4:5: keyframes[1]: time_s 0 is not after 0 of the keyframe before; times must increase\n");
}

}  // namespace
}  // namespace overfly
