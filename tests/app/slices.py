#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""slices.py BUILD: slices and projections as `tan render` makes them are those of the mesh, judged by VTK, which cuts the mesh that `tan extract`
writes, and by numpy, tetrahedron by tetrahedron. Exit code 77: something is missing."""
import itertools
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
    from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkPlane, vtkUnstructuredGrid
    from vtkmodules.vtkFiltersCore import vtkCutter
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
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


def write_step(path):
    """Cubes of six tetrahedra each: those with x < 1 end at z = 1, the others at z = 2."""
    sizes, half = (4, 2, 4), 0.5
    corners, cells = {}, []
    for i, j, k in numpy.ndindex(*sizes):
        if i * half >= 1 or k * half < 1:
            for order in itertools.permutations(range(3)):
                at = numpy.array([i, j, k])
                cell = [tuple(at)]
                for axis in order:
                    at[axis] += 1
                    cell.append(tuple(at))
                cells.append([corners.setdefault(corner, len(corners)) for corner in cell])
    places = numpy.array(list(corners)) * half
    grid, points, array = vtkUnstructuredGrid(), vtkPoints(), numpy_to_vtk(numpy.sin(3 * places[:, 0]) + places[:, 1] ** 2 + places[:, 2], deep=True)
    points.SetData(numpy_to_vtk(places, deep=True))
    grid.SetPoints(points)
    grid.Allocate(len(cells))
    for a, b, c, d in cells:
        edges = places[[b, c, d]] - places[a]
        ids = (a, b, c, d) if numpy.linalg.det(edges) > 0 else (a, b, d, c)
        grid.InsertNextCell(VTK_TETRA, 4, ids)
    array.SetName("field")
    grid.GetPointData().SetScalars(array)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()


def cut_by_vtk(mesh, normal, offset):
    plane, cutter = vtkPlane(), vtkCutter()
    plane.SetOrigin(numpy.array(normal) * offset / numpy.dot(normal, normal))
    plane.SetNormal(normal)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOn()
    cutter.SetInputData(mesh)
    cutter.Update()
    return cutter.GetOutput()


class Cells:
    """Of each tetrahedron: where barycentric coordinates are linear functions of the place, and the values at its corners."""

    def __init__(self, mesh):
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 4)
        edges = (points[corners[:, 1:]] - points[corners[:, :1]]).transpose(0, 2, 1)
        with_volume = numpy.abs(numpy.linalg.det(edges)) > 1e-12 * numpy.ptp(points, axis=0).prod()
        self.origins = points[corners[with_volume, 0]]
        self.inverses = numpy.linalg.inv(edges[with_volume])
        self.values = vtk_to_numpy(values_of(mesh)).astype(float)[corners[with_volume]]

    def coordinates(self, place, direction=None):
        """Four of each cell; with a direction their changes along it."""
        three = self.inverses @ direction if direction is not None else numpy.einsum("cij,cj->ci", self.inverses, place - self.origins)
        first = (0 if direction is not None else 1) - three.sum(axis=1, keepdims=True)
        return numpy.concatenate([first, three], axis=1)

    def off(self, place, value):
        """How far a value is off that of the cells that hold the place, at the best; those beside it count to rounding."""
        shares = self.coordinates(place)
        holds = shares.min(axis=1) > -1e-4
        return numpy.abs((shares * self.values).sum(axis=1) - value)[holds].min(initial=numpy.inf)

    def extremes(self, place, direction):
        """The smallest and the largest value along a line: they are where it enters or leaves a cell."""
        at, change = self.coordinates(place), self.coordinates(place, direction)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            zero = -at / change
        begin = numpy.where(change > 0, zero, -numpy.inf).max(axis=1)
        end = numpy.where(change < 0, zero, numpy.inf).min(axis=1)
        passed = (begin < end) & ~((change == 0) & (at < 0)).any(axis=1)
        ends = numpy.stack([begin, end])[:, passed, None]
        values = ((at[passed] + ends * change[passed]) * self.values[passed]).sum(axis=2)
        return values.min(), values.max()


def values_of(data):
    return data.GetPointData().GetArray(0)


def picture(path):
    """Rows from the top, channels red, green, blue."""
    image = read(vtkPNGReader(), path)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].astype(float)


class Slices(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)

    def mesh_of(self, kind):
        """Its model is made once."""
        sample, size, data = SAMPLES[kind]
        self.folder = pathlib.Path(self.kept.name) / kind
        if not self.folder.exists():
            self.folder.mkdir()
            tan(self.folder, "sample", sample, "--size", size, "-o", data)
            tan(self.folder, "build", data, "-o", "model.tan")
            tan(self.folder, "extract", "model.tan", "--error", 1, "-o", "mesh.vtu")
        return read(vtkXMLUnstructuredGridReader(), self.folder / "mesh.vtu")

    def slice_of(self, *planes):
        asked = [word for plane in planes for word in ("--slice", plane)]
        tan(self.folder, "render", "model.tan", "--error", 1, *asked, "--size", "32x24", "--surfaces", "slice.vtp", "-o", "slice.png")
        return read(vtkXMLPolyDataReader(), self.folder / "slice.vtp")

    def check_planes(self, kind):
        mesh = self.mesh_of(kind)
        bounds = numpy.array(mesh.GetBounds()).reshape(3, 2)
        middle, reach = bounds.mean(axis=1), numpy.ptp(bounds, axis=1)
        spread, cells = numpy.ptp(vtk_to_numpy(values_of(mesh))), Cells(mesh)
        for normal, share in (((1, 0, 0), 0.103), ((0, 0, 1), -0.207), ((1, -2, 0.5), 0.011), ((0.3, 0.4, 2), 0.053)):
            offset = numpy.dot(normal, middle + share * reach)
            across = [axis for axis in range(3) if normal == tuple(numpy.eye(3)[axis])]
            text = f"{'xyz'[across[0]]}={offset!r}" if across else ",".join(repr(float(number)) for number in (*normal, offset))
            found, expected = self.slice_of(text), cut_by_vtk(mesh, normal, offset)
            self.assertAlmostEqual(area(found) / area(expected), 1, delta=1e-5, msg=f"{kind}, {text}")
            places = vtk_to_numpy(found.GetPoints().GetData()).astype(float)
            self.assertLess(numpy.abs(places @ normal - offset).max(), 1e-5 * numpy.linalg.norm(reach) * numpy.linalg.norm(normal))
            values = vtk_to_numpy(values_of(found)).astype(float)
            for vertex in range(0, len(places), 1 + len(places) // 100):
                self.assertLess(cells.off(places[vertex], values[vertex]), 1e-4 * spread, f"{kind}, {text}")

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
            planes = [f"{'xyz'[axis]}={float(place)!r}" for place in (places[0], places[len(places) // 2], places[-1])]
            self.assertAlmostEqual(area(self.slice_of(*planes)) / of_box, len(planes), delta=1e-6)

    def test_parts_that_end_in_the_plane(self):
        """In z = 1 one half of a step ends and the other goes on: both are seen, as in VTK's cut."""
        self.folder = pathlib.Path(self.kept.name) / "step"
        self.folder.mkdir()
        write_step(self.folder / "data.vtu")
        tan(self.folder, "build", "data.vtu", "-o", "model.tan")
        tan(self.folder, "extract", "model.tan", "--error", 1, "-o", "mesh.vtu")
        mesh = read(vtkXMLUnstructuredGridReader(), self.folder / "mesh.vtu")
        for text, normal, offset in (("z=1", (0, 0, 1), 1), ("0,0,-1,-1", (0, 0, -1), -1), ("x=1", (1, 0, 0), 1)):
            # VTK takes the faces in the plane of those cells alone that lie on one side of it: here of one half, or of both.
            least, most = sorted((area(cut_by_vtk(mesh, normal, offset)), area(cut_by_vtk(mesh, numpy.negative(normal), -offset))))
            self.assertGreater(most, least + 0.3)
            self.assertAlmostEqual(area(self.slice_of(text)), most, delta=1e-5, msg=text)

    def test_projections(self):
        """The largest and the smallest value of rays parallel to y, in a grey that stands for it."""
        mesh = self.mesh_of("lattice")
        bounds = numpy.array(mesh.GetBounds()).reshape(3, 2)
        middle, reach = bounds.mean(axis=1), numpy.ptp(bounds, axis=1)
        values = vtk_to_numpy(values_of(mesh))
        least, largest = float(values.min()), float(values.max())
        grey = {"format": "tan-transfer-function", "version": 2, "colours": [{"value": least, "colour": [0, 0, 0]}, {"value": largest, "colour": [1, 1, 1]}],
                "opacities": [{"value": least, "opacity": 0}, {"value": largest, "opacity": 0.5}]}
        (self.folder / "grey.json").write_text(json.dumps(grey))
        size, distance = 24, 2 * reach.max()
        half = distance * numpy.tan(numpy.radians(15))  # of what is seen
        camera = {"azimuth": 0, "elevation": 0, "perspective": False, "fieldOfView": 30, "target": list(middle), "distance": distance}
        (self.folder / "camera.json").write_text(json.dumps(camera))
        step = 2 * half / size
        x = middle[0] - half + step * (numpy.arange(size) + 0.5)
        z = middle[2] + half - step * (numpy.arange(size) + 0.5)
        rows, columns = numpy.nonzero((numpy.abs(z - middle[2]) < reach[2] / 2 - step)[:, None] & (numpy.abs(x - middle[0]) < reach[0] / 2 - step))
        self.assertGreater(len(rows), 100)
        cells = Cells(mesh)
        expected = numpy.array([cells.extremes(numpy.array([x[column], middle[1], z[row]]), numpy.array([0.0, 1, 0])) for row, column in zip(rows, columns)])
        for name, of_rays in zip(("minimum", "maximum"), expected.T):
            tan(self.folder, "render", "model.tan", "--error", 1, "--mode", "projection", "--projection", name, "--transfer", "grey.json",
                "--camera", "camera.json", "--size", f"{size}x{size}", "--samples", 1, "--no-outline", "-o", f"{name}.png")
            seen = picture(self.folder / f"{name}.png")[rows, columns]
            self.assertTrue((seen.max(axis=1) == seen.min(axis=1)).all())
            off = numpy.abs(seen.mean(axis=1) - 255 * (of_rays - least) / (largest - least))
            self.assertLess(off.max(), 2, name)  # rays pass a little beside the middle of their pixels
            self.assertGreater(numpy.ptp(seen), 50 if name == "maximum" else 5)


unittest.main()
