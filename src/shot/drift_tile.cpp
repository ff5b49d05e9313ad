#include "shot/drift_tile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "film/frame_error.h"
#include "film/integrate.h"

namespace overfly {
namespace {

constexpr int kBlockSide_px = 16;  // of lines that are traced in one go

// Of an error that can't be reached, and is far below what anyone sees.
constexpr int kMostLines = 64;

}  // namespace

DriftTile::DriftTile(const Exposing& exposing, const PixelTile& tile, const DriftView& view, const ShutterCurve& curve,
                     TraceCounters& counters)
    : exposing_(&exposing),
      view_(&view),
      counters_(&counters),
      tile_(tile),
      pattern_(view.pattern),
      curve_(curve),
      pixels_(tile, view.pattern.axis, view.px_per_s, exposing.margin_px(), RunWeighing(curve, exposing.filter)) {}

void DriftTile::expose(TimeRange exposure, FilmFrame& film) {
    film_ = &film;
    pixels_.set_exposure({exposure, curve_}, pattern_.per_pixel);
    pixels_.set_film(0, 0, view_->pattern.size.width);
    if (exposing_->tracers.error > 0.0) {
        sweep_until_good();
    } else {
        sweep();
    }
}

// All lines of the pattern that are in the tile at any time of the exposure, or so near that it gets light of them.
void DriftTile::sweep() {
    const TimeRange e = pixels_.exposure().when;
    const double reach_px = 0.5 * view_->px_per_s * e.duration_s();
    const double end_px = pixels_.end_px() + reach_px;
    const auto [begin_row, end_row] = pixels_.rows_around();
    for (double from = pixels_.begin_px() - reach_px; from < end_px; from += kBlockSide_px) {
        const double to = std::min(from + kBlockSide_px, end_px);
        const TimeRange open = intersection(intersection(e, view_->when()), pixels_.time_near(from, to));
        if (open.duration_s() <= kLeastShare * e.duration_s()) continue;
        for (int row = begin_row; row < end_row; row += kBlockSide_px)
            follow({row, std::min(row + kBlockSide_px, end_row), from, to}, open);
    }
}

// Twice as many lines again and again: half of them are always other ones than the half before, so the difference of
// the two pictures tells the error of their mean. Where only a part of the exposure is in this piece, the error allowed
// is that part's share, as errors of parts add up that know nothing of each other.
void DriftTile::sweep_until_good() {
    FilmFrame* const whole_film = film_;
    const TimeRange open = intersection(pixels_.exposure().when, view_->when());
    const double share = open.duration_s() > 0.0 ? pixels_.exposure().share_of(open) : 0.0;
    const double allowed = exposing_->tracers.error * std::sqrt(share);
    // A film that counts its weights is developed to a whole exposure.
    const float weight = exposing_->filter != nullptr ? static_cast<float>(share) : 1.0F;
    const FrameSteps& steps = whole_film->facts().steps();
    ExposedFrame mean = sweep_apart(1, steps);
    for (int lines = 1; lines < kMostLines; lines *= 2) {
        const ExposedFrame other = sweep_apart(lines, steps);
        const double error = 0.5 * root_mean_square(mean.frame, other.frame);
        mean.join(other);
        if (error <= allowed) break;
    }
    add(mean, weight, *whole_film);
}

void DriftTile::add(const ExposedFrame& apart, float weight, FilmFrame& film) const {
    const Frame& frame = apart.frame;
    const auto width = static_cast<std::size_t>(view_->pattern.size.width);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const std::size_t i = frame.index(x, y);
            const std::size_t pixel =
                static_cast<std::size_t>(tile_.top + y) * width + static_cast<std::size_t>(tile_.left + x);
            const auto& [r, g, b, a] = frame.rgba[i];
            film.add(pixel, weight, {{r, g, b}, a, frame.depth_m[i]});
            if (film.has_facts()) film.facts().add_from(apart.facts, i, pixel, weight);
        }
    }
}

// A picture of the tile alone, by lines that no other has been made of.
ExposedFrame DriftTile::sweep_apart(int lines, const FrameSteps& steps) {
    FilmFrame film = exposing_->film_of(pixels_.width(), pixels_.height(), steps);
    film_ = &film;
    pixels_.set_film(tile_.left, tile_.top, pixels_.width());
    pixels_.set_exposure(pixels_.exposure(), lines);
    pattern_.per_pixel = lines;
    ++pattern_.set;
    sweep();
    return std::move(film).develop();
}

// REQUIRES: open is a part of the exposure.
void DriftTile::follow(const HomeRange& homes, TimeRange open) {
    const double shift_px = view_->px_per_s * (pixels_.exposure().when.centre_s() - view_->when().centre_s());
    lines_ = lines_of(pattern_, homes);
    samples_.clear();
    skies_.clear();
    for (const DriftingLine& line : lines_) samples_.push_back(sample_of(pattern_, line, shift_px));
    lists_.clear();
    view_->tracer.trace(view_->prepared, samples_, {&open, 1}, lists_, *counters_);
    LineDeposits lines(exposing_->shader, view_->camera(), {&film_, 1}, pattern_.per_pixel);
    LightDeposits looks(exposing_->shader, view_->camera(), {&film_, 1}, pattern_.per_pixel);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const DriftingLine& line = lines_[i];
        const TimeRange near = intersection(open, pixels_.time_near(line.home_px, line.home_px));
        if (near.duration_s() <= 0.0) continue;
        for_each_stretch(lists_.of(i), near, [&](const SurfaceSegment* seen, TimeRange stretch) {
            const SceneShader::Sighting sighted = sighting(i, seen);
            const PixelRun to = pixels_.run_of(line, stretch);
            if (sighted.is_of_ground()) return lines.add_ground(sighted, stretch, to);
            if (seen != nullptr) return pixels_.look_often(line, sighted, stretch, to, looks);
            lines.add_sky(sighted, stretch, to);
            skies_.push_back({i, stretch});
        });
    }
    lines.flush();
    for (const std::size_t k : lines.left_over()) {
        const auto& [i, when] = skies_[k];
        pixels_.look_often(lines_[i], sighting(i, nullptr), when, pixels_.run_of(lines_[i], when), looks);
    }
}

SceneShader::Sighting DriftTile::sighting(std::size_t line, const SurfaceSegment* seen) const {
    return {samples_[line].x, samples_[line].y, seen, lists_.reflected};
}

}  // namespace overfly
