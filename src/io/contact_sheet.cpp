#include "io/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/digits.h"
#include "io/frame_file.h"
#include "io/png_file.h"

namespace overfly {
namespace {

constexpr int kGap_px = 4;              // around and between thumbnails
constexpr std::uint8_t kPaper = 32;     // a dark grey
constexpr int kThumbnailsPerDot = 160;  // a dot of the frame number is this part of a thumbnail's width

std::vector<NumberedFrame> evenly_spread(std::span<const NumberedFrame> frames, int most) {
    const auto wanted = std::min(frames.size(), static_cast<std::size_t>(most));
    std::vector<NumberedFrame> chosen;
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t last_step = std::max<std::size_t>(wanted - 1, 1);
        chosen.push_back(frames[(i * (frames.size() - 1) + last_step / 2) / last_step]);
    }
    return chosen;
}

// Averaged in linear light, where an average is what an eye or a lens would see.
Frame resized(const Frame& frame, int width) {
    const double scale = static_cast<double>(width) / frame.width;
    const int height = std::max(1, static_cast<int>(std::lround(scale * frame.height)));
    Frame small;
    small.width = width;
    small.height = height;
    small.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    // OpenImageIO wraps our pixels without a copy; its parameter is not const, but a source is only read.
    auto* pixels = const_cast<std::array<float, 4>*>(frame.rgba.data());
    const OIIO::ImageBuf source(OIIO::ImageSpec(frame.width, frame.height, 4, OIIO::TypeDesc::FLOAT), pixels);
    OIIO::ImageBuf target(OIIO::ImageSpec(width, height, 4, OIIO::TypeDesc::FLOAT), small.rgba.data());
    constexpr int kOneThread = 1;  // thumbnails are made in parallel
    check(OIIO::ImageBufAlgo::resize(target, source, "", 0.0F, OIIO::ROI(), kOneThread), "a frame can be resized");
    return small;
}

void paste(DisplayImage& sheet, const DisplayImage& thumbnail, int left, int top) {
    const int rows = std::min(thumbnail.height, sheet.height - top);
    for (int y = 0; y < rows; ++y) {
        const auto row = thumbnail.rgb.begin() + static_cast<std::ptrdiff_t>(thumbnail.index(0, y));
        std::copy_n(row, 3 * thumbnail.width,
                    sheet.rgb.begin() + static_cast<std::ptrdiff_t>(sheet.index(left, top + y)));
    }
}

}  // namespace

DisplayImage contact_sheet(std::span<const NumberedFrame> frames, const ContactSheetOptions& options) {
    check(!frames.empty(), "a contact sheet has frames");
    check(options.columns > 0 && options.most_thumbnails > 0 && options.thumbnail_width_px > 0,
          "a contact sheet's options are positive");
    const std::vector<NumberedFrame> chosen = evenly_spread(frames, options.most_thumbnails);
    std::vector<DisplayImage> thumbnails(chosen.size());
    parallel_for(chosen.size(), [&](std::size_t i) {
        thumbnails[i] = display_image(resized(read_frame(chosen[i].file), options.thumbnail_width_px));
        const int dot_px = std::max(1, options.thumbnail_width_px / kThumbnailsPerDot);
        draw_number(thumbnails[i], chosen[i].number, 0, thumbnails[i].height, dot_px);
    });

    const int count = static_cast<int>(thumbnails.size());
    const int columns = std::min(options.columns, count);
    const int rows = (count + columns - 1) / columns;
    const int step_x = options.thumbnail_width_px + kGap_px;
    const int step_y = std::ranges::max(thumbnails, {}, &DisplayImage::height).height + kGap_px;
    DisplayImage sheet{.width = columns * step_x + kGap_px, .height = rows * step_y + kGap_px};
    sheet.rgb.assign(sheet.index(0, sheet.height), kPaper);
    for (int i = 0; i < count; ++i) {
        paste(sheet, thumbnails[static_cast<std::size_t>(i)], kGap_px + i % columns * step_x,
              kGap_px + i / columns * step_y);
    }
    return sheet;
}

void write_contact_sheet(const std::filesystem::path& file, std::span<const NumberedFrame> frames,
                         const ContactSheetOptions& options) {
    write_png(file, contact_sheet(frames, options));
}

}  // namespace overfly
