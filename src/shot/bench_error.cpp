#include "shot/bench_error.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "film/frame_error.h"
#include "shot/drift_fields.h"

namespace overfly {
namespace {

constexpr int kReferenceSamples = 4096;
constexpr std::array<int, 5> kSamples = {16, 32, 64, 128, 256};
constexpr std::array<int, 6> kLines = {1, 2, 3, 4, 6, 8};
constexpr int kTileRows = 5;

// Few lines that drift far, or one that doesn't.
struct OtherDrift {
    int lines;
    double times;  // the shot's drift
};
constexpr std::array<OtherDrift, 6> kOtherDrifts = {{{1, 0.5}, {1, 1.5}, {1, 2.0}, {1, 3.0}, {2, 2.0}, {2, 3.0}}};

// One tile in each of kTileRows x kTileRows fields of the picture, shifted from field to field so that they share
// columns and rows only where a small picture has too few.
class SomeTiles {
  public:
    explicit SomeTiles(PictureSize size) {
        const int columns = drift_tiles_along(size.width), rows = drift_tiles_along(size.height);
        for (int i = 0; i < kTileRows; ++i) {
            for (int j = 0; j < kTileRows; ++j) tiles_.emplace(place(i, j, columns), place(j, i, rows));
        }
    }

    bool operator()(int x, int y) const { return tiles_.contains({x / kDriftTileSide_px, y / kDriftTileSide_px}); }
    [[nodiscard]] double share(PictureSize size) const {
        int pixels = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) pixels += (*this)(x, y) ? 1 : 0;
        }
        return static_cast<double>(pixels) / size.width / size.height;
    }

  private:
    // Along a side of so many tiles: in field `of`, shifted by where that is along the other side.
    static int place(int of, int along_other, int tiles) {
        return (2 * (of * kTileRows + along_other) + 1) * tiles / (2 * kTileRows * kTileRows);
    }

    std::set<std::pair<int, int>> tiles_;  // column and row
};

class ErrorMeasuring {
  public:
    ErrorMeasuring(const BenchScene& scene, const Progress& progress)
        : scene_(&scene),
          progress_(&progress),
          tiles_(scene.size()),
          share_(tiles_.share(scene.size())),
          work_(middle_frame(scene)),
          piece_(bench_work(scene, 1).front()) {}

    ErrorBench run() {
        ErrorBench out;
        out.reference_samples = kReferenceSamples;
        say("making the reference");
        reference_ = exposed(TracerKind::Discrete, {.count = kReferenceSamples}, work_, tiles_).frames.front();
        for (const int samples : kSamples) out.discrete.push_back(point(TracerKind::Discrete, samples, 0.0));
        const double drift_px = scene_->shot().sampling.drift_px;
        for (const int lines : kLines) out.kinetic.push_back(point(TracerKind::Kinetic, lines, drift_px));
        if (drift_px > 0.0) {
            for (const auto& [lines, times] : kOtherDrifts)
                out.other_drifts.push_back(point(TracerKind::Kinetic, lines, times * drift_px));
        }
        std::vector<ErrorPoint> quickest = out.kinetic;
        quickest.insert(quickest.end(), out.other_drifts.begin(), out.other_drifts.end());
        std::ranges::sort(quickest, {}, &ErrorPoint::seconds);
        for (const ErrorPoint& d : out.discrete) {
            const auto good = std::ranges::find_if(quickest, [&](const ErrorPoint& k) { return k.rmse <= d.rmse; });
            if (good != quickest.end()) out.equal.push_back({d, *good});
        }
        return out;
    }

  private:
    Exposed exposed(TracerKind kind, const ErrorPoint& asked, const BenchWork& work, const WantedTile& wanted) const {
        SamplingDocument sampling = scene_->shot().sampling;
        sampling.tracer = kind;
        sampling.lines = sampling.samples = asked.count;
        sampling.drift_px = asked.drift_px;
        const ShotTracers tracers = scene_->tracers(sampling);
        Exposing exposing = scene_->exposing(tracers);
        exposing.wanted = wanted;
        return expose(exposing, work);
    }

    ErrorPoint point(TracerKind kind, int count, double drift_px) const {
        say("timing pictures");
        ErrorPoint out = {count, drift_px};
        const Exposed some = exposed(kind, out, work_, tiles_);
        out.seconds = kind == TracerKind::Kinetic ? exposed(kind, out, piece_, {}).seconds / frames_in_piece()
                                                  : some.seconds / share_;
        out.rmse = root_mean_square(some.frames.front(), reference_, tiles_);
        return out;
    }

    [[nodiscard]] double frames_in_piece() const {
        double exposed_s = 0.0;
        for (const PlannedFrame& f : piece_.frames) exposed_s += f.exposure.duration_s();
        const double exposure_s = work_.frames.front().exposure.duration_s();
        return exposure_s > 0.0 ? exposed_s / exposure_s : static_cast<double>(piece_.frames.size());
    }

    void say(std::string_view what) const {
        if (*progress_) (*progress_)(what, 0.0, 0.0);
    }

    const BenchScene* scene_;
    const Progress* progress_;
    SomeTiles tiles_;
    double share_;
    BenchWork work_, piece_;
    Frame reference_;
};

}  // namespace

ErrorBench bench_error(const BenchScene& scene, const Progress& progress) {
    const OneThread one_thread;
    return ErrorMeasuring(scene, progress).run();
}

}  // namespace overfly
