// The time line: which triangle is seen when, and when shutters are open.
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "shot/timeline_page.h"

namespace overfly {
namespace {

constexpr double kShutterHeight = 6.0;
constexpr double kGap = 5.0;     // between the bar and the shutters
constexpr double kNarrow = 4.0;  // bars that a line between them would hide
constexpr double kLabelWidth = 58.0, kLabelHeight = 22.0, kLabelRoom = 22.0;

struct Shown {
    double left, right;

    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double middle() const { return 0.5 * (left + right); }
};

Shown shown(const TimelinePage& page, TimeRange when) {
    const TimeRange inside = intersection(when, page.pixel().timeline.when);
    return {page.x_at(inside.begin_s), page.x_at(inside.end_s)};
}

void draw_bars(const TimelinePage& page, const PageArea& row, SvgText& svg) {
    svg.add("rect",
            {{"x", row.left}, {"y", row.top}, {"width", row.width()}, {"height", row.height()}, {"class", "sky"}},
            "sky");
    for (const SightRecord& r : page.pixel().timeline.seen) {
        const TriangleLook& look = *page.look_of(r.what);
        const Shown at = shown(page, r.when);
        const std::string tip = fmt::format("{}: {}, {} to {} s", look.letter, page.name_of(r.what),
                                            page.time_text(r.when.begin_s), page.time_text(r.when.end_s));
        svg.add("rect",
                {{"x", at.left},
                 {"y", row.top},
                 {"width", at.width()},
                 {"height", row.height()},
                 {"fill", look.colour},
                 {"class", at.width() > kNarrow ? "bar" : "narrow"}},
                tip);
    }
}

// The times at which no shutter is open, on the page. Nothing of what is seen then gets into a frame.
std::vector<Shown> closed_times(const TimelinePage& page, const PageArea& row) {
    std::vector<Shown> closed;
    double from = row.left;
    for (const PlannedFrame& f : page.pixel().frames) {
        const Shown open = shown(page, f.exposure);
        if (open.left > from) closed.push_back({from, open.left});
        from = std::max(from, open.right);
    }
    if (row.right > from) closed.push_back({from, row.right});
    return closed;
}

// The letter of a bar stands in its widest part between openings and closings of the shutter.
void draw_letters(const TimelinePage& page, const PageArea& row, std::span<const Shown> closed, SvgText& svg) {
    for (const SightRecord& r : page.pixel().timeline.seen) {
        const TriangleLook& look = *page.look_of(r.what);
        const Shown bar = shown(page, r.when);
        Shown widest = {bar.left, bar.left};
        bool is_pale = false;
        const auto offer = [&](double left, double right, bool pale) {
            const Shown part = {std::max(left, bar.left), std::min(right, bar.right)};
            if (part.width() <= widest.width()) return;
            widest = part;
            is_pale = pale;
        };
        double from = row.left;
        for (const Shown& c : closed) {
            offer(from, c.left, false);
            offer(c.left, c.right, true);
            from = c.right;
        }
        offer(from, row.right, false);
        if (widest.width() < 10.0 * static_cast<double>(look.letter.size()) + 4.0) continue;
        svg.text({widest.middle(), row.top + 0.5 * row.height() + 5.0},
                 look.is_dark && !is_pale ? "letter white" : "letter", look.letter);
    }
}

void draw_shutters(const TimelinePage& page, const PageArea& row, SvgText& svg) {
    const std::vector<PlannedFrame>& frames = page.pixel().frames;
    const double together = kLabelWidth * static_cast<double>(frames.size()) / row.width();
    const auto labelled = static_cast<std::size_t>(std::max(1.0, std::ceil(together)));
    double label_from = row.left;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const PlannedFrame& f = frames[k];
        const Shown open = shown(page, f.exposure);
        svg.add(
            "rect",
            {{"x", open.left},
             {"y", row.top},
             {"width", std::max(1.0, open.width())},
             {"height", kShutterHeight},
             {"class", "shutter"}},
            fmt::format("frame {}: shutter open {:.5f} to {:.5f} s", f.number, f.exposure.begin_s, f.exposure.end_s));
        if (k % labelled != 0 || open.middle() < label_from) continue;
        const double middle = std::clamp(open.middle(), row.left + kLabelRoom, row.right - kLabelRoom);
        svg.text({middle, row.top + 20.0}, "small centre", fmt::format("frame {}", f.number));
        label_from = middle + kLabelWidth;
    }
}

}  // namespace

void draw_time_line(const TimelinePage& page, const PageArea& area, SvgText& svg) {
    const PageArea bars = {area.left, area.top, area.right, area.bottom - kShutterHeight - kGap - kLabelHeight};
    draw_bars(page, bars, svg);
    const std::vector<Shown> closed = closed_times(page, bars);
    for (const Shown& c : closed) {
        svg.add("rect",
                {{"x", c.left}, {"y", bars.top}, {"width", c.width()}, {"height", bars.height()}, {"class", "veil"}});
    }
    draw_letters(page, bars, closed, svg);
    svg.text({area.left - 10.0, bars.top + 0.5 * bars.height() + 4.0}, "small end", "seen");
    const PageArea shutters = {area.left, bars.bottom + kGap, area.right, area.bottom};
    svg.text({area.left - 10.0, shutters.top + 7.0}, "small end", "shutter");
    draw_shutters(page, shutters, svg);
}

}  // namespace overfly
