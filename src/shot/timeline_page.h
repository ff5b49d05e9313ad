#pragma once

#include <map>
#include <string>

#include "io/svg_text.h"
#include "shot/pixel_timeline.h"

namespace overfly {

// What the parts of a timeline's drawing share: where things are on the page, and how triangles look.

// A part of the page, in units of SVG (pixels of a screen).
struct PageArea {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    [[nodiscard]] double middle_x() const { return 0.5 * (left + right); }
};

// How a triangle that is seen is told from others: by the order in which it is first seen.
struct TriangleLook {
    std::string letter;    // A to Z, AA, AB ...
    std::string colour;    // of lines and areas
    bool is_dark = false;  // letters on it are white
};

inline constexpr const char* kUnseenColour = "#6b6b6b";  // of a triangle that never is

class TimelinePage {
  public:
    // REQUIRES: pixel outlives this.
    explicit TimelinePage(const PixelTimeline& pixel);

    [[nodiscard]] const PixelTimeline& pixel() const { return *pixel_; }
    // None for a triangle that is never seen.
    [[nodiscard]] const TriangleLook* look_of(SurfaceTriangle what) const;
    // "triangle 7" of the terrain, "glider 7" of a body of that name.
    [[nodiscard]] std::string name_of(SurfaceTriangle what) const;
    // Where a time is on the page, the same in all parts that have time along x.
    [[nodiscard]] double x_at(double time_s) const;
    [[nodiscard]] std::string time_text(double time_s) const;  // with the digits that this stretch calls for

    static constexpr double kWidth = 960.0;
    static constexpr double kLeft = 76.0, kRight = 936.0;  // of what has time along x

  private:
    const PixelTimeline* pixel_;
    std::map<SurfaceTriangle, TriangleLook> looks_;
};

// The parts, each within its area.
void draw_time_line(const TimelinePage& page, const PageArea& area, SvgText& svg);
void draw_depths(const TimelinePage& page, const PageArea& area, SvgText& svg);
void draw_curve(const TimelinePage& page, const PlaneCurve& curve, const PageArea& area, SvgText& svg);
void draw_legend(const PageArea& area, SvgText& svg);

// A step of 1, 2 or 5 times a power of ten that divides a length into `most` parts at most.
[[nodiscard]] double round_step(double length, int most);

}  // namespace overfly
