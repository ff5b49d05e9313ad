#pragma once

#include <cstdint>
#include <span>

#include "trace/kinetic_log.h"
#include "trace/kinetic_scene.h"

namespace overfly {

// A sample on its way.
struct Stride {
    double x = 0.0, y = 0.0;      // on the film
    TriangleId triangle = kNone;  // in which it is, seen from the front
    double u = 0.0;               // since when, at most
    double limit_u = 1.0;         // how far it goes
    double stop_u = 0.0;          // where it stopped, about
    RecordId last = kNone;        // in the log
    enum class Stop : std::uint8_t { Limit, Doubt } stop = Stop::Limit;
    bool has_moved = false;  // from one triangle to another, so that u is in single precision
};

// Lets the samples `who` walk from triangle to triangle as long as that is plain: across edges between triangles that
// are seen from the front all through. Each ends at its limit, in the triangle in which it then is, or in Doubt: in the
// last triangle that is certain, with the time since when, where whatever comes next has to be decided with more care.
// Who has come to `enough_u` may end there as at a limit; up to there all is the same to the bit whatever `enough_u`
// is. Times are within a thousandth of a pixel of the edges; all samples get the same answer in any company and from
// every vector unit. REQUIRES: scene.is_ahead of all samples; each is in a triangle that is seen from the front all
// through.
struct StrideTask {
    const StrideScene& scene;
    std::span<Stride> samples;
    std::span<const std::uint32_t> who;
    double enough_u;
};
void stride(const StrideTask& task, StrideLog& log);

}  // namespace overfly
