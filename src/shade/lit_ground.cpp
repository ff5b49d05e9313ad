#include "shade/lit_ground.h"

#include <algorithm>
#include <cmath>

#include "shade/daylight.h"
#include "terrain/sample_grid.h"

namespace overfly {

LitGround::LitGround(const TerrainMesh& full, const GroundLight& light) : far_(full, light) {
    const SampleGrid grid(full);
    columns_ = grid.columns;
    rows_ = grid.rows;
    if (full.positions.empty()) return;
    lowest_m_ = height_over_ball_m(full.positions.front());
    for (const Point<Scene>& p : full.positions) lowest_m_ = std::min(lowest_m_, height_over_ball_m(p));
    const std::size_t count = grid.vertex.size();
    samples_.resize(2 * count);
    std::vector<std::uint8_t> is_known(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const VertexId v = grid.vertex[i];
        if (v == kNone) continue;
        is_known[i] = 1;
        const auto height_m = static_cast<float>(height_over_ball_m(full.positions[v]) - lowest_m_);
        const Rgb sun = light.radiance[v], shade = light.without_sun[v];
        samples_[i] = Sample{sun.r, sun.g, sun.b, height_m};
        samples_[count + i] = Sample{shade.r, shade.g, shade.b, height_m};
    }
    fill_beside(is_known);
    for (std::size_t i = 0; i < count; ++i) {
        if (grid.diagonal[i] == 0) continue;
        for (Sample* const sample : {&samples_[i], &samples_[count + i]}) (*sample)[3] = -(*sample)[3];
    }
}

// Samples without ground that are beside one with ground take its light: rounding may look a little past an edge.
void LitGround::fill_beside(const std::vector<std::uint8_t>& is_known) {
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t count = is_known.size(), rows = count / columns;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_known[i] != 0) continue;
        const std::size_t row = i / columns, column = i % columns;
        for (std::size_t r = row > 0 ? row - 1 : 0; r < std::min(row + 2, rows); ++r) {
            for (std::size_t c = column > 0 ? column - 1 : 0; c < std::min(column + 2, columns); ++c) {
                const std::size_t beside = r * columns + c;
                if (is_known[beside] == 0) continue;
                samples_[i] = samples_[beside];
                samples_[count + i] = samples_[count + beside];
            }
        }
    }
}

}  // namespace overfly
