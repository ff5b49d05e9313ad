#include "shot/drift_exposure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "film/frame_error.h"
#include "film/integrate.h"
#include "shot/drifting_sight.h"
#include "shot/light_deposits.h"
#include "shot/line_deposits.h"
#include "shot/run_shares.h"

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

// Exposures as long as each other, but for rounding.
constexpr double kAsLong = 1e-9;

// What lines may drift in a piece. Farther, the drift is no longer the motion that it is taken for (film_drift.h), and
// most of what is prepared for the piece is never passed.
constexpr double kFarthest_px = 320.0;

// The first of all planned exposures that are in the piece, whichever are asked for.
double planned_exposure_s(const Exposing& exposing, const MotionPiece& piece) {
    const auto planned =
        std::ranges::find_if(exposing.planned, [&](const PlannedFrame& f) { return is_exposed_in(f, piece); });
    check(planned != exposing.planned.end(), "what is exposed was planned");
    return planned->exposure.duration_s();
}

}  // namespace

bool are_swept_together(const Exposing& exposing, const MotionPiece& piece) {
    const double exposure_s = planned_exposure_s(exposing, piece);
    if (exposure_s == 0.0) return false;
    if (exposing.tracers.drift_px * piece.when.duration_s() > kFarthest_px * exposure_s) return false;
    return std::ranges::all_of(exposing.planned, [&](const PlannedFrame& f) {
        return !is_exposed_in(f, piece) || std::abs(f.exposure.duration_s() - exposure_s) <= kAsLong * exposure_s;
    });
}

// What is traced where the drift is along one axis.
struct DriftExposure::View {
    View(const Exposing& exposing, const Sight& seen, TimeRange over, double rate_px_per_s, DriftAxis axis)
        : pattern{exposing.size, axis, exposing.tracers.lines},
          px_per_s(rate_px_per_s),
          sight(drifting(seen, over, drift_of(exposing.size, over))),
          tracer(exposing.tracers.continuous->surfaces(), sight),
          prepared(tracer.prepare(over, film_bounds(over, exposing.tracers.drift_px, exposing.margin_px()))) {}
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
    [[nodiscard]] FilmBounds film_bounds(TimeRange over, double drift_px, double margin_px) const {
        FilmBounds b = pattern.size.film_bounds(margin_px);
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
          film_width_(view.pattern.size.width),
          weighing_(whole.curve_, whole.exposing_->filter) {
        const bool is_x = view.pattern.axis == DriftAxis::X;
        rows_ = is_x ? Stretch{tile.top, tile.bottom} : Stretch{tile.left, tile.right};
        along_ = is_x ? Stretch{tile.left, tile.right} : Stretch{tile.top, tile.bottom};
        from_px_ = along_.begin - whole.exposing_->margin_px();
        to_px_ = along_.end + whole.exposing_->margin_px();
        margin_rows_ = static_cast<int>(std::ceil(whole.exposing_->margin_px()));
    }

    void expose(std::size_t exposure) {
        exposure_ = whole_->exposures_[exposure];
        weighed_ = {exposure_, whole_->curve_};
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

    // All lines of the pattern that are in the tile at any time of the exposure, or so near that it gets light of them.
    void sweep() {
        const TimeRange e = exposure_;
        const double reach_px = 0.5 * view_->px_per_s * e.duration_s();
        const double end_px = to_px_ + reach_px;
        for (double from = from_px_ - reach_px; from < end_px; from += kBlockSide_px) {
            const double to = std::min(from + kBlockSide_px, end_px);
            // The time that any of them is in the tile.
            const TimeRange in_tile = {e.centre_s() + (from_px_ - to) / view_->px_per_s,
                                       e.centre_s() + (to_px_ - from) / view_->px_per_s};
            const TimeRange open = intersection(intersection(e, view_->when()), in_tile);
            if (open.duration_s() <= kLeastShare * e.duration_s()) continue;
            const int end_row = rows_.end + margin_rows_;
            for (int row = rows_.begin - margin_rows_; row < end_row; row += kBlockSide_px)
                follow({row, std::min(row + kBlockSide_px, end_row), from, to}, open);
        }
    }

    // Twice as many lines again and again: half of them are always other ones than the half before, so the difference
    // of the two pictures tells the error of their mean. Where only a part of the exposure is in this piece, the error
    // allowed is that part's share, as errors of parts add up that know nothing of each other.
    void sweep_until_good() {
        FilmFrame* const whole_film = film_;
        const TimeRange open = intersection(exposure_, view_->when());
        const double share = open.duration_s() > 0.0 ? weighed_.share_of(open) : 0.0;
        const double allowed = whole_->exposing_->tracers.error * std::sqrt(share);
        // A film that counts its weights is developed to a whole exposure.
        const float weight = whole_->exposing_->filter != nullptr ? static_cast<float>(share) : 1.0F;
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
                                weight, {{r, g, b}, a, mean.depth_m[i]});
            }
        }
    }

    // A picture of the tile alone, by lines that no other has been made of.
    Frame sweep_apart(int lines) {
        const bool is_x = pattern_.axis == DriftAxis::X;
        const int across = rows_.end - rows_.begin, along = along_.end - along_.begin;
        FilmFrame film = whole_->exposing_->film_of(is_x ? along : across, is_x ? across : along);
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
                const PixelRun to = weighing_.is_even() ? passed_by(lines_[i], stretch) : weighed(lines_[i], stretch);
                if (sighting.is_of_ground()) return lines.add_ground(sighting, stretch, to);
                if (seen == nullptr && lines.add_sky(sighting, stretch, to)) return;
                if (to.shares == nullptr) return look_often(lines_[i], sighting, stretch, looks);
                look_by_cells(lines_[i], sighting, stretch, *to.shares, looks);
            });
        }
    }

    [[nodiscard]] TimeRange time_in_tile(const DriftingLine& line) const {
        const double s_per_px = 1.0 / view_->px_per_s;
        const double centre_s = exposure_.centre_s();
        return {centre_s + (from_px_ - line.home_px) * s_per_px, centre_s + (to_px_ - line.home_px) * s_per_px};
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

    // What the tile's pixels get of the line meanwhile, until the next call.
    [[nodiscard]] PixelRun weighed(const DriftingLine& line, TimeRange stretch) {
        const bool is_x = view_->pattern.axis == DriftAxis::X;
        const double length_px = view_->px_per_s * stretch.duration_s();
        return {.count = static_cast<int>(std::ceil(length_px)) + 1,
                .shares = &weighing_.of({
                    .from_px = line.home_px + view_->px_per_s * (stretch.begin_s - exposure_.centre_s()),
                    .length_px = length_px,
                    .across_px = line.row + line.across_px,
                    .from_part = weighed_.part_at(stretch.begin_s),
                    .to_part = weighed_.part_at(stretch.end_s),
                    .weight = 1.0 / pattern_.per_pixel,
                    .first = along_.begin,
                    .end = along_.end,
                    .first_row = rows_.begin,
                    .end_row = rows_.end,
                    .first_pixel = static_cast<std::uint32_t>(pixel(rows_.begin, along_.begin)),
                    .stride = is_x ? 1 : film_width_,
                    .row_stride = is_x ? film_width_ : 1,
                })};
    }

    // Two looks for each cell, at other places for each line: as below.
    static void look_by_cells(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                              const RunShares& to, LightDeposits& deposits) {
        double begin_v = 0.0;
        std::size_t begin = 0;
        for (const RunShares::Cell& cell : to.cells) {
            const auto end_v = static_cast<double>(cell.end_v);
            for (const double half : {0.0, 0.5}) {
                const double v = begin_v + (half + 0.5 * line.phase) * (end_v - begin_v);
                deposits.look({sighting, stretch.begin_s + v * stretch.duration_s()});
                for (std::size_t k = begin; k < cell.end_share; ++k) {
                    const RunShares::Share& share = to.shares[k];
                    for (const RunShares::Row& row : to.rows) {
                        const double weight = 0.5 * static_cast<double>(row.weight * share.whole);
                        deposits.to(0, share.pixel + static_cast<std::uint32_t>(row.offset), weight,
                                    share.is_inside && row.is_inside);
                    }
                }
            }
            begin_v = end_v;
            begin = cell.end_share;
        }
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
    double from_px_ = 0.0, to_px_ = 0.0;  // along_, and as far around as pixels look
    int margin_rows_ = 0;                 // as far around rows_
    TimeRange exposure_;
    Exposure weighed_;
    FilmFrame* film_ = nullptr;  // with this pixel of the picture first, and so wide
    int film_left_ = 0, film_top_ = 0, film_width_;
    RunWeighing weighing_;
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
    const Sight& seen = exposing.tracers.continuous->sight();
    if (are_swept_together(exposing, piece)) {
        curve_ = exposing.curve;
        prepare(seen, piece.when, planned_exposure_s(exposing, piece));
        return;
    }
    TimeRange& exposure = exposures_.front();
    if (exposure.duration_s() == 0.0) {
        const double time_s = exposure.begin_s;
        exposure = {time_s - 0.5 * kSweep_s, time_s + 0.5 * kSweep_s};
        prepare(standing_still(seen, time_s, exposure), exposure, kSweep_s);
        return;
    }
    curve_ = exposing.curve;
    const TimeRange open = intersection(exposure, piece.when);
    if (open.duration_s() > kLeastShare * exposure.duration_s())
        prepare(during(seen, open), open, exposure.duration_s());
}

void DriftExposure::prepare(const Sight& sight, TimeRange over, double exposure_s) {
    for (const DriftAxis axis : {DriftAxis::X, DriftAxis::Y}) {
        if (std::ranges::find(axes_, axis) == axes_.end()) continue;
        views_[static_cast<std::size_t>(axis)] =
            std::make_unique<View>(*exposing_, sight, over, exposing_->tracers.drift_px / exposure_s, axis);
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
        if (views_[static_cast<std::size_t>(axes_[t])] == nullptr) continue;
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
