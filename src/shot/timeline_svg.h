#pragma once

#include <string>

#include "shot/pixel_timeline.h"

namespace overfly {

// A page about what a pixel sees, as an SVG document: the time line, the depths of everything that its line of sight
// passes, and the curves of intersection in the planes of triangles. Colours that people who see few colours can tell
// apart (Okabe and Ito 2008), and letters besides.
[[nodiscard]] std::string timeline_svg(const PixelTimeline& pixel);

}  // namespace overfly
