#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""deviations.py BUILD: isovalues in standard deviations above the mean (R19), judged by numpy: of a density map by all its samples, of other
data by a quadrature over the mesh that TAn writes, which meshio reads; and by gemmi, where it is there. Exit code 77: something is missing."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import meshio
    import numpy
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
TAN = BUILD / "bin/tan"
SHAPE = (14, 17, 20)


def tan(folder, *words, code=0):
    done = subprocess.run([str(TAN), *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == code, f"{words}: {done.returncode} {done.stdout}{done.stderr}"
    return done.stdout + done.stderr if code else done.stdout


def figures(folder, *words):
    return json.loads(tan(folder, *words, "--json"))


def density():
    """Two blobs on noise, far from the mean zero: x is the first index."""
    places = numpy.stack(numpy.meshgrid(*(numpy.linspace(-1, 1, count) for count in SHAPE), indexing="ij"), axis=-1)
    blobs = sum(numpy.exp(-8 * ((places - centre) ** 2).sum(axis=-1)) for centre in ((0.3, 0.1, 0), (-0.4, -0.2, 0.3)))
    return (40 + blobs + 0.02 * numpy.random.default_rng(1).standard_normal(SHAPE)).astype("<f4")


def write_map(file, values):
    """A map of mode 2, byte by byte; what its header tells of the values is wrong on purpose."""
    head = numpy.zeros(256, "<i4")
    reals = head.view("<f4")
    head[:3], head[3], head[7:10] = values.shape, 2, values.shape
    reals[10:13], reals[13:16], head[16:19] = numpy.array(values.shape) * 1.5, 90, (1, 2, 3)
    reals[19:22], reals[54] = (values.min(), values.max(), 7), 3
    head[22], head[27] = 1, 20140
    raw = bytearray(head.tobytes())
    raw[208:216] = b"MAP DD\0\0"
    file.write_bytes(bytes(raw) + values.tobytes(order="F"))


def write_nrrd(file, values):
    sizes = " ".join(map(str, values.shape))
    head = f"NRRD0004\ntype: float\ndimension: 3\nsizes: {sizes}\nspacings: 1.5 1.5 1.5\nencoding: raw\nendian: little\n\n"
    file.write_bytes(head.encode() + values.tobytes(order="F"))


def over_the_volume(file):
    """Mean and deviation by the rule of four points in each tetrahedron, which is exact for squares of linear functions."""
    mesh = meshio.read(file)
    corners = mesh.points[mesh.cells_dict["tetra"]]
    values = next(iter(mesh.point_data.values())).ravel().astype(float)[mesh.cells_dict["tetra"]]
    volumes = numpy.abs(numpy.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    near, far = 0.5854101966249685, 0.1381966011250105
    at_points = values @ (numpy.full((4, 4), far) + (near - far) * numpy.eye(4))
    weights = numpy.repeat(volumes[:, None] / 4, 4, axis=1)
    mean = (weights * at_points).sum() / volumes.sum()
    return mean, numpy.sqrt((weights * (at_points - mean) ** 2).sum() / volumes.sum())


class Deviations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        cls.values = density()
        write_map(cls.folder / "blobs.map", cls.values)
        write_nrrd(cls.folder / "blobs.nrrd", cls.values)
        tan(cls.folder, "build", "blobs.map", "-o", "map.tan")
        tan(cls.folder, "build", "blobs.nrrd", "-o", "other.tan")
        exact = cls.values.astype(float)
        cls.mean, cls.deviation = exact.mean(), exact.std()

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def test_maps_tell_mean_and_deviation_of_all_samples(self):
        for told in (figures(self.folder, "info", "map.tan"), figures(self.folder, "info", "blobs.map")):
            numpy.testing.assert_allclose([told["mean"], told["standard_deviation"]], [self.mean, self.deviation], rtol=1e-12)
        self.assertIn("both of all samples", tan(self.folder, "info", "map.tan"))
        self.assertNotIn("mean", figures(self.folder, "info", "other.tan"))
        self.assertNotIn("values.mean", tan(self.folder, "info", "map.tan"))

    def test_gemmi_tells_the_same(self):
        try:
            import gemmi
        except ImportError as missing:
            self.skipTest(str(missing))
        read = gemmi.read_ccp4_map(str(self.folder / "blobs.map"))
        read.update_ccp4_header()
        told = figures(self.folder, "info", "map.tan")
        numpy.testing.assert_allclose([told["mean"], told["standard_deviation"]], [read.header_float(22), read.header_float(55)], rtol=1e-5)

    def test_a_part_has_its_own(self):
        tan(self.folder, "build", "blobs.map", "--region", "2,3,4,11,13,15", "-o", "part.tan")
        part = self.values[2:12, 3:14, 4:16].astype(float)
        told = figures(self.folder, "info", "part.tan")
        numpy.testing.assert_allclose([told["mean"], told["standard_deviation"]], [part.mean(), part.std()], rtol=1e-12)

    def test_packed_models_keep_them(self):
        tan(self.folder, "pack", "map.tan", "-o", "packed.tan")
        told = figures(self.folder, "info", "packed.tan")
        numpy.testing.assert_allclose([told["mean"], told["standard_deviation"]], [self.mean, self.deviation], rtol=1e-12)
        made = figures(self.folder, "isosurface", "packed.tan", "--value", "2sd", "-o", "s.vtp")
        numpy.testing.assert_allclose(made["surfaces"][0]["value"], self.mean + 2 * self.deviation, rtol=1e-12)

    def test_surfaces_lie_at_so_many_deviations(self):
        made = figures(self.folder, "isosurface", "map.tan", "--error", "0", "--value", "1.5sd,40.3,3sd", "-o", "s.vtp")
        expected = [self.mean + 1.5 * self.deviation, 40.3, self.mean + 3 * self.deviation]
        numpy.testing.assert_allclose([surface["value"] for surface in made["surfaces"]], expected, rtol=1e-12)
        self.assertTrue(all(surface["triangles"] > 0 for surface in made["surfaces"]))
        told = [text for text in made["remarks"] if text.startswith(("1.5sd is", "3sd is"))]
        self.assertEqual(len(told), 2)
        self.assertTrue(all("of all samples" in text for text in told), told)
        same = figures(self.folder, "isosurface", "map.tan", "--error", "0", "--value", repr(expected[2]), "-o", "same.vtp")
        self.assertEqual(made["surfaces"][2]["triangles"], same["triangles"])
        below = figures(self.folder, "isosurface", "map.tan", "--error", "0", "--value=-0.25sd", "-o", "s.vtp")
        numpy.testing.assert_allclose(below["surfaces"][0]["value"], self.mean - 0.25 * self.deviation, rtol=1e-12)

    def test_fields_around_the_isovalues_follow_them(self):
        field = ("--field", "isovalues(;0.2,30,0.05)", "-o", "s.vtp")
        value = repr(self.mean + 3 * self.deviation)
        typed, same, other = (figures(self.folder, "isosurface", "map.tan", "--value", at, *field) for at in ("3sd", value, "40"))
        self.assertEqual(typed["tetrahedra"], same["tetrahedra"])
        self.assertNotEqual(typed["tetrahedra"], other["tetrahedra"])

    def test_pictures_are_those_of_the_value(self):
        size = ("--size", "80x60", "-o")
        value = repr(self.mean + 2 * self.deviation)
        drawn = figures(self.folder, "render", "map.tan", "--isovalue", "2sd:gold:0.5", "--isovalue", "40.4", *size, "typed.png")
        tan(self.folder, "render", "map.tan", "--isovalue", f"{value}:gold:0.5", "--isovalue", "40.4", *size, "same.png")
        tan(self.folder, "render", "map.tan", "--isovalue", "3sd:gold:0.5", "--isovalue", "40.4", *size, "other.png")
        typed, same, other = ((self.folder / name).read_bytes() for name in ("typed.png", "same.png", "other.png"))
        self.assertEqual(typed, same)
        self.assertNotEqual(typed, other)
        self.assertTrue(any(text.startswith("2sd is") for text in drawn["remarks"]), drawn["remarks"])

    def test_other_data_have_those_of_the_finest_mesh(self):
        tan(self.folder, "extract", "other.tan", "--error", "0", "-o", "finest.vtu")
        mean, deviation = over_the_volume(self.folder / "finest.vtu")
        self.assertGreater(abs(deviation - self.deviation), 1e-4 * deviation)  # so that it is seen which is which
        made = figures(self.folder, "isosurface", "other.tan", "--value", "2sd", "-o", "s.vtp")
        numpy.testing.assert_allclose(made["surfaces"][0]["value"], mean + 2 * deviation, rtol=1e-7)
        self.assertTrue(any("over the volume of the finest mesh" in text for text in made["remarks"]), made["remarks"])

    def test_what_is_none_is_refused(self):
        for wrong in ("sd", "xsd", "2.5sds", "nansd", "infsd", "2.5 σ"):
            tan(self.folder, "isosurface", "map.tan", "--value", wrong, "-o", "s.vtp", code=2)
            tan(self.folder, "render", "map.tan", "--isovalue", wrong, "-o", "s.png", code=2)

    def test_a_map_of_one_value_has_none(self):
        flat = numpy.full((5, 5, 5), 3, "<f4")
        flat[2, 2, 2] = 4
        write_map(self.folder / "flat.map", flat)
        told = figures(self.folder, "info", "flat.map")
        numpy.testing.assert_allclose([told["mean"], told["standard_deviation"]], [flat.mean(dtype=float), flat.std(dtype=float)], rtol=1e-12)


unittest.main()
