#include "trace/kinetic_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trace/kinetic_look.h"
#include "trace/kinetic_start.h"

namespace overfly {
namespace {

// A discrete ray looks this much later than an edge is left, in u: far enough that double tells the two apart, and for
// an image that moves by 100 pixels in a piece a ten-millionth of a pixel. Where it does not help (hardly anything
// moves), the next look is a thousand times as far ahead, up to the longest.
constexpr double kJump = 1e-9;
constexpr double kJumpGrowth = 1e3;
constexpr double kLongestJump = 1e-3;

// Behind an edge, relative to its depth: floats can tell. Only near the edge's ends, in its length, is anything of the
// same surface as close behind.
constexpr double kBehind = 1.0 + 1e-6;
constexpr double kCorner = 0.05;

// Passages this near to a look, in u, are such as a ray in float may get wrong.
constexpr double kAboutNow = 1e-3;

// Nearer than what is seen, relative to its depth: more than rounding.
constexpr double kNearer = 1.0 - 1e-9;

// A stride that comes to a silhouette is at it within this, in u.
constexpr double kAboutStop = 1e-5;

// Where a stride gave up, careful steps go on for at least as long, in u: longer than a stride's times are off.
constexpr double kStep = 1e-6;

// More triangles than this meet at no vertex that a walk could circle.
constexpr int kMostStalled = 64;

bool is_after(const SilhouettePassage& passage, double u) { return passage.u - passage.doubt_u > u; }

}  // namespace

void KineticWalk::follow(std::span<const ImageSample> samples, std::span<TriangleId> seen, SegmentLists& out) {
    begin(samples, seen);
    std::vector<std::uint32_t> walking;
    std::vector<std::uint32_t> still;
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        if (!is_plain(i)) begin_carefully(i);
        if (strides_[i].u < stretch_.to_u) walking.push_back(i);
    }
    while (!walking.empty()) {
        stride_on(walking);
        still.clear();
        for (const std::uint32_t i : walking) {
            // Most are through.
            const bool has_passages = cares_[i].next_passage < cares_[i].end_passage;
            if (is_through(i) && !has_passages) continue;
            settle(i);
            if (!is_through(i) && strides_[i].u < stretch_.to_u) still.push_back(i);
        }
        std::swap(walking, still);
    }
    std::uint64_t changes = 0;
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        hold(i);
        emit(stretch_.to_u);
        changes += log_.write(stretch_, strides_[i].last, out) - 1;
        if (!seen.empty()) seen[i] = strides_[i].triangle;
    }
    counters_->crossings += changes - std::min(changes, jumps_);
}

void KineticWalk::begin(std::span<const ImageSample> samples, std::span<TriangleId> seen) {
    samples_ = samples;
    strides_.resize(samples.size());
    cares_.assign(samples.size(), {});
    log_.count = 0;
    line_of_ = kNone;
    find_starts(samples, seen);
    find_passages(samples);
}

// By rays for all, or for those of which it is not known.
void KineticWalk::find_starts(std::span<const ImageSample> samples, std::span<TriangleId> seen) {
    std::vector<TriangleId> found(seen.begin(), seen.end());
    found.resize(samples.size(), kNotKnown);
    counters_->restarts += static_cast<std::uint64_t>(std::ranges::count(found, kNotKnown));
    look_roughly(*scene_, piece_->motion(), stretch_.from_u, samples, found);
    for (std::size_t i = 0; i < samples.size(); ++i)
        strides_[i] = {samples[i].x, samples[i].y, found[i], stretch_.from_u};
}

void KineticWalk::find_passages(std::span<const ImageSample> samples) {
    SilhouettePassages found = silhouette_passages(*piece_, stretch_, samples);
    passages_ = std::move(found.in_order);
    for (const std::uint32_t i : found.begins_at_edge) strides_[i].triangle = kNotKnown;  // not for long
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        cares_[i].first_passage = cares_[i].next_passage = at;
        while (at < passages_.size() && passages_[at].sample == i) ++at;
        cares_[i].end_passage = at;
    }
}

// What stride() can't follow is set down in double.
void KineticWalk::begin_carefully(std::uint32_t sample) {
    hold(sample);
    Stride& s = strides_[sample];
    const bool is_certain =
        s.triangle == kNone || (s.triangle != kNotKnown && edge_values(*mesh_, s.triangle, line_at(s.u)).inside());
    if (!is_certain) s.triangle = look(*scene_, line_at(s.u));
    while (s.u < stretch_.to_u && !is_plain(sample)) take_event();
}

void KineticWalk::stride_on(std::span<const std::uint32_t> walking) {
    for (const std::uint32_t i : walking) {
        strides_[i].limit_u = next_stop(strides_[i].u);
        cares_[i].before_stride = strides_[i].last;
        cares_[i].stride_u = strides_[i].u;
    }
    stride({piece_->stride_scene(), strides_, walking, stretch_.to_u}, log_);
}

// When a sample that walks has to be looked at next.
double KineticWalk::next_stop(double u) const {
    const auto surface = std::ranges::upper_bound(piece_->surface_passages(), u);
    return surface != piece_->surface_passages().end() ? *surface : 1.0;
}

bool KineticWalk::is_through(std::uint32_t sample) const {
    const Stride& s = strides_[sample];
    return s.stop == Stride::Stop::Limit && s.limit_u >= stretch_.to_u;
}

// Whether stride() can take the sample further.
bool KineticWalk::is_plain(std::uint32_t sample) const {
    const TriangleId triangle = strides_[sample].triangle;
    return piece_->is_ahead() && triangle < kNotKnown && piece_->facing(triangle) == Facing::Front;
}

// Takes care of why a sample does not walk, until it can or is at the end.
void KineticWalk::settle(std::uint32_t sample) {
    hold(sample);
    Stride& s = strides_[sample];
    if (is_disturbed(sample) || leaves_silhouette(s)) {
        s.stop = Stride::Stop::Doubt;  // not where stride() left it
    } else if (is_through(sample)) {
        return;
    } else if (s.stop == Stride::Stop::Doubt) {
        settle_doubt(s);
    } else {
        s.u = s.limit_u;
        look_again(s.u);
    }
    while (s.u < stretch_.to_u && !is_plain(sample)) take_event();
}

// Whether a passage changes what stride() has walked. Then the sample has gone back to it.
bool KineticWalk::is_disturbed(std::uint32_t sample) {
    Care& care = cares_[sample];
    Stride& s = strides_[sample];
    const double until = s.stop == Stride::Stop::Doubt ? s.stop_u : std::min(s.limit_u, stretch_.to_u);
    if (care.next_passage == care.end_passage || is_after(passages_[care.next_passage], until)) return false;
    retrace(sample);
    const Stride walked = s;
    while (care.next_passage < care.end_passage) {
        const std::uint32_t next = care.next_passage;
        if (is_after(passages_[next], until)) break;
        while (way_.size() > 1 && way_.back().until_u < passages_[next].u - passages_[next].doubt_u) way_.pop_back();
        if (!is_hidden(passages_[next])) {
            const SilhouettePassage& passage = resolved(next);
            if (passage.u > until) break;
            while (way_.size() > 1 && way_.back().until_u < passage.u) way_.pop_back();
            s.triangle = way_.back().triangle;
            s.u = way_.back().since_u;
            s.last = way_.back().before;
            ++care.next_passage;
            if (passage.state != SilhouettePassage::State::None && passage.u > s.u && handle_passage(passage))
                return true;
            s = walked;
        } else {
            ++care.next_passage;
        }
    }
    return false;
}

// Whether stride() stopped because the surface ends at a silhouette that is known. Then the sample has left it.
bool KineticWalk::leaves_silhouette(const Stride& s) {
    Care& care = cares_[held_];
    if (s.stop != Stride::Stop::Doubt || care.next_passage == care.end_passage) return false;
    if (is_after(passages_[care.next_passage], s.stop_u + kAboutStop)) return false;
    const SilhouettePassage& passage = resolved(care.next_passage);
    const bool is_at_it = std::abs(passage.u - s.stop_u) < kAboutStop && passage.u > s.u;
    if (passage.state == SilhouettePassage::State::None || passage.comes || !is_at_it) return false;
    if (nearer_beside(passage.half_edge, passage.u) != s.triangle) return false;
    ++care.next_passage;
    return handle_passage(passage);
}

// What stride() has walked with the sample, latest first.
void KineticWalk::retrace(std::uint32_t sample) {
    const Stride& s = strides_[sample];
    const Care& care = cares_[sample];
    const bool doubts = s.stop == Stride::Stop::Doubt;
    way_.clear();
    Way way = {s.triangle, s.u, doubts ? s.stop_u : std::min(s.limit_u, stretch_.to_u), s.last};
    while (way.before != care.before_stride) {
        const RecordId record = way.before;
        way.since_u = static_cast<double>(log_.until_u[record]);
        way_.push_back(way);
        way = {log_.triangle[record], 0.0, way.since_u, log_.before[record]};
    }
    way.since_u = care.stride_u;
    way_.push_back(way);
}

// Whether the edge is surely behind all that is seen at about the passage. The way is at the begin of that.
bool KineticWalk::is_hidden(const SilhouettePassage& passage) const {
    const double until = passage.u + passage.doubt_u;
    if (until > way_.front().until_u) return false;
    const Silhouette& silhouette = piece_->silhouettes()[passage.silhouette];
    for (auto way = way_.rbegin(); way != way_.rend() && way->since_u <= until; ++way) {
        if (!piece_->hides(way->triangle, silhouette, passage.u)) return false;
    }
    return true;
}

const SilhouettePassage& KineticWalk::resolved(std::uint32_t passage) {
    resolve(*piece_, samples_[passages_[passage].sample], passages_[passage]);
    return passages_[passage];
}

// Careful steps from shortly before it stopped: what it has walked before that stays as it is.
void KineticWalk::settle_doubt(Stride& s) {
    const double at = std::max(s.has_moved ? s.u + kStep : s.u, s.stop_u - kStep);
    const double until = s.stop_u + kStep;
    if (at == stretch_.from_u) {
        // Where it began was known roughly.
        s.triangle = look(*scene_, line_at(at));
    } else if (!edge_values(*mesh_, s.triangle, line_at(at)).inside()) {
        // The stride went astray, or leaves right away.
        ++counters_->restarts;
        return look_again(at);
    }
    s.u = at;
    step_past(until);
}

// Careful steps until a time.
void KineticWalk::step_past(double u) {
    while (strides_[held_].u < std::min(u, 1.0)) take_event();
}

// The careful steps are about this sample from now on.
void KineticWalk::hold(std::uint32_t sample) { held_ = sample; }

const LineOverPiece& KineticWalk::held_line() {
    if (line_of_ != held_) line_ = piece_->lines().at(strides_[held_].x, strides_[held_].y);
    line_of_ = held_;
    return line_;
}

// The sample sees the triangle from now on.
void KineticWalk::enter(TriangleId triangle, double u) {
    Stride& s = strides_[held_];
    cares_[held_].stalled = u == s.u ? cares_[held_].stalled + 1 : 0;
    s.triangle = triangle;
    s.u = u;
}

void KineticWalk::take_event() {
    const Event event = next_event();
    if (handle_passages(event.u)) return;
    if (event.reason == Reason::Side) {
        cross(event.side, event.u);
    } else if (event.reason == Reason::End) {
        strides_[held_].u = 1.0;
    } else {
        look_again(event.u);
    }
}

KineticWalk::Event KineticWalk::next_event() {
    const Stride& s = strides_[held_];
    Event event = {1.0, Reason::End, 0};
    const auto passages = piece_->surface_passages();
    const auto passage = std::ranges::upper_bound(passages, s.u);
    if (passage != passages.end() && *passage < event.u) event = {*passage, Reason::Passage, 0};
    if (s.triangle == kNone) return event;
    if (piece_->facing(s.triangle) == Facing::Changes) {
        for (const double u : sign_change_roots<2>(height_over_plane(*mesh_, s.triangle, piece_->motion()))) {
            if (u > s.u && u < event.u) event = {u, Reason::Turn, 0};
        }
    }
    const double sign = piece_->facing_sign(s.triangle, s.u);
    double furthest_out = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeSide side = side_of(4 * s.triangle + k);
        if (sign * side.sign_after(s.u) < 0.0) {
            // Already outside: this happens around a vertex, and after a look that rounding led astray.
            const double out = std::abs(side.value(s.u));
            if (event.u == s.u && out < furthest_out) continue;
            event = {s.u, Reason::Side, k};
            furthest_out = out;
        } else if (const double root = side.next_root(s.u); root < event.u) {
            event = {root, Reason::Side, k};
        }
    }
    return event;
}

// Whether one of the passages until then changes what is seen.
bool KineticWalk::handle_passages(double until) {
    Care& care = cares_[held_];
    while (care.next_passage < care.end_passage && !is_after(passages_[care.next_passage], until)) {
        const SilhouettePassage& passage = resolved(care.next_passage);
        if (passage.u > until) break;
        ++care.next_passage;
        if (passage.state == SilhouettePassage::State::None || passage.u <= strides_[held_].u) continue;
        if (handle_passage(passage)) return true;
    }
    return false;
}

bool KineticWalk::handle_passage(const SilhouettePassage& passage) {
    const TriangleId seen = strides_[held_].triangle;
    const TriangleId beside = nearer_beside(passage.half_edge, passage.u);
    if (beside == kNone || (beside == seen && passage.comes)) return false;
    const bool is_near_half = beside == passage.half_edge / 4;
    const HalfEdgeId half_edge =
        is_near_half ? passage.half_edge : mesh_->twins[passage.half_edge / 4][passage.half_edge % 4];
    const Line line = line_at(passage.u);
    if (beside != seen) {
        const double depth = edge_point(*mesh_, half_edge, line).depth;
        if (seen != kNone && !(depth < kNearer * depth_on(*mesh_, seen, line))) return false;
        if (!is_inside_but(half_edge, passage.u)) return false;
        if (passage.comes) {
            ++counters_->occlusions;
            ++jumps_;
            emit(passage.u);
            enter(beside, passage.u);
            return true;
        }
    }
    // It leaves what is seen, or what the sample should have been seeing until now.
    ++(beside == seen ? counters_->disocclusions : counters_->lost);
    leave_surface(half_edge, passage.u);
    return true;
}

void KineticWalk::cross(unsigned side, double u) {
    const TriangleId triangle = strides_[held_].triangle;
    const HalfEdgeId twin = mesh_->twins[triangle][side];
    const bool goes_round = u == strides_[held_].u && cares_[held_].stalled >= kMostStalled;
    if (!goes_round && twin != kNone && piece_->facing_sign(twin / 4, u) == piece_->facing_sign(triangle, u)) {
        emit(u);
        enter(twin / 4, u);
        return;
    }
    ++(goes_round ? counters_->lost : counters_->disocclusions);
    leave_surface(4 * triangle + side, u);
}

// Across an edge at which the surface ends, to whatever is behind it.
void KineticWalk::leave_surface(HalfEdgeId half_edge, double u) {
    const EdgePoint point = edge_point(*mesh_, half_edge, line_at(u));
    // At a corner the surface may go on, or the next of it be too close behind for a float.
    const bool is_at_corner = !(point.along > kCorner && point.along < 1.0 - kCorner);
    if (is_at_corner || !(point.depth > 0.0)) return look_again(u, 0.0, half_edge / 4);
    look_again(u, point.depth * kBehind);
}

// Asks a discrete ray what is seen just after a time, from a depth on; but first the triangles around `near`.
void KineticWalk::look_again(double u, double least, TriangleId near) {
    emit(u);
    ++jumps_;
    Care& care = cares_[held_];
    const bool again = care.last_jump > 0.0 && u <= care.last_look + 2.0 * care.last_jump;
    care.last_jump = again ? std::min(care.last_jump * kJumpGrowth, kLongestJump) : kJump;
    care.last_look = u;
    const double later = std::min(u + care.last_jump, 1.0);
    const Line line = line_at(later);
    TriangleId next = near != kNone ? look_around(*mesh_, line, near) : kNone;
    if (next == kNone) next = look(*scene_, line, least);
    enter(nearest_at_edges(next, later), later);
}

// What is seen at a time when a ray in float finds `seen`: where a silhouette is passed at about that time, the ray may
// have missed what is beside it.
TriangleId KineticWalk::nearest_at_edges(TriangleId seen, double u) {
    const Line line = line_at(u);
    const Care& care = cares_[held_];
    for (std::uint32_t k = care.first_passage; k < care.end_passage; ++k) {
        if (std::abs(passages_[k].u - u) > kAboutNow + passages_[k].doubt_u) continue;
        const SilhouettePassage& passage = resolved(k);
        if (passage.state == SilhouettePassage::State::None) continue;
        const bool is_over = passage.comes ? passage.u <= u : passage.u > u;
        if (!is_over || std::abs(passage.u - u) > kAboutNow) continue;
        const TriangleId beside = nearer_beside(passage.half_edge, u);
        if (beside == kNone || beside == seen || !edge_values(*mesh_, beside, line).inside()) continue;
        const double depth = depth_on(*mesh_, beside, line);
        if (depth > 0.0 && (seen == kNone || depth < depth_on(*mesh_, seen, line))) seen = beside;
    }
    return seen;
}

// Notes that what has been seen was seen until then.
void KineticWalk::emit(double until) {
    Stride& s = strides_[held_];
    s.last = log_.add(s.last, s.triangle, static_cast<float>(until));
}

EdgeSide KineticWalk::side_of(HalfEdgeId half_edge) {
    const auto& corner = mesh_->triangles[half_edge / 4];
    const VertexId a = corner[half_edge % 4];
    const VertexId b = corner[(half_edge % 4 + 1) % 3];
    const Point<Scene> reference = piece_->motion().reference;
    return EdgeSide(
        held_line().side_of(edge_function(a, b, mesh_->positions[a] - reference, mesh_->positions[b] - reference)));
}

Line KineticWalk::line_at(double u) const { return piece_->line_at(u, strides_[held_].x, strides_[held_].y); }

// Of the triangles at an edge the one that is nearer beside it, or kNone if the surface does not end there now.
TriangleId KineticWalk::nearer_beside(HalfEdgeId half_edge, double u) const {
    const TriangleId a = half_edge / 4;
    const HalfEdgeId twin = mesh_->twins[a][half_edge % 4];
    if (twin == kNone) return a;
    const TriangleId b = twin / 4;
    const double sign = piece_->facing_sign(a, u);
    if (piece_->facing_sign(b, u) == sign) return kNone;
    // Both are on one side of the edge on the film; the one whose far corner is on the camera's side of the other.
    const auto& corner = mesh_->triangles[a];
    const Point<Scene> v0 = mesh_->positions[corner[0]];
    const Vector<Scene> normal = overfly::cross(mesh_->positions[corner[1]] - v0, mesh_->positions[corner[2]] - v0);
    const Point<Scene> apex = mesh_->positions[mesh_->triangles[b][(twin % 4 + 2) % 3]];
    return sign * dot(normal, apex - v0) > 0.0 ? b : a;
}

// Whether the line is on the inner side of the other two edges of the half-edge's triangle.
bool KineticWalk::is_inside_but(HalfEdgeId half_edge, double u) const {
    const EdgeValues values = edge_values(*mesh_, half_edge / 4, line_at(u));
    const double sign = piece_->facing_sign(half_edge / 4, u);
    const std::size_t side = half_edge % 4;
    return sign * values.at[(side + 1) % 3] >= 0.0 && sign * values.at[(side + 2) % 3] >= 0.0;
}

}  // namespace overfly
