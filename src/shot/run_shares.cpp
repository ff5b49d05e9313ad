#include "shot/run_shares.h"

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

// Middles of pixels and, for a tent of two pixels, all its joints lie on this grid.
constexpr double kFilterCell_px = 0.5;

// Of an exposure, where the shutter isn't a box: between two the openness is straight, or nearly. The usual ramp ends
// on one of them.
constexpr int kShutterCells = 16;

// The middle of a product of two functions that are straight in a cell: the integral of (v - 1/2)^2.
constexpr double kTwelfth = 1.0 / 12.0;

// Multiples of a step between the ends, as parts of the way.
void add_multiples(double from, double length, double step, std::vector<double>& out) {
    for (double k = std::floor(from / step) + 1.0; k * step < from + length; k += 1.0)
        out.push_back((k * step - from) / length);
}

}  // namespace

// One end of a cell.
struct RunWeighing::End {
    End(const Sweep& sweep, const ShutterCurve& curve, double at_v)
        : v(at_v), px(sweep.from_px + at_v * sweep.length_px) {
        const double part = sweep.from_part + v * (sweep.to_part - sweep.from_part);
        share = curve.share_until(part);
        openness = curve.is_box() ? 1.0 : curve.openness(part);
    }
    double v, px;
    double share = 0.0, openness = 0.0;
};

const RunShares& RunWeighing::of(const Sweep& sweep) {
    out_.cells.clear();
    out_.shares.clear();
    weigh_rows(sweep);
    cut(sweep);
    End from(sweep, curve_, 0.0);
    for (const double v : cuts_v_) {
        if (v <= from.v) continue;
        const End to(sweep, curve_, v);
        add_cell(sweep, from, to);
        from = to;
    }
    return out_;
}

void RunWeighing::weigh_rows(const Sweep& sweep) {
    out_.rows.clear();
    const int inside = static_cast<int>(std::floor(sweep.across_px));
    if (filter_ == nullptr || sweep.length_px == 0.0) {
        out_.rows.push_back({(inside - sweep.first_row) * sweep.row_stride, 1.0F, true});
        return;
    }
    const double radius_px = filter_->radius_px();
    const int first = std::max(sweep.first_row, static_cast<int>(std::floor(sweep.across_px - radius_px - 0.5)) + 1);
    const int last = std::min(sweep.end_row, static_cast<int>(std::ceil(sweep.across_px + radius_px - 0.5))) - 1;
    for (int row = first; row <= last; ++row) {
        out_.rows.push_back({(row - sweep.first_row) * sweep.row_stride,
                             static_cast<float>(filter_->density(sweep.across_px - (row + 0.5))), row == inside});
    }
}

void RunWeighing::cut(const Sweep& sweep) {
    cuts_v_.clear();
    if (sweep.length_px > 0.0)
        add_multiples(sweep.from_px, sweep.length_px, filter_ != nullptr ? kFilterCell_px : 1.0, cuts_v_);
    if (!curve_.is_box()) {
        const double parts = sweep.to_part - sweep.from_part;
        add_multiples(sweep.from_part, parts, 1.0 / kShutterCells, cuts_v_);
        for (const double joint : curve_.joints()) {
            const double v = (joint - sweep.from_part) / parts;
            if (v > 0.0 && v < 1.0) cuts_v_.push_back(v);
        }
    }
    cuts_v_.push_back(1.0);
    std::ranges::sort(cuts_v_);
}

void RunWeighing::add_cell(const Sweep& sweep, const End& from, const End& to) {
    if (filter_ != nullptr && sweep.length_px > 0.0) {
        add_filtered(sweep, from, to);
    } else {
        const int at = std::clamp(static_cast<int>(std::floor(0.5 * (from.px + to.px))), sweep.first, sweep.end - 1);
        const double parts = (to.v - from.v) * (sweep.to_part - sweep.from_part);
        const double growth = parts * (to.openness - from.openness) * kTwelfth;
        out_.shares.push_back({sweep.first_pixel + static_cast<std::uint32_t>((at - sweep.first) * sweep.stride),
                               static_cast<float>(sweep.weight * (to.share - from.share)),
                               static_cast<float>(sweep.weight * growth), true});
    }
    out_.cells.push_back({static_cast<float>(to.v), static_cast<std::uint32_t>(out_.shares.size())});
}

// In the cell both openness o and filter f are taken for straight, with o's mean and f's exact: then the mean of o f
// is that of o times that of f, and a twelfth of the product of their growths; and light that grows by 1 gets a twelfth
// of what either grows by, times the mean of the other, beside its own mean.
void RunWeighing::add_filtered(const Sweep& sweep, const End& from, const End& to) {
    const double length_px = to.px - from.px;
    if (length_px <= 0.0) return;
    const double radius_px = filter_->radius_px();
    const int first = std::max(sweep.first, static_cast<int>(std::floor(from.px - radius_px - 0.5)) + 1);
    const int last = std::min(sweep.end, static_cast<int>(std::ceil(to.px + radius_px - 0.5))) - 1;
    const int inside = static_cast<int>(std::floor(0.5 * (from.px + to.px)));
    const double light = to.share - from.share;
    const double opening = (to.v - from.v) * (sweep.to_part - sweep.from_part) * (to.openness - from.openness);
    for (int at = first; at <= last; ++at) {
        const double begin_px = from.px - (at + 0.5), end_px = to.px - (at + 0.5);
        const double mean = (filter_->until(end_px) - filter_->until(begin_px)) / length_px;
        const double rise = filter_->density(end_px) - filter_->density(begin_px);
        out_.shares.push_back({sweep.first_pixel + static_cast<std::uint32_t>((at - sweep.first) * sweep.stride),
                               static_cast<float>(sweep.weight * (light * mean + kTwelfth * opening * rise)),
                               static_cast<float>(sweep.weight * kTwelfth * (light * rise + opening * mean)),
                               at == inside});
    }
}

}  // namespace overfly
