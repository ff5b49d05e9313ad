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
    KineticWalk(const WalkTask& task, const PieceStretch& stretch) : task_(task), stretch_(stretch), steps_(task) {}

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

    WalkTask task_;
    PieceStretch stretch_;
    KineticSteps steps_;
    std::vector<Way> way_;  // of one sample, latest first
};

}  // namespace overfly
