#include "trace/silhouette_passages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

// What is further from the stretch is left out: nothing in it is as near to that as two guesses may be off, nor is
// looked at together with it (kAboutNow in kinetic_steps.cpp).
constexpr double kOutside = 4.0 * static_cast<double>(kGuessDoubt);

// And what is guessed to be that far off is passed no further off than this.
constexpr double kFurthest = kOutside + 2.0 * static_cast<double>(kGuessDoubt);

// Where a line of sight passes an edge's line.
struct Root {
    double u;
    bool rises;
};

std::optional<SilhouettePassage> passage_at(const KineticPiece& piece, const ImageSample& sample,
                                            const SilhouettePassage& which, Root root) {
    SilhouettePassage passage = which;
    passage.state = SilhouettePassage::State::Exact;
    passage.doubt_u = 0.0;
    passage.comes = root.rises == (piece.facing_sign(which.half_edge / 4, root.u) > 0.0);
    passage.u = passage.comes ? root.u + kRootSlack : root.u - kRootSlack;
    if (passage.u <= 0.0 || passage.u > 1.0) return std::nullopt;
    const EdgePoint point = edge_point(piece.mesh(), which.half_edge, piece.line_at(root.u, sample.x, sample.y));
    const bool is_beside = point.along < -kBesideEdge || point.along > 1.0 + kBesideEdge;
    if (!(point.depth > 0.0) || is_beside) return std::nullopt;
    return passage;
}

class Gathering {
  public:
    Gathering(const KineticPiece& piece, const PieceStretch& stretch, std::span<const ImageSample> samples)
        : piece_(&piece), stretch_(&stretch), samples_(samples) {}

    SilhouettePassages run() {
        const std::vector<KineticPiece::Near> near =
            piece_->silhouettes_near(film_bounds(samples_), stretch_->from_u - kFurthest, stretch_->to_u + kFurthest);
        if (!near.empty()) gather(near);
        if (!mixed_.empty()) by_sample();
        return std::move(found_);
    }

  private:
    void gather(std::span<const KineticPiece::Near> near) {
        const FilmPlaces places(samples_);
        std::vector<PassingPlace> passing;
        for (const auto& [s, film] : near) {
            const Silhouette& silhouette = piece_->silhouettes()[s];
            passing.clear();
            append_passing(silhouette, film, stretch_->from_u, places, passing);
            for (const PassingPlace& p : passing) {
                SilhouettePassage which;
                which.sample = p.place;
                which.silhouette = s;
                which.u = static_cast<double>(p.guess_u);
                which.doubt_u = static_cast<double>(p.doubt_u);
                which.half_edge = silhouette.half_edge;
                which.state = SilhouettePassage::State::Guess;
                if (p.once) {
                    if (is_about(which.u)) mixed_.push_back(which);
                } else {
                    add_exact(which, silhouette);
                }
            }
        }
    }

    [[nodiscard]] bool is_about(double u) const {
        return u > stretch_->from_u - kOutside && u < stretch_->to_u + kOutside;
    }

    void add_exact(const SilhouettePassage& which, const Silhouette& silhouette) {
        const ImageSample& sample = samples_[which.sample];
        const Bernstein<4> side = silhouette.across.at(sample.x, sample.y);
        // On the film a side form falls by its own gradient for each unit of distance.
        const double u0 = stretch_->from_u;
        const double gradient =
            std::hypot(value_at<4>(silhouette.across.right, u0), value_at<4>(silhouette.across.down, u0));
        const double first = value_at<4>(side, u0);
        if (std::abs(first) <= kNearBegin * gradient) add_at_begin(which, first);
        const EdgeSide exact(side);
        for (const double u : exact.roots()) {
            const auto passage = passage_at(*piece_, sample, which, {u, exact.sign_after(u) > 0.0});
            if (passage && is_about(u)) mixed_.push_back(*passage);
        }
    }

    // As if the line came to it just now, if it is on the side of what is beside the edge.
    void add_at_begin(const SilhouettePassage& which, double side) {
        const ImageSample& s = samples_[which.sample];
        const double u = stretch_->from_u;
        const EdgePoint point = edge_point(piece_->mesh(), which.half_edge, piece_->line_at(u, s.x, s.y));
        const bool is_beside = point.along < -kBesideBegin || point.along > 1.0 + kBesideBegin;
        if (is_beside || !(point.depth > 0.0)) return;
        found_.begins_at_edge.push_back(which.sample);
        if (side * piece_->facing_sign(which.half_edge / 4, u) < 0.0) return;
        SilhouettePassage passage = which;
        passage.u = u + kRootSlack;
        passage.doubt_u = 0.0;
        passage.comes = true;
        passage.state = SilhouettePassage::State::Exact;
        mixed_.push_back(passage);
    }

    // Counts how many each sample has, puts them there, and sorts the few of each.
    void by_sample() {
        std::vector<std::uint32_t> ends(samples_.size() + 1, 0);
        for (const SilhouettePassage& p : mixed_) ++ends[p.sample + 1];
        for (std::size_t i = 0; i < samples_.size(); ++i) ends[i + 1] += ends[i];
        found_.in_order.resize(mixed_.size());
        std::vector<std::uint32_t> next = ends;
        for (const SilhouettePassage& p : mixed_) found_.in_order[next[p.sample]++] = p;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            put_in_order(std::span(found_.in_order).subspan(ends[i], ends[i + 1] - ends[i]));
    }

    void put_in_order(std::span<SilhouettePassage> of_one) const {
        if (of_one.size() < 2) return;
        const auto is_sooner = [](const SilhouettePassage& a, const SilhouettePassage& b) {
            return a.u != b.u ? a.u < b.u : a.half_edge < b.half_edge;
        };
        std::ranges::sort(of_one, is_sooner);
        bool any = false;
        for (std::size_t k = 0; k + 1 < of_one.size(); ++k) {
            if (of_one[k + 1].u - of_one[k].u > of_one[k + 1].doubt_u + of_one[k].doubt_u) continue;
            for (SilhouettePassage* p : {&of_one[k], &of_one[k + 1]}) {
                any = any || p->state == SilhouettePassage::State::Guess;
                to_sort_.push_back(p);
            }
        }
        for (SilhouettePassage* p : to_sort_) resolve(*piece_, samples_[p->sample], *p);
        to_sort_.clear();
        if (any) std::ranges::sort(of_one, is_sooner);
    }

    const KineticPiece* piece_;
    const PieceStretch* stretch_;
    std::span<const ImageSample> samples_;
    std::vector<SilhouettePassage> mixed_;
    mutable std::vector<SilhouettePassage*> to_sort_;
    SilhouettePassages found_;
};

}  // namespace

SilhouettePassages silhouette_passages(const KineticPiece& piece, const PieceStretch& stretch,
                                       std::span<const ImageSample> samples) {
    return Gathering(piece, stretch, samples).run();
}

void resolve(const KineticPiece& piece, const ImageSample& sample, SilhouettePassage& passage) {
    if (passage.state != SilhouettePassage::State::Guess) return;
    const Bernstein<4> side = piece.silhouettes()[passage.silhouette].across.at(sample.x, sample.y);
    const RootStep step = step_to_root<4>(taylor_at<4>(side, passage.u));
    Root root = {passage.u + step.h, side[0] < 0.0 || side[4] > 0.0};
    if (!step.is_last) {
        const EdgeSide exact(side);
        double nearest = std::numeric_limits<double>::infinity();
        for (const double u : exact.roots()) {
            if (std::abs(u - passage.u) >= nearest) continue;
            nearest = std::abs(u - passage.u);
            root = {u, exact.sign_after(u) > 0.0};
        }
    }
    const auto found = passage_at(piece, sample, passage, root);
    if (found) {
        passage = *found;
    } else {
        passage.state = SilhouettePassage::State::None;
        passage.doubt_u = 0.0;
    }
}

}  // namespace overfly
