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
#include "io/burn_in.h"
#include "io/frame_file.h"
#include "io/png_file.h"

namespace overfly {
namespace {

constexpr int kGap_px = 4;           // around and between thumbnails
constexpr std::uint8_t kPaper = 32;  // a dark grey
constexpr int kDotsAcross = 160;     // a dot of what is written is this part of a thumbnail's width

std::vector<std::filesystem::path> evenly_spread(std::span<const std::filesystem::path> frames, int most) {
    const auto wanted = std::min(frames.size(), static_cast<std::size_t>(most));
    std::vector<std::filesystem::path> chosen;
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

DisplayImage thumbnail(const std::filesystem::path& frame, const ContactSheetOptions& options) {
    const Frame small = resized(read_frame(frame), options.thumbnail_width_px);
    DisplayImage image = display_image(small, options.look.view);
    BurnIn wanted = options.look.burn_in;
    wanted.frame = true;  // in any case
    burn_in(image, burn_in_lines(wanted, frame), std::max(1, options.thumbnail_width_px / kDotsAcross));
    return image;
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

DisplayImage contact_sheet(std::span<const std::filesystem::path> frames, const ContactSheetOptions& options) {
    check(!frames.empty(), "a contact sheet has frames");
    check(options.columns > 0 && options.most_thumbnails > 0 && options.thumbnail_width_px > 0,
          "a contact sheet's options are positive");
    const std::vector<std::filesystem::path> chosen = evenly_spread(frames, options.most_thumbnails);
    std::vector<DisplayImage> thumbnails(chosen.size());
    parallel_for(chosen.size(), [&](std::size_t i) { thumbnails[i] = thumbnail(chosen[i], options); });

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

void write_contact_sheet(const std::filesystem::path& file, std::span<const std::filesystem::path> frames,
                         const ContactSheetOptions& options) {
    write_png(file, contact_sheet(frames, options), options.look.remark());
}

}  // namespace overfly
