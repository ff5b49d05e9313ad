#include "io/object_coverage.h"

#include <bit>

#include <gtest/gtest.h>

#include "film/cryptomatte.h"
#include "io/frame_file.h"
#include "io/layer_attributes.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

// Two pixels: half torus and a quarter terrain, and a quarter torus.
Frame sample(LayerSet layers) {
    Frame frame = sample_frame(2, 1);
    add_layers(frame, layers);
    const float torus = cryptomatte_number(cryptomatte_id("torus"));
    const float terrain = cryptomatte_number(cryptomatte_id("terrain"));
    for (LayerChannel& channel : frame.layers) channel.values = {0.0F, 0.0F};
    const auto set = [&](const char* name, std::vector<float> values) {
        for (LayerChannel& channel : frame.layers) {
            if (channel.name == name) channel.values = values;
        }
    };
    set("CryptoObject00.r", {torus, torus});
    set("CryptoObject00.g", {0.5F, 0.25F});
    set("CryptoObject00.b", {terrain, 0.0F});
    set("CryptoObject00.a", {0.25F, 0.0F});
    set("id", {terrain, 0.0F});
    return frame;
}

std::vector<ObjectCoverage> coverage(LayerSet layers, const std::string& manifest) {
    const TemporaryFolder folder;
    FrameHeader header = sample_header();
    header.layers = layers;
    write_frame(folder / "a.exr", sample(layers), header);
    return object_coverage(read_channels(folder / "a.exr"), manifest);
}

TEST(ObjectCoverage, AddsUpTheSharesOfCryptomatte) {
    const std::string manifest = cryptomatte_manifest(std::vector<std::string>{"torus", "terrain", "unseen"});
    const auto objects = coverage({Layer::Cryptomatte, Layer::Id}, manifest);
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_EQ(objects[0].name, "torus");
    EXPECT_DOUBLE_EQ(objects[0].share, 0.375);
    EXPECT_EQ(objects[1].name, "terrain");
    EXPECT_DOUBLE_EQ(objects[1].share, 0.125);
}

TEST(ObjectCoverage, CountsPixelsWhereThereIsNoCryptomatte) {
    const auto objects = coverage({Layer::Id}, "no manifest");
    ASSERT_EQ(objects.size(), 1U);
    EXPECT_EQ(objects[0].name, cryptomatte_hex(cryptomatte_id("terrain")));
    EXPECT_DOUBLE_EQ(objects[0].share, 0.5);
}

TEST(ObjectCoverage, IsNothingOfAFrameWithoutObjects) { EXPECT_TRUE(coverage({Layer::Normal}, "").empty()); }

// A float would round it.
TEST(ChannelStatistics, AreExactForNumbersOfObjects) {
    const TemporaryFolder folder;
    FrameHeader header = sample_header();
    header.layers = {Layer::Id};
    Frame frame = sample({Layer::Id});
    frame.layers.front().values = {std::bit_cast<float>(4053562365U), std::bit_cast<float>(4053562363U)};
    write_frame(folder / "a.exr", frame, header);
    const ChannelStatistics s = statistics_of(*read_channels(folder / "a.exr").find("id"));
    EXPECT_EQ(s.least, 4053562363.0);
    EXPECT_EQ(s.most, 4053562365.0);
}

}  // namespace
}  // namespace overfly
