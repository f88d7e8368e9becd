# SPDX-License-Identifier: GPL-3.0-or-later
"""The yardstick of the rendering benchmark: VTK draws the same tetrahedra with the same transfer function and cameras.

    vtk_volume.py FOLDER

FOLDER holds scene.json and the arrays positions, values and tetrahedra as rendering_benchmark.cpp writes them. Prints
one JSON object: for each mapper the seconds of each frame. The first frame is drawn twice and counted once.
"""
import json
import os
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkVolumeProperty, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper, vtkUnstructuredGridVolumeRayCastMapper
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 the factory of render windows
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401 and of the mapper

# On one core the time that the process had the core: others may use the machine too.
clock = time.process_time if len(os.sched_getaffinity(0)) == 1 else time.perf_counter

MAPPERS = {"vtkProjectedTetrahedraMapper": vtkProjectedTetrahedraMapper,
           "vtkUnstructuredGridVolumeRayCastMapper": vtkUnstructuredGridVolumeRayCastMapper}


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
    grid.GetPointData().SetScalars(numpy_to_vtk(numpy.fromfile(os.path.join(folder, "values"), numpy.float32), deep=1))
    return grid


def volume_property(scene):
    colours, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for point in scene["points"]:
        colours.AddRGBPoint(point["value"], *point["colour"])
        opacities.AddPoint(point["value"], point["opacity"])
    result = vtkVolumeProperty()
    result.SetColor(colours)
    result.SetScalarOpacity(opacities)
    result.SetScalarOpacityUnitDistance(scene["unitDistance"])
    result.SetInterpolationTypeToLinear()
    result.ShadeOff()
    return result


def draw(scene, grid, name, folder):
    mapper = MAPPERS[name]()
    mapper.SetInputData(grid)
    if name == "vtkUnstructuredGridVolumeRayCastMapper":
        mapper.SetAutoAdjustSampleDistances(False)
        mapper.SetImageSampleDistance(1)
        mapper.SetNumberOfThreads(len(os.sched_getaffinity(0)))
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(volume_property(scene))
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddVolume(volume)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(scene["width"], scene["height"])
    window.AddRenderer(renderer)
    seconds = []
    for number, camera in enumerate(scene["cameras"][:1] + scene["cameras"]):
        view = renderer.GetActiveCamera()
        view.SetPosition(camera["eye"])
        view.SetFocalPoint(camera["target"])
        view.SetViewUp(0, 0, 1)
        view.SetViewAngle(30)
        renderer.ResetCameraClippingRange()
        start = clock()
        window.Render()
        window.WaitForCompletion()
        if number > 0:
            seconds.append(clock() - start)
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(os.path.join(folder, name + ".png"))
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()
    return seconds


def main():
    folder = sys.argv[1]
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        scene = json.load(file)
    grid = read_grid(folder)
    result = {name: draw(scene, grid, name, folder) for name in MAPPERS}
    result["version"] = vtkVersion.GetVTKVersion()
    print(json.dumps(result))


main()
