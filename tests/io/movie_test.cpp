#include "io/movie.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/display.h"
#include "io/frame_file.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

std::vector<std::filesystem::path> sequence(const TemporaryFolder& folder, int count, int width, int height) {
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < count; ++i) {
        Frame frame = sample_frame(width, height);
        const float level = 0.1F * static_cast<float>(i + 1);
        for (auto& rgba : frame.rgba) rgba = {level, 0.5F * level, 0.2F, 1.0F};
        files.push_back(folder / (std::to_string(i) + ".exr"));
        write_frame(files.back(), frame, sample_header());
    }
    return files;
}

std::string output_of(const std::string& command) {
    const auto close = [](std::FILE* pipe) { pclose(pipe); };
    const std::unique_ptr<std::FILE, decltype(close)> pipe(popen(command.c_str(), "r"), close);
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
        text.append(buffer.data(), count);
    }
    return text;
}

TEST(Movie, HasTheRateTheSizeAndEveryFrame) {
    const TemporaryFolder folder;
    write_movie(folder / "it's a film.mp4", sequence(folder, 5, 63, 35), {24000, 1001});
    const std::string seen = output_of(
        "ffprobe -v error -count_frames -select_streams v:0 -of default=noprint_wrappers=1:nokey=1 "
        "-show_entries stream=codec_name,width,height,pix_fmt,color_space,r_frame_rate,nb_read_frames \"" +
        (folder / "it's a film.mp4").string() + "\"");
    EXPECT_EQ(seen, "h264\n64\n36\nyuv420p\nbt709\n24000/1001\n5\n");
    EXPECT_EQ(folder.file_count(), 6U);
}

TEST(Movie, ShowsTheColoursOfTheFrames) {
    const TemporaryFolder folder;
    const auto frames = sequence(folder, 6, 64, 36);
    write_movie(folder / "film.mp4", frames, {24, 1});
    const std::string decoded = output_of("ffmpeg -v error -i \"" + (folder / "film.mp4").string() +
                                          "\" -f rawvideo -pix_fmt rgb24 -vf scale=in_color_matrix=bt709 -");
    constexpr std::size_t kFrameBytes = 3U * 64U * 36U;
    ASSERT_EQ(decoded.size(), 6 * kFrameBytes);
    for (std::size_t i = 0; i < 6; ++i) {
        const DisplayImage shown = display_image(read_frame(frames[i]));
        for (std::size_t c = 0; c < 3; ++c) {
            // 8 bits, limited range and a lossy coder: 4 levels of 255.
            EXPECT_NEAR(static_cast<unsigned char>(decoded[i * kFrameBytes + 3000 + c]), shown.rgb[3000 + c], 4) << i;
        }
    }
}

TEST(Movie, TellsItsProgress) {
    const TemporaryFolder folder;
    std::vector<double> done;
    write_movie(folder / "film.mp4", sequence(folder, 3, 32, 18), {24, 1},
                [&](std::string_view, double now, double total) {
                    if (done.empty() || done.back() != now) done.push_back(now);  // again while ffmpeg lets us wait
                    EXPECT_EQ(total, 3.0);
                });
    if (done.front() == 0.0) done.erase(done.begin());
    EXPECT_EQ(done, (std::vector<double>{1.0, 2.0, 3.0}));
}

std::string complaint(const std::filesystem::path& movie, const std::vector<std::filesystem::path>& frames) {
    try {
        write_movie(movie, frames, {24, 1});
        return "none";
    } catch (const UserError& e) {
        return e.what();
    }
}

TEST(Movie, SaysWhatIsWrongAndLeavesNothing) {
    const TemporaryFolder folder;
    auto frames = sequence(folder, 2, 32, 18);
    EXPECT_NE(complaint(folder / "missing/film.mp4", frames).find("No such file or directory"), std::string::npos);

    write_frame(folder / "other.exr", sample_frame(40, 18), sample_header());
    frames.push_back(folder / "other.exr");
    EXPECT_EQ(complaint(folder / "film.mp4", frames),
              (folder / "other.exr").string() + ": has another size than the first frame of its movie");
    frames.back() = folder / "missing.exr";
    EXPECT_EQ(complaint(folder / "film.mp4", frames), (folder / "missing.exr").string() + ": no such frame");
    EXPECT_EQ(folder.file_count(), 3U);
}

TEST(Movie, LeavesNothingWhenItIsStopped) {
    const TemporaryFolder folder;
    struct Stopped {};
    EXPECT_THROW(write_movie(folder / "film.mp4", sequence(folder, 3, 32, 18), {24, 1},
                             [](std::string_view, double now, double) {
                                 if (now == 2.0) throw Stopped();
                             }),
                 Stopped);
    EXPECT_EQ(folder.file_count(), 3U);
}

TEST(MovieDeathTest, NamesThePackageWhenFfmpegIsNotInstalled) {
    const TemporaryFolder folder;
    const auto frames = sequence(folder, 1, 32, 18);
    const auto without_programs = [&] {
        setenv("PATH", folder.path().c_str(), 1);
        std::fputs(complaint(folder / "film.mp4", frames).c_str(), stderr);
        std::_Exit(3);
    };
    EXPECT_EXIT(without_programs(), testing::ExitedWithCode(3), "apt-get install ffmpeg");
}

}  // namespace
}  // namespace overfly
