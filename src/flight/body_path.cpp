#include "flight/body_path.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "flight/attitude.h"
#include "flight/camera_path.h"
#include "flight/check_flight.h"
#include "flight/resolve_place.h"

namespace overfly {
namespace {

// A body's nose is where a camera looks, and its up is against the camera's down.
Rotation<Scene, Body> as_body(const Rotation<Scene, Camera>& camera) { return {camera.x, camera.z, -camera.y}; }

Transform<Scene, Body> pose(Point<Scene> position, const Rotation<Scene, Body>& rotation) {
    const Vector<Scene> sum = rotation.x + rotation.y + rotation.z;
    check(std::isfinite(dot(sum, sum) + position.x + position.y + position.z), "a body's pose is finite");
    return {rotation, {position.x, position.y, position.z}};
}

// The polynomials over a place that is resolved.
struct Drift {
    BodyPolynomials motion;
    Point<Scene> origin;
    Rotation<Scene, Scene> axes;  // east, north and up at the place

    [[nodiscard]] Transform<Scene, Body> pose_at(double time_s) const {
        const Vector<Scene> way{motion.east_m.at(time_s), motion.north_m.at(time_s), motion.up_m.at(time_s)};
        const Attitude attitude{Angle::degrees(motion.heading_deg.at(time_s)),
                                Angle::degrees(motion.pitch_deg.at(time_s)),
                                Angle::degrees(motion.roll_deg.at(time_s))};
        return pose(origin + axes * way, as_body(orientation(attitude, axes)));
    }
    [[nodiscard]] bool stands_still() const {
        return motion.east_m.is_constant() && motion.north_m.is_constant() && motion.up_m.is_constant() &&
               motion.heading_deg.is_constant() && motion.pitch_deg.is_constant() && motion.roll_deg.is_constant();
    }
};

Drift drift(const BodyPolynomials& motion, const SceneFrame& frame, const Surroundings& surroundings) {
    const std::optional<Geodetic> place = resolve_place(motion.place, surroundings);
    check(place.has_value(), "a body's height is counted from ground that is there");
    return {motion, frame.scene(*place), frame.local_axes(*place)};
}

bool is_finite(const TimePolynomial& polynomial) {
    for (const double c : polynomial.coefficients)
        if (!std::isfinite(c)) return false;
    return true;
}

std::string fault(const BodyPolynomials& motion, const Surroundings& surroundings) {
    for (const TimePolynomial* p :
         {&motion.east_m, &motion.north_m, &motion.up_m, &motion.heading_deg, &motion.pitch_deg, &motion.roll_deg}) {
        if (!is_finite(*p)) return "a coefficient is not a finite number";
    }
    const FlightPlace& place = motion.place;
    const double lon_deg = place.lon.degrees(), lat_deg = place.lat.degrees();
    if (!std::isfinite(lon_deg) || !std::isfinite(place.height_m) || !(std::abs(lat_deg) <= 90.0))
        return "lon, lat and height must be finite numbers, lat from -90 to 90";
    if (!resolve_place(place, surroundings))
        return fmt::format(
            "lon {:.6f}, lat {:.6f}: height is counted from the ground, but there is no terrain; move the body onto "
            "the "
            "terrain or count from sea level or the ellipsoid",
            lon_deg, lat_deg);
    return "";
}

}  // namespace

BodyPath::BodyPath(const BodyMotion& motion, const SceneFrame& frame, const Surroundings& surroundings) {
    if (const auto* polynomials = std::get_if<BodyPolynomials>(&motion)) {
        const Drift body = drift(*polynomials, frame, surroundings);
        pose_at_ = [body](double time_s) { return body.pose_at(time_s); };
        stands_still_ = body.stands_still();
        return;
    }
    const auto& flight = std::get<BodyFlight>(motion);
    const CameraPath path(flight.keyframes, frame, surroundings);
    pose_at_ = [path, delay_s = flight.delay_s](double time_s) {
        const CameraPose camera = path.pose_at(time_s - delay_s);
        return pose(camera.position, as_body(camera.orientation));
    };
    stands_still_ = flight.keyframes.size() == 1;
    if (stands_still_) return;
    for (const double time_s : path.joints_s()) joints_s_.push_back(time_s + flight.delay_s);
}

std::vector<Problem> check_body_motion(const std::string& name, const BodyMotion& motion, const BodyPlaces& places,
                                       const Surroundings& surroundings) {
    const auto problem = [&](const std::string& what) -> Problem {
        return {places.body, fmt::format("body '{}': {}", name, what)};
    };
    if (const auto* polynomials = std::get_if<BodyPolynomials>(&motion)) {
        const std::string found = fault(*polynomials, surroundings);
        return found.empty() ? std::vector<Problem>{} : std::vector{problem(found)};
    }
    const auto& flight = std::get<BodyFlight>(motion);
    std::vector<Problem> problems = check_keyframes(flight.keyframes, places.keyframes, surroundings);
    if (!std::isfinite(flight.delay_s)) problems.push_back(problem("delay_s is not a finite number"));
    return problems;
}

}  // namespace overfly
