#pragma once

#include <cstddef>
#include <string>

#include "config/documents.h"
#include "shot/shot_body.h"
#include "shot/stage.h"

namespace overfly {

// What there is in a scene that takes memory.
struct SceneSizes {
    std::size_t full_triangles = 0, samples = 0;  // of the terrain, every sample of it
    std::size_t triangles = 0;                    // that are looked at: all of these, or fewer made for the flight
    bool has_hierarchy = false;                   // of the same, for the interval tracer
    std::size_t body_triangles = 0;
    std::size_t pixels = 0;
    std::size_t ground_facts = 0;  // that layers are told of each sample (shade/ground_facts.h)
};

// REQUIRES: the stage still has its full mesh.
[[nodiscard]] SceneSizes sizes_of(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies);

// Bytes that the scene takes, the program included: while it is made, and when frames are rendered. From above: up to
// some 30 percent more than what is measured (docs/kinetic.md, Memory).
struct SceneMemory {
    double making_bytes = 0.0, kept_bytes = 0.0;
};
[[nodiscard]] SceneMemory scene_memory(const SceneSizes& sizes);

// What frames there is memory for.
struct FramesInMemory {
    std::size_t frame_bytes = 0;  // of the film of one
    int threads = 1;              // each may write a frame, which takes its film once more
    std::size_t most = 2;         // frames that there is work for at once
};

struct MemoryPlan {
    SceneMemory scene;
    double frame_bytes = 0.0, allowed_bytes = 0.0;
    int threads = 1;
    std::size_t frames = 0;  // at once

    // What the render takes at most with so many films.
    [[nodiscard]] double bytes_with(std::size_t films) const;
    // "memory: 0.33 GB for the scene, 10.4 MB a frame, 16 frames at once, of 4 GB"
    [[nodiscard]] std::string text() const;
};

// As many frames at once as the shot allows, but no more than there is work for. Throws UserError where it allows too
// little for kFewestFilms (frame_loop.h), with the least that would do.
[[nodiscard]] MemoryPlan plan_memory(const ShotDocument& shot, const SceneMemory& scene, const FramesInMemory& frames);

// Throws what plan_memory will throw anyway, whatever the mesh for the flight will be: before work is done for nothing.
// REQUIRES: the stage still has its full mesh.
void require_memory(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies);

}  // namespace overfly
