#include "shot/drift_pixels.h"

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

// Two looks for each cell, at other places for each line.
void look_by_cells(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                   const RunShares& to, LightDeposits& looks) {
    double begin_v = 0.0;
    std::size_t begin = 0;
    for (const RunShares::Cell& cell : to.cells) {
        const auto end_v = static_cast<double>(cell.end_v);
        for (const double half : {0.0, 0.5}) {
            const double v = begin_v + (half + 0.5 * line.phase()) * (end_v - begin_v);
            looks.look({sighting, stretch.begin_s + v * stretch.duration_s()});
            for (std::size_t k = begin; k < cell.end_share; ++k) {
                const RunShares::Share& share = to.shares[k];
                for (const RunShares::Row& row : to.rows) {
                    const double weight = 0.5 * static_cast<double>(row.weight * share.whole);
                    looks.to(0, share.pixel + static_cast<std::uint32_t>(row.offset), weight,
                             share.is_inside && row.is_inside);
                }
            }
        }
        begin_v = end_v;
        begin = cell.end_share;
    }
}

}  // namespace

DriftPixels::DriftPixels(const PixelTile& tile, DriftAxis axis, double px_per_s, double margin_px,
                         const RunWeighing& weighing)
    : is_x_(axis == DriftAxis::X),
      px_per_s_(px_per_s),
      rows_(is_x_ ? Stretch{tile.top, tile.bottom} : Stretch{tile.left, tile.right}),
      along_(is_x_ ? Stretch{tile.left, tile.right} : Stretch{tile.top, tile.bottom}),
      from_px_(along_.begin - margin_px),
      to_px_(along_.end + margin_px),
      margin_rows_(static_cast<int>(std::ceil(margin_px))),
      weighing_(weighing) {}

void DriftPixels::set_film(int left, int top, int width) {
    film_left_ = left;
    film_top_ = top;
    film_width_ = width;
}

void DriftPixels::set_exposure(const Exposure& exposure, int lines_per_pixel) {
    exposure_ = exposure;
    lines_per_pixel_ = lines_per_pixel;
    weight_per_s_ = 1.0 / (exposure.when.duration_s() * lines_per_pixel);
}

TimeRange DriftPixels::time_near(double first_home_px, double last_home_px) const {
    const double centre_s = exposure_.when.centre_s();
    return {centre_s + (from_px_ - last_home_px) / px_per_s_, centre_s + (to_px_ - first_home_px) / px_per_s_};
}

PixelRun DriftPixels::run_of(const DriftingLine& line, TimeRange stretch) {
    return weighing_.is_even() ? passed_by(line, stretch) : weighed(line, stretch);
}

void DriftPixels::look_often(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                             const PixelRun& to, LightDeposits& looks) const {
    if (to.shares != nullptr) return look_by_cells(line, sighting, stretch, *to.shares, looks);
    look_by_pixels(line, sighting, stretch, looks);
}

// The pixels that the line passes meanwhile.
PixelRun DriftPixels::passed_by(const DriftingLine& line, TimeRange stretch) const {
    const TimeRange e = exposure_.when;
    const double from_px = line.home_px + px_per_s_ * (stretch.begin_s - e.centre_s());
    const double length_px = px_per_s_ * stretch.duration_s();
    // Left of the first pixel rounding is upward, which comes to the same.
    const auto in_tile = [&](double px) { return std::clamp(static_cast<int>(px), along_.begin, along_.end - 1); };
    const int first = in_tile(from_px), last = in_tile(from_px + length_px);
    const double v_per_px = 1.0 / length_px;
    return {.first = static_cast<std::uint32_t>(pixel(line.row, first)),
            .stride = is_x_ ? 1 : film_width_,
            .count = last - first + 1,
            .first_end = (first + 1 - from_px) * v_per_px,
            .v_per_pixel = v_per_px,
            .weight = stretch.duration_s() * weight_per_s_};
}

// What the pixels get where some of the run counts for more than other.
PixelRun DriftPixels::weighed(const DriftingLine& line, TimeRange stretch) {
    const double length_px = px_per_s_ * stretch.duration_s();
    return {.count = static_cast<int>(std::ceil(length_px)) + 1,
            .shares = &weighing_.of({
                .from_px = line.home_px + px_per_s_ * (stretch.begin_s - exposure_.when.centre_s()),
                .length_px = length_px,
                .across_px = line.row + line.across_px,
                .from_part = exposure_.part_at(stretch.begin_s),
                .to_part = exposure_.part_at(stretch.end_s),
                .weight = 1.0 / lines_per_pixel_,
                .first = along_.begin,
                .end = along_.end,
                .first_row = rows_.begin,
                .end_row = rows_.end,
                .first_pixel = static_cast<std::uint32_t>(pixel(rows_.begin, along_.begin)),
                .stride = is_x_ ? 1 : film_width_,
                .row_stride = is_x_ ? film_width_ : 1,
            })};
}

// One look for each of the pixels that the line passes meanwhile, or two.
void DriftPixels::look_by_pixels(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                                 LightDeposits& looks) const {
    const TimeRange e = exposure_.when;
    const double s_per_px = 1.0 / px_per_s_;
    const auto at_px = [&](double t) { return line.home_px + px_per_s_ * (t - e.centre_s()); };
    const auto time_at = [&](int px) { return e.centre_s() + (px - line.home_px) * s_per_px; };
    const int first = std::max(static_cast<int>(std::floor(at_px(stretch.begin_s))), along_.begin);
    const int last = std::min(static_cast<int>(std::floor(at_px(stretch.end_s))), along_.end - 1);
    for (int px = first; px <= last; ++px) {
        const TimeRange in_pixel = intersection(stretch, {time_at(px), time_at(px + 1)});
        if (in_pixel.duration_s() <= 0.0) continue;
        const double share = in_pixel.duration_s() * weight_per_s_;
        if (sighting.seen != nullptr) {
            looks.add(0, pixel(line.row, px), share, {sighting, in_pixel.centre_s()});
            continue;
        }
        // Where the round Earth ends before the sky no triangle does: this edge is found by looking, at another place
        // for each line.
        for (const double half : {0.0, 0.5}) {
            const double time_s = in_pixel.begin_s + (half + 0.5 * line.phase()) * in_pixel.duration_s();
            looks.add(0, pixel(line.row, px), 0.5 * share, {sighting, time_s});
        }
    }
}

std::size_t DriftPixels::pixel(int row, int along) const {
    const int x = (is_x_ ? along : row) - film_left_, y = (is_x_ ? row : along) - film_top_;
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(film_width_) + static_cast<std::size_t>(x);
}

}  // namespace overfly
