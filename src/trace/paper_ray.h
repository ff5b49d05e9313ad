#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "trace/paper_hierarchy.h"

namespace overfly {

// What the rays of both of the paper's tracers share: a direction that stays, and the slabs of a box as Kay and Kajiya
// 1986 cut a ray with them. Along axis k a ray from o is inside a slab [low, high] from
// low / d_k - o_k / d_k to high / d_k - o_k / d_k.
struct PaperDirection {
    explicit PaperDirection(Vector<Scene> direction)
        : d(direction), inverse{inverse_of(direction.x), inverse_of(direction.y), inverse_of(direction.z)} {
        for (std::size_t k = 0; k < 3; ++k) near[k] = inverse[k] < 0.0 ? k + 3 : k;
        for (std::size_t k = 0; k < 3; ++k) far[k] = inverse[k] < 0.0 ? k : k + 3;
    }

    [[nodiscard]] bool is_backward(std::size_t k) const { return near[k] != k; }
    // Where a ray from the origin would enter and leave the slab.
    [[nodiscard]] double entry(const PaperBox& box, std::size_t k) const { return box.bound[near[k]] * inverse[k]; }
    [[nodiscard]] double exit(const PaperBox& box, std::size_t k) const { return box.bound[far[k]] * inverse[k]; }
    // -o / d, by axis.
    [[nodiscard]] std::array<double, 3> shift(Vector<Scene> o) const {
        return {-o.x * inverse[0], -o.y * inverse[1], -o.z * inverse[2]};
    }

    Vector<Scene> d;
    std::array<double, 3> inverse;
    std::array<std::size_t, 3> near, far;  // in PaperBox::bound, what the ray meets first and last along each axis

  private:
    // Of a ray along the slab: so large that it is inside for ever or never, and still finite.
    static double inverse_of(double d) { return 1.0 / (std::abs(d) < 1e-30 ? std::copysign(1e-30, d) : d); }
};

// A ray that stands still: the usual slab test.
struct PaperStillRay {
    PaperStillRay(const PaperDirection& direction, Point<Scene> eye)
        : to(&direction), shift(direction.shift(eye - Point<Scene>{})) {}

    // Is any of the ray's first `farthest` lengths inside?
    [[nodiscard]] bool meets(const PaperBox& box, double farthest) const {
        const double from = std::max(std::max(to->entry(box, 0) + shift[0], to->entry(box, 1) + shift[1]),
                                     std::max(to->entry(box, 2) + shift[2], 0.0));
        const double until = std::min(std::min(to->exit(box, 0) + shift[0], to->exit(box, 1) + shift[1]),
                                      std::min(to->exit(box, 2) + shift[2], farthest));
        return from <= until;
    }

    const PaperDirection* to;
    std::array<double, 3> shift;
};

// A ray whose origin moves along a quadratic in u, by its Bernstein coefficients: what a polygon sees of a still ray
// when it is carried along itself (the paper's section 4).
//
// The slabs of the axes a and b hold the ray together at the time u when entry_a <= exit_b and entry_b <= exit_a. Both
// sides move with the origin, but box and time come apart: with r(u) = shift_a(u) - shift_b(u)
//     entry_b(box) - exit_a(box) <= r(u) <= exit_b(box) - entry_a(box).
// r is a quadratic of the ray alone. It lies between its chord and its chord plus its rise, so that each pair of axes
// leaves a range of times that is linear in the bounds of the box, and a box whose three ranges share no time is not
// met.
class PaperSweptRay {
  public:
    PaperSweptRay(const PaperDirection& direction, const std::array<Vector<Scene>, 3>& origin, double extent_m)
        : to_(&direction) {
        std::array<std::array<double, 3>, 3> shift;
        for (std::size_t j = 0; j < 3; ++j) shift[j] = direction.shift(origin[j]);
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            const double first = shift[0][a] - shift[0][b];
            const double last = shift[2][a] - shift[2][b];
            // A quadratic leaves its chord by at most half of what its middle coefficient does.
            const double rise = 0.5 * (shift[1][a] - shift[1][b] - 0.5 * (first + last));
            const double margin =
                kRounding * extent_m * (std::abs(direction.inverse[a]) + std::abs(direction.inverse[b]));
            greatest_shift_[a] = std::max({shift[0][a], shift[1][a], shift[2][a]}) + margin;
            const double least = first + std::max(rise, 0.0) + margin;
            const double most = first + std::min(rise, 0.0) - margin;
            const double slope = last - first;
            const double per_slope = std::abs(slope) < kFlat ? std::copysign(1.0 / kFlat, slope) : 1.0 / slope;
            pairs_[a] = {direction.near[b],
                         direction.far[a],
                         direction.far[b],
                         direction.near[a],
                         direction.inverse[b] * per_slope,
                         direction.inverse[a] * per_slope,
                         least * per_slope,
                         most * per_slope};
            if (slope < 0.0) {
                std::swap(pairs_[a].begin_b, pairs_[a].end_b);
                std::swap(pairs_[a].begin_a, pairs_[a].end_a);
                std::swap(pairs_[a].begin_shift, pairs_[a].end_shift);
            }
        }
    }

    // May any part of the ray be inside at any time? Never no where it is.
    [[nodiscard]] bool meets(const PaperBox& box) const {
        const auto& v = box.bound;
        const auto begin_of = [&](const Pair& p) {
            return v[p.begin_b] * p.scale_b - v[p.begin_a] * p.scale_a - p.begin_shift;
        };
        const auto end_of = [&](const Pair& p) {
            return v[p.end_b] * p.scale_b - v[p.end_a] * p.scale_a - p.end_shift;
        };
        const double begin =
            std::max(std::max(begin_of(pairs_[0]), begin_of(pairs_[1])), std::max(0.0, begin_of(pairs_[2])));
        const double end = std::min(std::min(end_of(pairs_[0]), end_of(pairs_[1])), std::min(1.0, end_of(pairs_[2])));
        const double ahead = std::min(std::min(to_->exit(box, 0) + greatest_shift_[0],  //
                                               to_->exit(box, 1) + greatest_shift_[1]),
                                      to_->exit(box, 2) + greatest_shift_[2]);
        // One comparison: which of the two fails can't be foreseen, and a wrong guess costs as much as the rest.
        return std::min(ahead, end - begin) >= 0.0;
    }

  private:
    // Far more than a dozen roundings of numbers as large as the scene, far less than anything to be seen.
    static constexpr double kRounding = 0x1p-42;
    static constexpr double kFlat = 1e-100;

    // When two slabs hold the ray together: from (bound b) * scale_b - (bound a) * scale_a - shift on, until the same
    // of other bounds.
    struct Pair {
        std::size_t begin_b, begin_a, end_b, end_a;  // in PaperBox::bound
        double scale_b, scale_a;
        double begin_shift, end_shift;
    };

    const PaperDirection* to_;
    std::array<Pair, 3> pairs_;
    std::array<double, 3> greatest_shift_;
};

}  // namespace overfly
