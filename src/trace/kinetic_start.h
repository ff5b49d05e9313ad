#pragma once

#include <span>

#include "flight/motion.h"
#include "trace/ray_scene.h"
#include "trace/visible_segment.h"

namespace overfly {

// What samples see at one time of a piece, as float packets of rays find it: near an edge it may be the neighbour, or
// what is in front of or behind a silhouette by a thousandth of a pixel; kNone for the sky.
// REQUIRES: as many `seen` as samples. Sixteen samples that follow each other should lie close together on the film.
void look_roughly(const RayScene& scene, const MotionPiece& piece, double u, std::span<const ImageSample> samples,
                  std::span<TriangleId> seen);

}  // namespace overfly
