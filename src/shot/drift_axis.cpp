#include "shot/drift_axis.h"

#include <cmath>
#include <cstddef>

#include "core/parallel.h"
#include "flight/film_drift.h"

namespace overfly {
namespace {

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

}  // namespace

void DriftAxisChoice::add(const PictureChange& change) {
    const double height = std::hypot(change.right, change.down);
    if (height == 0.0) return;
    const double right = change.right / height, down = change.down / height;
    const double passing = (right * change.motion_right_px + down * change.motion_down_px) / drift_px_;
    const auto error = [&](double along, double across) {
        const double a = std::abs(across), l = std::abs(along - passing);
        return a > 0.0 ? height * height * a * a / (a + l) : 0.0;
    };
    error_x_ += error(right, down);
    error_y_ += error(down, right);
}

std::vector<DriftAxis> drift_axes(const Exposing& exposing, const MotionPiece& piece,
                                  std::span<const PixelTile> tiles) {
    const MiddleOfPiece middle(exposing, piece);
    std::vector<DriftAxis> out(tiles.size(), DriftAxis::Y);
    parallel_for(tiles.size(), [&](std::size_t t) {
        if (!exposing.wanted || exposing.wanted(tiles[t].left, tiles[t].top)) out[t] = middle.axis(tiles[t]);
    });
    return out;
}

}  // namespace overfly
