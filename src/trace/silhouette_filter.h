#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/kinetic_piece.h"

namespace overfly {

// Places on the film as the vector units take them.
struct FilmPlaces {
    explicit FilmPlaces(std::span<const ImageSample> samples);

    std::size_t count;
    std::vector<float> x, y;  // filled up to whole vectors with the first place
};

// A place whose line of sight may pass a silhouette, and when in u, if only once: a guess.
struct PassingPlace {
    std::uint32_t place = 0;
    float guess_u = 0.0F;
};

// Appends the places whose line of sight may pass the silhouette while the piece lasts, in their order. The others
// surely don't: by Bernstein coefficients, and by where the edge appears, with a margin of more than rounding.
void append_passing(const Silhouette& silhouette, const FilmPlaces& places, std::vector<PassingPlace>& passing);

}  // namespace overfly
