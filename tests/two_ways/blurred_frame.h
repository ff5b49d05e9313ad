#pragma once

#include <span>
#include <vector>

#include "film/film_frame.h"
#include "film/frame_error.h"
#include "shot/expose_piece.h"
#include "shot/shot_tracers.h"
#include "two_ways/sample_flight.h"

namespace overfly::testing {

// Ground in dark and light bands of 40 m: harder to average than any landscape.
inline ColourRamp banded_ramp() {
    ColourRamp ramp;
    for (int band = 0; band < 250; ++band) {
        const float shade = band % 2 == 0 ? 0.05F : 0.9F;
        ramp.stops.push_back({40.0F * static_cast<float>(band), {shade, shade, shade}});
        ramp.stops.push_back({40.0F * static_cast<float>(band + 1), {shade, shade, shade}});
    }
    return ramp;
}

// Frames of a flight, exposed by a tracer with so many samples a pixel; with bodies, if there are any, and the
// shadows that `shot` asks for.
struct FrameMaker {
    const Stage& stage;
    const Sight& sight;
    PictureSize size;
    TimeRange exposure;
    ShotDocument shot{};
    const ShotBodies& bodies = kNobody;
    Daylight day{shot.look.look};
    LitGround light = {
        stage.full_mesh(),
        light_ground(stage.full_mesh(), banded_ramp(), day, [](std::span<const LightRay>) { return 0U; },
                     {shot.look.sun_shadows == SunShadows::Exact ? GroundShadows::Traced : GroundShadows::Baked})};

    inline static const ShotBodies kNobody;

    double drift_px = 0.0;  // of lines
    double error = 0.0;     // that they have to reach

    // Some of a shot's frames in one go.
    [[nodiscard]] std::vector<Frame> expose_some(TracerKind kind, int lines, int samples,
                                                 const std::vector<TimeRange>& exposures,
                                                 const std::vector<TimeRange>& all_exposures) const {
        ShotDocument asked = shot;
        asked.sampling.tracer = kind;
        asked.sampling.lines = lines;
        asked.sampling.samples = samples;
        asked.sampling.drift_px = drift_px;
        asked.sampling.error = error;
        const ShotTracers tracers(asked, stage, bodies, sight);
        std::vector<ShadedBody> shaded;
        for (const auto& body : bodies)
            shaded.push_back({&body->mesh(), {body->document().albedo, body->document().mirror}});
        const SceneShader shader(stage.mesh(), light, day, false, shaded);
        std::vector<PlannedFrame> planned;
        for (const TimeRange& e : all_exposures) planned.push_back({1, e.begin_s, e, {}});
        const Exposing exposing = {tracers.pair(), shader, size, {}, planned, {}, shot.shutter.curve, tracers.filter()};
        std::vector<FilmFrame> all_films(exposures.size(), exposing.film({}));
        for (const MotionPiece& piece : sight.motions.front().pieces) {
            std::vector<PlannedFrame> frames;
            std::vector<FilmFrame*> films;
            for (std::size_t k = 0; k < exposures.size(); ++k) {
                const PlannedFrame frame = {1, exposures[k].begin_s, exposures[k], {}};
                if (!is_exposed_in(frame, piece)) continue;
                frames.push_back(frame);
                films.push_back(&all_films[k]);
            }
            TraceCounters counters;
            if (!frames.empty()) expose_piece(exposing, piece, frames, films, counters);
        }
        std::vector<Frame> frames;
        for (FilmFrame& film : all_films) frames.push_back(std::move(film).develop().frame);
        return frames;
    }
    [[nodiscard]] Frame expose(TracerKind kind, int lines, int samples) const {
        return expose_some(kind, lines, samples, {exposure}, {exposure}).front();
    }
    [[nodiscard]] Frame by_lines(int lines) const { return expose(TracerKind::Interval, lines, 1); }
    [[nodiscard]] Frame by_kinetic_lines(int lines) const { return expose(TracerKind::Kinetic, lines, 1); }
    [[nodiscard]] Frame by_samples(int samples) const { return expose(TracerKind::Discrete, 1, samples); }
};

}  // namespace overfly::testing
