#pragma once

#include <cstdint>
#include <span>
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

// A record of a StrideLog; kNone: none.
using RecordId = std::uint32_t;

// What samples have left when: this triangle (kNone: the sky) at this time. Each record leads back to the one before it
// of the same sample; samples are mixed, and some records are no one's. To forget the last of a sample is to go back.
class StrideLog {
  public:
    std::vector<TriangleId> triangle;
    std::vector<float> until_u;
    std::vector<RecordId> before;
    std::size_t count = 0;

    [[nodiscard]] RecordId add(RecordId last, TriangleId what, float until);
    void reserve_more(std::size_t more);

    // Appends one sample's segments: from the begin of the stretch to its end. Returns how many records it has.
    std::size_t write(const PieceStretch& stretch, RecordId last, SegmentLists& out);

  private:
    std::vector<RecordId> in_order_;
};

}  // namespace overfly
