#include "shade/raster_bands.h"

#include <algorithm>

namespace overfly {

std::vector<std::size_t> band_starts(std::span<const GridPlace> samples) {
    std::vector<std::size_t> starts;
    for (std::size_t v = 0; v < samples.size(); ++v) {
        if (v == 0 || samples[v].row / kBandRows != samples[v - 1].row / kBandRows) starts.push_back(v);
    }
    starts.push_back(samples.size());
    return starts;
}

std::vector<VertexId> by_columns(std::span<const GridPlace> samples, std::size_t first, std::size_t last) {
    const auto band = samples.subspan(first, last - first);
    if (band.empty()) return {};
    const auto [least, most] = std::ranges::minmax(band, {}, &GridPlace::column);
    const auto column = [from = least.column](const GridPlace& p) { return static_cast<std::size_t>(p.column - from); };
    std::vector<std::size_t> end(column(most) + 2, 0);  // of each column's vertices, from 1 on
    for (const GridPlace& p : band) ++end[column(p) + 1];
    for (std::size_t c = 1; c < end.size(); ++c) end[c] += end[c - 1];
    std::vector<VertexId> order(band.size());
    for (std::size_t i = 0; i < band.size(); ++i) order[end[column(band[i])]++] = static_cast<VertexId>(first + i);
    return order;
}

}  // namespace overfly
