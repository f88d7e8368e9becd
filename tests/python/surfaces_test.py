#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""surfaces_test.py FOLDER: isosurfaces, slices, boundaries and values at places, judged by closed forms and by VTK; meshes for VTK and meshio."""
import gc
import unittest

from module import ModuleTest, lattice, np, placed, tan

try:
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
    from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkCutter, vtkProbeFilter
except ImportError:
    vtkPlane = None
try:
    import meshio
except ImportError:
    meshio = None


def needs(module, name):
    return unittest.skipIf(module is None, f"no {name}")


def area_in_vtk(poly_data):
    points = vtk_to_numpy(poly_data.GetPoints().GetData()).astype(float)
    a, b, c = (points[vtk_to_numpy(poly_data.GetPolys().GetConnectivityArray()).reshape(-1, 3)[:, corner]] for corner in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


class Surfaces(ModuleTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        x, y, z = lattice(9)
        cls.ramp = tan.build(x + 2 * y + 3 * z, cls.folder / "ramp.tan", **placed(9))

    def test_a_sphere(self):
        surface = self.ball.isosurface(0.8, error=0)
        self.assertLess(abs(surface.area() / (4 * np.pi * 0.64) - 1), 0.02)
        np.testing.assert_allclose(np.linalg.norm(surface.points, axis=1), 0.8, atol=0.02)
        np.testing.assert_allclose(surface.values, 0.8)
        outward = surface.points / np.linalg.norm(surface.points, axis=1)[:, None]
        self.assertLess(np.einsum("ij,ij->i", outward, surface.normals).max(), -0.9)  # towards smaller values
        a, b, c = (surface.points[surface.triangles[:, corner]] for corner in range(3))
        self.assertLess(np.einsum("ij,ij->i", np.cross(b - a, c - a), a).max(), 0)
        edges = np.sort(np.concatenate([surface.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]), axis=1)
        self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())  # closed
        self.assertEqual(len(self.ball.isosurface(9, error=5).triangles), 0)

    def test_a_plane_through_a_box(self):
        mesh = self.ball.mesh(error=4)
        for at in (0.3, (7, -5, 0.3)):
            cut = mesh.slice((0, 0, 2), at)
            self.assertAlmostEqual(cut.area(), 4, places=6)
            np.testing.assert_allclose(cut.points[:, 2], 0.3, atol=1e-6)
            np.testing.assert_allclose(cut.normals, [[0, 0, 1]] * len(cut.points), atol=1e-6)
        diagonal = self.ramp.slice((1, 1, 1), 0, error=0)
        self.assertAlmostEqual(diagonal.area(), 3 * np.sqrt(3), places=5)  # a regular hexagon
        np.testing.assert_allclose(diagonal.values, diagonal.points @ [1, 2, 3], atol=1e-5)

    def test_the_boundary(self):
        boundary = self.ball.mesh(error=4).boundary()
        self.assertAlmostEqual(boundary.area(), 24)
        self.assertTrue((np.abs(boundary.points).max(1) == 1).all())
        np.testing.assert_allclose(np.einsum("ij,ij->i", boundary.points, boundary.normals), 1, atol=1e-6)

    def test_values_of_a_linear_field(self):
        places = np.random.default_rng(5).uniform(-1, 1, (2000, 3))
        np.testing.assert_allclose(self.ramp.sample(places, error=0), places @ [1, 2, 3], atol=1e-5)
        corners = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
        mesh = self.ramp.mesh(error=30)
        np.testing.assert_allclose(mesh.sample(corners), corners @ [1, 2, 3], atol=1e-5)
        np.testing.assert_array_equal(np.isnan(mesh.sample(1.001 * corners)), True)
        self.assertTrue(np.isfinite(mesh.sample(mesh.points)).all())

    @needs(vtkPlane, "VTK")
    def test_vtk_probes_the_same(self):
        places = np.random.default_rng(6).uniform(-0.99, 0.99, (500, 3))
        mesh = self.ball.mesh(error=3)
        points, data, probe = vtkPoints(), vtkPolyData(), vtkProbeFilter()
        points.SetData(numpy_to_vtk(places))
        data.SetPoints(points)
        probe.SetInputData(data)
        probe.SetSourceData(mesh.to_vtk())
        probe.Update()
        np.testing.assert_allclose(vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("distance")), mesh.sample(places), atol=1e-5)

    @needs(vtkPlane, "VTK")
    def test_vtk_cuts_the_same(self):
        mesh = self.ball.mesh(error=3)
        plane, cutter, contour = vtkPlane(), vtkCutter(), vtkContourFilter()
        plane.SetNormal(0.6, 0, 0.8)
        plane.SetOrigin(0.1, 0, 0)
        cutter.SetCutFunction(plane)
        contour.SetValue(0, 0.7)
        for cut, ours in ((cutter, mesh.slice((0.6, 0, 0.8), (0.1, 0, 0))), (contour, mesh.isosurface(0.7))):
            cut.SetInputData(mesh.to_vtk())
            cut.Update()
            self.assertAlmostEqual(area_in_vtk(cut.GetOutput()), ours.area(), places=4)

    @needs(vtkPlane, "VTK")
    def test_what_vtk_has_outlives_the_mesh(self):
        mesh = self.ball.mesh(error=2)
        grid, surface = mesh.to_vtk(), mesh.boundary().to_vtk()
        points, corners = mesh.points.copy(), mesh.tetrahedra.copy()
        self.assertEqual(vtk_to_numpy(grid.GetPoints().GetData()).ctypes.data, mesh.points.ctypes.data)  # shared
        del mesh
        self.ball.mesh(error=0)
        gc.collect()
        np.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()), points)
        np.testing.assert_array_equal(vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4), corners)
        self.assertEqual(grid.GetCellType(0), 10)
        self.assertAlmostEqual(area_in_vtk(surface), 24)
        self.assertEqual(surface.GetPointData().GetNormals().GetNumberOfTuples(), surface.GetNumberOfPoints())

    @needs(meshio, "meshio")
    def test_meshio(self):
        mesh = self.ball.mesh(error=10)
        mesh.to_meshio().write(self.folder / "ball.vtu")
        read = meshio.read(self.folder / "ball.vtu")
        np.testing.assert_array_equal(read.points, mesh.points)
        np.testing.assert_array_equal(read.cells_dict["tetra"], mesh.tetrahedra)
        np.testing.assert_array_equal(read.point_data["distance"], mesh.values)
        mesh.boundary().to_meshio().write(self.folder / "ball.ply")
        self.assertEqual(len(meshio.read(self.folder / "ball.ply").cells_dict["triangle"]), len(mesh.boundary().triangles))
        import tan.meshio  # noqa: F401
        self.assertEqual(len(meshio.read(self.ball.path).points), len(self.ball.mesh().points))
        again = tan.build(tan.Cells(read.points, read.cells, read.point_data["distance"]), self.folder / "again.tan")
        self.assertAlmostEqual(again.mesh(error=0).volume(), 8)


if __name__ == "__main__":
    unittest.main()
