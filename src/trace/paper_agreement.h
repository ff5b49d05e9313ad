#pragma once

#include "trace/paper_scene.h"

namespace overfly {

// How two answers to the same animation differ, pixel by pixel and frame by frame.
struct PaperAgreement {
    std::uint64_t pixels = 0;
    std::uint64_t differing = 0;
    std::uint64_t unexplained = 0;  // of those: no edge of either polygon is within the distance asked for

    [[nodiscard]] double differing_share() const {
        return static_cast<double>(differing) / static_cast<double>(pixels);
    }
};

[[nodiscard]] PaperAgreement compare(const PaperScene& scene, const PaperFrames& a, const PaperFrames& b,
                                     double edge_px);

}  // namespace overfly
