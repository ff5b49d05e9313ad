#include "trace/kinetic_log.h"

#include <algorithm>
#include <utility>

namespace overfly {

void StrideLog::add(std::uint32_t who, TriangleId what, float until) {
    reserve_more(1);
    sample[count] = who;
    triangle[count] = what;
    until_u[count++] = until;
}

void StrideLog::reserve_more(std::size_t more) {
    if (count + more <= sample.size()) return;
    const std::size_t size = 2 * (count + more) + 4096;
    sample.resize(size);
    triangle.resize(size);
    until_u.resize(size);
}

void StrideLog::write(const PieceStretch& stretch, std::size_t samples, SegmentLists& out) const {
    struct Cursor {
        std::size_t first, next;  // in out.segments
        double since_s;
    };
    std::vector<Cursor> cursors(samples, {0, 0, stretch.when.begin_s});
    for (std::size_t k = 0; k < count; ++k) ++cursors[sample[k]].next;
    std::size_t end = out.segments.size();
    for (Cursor& c : cursors) {
        c.first = end;
        end += std::exchange(c.next, end);
    }
    std::size_t kept = out.segments.size();
    out.segments.resize(end);
    const bool is_instant = stretch.when.duration_s() == 0.0;
    const auto end_u = static_cast<float>(stretch.to_u);
    const double begin_s = stretch.piece->when.begin_s;
    const double duration_s = stretch.piece->when.duration_s();
    for (std::size_t k = 0; k < count; ++k) {
        Cursor& c = cursors[sample[k]];
        const float until = until_u[k];
        double until_s = std::max(c.since_s, begin_s + static_cast<double>(until) * duration_s);
        if (until >= end_u) until_s = stretch.when.end_s;
        const TriangleId seen = triangle[k];
        VisibleSegment* last = c.next > c.first ? &out.segments[c.next - 1] : nullptr;
        if (last != nullptr && last->triangle == seen && last->when.end_s == c.since_s) {
            last->when.end_s = until_s;
        } else if (seen != kNone && (until_s > c.since_s || is_instant)) {
            out.segments[c.next++] = {seen, {c.since_s, until_s}};
        }
        c.since_s = until_s;
    }
    // Some were the sky, or shorter than time can tell.
    for (const Cursor& c : cursors) {
        if (kept != c.first) {
            std::copy(out.segments.begin() + static_cast<std::ptrdiff_t>(c.first),
                      out.segments.begin() + static_cast<std::ptrdiff_t>(c.next),
                      out.segments.begin() + static_cast<std::ptrdiff_t>(kept));
        }
        kept += c.next - c.first;
        out.ends.push_back(static_cast<std::uint32_t>(kept));
    }
    out.segments.resize(kept);
}

}  // namespace overfly
