// A curve of intersection: a triangle in its own plane and the way of the line of sight's hit point through it.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "shot/timeline_page.h"

namespace overfly {
namespace {

constexpr double kCaption = 22.0;  // height of the words above the picture
constexpr double kRoom = 0.16;     // around the triangle, of its larger extent

// From a plane to a part of the page.
class PlaneMap {
  public:
    PlaneMap(const std::array<PlanePoint, 3>& corners, const PageArea& area) : area_(area) {
        const auto [west, east] = std::ranges::minmax(corners, {}, &PlanePoint::x_m);
        const auto [south, north] = std::ranges::minmax(corners, {}, &PlanePoint::y_m);
        middle_ = {0.5 * (west.x_m + east.x_m), 0.5 * (south.y_m + north.y_m)};
        const double width_m = std::max(east.x_m - west.x_m, 1e-9) * (1.0 + 2.0 * kRoom);
        const double height_m = std::max(north.y_m - south.y_m, 1e-9) * (1.0 + 2.0 * kRoom);
        per_m_ = std::min(area.width() / width_m, area.height() / height_m);
    }
    [[nodiscard]] SvgPoint at(PlanePoint p) const {
        return {area_.middle_x() + per_m_ * (p.x_m - middle_.x_m),
                0.5 * (area_.top + area_.bottom) - per_m_ * (p.y_m - middle_.y_m)};
    }
    [[nodiscard]] double per_m() const { return per_m_; }
    // Whether what is there can be seen; the clip path does the rest.
    [[nodiscard]] bool is_near(PlanePoint p) const {
        const SvgPoint q = at(p);
        return std::abs(q.x - area_.middle_x()) < 3.0 * area_.width() &&
               std::abs(q.y - 0.5 * (area_.top + area_.bottom)) < 3.0 * area_.height();
    }

  private:
    PageArea area_;
    PlanePoint middle_;
    double per_m_ = 1.0;
};

// A curve's point at a time between two that it has.
std::optional<PlanePoint> point_at(const PlaneCurve& curve, double time_s) {
    for (const auto& stretch : curve.path) {
        const auto after = std::ranges::lower_bound(stretch, time_s, {}, &CurvePoint::time_s);
        if (after == stretch.end()) continue;
        if (after == stretch.begin()) {
            if (after->time_s == time_s) return after->at;
            continue;
        }
        const CurvePoint& a = *(after - 1);
        const double share = (time_s - a.time_s) / (after->time_s - a.time_s);
        return PlanePoint{a.at.x_m + share * (after->at.x_m - a.at.x_m), a.at.y_m + share * (after->at.y_m - a.at.y_m)};
    }
    return std::nullopt;
}

// The curve from one time to another.
std::string path_between(const PlaneCurve& curve, const PlaneMap& map, TimeRange when) {
    std::string d;
    for (const auto& stretch : curve.path) {
        std::vector<SvgPoint> points;
        const auto flush = [&] {
            if (points.size() > 1) d += svg_path(points);
            points.clear();
        };
        if (const auto begin = point_at(curve, when.begin_s); begin && stretch.front().time_s <= when.begin_s)
            points.push_back(map.at(*begin));
        for (const CurvePoint& p : stretch) {
            if (p.time_s <= when.begin_s || p.time_s >= when.end_s) continue;
            if (map.is_near(p.at)) {
                points.push_back(map.at(p.at));
            } else {
                flush();
            }
        }
        if (const auto end = point_at(curve, when.end_s);
            end && stretch.back().time_s >= when.end_s && map.is_near(*end))
            points.push_back(map.at(*end));
        flush();
    }
    return d;
}

void draw_triangle(const PlaneCurve& curve, const PlaneMap& map, const std::string& colour, SvgText& svg) {
    std::vector<SvgPoint> corners;
    for (const PlanePoint& p : curve.corners) corners.push_back(map.at(p));
    // The straight lines through the edges, which the roots of the edge functions belong to.
    for (std::size_t k = 0; k < 3; ++k) {
        const SvgPoint a = corners[k];
        const SvgPoint b = corners[(k + 1) % 3];
        const double reach = 1000.0 / std::max(1.0, std::hypot(b.x - a.x, b.y - a.y));
        svg.add("line", {{"x1", a.x - reach * (b.x - a.x)},
                         {"y1", a.y - reach * (b.y - a.y)},
                         {"x2", b.x + reach * (b.x - a.x)},
                         {"y2", b.y + reach * (b.y - a.y)},
                         {"class", "grid"}});
    }
    svg.add("path", {{"d", svg_path(corners) + "Z"}, {"class", "triangle"}, {"fill", colour}});
}

void draw_marks(const PlaneCurve& curve, const PlaneMap& map, const std::string& colour,
                std::span<const TimeRange> seen, SvgText& svg) {
    for (const CurvePoint& p : curve.false_crossings) {
        const SvgPoint at = map.at(p.at);
        if (!map.is_near(p.at)) continue;
        svg.add("path",
                {{"d", fmt::format("M{} {}l8 8m0 -8l-8 8", svg_number(at.x - 4.0), svg_number(at.y - 4.0))},
                 {"class", "false"}},
                fmt::format("{:.5f} s: crosses the line of an edge beyond the edge", p.time_s));
    }
    for (const TimeRange& when : seen) {
        const auto begin = point_at(curve, when.begin_s);
        const auto end = point_at(curve, when.end_s);
        if (begin) {
            const SvgPoint at = map.at(*begin);
            svg.add("circle", {{"cx", at.x}, {"cy", at.y}, {"r", 4.5}, {"class", "begin"}, {"stroke", colour}},
                    fmt::format("seen from {:.5f} s", when.begin_s));
        }
        if (end) {
            const SvgPoint at = map.at(*end);
            svg.add("circle", {{"cx", at.x}, {"cy", at.y}, {"r", 4.5}, {"fill", colour}},
                    fmt::format("seen until {:.5f} s", when.end_s));
        }
    }
}

void draw_scale_bar(const PlaneMap& map, const PageArea& area, SvgText& svg) {
    const double length_m = round_step(area.width() / map.per_m(), 8);
    const double y = area.bottom - 9.0;
    const double right = area.left + 10.0 + map.per_m() * length_m;
    svg.add("path", {{"d", fmt::format("M{0} {1}v5h{2}v-5", svg_number(area.left + 10.0), svg_number(y - 5.0),
                                       svg_number(map.per_m() * length_m))},
                     {"class", "scale"}});
    svg.text({right + 6.0, y + 2.0}, "small", fmt::format("{:g} m", length_m));
}

}  // namespace

void draw_curve(const TimelinePage& page, const PlaneCurve& curve, const PageArea& area, SvgText& svg) {
    const TriangleLook* const look = page.look_of(curve.what);
    const std::string colour = look != nullptr ? look->colour : kUnseenColour;
    std::vector<TimeRange> seen;
    double seen_s = 0.0;
    for (const SightRecord& r : page.pixel().timeline.seen) {
        if (r.what == curve.what) seen.push_back(r.when);
        if (r.what == curve.what) seen_s += r.when.duration_s();
    }
    if (look != nullptr)
        svg.text({area.left, area.top + 14.0}, "letter left", look->letter, {{"style", "fill:" + colour}});
    svg.text(
        {area.left + (look != nullptr ? 10.0 + 9.0 * static_cast<double>(look->letter.size()) : 0.0), area.top + 14.0},
        "small", fmt::format("{}, seen for {:.2f} ms", page.name_of(curve.what), 1000.0 * seen_s));

    const PageArea picture = {area.left, area.top + kCaption, area.right, area.bottom};
    svg.open("svg",
             {{"x", picture.left}, {"y", picture.top}, {"width", picture.width()}, {"height", picture.height()}});
    const PageArea inside = {0.0, 0.0, picture.width(), picture.height()};
    const PlaneMap map(curve.corners, inside);
    svg.add("rect",
            {{"x", 0.0}, {"y", 0.0}, {"width", inside.width()}, {"height", inside.height()}, {"class", "panel"}});
    draw_triangle(curve, map, colour, svg);
    svg.add("path", {{"d", path_between(curve, map, page.pixel().timeline.when)}, {"class", "curve"}});
    for (const SightRecord& r : page.pixel().timeline.passed) {
        if (r.what != curve.what) continue;
        svg.add("path", {{"d", path_between(curve, map, r.when)}, {"class", "passed"}, {"stroke", colour}});
    }
    for (const TimeRange& when : seen)
        svg.add("path", {{"d", path_between(curve, map, when)}, {"class", "seen"}, {"stroke", colour}});
    draw_marks(curve, map, colour, seen, svg);
    draw_scale_bar(map, inside, svg);
    svg.close();
}

}  // namespace overfly
