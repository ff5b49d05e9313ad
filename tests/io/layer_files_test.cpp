#include "io/layer_files.h"

#include <set>
#include <string>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/frame_digest.h"
#include "io/frame_facts.h"
#include "io/layer_attributes.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"
#include "io/text_attribute.h"

namespace overfly {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

constexpr LayerSet kLayers = {Layer::Normal, Layer::Id, Layer::Cryptomatte, Layer::Direct};

Frame sample() {
    Frame frame = sample_frame(37, 19);
    add_layers(frame, kLayers);
    return frame;
}

FrameHeader header(LayerSet layer_files) {
    FrameHeader header = sample_header();
    header.layers = kLayers;
    header.layer_files = layer_files;
    header.objects = {"torus"};
    return header;
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
    return names;
}

std::vector<std::string> channels_in(const std::filesystem::path& file) {
    std::vector<std::string> names;
    for (const FrameChannel& channel : read_channels(file).channels) names.push_back(channel.name);
    return names;
}

TEST(LayerFiles, HaveTheNumberAtTheEnd) {
    EXPECT_EQ(layer_file("out/a.b.0012.exr", Layer::Normal), "out/a.b.N.0012.exr");
    EXPECT_EQ(layer_file("12345.exr", Layer::SunIncidence), "12345.sun_incidence.exr");
}

TEST(LayerFiles, AreKnownByTheirNames) {
    const auto found = layer_sequence("a.b.sun_incidence");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->frames, "a.b");
    EXPECT_EQ(found->layer, Layer::SunIncidence);
    EXPECT_FALSE(layer_sequence("a.b"));
    EXPECT_FALSE(layer_sequence("N"));
    EXPECT_FALSE(layer_sequence("a.all"));
}

TEST(LayerFiles, HoldTheirLayersAndTheFrameTheRest) {
    const TemporaryFolder folder;
    write_frame(folder / "a.0025.exr", sample(), header({Layer::Normal, Layer::Cryptomatte}));
    EXPECT_THAT(files_in(folder.path()), UnorderedElementsAre("a.0025.exr", "a.N.0025.exr", "a.cryptomatte.0025.exr"));
    EXPECT_THAT(channels_in(folder / "a.0025.exr"),
                UnorderedElementsAre("R", "G", "B", "A", "Z", "id", "direct.R", "direct.G", "direct.B"));
    EXPECT_THAT(channels_in(folder / "a.N.0025.exr"), UnorderedElementsAre("N.X", "N.Y", "N.Z"));
    EXPECT_EQ(channels_in(folder / "a.cryptomatte.0025.exr").size(), 12U);
}

TEST(LayerFiles, AreOneFrameWhateverIsWhere) {
    const TemporaryFolder folder;
    const FrameStorage lossy = {.beauty = Compression::Dwaa};
    for (const FrameStorage& storage : {FrameStorage{}, lossy}) {
        const FrameDigest one = write_digested_frame(folder / "one.exr", sample(), header({}), storage);
        const FrameDigest several = write_digested_frame(folder / "several.exr", sample(), header(kLayers), storage);
        EXPECT_EQ(several.pixels_sha256, one.pixels_sha256);
        EXPECT_EQ(several.statistics, one.statistics);
        EXPECT_EQ(digest_frame(folder / "several.exr").pixels_sha256, one.pixels_sha256);
        EXPECT_EQ(digest_frame(folder / "several.exr").size_bytes, several.size_bytes);
        EXPECT_EQ(read_frame_with_layers(folder / "several.exr"), read_frame_with_layers(folder / "one.exr"));
    }
    EXPECT_TRUE(is_complete_frame(folder / "several.exr"));
}

TEST(LayerFiles, HaveTheWholeHeader) {
    const TemporaryFolder folder;
    write_frame(folder / "a.0025.exr", sample(), header(kLayers));
    const FrameFacts frame = read_frame_facts(folder / "a.0025.exr");
    EXPECT_EQ(frame.layer_files, kLayers);
    for (const std::filesystem::path& file : files_of_frame(folder / "a.0025.exr", kLayers)) {
        const FrameFacts facts = read_frame_facts(file);
        EXPECT_EQ(facts.number, 25) << file;
        EXPECT_EQ(facts.world_to_camera, frame.world_to_camera) << file;
        EXPECT_EQ(facts.shot, frame.shot) << file;
    }
    // Each says what is in it, and Cryptomatte's file alone that it is one.
    const std::string in_frame = text_attribute(folder / "a.0025.exr", kLayersAttribute);
    EXPECT_THAT(in_frame, HasSubstr("Z: planar"));
    EXPECT_THAT(in_frame, Not(HasSubstr("N.X")));
    EXPECT_EQ(text_attribute(folder / "a.N.0025.exr", kLayersAttribute),
              "N.X N.Y N.Z: " + std::string(kind_of(Layer::Normal).meaning) + "\n");
    EXPECT_EQ(text_attribute(folder / "a.0025.exr", "cryptomatte/3ae39a5/name"), "");
    EXPECT_EQ(text_attribute(folder / "a.cryptomatte.0025.exr", "cryptomatte/3ae39a5/name"), "CryptoObject");
    EXPECT_EQ(text_attribute(folder / "a.id.0025.exr", kObjectsAttribute), "{\"torus\":\"f19c73fd\"}");
}

TEST(LayerFiles, AreMissedByTheirFrame) {
    const TemporaryFolder folder;
    write_frame(folder / "a.0025.exr", sample(), header(kLayers));
    std::filesystem::resize_file(folder / "a.N.0025.exr", std::filesystem::file_size(folder / "a.N.0025.exr") - 50);
    EXPECT_FALSE(is_complete_frame(folder / "a.0025.exr"));
    std::filesystem::remove(folder / "a.N.0025.exr");
    EXPECT_FALSE(is_complete_frame(folder / "a.0025.exr"));
    try {
        (void)digest_frame(folder / "a.0025.exr");
        FAIL() << "a layer is missing";
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().front().place.file, folder / "a.N.0025.exr");
    }
    Frame other = sample_frame(36, 19);
    add_layers(other, {Layer::Normal});
    write_frame(folder / "b.0025.exr", other, header({Layer::Normal}));
    std::filesystem::rename(folder / "b.N.0025.exr", folder / "a.N.0025.exr");
    EXPECT_THROW((void)digest_frame(folder / "a.0025.exr"), UserError);
}

// A folder is in the place of a layer's file.
TEST(LayerFiles, LeaveNoFrameWithoutThem) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "a.id.0025.exr" / "taken");
    EXPECT_THROW(write_frame(folder / "a.0025.exr", sample(), header({Layer::Normal, Layer::Id})), UserError);
    EXPECT_THAT(files_in(folder.path()), UnorderedElementsAre("a.id.0025.exr", "a.N.0025.exr"));
}

}  // namespace
}  // namespace overfly
