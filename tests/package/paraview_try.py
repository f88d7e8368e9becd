# SPDX-License-Identifier: GPL-3.0-or-later
"""pvbatch paraview_try.py PLUGIN one|two: models of this folder through the plugin, beside the files that `tan extract` has written: legacy ones,
as Debian 12's ParaView does not read small XML files with appended data, its own neither."""
import sys

from paraview import servermanager
from paraview.simple import (ColorBy, Contour, CreateView, GetLookupTableForArray, Hide, IntegrateVariables, LegacyVTKReader, LoadPlugin, OpenDataFile,
                             Render, ResetCamera, SaveScreenshot, Show)

PLUGIN, RANKS = sys.argv[1:3]
LoadPlugin(PLUGIN, remote=True, ns=globals())


def array_of(data, name):
    array = data.GetPointData().GetArray(name)
    assert array is not None, name
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


def check_same(found, expected):
    assert found.GetNumberOfPoints() == expected.GetNumberOfPoints() > 0
    assert found.GetNumberOfCells() == expected.GetNumberOfCells() > 0
    for point in range(found.GetNumberOfPoints()):
        assert found.GetPoint(point) == expected.GetPoint(point), point
    for cell in range(found.GetNumberOfCells()):
        one, other = found.GetCell(cell), expected.GetCell(cell)
        assert [one.GetPointId(i) for i in range(4)] == [other.GetPointId(i) for i in range(4)], cell
    names = [expected.GetPointData().GetArrayName(i) for i in range(expected.GetPointData().GetNumberOfArrays())]
    assert names
    for name in names:
        assert array_of(found, name) == array_of(expected, name), name
    return names[0]


def area_of(source, name, value):
    contour = Contour(Input=source, ContourBy=["POINTS", name], Isosurfaces=[value])
    total = servermanager.Fetch(IntegrateVariables(Input=contour))
    return contour, total.GetCellData().GetArray("Area").GetValue(0)


for model in ("c60", "body", "part"):
    for error in (4, 1, 0):
        reader = OpenDataFile(f"{model}.tan")
        reader.Error = error
        reader.UpdatePipeline()
        file = LegacyVTKReader(FileNames=[f"{model}-{error}.vtk"])
        file.UpdatePipeline()
        counts = [source.GetDataInformation().GetNumberOfCells() for source in (reader, file)]
        if RANKS == "one":
            name = check_same(servermanager.Fetch(reader), servermanager.Fetch(file))
        else:
            name = file.PointData.GetArray(0).Name
        ends = file.PointData.GetArray(name).GetRange()
        middle = sum(ends) / 2
        contour, area = area_of(reader, name, middle)
        expected = area_of(file, name, middle)[1]
        assert abs(area - expected) <= 1e-6 * expected > 0, (model, error, area, expected)
        print(f"{model} at {error} %: {counts[0]} cells, of the file {counts[1]}; area of the contour at {middle:g}: {area:g}")
        if RANKS == "one":
            assert counts[0] == counts[1]
        if error == 1 and RANKS == "one":
            view = CreateView("RenderView")
            view.ViewSize = [500, 400]
            Show(contour, view)
            ResetCamera(view)
            Render(view)
            SaveScreenshot(f"{model}-contour.png", view)
            Hide(contour, view)
            shown = Show(reader, view)
            ColorBy(shown, ("POINTS", name))
            shown.SetRepresentationType("Volume")
            GetLookupTableForArray(name, 1)
            Render(view)
            SaveScreenshot(f"{model}-volume.png", view)
print("all as it should be")
