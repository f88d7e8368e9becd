#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""slices.py BUILD: slices and projections as `tan render` makes them are those of the mesh, judged by VTK, which cuts and probes the mesh that
`tan extract` writes, and by numpy along each ray. Exit code 77: something is missing."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
    from vtkmodules.vtkFiltersCore import vtkCutter, vtkProbeFilter
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TAN = pathlib.Path(sys.argv.pop(1)).resolve() / "bin/tan"
SAMPLES = {"lattice": ("c60", 12, "data.nrrd"), "curvilinear": ("bent-duct", 8, "data.xyz"), "irregular": ("part", 8, "data.vtu")}


def tan(folder, *words):
    done = subprocess.run([str(TAN), *map(str, words), "--json"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return json.loads(done.stdout)


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def area(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float) if surface.GetNumberOfPoints() else numpy.zeros((0, 3))
    corners = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    return numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2


def cut_by_vtk(mesh, normal, offset):
    plane, cutter = vtkPlane(), vtkCutter()
    plane.SetOrigin(numpy.array(normal) * offset / numpy.dot(normal, normal))
    plane.SetNormal(normal)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOn()
    cutter.SetInputData(mesh)
    cutter.Update()
    return cutter.GetOutput()


def probed(mesh, places):
    """The values of the mesh at places, and which of them are in it."""
    points, asked, probe = vtkPoints(), vtkPolyData(), vtkProbeFilter()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    asked.SetPoints(points)
    probe.SetInputData(asked)
    probe.SetSourceData(mesh)
    probe.Update()
    found = probe.GetOutput().GetPointData()
    valid = vtk_to_numpy(found.GetArray(probe.GetValidPointMaskArrayName())).astype(bool)
    return vtk_to_numpy(found.GetArray(values_of(mesh).GetName())), valid


def values_of(data):
    return data.GetPointData().GetArray(0)


def picture(path):
    """Rows from the top, channels red, green, blue."""
    image = read(vtkPNGReader(), path)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].astype(float)


class Slices(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def mesh_of(self, kind):
        sample, size, data = SAMPLES[kind]
        tan(self.folder, "sample", sample, "--size", size, "-o", data)
        tan(self.folder, "build", data, "-o", "model.tan")
        tan(self.folder, "extract", "model.tan", "--error", 1, "-o", "mesh.vtu")
        return read(vtkXMLUnstructuredGridReader(), self.folder / "mesh.vtu")

    def slice_of(self, text, *options):
        tan(self.folder, "render", "model.tan", "--error", 1, "--slice", text, "--size", "32x24", "--surfaces", "slice.vtp", "-o", "slice.png", *options)
        return read(vtkXMLPolyDataReader(), self.folder / "slice.vtp")

    def check_planes(self, kind):
        mesh = self.mesh_of(kind)
        bounds = numpy.array(mesh.GetBounds()).reshape(3, 2)
        middle, reach = bounds.mean(axis=1), numpy.ptp(bounds, axis=1)
        spread = numpy.ptp(vtk_to_numpy(values_of(mesh)))
        for normal, share in (((1, 0, 0), 0.103), ((0, 0, 1), -0.207), ((1, -2, 0.5), 0.011), ((0.3, 0.4, 2), 0.053)):
            offset = numpy.dot(normal, middle + share * reach)
            across = [axis for axis in range(3) if normal == tuple(numpy.eye(3)[axis])]
            text = f"{'xyz'[across[0]]}={offset!r}" if across else ",".join(repr(float(number)) for number in (*normal, offset))
            found, expected = self.slice_of(text), cut_by_vtk(mesh, normal, offset)
            self.assertAlmostEqual(area(found) / area(expected), 1, delta=1e-5, msg=f"{kind}, {text}")
            places = vtk_to_numpy(found.GetPoints().GetData()).astype(float)
            self.assertLess(numpy.abs(places @ normal - offset).max(), 1e-5 * numpy.linalg.norm(reach) * numpy.linalg.norm(normal))
            values, inside = probed(mesh, places)
            self.assertGreater(inside.mean(), 0.5)
            off = numpy.abs(values - vtk_to_numpy(values_of(found)))[inside]
            self.assertLess(off.max(), 1e-3 * spread, f"{kind}, {text}")

    def test_lattices(self):
        self.check_planes("lattice")

    def test_curvilinear_grids(self):
        self.check_planes("curvilinear")

    def test_irregular_meshes(self):
        self.check_planes("irregular")

    def test_planes_through_vertices(self):
        """Faces of the mesh lie in them, at both ends as well: the area is that of the box, and nothing is there twice."""
        mesh = self.mesh_of("lattice")
        bounds = numpy.array(mesh.GetBounds()).reshape(3, 2)
        reach = numpy.ptp(bounds, axis=1)
        for axis in range(3):
            of_box = numpy.prod(numpy.delete(reach, axis))
            places = numpy.unique(vtk_to_numpy(mesh.GetPoints().GetData())[:, axis])
            for place in (places[0], places[len(places) // 2], places[-1]):
                self.assertAlmostEqual(area(self.slice_of(f"{'xyz'[axis]}={float(place)!r}")) / of_box, 1, delta=1e-6)

    def test_projections(self):
        """The largest and the smallest value of many places of each ray, parallel to y, in a grey that stands for it."""
        mesh = self.mesh_of("lattice")
        bounds = numpy.array(mesh.GetBounds()).reshape(3, 2)
        middle, reach = bounds.mean(axis=1), numpy.ptp(bounds, axis=1)
        values = vtk_to_numpy(values_of(mesh))
        least, largest = float(values.min()), float(values.max())
        grey = {"format": "tan-transfer-function", "version": 2, "colours": [{"value": least, "colour": [0, 0, 0]}, {"value": largest, "colour": [1, 1, 1]}],
                "opacities": [{"value": least, "opacity": 0}, {"value": largest, "opacity": 0.5}]}
        (self.folder / "grey.json").write_text(json.dumps(grey))
        size, depths = 24, 401
        distance = 2 * reach.max()
        half = distance * numpy.tan(numpy.radians(15)) # of what is seen
        camera = {"azimuth": 0, "elevation": 0, "perspective": False, "fieldOfView": 30, "target": list(middle), "distance": distance}
        (self.folder / "camera.json").write_text(json.dumps(camera))
        step = 2 * half / size
        x = middle[0] - half + step * (numpy.arange(size) + 0.5)
        z = middle[2] + half - step * (numpy.arange(size) + 0.5)
        y = numpy.linspace(bounds[1, 0], bounds[1, 1], depths)
        rows, columns = numpy.nonzero((numpy.abs(z - middle[2]) < reach[2] / 2 - step)[:, None] & (numpy.abs(x - middle[0]) < reach[0] / 2 - step))
        rays = numpy.stack([numpy.repeat(x[columns], depths), numpy.tile(y, len(rows)), numpy.repeat(z[rows], depths)], axis=1)
        along, inside = probed(mesh, rays)
        along = numpy.where(inside, along, numpy.nan).reshape(len(rows), depths)
        for name, expected in (("maximum", numpy.nanmax(along, axis=1)), ("minimum", numpy.nanmin(along, axis=1))):
            tan(self.folder, "render", "model.tan", "--error", 1, "--mode", "projection", "--projection", name, "--transfer", "grey.json",
                "--camera", "camera.json", "--size", f"{size}x{size}", "--samples", 4, "--no-outline", "-o", f"{name}.png")
            seen = picture(self.folder / f"{name}.png")[rows, columns]
            self.assertTrue((seen.max(axis=1) - seen.min(axis=1) <= 1).all())
            off = seen.mean(axis=1) - 255 * (expected - least) / (largest - least)
            # A pixel is the mean of its 16 samples, and the value of a ray bends: the mean of all is closer than each.
            self.assertLess(numpy.abs(off).max(), 12, name)
            self.assertLess(numpy.abs(off).mean(), 2.5, name)


unittest.main()
