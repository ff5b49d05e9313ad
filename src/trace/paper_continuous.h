#pragma once

#include "trace/paper_hierarchy.h"

namespace overfly {

// What the bounding volumes of the continuous tracer are.
enum class PaperVolumes {
    Inflated,  // the paper's: contain their polygons at all times; the ray stands still
    Carried  // of exact size, carried along with their bodies: in their frames the boxes stand still, the ray is swept;
             // where that is worth it (paper_hierarchy.h)
};

// The paper's tracer, its columns B: each pixel's ray walks the tree once for the whole animation. A polygon that it
// passes gives records of when and how deep, by the roots of its edge functions in time; the records, sorted by their
// start and truncated or split where another is nearer, shade their frames. The same plain scalar style as
// trace_paper_discrete, and the same answer but for ties.
PaperCounters trace_paper_continuous(const PaperScene& scene, const PaperHierarchy& tree, PaperVolumes volumes,
                                     PaperFrames& out);

}  // namespace overfly
