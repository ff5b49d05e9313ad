#pragma once

#include "trace/paper_hierarchy.h"

namespace overfly {

// The paper's "standard" ray tracer, its columns A: each frame by itself. The polygons and the boxes of `tree` are put
// where they are in the frame, then each pixel's ray walks the tree from front to back, box by box, and leaves out
// what lies behind the nearest polygon found so far. Plain scalar code in double precision, on the calling thread.
PaperCounters trace_paper_discrete(const PaperScene& scene, const PaperHierarchy& tree, PaperFrames& out);

}  // namespace overfly
