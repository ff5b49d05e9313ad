#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

// A curve's first two derivatives by time where it passes through one of its values.
template <class Value>
struct KnotDerivatives {
    Value velocity{}, acceleration{};
};

// The derivatives that Spline gives its quintics, in three steps: what polynomials through the neighbours have, turned
// so that nothing runs backward, and shortened so that nothing overshoots. Each step leaves smooth data as they are.
//
// The parabola through three neighbours (Bessel's) does not swing, but its velocity on a circle is short by a factor
// sin(h)/h, h the angle between two knots: the speed then ripples by 10 % at h = 45 degrees. The cubics through four
// neighbours bring that down to 1.2 %, but swing before a corner; so they count only as far as they agree.
// REQUIRES: those of Spline. GUARANTEES: those of Spline, of which its header tells how they follow.
template <class Value>
[[nodiscard]] std::vector<KnotDerivatives<Value>> knot_derivatives(std::span<const double> times_s,
                                                                   std::span<const Value> values);

extern template std::vector<KnotDerivatives<double>> knot_derivatives(std::span<const double>, std::span<const double>);
extern template std::vector<KnotDerivatives<Vector<Ecef>>> knot_derivatives(std::span<const double>,
                                                                            std::span<const Vector<Ecef>>);

}  // namespace overfly
