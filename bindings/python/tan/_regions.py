# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of space, for focuses and windows, and the error fields that they make."""
from __future__ import annotations

import dataclasses
from typing import Any, Iterable, List, Optional, Tuple, Union

from ._errors import WrongUsage
from ._numbers import Vector, choice, listed, number, vector


def _written(*numbers: float) -> str:
    return ",".join(repr(float(value)) for value in numbers)


@dataclasses.dataclass(frozen=True)
class Region:
    """A region of space. As a focus, the error in it is at most `error` (% of the range of values) and grows to the one outside over
    the length `falloff`."""

    error: Optional[float]
    falloff: float

    def __post_init__(self) -> None:
        self._keep("error", None if self.error is None else number(self.error, "error", least=0))
        self._keep("falloff", number(self.falloff, "falloff", least=0))

    def _keep(self, name: str, value: Any) -> None:
        """A member, checked; the only time that it is set."""
        object.__setattr__(self, name, value)

    def is_beside(self, least: Vector, largest: Vector) -> bool:
        """Whether it has nothing in common with a box."""
        return False

    def shape(self) -> str:
        """Its beginning in the text of a field."""
        raise TypeError("tan.Region is what regions have in common. Take tan.sphere(), tan.box() or tan.half_space().")

    def field(self, outside: float) -> str:
        """The error field of this focus as a text, where the error elsewhere is `outside`, in %."""
        if self.error is None:
            raise WrongUsage("A focus needs an error: tan.sphere(centre, radius, error=0.2).")
        return f"{self.shape()}; {_written(min(self.error, outside), outside, self.falloff)})"


@dataclasses.dataclass(frozen=True)
class Sphere(Region):
    """A ball: sphere() makes one."""

    centre: Tuple[float, ...]
    radius: float

    def __post_init__(self) -> None:
        super().__post_init__()
        self._keep("centre", vector(self.centre, "centre"))
        self._keep("radius", number(self.radius, "radius", least=0))

    def is_beside(self, least: Vector, largest: Vector) -> bool:
        away = [max(low - place, 0, place - high) for low, place, high in zip(least, self.centre, largest)]
        return bool(sum(length**2 for length in away) > self.radius**2)

    def shape(self) -> str:
        return f"sphere({_written(*self.centre, self.radius)}"


@dataclasses.dataclass(frozen=True)
class Box(Region):
    """A box along the axes: box() makes one."""

    least: Tuple[float, ...]
    largest: Tuple[float, ...]
    border: str

    def __post_init__(self) -> None:
        super().__post_init__()
        self._keep("least", vector(self.least, "least"))
        self._keep("largest", vector(self.largest, "largest"))
        choice(self.border, "border", ("intersecting", "contained", "clipped"))

    def is_beside(self, least: Vector, largest: Vector) -> bool:
        return any(bool(low > end or high < begin) for low, high, begin, end in zip(self.least, self.largest, least, largest))

    def shape(self) -> str:
        return f"box({_written(*self.least, *self.largest)}"


@dataclasses.dataclass(frozen=True)
class HalfSpace(Region):
    """What lies on one side of a plane: half_space() makes one."""

    normal: Tuple[float, ...]
    offset: float

    def __post_init__(self) -> None:
        super().__post_init__()
        self._keep("normal", vector(self.normal, "normal"))
        self._keep("offset", number(self.offset, "offset"))

    def shape(self) -> str:
        return f"halfspace({_written(*self.normal, self.offset)}"


def sphere(centre: Vector, radius: float, *, error: Optional[float] = None, falloff: float = 0) -> Sphere:
    """A ball as a focus of Model.mesh(): centre (x, y, z), radius and falloff in units of length, error in % of the range of values.

    >>> sphere((8, 8, 8), 3, error=0.5, falloff=4)
    Sphere(error=0.5, falloff=4.0, centre=(8.0, 8.0, 8.0), radius=3.0)
    """
    return Sphere(error, falloff, vector(centre, "centre"), radius)


def box(least: Vector, largest: Vector, *, error: Optional[float] = None, falloff: float = 0, border: str = "intersecting") -> Box:
    """A box along the axes, from the corner `least` to the corner `largest`, (x, y, z) each: a focus or a window of Model.mesh().

    `error` and `falloff` are those of a focus. `border` says what becomes of tetrahedra at the border of a window: "intersecting" keeps
    all that touch it, "contained" those that lie in it whole, and "clipped" cuts them at the window.
    """
    return Box(error, falloff, vector(least, "least"), vector(largest, "largest"), border)


def half_space(normal: Vector, offset: float, *, error: Optional[float] = None, falloff: float = 0) -> HalfSpace:
    """The points p with normal . p <= offset, as a focus of Model.mesh()."""
    return HalfSpace(error, falloff, vector(normal, "normal"), offset)


Focus = Union[None, Region, Iterable[Region]]
Ranges = Union[None, Tuple[float, float], Iterable[Tuple[float, float]]]


def regions_of(focus: Focus) -> List[Region]:
    """One region or several."""
    kinds = "focus is tan.sphere(...), tan.box(...) or tan.half_space(...), or a list of these"
    regions: List[Region] = [] if focus is None else [focus] if isinstance(focus, Region) else listed(focus, kinds)
    if not all(isinstance(region, Region) for region in regions):
        raise TypeError(kinds)
    return regions


def error_field(error: float, focus: Focus) -> str:
    """The error field as a text of TAn's: `error` everywhere, less in the focus."""
    fields = [region.field(error) for region in regions_of(focus)]
    if not fields:
        return repr(error)
    return fields[0] if len(fields) == 1 else f"min({', '.join(fields)})"


def ranges(values: Ranges) -> list[Tuple[float, float]]:
    """One closed range of values or several."""
    if values is None:
        return []
    given = listed(values, "values is a range (least, largest), or a list of these")
    if len(given) == 2 and not hasattr(given[0], "__len__"):
        given = [tuple(given)]
    found = []
    for least, largest in (vector(pair, "values", 2) for pair in given):
        if largest < least:
            raise WrongUsage(f"values go from {least:g} to {largest:g}, which is no range.")
        found.append((least, largest))
    return found


