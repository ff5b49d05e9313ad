#pragma once

#include <cstddef>
#include <filesystem>

#include "config/documents.h"
#include "core/progress.h"
#include "flight/camera_path.h"
#include "flight/closest_approach.h"
#include "shot/stage.h"

namespace overfly {

// What a mesh for a flight came to.
struct FlightMeshReport {
    std::size_t triangles_before = 0;
    std::size_t triangles = 0;
    double largest_error_px = 0.0;  // largest_mesh_error_px; at most the shot's mesh.pixel_error
    bool from_cache = false;
    double seconds = 0.0;
};

// How near a shot's flight comes, in pixels of its picture: the whole flight, a little before and after it, and what a
// shot exposes beyond that. The same for all frame rates and shutters, and for shots of other parts of the flight.
[[nodiscard]] ClosestApproach approach_of(const ShotDocument& shot, const CameraPath& path, const Stage& stage);

// Has the stage look at as few triangles as the shot's mesh.pixel_error allows along its flight (design 3.6): one mesh
// for all frames, so nothing pops. Kept in the cache under the content of the terrain and all that decides what is
// allowed. With a pixel_error of 0 the stage stays as it is.
// REQUIRES: the stage has its full mesh, and nobody refers to what it looks at.
FlightMeshReport fit_mesh_to_flight(Stage& stage, const ShotDocument& shot, const CameraPath& path,
                                    const std::filesystem::path& cache_folder, const Progress& progress = {});

}  // namespace overfly
