// The edge functions of one triangle along the lines of all cells at once. For Highway, as box_walk-inl.h.
#if defined(OVERFLY_TRACE_TRIANGLE_SIDES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERFLY_TRACE_TRIANGLE_SIDES_INL_H
#undef OVERFLY_TRACE_TRIANGLE_SIDES_INL_H
#else
#define OVERFLY_TRACE_TRIANGLE_SIDES_INL_H
#endif

#include <utility>

#include "core/bernstein.h"
#include "trace/box_walk-inl.h"
#include "trace/edge_function.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {

// The cells in which a line passes the three sides on one hand, for certain or perhaps.
struct SideMasks {
    std::uint32_t surely_inside = 0, perhaps_inside = 0;
};

template <std::size_t kDegree>
class TriangleSides {
  public:
    explicit TriangleSides(const PolynomialLines<kDegree>& lines) : lines_(&lines) {}

    // Evaluates them for the sides of a triangle, in these cells at least.
    HWY_INLINE SideMasks evaluate(const std::array<EdgeFunction, 3>& edges, std::uint32_t cells) {
        const Doubles d;
        const std::size_t lanes = hn::Lanes(d);
        const std::uint32_t chunk = (1U << lanes) - 1U;
        SideMasks masks;
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            if ((cells >> first & chunk) == 0) continue;
            const auto zero = hn::Zero(d);
            auto all_front = hn::Eq(zero, zero);
            auto all_back = all_front;
            auto any_front = all_front;
            auto any_back = all_front;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [least, most] = edge_range(edges[k], k, first);
                all_front = hn::And(all_front, hn::Ge(least, zero));
                all_back = hn::And(all_back, hn::Le(most, zero));
                any_front = hn::And(any_front, hn::Ge(most, zero));
                any_back = hn::And(any_back, hn::Le(least, zero));
            }
            masks.surely_inside |= bits_at(d, hn::Or(all_front, all_back), first);
            masks.perhaps_inside |= bits_at(d, hn::Or(any_front, any_back), first);
        }
        masks.surely_inside &= cells;
        masks.perhaps_inside &= cells;
        return masks;
    }

    // As last evaluated.
    [[nodiscard]] std::array<Bernstein<kDegree>, 3> in(std::size_t cell) const {
        std::array<Bernstein<kDegree>, 3> sides;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j <= kDegree; ++j) sides[k][j] = coefficients_[k][j][cell];
        }
        return sides;
    }

  private:
    // Evaluates the coefficients of edge k in the lanes from `first`, keeps them, and returns their range.
    HWY_INLINE std::pair<hn::Vec<Doubles>, hn::Vec<Doubles>> edge_range(const EdgeFunction& edge, std::size_t k,
                                                                        std::size_t first) {
        const Doubles d;
        // The order of operations is that of EdgeFunction::at, without fused steps, so that neighbours agree bit by
        // bit.
        const auto ax = hn::Set(d, -edge.sign * edge.a_cross_b.x);
        const auto ay = hn::Set(d, -edge.sign * edge.a_cross_b.y);
        const auto az = hn::Set(d, -edge.sign * edge.a_cross_b.z);
        const auto bx = hn::Set(d, -edge.sign * edge.b_minus_a.x);
        const auto by = hn::Set(d, -edge.sign * edge.b_minus_a.y);
        const auto bz = hn::Set(d, -edge.sign * edge.b_minus_a.z);
        auto least = hn::Set(d, std::numeric_limits<double>::infinity());
        auto most = hn::Neg(least);
        for (std::size_t j = 0; j <= kDegree; ++j) {
            const auto term = [&](hn::Vec<Doubles> factor, const PerCell<double>& line)
                                  HWY_ATTR { return hn::Mul(factor, hn::Load(d, &line[first])); };
            const auto along = hn::Add(hn::Add(term(ax, lines_->direction[0][j]), term(ay, lines_->direction[1][j])),
                                       term(az, lines_->direction[2][j]));
            const auto about = hn::Add(hn::Add(term(bx, lines_->moment[0][j]), term(by, lines_->moment[1][j])),
                                       term(bz, lines_->moment[2][j]));
            const auto coefficient = hn::Add(along, about);
            hn::Store(coefficient, d, &coefficients_[k][j][first]);
            least = hn::Min(least, coefficient);
            most = hn::Max(most, coefficient);
        }
        return {least, most};
    }

    const PolynomialLines<kDegree>* lines_;
    alignas(64) std::array<std::array<PerCell<double>, kDegree + 1>, 3> coefficients_{};
};

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#endif
