#include "shot/timeline_svg.h"

#include <algorithm>

#include <fmt/format.h>

#include "shot/timeline_page.h"

namespace overfly {
namespace {

constexpr double kMargin = 24.0;
constexpr double kTimeLineTop = 98.0;
constexpr double kTimeLineHeight = 70.0;
constexpr double kDepthsHeight = 270.0;
constexpr double kPanelHeight = 214.0, kLargePanelHeight = 400.0;
constexpr double kPanelGap = 18.0;
constexpr std::size_t kPanelsInRow = 3;
constexpr double kLegendHeight = 88.0;

// A font of every system; lines that stay readable when the page is shown at half its size.
constexpr const char* kStyle = R"(
text { font-family: "Helvetica Neue", Arial, "Liberation Sans", "DejaVu Sans", sans-serif; font-size: 13px; fill: #1a1a1a }
.title { font-size: 21px; font-weight: bold }
.about { font-size: 13.5px; fill: #505050 }
.part { font-size: 14.5px; font-weight: bold }
.small { font-size: 12px; fill: #404040 }
.letter { font-weight: bold; font-size: 14px; text-anchor: middle }
.halo { stroke: #ffffff; stroke-width: 4; paint-order: stroke; stroke-linejoin: round }
.letter.left { text-anchor: start }
.white { fill: #ffffff }
.centre { text-anchor: middle }
.end { text-anchor: end }
.sky { fill: #e3edf6 }
.bar { stroke: #ffffff; stroke-width: 0.8 }
.veil { fill: #ffffff; fill-opacity: 0.68 }
.shutter { fill: #303030 }
.open { fill: #f1f1ee }
.grid { stroke: #d2d2d2; stroke-width: 1 }
.axis { stroke: #404040; stroke-width: 1 }
.joint { stroke: #404040; stroke-width: 1; stroke-dasharray: 1 5 }
.frame { fill: none; stroke: #404040; stroke-width: 1 }
.panel { fill: #ffffff; stroke: #b8b8b8; stroke-width: 1 }
.triangle { fill-opacity: 0.14; stroke: #303030; stroke-width: 1.3; stroke-linejoin: round }
.curve { fill: none; stroke: #404040; stroke-width: 1; stroke-dasharray: 1.5 3.5 }
.passed { fill: none; stroke-width: 1.4; stroke-dasharray: 5 3.5 }
.seen { fill: none; stroke-width: 3.6; stroke-linecap: round; stroke-linejoin: round }
.begin { fill: #ffffff; stroke-width: 2 }
.false { fill: none; stroke: #303030; stroke-width: 1.6 }
.scale { fill: none; stroke: #404040; stroke-width: 1.2 }
)";

std::string counted(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string about(const TimelinePage& page) {
    const PixelTimeline& pixel = page.pixel();
    const TimeRange when = pixel.timeline.when;
    std::string frames = "between frames";
    if (pixel.frames.size() == 1) frames = fmt::format("frame {}", pixel.frames.front().number);
    if (pixel.frames.size() > 1)
        frames = fmt::format("frames {} to {}", pixel.frames.front().number, pixel.frames.back().number);
    return fmt::format("{} to {} s of the flight, {}, {}", page.time_text(when.begin_s), page.time_text(when.end_s),
                       frames, counted(pixel.timeline.pieces.size(), "piece") + " of motion");
}

void draw_title(const TimelinePage& page, SvgText& svg) {
    const PixelTimeline& pixel = page.pixel();
    svg.text({kMargin, 36.0}, "title",
             fmt::format("What pixel {}, {} of \"{}\" sees", pixel.x_px, pixel.y_px, pixel.shot));
    svg.text({kMargin, 58.0}, "about", about(page));
}

// A sample of how something is drawn, and what it means.
class Legend {
  public:
    Legend(const PageArea& area, SvgText& svg) : area_(area), x_(area.left), y_(area.top + 12.0), svg_(&svg) {}

    template <class Draw>
    void entry(double width, const char* words, const Draw& draw) {
        if (x_ + width > area_.right) {
            x_ = area_.left;
            y_ += 24.0;
        }
        draw(x_, y_);
        svg_->text({x_ + 42.0, y_ + 4.0}, "small", words);
        x_ += width;
    }

  private:
    PageArea area_;
    double x_, y_;
    SvgText* svg_;
};

// The panels of the curves: three in a row, or one that is large.
struct Panels {
    std::size_t count = 0;

    [[nodiscard]] std::size_t in_row() const { return std::clamp<std::size_t>(count, 1, kPanelsInRow); }
    [[nodiscard]] double panel_height() const { return count == 1 ? kLargePanelHeight : kPanelHeight; }
    [[nodiscard]] double height() const {
        const std::size_t rows = (count + in_row() - 1) / in_row();
        return static_cast<double>(rows) * (panel_height() + kPanelGap);
    }
    [[nodiscard]] PageArea area(std::size_t index, double top) const {
        const std::size_t row = index / in_row();
        const std::size_t column = index % in_row();
        const auto columns = static_cast<double>(in_row());
        const double width = (TimelinePage::kWidth - 2.0 * kMargin - kPanelGap * (columns - 1.0)) / columns;
        const double left = kMargin + static_cast<double>(column) * (width + kPanelGap);
        const double row_top = top + static_cast<double>(row) * (panel_height() + kPanelGap);
        return {left, row_top, left + width, row_top + panel_height()};
    }
};

}  // namespace

void draw_legend(const PageArea& area, SvgText& svg) {
    Legend legend(area, svg);
    const auto line = [&](const char* style, const char* colour) {
        return [&svg, style, colour](double x, double y) {
            svg.add("path", {{"d", fmt::format("M{} {}h34", svg_number(x), svg_number(y))},
                             {"class", style},
                             {"stroke", std::string(colour)}});
        };
    };
    const auto circle = [&](double x, double y, const char* style, const char* fill) {
        svg.add("circle", {{"cx", x},
                           {"cy", y},
                           {"r", 4.5},
                           {"class", style},
                           {"fill", std::string(fill)},
                           {"stroke", std::string("#0072B2")}});
    };
    legend.entry(290.0, "seen: the nearest, after occlusion", line("seen", "#0072B2"));
    legend.entry(290.0, "passed but hidden: before occlusion", line("passed", "#6b6b6b"));
    legend.entry(300.0, "where the line meets the plane", line("curve", "#404040"));
    legend.entry(290.0, "seen from here to here", [&](double x, double y) {
        circle(x + 8.0, y, "begin", "#ffffff");
        circle(x + 26.0, y, "", "#0072B2");
    });
    legend.entry(290.0, "crosses an edge's line beyond the edge", [&](double x, double y) {
        svg.add("path", {{"d", fmt::format("M{} {}l8 8m0 -8l-8 8", svg_number(x + 13.0), svg_number(y - 4.0))},
                         {"class", "false"}});
    });
    legend.entry(300.0, "a shutter is open; pale bars: none is", [&](double x, double y) {
        svg.add("rect", {{"x", x}, {"y", y - 7.0}, {"width", 34.0}, {"height", 14.0}, {"class", "open"}});
        svg.add("rect", {{"x", x}, {"y", y - 3.0}, {"width", 34.0}, {"height", 6.0}, {"class", "shutter"}});
    });
    legend.entry(290.0, "the next piece of the motion begins", [&](double x, double y) {
        svg.add("line", {{"x1", x + 17.0}, {"y1", y - 9.0}, {"x2", x + 17.0}, {"y2", y + 9.0}, {"class", "joint"}});
    });
}

std::string timeline_svg(const PixelTimeline& pixel) {
    const TimelinePage page(pixel);
    const double depths_top = kTimeLineTop + kTimeLineHeight + 34.0;
    const double panels_top = depths_top + kDepthsHeight + 82.0;
    const Panels panels = {pixel.curves.size()};
    const double legend_top = panels_top + (panels.count == 0 ? -20.0 : panels.height() + 4.0);
    const double height = legend_top + kLegendHeight;
    SvgText svg(TimelinePage::kWidth, height,
                fmt::format("What pixel {}, {} of {} sees", pixel.x_px, pixel.y_px, pixel.shot), kStyle);
    svg.add("rect", {{"x", 0.0}, {"y", 0.0}, {"width", TimelinePage::kWidth}, {"height", height}, {"fill", "#ffffff"}});
    draw_title(page, svg);
    const auto part = [&](double y, const char* letter, const std::string& words) {
        svg.text({kMargin, y}, "part", letter);
        svg.text({kMargin + 22.0, y}, "part", words);
    };
    constexpr double kLeft = TimelinePage::kLeft;
    constexpr double kRight = TimelinePage::kRight;
    part(kTimeLineTop - 12.0, "a", "Which triangle, when");
    draw_time_line(page, {kLeft, kTimeLineTop, kRight, kTimeLineTop + kTimeLineHeight}, svg);
    const std::size_t passed = pixel.timeline.passed.size();
    part(depths_top - 12.0, "b",
         fmt::format("Depth: {} before occlusion, {} after it", counted(passed, "record"),
                     counted(pixel.timeline.seen.size(), "record")));
    draw_depths(page, {kLeft, depths_top, kRight, depths_top + kDepthsHeight}, svg);
    if (!pixel.curves.empty())
        part(panels_top - 12.0, "c",
             "Curves of intersection in the planes of the triangles, from above, east to the right");
    for (std::size_t i = 0; i < panels.count; ++i) draw_curve(page, pixel.curves[i], panels.area(i, panels_top), svg);
    draw_legend({kMargin, legend_top, TimelinePage::kWidth - kMargin, height}, svg);
    return svg.document();
}

}  // namespace overfly
