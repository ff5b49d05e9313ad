#include "shade/sky_runs.h"

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

// The sky is smooth, but not near the horizon: pieces are halved until their middles are where straight ones have them,
// up to a share of their light. What is left of the error then is a sixth of that.
constexpr int kPixelsPerPiece = 8, kMostPieces = 32;
constexpr float kError = 1e-3F;

bool is_near(Float4 guess, Float4 sky) {
    for (int c = 0; c < 3; ++c) {
        if (std::abs(guess[c] - sky[c]) > kError * sky[c]) return false;
    }
    return true;
}

// Halved once: the middles are looked at in any case.
std::size_t pieces_at_first(int pixels) {
    return 2 * static_cast<std::size_t>(std::min(1 + pixels / kPixelsPerPiece, kMostPieces / 2));
}

}  // namespace

std::size_t SkyRuns::add(const Run& run) {
    runs_[count_] = run;
    return count_++;
}

void SkyRuns::begin_chains() {
    nodes_.clear();
    for (std::size_t k = 0; k < count_; ++k) {
        chains_[k] = {nodes_.size(), pieces_at_first(runs_[k].pixels), 0};
        nodes_.resize(nodes_.size() + chains_[k].pieces + 1);
    }
}

void SkyRuns::leave_dark() {
    begin_chains();
    std::ranges::fill(nodes_, Float4{0.0F, 0.0F, 0.0F, depth_});
}

void SkyRuns::follow() {
    begin_chains();
    bent_.clear();
    for (std::size_t k = 0; k < count_; ++k) {
        bent_.push_back(k);
        for (std::size_t i = 0; i <= chains_[k].pieces; ++i) ask(k, i);
    }
    while (!bent_.empty()) {
        look();
        std::erase_if(bent_, [&](std::size_t k) {
            return !is_smooth(k) || 2 * chains_[k].pieces > kMostPieces || is_straight(chains_[k]);
        });
        for (const std::size_t k : bent_) halve_pieces(k);
    }
}

// As far as every other node tells.
bool SkyRuns::is_straight(const Chain& chain) const {
    const Float4* const nodes = nodes_.data() + chain.first;
    for (std::size_t i = 1; i < chain.pieces; i += 2) {
        if (!is_near(0.5F * (nodes[i - 1] + nodes[i + 1]), nodes[i])) return false;
    }
    return true;
}

void SkyRuns::halve_pieces(std::size_t run) {
    Chain& chain = chains_[run];
    const std::size_t from = chain.first;
    chain.first = nodes_.size();
    chain.pieces *= 2;
    nodes_.resize(nodes_.size() + chain.pieces + 1);
    for (std::size_t i = 0; i <= chain.pieces; i += 2) nodes_[chain.first + i] = nodes_[from + i / 2];
    for (std::size_t i = 1; i < chain.pieces; i += 2) ask(run, i);
}

void SkyRuns::ask(std::size_t run, std::size_t node) {
    const Run& of = runs_[run];
    const double v = static_cast<double>(node) / static_cast<double>(chains_[run].pieces);
    asked_.x[asked_count_] = of.x;
    asked_.y[asked_count_] = of.y;
    asked_.u[asked_count_] = of.from_u + v * (of.to_u - of.from_u);
    whose_[asked_count_] = {static_cast<std::uint32_t>(run), static_cast<std::uint32_t>(chains_[run].first + node)};
    if (++asked_count_ == SkyNodes::kSize) look();
}

// At those that were asked.
void SkyRuns::look() {
    look_at_sky(*scene_, *day_, *light_, asked_, asked_count_);
    for (std::size_t i = 0; i < asked_count_; ++i) {
        const Rgb seen = asked_.views.seen(i);
        nodes_[whose_[i].node] = Float4{seen.r, seen.g, seen.b, depth_};
        chains_[whose_[i].run].on_earth += static_cast<std::size_t>(asked_.is_earth[i]);
    }
    asked_count_ = 0;
}

}  // namespace overfly
