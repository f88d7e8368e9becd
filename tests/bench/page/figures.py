# SPDX-License-Identifier: GPL-3.0-or-later
"""What a section of the page is made of: figures beside what was asked for, several beside each other, and lines."""
from dataclasses import dataclass, field

from results import NotMeasured, Source


@dataclass(frozen=True)
class Figure:
    """One number and what was asked for. With `over` it is the ratio of two sources."""
    label: str
    source: Source
    asked: float | None = None
    least: bool = False  # at least that much was asked for, else at most
    over: Source | None = None

    def value(self, results):
        value = results.number(self.source)
        if self.over is None or isinstance(value, NotMeasured):
            return value
        under = results.number(self.over)
        return under if isinstance(under, NotMeasured) else value / under

    def reached(self, value):
        """None if nothing was asked for or nothing was measured."""
        if self.asked is None or isinstance(value, NotMeasured):
            return None
        return value >= self.asked if self.least else value <= self.asked


@dataclass(frozen=True)
class AskedPlot:
    """Figures of one unit as bars, and as a table."""
    name: str  # of the picture's file
    title: str
    note: str
    unit: str
    figures: tuple
    logarithmic: bool = False


@dataclass(frozen=True)
class BesidePlot:
    """For each label the same of several: ours, then the others."""
    name: str
    title: str
    note: str
    unit: str
    names: tuple
    rows: tuple  # label, one source for each name
    logarithmic: bool = True


@dataclass(frozen=True)
class LinePlot:
    name: str
    title: str
    note: str
    x_unit: str
    unit: str
    series: tuple  # name, points: x (or the name of a size), source


@dataclass(frozen=True)
class Section:
    title: str
    text: str
    plots: tuple = field(default_factory=tuple)
