#include "film/film_frame.h"

#include <utility>

namespace overfly {

FilmFrame::FilmFrame(int width, int height, Weights weights, const FactKinds& kinds, const FrameSteps& steps)
    : facts_(kinds.any() ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 0, kinds, steps) {
    frame_.width = width;
    frame_.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    frame_.rgba.assign(pixels, {});
    frame_.depth_m.assign(pixels, Frame::kNoDepth);
    if (weights == Weights::AreCounted) weights_.assign(pixels, 0.0F);
}

Frame FilmFrame::develop() && {
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        if (weights_[i] == 0.0F) continue;
        for (float& c : frame_.rgba[i]) c /= weights_[i];
        if (has_facts()) facts_.divide(i, weights_[i]);
    }
    return std::move(frame_);
}

std::size_t FilmFrame::memory_bytes() const {
    return frame_.rgba.size() * sizeof(frame_.rgba[0]) + (frame_.depth_m.size() + weights_.size()) * sizeof(float) +
           facts_.memory_bytes();
}

}  // namespace overfly
