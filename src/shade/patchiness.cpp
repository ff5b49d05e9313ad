#include "shade/patchiness.h"

#include <cmath>
#include <cstdint>

namespace overfly {
namespace {

struct Octave {
    double lattice_m;
    float amplitude;
    std::uint64_t seed;
};
// Rather rough: the finer patches are half as strong as the larger. Amplitudes add up to 1.
constexpr Octave kOctaves[] = {{700.0, 0.64F, 1}, {210.0, 0.36F, 2}};

// From -1 to 1, by the finaliser of splitmix64 (Steele, Lea and Flood 2014).
float at_lattice(std::int64_t i, std::int64_t j, std::uint64_t seed) {
    std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U;
    h ^= (static_cast<std::uint64_t>(j) + seed) * 0xD1B54A32D192ED03U;
    h = (h ^ (h >> 30U)) * 0xBF58476D1CE4E5B9U;
    h = (h ^ (h >> 27U)) * 0x94D049BB133111EBU;
    h ^= h >> 31U;
    return static_cast<float>(h >> 40U) / 8388607.5F - 1.0F;  // of 24 bits
}

float smooth_step(float t) { return t * t * (3.0F - 2.0F * t); }

float value_noise(double x, double y, std::uint64_t seed) {
    const double i = std::floor(x);
    const double j = std::floor(y);
    const float s = smooth_step(static_cast<float>(x - i));
    const float t = smooth_step(static_cast<float>(y - j));
    const auto at = [&](int di, int dj) {
        return at_lattice(static_cast<std::int64_t>(i) + di, static_cast<std::int64_t>(j) + dj, seed);
    };
    const float south = (1.0F - s) * at(0, 0) + s * at(1, 0);
    const float north = (1.0F - s) * at(0, 1) + s * at(1, 1);
    return (1.0F - t) * south + t * north;
}

}  // namespace

float patchiness(Point<Scene> p) {
    float sum = 0.0F;
    for (const Octave& o : kOctaves) sum += o.amplitude * value_noise(p.x / o.lattice_m, p.y / o.lattice_m, o.seed);
    return sum;
}

}  // namespace overfly
