#include "shot/line_deposits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "shot/chain_integral.h"

namespace overfly {
namespace {

// Nodes for each cell of the raster that a run passes. The light of ground that is as different from sample to sample
// as can be has then the error that it has on the full mesh (16 lines: RMSE .0027 and .0020; with 2 it is .0063).
// Of a run over many cells the errors cancel out: from the second on one more for each does as well.
constexpr float kPiecesPerCell = 4.0F, kPiecesAtFirst = 3.0F;
// What is swept faster is a blur that nobody sees the grain of.
constexpr float kMostPieces = 64.0F;

// The sky is smooth, but not near the horizon: pieces are halved until their middles are where straight ones have them,
// up to a share of their light. What is left of the error then is a sixth of that.
constexpr int kPixelsPerSkyPiece = 8, kMostSkyPieces = 32;
constexpr float kSkyError = 1e-3F;

bool is_near(Float4 guess, Float4 sky) {
    for (int c = 0; c < 3; ++c) {
        if (std::abs(guess[c] - sky[c]) > kSkyError * sky[c]) return false;
    }
    return true;
}

// A run that turns its edge to the eye passes nobody knows how many.
int pieces_of(float cells) {
    const float wanted = std::ceil(std::min(kPiecesPerCell * cells, kPiecesAtFirst + cells));
    return wanted > 1.0F ? static_cast<int>(std::min(wanted, kMostPieces)) : 1;
}

}  // namespace

void LineDeposits::add_ground(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to) {
    const SurfaceSegment& seen = *sighting.seen;
    const std::size_t k = count_;
    runs_.x[k] = sighting.x;
    runs_.y[k] = sighting.y;
    runs_.from_u[k] = camera_->u_at(when.begin_s);
    runs_.to_u[k] = camera_->u_at(when.end_s);
    runs_.triangles.set(k, *shader_->mesh_, seen.triangle);
    runs_.in_shadow[k] = seen.in_shadow ? 1 : 0;
    to_[k] = to;
    if (to.shares != nullptr) {
        shares_.resize(GroundRuns::kSize);
        shares_[k] = *to.shares;
        to_[k].shares = &shares_[k];
    }
    if (++count_ == GroundRuns::kSize) flush();
}

bool LineDeposits::add_sky(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to) {
    std::array<Float4, kMostSkyPieces + 1> nodes;
    float alpha = 1.0F;
    std::optional<bool> is_ground;
    // Whether it is like those before: all of the sky, or all of the Earth.
    const auto look = [&](Float4& node, double share) {
        const SceneShader::Behind behind =
            shader_->behind_air(*camera_, {sighting, when.begin_s + when.duration_s() * share});
        if (is_ground.value_or(behind.air.has_value()) != behind.air.has_value()) return false;
        is_ground = behind.air.has_value();
        const Radiance seen = shader_->through_air(behind);
        node = Float4{seen.colour.r, seen.colour.g, seen.colour.b, seen.depth_m};
        alpha = seen.alpha;
        return true;
    };
    std::size_t pieces = static_cast<std::size_t>(std::min(1 + to.count / kPixelsPerSkyPiece, kMostSkyPieces / 2));
    for (std::size_t i = 0; i <= pieces; ++i) {
        if (!look(nodes[i], static_cast<double>(i) / static_cast<double>(pieces))) return false;
    }
    for (bool is_straight = false; !is_straight && 2 * pieces <= kMostSkyPieces; pieces *= 2) {
        is_straight = true;
        for (std::size_t i = pieces; i > 0; --i) nodes[2 * i] = nodes[i];
        for (std::size_t i = 1; i < 2 * pieces; i += 2) {
            if (!look(nodes[i], static_cast<double>(i) / static_cast<double>(2 * pieces))) return false;
            is_straight = is_straight && is_near(0.5F * (nodes[i - 1] + nodes[i + 1]), nodes[i]);
        }
    }
    deposit(std::span(nodes).first(pieces + 1), alpha, to);
    if (facts_.wanted()) add_sky_facts(sighting, when, static_cast<int>(pieces), to);
    return true;
}

void LineDeposits::add_sky_facts(const SceneShader::Sighting& sighting, TimeRange when, int pieces,
                                 const PixelRun& to) {
    for (int i = 0; i <= pieces; ++i) sky_facts_.tell({sighting, when.begin_s + when.duration_s() * i / pieces}, to);
    sky_facts_.deposit(0, static_cast<std::size_t>(pieces) + 1, to);
    sky_facts_.forget();
}

void LineDeposits::flush() {
    follow_ground(*camera_, shader_->daylight_->to_sun(), shader_->lowest_m_, runs_, count_);
    nodes_.clear();
    facts_.forget();
    for (std::size_t k = 0; k < count_; ++k) ask_nodes(k);
    look();
    first_node_[count_] = static_cast<std::uint32_t>(nodes_.size());
    for (std::size_t k = 0; k < count_; ++k) {
        const std::size_t count = first_node_[k + 1] - first_node_[k];
        deposit(std::span(nodes_).subspan(first_node_[k], count), 1.0F, to_[k]);
        if (facts_.wanted()) facts_.deposit(first_node_[k], count, to_[k]);
    }
    facts_.forget();
    count_ = 0;
}

void LineDeposits::ask_nodes(std::size_t run) {
    first_node_[run] = static_cast<std::uint32_t>(nodes_.size() + asked_count_);
    const int pieces = pieces_of(runs_.cells[run]);
    const float step = 1.0F / static_cast<float>(pieces);
    for (int i = 0; i <= pieces; ++i) {
        asked_.run[asked_count_] = static_cast<std::int32_t>(run);
        asked_.v[asked_count_] = static_cast<float>(i) * step;
        if (++asked_count_ == GroundNodes::kSize) look();
    }
}

// At those that were asked.
void LineDeposits::look() {
    look_at_ground(runs_, *shader_->light_, asked_, asked_count_);
    if (facts_.wanted()) facts_.keep_behind(asked_, asked_count_);
    look_through(shader_->daylight_->air(), asked_.views, asked_count_);
    if (facts_.wanted()) facts_.tell(runs_, asked_, asked_count_, to_);
    for (std::size_t i = 0; i < asked_count_; ++i) {
        const Rgb seen = asked_.views.seen(i);
        const float depth_m = asked_.depth_m[i];
        nodes_.push_back(Float4{seen.r, seen.g, seen.b, depth_m > 0.0F ? depth_m : Frame::kNoDepth});
    }
    asked_count_ = 0;
}

// nodes: evenly spaced in v.
void LineDeposits::deposit(std::span<const Float4> nodes, float alpha, const PixelRun& to) const {
    if (to.shares != nullptr) return deposit_shares(nodes, alpha, to);
    deposit_evenly(nodes, alpha, to);
}

void LineDeposits::deposit_evenly(std::span<const Float4> nodes, float alpha, const PixelRun& to) const {
    FilmFrame& film = *films_[to.film];
    const int pieces = static_cast<int>(nodes.size()) - 1;
    ChainIntegral chain(nodes.data(), pieces);
    const auto weight = static_cast<float>(to.weight), per_piece = weight / static_cast<float>(pieces);
    Float4 sum{};
    float depth_m = nodes.front()[3];
    for_each_pixel(to, [&](std::uint32_t pixel, float begin, float end) {
        const auto until = chain(end * static_cast<float>(pieces));
        Float4 light = per_piece * (until.sum - sum);
        light[3] = alpha * weight * (end - begin);
        film.add(pixel, light, std::min(depth_m, until.value[3]));
        sum = until.sum;
        depth_m = until.value[3];
    });
}

void LineDeposits::deposit_shares(std::span<const Float4> nodes, float alpha, const PixelRun& to) const {
    FilmFrame& film = *films_[to.film];
    const auto pieces = static_cast<float>(nodes.size() - 1);
    ChainIntegral chain(nodes.data(), static_cast<int>(nodes.size()) - 1);
    float reached = 0.0F;
    Float4 sum{}, value = nodes.front();
    std::size_t next = 0;
    for (const RunShares::Cell& cell : to.shares->cells) {
        const auto until = chain(cell.end_v * pieces);
        const float length = (cell.end_v - reached) * pieces;
        // A cell may be too short for single precision.
        const Float4 mean = length > 0.0F ? (until.sum - sum) / length : value;
        const Float4 growth = until.value - value;
        const float depth_m = std::min(value[3], until.value[3]);
        for (; next < cell.end_share; ++next) {
            const RunShares::Share& share = to.shares->shares[next];
            Float4 light = share.whole * mean + share.growth * growth;
            light[3] = alpha * share.whole;
            for (const RunShares::Row& row : to.shares->rows) {
                const bool is_inside = share.is_inside && row.is_inside;
                film.add(share.pixel + static_cast<std::uint32_t>(row.offset), row.weight * share.whole,
                         row.weight * light, is_inside ? depth_m : Frame::kNoDepth);
            }
        }
        reached = cell.end_v;
        sum = until.sum;
        value = until.value;
    }
}

}  // namespace overfly
