# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and surfaces for VTK. Points and values are shared with it; so are the numbers of vertices of meshes with fewer than 2^31."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._mesh import Mesh, Surface


def _points(points: Any) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    made = vtkPoints()
    made.SetData(numpy_to_vtk(points))
    return made


def _cells(corners: Any) -> Any:
    """VTK 9.1's vtkCellArray makes arrays of its own of the same memory, which do not keep NumPy's alive: so these are copies."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    count, width = corners.shape
    kind = np.int32 if corners.size < 2**31 else np.int64
    made = vtkCellArray()
    made.SetData(numpy_to_vtk(np.arange(0, width * count + 1, width, dtype=kind), deep=1),
                 numpy_to_vtk(corners.astype(kind).ravel(), deep=1))
    return made


def _add(data: Any, array: Any, name: str) -> None:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    made = numpy_to_vtk(array)
    made.SetName(name)
    data.AddArray(made)


def unstructured_grid(mesh: Mesh) -> Any:
    """A vtkUnstructuredGrid of tetrahedra, with the field as the active array of its points and the sites beside it."""
    from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
    grid = vtkUnstructuredGrid()
    grid.SetPoints(_points(mesh.points))
    grid.SetCells(VTK_TETRA, _cells(mesh.tetrahedra))
    name = mesh.value_name or "value"
    _add(grid.GetPointData(), mesh.values, name)
    _add(grid.GetPointData(), mesh.sites, "site")
    grid.GetPointData().SetActiveScalars(name)
    return grid


def poly_data(surface: Surface) -> Any:
    """A vtkPolyData, with the field as the active array of its points, and the normals."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    made = vtkPolyData()
    made.SetPoints(_points(surface.points))
    made.SetPolys(_cells(surface.triangles))
    name = surface.value_name or "value"
    _add(made.GetPointData(), surface.values, name)
    made.GetPointData().SetActiveScalars(name)
    normals = numpy_to_vtk(surface.normals)
    normals.SetName("normals")
    made.GetPointData().SetNormals(normals)
    return made
