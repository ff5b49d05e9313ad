#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shade/far_ground.h"
#include "shade/fast_exp.h"
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
    [[nodiscard]] Place at(RasterPlace place, bool in_shadow) const {
        return place_of(looked_up(samples(in_shadow), place));
    }

    // Which samples a place lies between, and the share of each: those of the corners in either triangle of the cell.
    struct Corners {
        std::size_t index = 0;  // of the first; the second is the next one, the others are below them
        float first = 1.0F, beside = 0.0F, under = 0.0F, opposite = 0.0F;
    };
    [[nodiscard]] Corners corners(RasterPlace place) const {
        const int c = std::clamp(static_cast<int>(place.column), 0, columns_ - 2);
        const int r = std::clamp(static_cast<int>(place.row), 0, rows_ - 2);
        const auto right = std::clamp(static_cast<float>(place.column - c), 0.0F, 1.0F);
        const auto down = std::clamp(static_cast<float>(place.row - r), 0.0F, 1.0F);
        const std::size_t index =
            static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        // right * down would make it the bilinear interpolation.
        const float if_joined = std::max(right + down - 1.0F, 0.0F), if_not = std::min(right, down);
        const float opposite = std::signbit(samples_[index][3]) ? if_joined : if_not;
        const float beside = right - opposite, under = down - opposite;
        return {index, 1.0F - right - under, beside, under, opposite};
    }
    [[nodiscard]] int columns() const { return columns_; }

    // The lowest ground, as height_over_ball_m counts.
    [[nodiscard]] double lowest_m() const { return lowest_m_; }
    [[nodiscard]] const FarGround& far() const { return far_; }
    [[nodiscard]] std::size_t memory_bytes() const { return samples_.size() * sizeof(Sample); }

    // The samples, for vector units: red, green, blue and height of each, row by row, and after all of them all again
    // without sun. A height is negative, if only -0.0, where SampleGrid::diagonal is 1; nothing else ever is.
    struct Raster {
        const float* samples = nullptr;
        int columns = 0, rows = 0;
    };
    [[nodiscard]] Raster raster() const { return {reinterpret_cast<const float*>(samples_.data()), columns_, rows_}; }

  private:
    using Sample = Float4;

    [[nodiscard]] const Sample* samples(bool in_shadow) const {
        return samples_.data() + (in_shadow ? samples_.size() / 2 : 0);
    }
    static Place place_of(Float4 v) { return {{v[0], v[1], v[2]}, v[3]}; }
    static Float4 without_sign(Float4 v) {
        return reinterpret_cast<Float4>(reinterpret_cast<Int4>(v) & 0x7fffffff);  // of vectors: the same bits
    }
    [[nodiscard]] Float4 looked_up(const Sample* of, RasterPlace place) const {
        const Corners c = corners(place);
        const Sample* const s = of + c.index;
        const Sample* const below = s + columns_;
        return without_sign(c.first * *s) + without_sign(c.beside * s[1]) + without_sign(c.under * *below) +
               without_sign(c.opposite * below[1]);
    }

    int columns_ = 0, rows_ = 0;
    std::vector<Sample> samples_;
    double lowest_m_ = 0.0;
    FarGround far_;
};

}  // namespace overfly
