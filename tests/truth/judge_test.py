#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge of the bench of truth finds what is wrong: meshes that hold a lattice rightly pass, and each with one thing wrong does not.
Exit code 77: the libraries that judge are missing."""
import collections
import itertools
import sys
import types
import unittest

try:
    import numpy

    import bench
    from samples import FRAMES, grid, some_holes
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


def mesh_of(case):
    """What TAn would write: each cell without a hole cut into six tetrahedra, points without a cell left out."""
    whole = ~case.holes[case.cells].any(axis=1) if case.holes is not None else slice(None)
    tetrahedra = numpy.concatenate([case.cells[whole][:, corners] for corners in bench.CUT[8]])
    turned = bench.volumes_of(case.places, tetrahedra) < 0
    tetrahedra[turned] = tetrahedra[turned][:, (1, 0, 2, 3)]
    used, numbers = numpy.unique(tetrahedra, return_inverse=True)
    values = case.values[used].astype("f4")
    return types.SimpleNamespace(points=case.places[used].copy(), point_data={"value": values},
                                 cells=[types.SimpleNamespace(type="tetra", data=numbers.reshape(-1, 4))])


class Judge(unittest.TestCase):
    def setUp(self):
        self.case = bench.of_grid("lattice", grid("oblique", "<f8"))
        self.mesh = mesh_of(self.case)

    def assert_found(self, pattern):
        self.assertRaisesRegex(bench.Wrong, pattern, bench.compare, self.case, self.mesh)

    def test_what_is_right_passes(self):
        for frame in FRAMES:
            for dtype in ("u1", "<i2", "<i4", "<f4", "<f8"):
                for holes in (None, some_holes()):
                    case = bench.of_grid("lattice", grid(frame, dtype), holes=holes)
                    bench.compare(case, mesh_of(case))

    def test_places(self):
        self.mesh.points[:, 0] *= -1
        self.assert_found("no sample lies at")
        self.mesh = mesh_of(self.case)
        self.mesh.points += 1e-3
        self.assert_found("no sample lies at")
        self.mesh = mesh_of(self.case)
        self.mesh.points = self.mesh.points.astype("f4").astype(float)
        self.assert_found("single precision")

    def test_samples_mirrored_within_the_same_box(self):
        mirrored = grid("oblique", "<f8")
        mirrored.values = mirrored.values[::-1]
        self.mesh = mesh_of(bench.of_grid("lattice", mirrored))
        self.assert_found("of 210 values")

    def test_a_value(self):
        self.mesh.point_data["value"][17] *= 1 + 2.0 ** -20
        self.assert_found("1 of 210 values")

    def test_values_of_another_type(self):
        self.mesh.point_data["value"] = numpy.rint(self.mesh.point_data["value"])
        self.assert_found("values")

    def test_a_hole_that_is_filled(self):
        self.case.holes = some_holes().ravel()
        self.assert_found("without a value are in the mesh")

    def test_samples_that_are_lost(self):
        for some in (1, 60):
            kept = numpy.ones(len(self.mesh.points), bool)
            kept[numpy.arange(some) * 3] = False
            tetrahedra = self.mesh.cells[0].data
            part = types.SimpleNamespace(points=self.mesh.points[kept], point_data={"value": self.mesh.point_data["value"][kept]},
                                         cells=[types.SimpleNamespace(type="tetra", data=(numpy.cumsum(kept) - 1)[tetrahedra[kept[tetrahedra].all(axis=1)]])])
            self.assertRaisesRegex(bench.Wrong, "fills", bench.compare, self.case, part)
            self.case.volume = None
            self.assertRaisesRegex(bench.Wrong, "not in the mesh", bench.compare, self.case, part)
            self.case.volume = mesh_volume(self.mesh)

    def test_tetrahedra(self):
        self.mesh.cells[0].data[3] = self.mesh.cells[0].data[3][[1, 0, 2, 3]]
        self.assert_found("turned over")

    def test_tetrahedra_flatter_than_the_rounding_of_their_volume(self):
        """Between the points of a plane that is oblique, and thus a plane but for the rounding of its points. The signs that count: integers'."""
        turn = numpy.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
        points = numpy.concatenate([numpy.indices((4, 4)).reshape(2, -1).T @ turn[:2], [[0, 0, 3.0]]])
        signs = collections.Counter()
        for corners in itertools.combinations(range(16), 4):
            tetrahedron = numpy.array([corners])
            a, b, c, d = ([int(number * 2.0 ** 80) for number in points[corner]] for corner in corners)
            b, c, d = ([corner[axis] - a[axis] for axis in range(3)] for corner in (b, c, d))
            exact = (b[0] * (c[1] * d[2] - c[2] * d[1]) + b[1] * (c[2] * d[0] - c[0] * d[2]) + b[2] * (c[0] * d[1] - c[1] * d[0]))
            volumes = bench.volumes_of(points, tetrahedron)
            self.assertEqual(bench.flat_or_turned(points, tetrahedron, volumes), int(exact <= 0))
            signs[exact > 0, volumes[0] > 0] += 1
        self.assertEqual(len(signs), 4)  # without fractions each kind of mistake is made

    def test_a_sample_twice(self):
        self.mesh.points[5] = self.mesh.points[6]
        self.assert_found("more than one vertex|values")

    def test_a_name(self):
        self.case.name = "density"
        self.assert_found("are called")

    def test_what_is_told(self):
        told = {"taken": {"array": "temperature", "step": "1 of 3, time 0"}, "guesses": ["step"], "unused": ["It holds 3 volumes."]}
        self.case.taken, self.case.guessed, self.case.left_out = {"array": "^temp", "step": "1 of 3"}, ("step",), ("volumes",)
        self.assertEqual(bench.untold(self.case, told), "")
        for change in ({"taken": {"array": "temperature"}}, {"taken": {"array": "pressure", "step": "1 of 3"}}, {"guesses": []}, {"unused": []}):
            self.assertNotEqual(bench.untold(self.case, told | change), "")


def mesh_volume(mesh):
    return bench.volumes_of(mesh.points, mesh.cells[0].data).sum()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
