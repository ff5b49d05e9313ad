#pragma once

#include <filesystem>
#include <vector>

#include "flight/body_shape.h"
#include "mesh/body_mesh.h"
#include "mesh/mesh_source.h"

namespace overfly {

// The surfaces of a PLY, OBJ, glTF or GLB file as one mesh: all its meshes, each as often as the file's nodes place it,
// polygons cut into triangles, turned upright and scaled. Positions are those of the file, in single precision; what
// follows is done in double. Normals, colours and textures are left out; points and lines are skipped and counted.
// Throws UserError with the file and the reason: unreadable, of another kind, broken, without surfaces, a position that
// is not finite or farther than 10,000 km from the middle.
[[nodiscard]] BodyMesh read_mesh_file(const MeshSource& source);

// The mesh of a body: of its file, its polygons, or its outline at the place where it stands.
// REQUIRES: check_body_motion finds nothing (body_path.h). Throws UserError as above.
[[nodiscard]] BodyMesh read_body_mesh(const BodyShape& shape, const BodyMotion& motion,
                                      const Surroundings& surroundings);

// The files that a mesh is read from, itself first: a glTF may keep its numbers in others. What a hash of the mesh has
// to cover. Throws UserError as above.
[[nodiscard]] std::vector<std::filesystem::path> mesh_file_inputs(const std::filesystem::path& file);

}  // namespace overfly
