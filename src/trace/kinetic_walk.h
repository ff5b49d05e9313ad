#pragma once

#include <span>
#include <vector>

#include "trace/kinetic_piece.h"
#include "trace/kinetic_steps.h"
#include "trace/kinetic_stride.h"
#include "trace/ray_scene.h"
#include "trace/visible_segment.h"

namespace overfly {

// Follows the samples of a small part of the film through a motion piece (design 3.4): from the triangle that each sees
// to the one that it sees next, at the earliest of
// - the exit across a side: into the neighbour, or, if the surface ends there, to what a discrete ray finds behind it;
// - the passage of a silhouette edge in front of it: those are looked for in what a sample has walked, and the walk
//   goes back to the first that matters;
// - the camera's own passage through the surface, when a discrete ray decides.
// What is plain is done by stride(), everything else by KineticSteps; here is who goes on by which.
class KineticWalk {
  public:
    KineticWalk(const RayScene& scene, const KineticPiece& piece, const PieceStretch& stretch,
                std::span<const ImageSample> samples, WalkingSamples& walking, TraceCounters& counters)
        : scene_(&scene),
          mesh_(&scene.mesh()),
          piece_(&piece),
          stretch_(stretch),
          counters_(&counters),
          samples_(samples),
          strides_(walking.strides),
          cares_(walking.cares),
          passages_(walking.passages),
          log_(walking.log),
          steps_(scene, piece, samples, walking, counters) {}

    // Appends what the samples see. Once.
    void follow(SegmentLists& out);

  private:
    using Care = WalkingSamples::Care;
    // A part of what stride() walked.
    struct Way {
        TriangleId triangle;
        double since_u, until_u;
        RecordId before;
    };

    void begin();
    void find_starts();
    void find_passages();
    void begin_carefully(std::uint32_t sample);
    void stride_on(std::span<const std::uint32_t> walking);
    [[nodiscard]] double next_stop(double u) const;
    [[nodiscard]] bool is_through(std::uint32_t sample) const;
    [[nodiscard]] bool is_plain(std::uint32_t sample) const;
    void settle(std::uint32_t sample);
    [[nodiscard]] bool is_disturbed(std::uint32_t sample);
    [[nodiscard]] bool leaves_silhouette(std::uint32_t sample);
    void retrace(std::uint32_t sample);
    [[nodiscard]] bool is_hidden(const SilhouettePassage& passage) const;
    void settle_doubt(Stride& s);

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
    KineticSteps steps_;
    std::vector<Way> way_;  // of one sample, latest first
};

}  // namespace overfly
