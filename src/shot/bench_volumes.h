#pragma once

#include <cstdint>
#include <span>

#include "core/progress.h"
#include "flight/motion.h"
#include "shot/pixel_tile.h"
#include "trace/interval.h"
#include "trace/time_cells.h"

namespace overfly {

// What kinds of bounding volume cost at the same work: one line of sight after the other, each once through a whole
// motion piece.
struct VolumeComparison {
    TraceCounters inflated;        // boxes that contain their triangle at all times of the piece, as the paper's do
    TraceCounters swept;           // boxes that stand still while the ray sweeps, through the piece as one cell of time
    TraceCounters swept_in_parts;  // the same in kVolumeParts cells, of which a vector unit tests all at once
    std::uint64_t differing = 0;   // lines that do not see the same segments by inflated and by swept
    double inflated_build_s = 0.0;  // of the hierarchy, for each piece; ours is built once for the flight
};

// As many cells as a walk of IntervalTracer follows together.
inline constexpr std::size_t kVolumeParts = kTimeCells;

// REQUIRES: the tracer is over the mesh; pieces is not empty.
[[nodiscard]] VolumeComparison compare_volumes(const TriangleMesh& mesh, const IntervalTracer& swept,
                                               std::span<const MotionPiece> pieces, PictureSize size,
                                               const Progress& progress = {});

// How boxes swell that have to contain their triangle for longer.
struct SwollenBoxes {
    std::size_t pieces = 0;  // of motion that they last for
    double lasting_s = 0.0;
    double per_line = 0.0;  // boxes around single triangles that a place of the film lies in, on average
};

// REQUIRES: pieces that follow each other.
[[nodiscard]] SwollenBoxes swollen_boxes(const TriangleMesh& mesh, std::span<const MotionPiece> pieces,
                                         PictureSize size);

}  // namespace overfly
