#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""models_test.py FOLDER: what a model says of itself, and the meshes that it gives, judged by the samples themselves."""
import gc
import pathlib
import pickle
import unittest
import warnings

from module import ModuleTest, np, tan, volumes


class Models(ModuleTest):
    def test_says_what_it_is(self):
        m = self.ball
        self.assertEqual((m.kind, m.shape, m.value_name, m.length_unit, m.dtype), ("regular", (13, 13, 13), "distance", "cm", np.dtype("float64")))
        np.testing.assert_allclose(m.bounds, [[-1, -1, -1], [1, 1, 1]])
        np.testing.assert_allclose(m.spacing, [1 / 6] * 3)
        np.testing.assert_allclose(m.range, (0, np.sqrt(3)))
        self.assertEqual((m.provenance["source"], m.provenance["builder"]), ("ball", "refinement"))
        self.assertIn(f"ball: {m.sites:,} sites", repr(m))
        self.assertTrue(m.is_whole)
        self.assertEqual(m.file_size, pathlib.Path(m.path).stat().st_size)

    def test_pickled_as_its_place(self):
        again = pickle.loads(pickle.dumps(self.ball))
        self.assertTrue(pathlib.Path(again.path).is_absolute())
        np.testing.assert_array_equal(again.mesh(error=5).points, self.ball.mesh(error=5).points)
        secret = tan.open(self.ball.path, token="secret")
        with self.assertRaisesRegex(TypeError, "would give the token away"):
            pickle.dumps(secret)

    def test_what_has_nothing_of_the_data_is_told(self):
        beside = "The (window|focus) has nothing of the data, which lie between"
        for query in ({"window": tan.box((3, 3, 3), (4, 4, 4))}, {"focus": tan.sphere((2, 2, 0), 1.3, error=0.1)},
                      {"focus": [tan.sphere((0, 0, 0), 0.5, error=0.1), tan.box((2, 0, 0), (3, 1, 1), error=0.1)]}):
            with self.assertWarnsRegex(UserWarning, beside):
                self.ball.mesh(error=5, **query)
        with self.assertWarnsRegex(UserWarning, "The surface of 99 is empty: the values of the mesh lie between 0 and 1.7"):
            self.assertEqual(len(self.ball.mesh(error=5).isosurface(99).triangles), 0)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.ball.mesh(error=5, focus=tan.sphere((2, 0, 0), 1.1, error=0.1), window=tan.box((1, 1, 1), (2, 2, 2))).isosurface(1.6)

    def test_names_of_other_formats_are_refused(self):
        for write in (self.ball.save, self.ball.pack, lambda path: tan.build(np.zeros((3, 3, 3)) + np.arange(3), path)):
            with self.assertRaisesRegex(tan.WrongUsage, "has the ending of another format. Take .tan"):
                write(self.folder / "ball.VTU")
        self.assertFalse((self.folder / "ball.VTU").exists())

    def test_levels_are_the_curve(self):
        levels = self.ball.levels
        self.assertEqual(levels.dtype.names, ("error", "warping", "sites", "tetrahedra"))
        self.assertTrue((np.diff(levels["error"]) <= 0).all())
        self.assertTrue((np.diff(levels["sites"].astype(int)) > 0).all())
        self.assertEqual((levels["error"][-1], levels["sites"][-1]), (0, self.ball.sites))
        self.assertFalse(levels.flags.writeable)
        rounded = 1 + 1e-12  # percentages are
        for level in levels[:: len(levels) // 5]:
            self.assertEqual(len(self.ball.mesh(error=float(level["error"]) * rounded).tetrahedra), level["tetrahedra"])
        row = levels[len(levels) // 2]
        self.assertEqual(self.ball.size_at(error=float(row["error"]) * rounded), tuple(row[name] for name in ("sites", "tetrahedra", "error", "warping")))

    def test_a_mesh_keeps_its_error_at_every_sample(self):
        steps = np.linspace(-1, 1, 13)
        places = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), -1).reshape(-1, 3)
        for error in (20, 5, 1):
            mesh = self.ball.mesh(error=error)
            self.assertLessEqual(mesh.error, error)
            off = np.abs(mesh.sample(places) - np.linalg.norm(places, axis=1)).max()
            self.assertLessEqual(off, error / 100 * np.sqrt(3) + 1e-6)
            np.testing.assert_allclose(volumes(mesh).sum(), 8)
            np.testing.assert_allclose(mesh.volume(), 8)
            self.assertGreater(volumes(mesh).min(), 0)
            np.testing.assert_allclose(mesh.values, np.linalg.norm(mesh.points, axis=1), atol=1e-6)

    def test_absolute_and_budget(self):
        self.assertEqual(len(self.ball.mesh(absolute=0.05 * np.sqrt(3)).points), len(self.ball.mesh(error=5).points))
        mesh = self.ball.mesh(budget=500)
        self.assertLessEqual(len(mesh.tetrahedra), 500)
        self.assertGreater(mesh.scale, 1)
        self.assertEqual(self.ball.size_at(budget=500).tetrahedra, len(mesh.tetrahedra))
        self.refused(tan.WrongUsage, "budget", self.ball.mesh, budget=1)

    def test_a_focus_is_finer_there(self):
        focus = tan.sphere((0.5, 0.5, 0.5), 0.3, error=0)
        mesh = self.ball.mesh(error=20, focus=focus)
        coarse = self.ball.mesh(error=20)
        near = np.linalg.norm(mesh.points - 0.5, axis=1) <= 0.3
        steps = np.linspace(-1, 1, 13)
        places = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), -1).reshape(-1, 3)
        inside = places[np.linalg.norm(places - 0.5, axis=1) <= 0.3]
        self.assertGreater(near.sum(), (np.linalg.norm(coarse.points - 0.5, axis=1) <= 0.3).sum())
        np.testing.assert_allclose(mesh.sample(inside), np.linalg.norm(inside, axis=1), atol=1e-6)
        self.assertLess(len(mesh.points), 13**3 // 2)
        two = self.ball.mesh(error=20, focus=[focus, tan.box((-1, -1, -1), (-0.6, -0.6, -0.6), error=0)])
        self.assertGreater(len(two.points), len(mesh.points))
        same = self.ball.mesh(field="sphere(0.5,0.5,0.5,0.3;0,20)")
        self.assertEqual(len(same.points), len(mesh.points))

    def test_a_window_is_filled(self):
        mesh = self.ball.mesh(error=5, window=tan.box((-0.5, -0.5, -0.5), (0.4, 0.3, 0.2), border="clipped"))
        np.testing.assert_allclose(mesh.volume(), 0.9 * 0.8 * 0.7)
        self.assertEqual(np.isnan(mesh.sample([[0, 0, 0], [0.5, 0, 0]])).tolist(), [False, True])
        self.assertIn(2**32 - 1, mesh.sites)
        inside = self.ball.mesh(error=5, window=tan.box((-0.5, -0.5, -0.5), (0.4, 0.3, 0.2), border="contained"))
        self.assertTrue(((inside.points >= -0.5) & (inside.points <= 0.4)).all())

    def test_values_choose_tetrahedra(self):
        mesh = self.ball.mesh(error=5, values=(0.5, 0.6))
        corners = mesh.values[mesh.tetrahedra]
        self.assertTrue(((corners.min(1) <= 0.6) & (corners.max(1) >= 0.5)).all())
        both = self.ball.mesh(error=5, values=[(0.5, 0.6), (1.2, 1.3)])
        self.assertGreater(len(both.tetrahedra), len(mesh.tetrahedra))

    def test_views_outlive_everything(self):
        m = tan.open(self.ball.path)
        mesh = m.mesh(error=2)
        surface = mesh.isosurface(0.5)
        kept = (mesh.points, mesh.values, mesh.tetrahedra, mesh.sites, surface.points, surface.triangles, m.levels)
        copies = [array.copy() for array in kept]
        part = mesh.points[10:20, 1]
        as_signed = mesh.tetrahedra.view("int32")
        del mesh, surface
        m.mesh(error=0)
        m.mesh(error=50)
        del m
        gc.collect()
        for array, copy in zip(kept, copies):
            np.testing.assert_array_equal(array, copy)
            self.assertFalse(array.flags.writeable)
            self.assertRaises(ValueError, array.__setitem__, 0, 0)
        np.testing.assert_array_equal(part, copies[0][10:20, 1])
        np.testing.assert_array_equal(as_signed, copies[2])

    def test_no_copy(self):
        mesh = self.ball.mesh(error=2)
        self.assertEqual(mesh.points.ctypes.data, mesh.points.ctypes.data)
        self.assertEqual(mesh.points.base.__class__.__name__, "PyCapsule")

    def test_explore(self):
        with self.ball.explore(budget=2000) as x:
            sizes = [len(x.mesh(error=error).tetrahedra) for error in (50, 10, 1)]
        self.assertEqual(sizes, sorted(sizes))
        self.assertLessEqual(sizes[-1], 2000)
        self.refused(tan.WrongUsage, "ended", x.mesh, error=1)

    def test_packed_and_saved(self):
        facts = self.ball.pack(self.folder / "packed.tan")
        self.assertLess(facts["bytes"], self.ball.file_size / 5)
        packed = tan.open(self.folder / "packed.tan")
        np.testing.assert_array_equal(packed.mesh(error=3).tetrahedra, self.ball.mesh(error=3).tetrahedra)
        self.ball.save(self.folder / "copy.tan")
        self.assertEqual((self.folder / "copy.tan").read_bytes(), pathlib.Path(self.ball.path).read_bytes())

    def test_verified(self):
        verdict = self.ball.verify(self.distances, spacing=[1 / 6] * 3, origin=(-1, -1, -1), levels=[10, 0])
        self.assertTrue(verdict, verdict.text)
        self.assertEqual([level["error"] for level in verdict.levels], [10, 0])
        self.assertLessEqual(verdict.levels[0]["error_statistics"]["largest"], 10)
        wrong = self.distances.copy()
        wrong[3, 4, 5] += 0.5
        refuted = self.ball.verify(wrong, spacing=[1 / 6] * 3, origin=(-1, -1, -1), levels=[10])
        self.assertFalse(refuted)
        self.assertIn("sample", refuted.text)


class WrongCalls(ModuleTest):
    def test_no_model(self):
        error = self.refused(OSError, "none.tan.*No such file", tan.open, self.folder / "none.tan")
        self.assertIsInstance(error, tan.BadInput)
        (self.folder / "text.tan").write_text("nothing")
        self.refused(tan.BadInput, "text.tan", tan.open, str(self.folder / "text.tan"))
        self.assertNotIn("\x1b", str(self.refused(OSError, r"red\\x1b\[31m.tan", tan.open, self.folder / "red\x1b[31m.tan")))
        self.refused(TypeError, "path", tan.open, 3)
        self.refused(TypeError, "path", tan.open, None)
        self.refused(ValueError, "path", tan.open, "")
        self.refused(ValueError, "path", tan.open, "a\0b")

    def test_damaged(self):
        whole = pathlib.Path(self.ball.path).read_bytes()
        for name, damaged in {"cut": whole[: len(whole) // 2], "changed": whole[:40000] + bytes(500) + whole[40500:]}.items():
            path = self.folder / f"{name}.tan"
            path.write_bytes(damaged)

            def used(path=path):
                tan.open(path).mesh(error=0)
            self.refused(tan.BadInput, f"{name}.tan", used)

    def test_numbers_that_are_none(self):
        nan, inf = float("nan"), float("inf")
        for keywords in ({"error": nan}, {"error": inf}, {"error": -1}, {"absolute": nan}, {"budget": 0}, {"budget": -5}, {"budget": 2**70},
                         {"values": (nan, 1)}, {"values": (2, 1)}, {"error": 1, "absolute": 1}, {"error": 1, "field": "2"}, {"field": "none"},
                         {"field": "nan"}, {"method": "magic"}, {"warping": 3}, {"field": "1", "focus": tan.sphere((0, 0, 0), 1, error=0)}):
            self.refused(ValueError, ".", self.ball.mesh, **keywords)
        for keywords in ({"error": "1"}, {"error": [1]}, {"error": 1j}, {"budget": 1.5}, {"budget": "9"}, {"error": True}, {"focus": "ball"},
                         {"window": (1, 2)}, {"values": 3}, {"field": 3}, {"method": 1}, {"progress": 3}, {"nothing": 1}):
            self.refused(TypeError, ".", self.ball.mesh, **keywords)
        self.refused(ValueError, "centre", tan.sphere, (nan, 0, 0), 1)
        self.refused(ValueError, "radius", tan.sphere, (0, 0, 0), -1)
        self.refused(ValueError, "centre", tan.sphere, (0, 0), 1)
        self.refused(ValueError, "border", tan.box, (0, 0, 0), (1, 1, 1), border="round")
        self.refused(ValueError, "focus", self.ball.mesh, focus=tan.sphere((0, 0, 0), 1))
        self.refused(ValueError, ".", self.ball.mesh, window=tan.box((1, 1, 1), (0, 0, 0)))

    def test_places_that_are_none(self):
        mesh = self.ball.mesh(error=10)
        self.refused(ValueError, "shape", mesh.sample, [[0, 0]])
        self.refused(ValueError, "shape", mesh.sample, 3)
        self.refused(TypeError, "numbers", mesh.sample, [["a", "b", "c"]])
        self.assertTrue(np.isnan(mesh.sample([[np.nan, 0, 0], [np.inf, 0, 0], [9, 9, 9]])).all())
        self.assertEqual(mesh.sample(np.zeros((0, 3))).shape, (0,))
        self.assertEqual(np.shape(mesh.sample((0.1, 0.2, 0.3))), ())
        self.refused(ValueError, "value", mesh.isosurface, float("nan"))
        self.refused(ValueError, "direction", mesh.slice, (0, 0, 0), 1)
        self.refused(TypeError, "normal", mesh.slice, "z", 1)

    def test_files_that_cannot_be_written(self):
        self.refused(OSError, "nowhere", self.ball.pack, self.folder / "nowhere" / "a.tan")
        (self.folder / "kept.txt").write_text("mine")
        self.refused(tan.WrongUsage, "kept.txt", self.ball.pack, self.folder / "kept.txt")
        self.assertEqual((self.folder / "kept.txt").read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
