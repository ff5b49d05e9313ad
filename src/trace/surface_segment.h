#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "trace/visible_segment.h"

namespace overfly {

struct Sight;

// What a sample sees for a while among several surfaces, each of which stands still in a scene of its own: terrain,
// and bodies in motion.
struct SurfaceSegment {
    std::uint32_t surface = 0;
    TriangleId triangle = kNone;  // of that surface; kNone: the sky, which only mirrors name
    TimeRange when;
    const MotionPiece* motion = nullptr;  // of the rays relative to the surface
    const Sight* sight = nullptr;         // who looks: the camera, or the camera in a mirror
    bool in_shadow = false;               // of a surface that the sun would else reach
    std::uint32_t reflected = kNone;      // in a mirror: which of SurfaceSegmentLists::reflected is seen there

    friend bool operator==(const SurfaceSegment&, const SurfaceSegment&) = default;
};

// Of many samples, as SegmentLists.
struct SurfaceSegmentLists {
    std::vector<SurfaceSegment> segments;
    std::vector<std::uint32_t> ends;  // of each sample's run in segments
    std::vector<SurfaceSegment> reflected;

    void clear() {
        segments.clear();
        ends.clear();
        reflected.clear();
    }
    void end_sample() { ends.push_back(static_cast<std::uint32_t>(segments.size())); }
    [[nodiscard]] std::span<const SurfaceSegment> of(std::size_t sample) const {
        const std::uint32_t begin = sample == 0 ? 0 : ends[sample - 1];
        return std::span(segments).subspan(begin, ends[sample] - begin);
    }
};

}  // namespace overfly
