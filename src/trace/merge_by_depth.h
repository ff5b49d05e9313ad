#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "trace/surface_segment.h"

namespace overfly {

// Of two lists of what one sample sees, each of other surfaces than the other, whatever is nearer when: split at the
// exact times at which the depths cross, where surfaces interpenetrate too (the roots of N_i D_j - N_j D_i, design 3.2;
// the ray parameter is the same relative to any surface). Of two equally near, the surface with the higher number.
// REQUIRES: lists in time order, without overlap; meshes by surface. Segments of no duration (instants) are compared
// with those of the same instant only. A segment without a triangle lies behind everything.
// GUARANTEES: in time order, without overlap; covers the union of what the two cover.
void merge_by_depth(std::span<const SurfaceSegment> a, std::span<const SurfaceSegment> b,
                    std::span<const TriangleMesh* const> meshes, const ImageSample& sample,
                    std::vector<SurfaceSegment>& out);

}  // namespace overfly
