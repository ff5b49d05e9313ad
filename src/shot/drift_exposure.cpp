#include "shot/drift_exposure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "film/frame_error.h"
#include "film/integrate.h"
#include "shot/drifting_sight.h"
#include "shot/light_deposits.h"
#include "shot/line_deposits.h"

namespace overfly {
namespace {

constexpr int kBlockSide_px = 16;  // of lines that are traced in one go

// Something far enough to stand for the sky.
constexpr double kFar_m = 1e6;

// Of an error that can't be reached, and is far below what anyone sees.
constexpr int kMostLines = 64;

// A part of an exposure that is no more than rounding, where it ends as a piece begins.
constexpr double kLeastShare = 1e-9;

// A stretched instant.
constexpr double kSweep_s = 1.0;

}  // namespace

// What is traced where the drift is along one axis.
struct DriftExposure::View {
    View(const Exposing& exposing, const Sight& seen, TimeRange over, double rate_px_per_s, DriftAxis axis)
        : pattern{exposing.size, axis, exposing.tracers.lines},
          px_per_s(rate_px_per_s),
          sight(drifting(seen, over, drift_of(exposing.size, over))),
          tracer(exposing.tracers.continuous->surfaces(), sight),
          prepared(tracer.prepare(over, film_bounds(over, exposing.tracers.drift_px))) {}
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    [[nodiscard]] TimeRange when() const { return prepared.when; }
    [[nodiscard]] const MotionPiece& camera() const { return sight.motions.front().piece_at(when().centre_s()); }

    LinePattern pattern;
    double px_per_s;
    Sight sight;
    SightTracer tracer;
    PreparedSight prepared;

  private:
    [[nodiscard]] FilmDrift drift_of(PictureSize size, TimeRange over) const {
        const double rate = px_per_s * size.film_per_px();
        if (pattern.axis == DriftAxis::X) return {rate, 0.0, over.centre_s()};
        return {0.0, rate, over.centre_s()};
    }
    // Where samples are in the middle of `over` that are in the picture at any time of an exposure. Their homes are up
    // to half an exposure's drift outside of it, and the middle of an exposure may be half an exposure before or after
    // `over`.
    [[nodiscard]] FilmBounds film_bounds(TimeRange over, double drift_px) const {
        FilmBounds b = pattern.size.film_bounds();
        const double margin = (0.5 * px_per_s * over.duration_s() + drift_px) * pattern.size.film_per_px();
        (pattern.axis == DriftAxis::X ? b.low_x : b.low_y) -= margin;
        (pattern.axis == DriftAxis::X ? b.high_x : b.high_y) += margin;
        return b;
    }
};

// One tile while it is exposed.
class DriftExposure::Tile {
  public:
    Tile(const DriftExposure& whole, const PixelTile& tile, const View& view, TraceCounters& counters)
        : whole_(&whole),
          view_(&view),
          counters_(&counters),
          pattern_(view.pattern),
          left_(tile.left),
          top_(tile.top),
          film_width_(view.pattern.size.width) {
        const bool is_x = view.pattern.axis == DriftAxis::X;
        rows_ = is_x ? Stretch{tile.top, tile.bottom} : Stretch{tile.left, tile.right};
        along_ = is_x ? Stretch{tile.left, tile.right} : Stretch{tile.top, tile.bottom};
    }

    void expose(std::size_t exposure) {
        exposure_ = whole_->exposures_[exposure];
        film_ = whole_->films_[exposure];
        if (whole_->exposing_->tracers.error > 0.0) {
            sweep_until_good();
        } else {
            sweep();
        }
    }

  private:
    struct Stretch {
        int begin, end;
    };

    // All lines of the pattern that are in the tile at any time of the exposure.
    void sweep() {
        const TimeRange e = exposure_;
        const double reach_px = 0.5 * view_->px_per_s * e.duration_s();
        const double end_px = along_.end + reach_px;
        for (double from = along_.begin - reach_px; from < end_px; from += kBlockSide_px) {
            const double to = std::min(from + kBlockSide_px, end_px);
            // The time that any of them is in the tile.
            const TimeRange in_tile = {e.centre_s() + (along_.begin - to) / view_->px_per_s,
                                       e.centre_s() + (along_.end - from) / view_->px_per_s};
            const TimeRange open = intersection(intersection(e, view_->when()), in_tile);
            if (open.duration_s() <= kLeastShare * e.duration_s()) continue;
            for (int row = rows_.begin; row < rows_.end; row += kBlockSide_px)
                follow({row, std::min(row + kBlockSide_px, rows_.end), from, to}, open);
        }
    }

    // Twice as many lines again and again: half of them are always other ones than the half before, so the difference
    // of the two pictures tells the error of their mean. Where only a part of the exposure is in this piece, the error
    // allowed is that part's share, as errors of parts add up that know nothing of each other.
    void sweep_until_good() {
        FilmFrame* const whole_film = film_;
        const double share = intersection(exposure_, view_->when()).duration_s() / exposure_.duration_s();
        const double allowed = whole_->exposing_->tracers.error * std::sqrt(std::max(share, 0.0));
        Frame mean = sweep_apart(1);
        for (int lines = 1; lines < kMostLines; lines *= 2) {
            const Frame other = sweep_apart(lines);
            const double error = 0.5 * root_mean_square(mean, other);
            for (std::size_t i = 0; i < mean.rgba.size(); ++i) {
                for (std::size_t c = 0; c < 4; ++c) mean.rgba[i][c] = 0.5F * (mean.rgba[i][c] + other.rgba[i][c]);
                mean.depth_m[i] = std::min(mean.depth_m[i], other.depth_m[i]);
            }
            if (error <= allowed) break;
        }
        const int width = view_->pattern.size.width;
        for (int y = 0; y < mean.height; ++y) {
            for (int x = 0; x < mean.width; ++x) {
                const std::size_t i = mean.index(x, y);
                const auto& [r, g, b, a] = mean.rgba[i];
                whole_film->add(static_cast<std::size_t>(top_ + y) * static_cast<std::size_t>(width) +
                                    static_cast<std::size_t>(left_ + x),
                                1.0F, {{r, g, b}, a, mean.depth_m[i]});
            }
        }
    }

    // A picture of the tile alone, by lines that no other has been made of.
    Frame sweep_apart(int lines) {
        const bool is_x = pattern_.axis == DriftAxis::X;
        const int across = rows_.end - rows_.begin, along = along_.end - along_.begin;
        FilmFrame film(is_x ? along : across, is_x ? across : along);
        film_ = &film;
        film_width_ = is_x ? along : across;
        film_left_ = left_;
        film_top_ = top_;
        pattern_.per_pixel = lines;
        ++pattern_.set;
        sweep();
        return std::move(film).develop();
    }

    // REQUIRES: open is a part of the exposure.
    void follow(const HomeRange& homes, TimeRange open) {
        const double shift_px = view_->px_per_s * (exposure_.centre_s() - view_->when().centre_s());
        lines_ = lines_of(pattern_, homes);
        samples_.clear();
        for (const DriftingLine& line : lines_) samples_.push_back(sample_of(pattern_, line, shift_px));
        SurfaceSegmentLists lists;
        view_->tracer.trace(view_->prepared, samples_, {&open, 1}, lists, *counters_);
        const SceneShader& shader = whole_->exposing_->shader;
        LineDeposits lines(shader, view_->camera(), {&film_, 1});
        LightDeposits looks(shader, view_->camera(), {&film_, 1});
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const TimeRange in_tile = intersection(open, time_in_tile(lines_[i]));
            if (in_tile.duration_s() <= 0.0) continue;
            for_each_stretch(lists.of(i), in_tile, [&](const SurfaceSegment* seen, TimeRange stretch) {
                const SceneShader::Sighting sighting = {samples_[i].x, samples_[i].y, seen, lists.reflected};
                const PixelRun to = passed_by(lines_[i], stretch);
                if (sighting.is_of_ground()) return lines.add_ground(sighting, stretch, to);
                if (seen == nullptr && lines.add_sky(sighting, stretch, to)) return;
                look_often(lines_[i], sighting, stretch, looks);
            });
        }
    }

    [[nodiscard]] TimeRange time_in_tile(const DriftingLine& line) const {
        const double s_per_px = 1.0 / view_->px_per_s;
        const double centre_s = exposure_.centre_s();
        return {centre_s + (along_.begin - line.home_px) * s_per_px, centre_s + (along_.end - line.home_px) * s_per_px};
    }

    // The pixels that the line passes meanwhile. REQUIRES: it is in the tile.
    [[nodiscard]] PixelRun passed_by(const DriftingLine& line, TimeRange stretch) const {
        const TimeRange e = exposure_;
        const double from_px = line.home_px + view_->px_per_s * (stretch.begin_s - e.centre_s());
        const double length_px = view_->px_per_s * stretch.duration_s();
        const auto in_tile = [&](double px) {
            return std::clamp(static_cast<int>(std::floor(px)), along_.begin, along_.end - 1);
        };
        const int first = in_tile(from_px), last = in_tile(from_px + length_px);
        const bool is_x = view_->pattern.axis == DriftAxis::X;
        const double v_per_px = 1.0 / length_px;
        return {.first = static_cast<std::uint32_t>(pixel(line.row, first)),
                .stride = is_x ? 1 : film_width_,
                .count = last - first + 1,
                .first_end = (first + 1 - from_px) * v_per_px,
                .v_per_pixel = v_per_px,
                .weight = stretch.duration_s() / (e.duration_s() * pattern_.per_pixel)};
    }

    // One look for each of the pixels that the line passes meanwhile, or two.
    void look_often(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                    LightDeposits& deposits) const {
        const TimeRange e = exposure_;
        const double per_s = view_->px_per_s, s_per_px = 1.0 / per_s;
        const double share_per_s = 1.0 / (e.duration_s() * pattern_.per_pixel);
        const auto at_px = [&](double t) { return line.home_px + per_s * (t - e.centre_s()); };
        const auto time_at = [&](int px) { return e.centre_s() + (px - line.home_px) * s_per_px; };
        const int first = std::max(static_cast<int>(std::floor(at_px(stretch.begin_s))), along_.begin);
        const int last = std::min(static_cast<int>(std::floor(at_px(stretch.end_s))), along_.end - 1);
        for (int px = first; px <= last; ++px) {
            const TimeRange in_pixel = intersection(stretch, {time_at(px), time_at(px + 1)});
            if (in_pixel.duration_s() <= 0.0) continue;
            const double share = in_pixel.duration_s() * share_per_s;
            if (sighting.seen != nullptr) {
                deposits.add(0, pixel(line.row, px), share, {sighting, in_pixel.centre_s()});
                continue;
            }
            // Where the round Earth ends before the sky no triangle does: this edge is found by looking, at another
            // place for each line.
            for (const double half : {0.0, 0.5}) {
                const double time_s = in_pixel.begin_s + (half + 0.5 * line.phase) * in_pixel.duration_s();
                deposits.add(0, pixel(line.row, px), 0.5 * share, {sighting, time_s});
            }
        }
    }

    [[nodiscard]] std::size_t pixel(int row, int along) const {
        const bool is_x = pattern_.axis == DriftAxis::X;
        const int x = (is_x ? along : row) - film_left_, y = (is_x ? row : along) - film_top_;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(film_width_) + static_cast<std::size_t>(x);
    }

    const DriftExposure* whole_;
    const View* view_;
    TraceCounters* counters_;
    LinePattern pattern_;
    int left_, top_;
    Stretch rows_{}, along_{};
    TimeRange exposure_;
    FilmFrame* film_ = nullptr;  // with this pixel of the picture first, and so wide
    int film_left_ = 0, film_top_ = 0, film_width_;
    std::vector<DriftingLine> lines_;
    std::vector<ImageSample> samples_;
};

DriftExposure::DriftExposure(const Exposing& exposing, const MotionPiece& piece, std::span<const TimeRange> exposures,
                             std::span<FilmFrame* const> films)
    : exposing_(&exposing),
      exposures_(exposures.begin(), exposures.end()),
      films_(films),
      tiles_(tiles_of(exposing.size, kDriftTileSide_px)) {
    for (const PixelTile& tile : tiles_) axes_.push_back(axis_for(tile, piece));
    const TracerPair& tracers = exposing.tracers;
    const double exposure_s = exposing.planned.front().exposure.duration_s();
    const bool is_instant = exposure_s == 0.0;
    TimeRange over = piece.when;
    Sight at_rest;
    if (is_instant) {
        const double time_s = exposures_.front().begin_s;
        over = {time_s - 0.5 * kSweep_s, time_s + 0.5 * kSweep_s};
        exposures_.front() = over;
        at_rest = standing_still(tracers.continuous->sight(), time_s, over);
    }
    for (const DriftAxis axis : {DriftAxis::X, DriftAxis::Y}) {
        if (std::ranges::find(axes_, axis) == axes_.end()) continue;
        views_[static_cast<std::size_t>(axis)] =
            std::make_unique<View>(exposing, is_instant ? at_rest : tracers.continuous->sight(), over,
                                   tracers.drift_px / (is_instant ? kSweep_s : exposure_s), axis);
    }
}

DriftExposure::~DriftExposure() = default;

DriftAxis DriftExposure::axis_for(const PixelTile& tile, const MotionPiece& piece) const {
    const double x = exposing_->size.film_x(0.5 * (tile.left + tile.right));
    const double y = exposing_->size.film_y(0.5 * (tile.top + tile.bottom));
    constexpr double kMiddle = 0.5;
    const Vector<Scene> direction = piece.direction_at(kMiddle, x, y);
    const Point<Scene> eye = piece.origin_at(kMiddle);
    const auto hit = exposing_->tracers.ground->first_hit(eye, direction);
    const Point<Scene> seen = eye + (hit ? hit->distance : kFar_m) * direction;
    const FilmPoint begin = film_point(piece, 0.0, seen), end = film_point(piece, 1.0, seen);
    if (begin.depth_m <= 0.0 || end.depth_m <= 0.0) return DriftAxis::X;
    return std::abs(end.y - begin.y) > std::abs(end.x - begin.x) ? DriftAxis::X : DriftAxis::Y;
}

std::vector<DriftExposure::Part> DriftExposure::parts() const {
    std::vector<Part> out;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        if (exposing_->wanted && !exposing_->wanted(tiles_[t].left, tiles_[t].top)) continue;
        for (std::size_t e = 0; e < exposures_.size(); ++e) out.push_back({t, e});
    }
    return out;
}

void DriftExposure::run(const Part& part, TraceCounters& counters) const {
    const View& view = *views_[static_cast<std::size_t>(axes_[part.tile])];
    Tile(*this, tiles_[part.tile], view, counters).expose(part.exposure);
}

}  // namespace overfly
