#include "trace/kinetic_steps.h"

#include <algorithm>
#include <cmath>

#include "trace/kinetic_look.h"

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

// More triangles than this meet at no vertex that a walk could circle.
constexpr int kMostStalled = 64;

}  // namespace

void KineticSteps::step_past(double u) {
    while (task_.walking->strides[held_].u < std::min(u, 1.0)) take_event();
}

const LineOverPiece& KineticSteps::held_line() {
    if (line_of_ != held_)
        line_ = task_.piece->lines().at(task_.walking->strides[held_].x, task_.walking->strides[held_].y);
    line_of_ = held_;
    return line_;
}

// The sample sees the triangle from now on.
void KineticSteps::enter(TriangleId triangle, double u) {
    Stride& s = task_.walking->strides[held_];
    task_.walking->cares[held_].stalled = u == s.u ? task_.walking->cares[held_].stalled + 1 : 0;
    s.triangle = triangle;
    s.u = u;
}

void KineticSteps::take_event() {
    const Event event = next_event();
    if (handle_passages(event.u)) return;
    if (event.reason == Reason::Side) {
        cross(event.side, event.u);
    } else if (event.reason == Reason::End) {
        task_.walking->strides[held_].u = 1.0;
    } else {
        look_again(event.u);
    }
}

KineticSteps::Event KineticSteps::next_event() {
    const Stride& s = task_.walking->strides[held_];
    Event event = {1.0, Reason::End, 0};
    const auto passages = task_.piece->surface_passages();
    const auto passage = std::ranges::upper_bound(passages, s.u);
    if (passage != passages.end() && *passage < event.u) event = {*passage, Reason::Passage, 0};
    if (s.triangle == kNone) return event;
    if (task_.piece->facing(s.triangle) == Facing::Changes) {
        for (const double u : sign_change_roots<2>(height_over_plane(*task_.mesh, s.triangle, task_.piece->motion()))) {
            if (u > s.u && u < event.u) event = {u, Reason::Turn, 0};
        }
    }
    const double sign = task_.piece->facing_sign(s.triangle, s.u);
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
bool KineticSteps::handle_passages(double until) {
    Care& care = task_.walking->cares[held_];
    while (care.next_passage < care.end_passage && !task_.walking->passages[care.next_passage].is_after(until)) {
        const SilhouettePassage& passage = resolved(care.next_passage);
        if (passage.u > until) break;
        ++care.next_passage;
        if (passage.state == SilhouettePassage::State::None || passage.u <= task_.walking->strides[held_].u) continue;
        if (handle_passage(passage)) return true;
    }
    return false;
}

bool KineticSteps::handle_passage(const SilhouettePassage& passage) {
    const TriangleId seen = task_.walking->strides[held_].triangle;
    const TriangleId beside = nearer_beside(passage.half_edge, passage.u);
    if (beside == kNone || (beside == seen && passage.comes)) return false;
    const bool is_near_half = beside == passage.half_edge / 4;
    const HalfEdgeId half_edge =
        is_near_half ? passage.half_edge : task_.mesh->twins[passage.half_edge / 4][passage.half_edge % 4];
    const Line line = line_at(passage.u);
    if (beside != seen) {
        const double depth = edge_point(*task_.mesh, half_edge, line).depth;
        if (seen != kNone && !(depth < kNearer * depth_on(*task_.mesh, seen, line))) return false;
        if (!is_inside_but(half_edge, passage.u)) return false;
        if (passage.comes) {
            ++task_.counters->occlusions;
            ++jumps_;
            emit(passage.u);
            enter(beside, passage.u);
            return true;
        }
    }
    // It leaves what is seen, or what the sample should have been seeing until now.
    ++(beside == seen ? task_.counters->disocclusions : task_.counters->lost);
    leave_surface(half_edge, passage.u);
    return true;
}

void KineticSteps::cross(unsigned side, double u) {
    const TriangleId triangle = task_.walking->strides[held_].triangle;
    const HalfEdgeId twin = task_.mesh->twins[triangle][side];
    const bool goes_round = u == task_.walking->strides[held_].u && task_.walking->cares[held_].stalled >= kMostStalled;
    if (!goes_round && twin != kNone &&
        task_.piece->facing_sign(twin / 4, u) == task_.piece->facing_sign(triangle, u)) {
        emit(u);
        enter(twin / 4, u);
        return;
    }
    ++(goes_round ? task_.counters->lost : task_.counters->disocclusions);
    leave_surface(4 * triangle + side, u);
}

// Across an edge at which the surface ends, to whatever is behind it.
void KineticSteps::leave_surface(HalfEdgeId half_edge, double u) {
    const EdgePoint point = edge_point(*task_.mesh, half_edge, line_at(u));
    // At a corner the surface may go on, or the next of it be too close behind for a float.
    const bool is_at_corner = !(point.along > kCorner && point.along < 1.0 - kCorner);
    if (is_at_corner || !(point.depth > 0.0)) return look_again(u, 0.0, half_edge / 4);
    look_again(u, point.depth * kBehind);
}

void KineticSteps::look_again(double u, double least, TriangleId near) {
    emit(u);
    ++jumps_;
    Care& care = task_.walking->cares[held_];
    const bool again = care.last_jump > 0.0 && u <= care.last_look + 2.0 * care.last_jump;
    care.last_jump = again ? std::min(care.last_jump * kJumpGrowth, kLongestJump) : kJump;
    care.last_look = u;
    const double later = std::min(u + care.last_jump, 1.0);
    const Line line = line_at(later);
    TriangleId next = near != kNone ? look_around(*task_.mesh, line, near) : kNone;
    if (next == kNone) next = look(*task_.scene, line, least);
    enter(nearest_at_edges(next, later), later);
}

// What is seen at a time when a ray in float finds `seen`: where a silhouette is passed at about that time, the ray may
// have missed what is beside it.
TriangleId KineticSteps::nearest_at_edges(TriangleId seen, double u) {
    const Line line = line_at(u);
    const Care& care = task_.walking->cares[held_];
    for (std::uint32_t k = care.first_passage; k < care.end_passage; ++k) {
        if (std::abs(task_.walking->passages[k].u - u) > kAboutNow + task_.walking->passages[k].doubt_u) continue;
        const SilhouettePassage& passage = resolved(k);
        if (passage.state == SilhouettePassage::State::None) continue;
        const bool is_over = passage.comes ? passage.u <= u : passage.u > u;
        if (!is_over || std::abs(passage.u - u) > kAboutNow) continue;
        const TriangleId beside = nearer_beside(passage.half_edge, u);
        if (beside == kNone || beside == seen || !edge_values(*task_.mesh, beside, line).inside()) continue;
        const double depth = depth_on(*task_.mesh, beside, line);
        if (depth > 0.0 && (seen == kNone || depth < depth_on(*task_.mesh, seen, line))) seen = beside;
    }
    return seen;
}

const SilhouettePassage& KineticSteps::resolved(std::uint32_t passage) {
    resolve(*task_.piece, task_.samples[task_.walking->passages[passage].sample], task_.walking->passages[passage]);
    return task_.walking->passages[passage];
}

EdgeSide KineticSteps::side_of(HalfEdgeId half_edge) {
    const auto& corner = task_.mesh->triangles[half_edge / 4];
    const VertexId a = corner[half_edge % 4];
    const VertexId b = corner[(half_edge % 4 + 1) % 3];
    const Point<Scene> reference = task_.piece->motion().reference;
    return EdgeSide(held_line().side_of(
        edge_function(a, b, task_.mesh->positions[a] - reference, task_.mesh->positions[b] - reference)));
}

Line KineticSteps::line_at(double u) const {
    return task_.piece->line_at(u, task_.walking->strides[held_].x, task_.walking->strides[held_].y);
}

TriangleId KineticSteps::nearer_beside(HalfEdgeId half_edge, double u) const {
    const TriangleId a = half_edge / 4;
    const HalfEdgeId twin = task_.mesh->twins[a][half_edge % 4];
    if (twin == kNone) return a;
    const TriangleId b = twin / 4;
    const double sign = task_.piece->facing_sign(a, u);
    if (task_.piece->facing_sign(b, u) == sign) return kNone;
    // Both are on one side of the edge on the film; the one whose far corner is on the camera's side of the other.
    const auto& corner = task_.mesh->triangles[a];
    const Point<Scene> v0 = task_.mesh->positions[corner[0]];
    const Vector<Scene> normal =
        overfly::cross(task_.mesh->positions[corner[1]] - v0, task_.mesh->positions[corner[2]] - v0);
    const Point<Scene> apex = task_.mesh->positions[task_.mesh->triangles[b][(twin % 4 + 2) % 3]];
    return sign * dot(normal, apex - v0) > 0.0 ? b : a;
}

// Whether the line is on the inner side of the other two edges of the half-edge's triangle.
bool KineticSteps::is_inside_but(HalfEdgeId half_edge, double u) const {
    const EdgeValues values = edge_values(*task_.mesh, half_edge / 4, line_at(u));
    const double sign = task_.piece->facing_sign(half_edge / 4, u);
    const std::size_t side = half_edge % 4;
    return sign * values.at[(side + 1) % 3] >= 0.0 && sign * values.at[(side + 2) % 3] >= 0.0;
}

}  // namespace overfly
