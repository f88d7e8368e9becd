# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and surfaces: arrays of NumPy over memory of the library."""
from __future__ import annotations

import warnings
from typing import Any, Optional, cast

import numpy as np
import numpy.typing as npt

from . import _tan
from ._errors import WrongUsage
from ._numbers import Vector, number, real_array, vector
from ._progress import Progress, reporting


class Surface:
    """Triangles with a normal at each vertex, as an isosurface, a slice or a boundary of a mesh gives them. Its arrays are read-only
    views, which stay valid without it."""

    def __init__(self, held: _tan.Surface, value_name: str = "", length_unit: str = "") -> None:
        if not isinstance(held, _tan.Surface):
            raise TypeError("surfaces are made by Mesh.isosurface(), Mesh.slice() and Mesh.boundary()")
        self._held = held
        self.value_name = value_name
        self.length_unit = length_unit

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """Positions of the vertices, shape (n, 3), in units of length."""
        return self._held.points()

    @property
    def normals(self) -> npt.NDArray[np.float32]:
        """Unit normals at the vertices, shape (n, 3): of isosurfaces towards smaller values, of boundaries outwards, of slices along the
        plane's normal."""
        return self._held.normals()

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Numbers of vertices, shape (m, 3), counterclockwise seen from where the normals point. `.view("int32")` where other programs
        want signed numbers."""
        return self._held.triangles()

    @property
    def values(self) -> npt.NDArray[np.float32]:
        """The field at the vertices, shape (n,), in units of the values."""
        return self._held.values()

    def area(self) -> float:
        """The sum of the triangles' areas, in the square of the unit of length."""
        a, b, c = (self.points[self.triangles[:, corner]] for corner in range(3))
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

    def to_vtk(self) -> Any:
        """A vtkPolyData with the field and the normals as arrays of the points. Needs VTK."""
        from .vtk import poly_data
        return poly_data(self)

    def to_meshio(self) -> Any:
        """A meshio.Mesh with the field as data of the points. Needs meshio."""
        from .meshio import surface_mesh
        return surface_mesh(self)

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData. Needs PyVista."""
        from .pyvista import wrapped
        return wrapped(self.to_vtk())

    def __repr__(self) -> str:
        return f"<tan.Surface {len(self.points):,} vertices, {len(self.triangles):,} triangles>"


class Mesh:
    """A conforming mesh of tetrahedra with a value at each vertex and a known error. Model.mesh() makes it. Its arrays are read-only views
    of memory that is not copied; they stay valid without the mesh and the model."""

    def __init__(self, held: _tan.Mesh, value_name: str = "", length_unit: str = "") -> None:
        if not isinstance(held, _tan.Mesh):
            raise TypeError("meshes are made by Model.mesh()")
        self._held = held
        self._facts = held.facts()
        self.value_name = value_name
        self.length_unit = length_unit

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """Positions of the vertices, shape (n, 3): x, y and z, in units of length."""
        return self._held.points()

    @property
    def values(self) -> npt.NDArray[np.float32]:
        """The field at the vertices, shape (n,), in units of the values."""
        return self._held.values()

    @property
    def tetrahedra(self) -> npt.NDArray[np.uint32]:
        """Numbers of vertices, shape (m, 4), positively oriented. `.view("int32")` where other programs want signed numbers."""
        return self._held.tetrahedra()

    @property
    def sites(self) -> npt.NDArray[np.uint32]:
        """The model's site that each vertex is, shape (n,); 2**32 - 1 for vertices that cutting made."""
        return self._held.sites()

    @property
    def error(self) -> Optional[float]:
        """The largest error that the mesh has at the samples, in % of the range of values, as the model guarantees it; None where points were
        inserted for a focus. Where a simplified boundary leaves samples outside (irregular data), it is that of a tetrahedron near by;
        Model.verify() also measures the error at the nearest place."""
        reached = self._facts["reached"]
        return None if reached is None else float(reached[0])

    @property
    def warping(self) -> Optional[float]:
        """Likewise how far the mesh lies from the data in space, in % of the diagonal of their bounds."""
        reached = self._facts["reached"]
        return None if reached is None else float(reached[1])

    @property
    def scale(self) -> float:
        """1 if the mesh keeps what was asked for; more if a budget did not allow it, or the model has nothing finer: the mesh keeps so
        many times the error."""
        return float(self._facts["scale"])

    def volume(self) -> float:
        """The sum of the tetrahedra's volumes, in the cube of the unit of length."""
        return self._held.volume()

    def sample(self, places: npt.ArrayLike, *, progress: Progress = None) -> npt.NDArray[np.float64]:
        """Values at places, by linear interpolation in the tetrahedra: an array of shape (n,) for places of shape (n, 3), a number for
        one of shape (3,). Not a number where a place lies outside the mesh. The first call makes an index of the mesh."""
        array = np.asarray(places)
        single = array.ndim == 1
        checked = real_array(array[np.newaxis] if single else array, "places", (None, 3))
        with reporting(progress) as report:
            values = self._held.sample(checked, report)
        return cast("npt.NDArray[np.float64]", values[0]) if single else values

    def isosurface(self, value: float, *, progress: Progress = None) -> Surface:
        """Where the field has this value, in units of the values: closed but for the boundary of the domain."""
        with reporting(progress) as report:
            surface = self._surface(self._held.isosurface(number(value, "value"), report))
        if not len(surface.triangles) and len(self.values):
            warnings.warn(f"The surface of {float(value):g} is empty: the values of the mesh lie between {self.values.min():g} and {self.values.max():g}.",
                          stacklevel=2)
        return surface

    def slice(self, normal: Vector, at: Any, *, progress: Progress = None) -> Surface:
        """The cut of a plane through the mesh. `normal` (x, y, z) is of any length but 0; `at` is a point (x, y, z) of the plane, or its
        distance from the origin along the normal, in units of length."""
        direction = vector(normal, "normal")
        longest = max(abs(part) for part in direction)
        if longest == 0:
            raise WrongUsage("normal is 0, which is no direction.")
        scaled = np.divide(direction, longest)  # whose square is neither too large nor too small for a double
        unit = scaled / np.linalg.norm(scaled)
        is_point = hasattr(at, "__len__") and getattr(at, "ndim", 1) > 0
        offset = float(np.dot(unit, vector(at, "at"))) if is_point else number(at, "at")
        with reporting(progress) as report:
            return self._surface(self._held.slice(tuple(unit), offset, report))

    def boundary(self, *, feature_angle: float = 30, progress: Progress = None) -> Surface:
        """The surface of the mesh, cavities included. At edges that turn by more than `feature_angle` degrees a vertex comes once for each
        side, with the normal of that."""
        with reporting(progress) as report:
            return self._surface(self._held.boundary(number(feature_angle, "feature_angle", least=0), report))

    def _surface(self, held: _tan.Surface) -> Surface:
        return Surface(held, self.value_name, self.length_unit)

    def to_vtk(self) -> Any:
        """A vtkUnstructuredGrid that shares points, values and tetrahedra with this mesh. Needs VTK."""
        from .vtk import unstructured_grid
        return unstructured_grid(self)

    def to_meshio(self) -> Any:
        """A meshio.Mesh of the same arrays. Needs meshio."""
        from .meshio import tetrahedral_mesh
        return tetrahedral_mesh(self)

    def to_pyvista(self) -> Any:
        """A pyvista.UnstructuredGrid. Needs PyVista."""
        from .pyvista import wrapped
        return wrapped(self.to_vtk())

    def __repr__(self) -> str:
        kept = "" if self.error is None else f", error {self.error:.3g} %"
        return f"<tan.Mesh {len(self.points):,} vertices, {len(self.tetrahedra):,} tetrahedra{kept}>"

