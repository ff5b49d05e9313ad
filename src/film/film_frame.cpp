#include "film/film_frame.h"

namespace overfly {

FilmFrame::FilmFrame(int width, int height) {
    frame_.width = width;
    frame_.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    frame_.rgba.assign(pixels, {});
    frame_.depth_m.assign(pixels, Frame::kNoDepth);
}

}  // namespace overfly
