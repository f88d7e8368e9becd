#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""open_in_others.py BUILD: what TAn writes of meshes, boundaries and surfaces opens in the programs that people take next, and is there
what it is here: counts, volume, area, values. Judged by meshio, gmsh, VTK, ADMesh and assimp, and by closed forms of what the samples
are; nothing of TAn reads here. Exit code 77: one of them is missing."""
import json
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkFeatureEdges, vtkMassProperties, vtkPolyDataConnectivityFilter
    from vtkmodules.vtkFiltersModeling import vtkHausdorffDistancePointSetFilter
    from vtkmodules.vtkIOGeometry import vtkGLTFReader
    from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
for program in ("gmsh", "admesh", "assimp"):
    if shutil.which(program) is None:
        print(f"skipped: no {program}")
        sys.exit(77)

TAN = pathlib.Path(sys.argv.pop(1)).resolve() / "bin/tan"
RADIUS = 7.3  # of the ball, whose lattice has 21 points a unit apart along each axis


def run(*words, folder=None, messages=False):
    """What a program says, with `messages` on both ways."""
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return done.stdout + done.stderr if messages else done.stdout


def write_lattice(path, values):
    """A cube of samples a unit apart."""
    sizes = " ".join(str(size) for size in reversed(values.shape))
    head = f"NRRD0004\ntype: float\ndimension: 3\nsizes: {sizes}\nencoding: raw\nendian: little\nspacings: 1 1 1\n\n"
    path.write_bytes(head.encode() + values.astype("<f4").tobytes())


def distance_from(x, y, z):
    """Of the points of a lattice with 21 points along each axis."""
    axis = numpy.arange(21.0)
    return numpy.sqrt((axis[:, None, None] - z) ** 2 + (axis[None, :, None] - y) ** 2 + (axis[None, None, :] - x) ** 2)


def areas_around(points, triangles):
    """A third of the area of the triangles around each vertex."""
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    third = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 6
    return numpy.bincount(triangles.ravel(), numpy.repeat(third, 3), len(points))


def in_pieces(surface, other):
    """The same surface, of triangles about as large as most of the other one."""
    def corners_of(of):
        points = vtk_to_numpy(of.GetPoints().GetData()).astype(float)
        corners = points[vtk_to_numpy(of.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
        return corners, numpy.linalg.norm(corners - numpy.roll(corners, -1, axis=1), axis=2).max(axis=1)
    (corners, sizes), (_, others) = corners_of(surface), corners_of(other)
    length = numpy.sort(others)[len(others) // 2]
    points, polygons = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for (a, b, c), size in zip(corners, sizes):
        count = max(1, math.floor(size / length + 0.5))
        number = {(i, j): points.InsertNextPoint(a + (b - a) * (i / count) + (c - a) * (j / count))
                  for j in range(count + 1) for i in range(count + 1 - j)}
        for i, j in number:
            for piece in ([(i, j), (i + 1, j), (i, j + 1)], [(i + 1, j), (i + 1, j + 1), (i, j + 1)]):
                if all(corner in number for corner in piece):
                    polygons.InsertNextCell(3, [number[corner] for corner in piece])
    pieces = vtkPolyData()
    pieces.SetPoints(points)
    pieces.SetPolys(polygons)
    return pieces


def run_filter(made, **settings):
    for name, setting in settings.items():
        getattr(made, "Set" + name)(setting)
    made.Update()
    return made.GetOutput()


def volumes(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, corner]] for corner in range(4))
    return numpy.einsum("ij,ij->i", b - a, numpy.cross(c - a, d - a)) / 6


def area_and_volume(points, triangles):
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2, numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def cells(mesh, kind):
    return numpy.concatenate([block.data for block in mesh.cells if block.type == kind]).astype(int)


def glb_values(path):
    """Of each vertex; of an isosurface one for all."""
    content = path.read_bytes()
    length = struct.unpack_from("<I", content, 12)[0]
    told = json.loads(content[20:20 + length])
    mesh, = told["meshes"]
    attributes = mesh["primitives"][0]["attributes"]
    count = told["accessors"][attributes["POSITION"]]["count"]
    if "_VALUE" not in attributes:
        return numpy.full(count, mesh["extras"]["isovalue"])
    view = told["bufferViews"][told["accessors"][attributes["_VALUE"]]["bufferView"]]
    return numpy.frombuffer(content, "<f4", count, 28 + length + view["byteOffset"])


class Others(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        write_lattice(cls.folder / "ball.nrrd", RADIUS - distance_from(10, 10, 10))
        # A ball that the sides cut, and a small one that a corner cuts.
        write_lattice(cls.folder / "cut.nrrd", numpy.maximum(12 - distance_from(8, 10, 10), 4 - distance_from(20, 20, 20)))
        for name, words in (("c60.nrrd", ("c60", "--size", 15)), ("part.vtu", ("part", "--size", 10)), ("duct.xyz", ("bent-duct", "--size", 9)),
                            ("points.csv", ("scattered", "--size", 8))):
            run(TAN, "sample", *words, "-o", name, folder=cls.folder)
        for name in ("ball.nrrd", "cut.nrrd", "c60.nrrd", "part.vtu", "duct.xyz", "points.csv"):
            run(TAN, "build", name, "-o", pathlib.Path(name).stem + ".tan", folder=cls.folder)

    def made(self, command, model, name, *words):
        told = json.loads(run(TAN, command, model + ".tan", *words, "-o", name, "--json", folder=self.folder))
        return self.folder / name, told

    def by_gmsh(self, path):
        """The file as gmsh understands it."""
        out = path.with_suffix(path.suffix + ".msh")
        said = run("gmsh", path, "-save", "-format", "msh2", "-o", out, messages=True)
        self.assertNotRegex(said, "(?i)error|warning")
        return meshio.read(out)

    def by_vtk(self, path):
        reader = {".vtu": vtkXMLUnstructuredGridReader, ".vtp": vtkXMLPolyDataReader, ".vtk": vtkGenericDataObjectReader,
                  ".glb": vtkGLTFReader}[path.suffix]()
        reader.SetFileName(str(path))
        reader.Update()
        self.assertEqual(reader.GetErrorCode(), 0)
        if path.suffix != ".glb":
            return reader.GetOutput()
        joined, leaves = vtkAppendPolyData(), reader.GetOutput().NewIterator()
        while not leaves.IsDoneWithTraversal():
            joined.AddInputData(leaves.GetCurrentDataObject())
            leaves.GoToNextItem()
        joined.Update()
        return joined.GetOutput()

    def surface(self, path, array):
        """Places, triangles, and the values of the vertices; None where the format has none."""
        if path.suffix in (".vtp", ".vtk", ".glb"):
            read = self.by_vtk(path)
            points = vtk_to_numpy(read.GetPoints().GetData()).astype(float)
            triangles = vtk_to_numpy(read.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            if path.suffix == ".glb":  # whose y points up
                return points[:, [0, 2, 1]] * [1, -1, 1], triangles, glb_values(path)
            return points, triangles, vtk_to_numpy(read.GetPointData().GetArray(array))
        mesh = meshio.read(path)
        return mesh.points.astype(float), cells(mesh, "triangle"), None if path.suffix in (".stl", ".obj") else mesh.point_data[array].ravel()

    def test_meshes(self):
        """Every tetrahedron is positive, and together they fill the domain; values lie within those of the data."""
        original = meshio.read(self.folder / "part.vtu")
        of_part = volumes(original.points.astype(float), cells(original, "tetra")).sum()
        for model, volume in (("c60", 14.0 ** 3), ("ball", 20.0 ** 3), ("part", of_part), ("duct", None), ("points", None)):
            found = set()
            for ending in ("vtu", "vtk"):
                path, told = self.made("extract", model, f"mesh-{model}.{ending}", "--error", 0)
                mine, gmsh, vtk = meshio.read(path), self.by_gmsh(path) if ending == "vtk" else None, self.by_vtk(path)
                for mesh in filter(None, (mine, gmsh)):
                    with self.subTest(model=model, ending=ending, reader="gmsh" if mesh is gmsh else "meshio"):
                        tetrahedra = cells(mesh, "tetra")
                        self.assertEqual((len(mesh.points), len(tetrahedra)), (told["sites"], told["tetrahedra"]))
                        each = volumes(mesh.points.astype(float), tetrahedra)
                        self.assertGreater(each.min(), 0)
                        if volume is not None:
                            self.assertAlmostEqual(each.sum() / volume, 1, delta=1e-5)
                        found.add(round(each.sum(), 3))
                self.assertEqual((vtk.GetNumberOfPoints(), vtk.GetNumberOfCells()), (told["sites"], told["tetrahedra"]))
                values = mine.point_data["density" if model == "duct" else "value"].ravel()
                self.assertTrue((values == vtk_to_numpy(vtk.GetPointData().GetScalars())).all())
                if model == "ball":
                    self.assertLess(abs(values - RADIUS + numpy.linalg.norm(mine.points - 10, axis=1)).max(), 1e-5)
            self.assertEqual(len(found), 1, f"{model}: {found}")

    def test_lives_of_a_range(self):
        for ending in ("vtu", "vtk"):
            path, told = self.made("extract", "c60", f"lives.{ending}", "--range", "1,8")
            mesh = meshio.read(path)
            self.assertEqual(len(cells(mesh, "tetra")), told["tetrahedra"])
            birth, death = (mesh.cell_data[name][0].ravel() for name in ("birth_error", "death_error"))
            self.assertTrue((birth >= death).all() and (birth > death).any(), f"{ending}: {birth}, {death}")
        # Triangles have lives in VTK's files, but not in a PLY file, which readers would refuse.
        words = ("--range", "1,8", "--value", 120)
        path, told = self.made("isosurface", "c60", "lives.vtp", *words)
        self.assertEqual(self.by_vtk(path).GetCellData().GetArray("birth_error").GetNumberOfValues(), told["triangles"])
        path, told = self.made("isosurface", "c60", "lives.ply", *words)
        self.assertEqual(len(self.surface(path, "isovalue")[1]), told["triangles"])
        self.assertIn("(birth_error, death_error)", told["remarks"][0])

    def judge_surface(self, path, told, vertices, area, volume, array, values_at):
        """That a file has these triangles: closed, outwards, of this area and this volume within; and these values."""
        ending = path.suffix
        points, triangles, values = self.surface(path, array)
        self.assertEqual(len(triangles), told["triangles"], path)
        found = area_and_volume(points, triangles)
        self.assertAlmostEqual(found[0] / area, 1, delta=1e-5, msg=path)
        self.assertAlmostEqual(found[1] / volume, 1, delta=1e-5, msg=path)
        if ending != ".stl":
            self.assertEqual(len(points), vertices, path)
        if values is not None:
            self.assertTrue((values == values_at(points)).all(), path)
        if ending in (".ply", ".stl", ".obj", ".glb"):
            faces = re.search(r"Faces:\s+(\d+)", run("assimp", "info", path))
            self.assertEqual(int(faces[1]), told["triangles"], path)
        if ending == ".stl":
            said = run("admesh", path)
            for what in ("Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges", "Normals fixed"):
                self.assertRegex(said, rf"{what}\s+:\s+0\b", path)
            self.assertAlmostEqual(float(re.search(r"Volume\s+:\s+(\S+)", said)[1]) / volume, 1, delta=1e-4)
            gmsh = self.by_gmsh(path)
            self.assertEqual((len(gmsh.points), len(cells(gmsh, "triangle"))), (vertices, told["triangles"]), path)

    def test_boundaries(self):
        for model, volume, area in (("c60", 14.0 ** 3, 6 * 14.0 ** 2), ("ball", 20.0 ** 3, 6 * 20.0 ** 2)):
            path, mesh = self.made("extract", model, "whole.vtu", "--error", 3)
            read = meshio.read(path)
            points, tetrahedra = read.points.astype(float), cells(read, "tetra")
            values = dict(zip(map(tuple, points), read.point_data["value"].ravel()))
            faces = numpy.sort(numpy.concatenate([numpy.delete(tetrahedra, corner, axis=1) for corner in range(4)]), axis=1)
            faces, times = numpy.unique(faces, axis=0, return_counts=True)
            told = {**mesh, "triangles": int((times == 1).sum())}
            vertices = len(numpy.unique(faces[times == 1]))
            self.assertGreater(len(points), vertices)
            for ending in ("vtp", "ply", "stl", "obj", "glb"):
                self.judge_surface(self.made("extract", model, f"boundary.{ending}", "--error", 3)[0], told, vertices, area, volume, "value",
                                   lambda found, values=values: [values[tuple(place)] for place in found])

    def test_surfaces(self):
        """A sphere: within what linear pieces of its size lose of it, outwards from the larger values inside."""
        path, told = self.made("isosurface", "ball", "sphere.vtu", "--error", 0, "--value", 0)
        mesh = meshio.read(path)
        area, volume = area_and_volume(mesh.points.astype(float), cells(mesh, "triangle"))
        self.assertAlmostEqual(area / (4 * math.pi * RADIUS ** 2), 1, delta=0.02)
        self.assertAlmostEqual(volume / (4 / 3 * math.pi * RADIUS ** 3), 1, delta=0.02)
        self.assertTrue((mesh.point_data["isovalue"] == 0).all())
        outwards = mesh.points - 10
        self.assertTrue((numpy.einsum("ij,ij->i", outwards, mesh.point_data["Normals"]) > 0).all())
        for ending in ("vtu", "vtk", "vtp", "ply", "stl", "obj", "glb"):
            path, told = self.made("isosurface", "ball", f"sphere.{ending}", "--error", 0, "--value", 0)
            self.judge_surface(path, told, len(mesh.points), area, volume, "isovalue", lambda found: numpy.zeros(len(found)))

    def test_arrays_keep_their_names(self):
        """Whoever writes what TAn reads, the array has its own name in what TAn writes, as far as the format bears it."""
        whole = meshio.read(self.folder / "part.vtu")
        pressure = whole.points[:, 0].astype("<f8")
        meshio.write(self.folder / "pressure.vtu", meshio.Mesh(whole.points, [("tetra", cells(whole, "tetra"))],
                                                               {"other": numpy.zeros(len(pressure)), "p (N/m^2)": pressure}))
        table = numpy.random.default_rng(7).random((60, 4))
        numpy.savetxt(self.folder / "table.csv", table, delimiter=",", header="x,y,z,T", comments="")
        for source, words, name in (("pressure.vtu", ["--array", "p (N/m^2)"], "p (N/m^2)"), ("table.csv", [], "T"), ("duct.xyz", [], "density"),
                                    ("c60.nrrd", [], "")):
            model = "named-" + source.split(".")[0]
            run(TAN, "build", source, *words, "-o", model + ".tan", folder=self.folder)
            self.assertEqual(json.loads(run(TAN, "info", model + ".tan", "--json", folder=self.folder)).get("array", ""), name)
            array = name or "value"
            for ending in ("vtu", "vtk"):
                path, _ = self.made("extract", model, f"{model}.{ending}", "--error", 0)
                self.assertEqual(self.by_vtk(path).GetPointData().GetScalars().GetName(), array)
                self.assertEqual(list(meshio.read(path).point_data), [array.replace(" ", "%20") if ending == "vtk" else array])
            path, _ = self.made("extract", model, f"{model}.ply", "--error", 0)
            self.assertIn(array.replace(" ", "_"), meshio.read(path).point_data)
            path, _ = self.made("extract", model, f"{model}.vtp", "--error", 0)
            self.assertEqual(self.by_vtk(path).GetPointData().GetScalars().GetName(), array)

    def shape_by_vtk(self, surface):
        """Open edges, their loops, edges of more than two triangles, and parts."""
        edges = dict(InputData=surface, FeatureEdges=False, ManifoldEdges=False)
        rims = run_filter(vtkFeatureEdges(), **edges, BoundaryEdges=True, NonManifoldEdges=False)
        crowded = run_filter(vtkFeatureEdges(), **edges, BoundaryEdges=False, NonManifoldEdges=True)

        def regions(of):
            made = vtkPolyDataConnectivityFilter()
            made.SetExtractionModeToAllRegions()
            run_filter(made, InputData=of)
            return made.GetNumberOfExtractedRegions() if of.GetNumberOfCells() > 0 else 0
        return rims.GetNumberOfCells(), regions(rims), crowded.GetNumberOfCells(), regions(surface)

    def test_solids(self):
        """What is told of openings, parts, area and volume is what VTK finds; closed solids are watertight for ADMesh."""
        volumes = {}
        for words in ([], ["--close", "above"], ["--close", "below"], ["--largest-part"], ["--close", "above", "--largest-part"]):
            path, told = self.made("isosurface", "cut", "solid.vtp", "--error", 1, "--value", 0, *words)
            surface = self.by_vtk(path)
            one, = told["surfaces"]
            with self.subTest(words=words):
                self.assertEqual((one["open_edges"], one["openings"], one["crowded_edges"], one["parts"]), self.shape_by_vtk(surface))
                self.assertEqual(one["parts"], 1 if "--largest-part" in words or "below" in words else 2)
                mass = vtkMassProperties()
                mass.SetInputData(surface)
                self.assertAlmostEqual(one["area"] / mass.GetSurfaceArea(), 1, delta=1e-5)
                if "--close" not in words:
                    self.assertGreater(one["openings"], 0)
                    self.assertNotIn("volume", one)
                    continue
                self.assertEqual(one["openings"], 0)
                self.assertAlmostEqual(one["volume"] / mass.GetVolume(), 1, delta=1e-3)
                volumes[" ".join(words)] = one["volume"]
                stl, again = self.made("isosurface", "cut", "solid.stl", "--error", 1, "--value", 0, *words)
                self.assertEqual(again["surfaces"][0]["volume"], one["volume"])
                said = run("admesh", stl)
                for what in ("Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed",
                             "Backwards edges", "Normals fixed"):
                    self.assertRegex(said, rf"{what}\s+:\s+0\b", words)
                self.assertRegex(said, rf"Number of parts\s+:\s+{one['parts']}\b")
                self.assertAlmostEqual(float(re.search(r"Volume\s+:\s+(\S+)", said)[1]) / one["volume"], 1, delta=1e-4)
                for ending in ("vtu", "vtk", "ply", "obj", "glb"):
                    path, told = self.made("isosurface", "cut", f"solid.{ending}", "--error", 1, "--value", 0, *words)
                    self.judge_surface(path, told, one["vertices"], one["area"], one["volume"], "isovalue", lambda found: numpy.zeros(len(found)))
        self.assertAlmostEqual((volumes["--close above"] + volumes["--close below"]) / 8000, 1, delta=1e-6)

    def test_deviation(self):
        """The stated distances from the surface of the finest mesh are those that VTK finds, both ways."""
        for words in ([], ["--close", "above", "--largest-part"]):
            path, told = self.made("isosurface", "cut", "coarse.vtp", "--error", 4, "--value", 0, "--deviation", *words)
            finest, _ = self.made("isosurface", "cut", "finest.vtp", "--error", 0, "--value", 0, *words)
            self.assertIn(b'Name="deviation"', path.read_bytes()[:4000])
            mine, theirs = self.by_vtk(path), self.by_vtk(finest)
            mine, theirs = in_pieces(mine, theirs), in_pieces(theirs, mine)
            judge = vtkHausdorffDistancePointSetFilter()
            judge.SetInputData(0, mine)
            judge.SetInputData(1, theirs)
            judge.SetTargetDistanceMethodToPointToCell()
            judge.Update()
            for number, (surface, key) in enumerate(((mine, "to_finest"), (theirs, "from_finest"))):
                found = told["surfaces"][0]["deviation"][key]
                distances = vtk_to_numpy(judge.GetOutput(number).GetPointData().GetArray("Distance"))
                points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
                areas = areas_around(points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))
                self.assertGreater(found["largest"], 0.01)
                self.assertAlmostEqual(found["largest"], judge.GetRelativeDistance()[number], delta=1e-5)
                self.assertAlmostEqual(found["mean"], (areas * distances).sum() / areas.sum(), delta=1e-5)


unittest.main()
