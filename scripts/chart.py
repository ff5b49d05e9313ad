"""Charts as SVG pages in the style of docs/figures, for scripts/plots. Lengths are in pixels of a screen."""

import math
from dataclasses import dataclass, field
from xml.sax.saxutils import escape

STYLE = """
text { font-family: "Helvetica Neue", Arial, "Liberation Sans", "DejaVu Sans", sans-serif }
text { font-size: 13px; fill: #1a1a1a }
.title { font-size: 21px; font-weight: bold }
.about { font-size: 13.5px; fill: #505050 }
.part { font-size: 14.5px; font-weight: bold }
.small { font-size: 12px; fill: #404040 }
.name { font-weight: bold }
.halo { stroke: #ffffff; stroke-width: 4; paint-order: stroke; stroke-linejoin: round }
.centre { text-anchor: middle }
.end { text-anchor: end }
.grid { stroke: #d2d2d2; stroke-width: 1 }
.axis { stroke: #404040; stroke-width: 1 }
.line { fill: none; stroke-width: 2.4; stroke-linejoin: round }
.dashed { stroke-dasharray: 6 4 }
.point { stroke: #ffffff; stroke-width: 1.2 }
"""

COLOURS = {"kinetic": "#0072B2", "discrete": "#D55E00", "interval": "#009E73"}


def number(value):
    """With as many digits as a label needs, and no exponent."""
    if abs(value) >= 1000:
        return f"{value:,.0f}"
    return f"{value:.3g}" if abs(value) >= 1e-4 else f"{value:.6f}".rstrip("0")


@dataclass
class Axis:
    """From `low` to `high`; `ticks` are values, or (value, text)."""

    label: str
    low: float
    high: float
    ticks: list
    log: bool = False

    def share(self, value):
        """0 at the low end, 1 at the high one."""
        if self.log:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)

    @staticmethod
    def covering(label, values):
        """A logarithmic axis from and to the 1, 2 or 5 times a power of ten around all values."""
        steps = [m * 10.0**e for e in range(-9, 10) for m in (1, 2, 5)]
        first = max(i for i, s in enumerate(steps) if s <= min(values) * 1.001)
        last = min(i for i, s in enumerate(steps) if s >= max(values) * 0.999)
        return Axis(label, steps[first], steps[last], steps[first : last + 1], log=True)

    def marks(self):
        return [t if isinstance(t, tuple) else (t, number(t)) for t in self.ticks]


@dataclass
class Series:
    """Points (x, y), a text for each or none, and a name beside point number `name_at`; offsets are (right, down)."""

    points: list
    colour: str
    name: str = ""
    name_at: int = -1
    name_offset: tuple = (0, -14)
    name_class: str = "centre"
    texts: list = field(default_factory=list)
    text_offset: tuple = (0, -10)
    text_class: str = "centre"
    dashed: bool = False


class Page:
    """An SVG document: a title, a line about it, and charts below."""

    def __init__(self, width, height, title, about):
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" role="img">',
            f"<title>{escape(title)}</title>",
            f"<style>{escape(STYLE)}</style>",
            f'<rect x="0" y="0" width="{width}" height="{height}" fill="#ffffff"/>',
        ]
        self.text(24, 36, title, "title")
        self.text(24, 58, about, "about")

    def add(self, element, **attributes):
        written = "".join(
            f' {key.rstrip("_").replace("_", "-")}="{round(v, 2) if isinstance(v, float) else escape(str(v))}"'
            for key, v in attributes.items()
        )
        self.parts.append(f"<{element}{written}/>")

    def text(self, x, y, words, style="", turned=False):
        turn = f' transform="rotate(-90 {x:.2f} {y:.2f})"' if turned else ""
        self.parts.append(f'<text x="{x:.2f}" y="{y:.2f}" class="{style}"{turn}>{escape(words)}</text>')

    def document(self):
        return "\n".join([*self.parts, "</svg>", ""])


class Chart:
    """A frame with two axes on a page."""

    def __init__(self, page, left, top, width, height, x, y, title=None):
        self.page, self.left, self.top, self.width, self.height = page, left, top, width, height
        self.x, self.y = x, y
        if title:
            letter, words = title
            page.text(left - 52, top - 16, letter, "part")
            page.text(left - 30, top - 16, words, "part")
        self._draw_axes()

    def at(self, point):
        return (
            self.left + self.width * self.x.share(point[0]),
            self.top + self.height * (1 - self.y.share(point[1])),
        )

    def _draw_axes(self):
        page, bottom, right = self.page, self.top + self.height, self.left + self.width
        for value, words in self.x.marks():
            x = self.at((value, self.y.low))[0]
            page.add("line", x1=x, y1=self.top, x2=x, y2=bottom, class_="grid")
            page.text(x, bottom + 19, words, "small centre")
        for value, words in self.y.marks():
            y = self.at((self.x.low, value))[1]
            page.add("line", x1=self.left, y1=y, x2=right, y2=y, class_="grid")
            page.text(self.left - 8, y + 4, words, "small end")
        page.add("line", x1=self.left, y1=bottom, x2=right, y2=bottom, class_="axis")
        page.add("line", x1=self.left, y1=self.top, x2=self.left, y2=bottom, class_="axis")
        page.text(self.left + 0.5 * self.width, bottom + 42, self.x.label, "centre")
        page.text(self.left - 52, self.top + 0.5 * self.height, self.y.label, "centre", turned=True)

    def draw(self, series):
        places = [self.at(p) for p in series.points]
        style = "line dashed" if series.dashed else "line"
        path = "M" + " L".join(f"{x:.2f} {y:.2f}" for x, y in places)
        self.page.add("path", d=path, class_=style, stroke=series.colour)
        if not series.dashed:
            for x, y in places:
                self.page.add("circle", cx=x, cy=y, r=4, fill=series.colour, class_="point")
        dx, dy = series.text_offset
        for (x, y), words in zip(places, series.texts):
            self.page.text(x + dx, y + dy, words, f"small halo {series.text_class}")
        if series.name:
            (x, y), (dx, dy) = places[series.name_at], series.name_offset
            self.page.text(x + dx, y + dy, series.name, f"name halo {series.name_class}")
