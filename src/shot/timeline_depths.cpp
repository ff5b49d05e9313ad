// Depth against time: every record before occlusion, thin, and what is left of them after it, bold.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "shot/timeline_page.h"

namespace overfly {
namespace {

constexpr int kMostTicks = 9;
constexpr std::size_t kMostJoints = 16;  // more would be a pattern of their own

// Depths on a logarithmic scale, farther ones higher.
class DepthAxis {
  public:
    DepthAxis(const PixelTimeline& pixel, const PageArea& area) : area_(area) {
        for (const SightRecord& r : pixel.timeline.passed) {
            for (const DepthAt& d : r.depth) {
                low_ = low_ > 0.0 ? std::min(low_, d.depth_m) : d.depth_m;
                high_ = std::max(high_, d.depth_m);
            }
        }
        if (low_ == 0.0) return;
        // Room around the curves, and for a single depth as well.
        const double room = std::max(std::pow(high_ / low_, 0.08), 1.002);
        low_ /= room;
        high_ *= room;
    }

    [[nodiscard]] double y_at(double depth_m) const {
        return area_.bottom - area_.height() * std::log(depth_m / low_) / std::log(high_ / low_);
    }

    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> out;
        if (low_ == 0.0) return out;
        if (high_ / low_ < 5.0) {
            const double step = round_step(high_ - low_, kMostTicks);
            for (double k = std::ceil(low_ / step); k * step <= high_; ++k) out.push_back(k * step);
            return out;
        }
        for (double power = std::pow(10.0, std::floor(std::log10(low_))); power <= high_; power *= 10.0) {
            for (const double step : {1.0, 2.0, 5.0}) {
                if (step * power >= low_ && step * power <= high_) out.push_back(step * power);
            }
        }
        return out;
    }

  private:
    PageArea area_;
    double low_ = 0.0, high_ = 0.0;  // zero where there is only sky
};

constexpr double kLongest_m = 10'000.0;  // of what is said in metres

void draw_frame(const TimelinePage& page, const DepthAxis& axis, const PageArea& area, SvgText& svg) {
    for (const PlannedFrame& f : page.pixel().frames) {
        const TimeRange open = intersection(f.exposure, page.pixel().timeline.when);
        const double left = page.x_at(open.begin_s);
        svg.add("rect", {{"x", left},
                         {"y", area.top},
                         {"width", std::max(1.0, page.x_at(open.end_s) - left)},
                         {"height", area.height()},
                         {"class", "open"}});
    }
    const std::vector<double> ticks = axis.ticks();
    const bool in_km = !ticks.empty() && ticks.back() >= kLongest_m;
    for (const double depth_m : ticks) {
        const double y = axis.y_at(depth_m);
        svg.add("line", {{"x1", area.left}, {"y1", y}, {"x2", area.right}, {"y2", y}, {"class", "grid"}});
        svg.text({area.left - 10.0, y + 4.0}, "small end", fmt::format("{:g}", in_km ? depth_m / 1000.0 : depth_m));
    }
    const TimeRange when = page.pixel().timeline.when;
    const double step_s = round_step(when.duration_s(), kMostTicks);
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step_s) - 1e-9)));
    for (double k = std::ceil(when.begin_s / step_s); k * step_s <= when.end_s; ++k) {
        const double x = page.x_at(k * step_s);
        svg.add("line", {{"x1", x}, {"y1", area.bottom}, {"x2", x}, {"y2", area.bottom + 5.0}, {"class", "axis"}});
        svg.text({x, area.bottom + 19.0}, "small centre", fmt::format("{:.{}f}", k * step_s, digits));
    }
    svg.add(
        "rect",
        {{"x", area.left}, {"y", area.top}, {"width", area.width()}, {"height", area.height()}, {"class", "frame"}});
    svg.text({area.right, area.bottom + 36.0}, "small end", "time of the flight, s");
    svg.text({area.left, area.bottom + 36.0}, "small",
             fmt::format("depth along the view, {} (logarithmic)", in_km ? "km" : "m"));
}

void draw_joints(const TimelinePage& page, const PageArea& area, SvgText& svg) {
    const std::vector<TimeRange>& pieces = page.pixel().timeline.pieces;
    if (pieces.size() > kMostJoints) return;
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const double x = page.x_at(pieces[k].begin_s);
        svg.add("line", {{"x1", x}, {"y1", area.top}, {"x2", x}, {"y2", area.bottom}, {"class", "joint"}},
                "the next piece of the motion begins");
    }
}

std::string curve_of(const TimelinePage& page, const DepthAxis& axis, const SightRecord& record) {
    std::vector<SvgPoint> points;
    for (const DepthAt& d : record.depth) points.push_back({page.x_at(d.time_s), axis.y_at(d.depth_m)});
    return svg_path(points);
}

// The letter stands above the middle of the longest record of its triangle, if that is wide enough.
void draw_letter(const TimelinePage& page, const DepthAxis& axis, const SightRecord& record, SvgText& svg) {
    const TriangleLook& look = *page.look_of(record.what);
    const DepthAt& middle = record.depth[record.depth.size() / 2];
    if (page.x_at(record.when.end_s) - page.x_at(record.when.begin_s) < 14.0) return;
    svg.text({page.x_at(middle.time_s), axis.y_at(middle.depth_m) - 8.0}, "letter halo", look.letter,
             {{"style", "fill:" + look.colour}});
}

// One triangle's record after the other is one line, so that its dashes are those of one line. Two are joined where the
// line of sight leaves one triangle and enters the other across their common edge.
bool goes_on(const SightRecord& a, const SightRecord& b) {
    constexpr double kSame_s = 1e-9;
    constexpr double kSame = 1e-6;  // of the depth
    const DepthAt& end = a.depth.back();
    const DepthAt& begin = b.depth.front();
    return std::abs(begin.time_s - end.time_s) < kSame_s && std::abs(begin.depth_m - end.depth_m) < kSame * end.depth_m;
}

// The records of triangles that are never seen, end to end.
std::vector<SightRecord> chained(const TimelinePage& page) {
    std::vector<SightRecord> chains;
    for (const SightRecord& r : page.pixel().timeline.passed) {
        if (r.depth.size() < 2 || page.look_of(r.what) != nullptr) continue;
        const auto before = std::ranges::find_if(chains, [&](const SightRecord& c) { return goes_on(c, r); });
        if (before == chains.end()) {
            chains.push_back(r);
        } else {
            before->depth.insert(before->depth.end(), r.depth.begin(), r.depth.end());
        }
    }
    return chains;
}

void draw_passed(const TimelinePage& page, const DepthAxis& axis, SvgText& svg) {
    for (const SightRecord& chain : chained(page)) {
        svg.add("path", {{"d", curve_of(page, axis, chain)}, {"class", "passed"}, {"stroke", kUnseenColour}});
    }
    for (const SightRecord& r : page.pixel().timeline.passed) {
        const TriangleLook* const look = page.look_of(r.what);
        if (r.depth.size() < 2 || look == nullptr) continue;
        svg.add("path", {{"d", curve_of(page, axis, r)}, {"class", "passed"}, {"stroke", look->colour}});
    }
}

void draw_seen(const TimelinePage& page, const DepthAxis& axis, SvgText& svg) {
    for (const SightRecord& r : page.pixel().timeline.seen) {
        if (r.depth.size() < 2) continue;
        const TriangleLook& look = *page.look_of(r.what);
        svg.add("path", {{"d", curve_of(page, axis, r)}, {"class", "seen"}, {"stroke", look.colour}},
                fmt::format("{}: {}, {} to {} s, {:.1f} to {:.1f} m", look.letter, page.name_of(r.what),
                            page.time_text(r.when.begin_s), page.time_text(r.when.end_s), r.depth.front().depth_m,
                            r.depth.back().depth_m));
    }
    for (const SightRecord& r : page.pixel().timeline.seen) {
        if (r.depth.size() >= 2) draw_letter(page, axis, r, svg);
    }
}

}  // namespace

void draw_depths(const TimelinePage& page, const PageArea& area, SvgText& svg) {
    const DepthAxis axis(page.pixel(), area);
    draw_frame(page, axis, area, svg);
    draw_joints(page, area, svg);
    draw_passed(page, axis, svg);
    draw_seen(page, axis, svg);
    if (page.pixel().timeline.passed.empty())
        svg.text({area.middle_x(), 0.5 * (area.top + area.bottom)}, "about centre", "nothing but sky");
}

}  // namespace overfly
