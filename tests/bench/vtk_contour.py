# SPDX-License-Identifier: GPL-3.0-or-later
"""The yardstick of the isosurface cases: VTK contours the same tetrahedra, with merged points and normals.

    vtk_contour.py FOLDER

FOLDER holds scene.json (isovalue, runs) and the arrays positions, values and tetrahedra as vtk_yardstick.cpp writes
them. Prints one JSON object: for each way of doing it the seconds of each run, after one that does not count.
"""
import json
import os
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkContour3DLinearGrid

# On one core the time that the process had the core: others may use the machine too.
clock = time.process_time if len(os.sched_getaffinity(0)) == 1 else time.perf_counter


def read_grid(folder):
    points = vtkPoints()
    positions = numpy.fromfile(os.path.join(folder, "positions"), numpy.float64).reshape(-1, 3)
    points.SetData(numpy_to_vtk(positions, deep=1))
    tetrahedra = numpy.fromfile(os.path.join(folder, "tetrahedra"), numpy.uint32).reshape(-1, 4).astype(numpy.int64)
    legacy = numpy.hstack([numpy.full((len(tetrahedra), 1), 4, numpy.int64), tetrahedra]).ravel()
    cells = vtkCellArray()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(legacy, deep=1))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(VTK_TETRA, cells)
    values = numpy_to_vtk(numpy.fromfile(os.path.join(folder, "values"), numpy.float32), deep=1)
    values.SetName("values")
    grid.GetPointData().SetScalars(values)
    return grid


def contour(grid, scene, tree):
    contouring = vtkContour3DLinearGrid()
    contouring.SetInputData(grid)
    contouring.SetMergePoints(True)
    contouring.SetComputeNormals(True)
    contouring.SetInterpolateAttributes(False)
    contouring.SetUseScalarTree(tree)
    contouring.SetValue(0, scene["isovalue"])
    seconds = []
    for _ in range(scene["runs"] + 1):
        contouring.Modified()
        start = clock()
        contouring.Update()
        seconds.append(clock() - start)
    return seconds[1:]


def main():
    folder = sys.argv[1]
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        scene = json.load(file)
    grid = read_grid(folder)
    result = {"vtkContour3DLinearGrid": contour(grid, scene, False),
              "vtkContour3DLinearGrid with scalar tree": contour(grid, scene, True),
              "version": vtkVersion.GetVTKVersion()}
    print(json.dumps(result))


main()
