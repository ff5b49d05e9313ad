#include "flight/path_report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "flight/attitude.h"

namespace overfly {
namespace {

constexpr double kStandardGravity_m_per_s2 = 9.80665;

struct Sample {
    double time_s = 0.0;
    CameraPose pose;
    Geodetic place;
    Attitude attitude;
    std::optional<double> clearance_m;
};

std::optional<double> clearance_m(const Geodetic& place, const Surroundings& surroundings) {
    const std::optional<double> ground_m = surroundings.ground_height_m(place.lon, place.lat);
    if (!ground_m) return std::nullopt;
    return place.height_m - *ground_m;
}

std::vector<Sample> samples_of(const CameraPath& path, const Surroundings& surroundings, double samples_per_second) {
    const TimeRange times = path.times();
    const auto steps = static_cast<std::size_t>(std::ceil(times.duration_s() * samples_per_second));
    std::vector<Sample> samples;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double share = steps == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(steps);
        const double t = times.begin_s + share * times.duration_s();
        const Geodetic place = path.place_at(t);
        samples.push_back({t, path.pose_at(t), place, path.attitude_at(t), clearance_m(place, surroundings)});
    }
    return samples;
}

// The angle of the rotation between two orientations, by the arc tangent, which is exact for small angles as well.
double turn_rad(const Rotation<Scene, Camera>& a, const Rotation<Scene, Camera>& b) {
    const Rotation<Camera, Camera> r = inverse(a) * b;
    const double sine = 0.5 * std::hypot(r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x);
    const double cosine = 0.5 * (r.x.x + r.y.y + r.z.z - 1.0);
    return std::atan2(sine, cosine);
}

void keep_larger(Extreme& extreme, double value, double time_s) {
    if (value > extreme.value) extreme = {value, time_s};
}

void report_step(const Sample& a, const Sample& b, PathReport& report) {
    const double dt_s = b.time_s - a.time_s, time_s = 0.5 * (a.time_s + b.time_s);
    const double step_m = distance(a.pose.position, b.pose.position), speed = step_m / dt_s;
    report.length_m += step_m;
    report.climb_m += std::max(0.0, b.place.height_m - a.place.height_m);
    keep_larger(report.fastest_m_per_s, speed, time_s);
    if (speed < report.slowest_m_per_s.value) report.slowest_m_per_s = {speed, time_s};

    const auto rate = [dt_s](Angle from, Angle to) {
        return std::abs((nearest_turn(to, from) - from).degrees()) / dt_s;
    };
    keep_larger(report.fastest_turn_deg_per_s,
                Angle::radians(turn_rad(a.pose.orientation, b.pose.orientation)).degrees() / dt_s, time_s);
    keep_larger(report.fastest_heading_deg_per_s, rate(a.attitude.heading, b.attitude.heading), time_s);
    keep_larger(report.fastest_pitch_deg_per_s, rate(a.attitude.pitch, b.attitude.pitch), time_s);
    keep_larger(report.fastest_roll_deg_per_s, rate(a.attitude.roll, b.attitude.roll), time_s);
}

void report_acceleration(const Sample& a, const Sample& b, const Sample& c, PathReport& report) {
    const double dt_s = b.time_s - a.time_s;
    const Vector<Scene> second = (c.pose.position - b.pose.position) - (b.pose.position - a.pose.position);
    keep_larger(report.hardest_g, length(second) / (dt_s * dt_s) / kStandardGravity_m_per_s2, b.time_s);
}

// The lowest clearance within [begin, end] by golden section (Kiefer 1953). Times without ground count as high above
// it.
LowestClearance lowest_within(const CameraPath& path, const Surroundings& surroundings, TimeRange when,
                              LowestClearance lowest) {
    const auto at = [&](double t) {
        const Geodetic place = path.place_at(t);
        const double clearance = clearance_m(place, surroundings).value_or(HUGE_VAL);
        if (clearance < lowest.clearance_m) lowest = {clearance, t, place.lon, place.lat};
        return clearance;
    };
    constexpr double kShare = 1.0 / std::numbers::phi;
    double a = when.begin_s, b = when.end_s;
    double left = b - kShare * (b - a), right = a + kShare * (b - a);
    double at_left = at(left), at_right = at(right);
    constexpr int kSteps = 40;  // 0.618^40 = 4e-9 of the bracket
    for (int i = 0; i < kSteps; ++i) {
        if (at_left <= at_right) {
            b = right, right = left, at_right = at_left;
            left = b - kShare * (b - a), at_left = at(left);
        } else {
            a = left, left = right, at_left = at_right;
            right = a + kShare * (b - a), at_right = at(right);
        }
    }
    return lowest;
}

// Refines every hollow of the samples that might be the lowest: that lies above the lowest sample by less than the
// clearance changes in one step anywhere.
std::optional<LowestClearance> lowest_clearance(const CameraPath& path, const Surroundings& surroundings,
                                                const std::vector<Sample>& samples) {
    const auto high = [&](std::size_t i) { return samples[i].clearance_m.value_or(HUGE_VAL); };
    std::optional<LowestClearance> lowest;
    double largest_step_m = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].clearance_m) continue;
        if (!lowest || *samples[i].clearance_m < lowest->clearance_m)
            lowest = {*samples[i].clearance_m, samples[i].time_s, samples[i].place.lon, samples[i].place.lat};
        if (i > 0 && samples[i - 1].clearance_m)
            largest_step_m = std::max(largest_step_m, std::abs(*samples[i].clearance_m - *samples[i - 1].clearance_m));
    }
    if (!lowest || samples.size() < 2) return lowest;
    const double might_be_m = lowest->clearance_m + largest_step_m;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, samples.size() - 1);
        if (high(i) <= might_be_m && high(i) <= high(before) && high(i) <= high(after))
            lowest = lowest_within(path, surroundings, {samples[before].time_s, samples[after].time_s}, *lowest);
    }
    return lowest;
}

}  // namespace

PathReport report_path(const CameraPath& path, const Surroundings& surroundings, double samples_per_second) {
    check(samples_per_second > 0.0, "a path is sampled at a positive rate");
    const std::vector<Sample> samples = samples_of(path, surroundings, samples_per_second);
    PathReport report;
    report.duration_s = path.times().duration_s();
    if (samples.size() > 1) report.slowest_m_per_s.value = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        report_step(samples[i], samples[i + 1], report);
        if (i > 0) report_acceleration(samples[i - 1], samples[i], samples[i + 1], report);
    }
    if (report.duration_s > 0.0) report.mean_m_per_s = report.length_m / report.duration_s;
    report.lowest = lowest_clearance(path, surroundings, samples);
    const auto off = std::count_if(samples.begin(), samples.end(), [](const Sample& s) { return !s.clearance_m; });
    report.off_terrain_share = static_cast<double>(off) / static_cast<double>(samples.size());
    return report;
}

}  // namespace overfly
