#pragma once

#include <array>
#include <string>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "trace/paper_agreement.h"

namespace overfly {

struct PaperBenchOptions {
    int runs = 3;  // of each tracer, in turn; the quickest counts
    Progress progress;
};

// A column of the paper's Figure 5 in thousands, as printed there.
struct PaperColumn {
    double bv_tests = 0.0, bv_hits = 0.0, poly_tests = 0.0, poly_hits = 0.0;
    double seconds = 0.0;  // of a Silicon Graphics Iris 4D
};

struct PaperMeasurement {
    PaperCounters counters;
    double seconds = 0.0;        // of this thread's processor time, the least of all runs
    PaperAgreement to_discrete;  // the frames against those of the discrete tracer
};

// How many times as much the one has to do as the other.
struct PaperRatio {
    double bv_tests = 0.0, poly_tests = 0.0, seconds = 0.0;
};

struct PaperCase {
    std::string name, title;
    PaperMeasurement discrete;
    PaperMeasurement continuous;  // boxes carried along, the ray swept
    PaperMeasurement inflated;    // the continuous tracer with the paper's bounding volumes
    PaperMeasurement embree;      // has no counters
    PaperColumn paper_discrete, paper_continuous;

    [[nodiscard]] PaperRatio ratio() const;  // discrete to continuous
    [[nodiscard]] PaperRatio inflated_ratio() const;
    [[nodiscard]] PaperRatio paper_ratio() const;
};

struct PaperBench {
    int rows = 0, columns = 0, frames = 0;
    std::vector<PaperCase> cases;
};

// The paper's Figure 5 (trace/paper_scene.h), measured again: its three animations by each tracer, on this thread.
// The time includes whatever a tracer prepares for an animation or a frame, and the shading, which is to write the
// number of the polygon seen. Not included: the tree of bounding volumes, which all but Embree share.
[[nodiscard]] PaperBench bench_paper(const TerrainDocument& terrain, const PaperBenchOptions& options);

}  // namespace overfly
