#include "trace/kinetic_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trace/kinetic_look.h"
#include "trace/kinetic_start.h"

namespace overfly {
namespace {

// What a sample sees is to be found out; no triangle has this number.
constexpr TriangleId kNotKnown = kNone - 1;

// A stride that comes to a silhouette is at it within this, in u.
constexpr double kAboutStop = 1e-5;

// Where a stride gave up, careful steps go on for at least as long, in u: longer than a stride's times are off.
constexpr double kStep = 1e-6;

}  // namespace

void KineticWalk::follow(SegmentLists& out) {
    begin();
    std::vector<std::uint32_t> walking;
    std::vector<std::uint32_t> still;
    for (std::uint32_t i = 0; i < task_.samples.size(); ++i) {
        if (!is_plain(i)) begin_carefully(i);
        if (task_.walking->strides[i].u < stretch_.to_u) walking.push_back(i);
    }
    while (!walking.empty()) {
        stride_on(walking);
        still.clear();
        for (const std::uint32_t i : walking) {
            // Most are through.
            const bool has_passages = task_.walking->cares[i].next_passage < task_.walking->cares[i].end_passage;
            if (is_through(i) && !has_passages) continue;
            settle(i);
            if (!is_through(i) && task_.walking->strides[i].u < stretch_.to_u) still.push_back(i);
        }
        std::swap(walking, still);
    }
    std::uint64_t changes = 0;
    for (std::uint32_t i = 0; i < task_.samples.size(); ++i) {
        steps_.hold(i);
        steps_.emit(stretch_.to_u);
        changes += task_.walking->log.write(stretch_, task_.walking->strides[i].last, out) - 1;
    }
    task_.counters->crossings += changes - std::min(changes, steps_.jumps());
}

void KineticWalk::begin() {
    task_.walking->strides.resize(task_.samples.size());
    task_.walking->cares.assign(task_.samples.size(), {});
    task_.walking->log.count = 0;
    find_starts();
    find_passages();
}

void KineticWalk::find_starts() {
    std::vector<TriangleId> found(task_.samples.size());
    task_.counters->restarts += task_.samples.size();
    look_roughly(*task_.scene, task_.piece->motion(), stretch_.from_u, task_.samples, found);
    for (std::size_t i = 0; i < task_.samples.size(); ++i)
        task_.walking->strides[i] = {task_.samples[i].x, task_.samples[i].y, found[i], stretch_.from_u};
}

void KineticWalk::find_passages() {
    SilhouettePassages found = silhouette_passages(*task_.piece, stretch_, task_.samples);
    task_.walking->passages = std::move(found.in_order);
    for (const std::uint32_t i : found.begins_at_edge) task_.walking->strides[i].triangle = kNotKnown;  // not for long
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < task_.samples.size(); ++i) {
        task_.walking->cares[i].first_passage = task_.walking->cares[i].next_passage = at;
        while (at < task_.walking->passages.size() && task_.walking->passages[at].sample == i) ++at;
        task_.walking->cares[i].end_passage = at;
    }
}

// What stride() can't follow is set down in double.
void KineticWalk::begin_carefully(std::uint32_t sample) {
    steps_.hold(sample);
    Stride& s = task_.walking->strides[sample];
    const bool is_certain = s.triangle == kNone || (s.triangle != kNotKnown &&
                                                    edge_values(*task_.mesh, s.triangle, steps_.line_at(s.u)).inside());
    if (!is_certain) s.triangle = look(*task_.scene, steps_.line_at(s.u));
    while (s.u < stretch_.to_u && !is_plain(sample)) steps_.take_event();
}

void KineticWalk::stride_on(std::span<const std::uint32_t> walking) {
    for (const std::uint32_t i : walking) {
        task_.walking->strides[i].limit_u = next_stop(task_.walking->strides[i].u);
        task_.walking->cares[i].before_stride = task_.walking->strides[i].last;
        task_.walking->cares[i].stride_u = task_.walking->strides[i].u;
    }
    stride({task_.piece->stride_scene(), task_.walking->strides, walking, stretch_.to_u}, task_.walking->log);
}

// When a sample that walks has to be looked at next.
double KineticWalk::next_stop(double u) const {
    const auto surface = std::ranges::upper_bound(task_.piece->surface_passages(), u);
    return surface != task_.piece->surface_passages().end() ? *surface : 1.0;
}

bool KineticWalk::is_through(std::uint32_t sample) const {
    const Stride& s = task_.walking->strides[sample];
    return s.stop == Stride::Stop::Limit && s.limit_u >= stretch_.to_u;
}

// Whether stride() can take the sample further.
bool KineticWalk::is_plain(std::uint32_t sample) const {
    const TriangleId triangle = task_.walking->strides[sample].triangle;
    return task_.piece->is_ahead() && triangle < kNotKnown && task_.piece->facing(triangle) == Facing::Front;
}

// Takes care of why a sample does not walk, until it can or is at the end.
void KineticWalk::settle(std::uint32_t sample) {
    steps_.hold(sample);
    Stride& s = task_.walking->strides[sample];
    if (is_disturbed(sample) || leaves_silhouette(sample)) {
        s.stop = Stride::Stop::Doubt;  // not where stride() left it
    } else if (is_through(sample)) {
        return;
    } else if (s.stop == Stride::Stop::Doubt) {
        settle_doubt(s);
    } else {
        s.u = s.limit_u;
        steps_.look_again(s.u);
    }
    while (s.u < stretch_.to_u && !is_plain(sample)) steps_.take_event();
}

// Whether a passage changes what stride() has walked. Then the sample has gone back to it.
bool KineticWalk::is_disturbed(std::uint32_t sample) {
    Care& care = task_.walking->cares[sample];
    Stride& s = task_.walking->strides[sample];
    const double until = s.stop == Stride::Stop::Doubt ? s.stop_u : std::min(s.limit_u, stretch_.to_u);
    if (care.next_passage == care.end_passage || task_.walking->passages[care.next_passage].is_after(until))
        return false;
    retrace(sample);
    const Stride walked = s;
    while (care.next_passage < care.end_passage) {
        const std::uint32_t next = care.next_passage;
        if (task_.walking->passages[next].is_after(until)) break;
        while (way_.size() > 1 &&
               way_.back().until_u < task_.walking->passages[next].u - task_.walking->passages[next].doubt_u)
            way_.pop_back();
        if (!is_hidden(task_.walking->passages[next])) {
            const SilhouettePassage& passage = steps_.resolved(next);
            if (passage.u > until) break;
            while (way_.size() > 1 && way_.back().until_u < passage.u) way_.pop_back();
            s.triangle = way_.back().triangle;
            s.u = way_.back().since_u;
            s.last = way_.back().before;
            ++care.next_passage;
            if (passage.state != SilhouettePassage::State::None && passage.u > s.u && steps_.handle_passage(passage))
                return true;
            s = walked;
        } else {
            ++care.next_passage;
        }
    }
    return false;
}

// Whether stride() stopped because the surface ends at a silhouette that is known. Then the sample has left it.
bool KineticWalk::leaves_silhouette(std::uint32_t sample) {
    Care& care = task_.walking->cares[sample];
    const Stride& s = task_.walking->strides[sample];
    if (s.stop != Stride::Stop::Doubt || care.next_passage == care.end_passage) return false;
    if (task_.walking->passages[care.next_passage].is_after(s.stop_u + kAboutStop)) return false;
    const SilhouettePassage& passage = steps_.resolved(care.next_passage);
    const bool is_at_it = std::abs(passage.u - s.stop_u) < kAboutStop && passage.u > s.u;
    if (passage.state == SilhouettePassage::State::None || passage.comes || !is_at_it) return false;
    if (steps_.nearer_beside(passage.half_edge, passage.u) != s.triangle) return false;
    ++care.next_passage;
    return steps_.handle_passage(passage);
}

// What stride() has walked with the sample, latest first.
void KineticWalk::retrace(std::uint32_t sample) {
    const Stride& s = task_.walking->strides[sample];
    const Care& care = task_.walking->cares[sample];
    const bool doubts = s.stop == Stride::Stop::Doubt;
    way_.clear();
    Way way = {s.triangle, s.u, doubts ? s.stop_u : std::min(s.limit_u, stretch_.to_u), s.last};
    while (way.before != care.before_stride) {
        const RecordId record = way.before;
        way.since_u = static_cast<double>(task_.walking->log.until_u[record]);
        way_.push_back(way);
        way = {task_.walking->log.triangle[record], 0.0, way.since_u, task_.walking->log.before[record]};
    }
    way.since_u = care.stride_u;
    way_.push_back(way);
}

// Whether the edge is surely behind all that is seen at about the passage. The way is at the begin of that.
bool KineticWalk::is_hidden(const SilhouettePassage& passage) const {
    const double until = passage.u + passage.doubt_u;
    if (until > way_.front().until_u) return false;
    const Silhouette& silhouette = task_.piece->silhouettes()[passage.silhouette];
    for (auto way = way_.rbegin(); way != way_.rend() && way->since_u <= until; ++way) {
        if (!task_.piece->hides(way->triangle, silhouette, passage.u)) return false;
    }
    return true;
}

// Careful steps from shortly before it stopped: what it has walked before that stays as it is.
void KineticWalk::settle_doubt(Stride& s) {
    const double at = std::max(s.has_moved ? s.u + kStep : s.u, s.stop_u - kStep);
    const double until = s.stop_u + kStep;
    if (at == stretch_.from_u) {
        // Where it began was known roughly.
        s.triangle = look(*task_.scene, steps_.line_at(at));
    } else if (!edge_values(*task_.mesh, s.triangle, steps_.line_at(at)).inside()) {
        // The stride went astray, or leaves right away.
        ++task_.counters->restarts;
        return steps_.look_again(at);
    }
    s.u = at;
    steps_.step_past(until);
}

}  // namespace overfly
