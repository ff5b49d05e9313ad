#pragma once

#include <vector>

#include "trace/swept_ray.h"

namespace overfly {

// Of the records of one cell, whatever is nearest when: sorted by start time, without overlap; truncated or split where
// another record is nearer, at the exact time where two planes cross (the root of N_i D_j - N_j D_i, design 3.2).
// Of two equally near, the triangle with the lower number.
// REQUIRES: every record's triangle is of ray.mesh.
[[nodiscard]] std::vector<CellRecord>& nearest_records(const SweptRays& ray, std::size_t cell,
                                                       std::vector<CellRecord>& records,
                                                       std::vector<CellRecord>& scratch);

}  // namespace overfly
