// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/silhouette_filter.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "trace/silhouette_filter.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace silhouette_filter {

namespace hn = hwy::HWY_NAMESPACE;

// Newton's steps; a root that they do not find is left open.
constexpr int kSteps = 4;

// Of a time in single precision, and a good deal more.
constexpr float kTimeRounding = 1e-6F;

// The slope may change until the root: half of the doubt is for that.
constexpr float kHalfGuessDoubt = 0.5F * kGuessDoubt;

using D = hn::CappedTag<float, FilmPlaces::kTogether>;
using V = hn::Vec<D>;

// The coefficients of a form for lines of sight.
HWY_INLINE std::array<V, 5> at(const FloatForm& form, V x, V y) {
    const D d;
    std::array<V, 5> c;
    for (std::size_t j = 0; j < 5; ++j) {
        c[j] = hn::Add(hn::Add(hn::Mul(x, hn::Set(d, form.right[j])), hn::Mul(y, hn::Set(d, form.down[j]))),
                       hn::Set(d, form.view[j]));
    }
    return c;
}

HWY_INLINE V value(const std::array<V, 5>& c, V u) {
    V sum = hn::Add(hn::Mul(c[4], u), c[3]);
    for (std::size_t j = 3; j > 0; --j) sum = hn::Add(hn::Mul(sum, u), c[j - 1]);
    return sum;
}

HWY_INLINE V slope(const std::array<V, 5>& c, V u) {
    const D d;
    V sum = hn::Add(hn::Mul(hn::Mul(c[4], hn::Set(d, 4.0F)), u), hn::Mul(c[3], hn::Set(d, 3.0F)));
    sum = hn::Add(hn::Mul(sum, u), hn::Add(c[2], c[2]));
    return hn::Add(hn::Mul(sum, u), c[1]);
}

// What the Bernstein coefficients of the same polynomial tell for certain.
struct Course {
    hn::Mask<D> has_one_sign, is_monotone;
};
HWY_INLINE Course course(const std::array<V, 5>& c, float margin) {
    const D d;
    // b_j = sum over i <= j of C(j,i) / C(4,i) c_i.
    const V quarter = hn::Mul(c[1], hn::Set(d, 0.25F));
    const V sixth = hn::Mul(c[2], hn::Set(d, 1.0F / 6.0F));
    const V b1 = hn::Add(c[0], quarter);
    const V b2 = hn::Add(hn::Add(b1, quarter), sixth);
    const V b3 = hn::Add(hn::Add(hn::Add(c[0], hn::Mul(quarter, hn::Set(d, 3.0F))), hn::Mul(sixth, hn::Set(d, 3.0F))),
                         hn::Mul(c[3], hn::Set(d, 0.25F)));
    const V b4 = hn::Add(hn::Add(hn::Add(c[0], c[1]), hn::Add(c[2], c[3])), c[4]);
    const V least = hn::Min(hn::Min(hn::Min(c[0], b1), hn::Min(b2, b3)), b4);
    const V most = hn::Max(hn::Max(hn::Max(c[0], b1), hn::Max(b2, b3)), b4);
    const V d0 = hn::Sub(b1, c[0]);
    const V d1 = hn::Sub(b2, b1);
    const V d2 = hn::Sub(b3, b2);
    const V d3 = hn::Sub(b4, b3);
    const V least_slope = hn::Min(hn::Min(d0, d1), hn::Min(d2, d3));
    const V most_slope = hn::Max(hn::Max(d0, d1), hn::Max(d2, d3));
    const V high = hn::Set(d, margin);
    const V low = hn::Set(d, -margin);
    return {hn::Or(hn::Gt(least, high), hn::Lt(most, low)), hn::Or(hn::Gt(least_slope, high), hn::Lt(most_slope, low))};
}

HWY_INLINE std::uint32_t bits_of(hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

class Filter {
  public:
    Filter(const Silhouette& s, const FilmBounds& film, double begin_u)
        : s_(&s), film_(film), begin_u_(static_cast<float>(begin_u)) {}

    // Which of the packets have any sample within reach.
    [[nodiscard]] bool may_pass(const FilmBounds& packet) const { return film_.overlaps(packet); }

    struct Passing {
        hn::Mask<D> may, once;
        V u, doubt;
    };

    HWY_INLINE Passing passing(V x, V y) const {
        const D d;
        const std::array<V, 5> c = at(s_->rough_across, x, y);
        const Course side = course(c, s_->rough_across.margin());
        auto may = hn::And(hn::Not(side.has_one_sign), is_on_film(x, y));
        if (hn::AllFalse(d, may)) return {may, may, x, x};
        const Root root = root_of(c, side.is_monotone);
        if (s_->has_ends) may = hn::AndNot(surely_beside(root, x, y), may);
        return {may, root.is_certain, root.u, root.doubt};
    }

  private:
    struct Root {
        V u, doubt;              // by how much it may be off, if it is certain
        hn::Mask<D> is_only;     // the line of sight passes the edge's line there, and at no other time
        hn::Mask<D> is_certain;  // and that by kGuessDoubt, and not near the begin or the end
    };

    HWY_INLINE hn::Mask<D> is_on_film(V x, V y) const {
        const D d;
        const auto low = [](double v) { return static_cast<float>(v) - kFilmRounding; };
        const auto high = [](double v) { return static_cast<float>(v) + kFilmRounding; };
        const auto in_x = hn::And(hn::Ge(x, hn::Set(d, low(film_.low_x))), hn::Le(x, hn::Set(d, high(film_.high_x))));
        const auto in_y = hn::And(hn::Ge(y, hn::Set(d, low(film_.low_y))), hn::Le(y, hn::Set(d, high(film_.high_y))));
        return hn::And(in_x, in_y);
    }

    HWY_INLINE Root root_of(const std::array<V, 5>& c, hn::Mask<D> is_monotone) const {
        const D d;
        const V zero = hn::Zero(d);
        const V one = hn::Set(d, 1.0F);
        const V last = value(c, one);
        const auto once = hn::And(is_monotone, hn::Lt(hn::Mul(c[0], last), zero));
        V u = hn::Div(c[0], hn::IfThenElse(once, hn::Sub(c[0], last), one));
        for (int step = 0; step < kSteps; ++step)
            u = hn::Min(hn::Max(hn::Sub(u, hn::Div(value(c, u), slope(c, u))), zero), one);
        const V margin = hn::Set(d, s_->rough_across.margin());
        const auto is_found = hn::And(once, hn::Le(hn::Abs(value(c, u)), margin));
        // What is left of the value, and as much as it may be off by, over the slope: the guess may be off by that.
        const V left = hn::Add(hn::Abs(value(c, u)), hn::Set(d, s_->rough_across.rounding()));
        const auto is_near = hn::Lt(left, hn::Mul(hn::Abs(slope(c, u)), hn::Set(d, kHalfGuessDoubt)));
        const auto is_inside =
            hn::Gt(hn::Min(hn::Abs(value(c, hn::Set(d, begin_u_))), hn::Min(hn::Abs(c[0]), hn::Abs(last))),
                   hn::Add(margin, margin));
        const V doubt = hn::Div(hn::Add(left, left), hn::Abs(slope(c, u)));
        return {u, doubt, is_found, hn::And(is_found, hn::And(is_near, is_inside))};
    }

    // Whether the line of sight surely does not pass between the edge's ends.
    HWY_INLINE hn::Mask<D> surely_beside(const Root& root, V x, V y) const {
        const auto beside =
            hn::Or(surely_below_0(s_->rough_begin, root, x, y), surely_below_0(s_->rough_end, root, x, y));
        return hn::And(root.is_only, beside);
    }
    HWY_INLINE static hn::Mask<D> surely_below_0(const FloatForm& form, const Root& root, V x, V y) {
        const D d;
        const std::array<V, 5> c = at(form, x, y);
        const V side = value(c, root.u);
        const V moved = hn::Mul(hn::Abs(slope(c, root.u)), hn::Add(root.doubt, root.doubt));
        const auto is_below = hn::Lt(side, hn::Neg(hn::Add(moved, hn::Set(d, form.rounding()))));
        return hn::Or(hn::And(root.is_certain, is_below), hn::Lt(side, hn::Set(d, -form.margin())));
    }

    const Silhouette* s_;
    FilmBounds film_;
    float begin_u_;
};

void append(const Silhouette& silhouette, const FilmBounds& film, double begin_u, const FilmPlaces& places,
            std::vector<PassingPlace>& passing) {
    const Filter filter(silhouette, film, begin_u);
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t first = 0; first < places.count; first += lanes) {
        if (!filter.may_pass(places.bounds[first / FilmPlaces::kTogether])) continue;
        const Filter::Passing some = filter.passing(hn::LoadU(d, &places.x[first]), hn::LoadU(d, &places.y[first]));
        if (hn::AllFalse(d, some.may)) continue;
        alignas(64) std::array<float, FilmPlaces::kTogether> guess;
        hn::Store(some.u, d, guess.data());
        alignas(64) std::array<float, FilmPlaces::kTogether> doubt;
        hn::Store(hn::Min(hn::Add(some.doubt, hn::Set(d, kTimeRounding)), hn::Set(d, kGuessDoubt)), d, doubt.data());
        const std::uint32_t once = bits_of(some.once);
        for (std::uint32_t bits = bits_of(some.may); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const std::size_t place = first + lane;
            if (place < places.count)
                passing.push_back(
                    {static_cast<std::uint32_t>(place), guess[lane], doubt[lane], (once >> lane & 1U) != 0});
        }
    }
}

}  // namespace silhouette_filter

void append_passing_places(const Silhouette& silhouette, const FilmBounds& film, double begin_u,
                           const FilmPlaces& places, std::vector<PassingPlace>& passing) {
    silhouette_filter::append(silhouette, film, begin_u, places, passing);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(append_passing_places);

FilmPlaces::FilmPlaces(std::span<const ImageSample> samples) : count(samples.size()) {
    const std::size_t whole = (count + kTogether - 1) / kTogether * kTogether;
    x.resize(whole);
    y.resize(whole);
    for (std::size_t i = 0; i < whole; ++i) {
        const ImageSample& s = samples[i < count ? i : 0];
        x[i] = static_cast<float>(s.x);
        y[i] = static_cast<float>(s.y);
    }
    for (std::size_t first = 0; first < count; first += kTogether)
        bounds.push_back(film_bounds(samples.subspan(first, std::min(kTogether, count - first))));
}

void append_passing(const Silhouette& silhouette, const FilmBounds& film, double begin_u, const FilmPlaces& places,
                    std::vector<PassingPlace>& passing) {
    HWY_DYNAMIC_DISPATCH(append_passing_places)(silhouette, film, begin_u, places, passing);
}
}  // namespace overfly
#endif
