#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/float4.h"
#include "flight/motion.h"
#include "shade/sky_nodes.h"

namespace overfly {

// What lines of sight see while they meet no triangle: runs, many at once. Each is followed as a chain of straight
// pieces that are equally long in time.
class SkyRuns {
  public:
    static constexpr std::size_t kSize = 64;

    struct Run {
        double x = 0.0, y = 0.0;          // the film point
        double from_u = 0.0, to_u = 0.0;  // in the piece
        int pixels = 1;                   // that it passes
    };
    // scene, day, light: look_at_sky's; all must outlive it. depth: the fourth number of all nodes.
    SkyRuns(const MotionPiece& scene, const Daylight& day, const LitGround& light, float depth)
        : scene_(&scene), day_(&day), light_(&light), depth_(depth) {}

    // Its number, counted from the last clear(). REQUIRES: less than kSize.
    std::size_t add(const Run& run);
    [[nodiscard]] std::size_t count() const { return count_; }
    void clear() { count_ = 0; }

    // Looks at all runs. GUARANTEES: what is said of one doesn't depend on which others there are.
    void follow();
    // Instead of follow(): there is no light, nor an edge.
    void leave_dark();

    // Red, green, blue and depth at the nodes. REQUIRES: is_smooth(run).
    [[nodiscard]] std::span<const Float4> nodes(std::size_t run) const {
        const Chain& chain = chains_[run];
        return std::span(nodes_).subspan(chain.first, chain.pieces + 1);
    }
    // Not where the round Earth ends before the sky meanwhile.
    [[nodiscard]] bool is_smooth(std::size_t run) const {
        const Chain& chain = chains_[run];
        return chain.on_earth == 0 || chain.on_earth == chain.pieces + 1;
    }

  private:
    struct Chain {
        std::size_t first = 0, pieces = 1;
        std::size_t on_earth = 0;  // so many of its nodes
    };
    void begin_chains();
    [[nodiscard]] bool is_straight(const Chain& chain) const;
    void halve_pieces(std::size_t run);
    void ask(std::size_t run, std::size_t node);
    void look();

    const MotionPiece* scene_;
    const Daylight* day_;
    const LitGround* light_;
    float depth_;
    std::size_t count_ = 0;
    std::array<Run, kSize> runs_{};
    std::array<Chain, kSize> chains_{};
    std::vector<std::size_t> bent_;  // whose pieces are still to be halved
    std::vector<Float4> nodes_;
    // Nodes that still have to be looked at, and whose they are.
    std::size_t asked_count_ = 0;
    SkyNodes asked_;
    struct Asked {
        std::uint32_t run = 0, node = 0;
    };
    std::array<Asked, SkyNodes::kSize> whose_{};
};

}  // namespace overfly
