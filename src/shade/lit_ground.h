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
// Of a quarter of a cell at most one look says enough, and one cell has two: light bends at its sides. What is swept
// faster than the most is a blur that nobody sees the grain of.
inline constexpr double kLooksMore = 0.75;
inline constexpr double kMostLooks = 32.0;

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
        return place_of(looked_up((in_shadow ? without_sun_ : in_sun_).data(), place.column, place.row));
    }

    // The straight way between two places, and the looks at it that its light is the mean of: one at each cell, and one
    // more, 32 at most. Of light as different from sample to sample as can be, 16 lines have the error that they have
    // on the full mesh.
    struct Way {
        double column = 0.0, row = 0.0;  // of the first look
        double step_columns = 0.0, step_rows = 0.0;
        int looks = 1;
    };
    [[nodiscard]] static Way way(RasterPlace from, RasterPlace to);
    [[nodiscard]] Place mean(const Way& way, bool in_shadow) const {
        const Sample* const samples = (in_shadow ? without_sun_ : in_sun_).data();
        Float4 sum = looked_up(samples, way.column, way.row);
        for (int k = 1; k < way.looks; ++k)
            sum += looked_up(samples, way.column + k * way.step_columns, way.row + k * way.step_rows);
        return place_of(sum * (1.0F / static_cast<float>(way.looks)));
    }

    // The lowest ground, as height_over_ball_m counts.
    [[nodiscard]] double lowest_m() const { return lowest_m_; }
    [[nodiscard]] const FarGround& far() const { return far_; }
    [[nodiscard]] std::size_t memory_bytes() const { return (in_sun_.size() + without_sun_.size()) * sizeof(Sample); }

  private:
    // Red, green, blue, and the height: four numbers that are worked on as one. The height is negative, if only -0.0,
    // where SampleGrid::diagonal is 1; nothing else ever is.
    using Sample = Float4;

    static Place place_of(Float4 v) { return {{v[0], v[1], v[2]}, v[3]}; }
    static Float4 without_sign(Float4 v) {
        using Int4 [[gnu::vector_size(16)]] = std::int32_t;
        return reinterpret_cast<Float4>(reinterpret_cast<Int4>(v) & 0x7fffffff);  // of vectors: the same bits
    }
    [[nodiscard]] Float4 looked_up(const Sample* samples, double column, double row) const {
        const int c = std::clamp(static_cast<int>(column), 0, columns_ - 2);
        const int r = std::clamp(static_cast<int>(row), 0, rows_ - 2);
        const auto right = std::clamp(static_cast<float>(column - c), 0.0F, 1.0F);
        const auto down = std::clamp(static_cast<float>(row - r), 0.0F, 1.0F);
        const Sample* const s =
            samples + static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        const Sample* const below = s + columns_;
        // Shares of the corners. With this of the one opposite they are those in either triangle of the cell;
        // right * down would make it the bilinear interpolation.
        const float if_joined = std::max(right + down - 1.0F, 0.0F), if_not = std::min(right, down);
        const float opposite = std::signbit((*s)[3]) ? if_joined : if_not;
        const float beside = right - opposite, under = down - opposite, first = 1.0F - right - under;
        return without_sign(first * *s) + without_sign(beside * s[1]) + without_sign(under * *below) +
               without_sign(opposite * below[1]);
    }

    void fill_beside(const std::vector<std::uint8_t>& is_known);

    int columns_ = 0, rows_ = 0;
    std::vector<Sample> in_sun_, without_sun_;  // by sample of the raster
    double lowest_m_ = 0.0;
    FarGround far_;
};

}  // namespace overfly
