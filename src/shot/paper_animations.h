#pragma once

#include <string>
#include <vector>

#include "config/documents.h"
#include "trace/paper_scene.h"

namespace overfly {

// One of the animations that the paper (trace/paper_scene.h) measures in its section 5.
struct PaperAnimation {
    std::string name, title;
    PaperScene scene;
};

// Samples along each side of the terrain that the third animation flies over: 34 x 34 cells of two triangles.
inline constexpr int kPaperSamples = 35;

// Its three animations, as far as the paper describes them; where it leaves a number open, the one that makes its
// counts of hits ours:
// 1. a static polygon that fills the image;
// 2. the same behind a smaller one that moves from the lower left corner to the upper right at constant speed. 327 of
//    409 thousand rays with polygons hit them: the small one sweeps 60 % of the picture;
// 3. a flight over 2,312 triangles of a real terrain, straight and at constant speed. 12,215 of 20,480 thousand rays of
//    frames meet ground, and a pixel meets 5.6 polygons (1,137 thousand in all).
// Reads the terrain that the document names and keeps samples at equal distances, the outermost ones included. Throws
// UserError where it cannot be read, is smaller than 35 x 35 samples or lacks one of those chosen.
[[nodiscard]] std::vector<PaperAnimation> paper_animations(const TerrainDocument& terrain);

}  // namespace overfly
