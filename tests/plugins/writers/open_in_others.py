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
import subprocess
import sys
import tempfile
import unittest

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
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


def run(*words, folder=None):
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return done.stdout


def write_ball(path):
    """How far inside of a ball a point of a lattice lies."""
    axis = numpy.arange(21) - 10.0
    depth = RADIUS - numpy.sqrt(axis[:, None, None] ** 2 + axis[None, :, None] ** 2 + axis[None, None, :] ** 2).astype("<f4")
    head = "NRRD0004\ntype: float\ndimension: 3\nsizes: 21 21 21\nencoding: raw\nendian: little\nspacings: 1 1 1\n\n"
    path.write_bytes(head.encode() + depth.tobytes())


def volumes(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, corner]] for corner in range(4))
    return numpy.einsum("ij,ij->i", b - a, numpy.cross(c - a, d - a)) / 6


def area_and_volume(points, triangles):
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2, numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def cells(mesh, kind):
    return numpy.concatenate([block.data for block in mesh.cells if block.type == kind]).astype(int)


class Others(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        write_ball(cls.folder / "ball.nrrd")
        for name, words in (("c60.nrrd", ("c60", "--size", 15)), ("part.vtu", ("part", "--size", 10)), ("duct.xyz", ("bent-duct", "--size", 9)),
                            ("points.csv", ("scattered", "--size", 8))):
            run(TAN, "sample", *words, "-o", name, folder=cls.folder)
        for name in ("ball.nrrd", "c60.nrrd", "part.vtu", "duct.xyz", "points.csv"):
            run(TAN, "build", name, "-o", pathlib.Path(name).stem + ".tan", folder=cls.folder)

    def made(self, command, model, name, *words):
        told = json.loads(run(TAN, command, model + ".tan", *words, "-o", name, "--json", folder=self.folder))
        return self.folder / name, told

    def by_gmsh(self, path):
        """The file as gmsh understands it."""
        out = path.with_suffix(path.suffix + ".msh")
        said = run("gmsh", path, "-save", "-format", "msh2", "-o", out)
        self.assertNotRegex(said, "(?i)error|warning")
        return meshio.read(out)

    def by_vtk(self, path):
        reader = {".vtu": vtkXMLUnstructuredGridReader, ".vtp": vtkXMLPolyDataReader, ".vtk": vtkGenericDataObjectReader}[path.suffix]()
        reader.SetFileName(str(path))
        reader.Update()
        self.assertEqual(reader.GetErrorCode(), 0)
        return reader.GetOutput()

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
                values = mine.point_data["value"].ravel()
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

    def judge_surface(self, path, told, vertices, area, volume):
        """That a file has these triangles: closed, outwards, of this area and this volume within."""
        ending = path.suffix
        if ending in (".vtu", ".ply", ".stl", ".obj"):
            mesh = meshio.read(path)
            found = area_and_volume(mesh.points.astype(float), cells(mesh, "triangle"))
            self.assertEqual(len(cells(mesh, "triangle")), told["triangles"], path)
            if ending != ".stl":
                self.assertEqual(len(mesh.points), vertices, path)
            self.assertAlmostEqual(found[0] / area, 1, delta=1e-5, msg=path)
            self.assertAlmostEqual(found[1] / volume, 1, delta=1e-5, msg=path)
        if ending in (".vtp", ".vtk"):
            self.assertEqual(self.by_vtk(path).GetNumberOfPolys(), told["triangles"], path)
        if ending in (".ply", ".stl", ".obj", ".glb"):
            self.assertIn(str(told["triangles"]), re.search(r"Faces:\s+(\d+)", run("assimp", "info", path))[1], path)
        if ending == ".stl":
            said = run("admesh", path)
            for what in ("Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges", "Normals fixed"):
                self.assertRegex(said, rf"{what}\s+:\s+0\b", path)
            self.assertAlmostEqual(float(re.search(r"Volume\s+:\s+(\S+)", said)[1]) / volume, 1, delta=1e-4)
            self.assertEqual(self.by_gmsh(path).points.shape[1], 3)

    def test_boundaries(self):
        for model, volume, area in (("c60", 14.0 ** 3, 6 * 14.0 ** 2), ("ball", 20.0 ** 3, 6 * 20.0 ** 2)):
            path, mesh = self.made("extract", model, "whole.vtu", "--error", 3)
            points, tetrahedra = (lambda read: (read.points.astype(float), cells(read, "tetra")))(meshio.read(path))
            faces = numpy.sort(numpy.concatenate([numpy.delete(tetrahedra, corner, axis=1) for corner in range(4)]), axis=1)
            faces, times = numpy.unique(faces, axis=0, return_counts=True)
            told = {**mesh, "triangles": int((times == 1).sum())}
            vertices = len(numpy.unique(faces[times == 1]))
            self.assertGreater(len(points), vertices)
            for ending in ("vtp", "ply", "stl", "obj", "glb"):
                self.judge_surface(self.made("extract", model, f"boundary.{ending}", "--error", 3)[0], told, vertices, area, volume)

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
            self.judge_surface(path, told, len(mesh.points), area, volume)


unittest.main()
