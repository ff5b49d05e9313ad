#include "trace/nearest_records.h"

#include <algorithm>
#include <limits>

#include "core/polynomial_roots.h"
#include "trace/plane_depth.h"

namespace overfly {
namespace {

bool overlap(const CellRecord& a, const CellRecord& b) { return a.begin < b.end && b.begin < a.end; }

// Drops records that lie wholly behind another throughout their time.
void drop_hidden(std::vector<CellRecord>& records) {
    const auto is_hidden = [&](const CellRecord& r) {
        return std::ranges::any_of(records, [&](const CellRecord& o) {
            return o.begin <= r.begin && r.end <= o.end && o.farthest_m < r.nearest_m;
        });
    };
    std::vector<CellRecord> kept;
    std::ranges::copy_if(records, std::back_inserter(kept), [&](const CellRecord& r) { return !is_hidden(r); });
    records = std::move(kept);
}

bool are_apart(const std::vector<CellRecord>& sorted) {
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (overlap(sorted[i - 1], sorted[i])) return false;
    }
    return true;
}

// Every time at which the nearest record may change: the ends, and where two planes cross.
std::vector<double> event_times(std::span<const CellRecord> records, std::span<const PlaneDepth> depths,
                                const TimeCells& cells, std::size_t cell) {
    std::vector<double> times;
    for (std::size_t i = 0; i < records.size(); ++i) {
        times.push_back(records[i].begin);
        times.push_back(records[i].end);
        for (std::size_t j = 0; j < i; ++j) {
            if (!overlap(records[i], records[j]) || records[i].triangle == records[j].triangle) continue;
            const Bernstein<4> a = depths[i].numerator_in(cells, cell) * depths[j].denominator_in(cells, cell);
            const Bernstein<4> b = depths[j].numerator_in(cells, cell) * depths[i].denominator_in(cells, cell);
            Bernstein<4> difference{};
            for (std::size_t k = 0; k < 5; ++k) difference[k] = a[k] - b[k];
            for (const double u : sign_change_roots<4>(difference)) times.push_back(u);
        }
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}  // namespace

std::vector<CellRecord>& nearest_records(const SweptRays& ray, std::size_t cell, std::vector<CellRecord>& records,
                                         std::vector<CellRecord>& scratch) {
    const auto by_start = [](const CellRecord& a, const CellRecord& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.triangle < b.triangle;
    };
    std::ranges::sort(records, by_start);
    if (are_apart(records)) return records;
    drop_hidden(records);
    if (are_apart(records)) return records;

    std::vector<PlaneDepth> depths;
    depths.reserve(records.size());
    for (const CellRecord& r : records)
        depths.emplace_back(*ray.mesh, r.triangle, *ray.cells->piece, ray.x[cell], ray.y[cell]);
    const std::vector<double> times = event_times(records, depths, *ray.cells, cell);
    scratch.clear();
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        const double middle = 0.5 * (times[i] + times[i + 1]);
        const CellRecord* nearest = nullptr;
        double nearest_m = std::numeric_limits<double>::infinity();
        for (std::size_t r = 0; r < records.size(); ++r) {
            if (records[r].begin > times[i] || records[r].end < times[i + 1]) continue;
            const double depth_m = depths[r].at(ray.cells->piece_u(cell, middle));
            const bool is_nearer = depth_m < nearest_m || (depth_m == nearest_m && nearest != nullptr &&
                                                           records[r].triangle < nearest->triangle);
            if (!is_nearer) continue;
            nearest = &records[r];
            nearest_m = depth_m;
        }
        if (nearest == nullptr) continue;
        const bool goes_on =
            !scratch.empty() && scratch.back().triangle == nearest->triangle && scratch.back().end == times[i];
        if (goes_on) {
            scratch.back().end = times[i + 1];
        } else {
            scratch.push_back(*nearest);
            scratch.back().begin = times[i];
            scratch.back().end = times[i + 1];
        }
    }
    return scratch;
}

}  // namespace overfly
