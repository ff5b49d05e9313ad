#pragma once

#include <cstddef>

#include "core/float4.h"

namespace overfly {

// The integral of a chain of straight pieces from its begin on, for ever later ends. A node every `stride` values.
class ChainIntegral {
  public:
    ChainIntegral(const Float4* nodes, int pieces, std::size_t stride = 1)
        : stride_(stride), from_(nodes), last_(nodes + static_cast<std::size_t>(pieces - 1) * stride) {}

    struct Until {
        Float4 sum;    // each piece being of unit length
        Float4 value;  // there
    };
    // t: in pieces.
    Until operator()(float t) {
        while (t - whole_ > 1.0F && from_ < last_) {
            before_ += 0.5F * (from_[0] + from_[stride_]);
            whole_ += 1.0F;
            from_ += stride_;
        }
        const float rest = t - whole_;
        const Float4 value = from_[0] + rest * (from_[stride_] - from_[0]);
        return {before_ + (0.5F * rest) * (from_[0] + value), value};
    }

  private:
    std::size_t stride_;
    const Float4 *from_, *last_;
    Float4 before_{};
    float whole_ = 0.0F;
};

}  // namespace overfly
