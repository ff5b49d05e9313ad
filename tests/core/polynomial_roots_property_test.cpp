// The laws of polynomial_roots.h on two million polynomials, most of them made to hurt.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/polynomial_roots.h"
#include "core/root_laws.h"

namespace overfly {
namespace {

constexpr std::uint64_t kSeed = 20220704;

class Source {
  public:
    explicit Source(std::uint64_t seed) : generator_(seed) {}

    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
    // 10^low to 10^high, of either sign.
    double magnitude(double low, double high) {
        return (whole(0, 1) == 0 ? 1.0 : -1.0) * std::pow(10.0, between(low, high));
    }

  private:
    std::mt19937_64 generator_;
};

template <std::size_t N>
using Maker = Bernstein<N> (*)(Source&);

template <std::size_t N>
Bernstein<N> uniform(Source& from) {
    Bernstein<N> b{};
    for (double& c : b) c = from.between(-1.0, 1.0);
    return b;
}

template <std::size_t N>
Bernstein<N> of_all_magnitudes(Source& from) {
    Bernstein<N> b{};
    const double span = from.between(0.0, 40.0);
    for (double& c : b) c = from.magnitude(-span, 0.0);
    return b;
}

// Zeros everywhere, equal neighbours, values that are exactly zero.
template <std::size_t N>
Bernstein<N> of_small_numbers(Source& from) {
    Bernstein<N> b{};
    for (double& c : b) c = from.whole(-2, 2);
    return b;
}

template <std::size_t N>
Bernstein<N> with_spread_roots(Source& from) {
    std::array<double, N> roots{};
    for (double& r : roots) r = from.between(-0.5, 1.5);
    return testing::with_roots<N>(roots);
}

// Roots within 10^-1 to 10^-17 of two places.
template <std::size_t N>
Bernstein<N> with_clustered_roots(Source& from) {
    std::array<double, N> roots{};
    const std::array<double, 2> centres = {from.between(0.0, 1.0), from.between(0.0, 1.0)};
    for (double& r : roots) {
        r = centres[static_cast<std::size_t>(from.whole(0, 1))] + from.magnitude(-17.0, -1.0);
    }
    return testing::with_roots<N>(roots);
}

// Roots at the ends, and as near to them as a double can tell.
template <std::size_t N>
Bernstein<N> with_roots_at_the_ends(Source& from) {
    std::array<double, N> roots{};
    for (double& r : roots) {
        const int kind = from.whole(0, 5);
        r = kind < 2 ? static_cast<double>(kind) : from.magnitude(-20.0, -1.0) + (kind == 2 ? 1.0 : 0.0);
        if (kind == 5) r = from.between(0.0, 1.0);
    }
    return testing::with_roots<N>(roots);
}

// A polynomial of lower degree raised to this one, with rounding, and noise on top in half of the cases.
template <std::size_t N>
Bernstein<N> of_lower_degree(Source& from) {
    std::array<long double, N + 1> c{};
    const int degree = from.whole(0, static_cast<int>(N));
    for (int i = 0; i <= degree; ++i) c[static_cast<std::size_t>(i)] = from.between(-1.0, 1.0);
    for (int n = degree; n < static_cast<int>(N); ++n) {
        for (int i = n + 1; i >= 0; --i) {
            const auto k = static_cast<std::size_t>(i);
            const long double part = static_cast<long double>(i) / static_cast<long double>(n + 1);
            c[k] = (i > 0 ? part * c[k - 1] : 0.0L) + (i <= n ? (1 - part) * c[k] : 0.0L);
        }
    }
    Bernstein<N> b{};
    const double noise = from.whole(0, 1) == 0 ? 0.0 : std::abs(from.magnitude(-18.0, -8.0));
    for (std::size_t i = 0; i <= N; ++i) b[i] = static_cast<double>(c[i]) + noise * from.between(-1.0, 1.0);
    return b;
}

// Moved up or down so that one of its extremes comes near to zero, or on it.
template <std::size_t N>
Bernstein<N> nearly_touching(Source& from) {
    Bernstein<N> b = uniform<N>(from);
    const Roots<N - 1> turns = sign_change_roots<N - 1>(derivative<N>(b));
    if (turns.count == 0) return b;
    const double turn = turns.u[static_cast<std::size_t>(from.whole(0, static_cast<int>(turns.count) - 1))];
    const double shift = value_at<N>(b, turn) + (from.whole(0, 2) == 0 ? 0.0 : from.magnitude(-18.0, -10.0));
    for (double& c : b) c -= shift;
    return b;
}

// The laws for one polynomial; equal roots for its negative and at another magnitude.
template <std::size_t N>
std::string broken_law(const Bernstein<N>& b, Source& from) {
    const Roots<N> roots = sign_change_roots<N>(b);
    const std::string broken = testing::broken_law<N>(b, roots, {0.0, 1.0, from.between(0, 1), from.between(0, 1)});
    if (!broken.empty()) return broken;
    Bernstein<N> other = b;
    const int exponent = from.whole(-60, 900);
    for (double& c : other) c = -std::ldexp(c, exponent);
    const Roots<N> same = sign_change_roots<N>(other);
    return same.count == roots.count && same.u == roots.u ? "" : "magnitude 2^" + std::to_string(exponent);
}

template <std::size_t N>
void check_family(const char* name, Maker<N> make, int trials) {
    Source from(kSeed + N);
    for (int trial = 0; trial < trials; ++trial) {
        const Bernstein<N> b = make(from);
        const std::string broken = broken_law<N>(b, from);
        ASSERT_EQ(broken, "") << name << ", degree " << N << ", seed " << kSeed << ", trial " << trial << "\n"
                              << ::testing::PrintToString(b);
    }
}

template <std::size_t N>
void check_degree() {
#ifdef __SANITIZE_ADDRESS__
    constexpr int kTrials = 2'000;  // ten times as slow; what a sanitizer sees, it sees soon
#else
    constexpr int kTrials = 20'000;
#endif
    check_family<N>("uniform", uniform<N>, kTrials);
    check_family<N>("of all magnitudes", of_all_magnitudes<N>, kTrials);
    check_family<N>("of small numbers", of_small_numbers<N>, kTrials);
    check_family<N>("with spread roots", with_spread_roots<N>, kTrials);
    check_family<N>("with clustered roots", with_clustered_roots<N>, kTrials);
    check_family<N>("with roots at the ends", with_roots_at_the_ends<N>, kTrials);
    check_family<N>("of lower degree", of_lower_degree<N>, kTrials);
    check_family<N>("nearly touching", nearly_touching<N>, kTrials);
}

template <std::size_t... Is>
void check_degrees(std::index_sequence<Is...>) {
    (check_degree<Is + 2>(), ...);
}

TEST(PolynomialRootsProperty, LawsHoldForNastyPolynomials) { check_degrees(std::make_index_sequence<11>{}); }

// Roots at eighths, exactly: those inside of odd order and no others, each within what its order allows.
template <std::size_t N>
void check_exact(int trials) {
    Source from(kSeed + 100 + N);
    for (int trial = 0; trial < trials; ++trial) {
        std::array<int, N> numerators{};
        for (int& n : numerators) n = N <= 8 ? from.whole(-4, 12) : from.whole(0, 8);
        const Bernstein<N> b = testing::with_eighths<N>(numerators);
        const Roots<N> roots = sign_change_roots<N>(b);
        std::vector<double> wanted;
        std::vector<double> bounds;
        for (int n = 1; n < 8; ++n) {
            const auto order = std::ranges::count(numerators, n);
            if (order % 2 == 0) continue;
            wanted.push_back(n / 8.0);
            bounds.push_back(order == 1 ? 1e-10 : 0.06);
        }
        const auto report = [&] {
            return "degree " + std::to_string(N) + ", seed " + std::to_string(kSeed) + ": " +
                   ::testing::PrintToString(numerators);
        };
        ASSERT_EQ(roots.count, wanted.size()) << report();
        for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_NEAR(roots.u[i], wanted[i], bounds[i]) << report();
    }
}

TEST(PolynomialRootsProperty, ExactRootsOfOddOrderAndNoOthers) {
    check_exact<2>(20'000);
    check_exact<3>(20'000);
    check_exact<4>(50'000);
    check_exact<6>(50'000);
    check_exact<8>(50'000);
    check_exact<10>(50'000);
    check_exact<12>(50'000);
}

// Roots at least 1 / (2 N) apart: all of them, to 1e-12, by arithmetic of 113 bits.
template <std::size_t N>
void check_separated(int trials) {
    Source from(kSeed + 200 + N);
    for (int trial = 0; trial < trials; ++trial) {
        std::array<double, N> places{};
        for (std::size_t i = 0; i < N; ++i) {
            places[i] = (static_cast<double>(i) + from.between(0.25, 0.75)) / static_cast<double>(N);
        }
        const Bernstein<N> b = testing::with_roots<N>(places);
        const Roots<N> roots = sign_change_roots<N>(b);
        ASSERT_EQ(roots.count, N) << "seed " << kSeed << ", trial " << trial;
        for (const double u : roots) {
            ASSERT_TRUE(testing::changes_near<N>(b, u, 1e-12))
                << u << ", degree " << N << ", seed " << kSeed << ", trial " << trial;
        }
    }
}

TEST(PolynomialRootsProperty, WellSeparatedRootsToTwelveDigits) {
    check_separated<2>(5'000);
    check_separated<3>(5'000);
    check_separated<4>(5'000);
    check_separated<8>(2'000);
    check_separated<12>(1'000);
}

}  // namespace
}  // namespace overfly
