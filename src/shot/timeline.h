#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "trace/visible_segment.h"

namespace overfly {

// What one line of sight meets over a stretch of the flight, worked out from the definitions rather than quickly: every
// triangle that it passes, hidden ones too, what of that is seen, and where on the triangles. Mirrors are seen as
// surfaces, not what they show.

// Something to see, standing still in a scene of its own (trace/surface_segment.h): terrain, or a body.
struct TimelineSurface {
    const TriangleMesh* mesh = nullptr;
    const Motion* motion = nullptr;  // of the rays relative to it
};

struct SurfaceTriangle {
    std::uint32_t surface = 0;
    TriangleId triangle = kNone;

    friend bool operator==(const SurfaceTriangle&, const SurfaceTriangle&) = default;
    friend bool operator<(const SurfaceTriangle& a, const SurfaceTriangle& b) {
        return a.surface != b.surface ? a.surface < b.surface : a.triangle < b.triangle;
    }
};

struct DepthAt {
    double time_s = 0.0, depth_m = 0.0;
};

// From `when.begin_s` to `when.end_s` the line passes through the triangle, before the camera.
struct SightRecord {
    SurfaceTriangle what;
    TimeRange when;
    std::vector<DepthAt> depth;  // from begin to end, close enough to draw; at least two
};

// A point of a triangle's plane in metres, as seen from above the plane: x to the east as far as the plane allows.
struct PlanePoint {
    double x_m = 0.0, y_m = 0.0;
};

struct CurvePoint {
    double time_s = 0.0;
    PlanePoint at;
};

// The curve of intersection (Chapman, Calvert and Dill 1991, section 4): where the moving line meets a triangle's
// plane.
struct PlaneCurve {
    SurfaceTriangle what;
    std::array<PlanePoint, 3> corners;
    std::vector<std::vector<CurvePoint>> path;  // unbroken stretches
    // Where it crosses an edge, and where only the straight line through one: the paper's "false intersections".
    std::vector<CurvePoint> crossings, false_crossings;
};

struct Timeline {
    ImageSample sample;
    TimeRange when;
    std::vector<TimeRange> pieces;    // of the first surface's motion, cut off at the ends of `when`
    std::vector<SightRecord> passed;  // before occlusion, in order of their begin
    std::vector<SightRecord> seen;    // after: in order, without overlap
};

// GUARANTEES: `seen` is what SightTracer sees by IntervalTracers.
// REQUIRES: at least one surface; when lasts for some time, within all motions.
[[nodiscard]] Timeline trace_timeline(std::span<const TimelineSurface> surfaces, const ImageSample& sample,
                                      TimeRange when);

// The curve over the whole time of the timeline.
[[nodiscard]] PlaneCurve plane_curve(std::span<const TimelineSurface> surfaces, const Timeline& timeline,
                                     SurfaceTriangle what);

}  // namespace overfly
