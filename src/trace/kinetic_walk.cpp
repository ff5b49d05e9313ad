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
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
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
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
        steps_.hold(i);
        steps_.emit(stretch_.to_u);
        changes += log_.write(stretch_, strides_[i].last, out) - 1;
    }
    counters_->crossings += changes - std::min(changes, steps_.jumps());
}

void KineticWalk::begin() {
    strides_.resize(samples_.size());
    cares_.assign(samples_.size(), {});
    log_.count = 0;
    find_starts();
    find_passages();
}

void KineticWalk::find_starts() {
    std::vector<TriangleId> found(samples_.size());
    counters_->restarts += samples_.size();
    look_roughly(*scene_, piece_->motion(), stretch_.from_u, samples_, found);
    for (std::size_t i = 0; i < samples_.size(); ++i)
        strides_[i] = {samples_[i].x, samples_[i].y, found[i], stretch_.from_u};
}

void KineticWalk::find_passages() {
    SilhouettePassages found = silhouette_passages(*piece_, stretch_, samples_);
    passages_ = std::move(found.in_order);
    for (const std::uint32_t i : found.begins_at_edge) strides_[i].triangle = kNotKnown;  // not for long
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
        cares_[i].first_passage = cares_[i].next_passage = at;
        while (at < passages_.size() && passages_[at].sample == i) ++at;
        cares_[i].end_passage = at;
    }
}

// What stride() can't follow is set down in double.
void KineticWalk::begin_carefully(std::uint32_t sample) {
    steps_.hold(sample);
    Stride& s = strides_[sample];
    const bool is_certain = s.triangle == kNone ||
                            (s.triangle != kNotKnown && edge_values(*mesh_, s.triangle, steps_.line_at(s.u)).inside());
    if (!is_certain) s.triangle = look(*scene_, steps_.line_at(s.u));
    while (s.u < stretch_.to_u && !is_plain(sample)) steps_.take_event();
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
    steps_.hold(sample);
    Stride& s = strides_[sample];
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
    Care& care = cares_[sample];
    Stride& s = strides_[sample];
    const double until = s.stop == Stride::Stop::Doubt ? s.stop_u : std::min(s.limit_u, stretch_.to_u);
    if (care.next_passage == care.end_passage || passages_[care.next_passage].is_after(until)) return false;
    retrace(sample);
    const Stride walked = s;
    while (care.next_passage < care.end_passage) {
        const std::uint32_t next = care.next_passage;
        if (passages_[next].is_after(until)) break;
        while (way_.size() > 1 && way_.back().until_u < passages_[next].u - passages_[next].doubt_u) way_.pop_back();
        if (!is_hidden(passages_[next])) {
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
    Care& care = cares_[sample];
    const Stride& s = strides_[sample];
    if (s.stop != Stride::Stop::Doubt || care.next_passage == care.end_passage) return false;
    if (passages_[care.next_passage].is_after(s.stop_u + kAboutStop)) return false;
    const SilhouettePassage& passage = steps_.resolved(care.next_passage);
    const bool is_at_it = std::abs(passage.u - s.stop_u) < kAboutStop && passage.u > s.u;
    if (passage.state == SilhouettePassage::State::None || passage.comes || !is_at_it) return false;
    if (steps_.nearer_beside(passage.half_edge, passage.u) != s.triangle) return false;
    ++care.next_passage;
    return steps_.handle_passage(passage);
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

// Careful steps from shortly before it stopped: what it has walked before that stays as it is.
void KineticWalk::settle_doubt(Stride& s) {
    const double at = std::max(s.has_moved ? s.u + kStep : s.u, s.stop_u - kStep);
    const double until = s.stop_u + kStep;
    if (at == stretch_.from_u) {
        // Where it began was known roughly.
        s.triangle = look(*scene_, steps_.line_at(at));
    } else if (!edge_values(*mesh_, s.triangle, steps_.line_at(at)).inside()) {
        // The stride went astray, or leaves right away.
        ++counters_->restarts;
        return steps_.look_again(at);
    }
    s.u = at;
    steps_.step_past(until);
}

}  // namespace overfly
