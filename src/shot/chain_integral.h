#pragma once

#include <algorithm>
#include <cstddef>

#include "core/float4.h"

namespace overfly {

// The integral of a chain of straight pieces, each being of unit length, from each place that is asked for to the next.
class ChainIntegral {
  public:
    ChainIntegral(const Float4* nodes, int pieces)
        : to_(nodes + 1), last_(nodes + pieces), begin_(nodes[0]), rise_(nodes[1] - nodes[0]) {}

    struct Until {
        Float4 more;   // since the last place, at first since the chain's begin
        Float4 value;  // there
    };
    // t: in pieces, not before the last one.
    Until operator()(float t) {
        Float4 more{};
        while (t - whole_ > 1.0F && to_ < last_) {
            more += mean_to(1.0F);
            begin_ = to_[0];
            rise_ = to_[1] - to_[0];
            ++to_;
            whole_ += 1.0F;
            reached_ = 0.0F;
        }
        const float rest = t - whole_;
        more += mean_to(rest);
        reached_ = rest;
        return {more, begin_ + rest * rise_};
    }

  private:
    [[nodiscard]] Float4 mean_to(float t) const { return (t - reached_) * (begin_ + (0.5F * (reached_ + t)) * rise_); }

    const Float4 *to_, *last_;  // the node at the end of this piece, and of all
    Float4 begin_, rise_;       // of this piece
    float whole_ = 0.0F, reached_ = 0.0F;
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
