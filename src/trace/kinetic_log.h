#pragma once

#include <cstdint>
#include <vector>

#include "flight/motion.h"
#include "trace/visible_segment.h"

namespace overfly {

// A part of a motion piece: in its u, and on the flight's axis.
struct PieceStretch {
    const MotionPiece* piece = nullptr;
    double from_u = 0.0, to_u = 1.0;
    TimeRange when;
};

// What samples have left when: this triangle (kNone: the sky) at this time. In order for each sample.
struct StrideLog {
    std::vector<std::uint32_t> sample, triangle;
    std::vector<float> until_u;
    std::size_t count = 0;

    void add(std::uint32_t who, TriangleId what, float until);
    void reserve_more(std::size_t more);

    // Appends each sample's segments: the log has the samples mixed, each with its own in order, from the begin of the
    // stretch to its end. REQUIRES: as many samples as the log knows.
    void write(const PieceStretch& stretch, std::size_t samples, SegmentLists& out) const;
};

}  // namespace overfly
