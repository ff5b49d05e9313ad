#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/kinetic_piece.h"

namespace overfly {

// Places on the film as the vector units take them.
struct FilmPlaces {
    explicit FilmPlaces(std::span<const ImageSample> samples);

    static constexpr std::size_t kTogether = 16;

    std::size_t count;
    std::vector<float> x, y;         // filled up to whole vectors with the first place
    std::vector<FilmBounds> bounds;  // of every sixteen
};

// A guess of a time at which a line of sight passes an edge is never off by more than this, in u.
inline constexpr float kGuessDoubt = 1e-3F;

// A place whose line of sight may pass a silhouette.
struct PassingPlace {
    std::uint32_t place = 0;
    float guess_u = 0.0F;  // when it passes the edge's line, if it does so once
    float doubt_u = 0.0F;  // the guess is off by less than this
    bool once =
        false;  // surely, at about the guess; neither near the piece's end, nor is it near the edge at the begin
};

// Appends the places whose line of sight may pass the silhouette while that is on this part of the film, in their
// order; and those that are near it at `begin_u`. The others surely don't: by Bernstein coefficients, and by where the
// edge appears, with a margin of more than rounding.
void append_passing(const Silhouette& silhouette, const FilmBounds& film, double begin_u, const FilmPlaces& places,
                    std::vector<PassingPlace>& passing);

}  // namespace overfly
