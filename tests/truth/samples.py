# SPDX-License-Identifier: GPL-3.0-or-later
"""What the files of this bench hold: a function of the place in the world, sampled at the points of a grid, in any number type."""
import dataclasses
import importlib

import numpy

SIZE = (5, 6, 7)  # points along i, j, k: all different, so that exchanged axes show


class Missing(Exception):
    """A library that a job needs is not installed; its text names the package."""


class _Absent:
    def __init__(self, name):
        self.name = name

    def __getattr__(self, attribute):
        if attribute.startswith("__"):
            raise AttributeError(attribute)
        raise Missing(f"python3-{self.name}")


def library(name, package=None):
    """The module, or if it is not installed something that says so when it is used: only the jobs that need it are skipped."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return _Absent((package or name.partition(".")[0]).lower())


# Where grids lie: point (i, j, k) at origin + steps (i, j, k); the steps are columns.

def _turned(degrees, axis):
    c, s = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    a, b = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = numpy.eye(3)
    matrix[a, a], matrix[a, b], matrix[b, a], matrix[b, b] = c, -s, s, c
    return matrix


SPACING = numpy.diag((4.0, 3.0, 2.0))
ORIGIN = (10.0, 20.0, -30.0)
FRAMES = {
    "identity": (numpy.eye(3), (0.0, 0.0, 0.0)),
    "offset": (SPACING, ORIGIN),
    "mirrored": (numpy.diag((-1.0, 1.0, 1.0)) @ SPACING, ORIGIN),
    "turned half": (numpy.diag((-1.0, -1.0, 1.0)) @ SPACING, ORIGIN),
    "permuted": (numpy.eye(3)[:, [2, 0, 1]] @ SPACING, (-5.25, 33.5, 8.0)),
    "exchanged": (numpy.array([[0.0, 0, -1], [4, 0, 0], [0, -2, 0]]), (86.5, -33.75, 46.5)),
    "oblique": (_turned(20, 2) @ SPACING, ORIGIN),
    "oblique twice": (_turned(35, 0) @ _turned(-50, 1) @ SPACING, ORIGIN),
    "oblique, mirrored": (_turned(20, 2) @ numpy.diag((4.0, 3.0, -2.0)), ORIGIN),
    "sheared": (numpy.array([[4.0, 0.9, -0.4], [0, 3, 0.7], [0, 0, 2]]), ORIGIN),
    "far away": (numpy.diag((0.125, 0.125, 0.25)), (339385.0, 4264212.0, 1680.0)),
    "tiny": (numpy.diag((4e-9, 3e-9, 2e-9)), (1e-8, -2e-8, 3e-8)),
}


def wave(places, variant=0):
    """Between -1 and 1, with no symmetry and no straight part; of each variant another one. The unit is the step of the grid, or so."""
    places = numpy.asarray(places, float)
    least = places.reshape(-1, 3).min(axis=0)
    span = places.reshape(-1, 3).max(axis=0) - least
    x, y, z = numpy.moveaxis((places - least) / numpy.where(span > 0, span, 1), -1, 0) * 6.0
    return (0.45 * numpy.sin(1.7 * x + 1.3 + variant) + 0.3 * numpy.cos(2.3 * y - 0.4 * x + 0.5 * variant)
            + 0.2 * numpy.sin(1.9 * z + 0.8 * y + 2 * variant) + 0.04 * (x - y + z) / 6)


HALF_WIDTH = {"i1": 100, "u1": 110, "i2": 25000, "u2": 30000, "i4": 8e6, "u4": 8e6, "i8": 8e6, "u8": 8e6}


def numbers(of_wave, dtype):
    """The wave as numbers of a type, which use most of what the type holds; whole ones are rounded, unsigned ones begin above 0."""
    kind = numpy.dtype(dtype)
    if kind.kind == "f":
        return (100 * of_wave + 20).astype(kind)
    width = HALF_WIDTH[kind.kind + str(kind.itemsize)]
    return numpy.rint(width * of_wave + (1.1 * width if kind.kind == "u" else 0)).astype(kind)


@dataclasses.dataclass
class Grid:
    """Samples [i, j, k] of the wave in a frame."""
    steps: numpy.ndarray
    origin: numpy.ndarray
    places: numpy.ndarray  # [i, j, k, 3]
    values: numpy.ndarray  # [i, j, k]

    @property
    def spacing(self):
        return numpy.linalg.norm(self.steps, axis=0)

    @property
    def directions(self):
        return self.steps / self.spacing

    @property
    def end(self):
        return self.places[-1, -1, -1]

    def fastest_first(self):
        """The samples in the order of most files: i runs fastest."""
        return self.values.transpose(2, 1, 0)


def placed(steps, origin, size=SIZE):
    return numpy.asarray(origin) + numpy.moveaxis(numpy.indices(size), 0, -1) @ numpy.asarray(steps).T


def grid(frame="offset", dtype="<f4", size=SIZE, variant=0):
    steps, origin = FRAMES[frame] if isinstance(frame, str) else frame
    places = placed(steps, origin, size)
    return Grid(numpy.asarray(steps, float), numpy.asarray(origin, float), places, numbers(wave(places, variant), dtype))


def some_holes(size=SIZE):
    """[i, j, k]: a few samples, none of them near a corner, so that every other one still is the corner of a whole cell."""
    holes = numpy.zeros(size, bool)
    for at in ((2, 2, 2), (2, 3, 4), (1, 3, 2)):
        holes[at] = True
    return holes


def axes(*lengths_and_starts):
    """Coordinates of a rectilinear grid, at uneven steps."""
    return [start + step * (numpy.arange(count) + 0.21 * numpy.sin(numpy.arange(count)) * numpy.arange(count) / count)
            for count, step, start in zip(SIZE, (4.0, 3.0, 2.0), lengths_and_starts or (10.0, 20.0, -30.0))]


def rectilinear(along, dtype="<f4", variant=0):
    """Samples at uneven steps along the axes; steps and origin are not told."""
    places = numpy.stack(numpy.meshgrid(*along, indexing="ij"), axis=-1)
    return Grid(numpy.full((3, 3), numpy.nan), numpy.full(3, numpy.nan), places, numbers(wave(places, variant), dtype))


def curvilinear(dtype="<f4", variant=0, size=SIZE, precision=float, shift=(0.0, 0.0, 0.0)):
    """Samples of a bent block."""
    i, j, k = numpy.indices(size).astype(float)
    radius, angle = 4 + 0.5 * i, 0.2 * j + 0.03 * k
    places = (numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle), 0.75 * k + 0.06 * i * j], axis=-1) + shift).astype(precision)
    return Grid(numpy.full((3, 3), numpy.nan), numpy.full(3, numpy.nan), places.astype(float), numbers(wave(places, variant), dtype))
