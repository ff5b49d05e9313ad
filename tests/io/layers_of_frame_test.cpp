// Layers on their way into a file and back.

#include <bit>
#include <limits>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIDManifest.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "film/cryptomatte.h"
#include "io/layer_attributes.h"
#include "io/sample_frame.h"
#include "io/stored_pixels.h"
#include "io/temporary_folder.h"
#include "io/text_attribute.h"

namespace overfly {
namespace {

using testing::HasSubstr;
using testing::Not;

Frame frame_with(LayerSet layers) {
    Frame frame = sample_frame(37, 19);
    add_layers(frame, layers);
    return frame;
}

FrameHeader header_with(LayerSet layers) {
    FrameHeader header = sample_header();
    header.layers = layers;
    return header;
}

TEST(LayersOfFrame, AreStoredInTheirTypes) {
    const TemporaryFolder folder;
    const LayerSet all = *layers_named("all");
    Frame frame = frame_with(all);
    write_frame(folder / "a.exr", frame, header_with(all));
    const FrameChannels channels = read_channels(folder / "a.exr");
    EXPECT_EQ(channels.channels.size(), frame.layers.size() + 5);
    for (const LayerKind& kind : layer_kinds()) {
        for (const std::string_view name : kind.channels) {
            const FrameChannel* const channel = channels.find(name);
            ASSERT_NE(channel, nullptr) << name;
            const ChannelType type = kind.type == StoredAs::Half    ? ChannelType::Half
                                     : kind.type == StoredAs::Float ? ChannelType::Float
                                                                    : ChannelType::Uint;
            EXPECT_EQ(channel->type, type) << name;
        }
    }
    const Frame back = read_frame_with_layers(folder / "a.exr");
    EXPECT_EQ(back.layers.size(), frame.layers.size());
    for (const LayerChannel& channel : back.layers) {
        const auto written = std::ranges::find(frame.layers, channel.name, &LayerChannel::name);
        ASSERT_NE(written, frame.layers.end());
        for (std::size_t i = 0; i < channel.values.size(); ++i) {
            const float tolerance = channel.type == StoredAs::Half ? std::ldexp(written->values[i], -11) : 0.0F;
            ASSERT_NEAR(channel.values[i], written->values[i], tolerance) << channel.name;
        }
    }
}

TEST(LayersOfFrame, KeepTheBitsOfNumbersOfObjects) {
    const TemporaryFolder folder;
    Frame frame = frame_with({Layer::Id});
    frame.layers[0].values[0] = std::bit_cast<float>(0xffffffffU);  // no number as a float
    frame.layers[0].values[1] = std::bit_cast<float>(4053562365U);
    write_frame(folder / "a.exr", frame, header_with({Layer::Id}));
    const Frame back = read_frame_with_layers(folder / "a.exr");
    EXPECT_EQ(std::bit_cast<std::uint32_t>(back.layers[0].values[0]), 0xffffffffU);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(back.layers[0].values[1]), 4053562365U);
}

TEST(LayersOfFrame, EndWhereHalfEnds) {
    Frame frame = frame_with({Layer::Sky});
    frame.layers[0].values[0] = 1e9F;
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", frame, header_with({Layer::Sky}));
    EXPECT_EQ(read_frame_with_layers(folder / "a.exr").layers[2].values[0], 65504.0F);  // sky.B, G, R
}

TEST(LayersOfFrame, AreFinite) {
    const TemporaryFolder folder;
    for (const Layer layer : {Layer::Haze, Layer::Position}) {
        Frame frame = frame_with({layer});
        frame.layers[1].values[5] = std::numeric_limits<float>::quiet_NaN();
        EXPECT_THROW(write_frame(folder / "a.exr", frame, header_with({layer})), InternalError);
    }
}

TEST(LayersOfFrame, AreHashedInMemoryAsInAFile) {
    const TemporaryFolder folder;
    const LayerSet layers = {Layer::Normal, Layer::Id, Layer::Longitude, Layer::Direct};
    const Frame frame = frame_with(layers);
    const FrameDigest digest = write_digested_frame(folder / "a.exr", frame, header_with(layers));
    EXPECT_EQ(digest.pixels_sha256, hex(pixel_hash(read_channels(folder / "a.exr"))));
    EXPECT_EQ(digest.pixels_sha256, digest_frame(folder / "a.exr").pixels_sha256);
}

TEST(LayersOfFrame, LoseSomethingWhereTheyAreLightOnly) {
    const TemporaryFolder folder;
    const LayerSet layers = {Layer::Direct, Layer::Normal, Layer::Id};
    const Frame frame = frame_with(layers);
    write_frame(folder / "zip.exr", frame, header_with(layers));
    write_frame(folder / "a.exr", frame, header_with(layers), {.beauty = Compression::Dwaa, .quality = 500.0});
    const FrameChannels lossless = read_channels(folder / "zip.exr"), lossy = read_channels(folder / "a.exr");
    for (const FrameChannel& channel : lossy.channels) {
        const bool is_light = channel.name.starts_with("direct.") || channel.name.size() == 1;
        if (!is_light || channel.name == "A" || channel.name == "Z") {
            EXPECT_EQ(channel.values, lossless.find(channel.name)->values) << channel.name;
        } else {
            EXPECT_NE(channel.values, lossless.find(channel.name)->values) << channel.name;
        }
        EXPECT_EQ(channel.compression, is_light && channel.name != "Z" ? "dwaa" : "zip") << channel.name;
    }
}

TEST(LayersOfFrame, AreExplainedInTheHeader) {
    const TemporaryFolder folder;
    const LayerSet layers = {Layer::Normal, Layer::Cryptomatte};
    FrameHeader header = header_with(layers);
    header.objects = {"torus", "glider \"7\""};
    write_frame(folder / "a.exr", frame_with(layers), header);
    const std::string meanings = text_attribute(folder / "a.exr", kLayersAttribute);
    EXPECT_THAT(meanings, HasSubstr("Z: planar distance along the view axis in metres, nearest"));
    EXPECT_THAT(meanings, HasSubstr("\nN.X N.Y N.Z: normal in the scene"));
    EXPECT_THAT(meanings, Not(HasSubstr("range")));
    EXPECT_EQ(text_attribute(folder / "a.exr", "cryptomatte/3ae39a5/name"), "CryptoObject");
    EXPECT_EQ(text_attribute(folder / "a.exr", "cryptomatte/3ae39a5/hash"), "MurmurHash3_32");
    EXPECT_EQ(text_attribute(folder / "a.exr", "cryptomatte/3ae39a5/conversion"), "uint32_to_float32");
    EXPECT_EQ(
        text_attribute(folder / "a.exr", "cryptomatte/3ae39a5/manifest"),
        "{\"glider \\\"7\\\"\":\"" + cryptomatte_hex(cryptomatte_id("glider \"7\"")) + "\",\"torus\":\"f19c73fd\"}");
}

TEST(LayersOfFrame, HaveNothingOfCryptomatteWithoutIt) {
    const TemporaryFolder folder;
    FrameHeader header = header_with({Layer::Id});
    header.objects = {"torus"};
    write_frame(folder / "a.exr", frame_with({Layer::Id}), header);
    EXPECT_EQ(text_attribute(folder / "a.exr", "cryptomatte/3ae39a5/manifest"), "");
    EXPECT_EQ(text_attribute(folder / "a.exr", kObjectsAttribute), "{\"torus\":\"f19c73fd\"}");
}

// Two ways: OpenEXR has the same hash for its own manifests.
TEST(Cryptomatte, HashesAsOpenExrDoes) {
    std::string name;
    for (int length = 0; length < 40; ++length) {
        const std::uint32_t theirs = Imf::IDManifest::MurmurHash32(name);
        const std::uint32_t exponent = theirs >> 23U & 0xffU;
        const bool is_flipped = exponent == 0 || exponent == 0xffU;
        EXPECT_EQ(cryptomatte_id(name), is_flipped ? theirs ^ 0x800000U : theirs) << name;
        name += static_cast<char>(200 - 5 * length);
    }
}

// What other programs see.
TEST(LayersOfFrame, AreReadByOpenImageIo) {
    const TemporaryFolder folder;
    const LayerSet layers = {Layer::Motion, Layer::Id};
    const Frame frame = frame_with(layers);
    write_frame(folder / "a.exr", frame, header_with(layers));
    const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_THAT(spec.channelnames, testing::UnorderedElementsAre("R", "G", "B", "A", "Z", "forward.u", "forward.v",
                                                                 "backward.u", "backward.v", "id"));
    EXPECT_EQ(spec.channelformat(spec.channelindex("id")), OIIO::TypeDesc::UINT32);
    EXPECT_EQ(spec.channelformat(spec.channelindex("forward.u")), OIIO::TypeDesc::FLOAT);
}

}  // namespace
}  // namespace overfly
