#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/time_range.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// A place on the film (film coordinates, flight/motion.h) whose line of sight is followed through time.
struct ImageSample {
    double x = 0.0, y = 0.0;
    double phase = 0.0;  // [0, 1): where in each exposure a tracer that sees only instants looks
};

// The answer to "which polygon is seen when": this triangle is the nearest along the sample's line of sight all through
// `when`. A segment of no duration was looked at in that instant only and stands for its whole exposure.
struct VisibleSegment {
    TriangleId triangle = kNone;
    TimeRange when;

    friend bool operator==(const VisibleSegment&, const VisibleSegment&) = default;
};

// The visible segments of many samples, sample by sample, each sample's in time order and without overlap. Where there
// is none, nothing but sky is seen.
struct SegmentLists {
    std::vector<VisibleSegment> segments;
    std::vector<std::uint32_t> ends;  // of each sample's run in segments

    void clear() {
        segments.clear();
        ends.clear();
    }
    void end_sample() { ends.push_back(static_cast<std::uint32_t>(segments.size())); }
    [[nodiscard]] std::span<const VisibleSegment> of(std::size_t sample) const {
        const std::uint32_t begin = sample == 0 ? 0 : ends[sample - 1];
        return std::span(segments).subspan(begin, ends[sample] - begin);
    }
};

// What a tracer had to do, for statistics. Sums of integers, so the same for any number of threads.
struct TraceCounters {
    std::uint64_t rays = 0;       // discrete: rays cast; interval: samples followed through a piece
    std::uint64_t box_tests = 0;  // of a walk with a box, all of its cells at once
    std::uint64_t box_hits = 0;
    std::uint64_t triangle_tests = 0;  // likewise with a triangle
    std::uint64_t triangle_hits = 0;
    std::uint64_t segments = 0;  // visible segments found
    std::uint64_t resolved = 0;  // discrete: hits too near an edge for float, decided again in double
    // Kinetic: samples set down by a discrete ray, at the begin of a piece or where a stride went astray; steps to a
    // neighbour; silhouettes that came in front, and that were left; and how often the walk found that it was not where
    // it thought.
    std::uint64_t restarts = 0, crossings = 0, occlusions = 0, disocclusions = 0, lost = 0;
    // Answers that a ray was asked again (kinetic_check.h), those that differed, and of them those next to an edge.
    std::uint64_t checked = 0, differed = 0, differed_by_edge = 0;

    TraceCounters& operator+=(const TraceCounters& other) {
        rays += other.rays;
        box_tests += other.box_tests;
        box_hits += other.box_hits;
        triangle_tests += other.triangle_tests;
        triangle_hits += other.triangle_hits;
        segments += other.segments;
        resolved += other.resolved;
        restarts += other.restarts;
        crossings += other.crossings;
        occlusions += other.occlusions;
        disocclusions += other.disocclusions;
        lost += other.lost;
        checked += other.checked;
        differed += other.differed;
        differed_by_edge += other.differed_by_edge;
        return *this;
    }
};

}  // namespace overfly
