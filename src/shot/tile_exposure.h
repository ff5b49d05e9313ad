#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "film/film_frame.h"
#include "shot/expose_piece.h"
#include "shot/light_deposits.h"
#include "shot/pixel_tile.h"

namespace overfly {

// What the tiles of all frames of a piece share.
struct TilePreparation {
    // Both must outlive it.
    TilePreparation(const Exposing& exposing, const MotionPiece& piece);

    const Exposing* exposing;
    const MotionPiece* piece;
    PreparedSight lines, samples;    // as far as there are such tracers
    std::vector<TimeRange> planned;  // exposures in the piece, asked for or not
    bool is_kinetic = false;         // whether lines are
};

// Exposures that follow each other, through which lines that stand still are followed in one go.
struct Walk {
    std::size_t first = 0, count = 0;
    std::vector<TimeRange> traced;  // the same, after the one at which all such walks set out
};

// The walks for some of the planned exposures of a piece. Where a walk sets out depends on the planned exposures alone:
// what the kinetic tracer says is the same to the bit then, whichever of them are asked for in one go.
[[nodiscard]] std::vector<Walk> walks_through(std::span<const TimeRange> planned, std::span<const TimeRange> exposures);

// Light of lines that stand still, or of samples, for some frames of a piece: those of one walk, where lines are
// followed by the kinetic tracer.
class TileExposure {
  public:
    // All must outlive it. traced: the exposures that lines are followed through.
    TileExposure(const TilePreparation& prepared, std::span<const TimeRange> exposures,
                 std::span<FilmFrame* const> films, std::vector<TimeRange> traced);

    // Different tiles may be run from different threads at once.
    void run(const PixelTile& tile, TraceCounters& counters) const;

  private:
    void follow(const TileSamples& lines, TraceCounters& counters) const;
    void follow_ground(const TileSamples& lines, const SurfaceSegmentLists& lists) const;
    template <class WithExposure>
    void for_each_exposure_of(const TileSamples& lines, const WithExposure& with_exposure) const;
    void sample(const PixelTile& tile, std::span<const TimeRange> sampled, TraceCounters& counters) const;
    void sample(const TileSamples& tiled, std::span<const TimeRange> sampled, std::size_t first,
                TraceCounters& counters) const;
    [[nodiscard]] double phase_by_light(double phase, TimeRange part, TimeRange of) const;
    [[nodiscard]] double share_of(TimeRange part, TimeRange exposure) const;

    const TilePreparation* prepared_;
    const Exposing* exposing_;
    const MotionPiece* piece_;
    std::span<const TimeRange> exposures_;
    std::span<FilmFrame* const> films_;
    std::vector<TimeRange> traced_;
};

}  // namespace overfly
