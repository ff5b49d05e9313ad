#pragma once

#include "flight/motion.h"
#include "mesh/triangle_mesh.h"
#include "trace/visible_segment.h"

namespace overfly {

// In film coordinates, from a sample to the nearest side of a triangle at a time u of the piece, sides taken as lines.
[[nodiscard]] double film_distance_to_sides(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece,
                                            const ImageSample& sample, double u);

}  // namespace overfly
