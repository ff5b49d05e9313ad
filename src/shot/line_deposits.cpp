#include "shot/line_deposits.h"

#include <algorithm>
#include <cmath>

#include "shot/chain_integral.h"

namespace overfly {
namespace {

// Nodes for each cell of the raster that a run passes. The light of ground that is as different from sample to sample
// as can be has then the error that it has on the full mesh (16 lines: RMSE .0027 and .0020; with 2 it is .0063).
// Of a run over many cells the errors cancel out: from the second on one more for each does as well.
constexpr float kPiecesPerCell = 4.0F, kPiecesAtFirst = 3.0F;
// What is swept faster is a blur that nobody sees the grain of.
constexpr float kMostPieces = 64.0F;

// Nothing in the fourth place.
Float4 colour_of(Float4 v) {
    constexpr Int4 kColour = {-1, -1, -1, 0};
    return reinterpret_cast<Float4>(reinterpret_cast<Int4>(v) & kColour);  // of vectors: the same bits
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
    to_.set(k, to);
    if (++count_ == GroundRuns::kSize) flush_ground();
}

void LineDeposits::add_sky(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to) {
    const std::size_t k = skies_.add(
        {sighting.x, sighting.y, camera_->u_at(when.begin_s), camera_->u_at(when.end_s), static_cast<int>(to.count)});
    sky_sightings_[k] = sighting;
    sky_times_[k] = when;
    to_of_sky_.set(k, to);
    if (skies_.count() == SkyRuns::kSize) flush_sky();
}

void LineDeposits::Targets::set(std::size_t k, const PixelRun& to) {
    to_[k] = to;
    if (to.shares == nullptr) return;
    shares_.resize(to_.size());
    shares_[k] = *to.shares;
    to_[k].shares = &shares_[k];
}

void LineDeposits::flush() {
    flush_ground();
    flush_sky();
}

void LineDeposits::flush_sky() {
    const bool is_transparent = shader_->transparent_sky_;
    if (is_transparent) {
        skies_.leave_dark();
    } else {
        skies_.follow();
    }
    for (std::size_t k = 0; k < skies_.count(); ++k) {
        if (!skies_.is_smooth(k)) {
            left_over_.push_back(skies_before_ + k);
            continue;
        }
        deposit(skies_.nodes(k), is_transparent ? 0.0F : 1.0F, to_of_sky_[k]);
        if (facts_.wanted()) deposit_sky_facts(k);
    }
    skies_before_ += skies_.count();
    skies_.clear();
}

void LineDeposits::deposit_sky_facts(std::size_t run) {
    const std::size_t nodes = skies_.nodes(run).size();
    const TimeRange when = sky_times_[run];
    for (std::size_t i = 0; i < nodes; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(nodes - 1);
        sky_facts_.tell({sky_sightings_[run], when.begin_s + when.duration_s() * share}, to_of_sky_[run]);
    }
    sky_facts_.deposit(0, nodes, to_of_sky_[run]);
    sky_facts_.forget();
}

void LineDeposits::flush_ground() {
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
    if (facts_.wanted()) facts_.tell(runs_, asked_, asked_count_, to_.all());
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
    const auto pieces = static_cast<float>(nodes.size() - 1), weight = static_cast<float>(to.weight);
    ChainIntegral chain(nodes.data(), static_cast<int>(nodes.size()) - 1);
    const float per_piece = weight / pieces;
    const Float4 of_alpha = {0.0F, 0.0F, 0.0F, alpha * weight};
    float depth_m = nodes.front()[3];
    for_each_pixel(to, [&](std::uint32_t pixel, float begin, float end) {
        const auto until = chain(end * pieces);
        film.add(pixel, colour_of(per_piece * until.more) + (end - begin) * of_alpha,
                 std::min(depth_m, until.value[3]));
        depth_m = until.value[3];
    });
}

void LineDeposits::deposit_shares(std::span<const Float4> nodes, float alpha, const PixelRun& to) const {
    FilmFrame& film = *films_[to.film];
    const auto pieces = static_cast<float>(nodes.size() - 1);
    ChainIntegral chain(nodes.data(), static_cast<int>(nodes.size()) - 1);
    float reached = 0.0F;
    Float4 value = nodes.front();
    std::size_t next = 0;
    for (const RunShares::Cell& cell : to.shares->cells) {
        const auto until = chain(cell.end_v * pieces);
        const float length = (cell.end_v - reached) * pieces;
        // A cell may be too short for single precision.
        const Float4 mean = length > 0.0F ? until.more / length : value;
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
        value = until.value;
    }
}

}  // namespace overfly
