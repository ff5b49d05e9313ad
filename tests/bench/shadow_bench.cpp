#include <benchmark/benchmark.h>

#include <cmath>

#include "config/read.h"
#include "core/angle.h"
#include "shot/expose_piece.h"
#include "shot/pixel_tile.h"
#include "shot/shot_motion.h"
#include "shot/stage.h"
#include "trace/interval.h"
#include "trace/shadow_tracer.h"

// What it costs to ask when the sun reaches what a sample sees, on the demo's terrain.
namespace overfly {
namespace {

// One piece in the middle of the demo, and what one sample a pixel sees in every seventh tile, but ground that faces
// away from the sun.
class Demo {
  public:
    Demo()
        : shot_(read_shot_document(OVERFLY_SOURCE_DIR "/configs/demo.yaml", {})),
          stage_(prepare_terrain(shot_.terrain, default_cache_folder()), middle_of(shot_.flight)),
          tracer_(stage_.mesh()) {
        const CameraPath path = make_path(shot_.flight, stage_);
        const std::vector<PlannedFrame> frames = plan_frames(shot_, path.times());
        const Motion motion = shot_motion(shot_, path, frames, stage_);
        piece_ = motion.pieces[motion.pieces.size() / 2];
        for (const PlannedFrame& f : frames) {
            if (is_exposed_in(f, piece_)) exposures_.push_back(intersection(f.exposure, piece_.when));
        }
        const PictureSize size = {shot_.image.width, shot_.image.height};
        const std::vector<PixelTile> tiles = tiles_of(size);
        for (std::size_t i = 0; i < tiles.size(); i += 7) look(samples_of(tiles[i], size, 1).samples);
    }

    [[nodiscard]] const StaticBvh& hierarchy() const { return tracer_.hierarchy(); }
    [[nodiscard]] const TriangleMesh& mesh() const { return stage_.mesh(); }
    [[nodiscard]] const MotionPiece& piece() const { return piece_; }

    // Those of which the sun sees the same side.
    [[nodiscard]] std::vector<ShadowQuery> queries(Vector<Scene> to_sun) const {
        std::vector<ShadowQuery> out;
        for (const ShadowQuery& q : seen_) {
            const auto& corner = mesh().triangles[q.triangle];
            const Point<Scene> a = mesh().positions[corner[0]];
            const Vector<Scene> normal = cross(mesh().positions[corner[1]] - a, mesh().positions[corner[2]] - a);
            if (dot(normal, to_sun) > 0.0) out.push_back(q);
        }
        return out;
    }

  private:
    void look(const std::vector<ImageSample>& samples) {
        SegmentLists lists;
        TraceCounters counters;
        tracer_.trace(piece_, samples, exposures_, lists, counters);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            for (const VisibleSegment& s : lists.of(i)) {
                seen_.push_back({samples[i], &mesh(), s.triangle, &piece_, s.when});
            }
        }
    }

    ShotDocument shot_;
    Stage stage_;
    IntervalTracer tracer_;
    MotionPiece piece_;
    std::vector<TimeRange> exposures_;
    std::vector<ShadowQuery> seen_;
};

const Demo& demo() {
    static const Demo one;
    return one;
}

// By the sun's elevation, and whether it is taken for one that turns.
void terrain_on_itself(benchmark::State& state) {
    const double elevation = Angle::degrees(static_cast<double>(state.range(0))).radians();
    const double azimuth = Angle::degrees(115.0).radians();
    const Vector<Scene> to_sun = {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                                  std::sin(elevation)};
    MotionPiece motion = demo().piece();
    motion.to_sun = {to_sun, (state.range(1) == 1 ? 1e-9 : 0.0) * to_sun, {}};
    const std::vector<ShadowQuery> queries = demo().queries(to_sun);
    const ShadowTracer tracer(demo().mesh(), demo().hierarchy());
    ShadowLists lists;
    TraceCounters counters;
    for (auto _ : state) {
        lists.clear();
        tracer.trace(motion, queries, lists, counters);
        benchmark::DoNotOptimize(lists.dark.data());
    }
    const auto asked = static_cast<double>(counters.rays);
    state.counters["queries"] = static_cast<double>(queries.size());
    state.counters["ns_per_query"] =
        benchmark::Counter(1e-9 * asked, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["box_tests"] = static_cast<double>(counters.box_tests) / asked;
    state.counters["triangle_tests"] = static_cast<double>(counters.triangle_tests) / asked;
    state.counters["dark_stretches"] = static_cast<double>(counters.segments) / asked;
}
BENCHMARK(terrain_on_itself)
    ->ArgNames({"elevation_deg", "turning"})
    ->ArgsProduct({{5, 22, 60}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overfly

BENCHMARK_MAIN();
