#include "flight/check_flight.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>

#include "flight/place_curve.h"
#include "flight/resolve_place.h"
#include "geo/scene_frame.h"

namespace overfly {
namespace {

bool are_finite(std::initializer_list<double> numbers) {
    for (const double number : numbers)
        if (!std::isfinite(number)) return false;
    return true;
}

std::string lon_lat(const FlightPlace& place) {
    return fmt::format("lon {:.6f}, lat {:.6f}", place.lon.degrees(), place.lat.degrees());
}

// What is wrong with the numbers of one keyframe, "" if nothing is.
std::string number_problem(const Keyframe& keyframe) {
    const auto bad_place = [](const FlightPlace& p) {
        return !are_finite({p.lon.degrees(), p.lat.degrees(), p.height_m}) || std::abs(p.lat.degrees()) > 90.0;
    };
    if (!std::isfinite(keyframe.time_s)) return "time_s is not a finite number";
    if (bad_place(keyframe.place)) return "lon, lat and height must be finite numbers, lat from -90 to 90";
    if (const auto* aim = std::get_if<Attitude>(&keyframe.aim)) {
        if (!are_finite({aim->heading.degrees(), aim->pitch.degrees(), aim->roll.degrees()}) ||
            std::abs(aim->pitch.degrees()) > 90.0)
            return fmt::format(
                "heading {}, pitch {}, roll {}: must be finite numbers of degrees, pitch from -90 (straight down) to "
                "90",
                aim->heading.degrees(), aim->pitch.degrees(), aim->roll.degrees());
    } else if (const auto& look_at = std::get<LookAt>(keyframe.aim);
               bad_place(look_at.target) || !std::isfinite(look_at.roll.degrees())) {
        return "target: lon, lat, height and roll must be finite numbers, lat from -90 to 90";
    }
    const double fov_deg = keyframe.lens.horizontal_fov.degrees();
    if (!(fov_deg > 0.0 && fov_deg < 180.0))
        return fmt::format("field of view {} degrees: must be more than 0 and less than 180", fov_deg);
    return "";
}

class Checker {
  public:
    Checker(std::span<const Place> places, const Surroundings& surroundings)
        : places_(places), surroundings_(surroundings) {}

    void check(std::size_t i, const Keyframe& keyframe) {
        if (std::string problem = number_problem(keyframe); !problem.empty()) return add(i, std::move(problem));
        check_height(i, keyframe.place);
        if (const auto* look_at = std::get_if<LookAt>(&keyframe.aim)) check_target(i, keyframe.place, look_at->target);
    }

    void check_neighbours(std::size_t i, const Keyframe& from, const Keyframe& to) {
        if (!number_problem(from).empty() || !number_problem(to).empty()) return;
        if (!(from.time_s < to.time_s))
            add(i + 1, fmt::format("time_s {} is not after {} of the keyframe before; times must increase", to.time_s,
                                   from.time_s));
        if (are_far(from.place, to.place))
            add(i + 1, fmt::format("{} is a quarter of the Earth or more from the keyframe before; put one between",
                                   lon_lat(to.place)));
        const auto *looked = std::get_if<LookAt>(&from.aim), *looks = std::get_if<LookAt>(&to.aim);
        if (looked && looks && are_far(looked->target, looks->target))
            add(i + 1, fmt::format("target at {} is a quarter of the Earth or more from that of the keyframe before",
                                   lon_lat(looks->target)));
    }

    std::vector<Problem> take() { return std::move(problems_); }

  private:
    void check_height(std::size_t i, const FlightPlace& place) {
        const std::optional<double> ground_m = surroundings_.ground_height_m(place.lon, place.lat);
        const std::optional<Geodetic> resolved = resolve_place(place, surroundings_);
        if (!resolved)
            return add(i, fmt::format("{}: height is counted from the ground, but there is no terrain; move the camera "
                                      "onto the terrain or count from sea level or the ellipsoid",
                                      lon_lat(place)));
        if (ground_m && resolved->height_m < *ground_m)
            add(i,
                fmt::format("{}: the camera is {:.1f} m below the ground; must be above it (the ground is at {:.1f} m "
                            "above the ellipsoid)",
                            lon_lat(place), *ground_m - resolved->height_m, *ground_m));
    }

    void check_target(std::size_t i, const FlightPlace& camera, const FlightPlace& target) {
        const std::optional<Geodetic> from = resolve_place(camera, surroundings_);
        const std::optional<Geodetic> to = resolve_place(target, surroundings_);
        if (!to)
            add(i, fmt::format("target at {}: height is counted from the ground, but there is no terrain; move the "
                               "target onto the terrain or count from sea level or the ellipsoid",
                               lon_lat(target)));
        constexpr double kTouching_m = 1e-3;  // nearer, the direction would be rounding
        if (from && to && distance(ecef(*from), ecef(*to)) < kTouching_m)
            add(i, fmt::format("target at {} is where the camera is; must be elsewhere", lon_lat(target)));
    }

    static bool are_far(const FlightPlace& a, const FlightPlace& b) {
        return dot(ellipsoid_normal({a.lon, a.lat, 0.0}), ellipsoid_normal({b.lon, b.lat, 0.0})) <= 0.0;
    }

    void add(std::size_t i, std::string message) {
        problems_.push_back(
            {i < places_.size() ? places_[i] : Place{}, fmt::format("keyframes[{}]: {}", i, std::move(message))});
    }

    std::span<const Place> places_;
    const Surroundings& surroundings_;
    std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> check_keyframes(const std::vector<Keyframe>& keyframes, std::span<const Place> places,
                                     const Surroundings& surroundings) {
    if (keyframes.empty()) return {{places.empty() ? Place{} : places.front(), "keyframes: none; at least one"}};
    Checker checker(places, surroundings);
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        checker.check(i, keyframes[i]);
        if (i + 1 < keyframes.size()) checker.check_neighbours(i, keyframes[i], keyframes[i + 1]);
    }
    return checker.take();
}

}  // namespace overfly
