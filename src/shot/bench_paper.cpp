#include "shot/bench_paper.h"

#include <algorithm>
#include <functional>

#include "shot/paper_animations.h"
#include "shot/processor_time.h"
#include "trace/paper_continuous.h"
#include "trace/paper_discrete.h"
#include "trace/paper_embree.h"

namespace overfly {
namespace {

constexpr std::array<PaperColumn, 3> kPaperA = {{{20'480, 20'480, 20'480, 20'480, 4'080},
                                                 {61'440, 40'960, 20'480, 20'480, 5'160},
                                                 {422'532, 139'316, 28'913, 12'215, 16'020}}};
constexpr std::array<PaperColumn, 3> kPaperB = {
    {{204, 204, 204, 204, 349}, {614, 614, 409, 327, 411}, {17'309, 11'515, 5'620, 1'137, 2'025}}};

// Far more than the rounding of doubles, far less than can be seen; and that of Embree's floats.
constexpr double kTie_px = 1e-6;
constexpr double kFloatTie_px = 0.01;

using Tracer = std::function<PaperCounters(PaperFrames&)>;

void measure(const Tracer& tracer, PaperFrames& frames, PaperMeasurement& result) {
    const double start_s = processor_seconds();
    result.counters = tracer(frames);
    const double seconds = processor_seconds() - start_s;
    result.seconds = result.seconds > 0.0 ? std::min(result.seconds, seconds) : seconds;
}

PaperCase run_case(const PaperAnimation& animation, const PaperBenchOptions& options) {
    const PaperScene& scene = animation.scene;
    const PaperHierarchy tree = build_paper_hierarchy(scene);
    PaperFrames reference(scene);
    PaperFrames frames(scene);
    PaperCase result;
    result.name = animation.name;
    result.title = animation.title;
    // One after the other in each run, so that a change of the machine's speed meets all.
    for (int run = 0; run < options.runs; ++run) {
        if (options.progress) options.progress(animation.title, run, options.runs);
        measure([&](PaperFrames& out) { return trace_paper_discrete(scene, tree, out); }, reference, result.discrete);
        const auto compete = [&](const Tracer& tracer, PaperMeasurement& measurement, double tie_px) {
            measure(tracer, frames, measurement);
            if (run == 0) measurement.to_discrete = compare(scene, reference, frames, tie_px);
        };
        compete([&](PaperFrames& out) { return trace_paper_continuous(scene, tree, PaperVolumes::Carried, out); },
                result.continuous, kTie_px);
        compete([&](PaperFrames& out) { return trace_paper_continuous(scene, tree, PaperVolumes::Inflated, out); },
                result.inflated, kTie_px);
        const auto embree = [&](PaperFrames& out) {
            trace_paper_embree(scene, out);
            return PaperCounters{};
        };
        compete(embree, result.embree, kFloatTie_px);
    }
    return result;
}

PaperColumn in_thousands(const PaperMeasurement& m) {
    const auto thousands = [](std::uint64_t count) { return 1e-3 * static_cast<double>(count); };
    return {thousands(m.counters.bv_tests), thousands(m.counters.bv_hits), thousands(m.counters.poly_tests),
            thousands(m.counters.poly_hits), m.seconds};
}

PaperRatio ratio_of(const PaperColumn& a, const PaperColumn& b) {
    return {a.bv_tests / b.bv_tests, a.poly_tests / b.poly_tests, a.seconds / b.seconds};
}

}  // namespace

PaperRatio PaperCase::ratio() const { return ratio_of(in_thousands(discrete), in_thousands(continuous)); }
PaperRatio PaperCase::inflated_ratio() const { return ratio_of(in_thousands(discrete), in_thousands(inflated)); }
PaperRatio PaperCase::paper_ratio() const { return ratio_of(paper_discrete, paper_continuous); }

PaperBench bench_paper(const TerrainDocument& terrain, const PaperBenchOptions& options) {
    const std::vector<PaperAnimation> animations = paper_animations(terrain);
    const PaperScene& first = animations.front().scene;
    PaperBench bench = {first.camera.rows, first.camera.columns, first.frames, {}};
    for (std::size_t i = 0; i < animations.size(); ++i) {
        bench.cases.push_back(run_case(animations[i], options));
        bench.cases.back().paper_discrete = kPaperA[i];
        bench.cases.back().paper_continuous = kPaperB[i];
    }
    return bench;
}

}  // namespace overfly
