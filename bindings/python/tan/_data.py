# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays as data that a model is built from."""
from __future__ import annotations

import math
from typing import Any, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _tan
from ._errors import BadInput, WrongUsage
from ._numbers import Vector, choice, number, real_array, samples, text, truth, vector
from ._progress import Progress, reporting


class Data:
    """Arrays that a model can be built from: a Lattice, a Grid, Points or Cells.

    What the arrays do not say is said by keywords that all of them have: `name` of the data, `value_name` and `value_unit` of the
    values, `length_unit` of positions, and `space`, which way x, y and z grow, by three letters such as "LPS". A model keeps them.
    """

    def __init__(self, *, name: str = "array", value_name: str = "", value_unit: str = "", length_unit: str = "", space: str = "") -> None:
        self._names = _tan.Names()
        self._names.name = text(name, "name")
        self._names.value = text(value_name, "value_name")
        self._names.value_unit = text(value_unit, "value_unit")
        self._names.length_unit = text(length_unit, "length_unit")
        self._names.space = text(space, "space")
        self._held: Optional[_tan.Dataset] = None

    def _make(self, report: Any) -> _tan.Dataset:
        raise TypeError("tan.Data is what data have in common. Make tan.Lattice, tan.Grid, tan.Points or tan.Cells.")

    def dataset(self, progress: Progress = None) -> _tan.Dataset:
        """The data checked and repaired, made once. Errors: BadInput says what is wrong with them."""
        if self._held is None:
            with reporting(progress) as report:
                made = self._make(report)
            least, largest = made.facts()["range"]
            if not math.isfinite(float(largest) - float(least)):
                raise BadInput(f"The values of '{self._names.name}' go from {least:g} to {largest:g}, too far for computing with. Scale them.")
            self._held = made
        return self._held

    @property
    def kind(self) -> str:
        """What the data are once they are checked: "regular", "curvilinear", "irregular" or "scattered". A lattice or a grid with holes
        is "irregular"."""
        return str(self.dataset().facts()["kind"])

    @property
    def range(self) -> Tuple[float, float]:
        """The smallest and the largest value."""
        least, largest = self.dataset().facts()["range"]
        return float(least), float(largest)

    @property
    def remarks(self) -> List[str]:
        """What was changed to make the data usable, in sentences: points merged, cells left out."""
        return list(self.dataset().facts()["remarks"])

    def __repr__(self) -> str:
        return f"<tan.{type(self).__name__} '{self._names.name}'>"


def _along_zyx(array: npt.NDArray[Any], axes: str, name: str) -> npt.NDArray[Any]:
    choice(axes, "axes", ("zyx", "xyz"))
    if array.ndim != 3:
        raise WrongUsage(f"{name} is an array with three axes, not {array.ndim}.")
    return array if axes == "zyx" else array.T


def _masked(values: Any, mask: Any) -> Tuple[Any, Optional[npt.NDArray[np.bool_]]]:
    """The values, and where there are none: True is a hole, as in numpy.ma."""
    hidden: Optional[npt.NDArray[np.bool_]] = None
    if isinstance(values, np.ma.MaskedArray):
        hidden = np.array(np.broadcast_to(np.asarray(values.mask, dtype=bool), values.shape))
        values = values.data
    if mask is not None:
        array = np.asarray(mask)
        if array.dtype.kind not in "bui":
            raise TypeError(f"mask is an array of truth values, not of {array.dtype}")
        if array.shape != np.shape(values):
            raise WrongUsage(f"mask has the shape {array.shape}, and the values {np.shape(values)}.")
        hidden = array.astype(bool) if hidden is None else hidden | array.astype(bool)
    return values, hidden if hidden is not None and bool(hidden.any()) else None


def _cells_without(hidden: Optional[npt.NDArray[np.bool_]]) -> Optional[npt.NDArray[np.uint8]]:
    """The cells that have a hidden point as a corner."""
    if hidden is None:
        return None
    if min(hidden.shape) < 2:
        raise WrongUsage(f"A grid has at least two points along each axis, not {hidden.shape}.")
    cells: npt.NDArray[np.bool_] = np.zeros(tuple(length - 1 for length in hidden.shape), dtype=bool)
    for corner in np.ndindex(2, 2, 2):
        cells |= hidden[tuple(slice(at, at - 1 or None) for at in corner)]
    return cells.astype(np.uint8)


class Lattice(Data):
    """A regular grid of values: an array with three axes.

    **Order of axes.** `values[k, j, i]` is the value at the k-th place along z, the j-th along y and the i-th along x, as in arrays from
    ITK, SimpleITK, scikit-image and VTK (reshaped), however the array lies in memory. With `axes="xyz"` it is `values[i, j, k]`, as in
    nibabel. A C-contiguous array ("zyx"), or an F-contiguous one ("xyz"), is not copied: do not change it while a model is built.

    values: integers or real numbers, shape (nz, ny, nx), each at least 2. Values that are not finite, masked points of a numpy.ma array
        and points where `mask` is True are holes: the cells around them are left out, and the data become an irregular mesh.
    spacing, origin: (x, y, z), in units of length, whatever the axes of the array.
    directions: a (3, 3) array whose columns are the unit vectors along which i, j and k run, as ITK has it; None: x, y and z.

    >>> import numpy as np
    >>> Lattice(np.zeros((2, 3, 4)), spacing=(1, 1, 2.5), name="CT").kind
    'regular'
    """

    def __init__(self, values: npt.ArrayLike, *, spacing: Vector = (1, 1, 1), origin: Vector = (0, 0, 0),
                 directions: Optional[npt.ArrayLike] = None, mask: Optional[npt.ArrayLike] = None, axes: str = "zyx", **names: str) -> None:
        super().__init__(**names)
        plain, hidden = _masked(values, mask)
        self._values = np.ascontiguousarray(_along_zyx(samples(plain, "values"), axes, "values"))
        self._holes = _cells_without(None if hidden is None else _along_zyx(hidden, axes, "mask"))
        self._frame = _tan.Frame()
        self._frame.spacing = [number(part, "spacing") for part in vector(spacing, "spacing")]
        self._frame.origin = list(vector(origin, "origin"))
        if directions is not None:
            self._frame.directions = real_array(directions, "directions", (3, 3)).tolist()

    def _make(self, report: Any) -> _tan.Dataset:
        return _tan.lattice_data(self._values, self._frame, self._holes, self._names, report)


class Grid(Data):
    """A curvilinear (or rectilinear) grid: `values` and the coordinates `x`, `y` and `z` of its points are arrays of one shape with three
    axes; for a rectilinear grid the coordinates may have one axis each. The order of axes is that of a Lattice.

    Holes are those of a Lattice. Lengths are in any unit.

    >>> import numpy as np
    >>> values = np.zeros((2, 3, 4))
    >>> Grid(np.array([0, 1, 3, 4.]), np.array([0, 2, 3.]), np.array([0, 1.]), values).kind
    'curvilinear'
    """

    def __init__(self, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike, values: npt.ArrayLike, *,
                 mask: Optional[npt.ArrayLike] = None, axes: str = "zyx", **names: str) -> None:
        super().__init__(**names)
        plain, hidden = _masked(values, mask)
        self._values = np.ascontiguousarray(_along_zyx(samples(plain, "values"), axes, "values"))
        self._holes = _cells_without(None if hidden is None else _along_zyx(hidden, axes, "mask"))
        self._places = np.empty((*self._values.shape, 3))
        for axis, (name, given) in enumerate((("x", x), ("y", y), ("z", z))):
            coordinates = np.asarray(given)
            if coordinates.dtype.kind not in "buif":
                raise TypeError(f"{name} is an array of numbers, not of {coordinates.dtype}")
            if coordinates.ndim == 1:
                placed = coordinates.reshape([-1 if 2 - axis == index else 1 for index in range(3)])
            else:
                placed = _along_zyx(coordinates, axes, name)
            if placed.shape[2 - axis] != self._values.shape[2 - axis] or (coordinates.ndim == 3 and placed.shape != self._values.shape):
                raise WrongUsage(f"{name} has the shape {coordinates.shape}, which does not fit values of {np.shape(values)}.")
            self._places[..., axis] = placed

    def _make(self, report: Any) -> _tan.Dataset:
        return _tan.grid_data(self._places, self._values, self._holes, self._names, report)


class Points(Data):
    """Scattered points: `positions` of shape (n, 3), in units of length, and `values` of shape (n,). Their domain is their convex hull.
    Points whose value is not finite or masked are left out, and points at one place merged.

    >>> Points([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [1, 2, 3, 4]).kind
    'scattered'
    """

    def __init__(self, positions: npt.ArrayLike, values: npt.ArrayLike, *, mask: Optional[npt.ArrayLike] = None, **names: str) -> None:
        super().__init__(**names)
        plain, hidden = _masked(values, mask)
        self._positions = real_array(positions, "positions", (None, 3))
        self._values = real_array(plain, "values", (len(self._positions),))
        if hidden is not None:
            self._positions, self._values = self._positions[~hidden], self._values[~hidden]

    def _make(self, report: Any) -> _tan.Dataset:
        return _tan.point_data(self._positions, self._values, self._names, report)


Blocks = Union[npt.ArrayLike, Mapping[str, npt.ArrayLike], Sequence[Tuple[str, npt.ArrayLike]]]


class Cells(Data):
    """An irregular mesh: `positions` of shape (n, 3), in units of length; cells; and values of the points, or with `per_cell` of the cells,
    which are averaged onto the points.

    cells: numbers of points. An array of shape (m, 4) is tetrahedra; else pairs of a shape and an array, as meshio has them, or a
        dictionary: "tetra", "pyramid", "wedge", "hexahedron", "voxel", "tetra10", "pyramid13", "wedge15", "hexahedron20", corners
        numbered as in VTK.

    >>> Cells([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]], [1, 2, 3, 4]).kind
    'irregular'
    """

    def __init__(self, positions: npt.ArrayLike, cells: Blocks, values: npt.ArrayLike, *, per_cell: bool = False, **names: str) -> None:
        super().__init__(**names)
        self._positions = real_array(positions, "positions", (None, 3))
        self._blocks = [(shape, self._corners(shape, corners)) for shape, corners in self._pairs(cells)]
        self._single = np.asarray(values).dtype.itemsize <= 4 and np.asarray(values).dtype != np.dtype("int32")
        self._values = real_array(values, "values", (None,))
        self._per_cell = truth(per_cell, "per_cell")

    @staticmethod
    def _pairs(cells: Any) -> Iterable[Tuple[str, Any]]:
        if isinstance(cells, Mapping):
            return list(cells.items())
        if isinstance(cells, Sequence) and cells and isinstance(cells[0], Sequence) and cells[0] and isinstance(cells[0][0], str):
            return [(str(shape), corners) for shape, corners in cells]
        if isinstance(cells, Sequence) and cells and hasattr(cells[0], "type") and hasattr(cells[0], "data"):
            return [(str(block.type), block.data) for block in cells]
        return [("tetra", cells)]

    def _corners(self, shape: str, corners: Any) -> npt.NDArray[np.uint64]:
        text(shape, "the shape of cells")
        array = np.asarray(corners)
        if array.dtype.kind not in "ui":
            raise TypeError(f"cells are arrays of whole numbers, not of {array.dtype}")
        if array.ndim != 2:
            raise WrongUsage(f"Cells of the shape '{shape}' are an array with two axes, not {array.ndim}.")
        if array.size and (int(array.min()) < 0 or int(array.max()) >= len(self._positions)):
            raise WrongUsage(f"Cells of the shape '{shape}' have points from {array.min()} to {array.max()}, "
                             f"but there are {len(self._positions)}, numbered from 0.")
        return np.ascontiguousarray(array, dtype=np.uint64)

    def _make(self, report: Any) -> _tan.Dataset:
        return _tan.cell_data(self._positions, self._blocks, self._values, self._per_cell, self._single, self._names, report)
