#include "trace/discrete.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "trace/line.h"

namespace overfly {
namespace {

// Embree decides sides from float coordinates relative to the ray's origin, so an edge is off by a few roundings
// (2^-24) of the distance. Sixteen, as an angle: assumed, not derived; held by the agreement with double on real
// terrain.
constexpr float kFloatAngle = 0x1p-20F;

// Vertices and the ray's origin are rounded to float relative to the float centre.
constexpr float kFloatPlace = 0x1p-23F;

// After a fold or a border was decided against, the ray goes on just behind it.
constexpr double kBehind = 1.0 + 1e-6;

// One lane of a packet: which sample and exposure it stands for.
struct Lane {
    std::size_t sample = 0;
    double time_s = 0.0;
};

Line line_at(const MotionPiece& piece, double x, double y, double time_s) {
    const double u = piece.u_at(time_s);
    return {piece.reference, piece.origin.at(u), piece.direction_at(u, x, y)};
}

class Decision {
  public:
    Decision(const RayScene& scene, const Line& line) : scene_(&scene), line_(&line) {}

    // The triangle that the line really sees, given the one that float arithmetic named.
    [[nodiscard]] TriangleId decide(TriangleId named) const {
        TriangleId triangle = named;
        for (int behind = 0; behind < kMostSurfaces; ++behind) {
            if (const auto found = walk(triangle)) return *found;
            // The line passes a fold or a border that float took for a hit: look behind it.
            const double least = depth_on(scene_->mesh(), triangle, *line_) * kBehind;
            if (!std::isfinite(least) || least < 0.0) return named;
            const auto next = scene_->first_hit(line_->reference + line_->origin, line_->direction, least);
            if (!next) return kNone;
            triangle = next->triangle;
        }
        return named;
    }

  private:
    static constexpr int kMostSurfaces = 4;  // a ray that misses more folds than this by a rounding is not worth it
    static constexpr int kMostSteps = 8;     // around a vertex

    // From triangle to triangle across the side that the line passes on the wrong side of.
    [[nodiscard]] std::optional<TriangleId> walk(TriangleId triangle) const {
        for (int step = 0; step < kMostSteps; ++step) {
            const EdgeValues values = edge_values(scene_->mesh(), triangle, *line_);
            if (values.inside()) return triangle;
            const double facing = values.at[0] + values.at[1] + values.at[2];
            std::size_t worst = 0;
            for (std::size_t k = 1; k < 3; ++k) {
                if (values.at[k] * facing < values.at[worst] * facing) worst = k;
            }
            const HalfEdgeId twin = scene_->mesh().twins[triangle][worst];
            if (twin == kNone) return std::nullopt;
            triangle = twin / 4;
        }
        return std::nullopt;
    }

    const RayScene* scene_;
    const Line* line_;
};

// A packet being filled, and the rules that all of its rays share. Its loops over all lanes are written for the
// compiler to vectorise: around Embree they would otherwise cost as much as its search.
class Batch {
  public:
    Batch(const RayScene& scene, const MotionPiece& piece, std::span<const ImageSample> samples, const RayStart* start)
        : scene_(&scene), piece_(&piece), samples_(samples), start_(start), per_s_(1.0 / piece.when.duration_s()) {}

    [[nodiscard]] bool is_full() const { return count_ == RayPacket::kSize; }

    void add(std::size_t sample, double time_s) {
        x_[count_] = samples_[sample].x;
        y_[count_] = samples_[sample].y;
        u_[count_] = (time_s - piece_->when.begin_s) * per_s_;
        lanes_[count_++] = {sample, time_s};
    }

    // Calls found(sample, time, triangle) for every lane, with kNone where it sees the sky, and empties the packet.
    template <class Found>
    void trace(const Found& found, TraceCounters& counters) {
        if (count_ == 0) return;
        aim();
        scene_->first_hits(packet_);
        mark_doubtful();
        counters.rays += count_;
        for (std::size_t i = 0; i < count_; ++i) {
            TriangleId triangle = packet_.triangle[i];
            if (triangle != kNone && doubtful_[i] != 0) {
                ++counters.resolved;
                const Line line = line_at(*piece_, x_[i], y_[i], lanes_[i].time_s);
                triangle = Decision(*scene_, line).decide(triangle);
            }
            if (triangle != kNone) ++counters.segments;
            found(lanes_[i].sample, lanes_[i].time_s, triangle);
        }
        count_ = 0;
    }

  private:
    void aim() {
        const Vector<Scene> reference = piece_->reference - scene_->float_centre();
        for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
            packet_.aim(i, reference + piece_->origin.at(u_[i]), piece_->direction_at(u_[i], x_[i], y_[i]), i < count_);
        }
        if (start_ != nullptr) begin_at_start();
    }

    void begin_at_start() {
        for (std::size_t i = 0; i < count_; ++i) {
            const double least = start_->depth_at(lanes_[i].time_s, x_[i], y_[i]);
            const bool starts = std::isfinite(least) && least > 0.0;
            packet_.least[i] = starts ? static_cast<float>(least) : 0.0F;
            if (!starts) packet_.valid[i] = 0;
        }
    }

    // Which lanes hit so near an edge that their float decision may be wrong. A barycentric coordinate times twice the
    // projected area is the distance to an edge times the edge's projected length, which is at most the longest side.
    void mark_doubtful() {
        const auto longest_side_m = static_cast<float>(scene_->longest_side_m());
        const RayPacket& p = packet_;
        for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
            const float dx = p.direction_x[i];
            const float dy = p.direction_y[i];
            const float dz = p.direction_z[i];
            const float along = std::abs(p.normal_x[i] * dx + p.normal_y[i] * dy + p.normal_z[i] * dz);
            const float direction_length = std::sqrt(dx * dx + dy * dy + dz * dz);
            const float distance_m = p.depth[i] * direction_length;
            const float origin_m = std::abs(p.origin_x[i]) + std::abs(p.origin_y[i]) + std::abs(p.origin_z[i]);
            const float doubt_m = kFloatAngle * distance_m + kFloatPlace * (distance_m + origin_m);
            const float least = std::min(std::min(p.u[i], p.v[i]), 1.0F - p.u[i] - p.v[i]);
            doubtful_[i] = least * along < doubt_m * longest_side_m * direction_length ? 1 : 0;
        }
    }

    const RayScene* scene_;
    const MotionPiece* piece_;
    std::span<const ImageSample> samples_;
    const RayStart* start_;
    double per_s_;
    std::size_t count_ = 0;
    RayPacket packet_{};
    std::array<Lane, RayPacket::kSize> lanes_{};
    std::array<double, RayPacket::kSize> x_{}, y_{}, u_{};
    std::array<std::int32_t, RayPacket::kSize> doubtful_{};
};

}  // namespace

void DiscreteTracer::trace(const MotionPiece& piece, std::span<const ImageSample> samples,
                           std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters,
                           const RayStart* start) const {
    // Neighbouring samples share an exposure, so packets run through the samples for each exposure in turn; the answers
    // are put back into the order of the samples.
    struct Instant {
        TriangleId triangle = kNone;
        double time_s = std::numeric_limits<double>::quiet_NaN();  // stays so where the piece lacks the instant
    };
    std::vector<Instant> instants(samples.size() * exposures.size());
    for (std::size_t e = 0; e < exposures.size(); ++e) {
        Batch batch(*scene_, piece, samples, start);
        const auto keep = [&](std::size_t sample, double time_s, TriangleId triangle) {
            instants[sample * exposures.size() + e] = {triangle, time_s};
        };
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double time_s = exposures[e].begin_s + samples[i].phase * exposures[e].duration_s();
            if (time_s < piece.when.begin_s || time_s >= piece.when.end_s) continue;
            batch.add(i, time_s);
            if (batch.is_full()) batch.trace(keep, counters);
        }
        batch.trace(keep, counters);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t e = 0; e < exposures.size(); ++e) {
            const Instant& instant = instants[i * exposures.size() + e];
            if (std::isnan(instant.time_s)) continue;
            out.segments.push_back({instant.triangle, {instant.time_s, instant.time_s}});
        }
        out.end_sample();
    }
}

TriangleId DiscreteTracer::visible_at(const MotionPiece& piece, double x, double y, double time_s) const {
    const std::array<ImageSample, 1> sample = {{{x, y, 0.0}}};
    Batch batch(*scene_, piece, sample, nullptr);
    batch.add(0, time_s);
    TriangleId seen = kNone;
    TraceCounters counters;
    batch.trace([&](std::size_t, double, TriangleId triangle) { seen = triangle; }, counters);
    return seen;
}

}  // namespace overfly
