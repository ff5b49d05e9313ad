#include "shot/drift_stretches.h"

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

// Exposures as long as each other, but for rounding.
constexpr double kAsLong = 1e-9;

// What lines may drift in a stretch. Farther, the drift is no longer the motion that it is taken for (film_drift.h),
// and most of what is prepared for the stretch is never passed.
constexpr double kFarthest_px = 320.0;

}  // namespace

std::vector<TimeRange> drift_stretches(TimeRange piece, std::span<const TimeRange> exposures, double drift_px) {
    const double exposure_s = exposures.front().duration_s();
    const auto is_as_long = [&](const TimeRange& e) {
        return std::abs(e.duration_s() - exposure_s) <= kAsLong * exposure_s;
    };
    if (exposure_s == 0.0 || !std::ranges::all_of(exposures, is_as_long)) return {};
    const double far_px = drift_px * piece.duration_s() / exposure_s;
    if (far_px <= kFarthest_px) return {piece};
    const double parts = std::ceil(far_px / kFarthest_px);
    if (parts >= static_cast<double>(exposures.size())) return {};
    const auto count = static_cast<std::size_t>(parts);
    std::vector<TimeRange> out;
    double begin_s = piece.begin_s;
    for (std::size_t k = 1; k < count; ++k) {
        const std::size_t next = exposures.size() * k / count;
        const double end_s = 0.5 * (exposures[next - 1].end_s + exposures[next].begin_s);
        out.push_back({begin_s, end_s});
        begin_s = end_s;
    }
    out.push_back({begin_s, piece.end_s});
    return out;
}

}  // namespace overfly
