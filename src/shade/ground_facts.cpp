#include "shade/ground_facts.h"

#include <algorithm>
#include <cmath>

#include "shade/beside_ground.h"

namespace overfly {

namespace {

template <class Value>
std::vector<Value> by_sample(const SampleGrid& grid, std::span<const Value> of_vertices) {
    std::vector<Value> out(grid.vertex.size());
    std::vector<std::uint8_t> is_known(out.size(), 0);
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (grid.vertex[i] == kNone) continue;
        is_known[i] = 1;
        out[i] = of_vertices[grid.vertex[i]];
    }
    fill_beside(is_known, grid.columns, [&](std::size_t to, std::size_t from) { out[to] = out[from]; });
    return out;
}

}  // namespace

void GroundFacts::add(Kind kind, const SampleGrid& grid, std::span<const Float4> of_vertices) {
    samples_[static_cast<std::size_t>(kind)] = by_sample(grid, of_vertices);
}

void GroundFacts::add_objects(const SampleGrid& grid, std::span<const std::uint16_t> of_vertices) {
    objects_ = by_sample(grid, of_vertices);
}

std::uint16_t GroundFacts::object_at(RasterPlace place) const {
    if (objects_.empty()) return 0;
    const int column = std::clamp(static_cast<int>(std::lround(place.column)), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(std::lround(place.row)), 0, rows_ - 1);
    return objects_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column)];
}

}  // namespace overfly
