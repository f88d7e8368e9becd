# SPDX-License-Identifier: GPL-3.0-or-later
"""The ground of all plots: a small SVG file that can be read in light and in dark, and by a screen reader."""
import html
import math

WIDTH = 780
SIDE = 16
LINE = 17  # of text
# Colours of Okabe and Ito, that are told apart with any colour vision; brighter ones on a dark ground.
STYLE = """
text { font: 13px system-ui, sans-serif; fill: #1c1e21; } .title { font-size: 15px; font-weight: 600; } .strong { font-weight: 600; }
.soft { fill: #565c63; font-size: 12px; } .ground { fill: #fff; stroke: #d5dade; } .grid { stroke: #dfe3e7; } .axis { stroke: #767d85; }
.asked { stroke: #1c1e21; stroke-width: 2.5; } .s0 { fill: #0072b2; stroke: #0072b2; } .s1 { fill: #d55e00; stroke: #d55e00; }
.s2 { fill: #6a7178; stroke: #6a7178; } .s3 { fill: #00805d; stroke: #00805d; } .s4 { fill: #a8558a; stroke: #a8558a; }
.line { fill: none; stroke-width: 2; } .bar { stroke: none; } .dash { stroke-dasharray: 6 4; }
@media (prefers-color-scheme: dark) {
  text { fill: #e3e6e8; } .soft { fill: #a9b1b8; } .ground { fill: #1b1e21; stroke: #444b52; } .grid { stroke: #33393f; }
  .axis { stroke: #8b939b; } .asked { stroke: #f4f6f7; } .s0 { fill: #56b4e9; stroke: #56b4e9; } .s1 { fill: #f08a4b; stroke: #f08a4b; }
  .s2 { fill: #9aa2aa; stroke: #9aa2aa; } .s3 { fill: #2fb891; stroke: #2fb891; } .s4 { fill: #d79cc1; stroke: #d79cc1; } .line { fill: none; }
}
"""


def number_text(value):
    """Three digits that count, thousands with commas; what is whole and small as it is."""
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    text = f"{value:,.{digits}f}"
    return text if float(value) != int(value) or digits == 0 else f"{int(value):,}"


def tick_text(value):
    return f"{value:,.0f}" if value >= 1 and value == int(value) else f"{value:.6g}"


class Drawing:
    def __init__(self, title, description, height):
        self.title, self.description, self.height, self.parts = title, description, height, []

    def text(self, x, y, words, style="", anchor="start"):
        classes = f' class="{style}"' if style else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}"{classes} text-anchor="{anchor}">{html.escape(words.replace("^3", "³"))}</text>')

    def line(self, x1, y1, x2, y2, style):
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" class="{style}"/>')

    def bar(self, x, y, width, height, style):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{max(width, 1):.1f}" height="{height:.1f}" class="bar {style}"/>')

    def path(self, points, style):
        corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{corners}" class="line {style}"/>')

    def mark(self, x, y, number, style):
        """A circle, a square or a triangle: told apart without colours, too."""
        shapes = (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" class="{style}"/>',
                  f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" class="{style}"/>',
                  f'<path d="M {x:.1f} {y - 5:.1f} l 5 9 h -10 z" class="{style}"/>')
        self.parts.append(shapes[number % len(shapes)])

    def header(self, note):
        self.text(SIDE, 26, self.title, "title")
        self.text(SIDE, 26 + LINE, note, "soft")

    def svg(self):
        box = f'0 0 {WIDTH} {self.height:.0f}'
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" width="{WIDTH}" height="{self.height:.0f}" role="img" '
                f'aria-labelledby="title description">\n<title id="title">{html.escape(self.title)}</title>\n'
                f'<desc id="description">{html.escape(self.description)}</desc>\n<style>{STYLE}</style>\n'
                f'<rect class="ground" x=".5" y=".5" width="{WIDTH - 1}" height="{self.height - 1:.0f}" rx="6"/>\n'
                + "\n".join(self.parts) + "\n</svg>\n")


class Scale:
    """From values to places along an axis, linear from 0 on or logarithmic."""

    def __init__(self, values, start, end, logarithmic):
        self.start, self.end, self.logarithmic = start, end, logarithmic
        if logarithmic:
            self.low, self.high = 0.8 * min(values), 1.15 * max(values)
        else:
            self.low, self.high = 0, 1.04 * max(values)

    def place(self, value):
        if self.logarithmic:
            share = math.log(max(value, self.low) / self.low) / math.log(self.high / self.low)
        else:
            share = value / self.high
        return self.start + share * (self.end - self.start)

    def ticks(self):
        if not self.logarithmic:
            step = 10 ** math.floor(math.log10(self.high / 2))
            step *= next(factor for factor in (1, 2, 5, 10) if self.high / (factor * step) <= 6)
            return [step * i for i in range(int(self.high / step) + 1)]
        powers = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        for factors in ((1, 2, 5), (1, 3), (1,)):
            ticks = [factor * 10.0 ** power for power in powers for factor in factors]
            ticks = [tick for tick in ticks if self.low <= tick <= self.high]
            if len(ticks) <= 7:
                break
        return ticks
