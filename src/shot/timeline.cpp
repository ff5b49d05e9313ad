#include "shot/timeline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "trace/merge_by_depth.h"
#include "trace/plane_depth.h"
#include "trace/sample_line.h"

namespace overfly {
namespace {

constexpr std::size_t kTrianglesPerTask = 16'384;
// Steps of a record's depths: in each piece, whose motion is quadratic, and in the whole of a long timeline.
constexpr double kMostSteps = 24.0;
constexpr double kStepsInAll = 480.0;
constexpr int kCurveSteps = 48;  // of a curve in a plane, in each piece

// Every triangle is asked: for a single line that takes less time than building a hierarchy, and leaves nothing out.
std::vector<CellRecord> all_records(const SampleLine& line, std::size_t triangles) {
    const std::size_t tasks = (triangles + kTrianglesPerTask - 1) / kTrianglesPerTask;
    std::vector<std::vector<CellRecord>> found(tasks);
    parallel_for(tasks, [&](std::size_t task) {
        const std::size_t end = std::min(triangles, (task + 1) * kTrianglesPerTask);
        for (std::size_t t = task * kTrianglesPerTask; t < end; ++t)
            line.add_records(static_cast<TriangleId>(t), found[task]);
    });
    std::vector<CellRecord> all;
    for (const auto& records : found) all.insert(all.end(), records.begin(), records.end());
    return all;
}

int steps_of(TimeRange part, TimeRange whole) {
    return static_cast<int>(
        std::clamp(std::ceil(kStepsInAll * part.duration_s() / whole.duration_s()), 2.0, kMostSteps));
}

// At the ends exactly the range's own.
double time_of_step(TimeRange range, int k, int steps) {
    return k == steps ? range.end_s : range.begin_s + range.duration_s() * k / steps;
}

// Follows one sample over the surfaces, from piece to piece.
class Follower {
  public:
    Follower(std::span<const TimelineSurface> surfaces, Timeline& timeline)
        : surfaces_(surfaces), timeline_(&timeline) {}

    void run() {
        std::vector<const TriangleMesh*> meshes;
        for (const TimelineSurface& s : surfaces_) meshes.push_back(s.mesh);
        std::vector<SurfaceSegment> seen;
        for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
            std::vector<SurfaceSegment> merged;
            merge_by_depth(seen, follow(s), meshes, timeline_->sample, merged);
            seen = std::move(merged);
        }
        for (const SurfaceSegment& s : seen) add({s.surface, s.triangle}, *s.motion, s.when, timeline_->seen);
    }

  private:
    // What is passed of a surface goes to the timeline; what would be seen of it alone is returned.
    std::vector<SurfaceSegment> follow(std::uint32_t surface) {
        std::vector<SurfaceSegment> nearest;
        const TriangleMesh& mesh = *surfaces_[surface].mesh;
        for (const MotionPiece& piece : surfaces_[surface].motion->pieces_over(timeline_->when)) {
            const TimeRange part = intersection(piece.when, timeline_->when);
            if (part.duration_s() <= 0.0) continue;
            const SampleLine line(mesh, piece, timeline_->sample, part);
            const std::vector<CellRecord> records = all_records(line, mesh.triangles.size());
            for (const CellRecord& r : records) add({surface, r.triangle}, piece, line.when(r), timeline_->passed);
            std::vector<VisibleSegment> segments;
            line.append_segments(line.nearest(records), segments);
            for (const VisibleSegment& v : segments) nearest.push_back({surface, v.triangle, v.when, &piece});
        }
        return nearest;
    }

    // A record goes on from one piece to the next.
    void add(SurfaceTriangle what, const MotionPiece& piece, TimeRange when, std::vector<SightRecord>& out) const {
        const auto earlier = std::ranges::find_if(
            out, [&](const SightRecord& r) { return r.what == what && r.when.end_s == when.begin_s; });
        SightRecord& record = earlier != out.end() ? *earlier : out.emplace_back(SightRecord{what, when, {}});
        record.when.end_s = when.end_s;
        const ImageSample& sample = timeline_->sample;
        const PlaneDepth depth(*surfaces_[what.surface].mesh, what.triangle, piece, sample.x, sample.y);
        const int steps = steps_of(when, timeline_->when);
        for (int k = 0; k <= steps; ++k) {
            const double time_s = time_of_step(when, k, steps);
            const double depth_m = depth.at(piece.u_at(time_s));
            // At an end the line may run within the plane.
            if (std::isfinite(depth_m) && depth_m > 0.0) record.depth.push_back({time_s, depth_m});
        }
    }

    std::span<const TimelineSurface> surfaces_;
    Timeline* timeline_;
};

// Axes in a triangle's plane as seen from above: x to the east, y to the north of it; origin in its middle.
struct PlaneAxes {
    Point<Scene> origin;
    Vector<Scene> x, y;

    PlaneAxes(const TriangleMesh& mesh, TriangleId triangle) {
        const auto& corner = mesh.triangles[triangle];
        const Point<Scene> a = mesh.positions[corner[0]];
        const Vector<Scene> ab = mesh.positions[corner[1]] - a;
        const Vector<Scene> ac = mesh.positions[corner[2]] - a;
        origin = a + (ab + ac) / 3.0;
        Vector<Scene> up = normalized(cross(ab, ac));
        if (up.z < 0.0) up = -up;
        // Of east and north, the one that lies nearer to the plane.
        const bool faces_east = std::abs(up.x) > std::abs(up.y);
        const Vector<Scene> along = faces_east ? Vector<Scene>{0, 1, 0} : Vector<Scene>{1, 0, 0};
        const Vector<Scene> in_plane = normalized(along - dot(along, up) * up);
        x = faces_east ? cross(in_plane, up) : in_plane;
        y = cross(up, x);
    }
    [[nodiscard]] PlanePoint of(Point<Scene> p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

}  // namespace

Timeline trace_timeline(std::span<const TimelineSurface> surfaces, const ImageSample& sample, TimeRange when) {
    Timeline timeline = {sample, when, {}, {}, {}};
    for (const MotionPiece& piece : surfaces.front().motion->pieces_over(when)) {
        const TimeRange part = intersection(piece.when, when);
        if (part.duration_s() > 0.0) timeline.pieces.push_back(part);
    }
    Follower(surfaces, timeline).run();
    std::ranges::stable_sort(timeline.passed, {}, [](const SightRecord& r) { return r.when.begin_s; });
    return timeline;
}

PlaneCurve plane_curve(std::span<const TimelineSurface> surfaces, const Timeline& timeline, SurfaceTriangle what) {
    const TriangleMesh& mesh = *surfaces[what.surface].mesh;
    const PlaneAxes axes(mesh, what.triangle);
    PlaneCurve curve;
    curve.what = what;
    for (std::size_t k = 0; k < 3; ++k) curve.corners[k] = axes.of(mesh.positions[mesh.triangles[what.triangle][k]]);
    bool goes_on = false;
    for (const MotionPiece& piece : surfaces[what.surface].motion->pieces_over(timeline.when)) {
        const TimeRange part = intersection(piece.when, timeline.when);
        if (part.duration_s() <= 0.0) continue;
        const PlaneDepth depth(mesh, what.triangle, piece, timeline.sample.x, timeline.sample.y);
        const auto point_at = [&](double time_s) -> std::optional<CurvePoint> {
            const double u = piece.u_at(time_s);
            const double depth_m = depth.at(u);
            if (!std::isfinite(depth_m) || depth_m <= 0.0) return std::nullopt;
            const Vector<Scene> along = piece.direction_at(u, timeline.sample.x, timeline.sample.y);
            return CurvePoint{time_s, axes.of(piece.origin_at(u) + depth_m * along)};
        };
        for (int k = 0; k <= kCurveSteps; ++k) {
            const auto point = point_at(time_of_step(part, k, kCurveSteps));
            if (point && !goes_on) curve.path.emplace_back();
            if (point) curve.path.back().push_back(*point);
            goes_on = point.has_value();
        }
        for (const auto& c : SampleLine(mesh, piece, timeline.sample, part).crossings(what.triangle)) {
            if (const auto point = point_at(c.time_s))
                (c.on_triangle ? curve.crossings : curve.false_crossings).push_back(*point);
        }
    }
    return curve;
}

}  // namespace overfly
