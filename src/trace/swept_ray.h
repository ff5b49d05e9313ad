#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "trace/static_bvh.h"
#include "trace/time_cells.h"
#include "trace/visible_segment.h"

namespace overfly {

// A stretch of one cell, [begin, end] within [0, 1], during which the line of sight passes through a triangle, and the
// depths there: the paper's intersection record.
struct CellRecord {
    double begin = 0.0, end = 1.0;
    double nearest_m = 0.0, farthest_m = 0.0;  // over the stretch, with a margin
    TriangleId triangle = kNone;
};

using CellRecords = std::array<std::vector<CellRecord>, kTimeCells>;

// What the walk of a swept ray through the hierarchy needs.
struct SweptRay {
    const TerrainMesh* mesh;
    const StaticBvh* bvh;
    const TimeCells* cells;
    double x, y;           // on the film
    std::uint32_t active;  // the cells that matter, a bit each
};

// All records of the ray in its active cells, except such as lie behind records that cover their whole cell. Appends to
// `records`, unsorted. The same for every vector unit that the processor offers: which boxes are met may differ by a
// rounding, the records that can be seen do not.
void gather_records(const SweptRay& ray, CellRecords& records, TraceCounters& counters);

}  // namespace overfly
