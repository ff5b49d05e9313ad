#pragma once

#include <algorithm>
#include <cstddef>

#include "core/float4.h"

namespace overfly {

// The integral of a chain of straight pieces from its begin on, for ever later ends.
class ChainIntegral {
  public:
    ChainIntegral(const Float4* nodes, int pieces) : from_(nodes), last_(nodes + pieces - 1) {}

    struct Until {
        Float4 sum;    // each piece being of unit length
        Float4 value;  // there
    };
    // t: in pieces.
    Until operator()(float t) {
        while (t - whole_ > 1.0F && from_ < last_) {
            before_ += 0.5F * (from_[0] + from_[1]);
            whole_ += 1.0F;
            ++from_;
        }
        const float rest = t - whole_;
        const Float4 value = from_[0] + rest * (from_[1] - from_[0]);
        return {before_ + (0.5F * rest) * (from_[0] + value), value};
    }

  private:
    const Float4 *from_, *last_;
    Float4 before_{};
    float whole_ = 0.0F;
};

// How much each node of such a chain counts in its integral from one place to another, in pieces: with_node(node,
// weight) is called for both ends of each piece that is met. REQUIRES: 0 <= begin, end <= pieces.
template <class WithNode>
void for_each_node(float begin, float end, int pieces, const WithNode& with_node) {
    for (int piece = std::min(static_cast<int>(begin), pieces - 1); piece < pieces; ++piece) {
        const auto whole = static_cast<float>(piece);
        const float from = std::max(begin - whole, 0.0F), to = std::min(end - whole, 1.0F);
        if (to <= from) return;
        const float lasting = to - from, of_next = 0.5F * (from + to);
        with_node(static_cast<std::size_t>(piece), lasting * (1.0F - of_next));
        with_node(static_cast<std::size_t>(piece) + 1, lasting * of_next);
    }
}

}  // namespace overfly
