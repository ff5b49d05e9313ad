#pragma once

#include <array>
#include <span>
#include <vector>

#include "trace/inside_stretches.h"
#include "trace/swept_ray.h"

namespace overfly {

// The line of sight of one image sample through one stretch of a motion piece, followed one triangle at a time and
// without a vector unit: for whoever looks at single samples closely. The arithmetic is that of gather_records, so its
// records are the same to the bit.
class SampleLine {
  public:
    // REQUIRES: `when` lasts for some time and lies within the piece; mesh and piece outlive this.
    SampleLine(const TriangleMesh& mesh, const MotionPiece& piece, const ImageSample& sample, TimeRange when);

    // Appends every stretch in which the line passes through the triangle before the camera. Whether there is one.
    bool add_records(TriangleId triangle, std::vector<CellRecord>& records) const;

    // Of records of this line, whatever is nearest when (nearest_records.h).
    [[nodiscard]] std::vector<CellRecord> nearest(std::vector<CellRecord> records) const;

    // A record's begin and end on the flight's axis: `when`'s own at its ends.
    [[nodiscard]] TimeRange when(const CellRecord& record) const;

    // Appends nearest records as the segments that IntervalTracer makes of them.
    void append_segments(std::span<const CellRecord> nearest, std::vector<VisibleSegment>& segments) const;

    // A time at which the line changes from one side of a triangle's edge, or of that edge's extension, to the other.
    struct Crossing {
        double time_s = 0.0;
        bool on_triangle = false;  // else on the extension
    };
    // All of them, edge by edge.
    [[nodiscard]] std::vector<Crossing> crossings(TriangleId triangle) const;

  private:
    [[nodiscard]] std::array<Bernstein<4>, 3> sides(TriangleId triangle) const;

    const TriangleMesh* mesh_;
    ImageSample sample_;
    TimeCells cells_;                                     // one
    std::array<Bernstein<4>, 3> direction_{}, moment_{};  // by axis
};

}  // namespace overfly
