#include "shot/drift_fields.h"

#include <cstddef>

#include "core/parallel.h"
#include "flight/film_drift.h"
#include "shot/drift_axis.h"

namespace overfly {
namespace {

// In a row. A line that drifts into a field is followed for it alone, so longer ones save work; more of them occupy
// more threads.
constexpr std::size_t kMostTiles = 4;

// From one place to the next at which a tile is looked at; with steps of 4 pixels, or of 2, choices are no better. And
// how far away a change is taken: ground may be drawn out into bands of a pixel.
constexpr int kStep_px = 8, kReach_px = 2;

// Something far enough to stand for the sky.
constexpr double kFar_m = 1e6;

// The piece's middle, and a while before and after it in which speeds are taken.
constexpr double kMiddle = 0.5, kWhile = 0.01;

class MiddleOfPiece {
  public:
    MiddleOfPiece(const Exposing& exposing, const MotionPiece& piece)
        : exposing_(&exposing), piece_(&piece), eye_(piece.origin_at(kMiddle)) {
        const std::vector<TimeRange> planned = planned_exposures(exposing, piece);
        for (const TimeRange& e : planned)
            exposure_u_ += e.duration_s() / piece.when.duration_s() / static_cast<double>(planned.size());
    }

    [[nodiscard]] DriftAxis axis(const PixelTile& tile) const {
        DriftAxisChoice choice(exposing_->tracers.drift_px);
        for (int y = tile.top + kStep_px / 2; y < tile.bottom; y += kStep_px) {
            for (int x = tile.left + kStep_px / 2; x < tile.right; x += kStep_px) choice.add(change(x, y));
        }
        return choice.best();
    }

  private:
    [[nodiscard]] PictureChange change(int x_px, int y_px) const {
        const Look here = look(x_px, y_px), right = look(x_px + kReach_px, y_px), down = look(x_px, y_px + kReach_px);
        PictureChange out = {(right.light - here.light) / kReach_px, (down.light - here.light) / kReach_px};
        const FilmPoint begin = film_point(*piece_, kMiddle - kWhile, here.at);
        const FilmPoint end = film_point(*piece_, kMiddle + kWhile, here.at);
        if (begin.depth_m <= 0.0 || end.depth_m <= 0.0) return out;
        const double px_per_film = exposure_u_ / (2.0 * kWhile) / exposing_->size.film_per_px();
        out.motion_right_px = (end.x - begin.x) * px_per_film;
        out.motion_down_px = (end.y - begin.y) * px_per_film;
        return out;
    }

    struct Look {
        double light = 0.0;
        Point<Scene> at;
    };
    [[nodiscard]] Look look(int x_px, int y_px) const {
        const double x = exposing_->size.film_x(x_px), y = exposing_->size.film_y(y_px);
        const Vector<Scene> direction = piece_->direction_at(kMiddle, x, y);
        const auto hit = exposing_->tracers.ground->first_hit(eye_, direction);
        SurfaceSegment seen;
        if (hit) seen.triangle = hit->triangle;
        const SceneShader::Sighting sighting = {x, y, hit ? &seen : nullptr, {}};
        const Rgb light = exposing_->shader.radiance(*piece_, {sighting, piece_->when.centre_s()}).colour;
        return {static_cast<double>(light.r + light.g + light.b), eye_ + (hit ? hit->distance : kFar_m) * direction};
    }

    const Exposing* exposing_;
    const MotionPiece* piece_;
    Point<Scene> eye_;
    double exposure_u_ = 0.0;  // of a planned exposure, on average
};

// The tiles of a picture, each with its axis, while they are joined.
class JoinedTiles {
  public:
    JoinedTiles(const Exposing& exposing, const MotionPiece& piece)
        : tiles_(tiles_of(exposing.size, kDriftTileSide_px)),
          columns_(static_cast<std::size_t>(drift_tiles_along(exposing.size.width))),
          most_(exposing.tracers.error > 0.0 ? 1 : kMostTiles),
          axes_(tiles_.size(), DriftAxis::Y),
          is_open_(tiles_.size(), 1) {
        const MiddleOfPiece middle(exposing, piece);
        parallel_for(tiles_.size(), [&](std::size_t t) {
            is_open_[t] = !exposing.wanted || exposing.wanted(tiles_[t].left, tiles_[t].top) ? 1 : 0;
            if (is_open_[t] != 0) axes_[t] = middle.axis(tiles_[t]);
        });
    }

    [[nodiscard]] std::vector<DriftField> fields() {
        std::vector<DriftField> out;
        for (std::size_t t = 0; t < tiles_.size(); ++t) {
            if (is_open_[t] != 0) out.push_back(field_from(t));
        }
        return out;
    }

  private:
    // As far to the right, or down, as it goes.
    [[nodiscard]] DriftField field_from(std::size_t first) {
        const DriftAxis axis = axes_[first];
        const bool is_x = axis == DriftAxis::X;
        const std::size_t step = is_x ? 1 : columns_;
        const std::size_t end = is_x ? (first / columns_ + 1) * columns_ : tiles_.size();
        DriftField field = {tiles_[first], axis};
        std::size_t count = 0;
        for (std::size_t t = first; t < end && count < most_ && is_open_[t] != 0 && axes_[t] == axis; t += step) {
            field.pixels.right = tiles_[t].right;
            field.pixels.bottom = tiles_[t].bottom;
            is_open_[t] = 0;
            ++count;
        }
        return field;
    }

    std::vector<PixelTile> tiles_;  // row by row
    std::size_t columns_, most_;
    std::vector<DriftAxis> axes_;
    std::vector<char> is_open_;  // wanted, and in no field yet
};

}  // namespace

std::vector<DriftField> drift_fields(const Exposing& exposing, const MotionPiece& piece) {
    return JoinedTiles(exposing, piece).fields();
}

}  // namespace overfly
