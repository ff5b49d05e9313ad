#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "trace/static_bvh.h"
#include "trace/time_cells.h"
#include "trace/visible_segment.h"

namespace overfly {

class CellStarts;

// A stretch of one cell, [begin, end] within [0, 1], during which the line of sight passes through a triangle, and the
// depths there: the paper's intersection record.
struct CellRecord {
    double begin = 0.0, end = 1.0;
    double nearest_m = 0.0, farthest_m = 0.0;  // over the stretch, with a margin
    TriangleId triangle = kNone;
};

using CellRecords = std::array<std::vector<CellRecord>, kTimeCells>;

// What a walk through the hierarchy follows: the lines of sight of a few neighbouring samples
// (TimeCells::samples_together).
struct SweptRays {
    // The rays start at the camera.
    SweptRays(const TriangleMesh& terrain, const StaticBvh& hierarchy, const TimeCells& time,
              std::span<const ImageSample> samples);

    const TriangleMesh* mesh;
    const StaticBvh* bvh;
    const TimeCells* cells;
    std::uint32_t active = 0;              // the cells in use, a bit each
    alignas(64) PerCell<double> x{}, y{};  // of each cell's sample, on the film
    const CellStarts* starts = nullptr;    // where the rays start, if not at the camera
};

// All records of the rays in the cells in use, except such as lie behind records that cover their whole cell. Appends
// to `records`, unsorted. The same for every vector unit that the processor offers: which boxes are met may differ by a
// rounding, the records that can be seen do not.
void gather_records(const SweptRays& rays, CellRecords& records, TraceCounters& counters);

}  // namespace overfly
