#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""sampled_volume.py BUILD DATA... [--sizes 512] [--threads 1] [--rounds 5]: the samples of lattices (NRRD files) as `tan render --show data` draws
them, against VTK's vtkFixedPointVolumeRayCastMapper (linear, distance 1, one ray a pixel) with the same camera and function: times as ratios of
medians, taken by turns, and what 600 rays are off numpy's integral of the trilinear field, each program by its own definition of opacities
between points. A function that fills the volume and a sparse one, unlit and lit. Needs a display for VTK (xvfb-run). Pin it to quiet processors."""
import argparse
import gzip
import json
import pathlib
import statistics
import subprocess
import tempfile
import time

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("build", type=pathlib.Path)
arguments.add_argument("data", nargs="+", type=pathlib.Path)
arguments.add_argument("--sizes", type=int, nargs="+", default=[512])
arguments.add_argument("--threads", type=int, nargs="+", default=[1])
arguments.add_argument("--rounds", type=int, default=5)
asked = arguments.parse_args()
asked.build = asked.build.resolve()

RAYS, STEPS = 600, 24  # of a cell
COLOURS = [(0, (0, 0, 1)), (0.25, (0, 1, 1)), (0.5, (0, 1, 0)), (0.75, (1, 1, 0)), (1, (1, 0, 0))]
OPACITIES = {"full": [(0, 0), (0.05, 0.02), (0.2, 0.1), (0.5, 0.25), (1, 0.8)], "sparse": [(0, 0), (0.4, 0), (0.5, 0.3), (1, 0.8)]}
VIEW = {"azimuth": 30, "elevation": 20, "fieldOfView": 30}


class Case:
    """A lattice, a function and a camera."""

    def __init__(self, image, opacities):
        self.image, self.opacities = image, OPACITIES[opacities]
        self.size, self.spacing = numpy.array(image.GetDimensions()), numpy.array(image.GetSpacing())
        self.origin = numpy.array(image.GetOrigin())
        self.values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(self.size[::-1])
        self.least, self.reach = float(self.values.min()), float(numpy.ptp(self.values))
        extent = (self.size - 1) * self.spacing
        self.unit = numpy.linalg.norm(extent) / 40
        self.target = self.origin + extent / 2
        self.distance = 0.55 * numpy.linalg.norm(extent) / numpy.tan(numpy.radians(VIEW["fieldOfView"] / 2))
        turn, rise = numpy.radians([VIEW["azimuth"], VIEW["elevation"]])
        forward = numpy.array([-numpy.sin(turn) * numpy.cos(rise), numpy.cos(turn) * numpy.cos(rise), -numpy.sin(rise)])
        right = numpy.array([numpy.cos(turn), numpy.sin(turn), 0])
        self.axes = right, numpy.cross(right, forward), forward
        self.eye = self.target - self.distance * forward

    def value(self, share):
        return self.least + share * self.reach

    def files(self, folder):
        (folder / "camera.json").write_text(json.dumps({**VIEW, "perspective": True, "target": list(self.target), "distance": self.distance}))
        (folder / "function.json").write_text(json.dumps({
            "format": "tan-transfer-function", "version": 2, "unitDistance": self.unit,
            "colours": [{"value": self.value(share), "colour": colour} for share, colour in COLOURS],
            "opacities": [{"value": self.value(share), "opacity": opacity} for share, opacity in self.opacities]}))

    def trilinear(self, places):
        places = numpy.clip(places, 0, self.size - 1)
        first = numpy.minimum(places.astype(int), self.size - 2)
        share = places - first
        return sum(numpy.prod(numpy.where(corner, share, 1 - share), axis=-1) * self.values[tuple((first + corner).T[::-1])]
                   for corner in numpy.ndindex(2, 2, 2))

    def integral(self, column, row, size, linear_extinction):
        """The colour, of 255, on black."""
        right, up, forward = self.axes
        reach = numpy.tan(numpy.radians(VIEW["fieldOfView"] / 2))
        direction = forward + (column / size * 2 - 1) * reach * right + (1 - row / size * 2) * reach * up
        direction /= numpy.linalg.norm(direction)
        at, along = (self.eye - self.origin) / self.spacing, direction / self.spacing
        with numpy.errstate(divide="ignore"):
            ends = numpy.stack([-at / along, (self.size - 1 - at) / along])
        begin, end = max(ends.min(axis=0).max(), 0), ends.max(axis=0).min()
        if end <= begin:
            return numpy.zeros(3)
        steps = int(numpy.ceil((end - begin) * numpy.abs(along).max() * STEPS))
        values = self.trilinear(at + numpy.linspace(begin, end, steps + 1)[:, None] * along)
        middle = (values[1:] + values[:-1]) / 2
        knots = [self.value(share) for share, _ in self.opacities]
        opacities = numpy.array([opacity for _, opacity in self.opacities])
        if linear_extinction:
            extinction = numpy.interp(middle, knots, -numpy.log1p(-opacities) / self.unit)
        else:
            extinction = -numpy.log1p(-numpy.interp(middle, knots, opacities)) / self.unit
        left = numpy.exp(-numpy.concatenate([[0], numpy.cumsum(extinction * (end - begin) / steps)]))
        at_colours = [self.value(share) for share, _ in COLOURS]
        channels = numpy.stack([numpy.interp(middle, at_colours, [colour[channel] for _, colour in COLOURS]) for channel in range(3)])
        return 255 * (channels * (left[:-1] - left[1:])).sum(axis=1)


class VtkPicture:
    def __init__(self, case, lit, size, threads):
        colours, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
        for share, colour in COLOURS:
            colours.AddRGBPoint(case.value(share), *colour)
        for share, opacity in case.opacities:
            opacities.AddPoint(case.value(share), opacity)
        self.look = vtk.vtkVolumeProperty()
        self.look.SetColor(colours)
        self.look.SetScalarOpacity(opacities)
        self.look.SetScalarOpacityUnitDistance(case.unit)
        self.look.SetInterpolationTypeToLinear()
        self.look.SetShade(lit)
        self.mapper = vtk.vtkFixedPointVolumeRayCastMapper()
        self.mapper.SetInputData(case.image)
        self.mapper.AutoAdjustSampleDistancesOff()
        self.mapper.SetImageSampleDistance(1)
        self.mapper.SetSampleDistance(1)
        self.mapper.SetInteractiveSampleDistance(1)
        self.mapper.SetNumberOfThreads(threads)
        self.volume = vtk.vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.volume.SetProperty(self.look)
        renderer = vtk.vtkRenderer()
        renderer.AddVolume(self.volume)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(size, size)
        self.window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*case.eye)
        camera.SetFocalPoint(*case.target)
        camera.SetViewUp(*case.axes[1])
        camera.SetViewAngle(VIEW["fieldOfView"])
        renderer.ResetCameraClippingRange()
        self.camera, self.renderer = camera, renderer
        self.window.Render()

    def pixels(self):
        grabber = vtk.vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        image = grabber.GetOutput()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(*image.GetDimensions()[1::-1], -1)[::-1, :, :3].astype(float)

    def seconds(self):
        self.camera.Modified()
        self.volume.Modified()
        start = time.perf_counter()
        self.window.Render()
        return time.perf_counter() - start


def tan(folder, *words):
    done = subprocess.run([asked.build / "bin/tan", *map(str, words), "--json"], cwd=folder, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def read_nrrd(path):
    """Of attached samples along the axes, packed or not."""
    header, samples = path.read_bytes().split(b"\n\n", 1)
    said = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    samples = gzip.decompress(samples) if said["encoding"] == "gzip" else samples
    image = vtk.vtkImageData()
    image.SetDimensions(*map(int, said["sizes"].split()))
    image.SetSpacing(*map(float, said.get("spacings", "1 1 1").split()))
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.frombuffer(samples, {"float": "f4", "double": "f8"}.get(said["type"], said["type"])), deep=1))
    return image


def read_png(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(*image.GetDimensions()[1::-1], -1)[::-1, :, :3].astype(float)


def drawn(folder, lit, size, threads):
    figures = tan(folder, "render", "model.tan", "--mode", "volume", "--show", "data", "--error", 50, "--transfer", "function.json", "--camera", "camera.json",
                  "--size", f"{size}x{size}", "--samples", 1, "--background", "black", "--no-outline", "--threads", threads,
                  "--shaded" if lit else "--no-shaded", "-o", "picture.png")
    return figures["set_up_seconds"] + figures["fill_seconds"]


def largest_error(case, pixels, size, linear_extinction, beside):
    """Without the border of the picture, where texts may stand."""
    random = numpy.random.default_rng(5)
    places = random.integers(size // 8, size - size // 8, (RAYS, 2))
    return max(numpy.abs(pixels[row, column] - case.integral(column + beside[0], row + beside[1], size, linear_extinction)).max() for column, row in places)


def measure(folder, name, image):
    for kind in OPACITIES:
        case = Case(image, kind)
        case.files(folder)
        for size in asked.sizes:
            for threads in asked.threads:
                for lit in (False, True):
                    vtk_picture = VtkPicture(case, lit, size, threads)
                    ours, theirs = zip(*[(drawn(folder, lit, size, threads), vtk_picture.seconds()) for _ in range(asked.rounds)])
                    ratio = statistics.median(ours) / statistics.median(theirs)
                    text = f"{name:12} {kind:7} {'lit' if lit else 'unlit':5} {size} {threads} threads: {statistics.median(ours):.3f} s, {ratio:.2f} of VTK's"
                    if not lit:
                        errors = (largest_error(case, read_png(folder / "picture.png"), size, True, (0.50137, 0.50211)),
                                  largest_error(case, vtk_picture.pixels(), size, False, (0.5, 0.5)))
                        text += f"; largest error {errors[0]:.2f}, VTK's {errors[1]:.2f} of 255"
                    print(text, flush=True)


for data in asked.data:
    with tempfile.TemporaryDirectory() as made:
        place = pathlib.Path(made)
        (place / data.name).symlink_to(data.resolve())
        tan(place, "build", data.name, "-o", "model.tan", "--error", 40)
        measure(place, data.name.split("_")[0], read_nrrd(data))
