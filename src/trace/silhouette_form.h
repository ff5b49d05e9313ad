#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "trace/kinetic_line.h"
#include "trace/silhouette_film.h"

namespace overfly {

// On which side of a line in the scene the lines of sight are: that of film point (x, y) by x * right + y * down +
// view.
struct SideForm {
    Bernstein<4> right{}, down{}, view{};

    SideForm() = default;
    SideForm(const LinesOverPiece& lines, const EdgeFunction& edge)
        : right(lines.right.side_of(edge)), down(lines.down.side_of(edge)), view(lines.view.side_of(edge)) {}

    [[nodiscard]] Bernstein<4> at(double x, double y) const {
        Bernstein<4> side{};
        for (std::size_t j = 0; j < 5; ++j) side[j] = x * right[j] + y * down[j] + view[j];
        return side;
    }
    // Bounds over a part of the film and the whole piece.
    struct Range {
        double least, most;
    };
    [[nodiscard]] Range range(const FilmBounds& part) const {
        const double x = 0.5 * (part.low_x + part.high_x);
        const double y = 0.5 * (part.low_y + part.high_y);
        const double reach_x = 0.5 * (part.high_x - part.low_x);
        const double reach_y = 0.5 * (part.high_y - part.low_y);
        Bernstein<4> low{};
        Bernstein<4> high{};
        for (std::size_t j = 0; j < 5; ++j) {
            const double middle = x * right[j] + y * down[j] + view[j];
            const double reach = reach_x * std::abs(right[j]) + reach_y * std::abs(down[j]);
            low[j] = middle - reach;
            high[j] = middle + reach;
        }
        return {std::ranges::min(low), std::ranges::max(high)};
    }
};

// More than the rounding of a film coordinate in single precision, and enough to let pass who begins so near to an edge
// that silhouette_passages wants to know (kNearBegin).
inline constexpr float kFilmRounding = 4e-6F;

// A side in single precision, relative to the sum of its parts' magnitudes: its coefficients are rounded once each, and
// seven sums and products once each: 8 times 2^-24.
inline constexpr float kSideRounding = 5e-7F;

// The same in single precision, by powers of u.
struct FloatForm {
    std::array<float, 5> right{}, down{}, view{};
    float scale = 0.0F;  // the sum of its coefficients' magnitudes
    [[nodiscard]] float margin() const { return kFilmRounding * scale; }
    [[nodiscard]] float rounding() const { return kSideRounding * scale; }

    FloatForm() = default;
    explicit FloatForm(const SideForm& form) {
        double sum = 0.0;
        const auto right_u = monomials<4>(form.right);
        const auto down_u = monomials<4>(form.down);
        const auto view_u = monomials<4>(form.view);
        for (std::size_t j = 0; j < 5; ++j) {
            right[j] = static_cast<float>(right_u[j]);
            down[j] = static_cast<float>(down_u[j]);
            view[j] = static_cast<float>(view_u[j]);
            sum += std::abs(right_u[j]) + std::abs(down_u[j]) + std::abs(view_u[j]);
        }
        scale = static_cast<float>(sum);
    }
};

}  // namespace overfly
