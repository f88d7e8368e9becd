# SPDX-License-Identifier: GPL-3.0-or-later
"""The jobs of the bench, and their judge: a job writes a file and says what is in it; TAn builds a model of the file and writes its finest mesh;
numpy compares that with what the job said. Nothing of TAn reads here."""
import dataclasses
import fractions
import functools
import json
import pathlib
import re
import subprocess
import tempfile
import traceback

import meshio
import numpy

from samples import Missing

# What a job is about: the columns of the report.
KINDS = ("places", "numbers", "storage", "holes", "arrays", "steps", "series", "cells")
OUTCOMES = ("passed", "refused as expected", "skipped", "refused", "wrong", "not told")


@dataclasses.dataclass
class Case:
    """A file and what is in it."""
    file: pathlib.Path
    places: numpy.ndarray               # of its samples, in the world: [n, 3]
    values: numpy.ndarray               # [n]
    options: tuple = ()                 # of tan build and tan info
    cells: numpy.ndarray = None         # [m, corners]: where the domain is; None: points alone
    holes: numpy.ndarray = None         # [n]: samples that have no value; cells at them are no domain
    volume: float = None                # of the domain
    volume_slack: float = 1e-5          # of that
    place_slack: float = 0.0            # of the largest coordinate, where the file's own arithmetic rounds
    value_slack: float = 0.0            # of the largest value, likewise
    taken: dict = dataclasses.field(default_factory=dict)  # part -> what TAn has to say that it took (a pattern)
    guessed: tuple = ()                 # the parts of these that it has to call a guess
    left_out: tuple = ()                # patterns of what it has to say that it did not use
    name: str = ""                      # what the values are called in the mesh


@dataclasses.dataclass
class Job:
    format: str
    kind: str
    name: str
    write: object                       # (folder) -> Case
    quick: bool                         # also in ./dev test
    refused: str                        # why a refusal is right, or empty


BENCH = []


def add(format, kind, name, write, /, quick=False, refused="", **words):
    """A job: `write(folder, **words)` writes its file and returns its Case."""
    assert kind in KINDS, kind
    BENCH.append(Job(format, kind, name, functools.partial(write, **words), quick, refused))


def of_grid(file, grid, options=(), holes=None, **words):
    """The case of a file that holds a grid."""
    size = grid.values.shape
    number = numpy.arange(grid.values.size).reshape(size)
    lower, upper = slice(None, -1), slice(1, None)
    corners = [number[at].ravel() for at in ((lower, lower, lower), (upper, lower, lower), (upper, upper, lower), (lower, upper, lower),
                                             (lower, lower, upper), (upper, lower, upper), (upper, upper, upper), (lower, upper, upper))]
    cells = numpy.stack(corners, axis=1)
    if numpy.isfinite(grid.steps).all():
        whole = len(cells) if holes is None else (~holes.ravel()[cells].any(axis=1)).sum()
        words.setdefault("volume", whole * abs(numpy.linalg.det(grid.steps)))
    return Case(pathlib.Path(file), grid.places.reshape(-1, 3), grid.values.astype(float).ravel(), tuple(options), cells,
                None if holes is None else holes.ravel(), **words)


def of_points(file, places, values, options=(), **words):
    """The case of a file that holds points, each once."""
    return Case(pathlib.Path(file), numpy.asarray(places, float), numpy.asarray(values, float), tuple(options), **words)


def of_cells(file, points, values, cells, options=(), **words):
    """The case of a file that holds a mesh; a value that is not finite makes a hole."""
    values = numpy.asarray(values, float)
    holes = ~numpy.isfinite(values)
    if not holes.any():
        # Cells whose sides are bent may be cut in several ways, and quadratic ones are bent.
        words.setdefault("volume", sum(volume_of_cells(numpy.asarray(points, float), block) for block in cells))
        words.setdefault("volume_slack", 0.015)
    return Case(pathlib.Path(file), numpy.asarray(points, float), values, tuple(options), cells, holes if holes.any() else None, **words)


# How many points a cell has -> tetrahedra of its corners.
CUT = {4: ((0, 1, 2, 3),), 5: ((0, 1, 2, 4), (0, 2, 3, 4)), 6: ((0, 1, 2, 3), (1, 2, 3, 4), (2, 3, 4, 5)),
       8: ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))}
CUT |= {10: CUT[4], 15: CUT[6], 20: CUT[8], 27: CUT[8]}


def volume_of_cells(points, cells):
    return sum(numpy.abs(volumes_of(points, cells[:, corners])).sum() for corners in CUT[cells.shape[1]])


class Wrong(Exception):
    """The mesh is not what the file says."""


class Refused(Exception):
    """TAn did not read the file."""


def run(tan, *words):
    done = subprocess.run([str(tan), *map(str, words)], capture_output=True, text=True, errors="replace", check=False, timeout=240)
    if done.returncode != 0:
        text = " ".join((done.stderr + done.stdout).split())
        raise (Refused if done.returncode in (2, 3) else Wrong)(f"{words[0]} ends with {done.returncode}: {text}")
    return done.stdout


def judged(job, tan):
    """(outcome, why) of a job."""
    with tempfile.TemporaryDirectory(prefix="tan-truth-") as place:
        folder = pathlib.Path(place)
        try:
            case = job.write(folder)
            run(tan, "build", case.file, *case.options, "--error", "0", "-o", folder / "judged.tan")
            run(tan, "extract", folder / "judged.tan", "--error", "0", "-o", folder / "judged.vtu")
            mesh = meshio.read(folder / "judged.vtu")
            compare(case, mesh)
            told = untold(case, json.loads(run(tan, "info", case.file, *case.options, "--json"))) if case.taken or case.left_out or case.guessed else ""
            if job.refused:
                return "wrong", f"it is read, though the bench says: {job.refused}"
            return ("not told", told) if told else ("passed", "")
        except Missing as missing:
            return "skipped", f"install {missing}"
        except ImportError as missing:  # of meshio's own
            return "skipped", f"install python3-{str(missing.name).lower()}"
        except Refused as refused:
            return ("refused as expected", job.refused) if job.refused else ("refused", str(refused))
        except Wrong as wrong:
            return "wrong", str(wrong)
        except Exception:  # a fault of the bench itself, which is to fail as one
            return "wrong", "the bench: " + " ".join(traceback.format_exc(limit=-3).split())


def compare(case, mesh):
    """The vertices are the samples, each at its place with its value; the tetrahedra fill the domain."""
    points = mesh.points.astype(float)
    values = next(iter(mesh.point_data.values())).astype(float).ravel()
    tetrahedra = numpy.concatenate([block.data for block in mesh.cells if block.type == "tetra"]).astype(int)

    number, places_off = matched(case, points)
    kept = samples_of_domain(case)
    if not kept[number].all():
        raise Wrong(f"{(~kept[number]).sum()} samples without a value are in the mesh")
    off = numpy.abs(values - case.values[number])
    finite = numpy.abs(case.values[kept])
    bound = 2.0 ** -23 * numpy.abs(case.values[number]) + case.value_slack * finite.max() + 1e-38
    if (off > bound).any():
        worst = (off - bound).argmax()
        raise Wrong(f"{(off > bound).sum()} of {len(values)} values: {values[worst]:.9g} at {points[worst]}, which is {case.values[number[worst]]:.9g}")

    volumes = volumes_of(points, tetrahedra)
    if faulty := flat_or_turned(points, tetrahedra, volumes):
        raise Wrong(f"{faulty} tetrahedra are flat or turned over")
    if case.volume is not None and abs(volumes.sum() / case.volume - 1) > case.volume_slack + 1e3 * case.place_slack:
        raise Wrong(f"the mesh fills {volumes.sum():.9g} of {case.volume:.9g}")

    # A sample that its neighbours give exactly need not be a vertex.
    missing = kept.copy()
    missing[number] = False
    if missing.sum() > 0.2 * kept.sum():
        raise Wrong(f"{missing.sum()} of {kept.sum()} samples are not in the mesh")
    for at in numpy.flatnonzero(missing):
        given = interpolated(points, values, tetrahedra, volumes, case.places[at])
        if given is None or abs(given - case.values[at]) > 1e-6 * finite.max() + case.value_slack * finite.max():
            raise Wrong(f"the sample at {case.places[at]} is not in the mesh, which has {given} there instead of {case.values[at]:.9g}")
    if case.name and case.name not in mesh.point_data:
        raise Wrong(f"the values are called {list(mesh.point_data)}, not '{case.name}'; all else is right")
    if places_off:
        raise Wrong(f"places are off by up to {places_off:.2g}, as if they had been in single precision; all else is right")


def matched(case, points):
    """The number of the sample at each vertex, and how far off the places are if it is more than they may be, but no more than single precision
    makes them."""
    largest, extent = numpy.abs(case.places).max(), numpy.ptp(case.places, axis=0).max()
    tolerance = (1e-13 + case.place_slack) * largest + 1e-9 * extent
    number, off = numpy.empty(len(points), int), 0.0
    for at, point in enumerate(points):
        distance = numpy.abs(case.places - point).max(axis=1)
        number[at] = distance.argmin()
        off = max(off, distance[number[at]])
        if not distance[number[at]] <= tolerance + 1e-7 * largest:
            low, high = (" ".join(f"{n:.6g}" for n in ends) for ends in (points.min(axis=0), points.max(axis=0)))
            right = " to ".join(" ".join(f"{n:.6g}" for n in ends) for ends in (case.places.min(axis=0), case.places.max(axis=0)))
            raise Wrong(f"no sample lies at {point}; the mesh goes from {low} to {high}, the samples from {right}")
    if len(set(number)) != len(number):
        raise Wrong(f"{len(number) - len(set(number))} samples are more than one vertex")
    return number, off if off > tolerance else 0


def samples_of_domain(case):
    """Those that belong to a cell of which no corner is a hole."""
    if case.cells is None:
        return numpy.ones(len(case.places), bool) if case.holes is None else ~case.holes
    cells = [case.cells] if isinstance(case.cells, numpy.ndarray) else case.cells
    kept = numpy.zeros(len(case.places), bool)
    for block in cells:
        whole = numpy.ones(len(block), bool) if case.holes is None else ~case.holes[block].any(axis=1)
        kept[block[whole]] = True
    return kept


def volumes_of(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, corner]] - points[0] for corner in range(4))
    return numpy.einsum("ij,ij->i", b - a, numpy.cross(c - a, d - a)) / 6


def flat_or_turned(points, tetrahedra, volumes):
    """How many. Points that lie in a plane but for their rounding span tetrahedra far flatter than the rounding of `volumes`, whose sign says nothing
    of them: they are judged in fractions, which have none."""
    unsure = numpy.abs(volumes) < 1e-13 * numpy.ptp(points, axis=0).max() ** 3
    return (volumes[~unsure] < 0).sum() + sum(exact_volume(points[corners]) <= 0 for corners in tetrahedra[unsure])


def exact_volume(corners):
    a, *others = [[fractions.Fraction(float(number)) for number in corner] for corner in corners]
    b, c, d = [[number - of for number, of in zip(corner, a)] for corner in others]
    return (b[0] * (c[1] * d[2] - c[2] * d[1]) + b[1] * (c[2] * d[0] - c[0] * d[2]) + b[2] * (c[0] * d[1] - c[1] * d[0])) / 6


def interpolated(points, values, tetrahedra, volumes, place):
    """By the tetrahedron that holds the place, or None; by none that is flat within rounding."""
    tetrahedra, volumes = tetrahedra[volumes > 0], volumes[volumes > 0]
    shares = []
    for corner in range(4):
        moved = points[tetrahedra].copy()
        moved[:, corner] = place
        b, c, d = moved[:, 1] - moved[:, 0], moved[:, 2] - moved[:, 0], moved[:, 3] - moved[:, 0]
        shares.append(numpy.einsum("ij,ij->i", b, numpy.cross(c, d)) / 6 / volumes)
    shares = numpy.stack(shares, axis=1)
    best = shares.min(axis=1).argmax()
    return shares[best] @ values[tetrahedra[best]] if shares[best].min() > -1e-9 else None


def untold(case, info):
    """What `tan info --json` had to say and did not."""
    said = info.get("taken", {})
    for part, pattern in case.taken.items():
        if part not in said:
            return f"nothing is told of the {part} that was taken ({pattern})"
        if not re.search(pattern, said[part]):
            return f"the {part} is told as '{said[part]}', not '{pattern}'"
    for part in case.guessed:
        if part not in info.get("guesses", []):
            return f"the {part} is not called a guess: {info.get('guesses', [])}"
    for pattern in case.left_out:
        if not any(re.search(pattern, sentence) for sentence in info.get("unused", [])):
            return f"no sentence of what was not used says '{pattern}': {info.get('unused', [])}"
    return ""
