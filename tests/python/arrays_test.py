#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""arrays_test.py FOLDER: models of arrays: the order of axes, memory, types, frames, holes, grids, points and cells, judged by fields that
are linear, of which every mesh must be exact, and by VTK."""
import unittest

from module import ModuleTest, lattice, np, placed, tan, volumes

try:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
except ImportError:
    vtkImageData = None


class Arrays(ModuleTest):
    def built(self, source, **keywords):
        return tan.build(source, self.folder / "a.tan", **keywords)

    def exact(self, model, field):
        """Each vertex has the value of the field at its place."""
        mesh = model.mesh(error=0)
        np.testing.assert_allclose(mesh.values, field(*mesh.points.T), rtol=1e-5, atol=1e-5)
        return mesh

    def bumps(self, shape):
        return np.random.default_rng(7).random(shape)

    def test_the_axes_are_z_y_x(self):
        values = self.bumps((4, 5, 6))
        m = self.built(values, spacing=(1, 10, 100), origin=(0.5, 0, 0))
        self.assertEqual(m.shape, (4, 5, 6))
        np.testing.assert_allclose(m.bounds, [[0.5, 0, 0], [5.5, 40, 300]])
        mesh = m.mesh(error=0)
        i, j, k = np.round((mesh.points - [0.5, 0, 0]) / [1, 10, 100]).astype(int).T
        np.testing.assert_allclose(mesh.values, values[k, j, i], rtol=1e-6)

    def test_memory_does_not_matter(self):
        values = self.bumps((5, 6, 7)).astype("f4")
        wanted = self.built(values).mesh(error=0)
        wide = np.zeros((10, 6, 14), "f4")
        wide[::2, :, ::2] = values
        for other in (np.asfortranarray(values), wide[::2, :, ::2], values[::-1][::-1], values.astype(">f4"), values.tolist(),
                      np.ma.MaskedArray(values)):
            mesh = self.built(other).mesh(error=0)
            np.testing.assert_allclose(mesh.values, wanted.values, rtol=1e-6)
            np.testing.assert_array_equal(mesh.points, wanted.points)
        turned = self.built(np.asfortranarray(values.T), axes="xyz").mesh(error=0)
        np.testing.assert_array_equal(turned.values, wanted.values)
        np.testing.assert_array_equal(turned.points, wanted.points)

    def test_vtk_has_the_same_places(self):
        if vtkImageData is None:
            self.skipTest("no VTK")
        values = self.bumps((4, 5, 6))
        image = vtkImageData()
        image.SetDimensions(6, 5, 4)
        image.SetSpacing(1, 2, 3)
        image.SetOrigin(10, 20, 30)
        image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=1))
        mesh = self.built(values, spacing=(1, 2, 3), origin=(10, 20, 30)).mesh(error=0)
        for place, value in zip(mesh.points[::7], mesh.values[::7]):
            point = image.FindPoint(place)
            np.testing.assert_allclose(image.GetPoint(point), place)
            self.assertAlmostEqual(image.GetPointData().GetScalars().GetValue(point), value, places=6)

    def test_types(self):
        ramp = np.arange(60).reshape(3, 4, 5) % 7
        for kind in ("u1", "i1", "u2", "i2", "u4", "i4", "f4", "f8"):
            self.assertEqual(self.built(ramp.astype(kind)).dtype, np.dtype(kind))
        self.assertEqual(self.built(ramp > 3).dtype, np.dtype("u1"))
        self.assertEqual(self.built(ramp.astype("f2")).dtype, np.dtype("f4"))
        self.assertEqual(self.built(ramp.astype("i8")).dtype, np.dtype("i4"))
        self.assertEqual(self.built(ramp.astype("u8") + 2**31).dtype, np.dtype("u4"))
        self.assertEqual(self.built(ramp.astype("i8") + 2**40).range, (2.0**40, 2.0**40 + 6))
        self.refused(ValueError, "2.53", tan.Lattice, ramp.astype("i8") + 2**60)
        for kind in ("c16", "U3", "O", "g", "M8[s]"):
            self.refused(TypeError, "array of", tan.Lattice, ramp.astype(kind))

    def test_directions(self):
        cosine, sine = np.cos(0.3), np.sin(0.3)
        directions = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        values = self.bumps((4, 5, 6))
        m = self.built(values, spacing=(1, 2, 3), origin=(5, 6, 7), directions=directions)
        np.testing.assert_allclose(m.directions, directions)
        mesh = m.mesh(error=0)
        i, j, k = np.round((mesh.points - [5, 6, 7]) @ directions / [1, 2, 3]).astype(int).T
        np.testing.assert_allclose(mesh.values, values[k, j, i], rtol=1e-6)
        np.testing.assert_allclose(mesh.volume(), 5 * 8 * 9)
        self.refused(ValueError, "a", self.built, values, directions=np.zeros((3, 3)))
        self.refused(ValueError, "shape", self.built, values, directions=np.zeros((2, 3)))

    def test_holes(self):
        x, y, z = lattice(9)
        field = 3 * x - y + 2 * z
        inside = np.zeros(field.shape, bool)
        inside[3:6, 3:6, 3:5] = True
        missing = np.where(inside, np.nan, field)
        # Along x cells 2 to 4 touch a hidden point, along y and z cells 2 to 5; a cell is 1/4 wide.
        volume = 8 - 3 * 4 * 4 / 64
        for source in (missing, np.ma.MaskedArray(field, inside), tan.Lattice(field, mask=inside, **placed(9)),
                       tan.Lattice(np.asfortranarray(field.T), mask=inside.T, axes="xyz", **placed(9))):
            m = self.built(source, **({} if isinstance(source, tan.Data) else placed(9)))
            self.assertEqual(m.kind, "irregular")
            mesh = self.exact(m, lambda x, y, z: 3 * x - y + 2 * z)
            np.testing.assert_allclose(mesh.volume(), volume)
            self.assertTrue(np.isnan(mesh.sample([-0.02, 0, 0])))
        whole_numbers = tan.Lattice((100 * field).astype("i2"), mask=inside, **placed(9))
        self.assertEqual(self.built(whole_numbers).dtype, np.dtype("i2"))
        self.assertTrue(any("hole" in remark for remark in whole_numbers.remarks), whole_numbers.remarks)
        self.assertTrue(self.built(missing, **placed(9)).verify(tan.Lattice(missing, **placed(9)), levels=[10]))
        self.refused(ValueError, "nothing is left", self.built, np.full((4, 4, 4), np.nan))
        self.refused(ValueError, "shape", tan.Lattice, field, mask=inside[1:])

    def test_grids(self):
        u, v, w = np.meshgrid(np.linspace(0, 1, 7), np.linspace(0, 1, 6), np.linspace(0, 1, 5), indexing="xy")
        u, v, w = (part.transpose(2, 0, 1) for part in (u, v, w))
        self.assertEqual(u.shape, (5, 6, 7))
        x, y, z = u + 0.2 * v, v + 0.1 * w, w + 0.3 * u * u
        m = self.built(tan.Grid(x, y, z, x + 2 * y - z, name="bent", value_unit="Pa"))
        self.assertEqual((m.kind in ("curvilinear", "irregular"), m.value_unit, m.provenance["source"]), (True, "Pa", "bent"))
        self.exact(m, lambda x, y, z: x + 2 * y - z)
        along = tan.Grid(np.array([0, 1, 3.0]), np.array([0, 2, 3, 7.0]), np.array([1.0, 2]), self.bumps((2, 4, 3)))
        mesh = self.built(along).mesh(error=0)
        np.testing.assert_allclose(mesh.volume(), 3 * 7 * 1)
        np.testing.assert_allclose([mesh.points.min(0), mesh.points.max(0)], [[0, 0, 1], [3, 7, 2]])
        self.refused(ValueError, "fit", tan.Grid, x[1:], y, z, x)
        self.refused(ValueError, "fit", tan.Grid, np.arange(3), y, z, x)

    def test_points(self):
        places = np.random.default_rng(3).random((300, 3))
        field = places @ [1, 2, 3]
        m = self.built(tan.Points(places, field))
        self.exact(m, lambda x, y, z: x + 2 * y + 3 * z)
        self.assertTrue(m.verify(tan.Points(places, field), levels=[5]))
        data = tan.Points(np.concatenate([places, places[:5]]), np.concatenate([field, field[:5]]))
        self.assertTrue(any("5" in remark for remark in data.remarks), data.remarks)
        self.refused(ValueError, "shape", tan.Points, places, field[1:])
        self.refused(ValueError, "finite", self.built, tan.Points(np.full((5, 3), np.nan), np.zeros(5)))
        self.refused(ValueError, ".", self.built, tan.Points(np.zeros((0, 3)), np.zeros(0)))
        self.refused(ValueError, ".", self.built, tan.Points(np.c_[places[:, :2], np.zeros(300)], field))

    def test_cells(self):
        # A cube of two wedges, and a pyramid on its top.
        places = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1], [0.5, 0.5, 2]])
        blocks = {"wedge": [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]], "pyramid": [[4, 5, 6, 7, 8]]}
        field = places @ [1.0, 2, 3]
        m = self.built(tan.Cells(places, blocks, field), method="decimation")
        mesh = self.exact(m, lambda x, y, z: x + 2 * y + 3 * z)
        np.testing.assert_allclose(volumes(mesh).sum(), 1 + 1 / 3)
        same = self.built(tan.Cells(places, list(blocks.items()), field))
        np.testing.assert_allclose(same.mesh(error=0).volume(), 4 / 3)
        averaged = tan.Cells(places, [("hexahedron", [list(range(8))])], [5], per_cell=True)
        self.assertEqual(averaged.range, (5, 5))
        self.refused(ValueError, "numbered", tan.Cells, places, [[0, 1, 2, 99]], field)
        self.refused(ValueError, "numbered", tan.Cells, places, [[0, 1, 2, -1]], field)
        self.refused(ValueError, "row of 4", self.built, tan.Cells(places, [[0, 1, 2]], field))
        self.refused(ValueError, "cube", self.built, tan.Cells(places, {"cube": [[0, 1, 2, 3]]}, field))
        self.refused(ValueError, "values", self.built, tan.Cells(places, [[0, 1, 2, 5]], field[1:]))
        self.refused(TypeError, "whole", tan.Cells, places, [[0.5, 1, 2, 3]], field)
        self.refused(ValueError, ".", self.built, tan.Cells(places, np.zeros((0, 4), int), field))

    def test_shapes_that_are_none(self):
        for shape in ((5,), (5, 5), (0, 4, 4), (1, 4, 4), (2, 2, 2, 2)):
            self.refused(ValueError, ".", self.built, np.zeros(shape))
        values = self.bumps((3, 3, 3))
        for keywords in ({"spacing": (1, 1)}, {"spacing": (0, 1, 1)}, {"spacing": (-1, 1, 1)}, {"spacing": (float("nan"), 1, 1)},
                         {"origin": (float("inf"), 0, 0)}, {"axes": "yxz"}, {"error": float("nan")}, {"error": -1}, {"method": "magic"},
                         {"order": "exact"}, {"block": 0}, {"weights": "point:1"}, {"options": {"array": "p"}}, {"finest": 1}):
            self.refused(ValueError, ".", self.built, values, **keywords)
        for keywords in ({"spacing": "1x1x1"}, {"name": 3}, {"nothing": 1}, {"progress": 3}, {"block": 1.5}):
            self.refused(TypeError, ".", self.built, values, **keywords)
        self.refused(TypeError, "data are", self.built, 3)
        self.refused(TypeError, "path", tan.build, values, 3)
        huge = np.lib.stride_tricks.as_strided(np.zeros(1, "u1"), (2**20, 2**20, 2**20), (0, 0, 0))
        self.refused((MemoryError, ValueError), ".", self.built, huge)

    def test_builders(self):
        x, y, z = lattice(9)
        field = np.exp(-3 * (x * x + y * y + z * z))
        weighted = self.built(field, weights="point:4,4,4,2", error=2)
        self.assertIn("point", weighted.provenance["parameters"]["weights"])
        self.assertLessEqual(weighted.levels["error"][-1], 2)
        for method, keywords in (("decimation", {"order": "rounds", "finest": 0.5}), ("refinement", {"block": 4}), ("refinement", {"block": "none"})):
            m = self.built(field, method=method, **keywords)
            self.assertEqual(m.provenance["builder"], method)
            self.assertLessEqual(m.mesh(error=3).error, 3)
            self.assertTrue(m.verify(field, levels=[3]))

    def test_a_file_is_no_model(self):
        path = self.folder / "mine.txt"
        path.write_text("mine")
        self.refused(tan.WrongUsage, "mine.txt", tan.build, self.bumps((3, 3, 3)), path)
        self.assertEqual(path.read_text(), "mine")
        self.refused(OSError, "nowhere", tan.build, self.bumps((3, 3, 3)), self.folder / "nowhere" / "a.tan")


if __name__ == "__main__":
    unittest.main()
