#include "trace/paper_scene.h"

#include "core/error.h"

namespace overfly {

PaperFrames::PaperFrames(const PaperScene& scene)
    : blocks_((scene.camera.columns + kBlock - 1) / kBlock), frames_(scene.frames) {
    check(scene.polygons.size() < kNothing, "a pixel can tell polygons apart");
    pixels_.assign(static_cast<std::size_t>(scene.camera.rows * blocks_ * frames_ * kBlock), kNothing);
}

}  // namespace overfly
