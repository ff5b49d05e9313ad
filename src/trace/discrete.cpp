#include "trace/discrete.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "trace/line.h"

namespace overfly {
namespace {

// Embree decides sides from float coordinates relative to the ray's origin: its edge values are off by a few roundings
// of the distance. 16 of them, as an angle; four times the largest disagreement with double seen on the sample terrain.
constexpr double kFloatAngle = 16.0 * 0x1p-24;

// Vertices and the ray's origin are rounded to float relative to the float centre.
constexpr double kFloatPlace = 2.0 * 0x1p-24;

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

// Whether lane `i` hit so near an edge that its float decision may be wrong. Barycentric coordinate times twice the
// projected area is the distance to an edge times the edge's projected length, which is at most the longest side.
bool is_doubtful(const RayPacket& p, std::size_t i, double longest_side_m) {
    const double dx = static_cast<double>(p.direction_x[i]);
    const double dy = static_cast<double>(p.direction_y[i]);
    const double dz = static_cast<double>(p.direction_z[i]);
    const double along = std::abs(static_cast<double>(p.normal_x[i]) * dx + static_cast<double>(p.normal_y[i]) * dy +
                                  static_cast<double>(p.normal_z[i]) * dz);
    const double direction_length = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double distance_m = static_cast<double>(p.depth[i]) * direction_length;
    const double from_centre_m = distance_m + std::abs(static_cast<double>(p.origin_x[i])) +
                                 std::abs(static_cast<double>(p.origin_y[i])) +
                                 std::abs(static_cast<double>(p.origin_z[i]));
    const double doubt_m = kFloatAngle * distance_m + kFloatPlace * from_centre_m;
    const auto u = static_cast<double>(p.u[i]);
    const auto v = static_cast<double>(p.v[i]);
    const double least = std::min({u, v, 1.0 - u - v});
    return least * along < doubt_m * longest_side_m * direction_length;
}

// A packet being filled, and the rules that all of its rays share.
struct Batch {
    const RayScene& scene;
    const MotionPiece& piece;
    std::span<const ImageSample> samples;
    RayPacket packet{};
    std::array<Lane, RayPacket::kSize> lanes{};
    std::size_t count = 0;

    void add(std::size_t sample, double time_s) {
        const double u = piece.u_at(time_s);
        const Vector<Scene> o = piece.origin_at(u) - scene.float_centre();
        const Vector<Scene> d = piece.direction_at(u, samples[sample].x, samples[sample].y);
        packet.origin_x[count] = static_cast<float>(o.x);
        packet.origin_y[count] = static_cast<float>(o.y);
        packet.origin_z[count] = static_cast<float>(o.z);
        packet.direction_x[count] = static_cast<float>(d.x);
        packet.direction_y[count] = static_cast<float>(d.y);
        packet.direction_z[count] = static_cast<float>(d.z);
        packet.valid[count] = -1;
        lanes[count++] = {sample, time_s};
    }

    // Calls found(sample, time, triangle) for every lane, with kNone where it sees the sky, and empties the packet.
    template <class Found>
    void trace(const Found& found, TraceCounters& counters) {
        if (count == 0) return;
        for (std::size_t i = count; i < RayPacket::kSize; ++i) packet.valid[i] = 0;
        scene.first_hits(packet);
        counters.rays += count;
        for (std::size_t i = 0; i < count; ++i) {
            TriangleId triangle = packet.triangle[i];
            if (triangle != kNone && is_doubtful(packet, i, scene.longest_side_m())) {
                ++counters.resolved;
                const ImageSample& s = samples[lanes[i].sample];
                triangle = Decision(scene, line_at(piece, s.x, s.y, lanes[i].time_s)).decide(triangle);
            }
            ++counters.segments;
            found(lanes[i].sample, lanes[i].time_s, triangle);
        }
        count = 0;
    }
};

}  // namespace

void DiscreteTracer::trace(const MotionPiece& piece, std::span<const ImageSample> samples,
                           std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    // Neighbouring samples share an exposure, so packets run through the samples for each exposure in turn; the answers
    // are put back into the order of the samples.
    struct Instant {
        TriangleId triangle = kNone;
        double time_s = std::numeric_limits<double>::quiet_NaN();  // stays so where the piece lacks the instant
    };
    std::vector<Instant> instants(samples.size() * exposures.size());
    for (std::size_t e = 0; e < exposures.size(); ++e) {
        Batch batch{*scene_, piece, samples};
        const auto keep = [&](std::size_t sample, double time_s, TriangleId triangle) {
            instants[sample * exposures.size() + e] = {triangle, time_s};
        };
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double time_s = exposures[e].begin_s + samples[i].phase * exposures[e].duration_s();
            if (time_s < piece.when.begin_s || time_s >= piece.when.end_s) continue;
            batch.add(i, time_s);
            if (batch.count == RayPacket::kSize) batch.trace(keep, counters);
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
    Batch batch{*scene_, piece, sample};
    batch.add(0, time_s);
    TriangleId seen = kNone;
    TraceCounters counters;
    batch.trace([&](std::size_t, double, TriangleId triangle) { seen = triangle; }, counters);
    return seen;
}

}  // namespace overfly
