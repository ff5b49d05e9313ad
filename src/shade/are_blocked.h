#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

// From a point along a direction.
struct LightRay {
    Point<Scene> from;
    Vector<Scene> direction;
};

inline constexpr std::size_t kRaysAtOnce = 16;

// Of up to kRaysAtOnce rays, quickest for those that run much alike: bit i says whether ground stands in the way of
// the i-th. Called from many threads at once.
using AreBlocked = std::function<std::uint32_t(std::span<const LightRay> rays)>;

// Gathers rays until there are enough to ask about them at once. Each has a label of its own; when(label) is called for
// each ray that nothing blocks, in the order in which they came.
template <class F>
class OpenRays {
  public:
    OpenRays(const AreBlocked& are_blocked, F when) : are_blocked_(&are_blocked), when_(when) {}

    void add(const LightRay& ray, std::size_t label) {
        rays_[count_] = ray;
        labels_[count_] = label;
        if (++count_ == kRaysAtOnce) finish();
    }
    // Asks about those that are left.
    void finish() {
        if (count_ == 0) return;
        const std::uint32_t blocked = (*are_blocked_)({rays_.data(), count_});
        for (std::size_t i = 0; i < count_; ++i) {
            if (((blocked >> i) & 1U) == 0U) when_(labels_[i]);
        }
        count_ = 0;
    }

  private:
    const AreBlocked* are_blocked_;
    F when_;
    std::array<LightRay, kRaysAtOnce> rays_;
    std::array<std::size_t, kRaysAtOnce> labels_{};
    std::size_t count_ = 0;
};

}  // namespace overfly
