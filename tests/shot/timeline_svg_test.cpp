#include "shot/timeline_svg.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace overfly {
namespace {

SightRecord record(TriangleId triangle, TimeRange when, double depth_m) {
    return {{0, triangle}, when, {{when.begin_s, depth_m}, {when.end_s, depth_m + 1.0}}};
}

// Two triangles seen one after the other, one of them hidden at first; one that is never seen.
PixelTimeline small_timeline() {
    PixelTimeline pixel;
    pixel.shot = "a & b";
    pixel.picture = {960, 540};
    pixel.surfaces = {"terrain", "glider"};
    pixel.x_px = 12;
    pixel.y_px = 34;
    pixel.frames = {{7, 1.0, {1.0, 1.2}, {}}, {8, 1.4, {1.4, 1.6}, {}}};
    pixel.timeline = {{},
                      {1.0, 1.6},
                      {{1.0, 1.3}, {1.3, 1.6}},
                      {record(40, {1.0, 1.3}, 500.0), record(41, {1.1, 1.6}, 900.0), record(42, {1.0, 1.6}, 5000.0)},
                      {record(40, {1.0, 1.3}, 500.0), record(41, {1.3, 1.6}, 900.0)}};
    PlaneCurve curve;
    curve.what = {0, 41};
    curve.corners = {{{0, 0}, {10, 0}, {0, 10}}};
    curve.path = {{{1.0, {-5, 2}}, {1.6, {8, 2}}}};
    curve.crossings = {{1.1, {0, 2}}};
    curve.false_crossings = {{1.05, {-2, 2}}};
    pixel.curves = {curve};
    return pixel;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

// Tags that are opened are closed, in the right order; no bare ampersand.
void expect_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
        const std::size_t end = svg.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const std::string tag = svg.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find(' '));
        if (name.front() == '/') {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ("/" + open.back(), name);
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
    }
    EXPECT_TRUE(open.empty());
    for (std::size_t at = svg.find('&'); at != std::string::npos; at = svg.find('&', at + 1))
        EXPECT_LT(svg.find(';', at), at + 7);
    EXPECT_EQ(count(svg, "nan"), 0U);
}

TEST(TimelineSvg, DrawsEveryRecord) {
    const std::string svg = timeline_svg(small_timeline());
    expect_well_formed(svg);
    EXPECT_NE(svg.find("What pixel 12, 34 of &quot;a &amp; b&quot; sees"), std::string::npos);
    EXPECT_EQ(count(svg, "class=\"bar\""), 2U);
    // Three depths and one curve's hidden part; two that are seen, and one in the plane; one of each in the legend.
    EXPECT_EQ(count(svg, "class=\"passed\""), 5U);
    EXPECT_EQ(count(svg, "class=\"seen\""), 4U);
    EXPECT_EQ(count(svg, "class=\"false\""), 2U);
    EXPECT_NE(svg.find(">frame 7<"), std::string::npos);
    EXPECT_NE(svg.find(">frame 8<"), std::string::npos);
    EXPECT_NE(svg.find("3 records before occlusion, 2 records after it"), std::string::npos);
}

TEST(TimelineSvg, PutsTimesWhereTheyAre) {
    const std::string svg = timeline_svg(small_timeline());
    // The page's time runs from x = 76 to 936: half of it for each triangle.
    EXPECT_NE(svg.find("<rect x=\"76\" y=\"98\" width=\"430\""), std::string::npos);
    EXPECT_NE(svg.find("<rect x=\"506\" y=\"98\" width=\"430\""), std::string::npos);
}

TEST(TimelineSvg, OfTheSky) {
    PixelTimeline pixel = small_timeline();
    pixel.timeline.passed.clear();
    pixel.timeline.seen.clear();
    pixel.curves.clear();
    const std::string svg = timeline_svg(pixel);
    expect_well_formed(svg);
    EXPECT_NE(svg.find("nothing but sky"), std::string::npos);
    EXPECT_EQ(count(svg, "Curves of intersection"), 0U);
}

TEST(TimelineSvg, OfInstants) {
    PixelTimeline pixel = small_timeline();
    for (PlannedFrame& f : pixel.frames) f.exposure.end_s = f.exposure.begin_s;
    expect_well_formed(timeline_svg(pixel));
}

TEST(TimelineSvg, NamesBodies) {
    PixelTimeline pixel = small_timeline();
    pixel.timeline.seen[1].what.surface = 1;
    const std::string svg = timeline_svg(pixel);
    EXPECT_NE(svg.find("B: glider 41, "), std::string::npos);
    EXPECT_NE(svg.find("A: triangle 40, "), std::string::npos);
}

// As many triangles as a page never has room for.
TEST(TimelineSvg, OfManyTriangles) {
    PixelTimeline pixel = small_timeline();
    pixel.timeline.seen.clear();
    pixel.timeline.passed.clear();
    for (unsigned k = 0; k < 800; ++k) {
        const double begin_s = 1.0 + 0.6 * k / 800.0;
        pixel.timeline.seen.push_back(record(k, {begin_s, begin_s + 0.6 / 800.0}, 100.0 + k));
        pixel.timeline.passed.push_back(pixel.timeline.seen.back());
    }
    pixel.curves.clear();
    const std::string svg = timeline_svg(pixel);
    expect_well_formed(svg);
    EXPECT_EQ(count(svg, "class=\"narrow\""), 800U);
}

// A triangle that stands on edge in the view, and one that the camera reaches: depths and curves without a point.
TEST(TimelineSvg, OfRecordsWithoutDepth) {
    PixelTimeline pixel = small_timeline();
    pixel.timeline.seen[0].depth.clear();
    pixel.timeline.passed[0].depth.clear();
    pixel.curves[0].path.clear();
    expect_well_formed(timeline_svg(pixel));
}

}  // namespace
}  // namespace overfly
