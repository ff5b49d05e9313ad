#include "film/film_frame.h"

#include <algorithm>
#include <utility>

namespace overfly {

void ExposedFrame::join(const ExposedFrame& other) {
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) frame.rgba[i][c] = 0.5F * (frame.rgba[i][c] + other.frame.rgba[i][c]);
        frame.depth_m[i] = std::min(frame.depth_m[i], other.frame.depth_m[i]);
    }
    facts.join(other.facts);
}

FilmFrame::FilmFrame(int width, int height, Weights weights, const FactKinds& kinds, const FrameSteps& steps)
    : facts_(kinds.any() ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0, kinds, steps) {
    frame_.width = width;
    frame_.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    frame_.rgba.assign(pixels, {});
    frame_.depth_m.assign(pixels, Frame::kNoDepth);
    if (weights == Weights::AreCounted) weights_.assign(pixels, 0.0F);
}

ExposedFrame FilmFrame::develop() && {
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        if (weights_[i] == 0.0F) continue;
        for (float& c : frame_.rgba[i]) c /= weights_[i];
        if (has_facts()) facts_.divide(i, weights_[i]);
    }
    return {std::move(frame_), std::move(facts_)};
}

std::size_t FilmFrame::memory_bytes() const {
    return frame_.rgba.size() * sizeof(frame_.rgba[0]) + (frame_.depth_m.size() + weights_.size()) * sizeof(float) +
           facts_.memory_bytes();
}

std::size_t FilmFrame::memory_bytes(int width, int height, Weights weights, const FactKinds& kinds) {
    return FilmFrame(width, 1, weights, kinds).memory_bytes() * static_cast<std::size_t>(height);
}

}  // namespace overfly
