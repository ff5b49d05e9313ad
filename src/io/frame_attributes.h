#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "flight/shutter.h"
#include "io/exr_camera.h"
#include "io/frame_file.h"
#include "io/smpte_time.h"

namespace overfly {

// What the header of a frame's file says, as OpenEXR's types but without its headers.
struct FrameAttribute {
    using Vector2f = std::array<float, 2>;
    using Vector3d = std::array<double, 3>;
    using Matrix44f = std::array<std::array<float, 4>, 4>;
    using Value =
        std::variant<int, float, double, std::string, Vector2f, Vector3d, Matrix44f, RowMatrix, FrameRate, SmpteTime>;
    std::string name;
    Value value;
};

inline constexpr const char* kInputsAttribute = "overfly:inputs";
inline constexpr const char* kDepthMeaning =
    "planar distance along the view axis in metres, nearest in the pixel while the shutter is open; 1e10 = nothing but "
    "sky";

// Standard attributes in the standard's types, which are single precision, and the same camera in double precision
// under the prefix `overfly:`. A longitude in single precision is exact to 2 m only; worldToNDC has the precision of
// the scene's coordinates: from a camera 20 km from its origin it puts what is 400 m away within 0.01 pixel (1920
// pixels in 60 degrees), what is nearer less exactly. overfly:worldToNDC is exact.
[[nodiscard]] std::vector<FrameAttribute> frame_attributes(const FrameHeader& header, int width_px, int height_px);

}  // namespace overfly
