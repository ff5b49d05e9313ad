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

// Follows the samples of a small part of the film through a motion piece (design 3.4): from the triangle that each sees
// to the one that it sees next, at the earliest of
// - the exit across a side: into the neighbour, or, if the surface ends there, to what a discrete ray finds behind it;
// - the passage of a silhouette edge in front of it: those are looked for in what a sample has walked, and the walk
// goes
//   back to the first that matters;
// - the camera's own passage through the surface, when a discrete ray decides.
// What is plain is done by stride(); everything else here, in double: times are roots of the edge functions, neighbours
// share an edge function to the last bit, and what holds just after a time is told by counting roots, so at vertices,
// too, the walk is never between two triangles.
class KineticWalk {
  public:
    // What the careful steps remember of a sample.
    struct Care {
        std::uint32_t first_passage = 0, next_passage = 0, end_passage = 0;  // in passages_
        RecordId before_stride = kNone;                                      // its last record then
        double stride_u = 0.0;                                               // when it was taken up by stride()
        int stalled = 0;                                                     // steps without progress
        double last_look = 0.0, last_jump = 0.0;
    };

    // Memory to work in, of no meaning from one walk to the next.
    struct Scratch {
        std::vector<Stride> strides;              // by sample: where it is
        std::vector<Care> cares;                  // by sample
        std::vector<SilhouettePassage> passages;  // by sample, then in the order of time
        StrideLog log;
    };

    KineticWalk(const RayScene& scene, const KineticPiece& piece, const PieceStretch& stretch, Scratch& scratch,
                TraceCounters& counters)
        : scene_(&scene),
          mesh_(&scene.mesh()),
          piece_(&piece),
          stretch_(stretch),
          counters_(&counters),
          strides_(scratch.strides),
          cares_(scratch.cares),
          passages_(scratch.passages),
          log_(scratch.log) {}

    // Appends what the samples see. `seen`, if there is any, tells for each what it sees at the begin of the stretch
    // (kNotKnown: to be found out) and then what it sees at the end of the stretch.
    void follow(std::span<const ImageSample> samples, std::span<TriangleId> seen, SegmentLists& out);

  private:
    enum class Reason { End, Side, Turn, Passage };  // why what is seen may change
    struct Event {
        double u = 0.0;
        Reason reason = Reason::End;
        unsigned side = 0;
    };
    // A part of what stride() walked.
    struct Way {
        TriangleId triangle;
        double since_u, until_u;
        RecordId before;
    };

    void begin(std::span<const ImageSample> samples, std::span<TriangleId> seen);
    void find_starts(std::span<const ImageSample> samples, std::span<TriangleId> seen);
    void find_passages(std::span<const ImageSample> samples);
    void begin_carefully(std::uint32_t sample);
    void stride_on(std::span<const std::uint32_t> walking);
    [[nodiscard]] double next_stop(double u) const;
    [[nodiscard]] bool is_through(std::uint32_t sample) const;
    [[nodiscard]] bool is_plain(std::uint32_t sample) const;
    [[nodiscard]] bool is_disturbed(std::uint32_t sample);
    [[nodiscard]] bool leaves_silhouette(const Stride& s);
    void retrace(std::uint32_t sample);
    [[nodiscard]] bool is_hidden(const SilhouettePassage& passage) const;
    const SilhouettePassage& resolved(std::uint32_t passage);
    void settle(std::uint32_t sample);
    void settle_doubt(Stride& s);
    void step_past(double u);

    void hold(std::uint32_t sample);
    [[nodiscard]] const LineOverPiece& held_line();
    void enter(TriangleId triangle, double u);
    void take_event();
    [[nodiscard]] Event next_event();
    [[nodiscard]] bool handle_passages(double until);
    [[nodiscard]] bool handle_passage(const SilhouettePassage& passage);
    void cross(unsigned side, double u);
    void leave_surface(HalfEdgeId half_edge, double u);
    void look_again(double u, double least = 0.0, TriangleId near = kNone);
    [[nodiscard]] TriangleId nearest_at_edges(TriangleId seen, double u);
    void emit(double until);

    [[nodiscard]] EdgeSide side_of(HalfEdgeId half_edge);
    [[nodiscard]] Line line_at(double u) const;
    [[nodiscard]] TriangleId nearer_beside(HalfEdgeId half_edge, double u) const;
    [[nodiscard]] bool is_inside_but(HalfEdgeId half_edge, double u) const;

    const RayScene* scene_;
    const TriangleMesh* mesh_;
    const KineticPiece* piece_;
    PieceStretch stretch_;
    TraceCounters* counters_;

    std::span<const ImageSample> samples_;
    std::vector<Stride>& strides_;
    std::vector<Care>& cares_;
    std::vector<SilhouettePassage>& passages_;
    StrideLog& log_;
    std::uint64_t jumps_ = 0;  // from what is seen to what is no neighbour
    std::vector<Way> way_;     // of one sample, latest first

    // Of the sample that is held.
    std::uint32_t held_ = kNone;
    LineOverPiece line_;
    std::uint32_t line_of_ = kNone;  // whose it is
};

}  // namespace overfly
