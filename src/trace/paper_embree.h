#pragma once

#include "trace/paper_scene.h"

namespace overfly {

// The same frames by Embree: in single precision, by packets of 16 rays with vector instructions, over its own
// hierarchies, one for each body, which the ray is moved against. It does not say what it tests.
void trace_paper_embree(const PaperScene& scene, PaperFrames& out);

}  // namespace overfly
