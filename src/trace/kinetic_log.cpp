#include "trace/kinetic_log.h"

#include <algorithm>

namespace overfly {

RecordId StrideLog::add(RecordId last, TriangleId what, float until) {
    reserve_more(1);
    triangle[count] = what;
    until_u[count] = until;
    before[count] = last;
    return static_cast<RecordId>(count++);
}

void StrideLog::reserve_more(std::size_t more) {
    if (count + more <= triangle.size()) return;
    const std::size_t size = 2 * (count + more) + 4096;
    triangle.resize(size);
    until_u.resize(size);
    before.resize(size);
}

std::size_t StrideLog::write(const PieceStretch& stretch, RecordId last, SegmentLists& out) {
    in_order_.clear();
    for (RecordId r = last; r != kNone; r = before[r]) in_order_.push_back(r);
    std::ranges::reverse(in_order_);
    const double begin_s = stretch.piece->when.begin_s;
    const double duration_s = stretch.piece->when.duration_s();
    const auto end_u = static_cast<float>(stretch.to_u);
    const std::size_t first = out.segments.size();
    double since_s = stretch.when.begin_s;
    for (const RecordId r : in_order_) {
        const float until = until_u[r];
        double until_s = std::max(since_s, begin_s + static_cast<double>(until) * duration_s);
        if (until >= end_u) until_s = stretch.when.end_s;
        const TriangleId seen = triangle[r];
        // Shorter than time can tell.
        if (!(until_s > since_s)) continue;
        const bool goes_on = out.segments.size() > first && out.segments.back().triangle == seen &&
                             out.segments.back().when.end_s == since_s;
        if (goes_on) {
            out.segments.back().when.end_s = until_s;
        } else if (seen != kNone) {
            out.segments.push_back({seen, {since_s, until_s}});
        }
        since_s = until_s;
    }
    out.end_sample();
    return in_order_.size();
}

}  // namespace overfly
