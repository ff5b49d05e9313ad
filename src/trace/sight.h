#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "trace/kinetic.h"
#include "trace/sun_blocker.h"
#include "trace/surface_segment.h"
#include "trace/tracer.h"

namespace overfly {

// One thing to see, traced in the frame in which it stands still.
struct Surface {
    const TriangleMesh* mesh = nullptr;
    const Tracer* tracer = nullptr;
    const KineticTracer* kinetic = nullptr;  // that the camera's own lines of sight are followed by instead, if any
    const SunBlocker* blocker = nullptr;     // that finds its shadows; nullptr: it throws none
    bool shades_itself = false;              // whether it throws them on itself too
    bool is_mirror = false;
    FixedPlane mirror{};  // in which all of it lies, if it is one
};

// How all surfaces move relative to one who looks: the camera, or the camera in a mirror (and that in another).
struct Sight {
    std::vector<Motion> motions;      // by surface
    std::uint32_t in_mirror = kNone;  // the surface that sends these rays on; kNone: they start at the camera
    std::vector<Sight> mirrored;      // what is seen in mirrors, one for each mirror that is followed

    // Of the rays relative to the scene itself. REQUIRES: surface 0 is the terrain.
    [[nodiscard]] const MotionPiece& in_scene_at(double time_s) const { return motions.front().piece_at(time_s); }
};

// What all samples of the camera share over a stretch of time.
struct PreparedSight {
    TimeRange when;
    std::vector<std::optional<KineticPiece>> kinetic;  // by surface
};

// Follows samples through a scene of several surfaces: each surface by its own tracer, then whatever is nearer when;
// when and when not the sun reaches it; and what is seen in a mirror by rays that start there.
class SightTracer {
  public:
    // All must outlive the tracer. The surfaces that it asks are those of the sight's motions.
    SightTracer(std::span<const Surface> surfaces, const Sight& sight);

    [[nodiscard]] std::span<const Surface> surfaces() const { return surfaces_; }
    [[nodiscard]] const Sight& sight() const { return *sight_; }

    // For samples within `picture`, during one piece of the terrain's motion.
    // REQUIRES: all motions reach over `when`.
    [[nodiscard]] PreparedSight prepare(TimeRange when, const FilmBounds& picture) const;

    // Appends for each sample what it sees meanwhile. Outside the exposures segments may be missing or cut short.
    void trace(const PreparedSight& prepared, std::span<const ImageSample> samples,
               std::span<const TimeRange> exposures, SurfaceSegmentLists& out, TraceCounters& counters) const;

  private:
    void trace_alone(const PreparedSight& prepared, std::span<const ImageSample> samples,
                     std::span<const TimeRange> exposures, SurfaceSegmentLists& out, TraceCounters& counters) const;

    std::span<const Surface> surfaces_;
    const Sight* sight_;
    std::vector<const TriangleMesh*> meshes_;
};

}  // namespace overfly
