# SPDX-License-Identifier: GPL-3.0-or-later
"""paraview_pictures.py DATA FOLDER, by ParaView's pvbatch: the pictures of first_pictures.py as ParaView makes them with its defaults: the representation
Volume, and the filter Contour, of the first array of points that has one component."""
import pathlib
import sys

from paraview import simple

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from first_pictures import DATASETS, SIZE, input_of  # noqa: E402

data, folder = (pathlib.Path(place).resolve() for place in sys.argv[1:3])
(folder / "paraview").mkdir(parents=True, exist_ok=True)


def opened(file):
    if file.suffix == ".xyz":
        reader = simple.PLOT3DReader(FileName=str(file), QFileName=[str(file.with_suffix(".q"))])
        return simple.MergeBlocks(Input=reader)  # blocks of grids have no volume there
    return simple.OpenDataFile(str(file))


def array_of(source):
    source.UpdatePipeline()
    arrays = [source.PointData.GetArray(i) for i in range(source.PointData.GetNumberOfArrays())]
    return next(array.GetName() for array in arrays if array.GetNumberOfComponents() == 1)


def picture(name, what, show):
    file = folder / "paraview" / f"{name}-{what}.png"
    if file.exists():
        return
    view = simple.CreateView("RenderView")
    view.ViewSize = list(SIZE)
    view.OrientationAxesVisibility = 0
    show(view)
    view.ResetCamera()
    simple.SaveScreenshot(str(file), view, ImageResolution=list(SIZE))
    simple.Delete(view)
    print(file, flush=True)


for name in sys.argv[3:] or DATASETS:
    converted = folder / "converted" / f"{name}.vtk"
    source = opened(converted if converted.exists() else input_of(name, data, folder))
    array = array_of(source)

    def volume(view):
        shown = simple.Show(source, view)
        simple.ColorBy(shown, ("POINTS", array))
        shown.SetRepresentationType("Volume")
        shown.RescaleTransferFunctionToDataRange(True, False)
        shown.SetScalarBarVisibility(view, False)

    def surface(view):
        contour = simple.Contour(Input=source)
        contour.ContourBy = ["POINTS", array]
        low, high = source.PointData[array].GetRange()
        contour.Isosurfaces = [(low + high) / 2]  # what the form has at first
        shown = simple.Show(contour, view)
        simple.ColorBy(shown, None)

    picture(name, "volume", volume)
    picture(name, "surface", surface)
    simple.Delete(source)
