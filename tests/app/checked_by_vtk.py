#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""checked_by_vtk.py BUILD SOURCE: the script of docs/user/accuracy.md by which readers check a mesh with VTK finds what TAn says, of a boundary layer
over a wavy wall (R1, C12), also of a mesh with flat tetrahedra. Exit code 77: something is missing."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
    from vtkmodules.vtkIOXML import vtkXMLStructuredGridWriter
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TAN, SOURCE = pathlib.Path(sys.argv[1]).resolve() / "bin/tan", pathlib.Path(sys.argv[2]).resolve()
del sys.argv[1:]


def tan(*words):
    done = subprocess.run([str(TAN), *map(str, words), "--json"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return json.loads(done.stdout)


def write_boundary_layer(path, size):
    """Stretched towards a wall that is a wave; u rises within the layer."""
    i, j, k = (axis.ravel(order="F") for axis in numpy.meshgrid(*(numpy.linspace(0, 1, n) for n in size), indexing="ij"))
    wall = 0.1 * numpy.sin(2 * numpy.pi * i) * numpy.cos(numpy.pi * k)
    height = (numpy.exp(5 * j) - 1) / (numpy.exp(5) - 1)
    places = numpy.stack([2 * i, wall + height * (1 - wall), k], axis=1)
    u = numpy.tanh(height / (0.02 + 0.05 * i)) * (1 + 0.2 * numpy.sin(3 * k))
    grid, points = vtkStructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    values = numpy_to_vtk(u, deep=True)
    values.SetName("u")
    grid.SetDimensions(size)
    grid.SetPoints(points)
    grid.GetPointData().AddArray(values)
    writer = vtkXMLStructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    assert writer.Write() == 1


def documented_script(folder):
    script = re.search(r"## Check it with VTK.*?```python\n(.*?)```", (SOURCE / "docs/user/accuracy.md").read_text(), re.DOTALL).group(1)
    (folder / "check_error.py").write_text(script)
    return folder / "check_error.py"


def printed_by(script, *words):
    """The largest error, how many points are outside, and the largest error there."""
    printed = subprocess.run(["/usr/bin/python3", script, *words], capture_output=True, text=True, check=True)
    return map(float, re.search(r"error ([\d.e-]+) %\nof (\d+) .* place ([\d.e-]+) %", printed.stdout).groups())


class CheckedByVtk(unittest.TestCase):
    def test_the_documented_script_finds_what_is_told(self):
        with tempfile.TemporaryDirectory() as kept:
            folder = pathlib.Path(kept)
            data, model, mesh = folder / "layer.vts", folder / "layer.tan", folder / "mesh.vtu"
            write_boundary_layer(data, (24, 20, 8))
            tan("build", data, "-o", model)
            asked = 2.0
            found = tan("extract", model, "--error", asked, "-o", mesh)
            self.assertLess(found["sites"], 24 * 20 * 8 / 2)
            self.assertTrue(any("outside the mesh" in text for text in found["remarks"]), found["remarks"])
            measured = tan("extract", model, "--error", asked, "--against", data, "-o", mesh)
            self.assertFalse(any("outside the mesh" in text for text in measured.get("remarks", [])), measured)
            inside, number, nearest = printed_by(documented_script(folder), data, mesh, "u")
            self.assertLessEqual(inside, asked)
            self.assertGreater(inside, asked / 4)
            self.assertGreater(number, 0)
            self.assertAlmostEqual(max(inside, nearest), measured["error_at_nearest"]["largest"], delta=2e-3)

    def test_it_finds_the_right_ones_among_flat_tetrahedra(self):
        with tempfile.TemporaryDirectory() as kept:
            folder = pathlib.Path(kept)
            grid, model, mesh = folder / "body.xyz", folder / "body.tan", folder / "mesh.vtu"
            tan("sample", "blunt-body", "--size", 20, "-o", grid)
            tan("build", grid, "--array", "density", "--builder", "refinement", "--error-in", "grid", "-o", model)
            measured = tan("extract", model, "--error", 1, "--against", grid, "-o", mesh)
            inside, number, nearest = printed_by(documented_script(folder), grid, folder / "body.q", mesh, "density")
            self.assertGreater(inside, 2)
            self.assertAlmostEqual(max(inside, nearest), measured["error_in_space"]["largest"], delta=2e-3)

    def test_a_model_that_has_nothing_finer_says_so(self):
        with tempfile.TemporaryDirectory() as kept:
            folder = pathlib.Path(kept)
            data, model = folder / "layer.vts", folder / "layer.tan"
            write_boundary_layer(data, (12, 10, 6))
            tan("build", data, "--finest", 2, "-o", model)
            for error, is_told in ((0.5, True), (4, False)):
                remarks = tan("extract", model, "--error", error, "-o", folder / "mesh.vtu").get("remarks", [])
                self.assertEqual(any("no finer mesh" in text for text in remarks), is_told, (error, remarks))


unittest.main()
