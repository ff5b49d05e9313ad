#pragma once

#include <cmath>

#include "film/film_frame.h"
#include "shot/expose_piece.h"
#include "two_ways/terrain_flights.h"

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

// One frame of a flight, exposed by a tracer with so many samples a pixel.
struct FrameMaker {
    const Stage& stage;
    const Motion& motion;
    PictureSize size;
    TimeRange exposure;
    Daylight day{Look{}};
    GroundLight light =
        light_ground(stage.mesh(), banded_ramp(), day, [](Point<Scene>, Vector<Scene>) { return false; });

    [[nodiscard]] Frame expose(const Tracer& tracer, int samples) const {
        const SceneShader shader(stage.mesh(), light, day, false);
        FilmFrame film(size.width, size.height);
        const Exposing exposing = {tracer, shader, size, samples, {}};
        const std::vector<PlannedFrame> frames = {{1, exposure.begin_s, exposure, {}}};
        const std::vector<FilmFrame*> films = {&film};
        TraceCounters counters;
        for (const MotionPiece& piece : motion.pieces) {
            if (is_exposed_in(frames[0], piece)) expose_piece(exposing, piece, frames, films, counters);
        }
        return std::move(film).develop();
    }
};

// Of red, green and blue together, in shares of full scale (linear 1).
inline double root_mean_square_error(const Frame& a, const Frame& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(a.rgba[i][c]) - static_cast<double>(b.rgba[i][c]);
            sum += difference * difference;
        }
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.rgba.size())));
}

}  // namespace overfly::testing
