// Time per polynomial of sign_change_roots and of Bezier clipping on the same 4096 polynomials: coefficients at random,
// as many roots as the degree has, and one root of a nearly straight line as the interval tracer meets it.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "bezier_clipping.h"
#include "core/polynomial_roots.h"
#include "core/root_laws.h"

namespace overfly {
namespace {

constexpr std::size_t kPolynomials = 4096;
constexpr unsigned kSeed = 1;

enum class Kind { kRandom, kAllRoots, kOneRoot };

template <std::size_t N>
std::vector<Bernstein<N>> polynomials(Kind kind) {
    std::mt19937_64 generator(kSeed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    constexpr double kPitch = 1.0 / static_cast<double>(N);
    std::vector<Bernstein<N>> all(kPolynomials);
    for (Bernstein<N>& b : all) {
        const double root = 0.5 + 0.5 * uniform(generator);
        std::array<double, N> places{};
        for (std::size_t i = 0; i < N; ++i) {
            places[i] = (static_cast<double>(i) + 0.5 + 0.3 * uniform(generator)) * kPitch;
        }
        if (kind == Kind::kAllRoots) b = testing::with_roots<N>(places);
        for (std::size_t i = 0; i <= N && kind != Kind::kAllRoots; ++i) {
            b[i] = uniform(generator);
            if (kind == Kind::kOneRoot) b[i] = (static_cast<double>(i) + 0.02 * b[i]) * kPitch - root;
        }
    }
    return all;
}

// Google Benchmark shows the time for one polynomial as the inverse of the rate of items.
void count_polynomials(benchmark::State& state) {
    state.counters["per_polynomial"] = benchmark::Counter(
        static_cast<double>(kPolynomials), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <std::size_t N, Kind kKind>
void sign_changes_by_turns(benchmark::State& state) {
    const std::vector<Bernstein<N>> all = polynomials<N>(kKind);
    for (auto _ : state) {
        for (const Bernstein<N>& b : all) benchmark::DoNotOptimize(sign_change_roots<N>(b));
    }
    count_polynomials(state);
}

template <std::size_t N, Kind kKind>
void bezier_clipping(benchmark::State& state) {
    const std::vector<Bernstein<N>> all = polynomials<N>(kKind);
    std::vector<double> roots;
    for (auto _ : state) {
        for (const Bernstein<N>& b : all) {
            testing::bezier_clipping_roots<N>(b, roots);
            benchmark::DoNotOptimize(roots.data());
        }
    }
    count_polynomials(state);
}

template <std::size_t N>
void add_both() {
    const auto degree = "/" + std::to_string(N);
    const auto add = [&](const std::string& name, void (*run)(benchmark::State&)) {
        benchmark::RegisterBenchmark((name + degree).c_str(), run);
    };
    add("turns/random", sign_changes_by_turns<N, Kind::kRandom>);
    add("clipping/random", bezier_clipping<N, Kind::kRandom>);
    add("turns/all_roots", sign_changes_by_turns<N, Kind::kAllRoots>);
    add("clipping/all_roots", bezier_clipping<N, Kind::kAllRoots>);
    add("turns/one_root", sign_changes_by_turns<N, Kind::kOneRoot>);
    add("clipping/one_root", bezier_clipping<N, Kind::kOneRoot>);
}

}  // namespace
}  // namespace overfly

int main(int argc, char** argv) {
    overfly::add_both<2>();
    overfly::add_both<4>();
    overfly::add_both<8>();
    overfly::add_both<12>();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
