#pragma once

#include "core/float4.h"

namespace overfly {

// e^x for what is left of light after air: four in less time than std::exp takes for one, and the same bits with every
// libm. REQUIRES: x <= 0. GUARANTEES: exactly 1 at 0; relative error below 1e-5 down to x = -87; about e^-87 below.
[[nodiscard]] inline Float4 fast_exp(Float4 x) {
    const Float4 lowest = {-87.0F, -87.0F, -87.0F, -87.0F};
    const Float4 power_of_two = (x > lowest ? x : lowest) * 1.44269504F;  // log2 of e
    const Int4 whole = __builtin_convertvector(power_of_two, Int4);       // towards 0, so that the rest is in (-1, 0]
    const Float4 f = power_of_two - __builtin_convertvector(whole, Float4);
    // 2^f = 1 + f q(f), q through the five Chebyshev nodes of [-1, 0]: 4.3e-7. Rounding the power of two adds |x| 1e-7.
    const Float4 q = 0.69314694F + f * (0.24021469F + f * (0.05540856F + f * (0.00934423F + f * 0.00100363F)));
    const Int4 exponent = (whole + 127) << 23;
    return (1.0F + f * q) * reinterpret_cast<Float4>(exponent);  // of vectors: the same bits
}

[[nodiscard]] inline float fast_exp(float x) { return fast_exp(Float4{x, 0.0F, 0.0F, 0.0F})[0]; }

}  // namespace overfly
