# SPDX-License-Identifier: GPL-3.0-or-later
"""Models: what they say of themselves, meshes out of them, pictures of them."""
from __future__ import annotations

import contextlib
import os
import warnings
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _program, _tan
from ._data import Data
from ._errors import WrongUsage
from ._mesh import Mesh, Surface
from ._numbers import Vector, choice, listed, model_path, number, path_text, shown, text, truth, whole
from ._progress import Progress, reporting
from ._regions import Box, Focus, Ranges, Region, error_field, ranges, regions_of
from ._verdict import Verdict
from ._view import View, view_of


class Size(NamedTuple):
    """How large a mesh is, known without extracting it; error and warping in %, as the mesh has them."""

    sites: int
    tetrahedra: int
    error: float
    warping: float


class Model:
    """A multiresolution model: for every error a conforming mesh of tetrahedra that keeps it. tan.open() and tan.build() give one.

    Errors are in % of the range of values, warpings in % of the diagonal of the bounds, lengths and values in the units of the data.
    Safe to use from several threads: meshes of one model are extracted one after the other, of several (or of explore()) at once.
    """

    def __init__(self, held: _tan.Model, token: str = "") -> None:
        if not isinstance(held, _tan.Model):
            raise TypeError("models are made by tan.open() and tan.build()")
        self._held = held
        self._token = token
        self._about = held.description()
        self._levels: Optional[npt.NDArray[np.void]] = None
        self._remarks: Tuple[str, ...] = ()

    def __reduce__(self) -> Tuple[Any, ...]:
        """Pickled as the place where it lies, which is opened there again: for processes that share its disk, or reach its server."""
        from ._build import open as opened
        if self._token:
            raise TypeError("A model that was opened with a token is not pickled, as that would give the token away. Open it there by its address.")
        return opened, (self.path if "://" in self.path else os.path.abspath(self.path),)

    @property
    def path(self) -> str:
        """Where it lies: a path or an address."""
        return str(self._about["path"])

    @property
    def remarks(self) -> Tuple[str, ...]:
        """What there was to say of the data when tan.build() made it, in sentences: what was guessed, what a file has that was not used,
        points that were left out. None of a model that was opened."""
        return self._remarks

    @property
    def kind(self) -> str:
        """What its data are: "regular", "curvilinear", "irregular" or "scattered"."""
        return str(self._about["kind"])

    @property
    def bounds(self) -> npt.NDArray[np.float64]:
        """Of all points of the data: the smallest and the largest x, y and z, shape (2, 3), in units of length."""
        return np.array(self._about["bounds"], dtype=np.float64)

    @property
    def range(self) -> Tuple[float, float]:
        """The smallest and the largest value of the data, in units of the values: what errors are percentages of."""
        least, largest = self._about["range"]
        return float(least), float(largest)

    @property
    def dtype(self) -> np.dtype[Any]:
        """The type of the data's values."""
        return np.dtype({"float": "float32", "double": "float64"}.get(str(self._about["type"]), str(self._about["type"])))

    @property
    def value_name(self) -> str:
        """What the data call the values; empty if they do not say."""
        return str(self._about["value_name"])

    @property
    def value_unit(self) -> str:
        """The unit of the values; empty if it is not known."""
        return str(self.provenance["taken"].get("unit", ""))

    @property
    def length_unit(self) -> str:
        """The unit of positions, such as "mm"; empty if it is not known."""
        return str(self._about["length_unit"])

    @property
    def space(self) -> str:
        """Which way x, y and z grow, by three letters such as "LPS"; empty if it is not known."""
        return str(self._about["space"])

    @property
    def shape(self) -> Optional[Tuple[int, ...]]:
        """Of a lattice or a grid: its numbers of points along z, y and x, as the shape of its array; else None."""
        lattice = self._about.get("lattice")
        return None if lattice is None else tuple(reversed(lattice["size"]))

    @property
    def spacing(self) -> Optional[npt.NDArray[np.float64]]:
        """Of a lattice: the steps (x, y, z), in units of length; else None."""
        return np.array(self._about["lattice"]["spacing"]) if self.kind == "regular" else None

    @property
    def origin(self) -> Optional[npt.NDArray[np.float64]]:
        """Of a lattice: where its first point lies, (x, y, z), in units of length; else None."""
        return np.array(self._about["lattice"]["origin"]) if self.kind == "regular" else None

    @property
    def directions(self) -> Optional[npt.NDArray[np.float64]]:
        """Of a lattice: the unit vectors along which i, j and k run, as the columns of a (3, 3) array; else None."""
        return np.array(self._about["lattice"]["directions"]) if self.kind == "regular" else None

    @property
    def sites(self) -> int:
        """How many points of the data are vertices of its finest mesh."""
        return int(self._about["sites"])

    @property
    def tetrahedra(self) -> int:
        """How many tetrahedra it holds, of all its meshes."""
        return int(self._about["tetrahedra"])

    @property
    def file_size(self) -> int:
        """Bytes of its file, unpacked."""
        return int(self._about["file_size"])

    @property
    def is_whole(self) -> bool:
        """Whether all of it was opened, and not only its beginning (`error` of tan.open())."""
        return bool(self._about["is_whole"])

    @property
    def provenance(self) -> Dict[str, Any]:
        """How it came about: `source` and `hash` of the data, `builder` and its `parameters`, what was `taken` of a file that offers several
        things, which of that are `guesses`, and what the file says and was not used, `unused`."""
        return dict(self._about["provenance"])

    @property
    def levels(self) -> npt.NDArray[np.void]:
        """All meshes of falling error that it has, coarse first: a read-only structured array with `error` (%, float64), `warping` (%,
        float64), `sites` (uint32) and `tetrahedra` (uint64). Plot m.levels["error"] against m.levels["tetrahedra"]."""
        if self._levels is None:
            self._levels = self._held.levels(None)
        return self._levels

    def size_at(self, *, error: float = 0, warping: Optional[float] = None, budget: Optional[int] = None) -> Size:
        """How large the mesh of this error is; with a budget, of the most accurate one that is not above it."""
        asked = number(error, "error", least=0)
        bent = asked if warping is None else number(warping, "warping", least=0)
        allowed = None if budget is None else whole(budget, "budget", 1)
        return Size(*self._held.size_at(asked, bent if self._about["warps"] else 100.0, allowed))

    def mesh(self, *, error: Optional[float] = None, budget: Optional[int] = None, warping: Optional[float] = None,
             absolute: Optional[float] = None, focus: Focus = None, field: Optional[str] = None, window: Optional[Box] = None,
             values: Ranges = None, method: str = "automatic", progress: Progress = None) -> Mesh:
        """A mesh of a known error.

        error: at most this at each sample, in % of the range of values; or absolute: the same in units of the values. Without either:
            with a budget the smallest that it allows, else one whose mesh is quick to work with, 1 % as a rule.
        budget: at most so many tetrahedra; errors are multiplied by the smallest factor that allows it (Mesh.scale).
        warping: of curvilinear and irregular data, how far the mesh may lie from the data, in % of the diagonal; without it, the number
            of the error holds for both. 100 is no limit.
        focus: where the error is smaller: tan.sphere(centre, radius, error=0.2, falloff=5), tan.box(...), or a list of these.
        field: the error as a field, in TAn's own words, in place of error and focus: "isovalues(120; 0.2, 4, 30)".
        window: only what lies in this tan.box(...).
        values: only tetrahedra that can contain values from a to b, (a, b), or of several ranges.
        method: of meshes with a focus: "automatic", "closed-set" or "insertion".
        progress: see tan.open().

        Errors: WrongUsage (a ValueError) for what makes no sense, BadInput (an OSError) for a damaged file.
        """
        self._warn_of_nothing(regions_of(focus), window)
        query = self._query(error, budget, warping, absolute, focus, field)
        query.values = ranges(values)
        query.method = text(method, "method")
        if window is not None:
            if not isinstance(window, Box):
                raise TypeError(f"window is tan.box(...), not {shown(window)}")
            query.window, query.border = [list(window.least), list(window.largest)], window.border
        with reporting(progress) as report:
            return Mesh(self._held.extract(query, report), self.value_name, self.length_unit)

    def _warn_of_nothing(self, focus: Sequence[Region], window: Optional[Box]) -> None:
        """Of regions that have nothing of the data, which is no error and seldom meant."""
        least, largest = self.bounds.tolist()
        beside = [("window", window)] if isinstance(window, Box) else []
        for name, region in [*(("focus", region) for region in focus), *beside]:
            if region.is_beside(least, largest):
                warnings.warn(f"The {name} has nothing of the data, which lie between {tuple(least)} and {tuple(largest)}.", stacklevel=3)

    def _query(self, error: Optional[float], budget: Optional[int], warping: Optional[float], absolute: Optional[float], focus: Focus,
               field: Optional[str]) -> _tan.Query:
        if sum(given is not None for given in (error, absolute, field)) > 1:
            raise WrongUsage("Give one of error, absolute and field.")
        if field is not None and focus is not None:
            raise WrongUsage("A field says all of the error. Leave focus out, or write it into the field.")
        query = _tan.Query()
        query.warping, query.border = "100", "intersecting"
        query.budget = None if budget is None else whole(budget, "budget", 1)
        query.error = text(field, "field") if field is not None else error_field(self._percent(error, budget, absolute), focus)
        if warping is not None and not self._about["warps"]:
            raise WrongUsage(f"The data of '{self.path}' are {self.kind} and cannot warp. Leave warping out.")
        if self._about["warps"]:
            query.warping = query.error if warping is None else repr(number(warping, "warping", least=0))
        return query

    def _percent(self, error: Optional[float], budget: Optional[int], absolute: Optional[float]) -> float:
        if absolute is not None:
            least, largest = self.range
            difference = number(absolute, "absolute", least=0)
            return 0.0 if largest == least else min(100.0, 100 * difference / (largest - least))
        if error is not None:
            return number(error, "error", least=0)
        return 0.0 if budget is not None else self._held.starting_error()

    def isosurface(self, value: float, *, progress: Progress = None, **query: Any) -> Surface:
        """The surface on which the field has this value, of the mesh that mesh() gives for the other arguments."""
        return self.mesh(progress=progress, **query).isosurface(value, progress=progress)

    def slice(self, normal: Vector, at: Any, *, progress: Progress = None, **query: Any) -> Surface:
        """The cut of a plane through the mesh that mesh() gives for the other arguments."""
        return self.mesh(progress=progress, **query).slice(normal, at, progress=progress)

    def sample(self, places: npt.ArrayLike, *, progress: Progress = None, **query: Any) -> npt.NDArray[np.float64]:
        """Values at places, of the mesh that mesh() gives for the other arguments. For many calls keep the mesh."""
        return self.mesh(progress=progress, **query).sample(places, progress=progress)

    @contextlib.contextmanager
    def explore(self, **usual: Any) -> Iterator[Explorer]:
        """For many meshes of one kind: something with mesh(), whose arguments are `usual` unless others are given. It works beside this
        model, from another thread as well, and its caches go when the block ends.

            with m.explore(budget=1_000_000) as x:
                for error in (10, 1, 0.1):
                    print(error, len(x.mesh(error=error).tetrahedra))
        """
        explorer = Explorer(Model(self._held.again(), self._token), usual)
        try:
            yield explorer
        finally:
            explorer.close()

    def verify(self, against: Union[Data, str, Any], *, levels: Optional[Sequence[float]] = None, progress: Progress = None,
               **lattice: Any) -> Verdict:
        """Proves the model against the data that it was built from, by code that shares nothing with the builders: at each level every
        sample keeps the error, and the mesh covers the domain without gaps or overlaps.

        against: a path, the data (tan.Lattice ...), or the array, with the keywords that it was built with. levels: errors in %;
        0 is the whole model. Without them 10, 1 and 0, or of a file the usual ones.
        """
        errors = None if levels is None else [number(level, "levels", least=0) for level in listed(levels, "levels is a list of errors")]
        if errors == []:
            raise WrongUsage("levels is empty, which proves nothing. Leave it out, or name errors.")
        with reporting(progress) as report:
            if isinstance(against, str) or hasattr(against, "__fspath__"):
                if lattice:
                    raise WrongUsage(f"{', '.join(lattice)}: of arrays. What a file says of itself is taken from it.")
                words = ["verify", self.path, "--against", path_text(against, "against", in_utf8=False)]
                if errors is not None:
                    words += ["--lod", ",".join(f"{error:.17g}" for error in errors)]
                return Verdict(_program.run(words, report, accepted=(0, 1)))
            from ._build import data_of
            data = data_of(against, lattice).dataset()
            asked = [[error, error if self._about["warps"] else 100.0] for error in (errors if errors is not None else [10.0, 1.0, 0.0])]
            return Verdict(_tan.verify(self._held, data, asked, report))

    def pack(self, path: Any, *, progress: Progress = None) -> Dict[str, Any]:
        """Writes the model packed, for archives and networks: a hundredth to a third of its size, and exact. Gives `bytes` and `method`."""
        with reporting(progress) as report:
            return self._held.pack(model_path(self._target(path), "pack()"), report)

    def save(self, path: Any, *, error: Optional[float] = None, progress: Progress = None) -> None:
        """Writes it as a model file of this disk, wherever it lies: all of it, or only as much as this error needs."""
        target = model_path(self._target(path), "save()")
        with reporting(progress) as report:
            _tan.copy(self.path, None if error is None else number(error, "error", least=0), target, self._token, report)

    def _target(self, path: Any) -> str:
        """Where something of the model is written: anywhere but over the model."""
        found = path_text(path, "path")
        if os.path.exists(found) and os.path.exists(self.path) and os.path.samefile(found, self.path):
            raise WrongUsage(f"'{found}' is the model itself, which would be overwritten. Give another name.")
        return found

    def modes(self) -> List[Tuple[str, str]]:
        """The ways to draw it, the usual one first: ids for View(mode=...), and names."""
        return [(str(mode), str(name)) for mode, name in _tan.modes(self._held)]

    def settings(self, mode: Optional[str] = None) -> Dict[str, Union[bool, int, float, str]]:
        """What can be set of a mode, or of the usual one, in View(settings=...): the ids, with what is usual for this model."""
        view = self._checked(View(mode=mode))
        return {name: usual for name, _, usual, _, _, _ in _tan.settings(self._held, view.text) if usual is not None}

    def view(self, *, size: Tuple[int, int] = (1024, 768), **look: Any) -> View:
        """How the model is seen at first, in a picture of this size, with everything said, and with these changes."""
        asked = self._checked(view_of(None, look))
        return View.from_text(_tan.fitted_view(self._held, asked.text, drawing(asked, size)))

    def kept_view(self, path: Any) -> Tuple[View, List[str]]:
        """The view of a session or of a picture that TAn has written, and in sentences what is not as it was."""
        kept, differences, _, _ = _tan.kept_view(self._held, path_text(path, "path"))
        return View.from_text(kept), list(differences)

    def render(self, view: Optional[View] = None, *, size: Tuple[int, int] = (1024, 768), transparent: bool = False, samples: int = 4,
               threads: int = 0, backend: str = "cpu", frame: Optional[int] = None, progress: Progress = None,
               **look: Any) -> npt.NDArray[np.uint8]:
        """A picture: an array of shape (height, width, 4), red, green, blue and opacity from 0 to 255, rows from above. No display is needed.

        view: how the model is looked at; the remaining keywords change it, as tan.View has them: m.render(mode="volume", azimuth=60).
        size: (width, height) in pixels. transparent: without the background. samples: a pixel is the mean of so many squared samples,
        1 to 4. threads: the most to use; 0: all. backend: "cpu", or "gl" for the graphics card. frame: of the view's film.
        """
        looked = self._checked(view_of(view, look))
        options = drawing(looked, size)
        options.transparent, options.samples, options.threads = truth(transparent, "transparent"), whole(samples, "samples", 1, 4), whole(threads, "threads", 0, 4096)
        options.frame = None if frame is None else whole(frame, "frame", 0, 2**31 - 1)
        options.open_gl = choice(backend, "backend", ("cpu", "gl")) == "gl"
        with reporting(progress) as report:
            return _tan.draw(self._held, looked.text, options, report)

    def save_picture(self, path: Any, view: Optional[View] = None, *, size: Tuple[int, int] = (1024, 768), **how: Any) -> None:
        """Writes a picture as PNG. It says of itself how it was made: TAn's window, and kept_view(), open its view again."""
        target = self._target(path)
        if not target.lower().endswith(".png"):
            raise WrongUsage(f"'{target}' does not end in .png, the one format in which pictures are written.")
        looked = view_of(view, {name: value for name, value in how.items() if name not in _DRAWING})
        drawn = {name: value for name, value in how.items() if name in _DRAWING}
        pixels = self.render(looked, size=size, **drawn)
        options = drawing(looked, size)
        options.transparent = truth(how.get("transparent", False), "transparent")
        _tan.write_png(self._held, pixels, looked.text, options, target)

    def save_session(self, path: Any, view: Optional[View] = None, *, size: Tuple[int, int] = (1024, 768), **look: Any) -> None:
        """Writes a session (.tansession), which TAn's window and `tan render` open."""
        looked = self._checked(view_of(view, look))
        _tan.write_session(self._held, looked.text, drawing(looked, size), self._target(path))

    def _checked(self, view: View) -> View:
        """The view, as the model has it: pictures would leave out what it has not, and move a focus into the bounds."""
        mode = choice(view.mode if view.mode is not None else self.modes()[0][0], "mode", [mode for mode, _ in self.modes()])
        least, largest = self.bounds.tolist()
        for middle in view._middles:
            if any(not low <= place <= high for low, place, high in zip(least, middle, largest)):
                raise WrongUsage(f"The middle of a picture's focus lies in the bounds of the data, from {tuple(least)} to {tuple(largest)}, "
                                 f"not at {tuple(middle)}. Take a box that ends at the bounds, or a smaller sphere within them.")
        known = _tan.settings(self._held, view.text)
        if any(setting[1] == "isovalues" for setting in known):
            for value in view._isovalues_outside(self.range):
                warnings.warn(f"The surface of {value:g} is empty: the data lie between {self.range[0]:g} and {self.range[1]:g}.", stacklevel=3)
        return view._settled(mode, known)

    def _repr_html_(self) -> str:
        from ._notebook import page
        return page(self)

    def __repr__(self) -> str:
        least, largest = self.range
        name = self.provenance["source"] or self.path
        return f"<tan.Model {name}: {self.sites:,} sites, values {least:g} to {largest:g}>"


_DRAWING = ("transparent", "samples", "threads", "backend", "frame", "progress")


def drawing(view: View, size: Tuple[int, int]) -> _tan.DrawOptions:
    """How a picture of a view is made."""
    lengths = listed(size, "size is (width, height)")
    if len(lengths) != 2:
        raise TypeError(f"size is (width, height), not {shown(size)}")
    options = _tan.DrawOptions()
    options.width, options.height = (whole(length, "size", 1, 32767) for length in lengths)
    options.samples = 4
    options.fitted, options.zoom, options.target = view._fitted, view._zoom, view._target
    options.colours = view._colours or ""
    return options


class Explorer:
    """What Model.explore() gives."""

    def __init__(self, model: Model, usual: Dict[str, Any]) -> None:
        if not isinstance(model, Model):
            raise TypeError("explorers are made by Model.explore()")
        self._model: Optional[Model] = model
        self._usual = usual

    def mesh(self, **query: Any) -> Mesh:
        """Model.mesh() with the usual arguments, unless others are given."""
        if self._model is None:
            raise WrongUsage("The block of explore() has ended. Open another one.")
        return self._model.mesh(**{**self._usual, **query})

    def close(self) -> None:
        """Ends it; the block does so."""
        self._model = None
