#include "trace/silhouette_passages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/bracketed_root.h"
#include "trace/kinetic_edge.h"
#include "trace/silhouette_filter.h"

namespace overfly {
namespace {

// Beside an edge, in its own length: more than rounding.
constexpr double kBesideEdge = 1e-6;

// Two ways to find a root of an edge function differ by less than this, in u.
constexpr double kRootSlack = 1e-10;

// Rays in float are off by less than this, in film coordinates (2^-20 as an angle, discrete.cpp, and as much again for
// the lens), and by no more than this along an edge, in its length.
constexpr double kNearBegin = 4e-6;
constexpr double kBesideBegin = 0.01;

class Gathering {
  public:
    Gathering(const KineticPiece& piece, const PieceStretch& stretch, std::span<const ImageSample> samples)
        : piece_(&piece), stretch_(&stretch), samples_(samples) {}

    SilhouettePassages run() {
        const FilmPlaces places(samples_);
        std::vector<PassingPlace> passing;
        for (const std::uint32_t s : piece_->silhouettes_near(film_bounds(samples_))) {
            const Silhouette& silhouette = piece_->silhouettes()[s];
            passing.clear();
            append_passing(silhouette, places, passing);
            // On the film a side form falls by its own gradient for each unit of distance.
            const double u = stretch_->from_u;
            const double gradient =
                std::hypot(value_at<4>(silhouette.across.right, u), value_at<4>(silhouette.across.down, u));
            for (const PassingPlace& p : passing) add_roots(p, silhouette, kNearBegin * gradient);
        }
        std::ranges::sort(found_.in_order, [](const SilhouettePassage& a, const SilhouettePassage& b) {
            if (a.sample != b.sample) return a.sample < b.sample;
            return a.u != b.u ? a.u < b.u : a.half_edge < b.half_edge;
        });
        return std::move(found_);
    }

  private:
    void add_roots(const PassingPlace& passing, const Silhouette& silhouette, double near_begin) {
        const ImageSample& sample = samples_[passing.place];
        const Bernstein<4> side = silhouette.across.at(sample.x, sample.y);
        const double first = value_at<4>(side, stretch_->from_u);
        if (std::abs(first) <= near_begin) add_at_begin(passing.place, silhouette, first);
        const auto guess_u = static_cast<double>(passing.guess_u);
        if (sign_changes<4>(side) == 1 && guess_u >= 0.0 && guess_u <= 1.0) {
            const RootStep step = step_to_root<4>(taylor_at<4>(side, guess_u));
            if (step.is_last) return add(passing.place, silhouette, guess_u + step.h, side[0] < 0.0 || side[4] > 0.0);
        }
        const EdgeSide exact(side);
        for (const double root : exact.roots()) add(passing.place, silhouette, root, exact.sign_after(root) > 0.0);
    }

    // As if the line came to it just now, if it is on the side of what is beside the edge.
    void add_at_begin(std::uint32_t sample, const Silhouette& silhouette, double side) {
        const double u = stretch_->from_u;
        const ImageSample& s = samples_[sample];
        const EdgePoint point = edge_point(piece_->mesh(), silhouette.half_edge, piece_->line_at(u, s.x, s.y));
        const bool is_beside = point.along < -kBesideBegin || point.along > 1.0 + kBesideBegin;
        if (is_beside || !(point.depth > 0.0)) return;
        found_.begins_at_edge.push_back(sample);
        const bool is_covered = side * piece_->facing_sign(silhouette.half_edge / 4, u) >= 0.0;
        if (is_covered) found_.in_order.push_back({sample, u + kRootSlack, silhouette.half_edge, true});
    }

    void add(std::uint32_t sample, const Silhouette& silhouette, double root, bool rises) {
        const bool comes = rises == (piece_->facing_sign(silhouette.half_edge / 4, root) > 0.0);
        const double u = comes ? root + kRootSlack : root - kRootSlack;
        if (u <= stretch_->from_u || u > stretch_->to_u) return;
        const ImageSample& s = samples_[sample];
        const EdgePoint point = edge_point(piece_->mesh(), silhouette.half_edge, piece_->line_at(root, s.x, s.y));
        const bool is_beside = point.along < -kBesideEdge || point.along > 1.0 + kBesideEdge;
        if (point.depth > 0.0 && !is_beside) found_.in_order.push_back({sample, u, silhouette.half_edge, comes});
    }

    const KineticPiece* piece_;
    const PieceStretch* stretch_;
    std::span<const ImageSample> samples_;
    SilhouettePassages found_;
};

}  // namespace

SilhouettePassages silhouette_passages(const KineticPiece& piece, const PieceStretch& stretch,
                                       std::span<const ImageSample> samples) {
    return Gathering(piece, stretch, samples).run();
}

}  // namespace overfly
