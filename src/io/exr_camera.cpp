#include "io/exr_camera.h"

#include <cstddef>

namespace overfly {
namespace {

RowMatrix product(const RowMatrix& a, const RowMatrix& b) {
    RowMatrix ab{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            for (std::size_t k = 0; k < 4; ++k) ab[row][column] += a[row][k] * b[k][column];
        }
    }
    return ab;
}

}  // namespace

RowMatrix exr_world_to_camera(const CameraPose& pose) {
    const Transform<Camera, Scene> camera_from_scene = pose.camera_from_scene();
    const auto row = [](Vector<Camera> v, double w) { return std::array{v.x, -v.y, v.z, w}; };
    // The images of the world's axes and origin are the rows of a matrix for row vectors.
    return {row(camera_from_scene.rotation.x, 0.0), row(camera_from_scene.rotation.y, 0.0),
            row(camera_from_scene.rotation.z, 0.0), row(camera_from_scene.translation, 1.0)};
}

RowMatrix exr_world_to_ndc(const CameraPose& pose, int width_px, int height_px) {
    const double half_width = pose.tan_half_fov;  // of the picture at depth 1
    const double half_height = half_width * height_px / width_px;
    const RowMatrix camera_to_ndc{{{0.5 / half_width, 0.0, 0.0, 0.0},
                                   {0.0, -0.5 / half_height, 0.0, 0.0},
                                   {0.5, 0.5, 0.0, 1.0},
                                   {0.0, 0.0, 1.0, 0.0}}};
    return product(exr_world_to_camera(pose), camera_to_ndc);
}

}  // namespace overfly
