#pragma once

#include <span>
#include <vector>

#include "trace/kinetic_edge.h"
#include "trace/kinetic_piece.h"
#include "trace/kinetic_stride.h"
#include "trace/ray_scene.h"
#include "trace/silhouette_passages.h"
#include "trace/visible_segment.h"

namespace overfly {

// The samples of a walk (kinetic_walk.h), and what it remembers of them: memory to work in, of no meaning from one walk
// to the next.
struct WalkingSamples {
    // What careful steps remember of a sample.
    struct Care {
        std::uint32_t first_passage = 0, next_passage = 0, end_passage = 0;  // in passages
        RecordId before_stride = kNone;                                      // its last record then
        double stride_u = 0.0;                                               // when it was taken up by stride()
        int stalled = 0;                                                     // steps without progress
        double last_look = 0.0, last_jump = 0.0;
    };
    std::vector<Stride> strides;              // by sample: where it is
    std::vector<Care> cares;                  // by sample
    std::vector<SilhouettePassage> passages;  // by sample, then in the order of time
    StrideLog log;
};

// What is to be walked: all of it outlives the walk.
struct WalkTask {
    const RayScene* scene;
    const TriangleMesh* mesh;  // the scene's
    const KineticPiece* piece;
    std::span<const ImageSample> samples;
    WalkingSamples* walking;
    TraceCounters* counters;
};

// The steps of a walk that are not plain, of one sample at a time, in double: times are roots of the edge functions,
// neighbours share an edge function to the last bit, and what holds just after a time is told by counting roots, so at
// vertices, too, the walk is never between two triangles.
class KineticSteps {
  public:
    using Care = WalkingSamples::Care;

    // All must outlive it. samples: of the walk, by the same numbers.
    explicit KineticSteps(const WalkTask& task) : task_(task) {}

    // All else is about this sample from now on.
    void hold(std::uint32_t sample) { held_ = sample; }

    // To the next time at which what is seen may change, and over it.
    void take_event();
    void step_past(double u);  // until a time
    // Asks a discrete ray what is seen just after a time, from a depth on; but first the triangles around `near`.
    void look_again(double u, double least = 0.0, TriangleId near = kNone);
    // Whether the passage changes what is seen; then it does now.
    [[nodiscard]] bool handle_passage(const SilhouettePassage& passage);
    // Notes that what has been seen was seen until then.
    void emit(double until) {
        Stride& s = task_.walking->strides[held_];
        s.last = task_.walking->log.add(s.last, s.triangle, static_cast<float>(until));
    }

    [[nodiscard]] Line line_at(double u) const;
    // Of the triangles at an edge the one that is nearer beside it, or kNone if the surface does not end there now.
    [[nodiscard]] TriangleId nearer_beside(HalfEdgeId half_edge, double u) const;
    // A passage of whichever sample, no longer a guess.
    const SilhouettePassage& resolved(std::uint32_t passage);

    // How often what was seen next was no neighbour, of all samples.
    [[nodiscard]] std::uint64_t jumps() const { return jumps_; }

  private:
    enum class Reason { End, Side, Turn, Passage };  // why what is seen may change
    struct Event {
        double u = 0.0;
        Reason reason = Reason::End;
        unsigned side = 0;
    };

    [[nodiscard]] const LineOverPiece& held_line();
    void enter(TriangleId triangle, double u);
    [[nodiscard]] Event next_event();
    [[nodiscard]] bool handle_passages(double until);
    void cross(unsigned side, double u);
    void leave_surface(HalfEdgeId half_edge, double u);
    [[nodiscard]] TriangleId nearest_at_edges(TriangleId seen, double u);
    [[nodiscard]] EdgeSide side_of(HalfEdgeId half_edge);
    [[nodiscard]] bool is_inside_but(HalfEdgeId half_edge, double u) const;

    WalkTask task_;
    std::uint64_t jumps_ = 0;

    // Of the sample that is held.
    std::uint32_t held_ = kNone;
    LineOverPiece line_;
    std::uint32_t line_of_ = kNone;  // whose it is
};

}  // namespace overfly
