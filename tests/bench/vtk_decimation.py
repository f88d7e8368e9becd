# SPDX-License-Identifier: GPL-3.0-or-later
"""The yardstick of decimation: VTK reduces the tetrahedra of a .vtu file by quadrics.

    vtk_decimation.py FOLDER FILE SHARE...

Writes into FOLDER the arrays positions and values (double) and tetrahedra (uint32) of the file, and with the ending
.0, .1 ... those of the meshes that keep each SHARE of the tetrahedra. Prints one JSON object: "seconds" of each.
"""
import json
import os
import sys
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersCore import vtkUnstructuredGridQuadricDecimation
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

# On one core the time that the process had the core: others may use the machine too.
clock = time.process_time if len(os.sched_getaffinity(0)) == 1 else time.perf_counter


def write_grid(grid, folder, ending):
    # The decimated grid's array has no name.
    values = grid.GetPointData().GetScalars() or grid.GetPointData().GetArray(0)
    positions = vtk_to_numpy(grid.GetPoints().GetData()).astype(numpy.float64)
    values = vtk_to_numpy(values).astype(numpy.float64)
    tetrahedra = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).astype(numpy.uint32)
    positions.tofile(os.path.join(folder, "positions" + ending))
    values.tofile(os.path.join(folder, "values" + ending))
    tetrahedra.tofile(os.path.join(folder, "tetrahedra" + ending))


def main():
    folder, file = sys.argv[1:3]
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    points = grid.GetPointData()
    name = (points.GetScalars() or points.GetArray(0)).GetName()
    write_grid(grid, folder, "")
    seconds = []
    for number, share in enumerate(sys.argv[3:]):
        decimation = vtkUnstructuredGridQuadricDecimation()
        decimation.SetInputData(grid)
        decimation.SetScalarsName(name)
        decimation.SetTargetReduction(1 - float(share))
        start = clock()
        decimation.Update()
        seconds.append(clock() - start)
        write_grid(decimation.GetOutput(), folder, "." + str(number))
    print(json.dumps({"seconds": seconds, "version": vtkVersion.GetVTKVersion()}))


main()
