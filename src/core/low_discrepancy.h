#pragma once

#include <array>
#include <cstdint>

namespace overfly {

// Points that fill the unit cube evenly: the Sobol sequence's first three dimensions, each axis scrambled as Owen does
// it, by hashing (Burley 2020, "Practical Hash-based Owen Scrambling"). A pure function of (seed, index): every
// power-of-two run from index 0 is a (0, m, 2)-net in its first two dimensions, for every seed.

// Mixes 64 bits so that every input bit moves every output bit (splitmix64, Steele, Lea and Flood 2014).
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

// A number in [0, 1) for each seed.
[[nodiscard]] constexpr double uniform(std::uint64_t seed) { return 0x1p-53 * static_cast<double>(mixed(seed) >> 11U); }

[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 16U) | (x << 16U);
    x = ((x & 0xff00ff00U) >> 8U) | ((x & 0x00ff00ffU) << 8U);
    x = ((x & 0xf0f0f0f0U) >> 4U) | ((x & 0x0f0f0f0fU) << 4U);
    x = ((x & 0xccccccccU) >> 2U) | ((x & 0x33333333U) << 2U);
    return ((x & 0xaaaaaaaaU) >> 1U) | ((x & 0x55555555U) << 1U);
}

// Owen's scrambling of all binary digits at once, most significant first (Laine and Karras 2011, section 3).
[[nodiscard]] constexpr std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed_bits(x);
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed_bits(x);
}

namespace detail {

// Direction numbers of the primitive polynomials x + 1 and x^2 + x + 1 (Joe and Kuo 2008, rows 2 and 3).
constexpr std::array<std::uint32_t, 32> direction_numbers(int degree, std::uint32_t inner,
                                                          std::array<std::uint32_t, 2> m) {
    std::array<std::uint32_t, 32> v{};
    for (int i = 0; i < 32; ++i) {
        if (i < degree) {
            v[static_cast<std::size_t>(i)] = m[static_cast<std::size_t>(i)] << (31 - i);
            continue;
        }
        const std::uint32_t before = v[static_cast<std::size_t>(i - degree)];
        std::uint32_t x = before ^ (before >> degree);
        for (int k = 1; k < degree; ++k) {
            if (((inner >> (degree - 1 - k)) & 1U) != 0U) x ^= v[static_cast<std::size_t>(i - k)];
        }
        v[static_cast<std::size_t>(i)] = x;
    }
    return v;
}

inline constexpr std::array<std::array<std::uint32_t, 32>, 2> kDirections = {direction_numbers(1, 0, {1, 0}),
                                                                             direction_numbers(2, 1, {1, 3})};

}  // namespace detail

[[nodiscard]] constexpr std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    if (dimension == 0) return reversed_bits(index);
    std::uint32_t x = 0;
    for (std::size_t bit = 0; index != 0; ++bit, index >>= 1U) {
        if ((index & 1U) != 0U) x ^= detail::kDirections[dimension - 1][bit];
    }
    return x;
}

// How the axes are scrambled, by seed. Seeds that differ give sets that are independent of each other.
struct AxisScramble {
    std::array<std::uint32_t, 3> seed{};

    constexpr explicit AxisScramble(std::uint64_t of = 0) {
        const std::uint64_t s = mixed(of);
        for (std::size_t k = 0; k < 3; ++k) seed[k] = static_cast<std::uint32_t>(mixed(s + k + 1));
    }
};

// A point of the sequence before scrambling, the same for all seeds.
using SobolPoint = std::array<std::uint32_t, 3>;

[[nodiscard]] constexpr SobolPoint sobol_point(std::uint32_t index) {
    return {sobol(index, 0), sobol(index, 1), sobol(index, 2)};
}

// Its place in [0, 1)^3.
[[nodiscard]] constexpr std::array<double, 3> scrambled(const SobolPoint& point, const AxisScramble& scramble) {
    return {0x1p-32 * owen_scrambled(point[0], scramble.seed[0]), 0x1p-32 * owen_scrambled(point[1], scramble.seed[1]),
            0x1p-32 * owen_scrambled(point[2], scramble.seed[2])};
}

[[nodiscard]] constexpr std::array<double, 3> low_discrepancy_point(std::uint64_t seed, std::uint32_t index) {
    return scrambled(sobol_point(index), AxisScramble(seed));
}

}  // namespace overfly
