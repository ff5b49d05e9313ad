#include "io/exr_camera.h"

#include <gtest/gtest.h>

#include "io/sample_frame.h"

namespace overfly {
namespace {

std::array<double, 4> times(Point<Scene> p, const RowMatrix& m) {
    std::array<double, 4> product{};
    for (std::size_t i = 0; i < 4; ++i) product[i] = p.x * m[0][i] + p.y * m[1][i] + p.z * m[2][i] + m[3][i];
    return product;
}

// The point that the camera sees at film coordinates (x, y) and planar depth.
Point<Scene> seen_at(const CameraPose& pose, double x, double y, double depth_m) {
    const double t = pose.tan_half_fov;
    return pose.position + depth_m * (pose.orientation * Vector<Camera>{x * t, y * t, 1.0});
}

TEST(ExrCamera, IsLeftHandedWithYUpTheImage) {
    const CameraPose pose = sample_header().camera;
    const RowMatrix m = exr_world_to_camera(pose);
    EXPECT_NEAR(times(pose.position + pose.orientation.x, m)[0], 1.0, 1e-12);
    EXPECT_NEAR(times(pose.position - pose.orientation.y, m)[1], 1.0, 1e-12);
    EXPECT_NEAR(times(pose.position + pose.orientation.z, m)[2], 1.0, 1e-12);
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    EXPECT_NEAR(determinant, -1.0, 1e-12);
}

TEST(ExrCamera, NdcHasItsCornersAtThePicturesCorners) {
    const CameraPose pose = sample_header().camera;
    const RowMatrix m = exr_world_to_ndc(pose, 960, 540);
    constexpr double kAspect = 540.0 / 960.0;
    const struct {
        double x, y, ndc_x, ndc_y;
    } cases[] = {
        {-1.0, -kAspect, 0.0, 0.0}, {1.0, kAspect, 1.0, 1.0}, {0.0, 0.0, 0.5, 0.5}, {0.5, -kAspect, 0.75, 0.0}};
    for (const auto& c : cases) {
        const auto p = times(seen_at(pose, c.x, c.y, 7000.0), m);
        EXPECT_NEAR(p[0] / p[3], c.ndc_x, 1e-12);
        EXPECT_NEAR(p[1] / p[3], c.ndc_y, 1e-12);
        EXPECT_NEAR(p[3], 7000.0, 1e-9);
    }
}

}  // namespace
}  // namespace overfly
