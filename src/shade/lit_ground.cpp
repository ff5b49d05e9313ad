#include "shade/lit_ground.h"

#include <algorithm>
#include <cmath>

#include "shade/beside_ground.h"
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
    fill_beside(is_known, grid.columns, [&](std::size_t to, std::size_t from) {
        samples_[to] = samples_[from];
        samples_[count + to] = samples_[count + from];
    });
    for (std::size_t i = 0; i < count; ++i) {
        if (grid.diagonal[i] == 0) continue;
        for (Sample* const sample : {&samples_[i], &samples_[count + i]}) (*sample)[3] = -(*sample)[3];
    }
}

}  // namespace overfly
