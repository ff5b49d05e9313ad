#pragma once

#include <string>
#include <vector>

#include "io/frame_channels.h"

namespace overfly {

// An object of a frame's Cryptomatte, or of its layer `id`.
struct ObjectCoverage {
    std::string name;    // eight hexadecimal digits where the manifest has none
    double share = 0.0;  // of the picture
};

// What is seen in a frame, the most first: by Cryptomatte's shares of the pixels; where the frame has only the layer
// `id`, by the pixels in which an object is seen most. manifest: kObjectsAttribute; what is no JSON names nothing.
[[nodiscard]] std::vector<ObjectCoverage> object_coverage(const FrameChannels& frame, const std::string& manifest);

}  // namespace overfly
