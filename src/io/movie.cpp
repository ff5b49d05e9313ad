#include "io/movie.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/burn_in.h"
#include "io/display.h"
#include "io/encoder_process.h"
#include "io/frame_file.h"
#include "io/temporary_file.h"

namespace overfly {
namespace {

// H.264 with colour at half the resolution, which is what every player can show, needs even sizes.
DisplayImage even_sized(DisplayImage image) {
    const auto row_bytes = std::ptrdiff_t{3} * image.width;
    if (image.width % 2 == 1) {
        std::vector<std::uint8_t> wider;
        for (auto row = image.rgb.begin(); row != image.rgb.end(); row += row_bytes) {
            wider.insert(wider.end(), row, row + row_bytes);
            wider.insert(wider.end(), row + row_bytes - 3, row + row_bytes);
        }
        image.rgb = std::move(wider);
        ++image.width;
    }
    if (image.height % 2 == 1) {
        const std::vector<std::uint8_t> last_row(image.rgb.end() - 3 * image.width, image.rgb.end());
        image.rgb.insert(image.rgb.end(), last_row.begin(), last_row.end());
        ++image.height;
    }
    return image;
}

constexpr int kDotsAcross = 480;  // a dot of what is burnt in is this part of a picture's width

DisplayImage movie_picture(const std::filesystem::path& frame, const PreviewLook& look) {
    DisplayImage image = display_image(read_frame(frame), look.view);
    burn_in(image, burn_in_lines(look.burn_in, frame), std::max(1, image.width / kDotsAcross));
    return even_sized(std::move(image));
}

std::vector<std::string> ffmpeg_arguments(const DisplayImage& first, FrameRate rate, const std::string& remark,
                                          const std::filesystem::path& output) {
    // Without -xerror ffmpeg takes a disk that is full at the end of the file for a success.
    return {"ffmpeg", "-nostdin", "-loglevel", "error", "-xerror", "-y",
            // what comes in
            "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", first.width, first.height),
            "-framerate", fmt::format("{}/{}", rate.numerator, rate.denominator), "-i", "pipe:0",
            // Rec. 709 is what players assume for pictures of this kind; ffmpeg's own default is the older Rec. 601.
            "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-colorspace", "bt709", "-color_primaries", "bt709",
            "-color_trc", "iec61966-2-1", "-color_range", "tv",
            // what goes out
            "-c:v", "libx264", "-preset", "medium", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart",
            "-metadata", "comment=" + remark, "-f", "mp4", "file:" + output.string()};
}

// Reads and develops some frames at a time in parallel, and hands them to `use` in order.
template <class Use>
void for_each_picture(std::span<const std::filesystem::path> frames, const PreviewLook& look, const Use& use) {
    const auto batch_size = static_cast<std::size_t>(thread_limit());
    for (std::size_t begin = 0; begin < frames.size(); begin += batch_size) {
        std::vector<DisplayImage> pictures(std::min(batch_size, frames.size() - begin));
        parallel_for(pictures.size(), [&](std::size_t i) { pictures[i] = movie_picture(frames[begin + i], look); });
        for (std::size_t i = 0; i < pictures.size(); ++i) use(begin + i, pictures[i]);
    }
}

}  // namespace

void write_movie(const std::filesystem::path& file, std::span<const std::filesystem::path> frames, FrameRate rate,
                 const Progress& progress, const PreviewLook& look) {
    check(!frames.empty(), "a movie has frames");
    const DisplayImage first = movie_picture(frames.front(), look);
    TemporaryFile temporary(file);
    std::size_t done = 0;
    const auto tell = [&] {
        if (progress) progress("movie", static_cast<double>(done), static_cast<double>(frames.size()));
    };
    const auto encoder = EncoderProcess::start(ffmpeg_arguments(first, rate, look.remark(), temporary.path()), tell);
    if (!encoder) {
        throw UserError(Place{file},
                        "needs the program ffmpeg, which is not installed (Debian: apt-get install ffmpeg)");
    }
    bool reads = true;
    for_each_picture(frames, look, [&](std::size_t i, const DisplayImage& picture) {
        if (picture.width != first.width || picture.height != first.height) {
            throw UserError(Place{frames[i]}, "has another size than the first frame of its movie");
        }
        reads = reads && encoder->write(picture.rgb);
        done = i + 1;
        tell();
    });
    // The program's status alone does not tell of a reader that stopped early, nor a broken stream of a bad status.
    const bool ended_well = encoder->finish();
    if (!reads || !ended_well) throw UserError(Place{file}, fmt::format("ffmpeg failed: {}", encoder->complaints()));
    temporary.commit();
}

}  // namespace overfly
