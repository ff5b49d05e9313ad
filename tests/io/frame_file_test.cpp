#include "io/frame_file.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/error.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(FrameFile, GivesBackWhatWasWritten) {
    const TemporaryFolder folder;
    const Frame frame = sample_frame(67, 41);  // lines are not a multiple of ZIP's 16
    write_frame(folder / "a.exr", frame, sample_header());
    const Frame back = read_frame(folder / "a.exr");
    ASSERT_EQ(back.width, 67);
    ASSERT_EQ(back.height, 41);
    EXPECT_EQ(back.depth_m, frame.depth_m);
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            // Half has 11 significant bits: rounding to nearest is off by at most 2^-11 of the value.
            EXPECT_NEAR(back.rgba[i][c], frame.rgba[i][c], std::ldexp(frame.rgba[i][c], -11)) << i;
        }
    }
}

TEST(FrameFile, RoundsColoursToTheNearestHalfAndTiesToEven) {
    const TemporaryFolder folder;
    Frame frame = sample_frame(2, 1);
    const float step = std::ldexp(1.0F, -10);  // between halves above 1
    frame.rgba = {{1.0F + 0.49F * step, 1.0F + 0.51F * step, 1.0F + 0.5F * step, 1.0F + 1.5F * step},
                  {1e6F, -1e6F, std::ldexp(1.0F, -24), 0.0F}};
    frame.depth_m = {1.0F, 2.0F};
    write_frame(folder / "a.exr", frame, sample_header());
    const Frame back = read_frame(folder / "a.exr");
    EXPECT_EQ(back.rgba[0], (std::array{1.0F, 1.0F + step, 1.0F, 1.0F + 2.0F * step}));
    EXPECT_EQ(back.rgba[1], (std::array{65504.0F, -65504.0F, std::ldexp(1.0F, -24), 0.0F}));
}

TEST(FrameFile, RefusesToWriteWhatIsNotANumber) {
    const TemporaryFolder folder;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Frame frame = sample_frame(4, 4);
        frame.rgba[5][2] = bad;
        EXPECT_THROW(write_frame(folder / "a.exr", frame, sample_header()), InternalError);
        frame = sample_frame(4, 4);
        frame.depth_m[7] = bad;
        EXPECT_THROW(write_frame(folder / "a.exr", frame, sample_header()), InternalError);
    }
    Frame frame = sample_frame(4, 4);
    frame.depth_m.pop_back();
    EXPECT_THROW(write_frame(folder / "a.exr", frame, sample_header()), InternalError);
    EXPECT_EQ(folder.file_count(), 0U);
}

TEST(FrameFile, IsTheSameFileForTheSameFrame) {
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", sample_frame(33, 17), sample_header());
    write_frame(folder / "b.exr", sample_frame(33, 17), sample_header());
    EXPECT_EQ(content(folder / "a.exr"), content(folder / "b.exr"));
}

TEST(FrameFile, IsHalfColourAndFloatDepthInZip) {
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", sample_frame(33, 17), sample_header());
    const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_EQ(spec.channelnames, (std::vector<std::string>{"R", "G", "B", "A", "Z"}));
    EXPECT_EQ(spec.channelformats,
              (std::vector<OIIO::TypeDesc>{OIIO::TypeDesc::HALF, OIIO::TypeDesc::HALF, OIIO::TypeDesc::HALF,
                                           OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT}));
    EXPECT_EQ(spec.get_string_attribute("compression"), "zip");
}

std::string compression_of_part(const std::filesystem::path& file, int part) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input || !input->seek_subimage(part, 0)) return "no such part";
    return input->spec().get_string_attribute("compression");
}

TEST(FrameFile, IsCompressedAsAskedFor) {
    const TemporaryFolder folder;
    const Frame frame = sample_frame(67, 41);
    const std::vector<std::pair<Compression, std::string>> all = {
        {Compression::Zip, "zip"}, {Compression::Zips, "zips"}, {Compression::Piz, "piz"}};
    for (const auto& [compression, name] : all) {
        write_frame(folder / "a.exr", frame, sample_header(), {.beauty = compression, .data = compression});
        EXPECT_EQ(compression_of_part(folder / "a.exr", 0), name);
        EXPECT_EQ(compression_of_part(folder / "a.exr", 1), "no such part");
        write_frame(folder / "zip.exr", frame, sample_header());
        EXPECT_EQ(read_frame(folder / "a.exr"), read_frame(folder / "zip.exr")) << name;
    }
}

TEST(FrameFile, HasAPartForEachGroupThatIsCompressedDifferently) {
    const TemporaryFolder folder;
    const FrameStorage storage = {.beauty = Compression::Dwaa, .data = Compression::Zips, .quality = 80.0};
    write_frame(folder / "a.exr", sample_frame(67, 41), sample_header(), storage);
    EXPECT_THAT(compression_of_part(folder / "a.exr", 0), testing::StartsWith("dwaa"));
    EXPECT_EQ(compression_of_part(folder / "a.exr", 1), "zips");
    const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
    ASSERT_TRUE(input);
    const std::vector<std::pair<std::string, std::vector<std::string>>> parts = {{"beauty", {"R", "G", "B", "A"}},
                                                                                 {"data", {"Z"}}};
    for (int part = 0; part < 2; ++part) {
        ASSERT_TRUE(input->seek_subimage(part, 0));
        const OIIO::ImageSpec& spec = input->spec();
        const auto& [name, channels] = parts[static_cast<std::size_t>(part)];
        EXPECT_EQ(spec.get_string_attribute("oiio:subimagename"), name);
        EXPECT_EQ(spec.channelnames, channels);
        EXPECT_EQ(spec.get_int_attribute("imageCounter"), 25) << name;  // all parts have the whole header
    }
}

TEST(FrameFile, LosesNothingOfDataAndLittleOfLossyColour) {
    const TemporaryFolder folder;
    const Frame frame = sample_frame(67, 41);
    write_frame(folder / "a.exr", frame, sample_header(), {.beauty = Compression::Dwaa});
    const Frame back = read_frame(folder / "a.exr");
    EXPECT_EQ(back.depth_m, frame.depth_m);
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        EXPECT_EQ(back.rgba[i][3], frame.rgba[i][3]);  // alpha is no colour
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max<double>(largest, std::abs(back.rgba[i][c] - frame.rgba[i][c]));
    }
    EXPECT_GT(largest, 1e-4);
    EXPECT_LT(largest, 0.03);
}

TEST(FrameFile, IsSmallerWhereMoreMayBeLost) {
    const TemporaryFolder folder;
    write_frame(folder / "fine.exr", sample_frame(67, 41), sample_header(), {.beauty = Compression::Dwaa});
    write_frame(folder / "coarse.exr", sample_frame(67, 41), sample_header(),
                {.beauty = Compression::Dwaa, .quality = 400.0});
    EXPECT_LT(std::filesystem::file_size(folder / "coarse.exr"), std::filesystem::file_size(folder / "fine.exr"));
}

TEST(FrameFile, StoresNoDataWithLoss) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_frame(folder / "a.exr", sample_frame(4, 4), sample_header(), {.data = Compression::Dwaa}),
                 InternalError);
    EXPECT_EQ(folder.file_count(), 0U);
}

TEST(FrameFile, KnowsAFrameOfPartsThatIsCutOffOrDamaged) {
    const TemporaryFolder folder;
    write_frame(folder / "whole.exr", sample_frame(40, 33), sample_header(), {.beauty = Compression::Dwaa});
    EXPECT_TRUE(is_complete_frame(folder / "whole.exr"));
    const std::string whole = content(folder / "whole.exr");
    std::filesystem::copy_file(folder / "whole.exr", folder / "cut.exr");
    // Cut shorter and shorter, not written anew: replacing a file's content may wait for the disk.
    for (std::size_t size = whole.size(); size > 7;) {
        std::filesystem::resize_file(folder / "cut.exr", size -= 7);
        ASSERT_FALSE(is_complete_frame(folder / "cut.exr")) << size << " of " << whole.size();
    }
    std::string damaged = whole;
    damaged[damaged.size() - 100] = static_cast<char>(damaged[damaged.size() - 100] ^ 0x55);
    std::ofstream(folder / "cut.exr", std::ios::binary) << damaged;
    EXPECT_FALSE(is_complete_frame(folder / "cut.exr"));
}

TEST(FrameFile, KnowsAFrameThatIsCutOffAtAnyByte) {
    const TemporaryFolder folder;
    write_frame(folder / "whole.exr", sample_frame(40, 33), sample_header());
    EXPECT_TRUE(is_complete_frame(folder / "whole.exr"));
    std::filesystem::copy_file(folder / "whole.exr", folder / "cut.exr");
    const auto whole_size = std::filesystem::file_size(folder / "whole.exr");
    for (auto size = whole_size; size-- > 0;) {
        std::filesystem::resize_file(folder / "cut.exr", size);
        ASSERT_FALSE(is_complete_frame(folder / "cut.exr")) << size << " of " << whole_size;
    }
}

TEST(FrameFile, KnowsADamagedFrame) {
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", sample_frame(40, 33), sample_header());
    std::string damaged = content(folder / "a.exr");
    damaged[damaged.size() - 100] = static_cast<char>(damaged[damaged.size() - 100] ^ 0x55);
    std::ofstream(folder / "a.exr", std::ios::binary) << damaged;
    EXPECT_FALSE(is_complete_frame(folder / "a.exr"));
    EXPECT_THROW(static_cast<void>(read_frame(folder / "a.exr")), UserError);
}

TEST(FrameFile, RefusesWhatIsNotAFrame) {
    const TemporaryFolder folder;
    std::ofstream(folder / "text.exr") << "not a picture";
    EXPECT_FALSE(is_complete_frame(folder / "text.exr"));
    EXPECT_FALSE(is_complete_frame(folder / "missing.exr"));
    EXPECT_FALSE(is_complete_frame(folder.path()));
    EXPECT_THROW(static_cast<void>(read_frame(folder / "text.exr")), UserError);
    EXPECT_THROW(static_cast<void>(read_frame(folder / "missing.exr")), UserError);

    const auto output = OIIO::ImageOutput::create("exr");  // a picture of another program, without depth
    const std::vector<float> grey(12, 0.5F);
    ASSERT_TRUE(output->open((folder / "rgb.exr").string(), OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::HALF)));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, grey.data()) && output->close());
    EXPECT_FALSE(is_complete_frame(folder / "rgb.exr"));
}

// Lets no file grow beyond `size`, then tries to write a frame. The limit is the process's own, so this needs a child.
[[noreturn]] void write_within(rlim_t size, const TemporaryFolder& folder) {
    std::signal(SIGXFSZ, SIG_IGN);  // then the write fails with EFBIG, as it does with ENOSPC on a full disk
    const rlimit limit{size, size};
    setrlimit(RLIMIT_FSIZE, &limit);
    const bool nothing_before = folder.file_count() == 0;
    try {
        write_frame(folder / "a.exr", sample_frame(64, 48), sample_header());
    } catch (const UserError& e) {
        const bool said = std::string(e.what()) == (folder / "a.exr").string() + ": can't be written: File too large";
        std::_Exit(said && nothing_before && folder.file_count() == 0 ? 3 : 4);
    }
    std::_Exit(0);
}

TEST(FrameFileDeathTest, NoticesADiskThatFillsUpAndLeavesNothing) {
    const TemporaryFolder folder;
    write_frame(folder / "whole.exr", sample_frame(64, 48), sample_header());
    const auto size = std::filesystem::file_size(folder / "whole.exr");
    std::filesystem::remove(folder / "whole.exr");
    for (const std::uintmax_t limit : {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 1}) {
        EXPECT_EXIT(write_within(limit, folder), testing::ExitedWithCode(3), "") << limit;
    }
    EXPECT_EXIT(write_within(size, folder), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace overfly
