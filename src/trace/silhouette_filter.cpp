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

constexpr std::size_t kPlacesTogether = 16;

// More than the roundings of a film coordinate, and of a side relative to the sum of its parts' magnitudes; and enough
// to let pass who begins so near to an edge that silhouette_passages wants to know (kNearBegin there).
constexpr float kRounding = 4e-6F;

// Newton's steps; a root that they do not find is left open.
constexpr int kSteps = 4;

using D = hn::CappedTag<float, kPlacesTogether>;
using V = hn::Vec<D>;

// A side form in single precision: monomial coefficients in u.
struct Form {
    explicit Form(const SideForm& form) {
        double scale = 0.0;
        const auto right_u = monomials<4>(form.right);
        const auto down_u = monomials<4>(form.down);
        const auto view_u = monomials<4>(form.view);
        for (std::size_t j = 0; j < 5; ++j) {
            right[j] = static_cast<float>(right_u[j]);
            down[j] = static_cast<float>(down_u[j]);
            view[j] = static_cast<float>(view_u[j]);
            scale += std::abs(right_u[j]) + std::abs(down_u[j]) + std::abs(view_u[j]);
        }
        margin = kRounding * static_cast<float>(scale);
    }

    // The coefficients for a line of sight.
    HWY_INLINE std::array<V, 5> at(V x, V y) const {
        const D d;
        std::array<V, 5> c;
        for (std::size_t j = 0; j < 5; ++j) {
            c[j] = hn::Add(hn::Add(hn::Mul(x, hn::Set(d, right[j])), hn::Mul(y, hn::Set(d, down[j]))),
                           hn::Set(d, view[j]));
        }
        return c;
    }

    std::array<float, 5> right{}, down{}, view{};
    float margin = 0.0F;
};

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

// The Bernstein coefficients of the same polynomial: whether they surely have one sign.
HWY_INLINE hn::Mask<D> surely_one_sign(const std::array<V, 5>& c, float margin) {
    const D d;
    V b = c[0];
    V least = b;
    V most = b;
    // b_j = sum over i <= j of C(j,i) / C(4,i) c_i.
    const auto take = [&](V next) HWY_ATTR {
        least = hn::Min(least, next);
        most = hn::Max(most, next);
    };
    const V quarter = hn::Mul(c[1], hn::Set(d, 0.25F));
    const V sixth = hn::Mul(c[2], hn::Set(d, 1.0F / 6.0F));
    b = hn::Add(c[0], quarter);
    take(b);
    b = hn::Add(hn::Add(b, quarter), sixth);
    take(b);
    b = hn::Add(hn::Add(hn::Add(c[0], hn::Mul(quarter, hn::Set(d, 3.0F))), hn::Mul(sixth, hn::Set(d, 3.0F))),
                hn::Mul(c[3], hn::Set(d, 0.25F)));
    take(b);
    take(hn::Add(hn::Add(hn::Add(c[0], c[1]), hn::Add(c[2], c[3])), c[4]));
    return hn::Or(hn::Gt(least, hn::Set(d, margin)), hn::Lt(most, hn::Set(d, -margin)));
}

class Filter {
  public:
    Filter(const Silhouette& s)
        : across_(s.across),
          begin_(s.begin),
          end_(s.end),
          has_ends_(s.has_ends),
          low_x_(static_cast<float>(s.film.low_x) - kRounding),
          high_x_(static_cast<float>(s.film.high_x) + kRounding),
          low_y_(static_cast<float>(s.film.low_y) - kRounding),
          high_y_(static_cast<float>(s.film.high_y) + kRounding) {}

    struct Passing {
        hn::Mask<D> may;
        V u;
    };

    HWY_INLINE Passing passing(V x, V y) const {
        const D d;
        const auto in_x = hn::And(hn::Ge(x, hn::Set(d, low_x_)), hn::Le(x, hn::Set(d, high_x_)));
        const auto in_y = hn::And(hn::Ge(y, hn::Set(d, low_y_)), hn::Le(y, hn::Set(d, high_y_)));
        const std::array<V, 5> c = across_.at(x, y);
        const auto may = hn::AndNot(surely_one_sign(c, across_.margin), hn::And(in_x, in_y));
        if (hn::AllFalse(d, may)) return {may, x};
        const Root root = root_of(c);
        return {has_ends_ ? hn::AndNot(surely_beside(root, x, y), may) : may, root.u};
    }

  private:
    struct Root {
        V u;
        hn::Mask<D> is_only;  // the line of sight passes the edge's line there, and at no other time
    };

    HWY_INLINE Root root_of(const std::array<V, 5>& c) const {
        const D d;
        const V zero = hn::Zero(d);
        const V one = hn::Set(d, 1.0F);
        const V last = value(c, one);
        const auto once = hn::Lt(hn::Mul(c[0], last), zero);
        V u = hn::Div(c[0], hn::IfThenElse(once, hn::Sub(c[0], last), one));
        for (int step = 0; step < kSteps; ++step)
            u = hn::Min(hn::Max(hn::Sub(u, hn::Div(value(c, u), slope(c, u))), zero), one);
        const auto found = hn::Le(hn::Abs(value(c, u)), hn::Set(d, across_.margin));
        return {u, hn::And(once, found)};
    }

    // Whether the line of sight surely does not pass between the edge's ends.
    HWY_INLINE hn::Mask<D> surely_beside(const Root& root, V x, V y) const {
        const D d;
        const auto before = hn::Lt(value(begin_.at(x, y), root.u), hn::Set(d, -begin_.margin));
        const auto behind = hn::Lt(value(end_.at(x, y), root.u), hn::Set(d, -end_.margin));
        return hn::And(root.is_only, hn::Or(before, behind));
    }

    Form across_, begin_, end_;
    bool has_ends_;
    float low_x_, high_x_, low_y_, high_y_;
};

void append(const Silhouette& silhouette, const FilmPlaces& places, std::vector<PassingPlace>& passing) {
    const Filter filter(silhouette);
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t first = 0; first < places.count; first += lanes) {
        const Filter::Passing some = filter.passing(hn::LoadU(d, &places.x[first]), hn::LoadU(d, &places.y[first]));
        if (hn::AllFalse(d, some.may)) continue;
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, some.may, bytes);
        alignas(64) std::array<float, kPlacesTogether> guess;
        hn::Store(some.u, d, guess.data());
        auto bits = static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
        for (; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const std::size_t place = first + lane;
            if (place < places.count) passing.push_back({static_cast<std::uint32_t>(place), guess[lane]});
        }
    }
}

}  // namespace silhouette_filter

void append_passing_places(const Silhouette& silhouette, const FilmPlaces& places, std::vector<PassingPlace>& passing) {
    silhouette_filter::append(silhouette, places, passing);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(append_passing_places);

namespace {
constexpr std::size_t kWholeVectors = 16;
}

FilmPlaces::FilmPlaces(std::span<const ImageSample> samples) : count(samples.size()) {
    const std::size_t whole = (count + kWholeVectors - 1) / kWholeVectors * kWholeVectors;
    x.resize(whole);
    y.resize(whole);
    for (std::size_t i = 0; i < whole; ++i) {
        const ImageSample& s = samples[i < count ? i : 0];
        x[i] = static_cast<float>(s.x);
        y[i] = static_cast<float>(s.y);
    }
}

void append_passing(const Silhouette& silhouette, const FilmPlaces& places, std::vector<PassingPlace>& passing) {
    HWY_DYNAMIC_DISPATCH(append_passing_places)(silhouette, places, passing);
}
}  // namespace overfly
#endif
