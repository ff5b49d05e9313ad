#include "io/frame_digest.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// Two by one pixels of float channels, one part each.
struct Layer {
    const char *part, *channel;
    std::array<float, 2> values;
};

void write_layers(const std::filesystem::path& file, const std::vector<Layer>& layers,
                  Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    std::vector<Imf::Header> headers;
    for (const Layer& layer : layers) {
        Imf::Header& header = headers.emplace_back(2, 1);
        header.setName(layer.part);
        header.setType(Imf::SCANLINEIMAGE);
        header.compression() = compression;
        header.channels().insert(layer.channel, Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile output(file.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < layers.size(); ++i) {
        Imf::FrameBuffer buffer;
        buffer.insert(layers[i].channel,
                      Imf::Slice::Make(Imf::FLOAT, layers[i].values.data(), headers[i].dataWindow()));
        Imf::OutputPart part(output, static_cast<int>(i));
        part.setFrameBuffer(buffer);
        part.writePixels(1);
    }
}

TEST(FrameChannels, AreThoseOfAllPartsByName) {
    const TemporaryFolder folder;
    write_layers(folder / "a.exr", {{"one", "Z", {1, 2}}, {"two", "A", {3, 4}}, {"three", "Z", {5, 6}}});
    const FrameChannels frame = read_channels(folder / "a.exr");
    ASSERT_EQ(frame.channels.size(), 3U);
    EXPECT_EQ(frame.channels[0].name, "A");
    EXPECT_EQ(frame.channels[1].name, "Z");
    EXPECT_EQ(frame.channels[2].name, "three/Z");
    EXPECT_EQ(numbers_of(frame.channels[2]), (std::vector<float>{5, 6}));
    EXPECT_EQ(frame.channels[0].compression, "zip");
    EXPECT_EQ(frame.find("B"), nullptr);
}

TEST(FrameChannels, KeepEveryBitOfTheirTypes) {
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", sample_frame(5, 3), sample_header());
    const FrameChannels frame = read_channels(folder / "a.exr");
    const Frame read = read_frame(folder / "a.exr");
    ASSERT_EQ(frame.channels.size(), 5U);
    EXPECT_STREQ(name_of(frame.find("R")->type), "half");
    EXPECT_STREQ(name_of(frame.find("Z")->type), "float");
    EXPECT_EQ(numbers_of(*frame.find("Z")), read.depth_m);
    const std::vector<float> blue = numbers_of(*frame.find("B"));
    for (std::size_t i = 0; i < blue.size(); ++i) EXPECT_EQ(blue[i], read.rgba[i][2]);
}

TEST(PixelHash, IsOfThePixelsAlone) {
    const TemporaryFolder folder;
    const auto hash = [&](const std::vector<Layer>& layers, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
        write_layers(folder / "a.exr", layers, compression);
        return hex(pixel_hash(read_channels(folder / "a.exr")));
    };
    const std::string one = hash({{"one", "R", {1, 2}}, {"two", "G", {3, 4}}});
    EXPECT_EQ(hash({{"x", "G", {3, 4}}, {"y", "R", {1, 2}}}, Imf::PIZ_COMPRESSION), one) << "parts and compression";
    EXPECT_NE(hash({{"one", "R", {1, 2}}, {"two", "B", {3, 4}}}), one) << "another name";
    EXPECT_NE(hash({{"one", "R", {1, 2}}, {"two", "G", {3, 4.000001F}}}), one) << "another value";
    EXPECT_NE(hash({{"one", "R", {3, 4}}, {"two", "G", {1, 2}}}), one) << "exchanged";
    EXPECT_NE(hash({{"one", "R", {-0.0F, 2}}}), hash({{"one", "R", {0.0F, 2}}})) << "bits, not numbers";
}

TEST(ChannelStatistics, AreOfWhatIsFinite) {
    const std::vector<float> values = {1.0F, kNan, -3.0F, kInfinite, 5.0F, -kInfinite};
    const ChannelStatistics s = statistics_of(values);
    EXPECT_EQ(s.least, -3.0);
    EXPECT_EQ(s.most, 5.0);
    EXPECT_EQ(s.mean, 1.0);
    EXPECT_EQ(s.not_a_number, 1U);
    EXPECT_EQ(s.infinite, 2U);
    const ChannelStatistics none = statistics_of(std::vector<float>{kNan});
    EXPECT_EQ(none.least, 0.0);
    EXPECT_EQ(none.most, 0.0);
}

TEST(FrameDigest, SaysWhatAFrameLooksLike) {
    const TemporaryFolder folder;
    Frame frame = sample_frame(2, 1);
    frame.rgba = {{0.5F, 0.25F, 1.0F, 1.0F}, {0.0F, 0.0F, 0.0F, 0.5F}};
    frame.depth_m = {Frame::kNoDepth, 250.0F};
    write_frame(folder / "a.exr", frame, sample_header());
    const FrameDigest digest = digest_frame(folder / "a.exr");
    EXPECT_EQ(digest.size_bytes, std::filesystem::file_size(folder / "a.exr"));
    EXPECT_EQ(digest.width, 2);
    EXPECT_EQ(digest.height, 1);
    EXPECT_EQ(digest.pixels_sha256, hex(pixel_hash(read_channels(folder / "a.exr"))));
    ASSERT_TRUE(digest.statistics.luminance);
    EXPECT_NEAR(digest.statistics.luminance->most, 0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722, 1e-6);
    EXPECT_NEAR(digest.statistics.luminance->mean, 0.5 * digest.statistics.luminance->most, 1e-6);
    EXPECT_EQ(digest.statistics.luminance->least, 0.0);
    EXPECT_EQ(digest.statistics.mean_alpha, 0.75);
    EXPECT_EQ(digest.statistics.nearest_m, 250.0);
    EXPECT_FALSE(digest.is_black);
    EXPECT_EQ(digest.not_finite, 0U);
}

TEST(FrameDigest, OfAFrameThatIsWrittenIsThatOfItsFile) {
    const TemporaryFolder folder;
    for (const Compression beauty : {Compression::Zip, Compression::Piz, Compression::Dwaa}) {
        const FrameDigest written = write_digested_frame(folder / "a.exr", sample_frame(33, 17), sample_header(),
                                                         {.beauty = beauty, .data = Compression::Zip});
        const FrameDigest read = digest_frame(folder / "a.exr");
        EXPECT_EQ(written.pixels_sha256, read.pixels_sha256);
        EXPECT_EQ(written.size_bytes, read.size_bytes);
        EXPECT_EQ(written.width, read.width);
        EXPECT_EQ(written.statistics, read.statistics);
    }
}

TEST(FrameDigest, KnowsBlackAndTransparentFrames) {
    const TemporaryFolder folder;
    const auto is_black = [&](const std::vector<Layer>& layers) {
        write_layers(folder / "a.exr", layers);
        return digest_frame(folder / "a.exr").is_black;
    };
    const Layer red{"r", "R", {0, 0}}, green{"g", "G", {0, 0}}, blue{"b", "B", {0, 0}}, clear{"a", "A", {0, 0}};
    EXPECT_TRUE(is_black({red, green, blue, {"a", "A", {1, 1}}}));
    EXPECT_TRUE(is_black({{"r", "R", {1, 1}}, green, blue, clear}));
    EXPECT_FALSE(is_black({red, {"g", "G", {0, 1e-6F}}, blue, {"a", "A", {0, 1}}}));
    EXPECT_FALSE(is_black({red, green}));                  // not a picture
    EXPECT_FALSE(is_black({{"u", "forward.u", {0, 0}}}));  // what stands still
    EXPECT_FALSE(is_black({{"r", "R", {kNan, 0}}, green, blue}));
}

TEST(FrameDigest, CountsWhatIsNotFiniteInAnyChannel) {
    const TemporaryFolder folder;
    write_layers(folder / "a.exr",
                 {{"n", "N.X", {kNan, kInfinite}}, {"p", "P.X", {1, -kInfinite}}, {"z", "Z", {1, 2}}});
    const FrameDigest digest = digest_frame(folder / "a.exr");
    EXPECT_EQ(digest.not_finite, 3U);
    EXPECT_EQ(digest.not_finite_channel, "N.X");
    EXPECT_FALSE(digest.statistics.luminance);
    EXPECT_EQ(digest.statistics.nearest_m, 1.0);
}

TEST(FrameDigest, RefusesWhatCanNotBeReadWhole) {
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", sample_frame(40, 33), sample_header());
    const auto size = std::filesystem::file_size(folder / "a.exr");
    EXPECT_THROW((void)digest_frame(folder / "absent.exr"), UserError);
    EXPECT_THROW((void)digest_frame(folder.path()), UserError);
    for (std::uintmax_t cut = size; cut > 0; cut -= std::min<std::uintmax_t>(cut, 97)) {
        std::filesystem::resize_file(folder / "a.exr", cut - 1);
        EXPECT_THROW((void)digest_frame(folder / "a.exr"), UserError) << cut - 1 << " of " << size;
    }
}

}  // namespace
}  // namespace overfly
