#include "shade/raster_bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace overfly {
namespace {

// Rows of samples with gaps, as a mesh with holes has them.
std::vector<GridPlace> samples_with_gaps() {
    std::vector<GridPlace> samples;
    for (std::int32_t row = 3; row < 40; ++row) {
        if (row / kBandRows == 2) continue;
        for (std::int32_t column = 0; column < 50; ++column) {
            if ((column * 7 + row * 3) % 5 != 0) samples.push_back({column, row});
        }
    }
    return samples;
}

TEST(RasterBands, HoldEachVertexOnceColumnAfterColumn) {
    const std::vector<GridPlace> samples = samples_with_gaps();
    const std::vector<std::size_t> starts = band_starts(samples);
    std::vector<VertexId> all;
    for (std::size_t band = 0; band + 1 < starts.size(); ++band) {
        const std::vector<VertexId> order = by_columns(samples, starts[band], starts[band + 1]);
        ASSERT_FALSE(order.empty());
        for (std::size_t i = 0; i < order.size(); ++i) {
            EXPECT_EQ(samples[order[i]].row / kBandRows, samples[order[0]].row / kBandRows);
            if (i == 0) continue;
            const GridPlace before = samples[order[i - 1]], now = samples[order[i]];
            EXPECT_TRUE(before.column < now.column || (before.column == now.column && before.row < now.row));
        }
        all.insert(all.end(), order.begin(), order.end());
    }
    ASSERT_EQ(all.size(), samples.size());
    std::ranges::sort(all);
    for (std::size_t v = 0; v < all.size(); ++v) EXPECT_EQ(all[v], v);
    EXPECT_EQ(starts.size() - 1, 4U);  // rows 3 to 7, 8 to 15, 24 to 31, 32 to 39
}

TEST(RasterBands, OfNothingAreNone) {
    EXPECT_EQ(band_starts({}).size(), 1U);
    EXPECT_TRUE(by_columns({}, 0, 0).empty());
}

}  // namespace
}  // namespace overfly
