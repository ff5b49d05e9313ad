#pragma once

#include "mesh/triangle_mesh.h"

namespace overfly {

// Sets mesh.twins from its triangles: the triangle across each side. A side that more than two triangles share, or that
// two run along in the same direction, has no twins.
// REQUIRES: no triangle has a repeated corner; fewer than 2^30 triangles.
void connect_triangles(TriangleMesh& mesh);

}  // namespace overfly
