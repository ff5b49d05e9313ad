#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "film/film_frame.h"
#include "film/pixel_filter.h"
#include "flight/exposure.h"
#include "flight/motion.h"
#include "shot/frame_plan.h"
#include "shot/interrupted.h"
#include "shot/look_facts.h"
#include "shot/pixel_tile.h"
#include "shot/scene_shader.h"
#include "shot/tile_choice.h"

namespace overfly {

class DriftExposure;
struct TilePreparation;

// Which parts of a picture are wanted, by a pixel in them. The same for all pixels of a drift tile (drift_exposure.h).
using WantedTile = std::function<bool(int x, int y)>;

// What exposing film takes.
struct Exposing {
    TracerPair tracers;
    const SceneShader& shader;
    PictureSize size;
    ShouldStop should_stop;
    // All frames of the shot, asked for or not: what the hybrid chooses by, and from which the speed of lines that
    // drift is reckoned, so that both are the same to the bit whichever are asked for.
    std::span<const PlannedFrame> planned{};
    WantedTile wanted{};  // empty: all of the picture
    ShutterCurve curve{};
    const PixelFilter* filter = nullptr;  // none: the box of one pixel

    [[nodiscard]] Exposure exposure(TimeRange when) const { return {when, curve}; }
    [[nodiscard]] double margin_px() const { return filter != nullptr ? filter->margin_px() : 0.0; }
    [[nodiscard]] FilmFrame film(const PlannedFrame& frame) const {
        return film_of(size.width, size.height, steps_of(frame));
    }
    // Of one that nobody has told anything yet.
    [[nodiscard]] std::size_t film_bytes() const {
        return FilmFrame::memory_bytes(size.width, size.height, weights(), kinds());
    }
    // With room for the weights of this filter, and for what the shader's layers are told.
    [[nodiscard]] FilmFrame film_of(int width, int height, const FrameSteps& steps) const {
        return {width, height, weights(), kinds(), steps};
    }
    [[nodiscard]] FrameSteps steps_of(const PlannedFrame& frame) const;
    [[nodiscard]] FilmFrame::Weights weights() const {
        return filter != nullptr ? FilmFrame::Weights::AreCounted : FilmFrame::Weights::AddUp;
    }
    [[nodiscard]] FactKinds kinds() const { return shader.facts() != nullptr ? shader.facts()->kinds : FactKinds(); }
};

// Told after each tile of a piece: which share of it is done.
using PieceProgress = std::function<void(double share)>;

// Traces one piece of the flight. What its frames share is prepared once, however many go by.
class PieceExposure {
  public:
    // Both must outlive it.
    PieceExposure(const Exposing& exposing, const MotionPiece& piece);
    ~PieceExposure();
    PieceExposure(const PieceExposure&) = delete;
    PieceExposure& operator=(const PieceExposure&) = delete;

    // Adds what is seen in the piece to the frames that are exposed meanwhile. frames and films go together, films are
    // exposing.film(frame); frames are among the planned, in time order and without overlap. Quickest where frames of
    // later calls are later ones. Throws Interrupted when asked to stop. GUARANTEES: a film's pixels are the same to
    // the bit whichever other frames are exposed with it, or before it, in whatever tile order.
    void expose(std::span<const PlannedFrame> frames, std::span<FilmFrame* const> films, TraceCounters& counters,
                const PieceProgress& progress = {});

  private:
    const Exposing* exposing_;
    // One of them: lines drift, or they stand still.
    std::unique_ptr<DriftExposure> drifting_;
    std::unique_ptr<TilePreparation> standing_;
};

// All in one go.
void expose_piece(const Exposing& exposing, const MotionPiece& piece, std::span<const PlannedFrame> frames,
                  std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress = {});

// Whether the frame's shutter is open at any time of the piece (its end excluded).
[[nodiscard]] bool is_exposed_in(const PlannedFrame& frame, const MotionPiece& piece);

// The exposures of all planned frames in the piece, whichever are asked for.
[[nodiscard]] std::vector<TimeRange> planned_exposures(const Exposing& exposing, const MotionPiece& piece);

}  // namespace overfly
