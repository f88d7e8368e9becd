#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""logarithms.py BUILD: models of logarithms (--scale log), judged by numpy and by VTK and meshio reading what TAn writes: the bound on the
error is a factor at every sample, files have the logarithms and the values beside them, and what is not positive is told. Exit code 77:
something is missing."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersCore import vtkProbeFilter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
TAN = BUILD / "bin/tan"
SIZE = 14
SMALLEST = 1e-9


def tan(folder, *words, code=0):
    done = subprocess.run([str(TAN), *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == code, f"{words}: {done.returncode} {done.stdout}{done.stderr}"
    return done.stdout + done.stderr if code else done.stdout


def figures(folder, *words):
    return json.loads(tan(folder, *words, "--json"))


class Logarithms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        x = numpy.linspace(-1, 1, SIZE)
        cls.places = numpy.stack([axis.ravel(order="F") for axis in numpy.meshgrid(x, x, x, indexing="ij")], axis=1)
        cls.values = 10 ** (4 - 5 * numpy.linalg.norm(cls.places, axis=1) ** 2)
        table = "x,y,z,nut\n" + "".join(f"{a!r},{b!r},{c!r},{v!r}\n" for a, b, c, v in numpy.c_[cls.places, cls.values].tolist())
        (cls.folder / "nut.csv").write_text(table)
        cls.zeros = cls.values.copy()
        cls.zeros[cls.values < 1e-8] = 0
        cls.zeros[5] = -3
        head = (f"NRRD0004\ntype: double\ndimension: 3\nsizes: {SIZE} {SIZE} {SIZE}\nspacings: {x[1] - x[0]!r} {x[1] - x[0]!r} {x[1] - x[0]!r}\n"
                "encoding: raw\nendian: little\n\n")
        (cls.folder / "zeros.nrrd").write_bytes(head.encode() + cls.zeros.astype("<f8").tobytes())
        tan(cls.folder, "build", "nut.csv", "--scale", "log", "-o", "nut.tan")

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def probed(self, mesh, array):
        """The mesh's values at the samples, as VTK interpolates them, and where it has any."""
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.folder / mesh))
        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.places, deep=True))
        samples = vtkPolyData()
        samples.SetPoints(points)
        probe = vtkProbeFilter()
        probe.SetInputData(samples)
        probe.SetSourceConnection(reader.GetOutputPort())
        probe.Update()
        data = probe.GetOutput().GetPointData()
        return vtk_to_numpy(data.GetArray(array)), vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())) > 0

    def test_the_model_says_what_it_holds(self):
        found = figures(self.folder, "info", "nut.tan", "--lod", "2")
        self.assertEqual((found["array"], found["scale"]), ("log10(nut)", "log10"))
        logarithms = numpy.log10(self.values)
        numpy.testing.assert_allclose(found["range"], [logarithms.min(), logarithms.max()], rtol=1e-6)
        level = found["levels"][0]
        numpy.testing.assert_allclose(level["reached_factor"], 10 ** (level["reached"] / 100 * numpy.ptp(logarithms)), rtol=1e-5)
        text = tan(self.folder, "info", "nut.tan", "--lod", "2")
        self.assertIn("logarithms to base 10", text)
        self.assertIn("a factor of", text)

    def test_the_error_is_a_factor_at_every_sample(self):
        found = figures(self.folder, "extract", "nut.tan", "--error", "3", "-o", "coarse.vtu")
        self.assertLess(found["sites"], len(self.values) / 2)
        self.assertTrue(any("interpolate 'log10(nut)'" in text for text in found["remarks"]), found["remarks"])
        interpolated, inside = self.probed("coarse.vtu", "log10(nut)")
        self.assertGreater(inside.sum(), 0.8 * len(inside))
        of_surface = figures(self.folder, "extract", "nut.tan", "--error", "3", "-o", "coarse.stl").get("remarks", [])
        self.assertFalse(any("interpolate" in text for text in of_surface), of_surface)  # it has no arrays
        factors = 10 ** numpy.abs(interpolated - numpy.log10(self.values))[inside]
        self.assertLessEqual(factors.max(), found["reached_factor"] * (1 + 1e-4))
        self.assertGreater(factors.max(), 1.001)
        self.assertTrue(figures(self.folder, "verify", "nut.tan", "--against", "nut.csv", "--lod", "3,0")["ok"])
        told = figures(self.folder, "info", "nut.tan", "--against", "nut.csv", "--lod", "3")["levels"][0]
        self.assertIn("error_statistics", told)

    def test_files_have_the_values_beside_the_logarithms(self):
        for name in ("fine.vtu", "fine.vtk"):
            tan(self.folder, "extract", "nut.tan", "--error", "0", "-o", name)
            mesh = meshio.read(self.folder / name)
            self.assertEqual(set(mesh.point_data), {"log10(nut)", "nut"})
            logarithms, values = mesh.point_data["log10(nut)"].ravel(), mesh.point_data["nut"].ravel()
            numpy.testing.assert_allclose(values, 10.0 ** logarithms.astype(float), rtol=1e-6)
            places = {tuple(numpy.round(place, 6)): value for place, value in zip(self.places, self.values)}
            expected = numpy.array([places[tuple(numpy.round(place, 6))] for place in mesh.points])
            numpy.testing.assert_allclose(logarithms, numpy.log10(expected), rtol=0, atol=2e-6)

    def test_what_is_not_positive_is_counted_or_taken_as_the_smallest(self):
        smallest = self.zeros[self.zeros > 0].min()
        below = int((self.zeros <= 0).sum())
        told = tan(self.folder, "build", "zeros.nrrd", "--scale", "log", "-o", "refused.tan", code=2)
        self.assertIn(f"{below} of {SIZE ** 3} values are not positive", told)
        self.assertIn(f"log:{float(smallest)!r}"[:10], told)
        self.assertFalse((self.folder / "refused.tan").exists())
        told = tan(self.folder, "build", "zeros.nrrd", "--scale", f"log:{SMALLEST}", "-o", "zeros.tan")
        self.assertIn(f"{int((self.zeros < SMALLEST).sum())} of {SIZE ** 3} values", told)
        found = figures(self.folder, "info", "zeros.tan")
        self.assertTrue(any("were replaced by 1e-09" in text for text in found["unused"]), found["unused"])
        numpy.testing.assert_allclose(found["range"][0], numpy.log10(SMALLEST), rtol=1e-6)
        self.assertTrue(figures(self.folder, "verify", "zeros.tan", "--against", "zeros.nrrd", "--lod", "1,0")["ok"])
        self.assertIn("NOT", tan(self.folder, "verify", "zeros.tan", "--against", "zeros.nrrd", "--scale", "linear", code=1))
        for wrong in ("log:0", "log:x", "cubic"):
            tan(self.folder, "build", "zeros.nrrd", "--scale", wrong, "-o", "refused.tan", code=2)

    def test_packed_models_hold_logarithms_too(self):
        tan(self.folder, "pack", "nut.tan", "-o", "packed.tan")
        found = figures(self.folder, "info", "packed.tan", "--lod", "2")
        self.assertEqual((found["array"], found["scale"]), ("log10(nut)", "log10"))
        self.assertGreater(found["levels"][0]["reached_factor"], 1)
        tan(self.folder, "extract", "packed.tan", "--error", "2", "-o", "packed.vtu")
        self.assertEqual(set(meshio.read(self.folder / "packed.vtu").point_data), {"log10(nut)", "nut"})

    def test_isovalues_are_logarithms_or_typed_as_such_of_values(self):
        typed = figures(self.folder, "isosurface", "nut.tan", "--value", "log10(1e-3)", "-o", "typed.vtp")
        numpy.testing.assert_allclose(typed["surfaces"][0]["value"], -3, atol=1e-12)
        numpy.testing.assert_allclose(typed["surfaces"][0]["value_in_data"], 1e-3, rtol=1e-9)
        self.assertEqual(figures(self.folder, "isosurface", "nut.tan", "--value=-3", "-o", "typed.vtp")["triangles"], typed["triangles"])
        self.assertGreater(typed["triangles"], 0)
        tan(self.folder, "render", "nut.tan", "--isovalue", "log10(1e-3)", "--size", "40x30", "-o", "typed.png")
        tan(self.folder, "isosurface", "nut.tan", "--value", "log10(0)", "-o", "typed.vtp", code=2)

    def test_values_of_queries_are_logarithms_or_typed_as_such_of_values(self):
        for typed, same in ((("--values", "log10(1e-3),log10(100)"), ("--values=-3,2",)),
                            (("--field", "isovalues(log10(1e-3); 1, 8, 0.5)"), ("--field", "isovalues(-3; 1, 8, 0.5)")),
                            (("--field", "values(log10(1e-3):1, log10(100):8)"), ("--field", "values(-3:1, 2:8)"))):
            found = [figures(self.folder, "extract", "nut.tan", *words, "-o", "part.vtu")["tetrahedra"] for words in (typed, same)]
            self.assertEqual(*found, typed)
            self.assertGreater(found[0], 0)
        whole = figures(self.folder, "extract", "nut.tan", "--error", "1", "-o", "part.vtu")["tetrahedra"]
        part = figures(self.folder, "extract", "nut.tan", "--error", "1", "--values", "log10(1e-3),log10(1e-2)", "-o", "part.vtu")
        self.assertLess(part["tetrahedra"], whole)
        for wrong in (("--values", "log10(0),1"), ("--field", "values(log10(-1):1)")):
            tan(self.folder, "extract", "nut.tan", *wrong, "-o", "part.vtu", code=2)

    def test_values_of_weights_and_bars_are_typed_in_the_same_way(self):
        for name, value in (("typed.tan", "log10(1e-3)"), ("same.tan", "-3")):
            tan(self.folder, "build", "nut.csv", "--scale", "log", "--weight", f"value:{value},1", "-o", name)
        levels = [figures(self.folder, "info", name, "--lod", "2")["levels"] for name in ("typed.tan", "same.tan", "nut.tan")]
        self.assertEqual(levels[0], levels[1])
        self.assertNotEqual(levels[0], levels[2])
        for name, ends in (("typed.png", "log10(1e-3):log10(100)"), ("same.png", "-3:2")):
            tan(self.folder, "render", "nut.tan", "--mode", "volume", "--colour-bar", f"--bar-range={ends}", "--size", "160x120", "-o", name)
        self.assertEqual(*((self.folder / name).read_bytes() for name in ("typed.png", "same.png")))


unittest.main()
