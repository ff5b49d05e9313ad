#include "film/layers.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(LayerKinds, AreFoundByTheirChannels) {
    std::set<std::string_view> channels;
    for (const LayerKind& kind : layer_kinds()) {
        EXPECT_EQ(kind_of(kind.layer).name, kind.name);
        EXPECT_FALSE(kind.meaning.empty()) << kind.name;
        for (const std::string_view channel : kind.channels) {
            EXPECT_TRUE(channels.insert(channel).second) << channel << " is a channel of two layers";
            EXPECT_EQ(layer_of_channel(channel), kind.layer);
        }
    }
    for (const char* none : {"R", "G", "B", "A", "Z", "N", ""}) EXPECT_FALSE(layer_of_channel(none)) << none;
}

TEST(LayerKinds, AreAskedForByOneNameOrBySeveral) {
    LayerSet all;
    for (const LayerKind& kind : layer_kinds()) {
        EXPECT_EQ(layers_named(kind.name), LayerSet{kind.layer});
        all.add(kind.layer);
    }
    EXPECT_EQ(layers_named("all"), all);
    EXPECT_FALSE(layers_named("n"));
    EXPECT_FALSE(layers_named(""));
}

// What light is lost in is for the eye; the rest of it never is.
TEST(LayerKinds, AreStoredAsTheyNeedIt) {
    for (const LayerKind& kind : layer_kinds()) {
        const bool is_half = kind.type == StoredAs::Half;
        EXPECT_EQ(is_half, kind.group == LayerGroup::Beauty || kind.layer == Layer::Normal) << kind.name;
    }
}

// As a row of the table: the layer, and each of its channels.
TEST(LayerKinds, AreInTheManual) {
    std::ifstream stream(std::filesystem::path(OVERFLY_SOURCE_DIR) / "docs/layers.md");
    const std::string manual{std::istreambuf_iterator<char>(stream), {}};
    for (const LayerKind& kind : layer_kinds()) {
        std::string row = "\n| `" + std::string(kind.name) + "` |";
        for (const std::string_view channel : kind.channels) row += " `" + std::string(channel) + "`";
        const char* const type = kind.type == StoredAs::Half ? "half" : kind.type == StoredAs::Float ? "float" : "uint";
        row += std::string(" | ") + type + " |";
        EXPECT_NE(manual.find(row), std::string::npos) << row;
    }
}

}  // namespace
}  // namespace overfly
