#include "shade/lit_ground.h"

#include <algorithm>
#include <cmath>

#include "shade/daylight.h"
#include "terrain/sample_grid.h"

namespace overfly {

namespace {

// What is swept faster is a blur that nobody sees the grain of.
constexpr double kMostLooks = 32.0;

}  // namespace

LitGround::LitGround(const TerrainMesh& full, const GroundLight& light) : far_(full, light) {
    const SampleGrid grid(full);
    columns_ = grid.columns;
    rows_ = grid.rows;
    if (full.positions.empty()) return;
    lowest_m_ = height_over_ball_m(full.positions.front());
    for (const Point<Scene>& p : full.positions) lowest_m_ = std::min(lowest_m_, height_over_ball_m(p));
    in_sun_.resize(grid.vertex.size());
    without_sun_.resize(in_sun_.size());
    std::vector<std::uint8_t> is_known(in_sun_.size(), 0);
    for (std::size_t i = 0; i < in_sun_.size(); ++i) {
        const VertexId v = grid.vertex[i];
        if (v == kNone) continue;
        is_known[i] = 1;
        const auto height_m = static_cast<float>(height_over_ball_m(full.positions[v]) - lowest_m_);
        const Rgb sun = light.radiance[v], shade = light.without_sun[v];
        in_sun_[i] = {{sun.r, sun.g, sun.b, height_m}};
        without_sun_[i] = {{shade.r, shade.g, shade.b, height_m}};
    }
    fill_beside(is_known);
    for (std::size_t i = 0; i < in_sun_.size(); ++i) {
        if (grid.diagonal[i] == 0) continue;
        for (auto* samples : {&in_sun_, &without_sun_}) (*samples)[i].v[3] = -(*samples)[i].v[3];
    }
}

// Samples without ground that are beside one with ground take its light: rounding may look a little past an edge.
void LitGround::fill_beside(const std::vector<std::uint8_t>& is_known) {
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t rows = in_sun_.size() / columns;
    for (std::size_t i = 0; i < in_sun_.size(); ++i) {
        if (is_known[i] != 0) continue;
        const std::size_t row = i / columns, column = i % columns;
        for (std::size_t r = row > 0 ? row - 1 : 0; r < std::min(row + 2, rows); ++r) {
            for (std::size_t c = column > 0 ? column - 1 : 0; c < std::min(column + 2, columns); ++c) {
                if (is_known[r * columns + c] == 0) continue;
                in_sun_[i] = in_sun_[r * columns + c];
                without_sun_[i] = without_sun_[r * columns + c];
            }
        }
    }
}

LitGround::Place LitGround::at(RasterPlace place, bool in_shadow) const {
    const int c = std::clamp(static_cast<int>(place.column), 0, columns_ - 2);
    const int r = std::clamp(static_cast<int>(place.row), 0, rows_ - 2);
    const auto right = std::clamp(static_cast<float>(place.column - c), 0.0F, 1.0F);
    const auto down = std::clamp(static_cast<float>(place.row - r), 0.0F, 1.0F);
    const std::size_t i =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
    const Sample* const s = &(in_shadow ? without_sun_ : in_sun_)[i];
    const Sample* const below = s + columns_;
    // Shares of the corners. With this of the one opposite they are those in either triangle of the cell; right * down
    // would make it the bilinear interpolation.
    const float opposite = std::signbit(s->v[3]) ? std::max(right + down - 1.0F, 0.0F) : std::min(right, down);
    const float beside = right - opposite, under = down - opposite, first = 1.0F - right - under;
    std::array<float, 4> v;
    for (std::size_t k = 0; k < v.size(); ++k) {
        v[k] = std::abs(first * s->v[k]) + std::abs(beside * s[1].v[k]) + std::abs(under * below->v[k]) +
               std::abs(opposite * below[1].v[k]);
    }
    return {{v[0], v[1], v[2]}, v[3]};
}

LitGround::Place LitGround::mean(RasterPlace from, RasterPlace to, bool in_shadow) const {
    const double columns = to.column - from.column;
    const double rows = to.row - from.row;
    // Of a quarter of a cell at most one look says enough, and one cell has two: light bends at its sides.
    const double cells = std::max(std::abs(columns), std::abs(rows));
    const int looks = static_cast<int>(std::clamp(std::ceil(cells + 0.75), 1.0, kMostLooks));
    const double step = 1.0 / looks;
    Place sum;
    for (int k = 0; k < looks; ++k) {
        const double share = step * (k + 0.5);
        const Place one = at({from.column + share * columns, from.row + share * rows}, in_shadow);
        sum.radiance += one.radiance;
        sum.height_m += one.height_m;
    }
    const auto weight = static_cast<float>(step);
    return {weight * sum.radiance, weight * sum.height_m};
}

}  // namespace overfly
