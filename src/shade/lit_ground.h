#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shade/far_ground.h"
#include "shade/ground_light.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// A place in a raster, counted in samples.
struct RasterPlace {
    double column = 0.0, row = 0.0;
};

// The light of a full mesh by place in the raster, for whoever sees the ground through fewer triangles.
// 32 bytes for each sample of the raster, of which a place in the sun touches 16 of four neighbours: two or three lines
// of a processor's cache.
class LitGround {
  public:
    // What there is between samples: linear over each triangle of the full mesh.
    struct Place {
        Rgb radiance;
        float height_m = 0.0F;  // above lowest_m()
    };

    // REQUIRES: a mesh of triangulate(), its light.
    LitGround(const TerrainMesh& full, const GroundLight& light);

    // in_shadow: as GroundLight::without_sun. Places a rounding error outside of the mesh get what is next to them.
    [[nodiscard]] Place at(RasterPlace place, bool in_shadow) const;
    // The mean over the straight way between two places, by a look at each cell on it and one more, 32 at most. Of
    // light as different from sample to sample as can be, 16 lines have the error that they have on the full mesh.
    [[nodiscard]] Place mean(RasterPlace from, RasterPlace to, bool in_shadow) const;

    // The lowest ground, as height_over_ball_m counts.
    [[nodiscard]] double lowest_m() const { return lowest_m_; }
    [[nodiscard]] const FarGround& far() const { return far_; }
    [[nodiscard]] std::size_t memory_bytes() const { return (in_sun_.size() + without_sun_.size()) * sizeof(Sample); }

  private:
    // Red, green, blue, and the height: four numbers that are worked on as one. The height is negative, if only -0.0,
    // where SampleGrid::diagonal is 1; nothing else ever is.
    struct alignas(16) Sample {
        std::array<float, 4> v{};
    };

    void fill_beside(const std::vector<std::uint8_t>& is_known);

    int columns_ = 0, rows_ = 0;
    std::vector<Sample> in_sun_, without_sun_;  // by sample of the raster
    double lowest_m_ = 0.0;
    FarGround far_;
};

}  // namespace overfly
