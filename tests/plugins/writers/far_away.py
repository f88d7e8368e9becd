#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""far_away.py BUILD: data far from the origin, and a layer a ten-millionth of its domain thick, keep their places in every mesh, surface
and picture: no tetrahedron is flat or turned over, no triangle lost its area, every vertex is a sample to the last bit that the format has.
Judged in whole numbers, into which doubles are turned without rounding, from what VTK, meshio and the parsers below read; nothing of TAn
reads here. Exit code 77: one of the readers is missing."""
import concurrent.futures
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TAN = pathlib.Path(sys.argv.pop(1)).resolve() / "bin/tan"
SURVEY = (339385.0, 4264212.0, 1680.0)  # UTM, in metres
ORIGINS = {"0": (0.0, 0.0, 0.0), "1e3": (1e3, -1e3, 1e3), "utm": SURVEY, "1e8": (1e8, 1e8, -1e8), "1e9": (1e9, -1e9, 1e9)}
SPACINGS = (1.0, 0.05, 1e-3)
ALL = [(origin, spacing) for origin in ORIGINS for spacing in SPACINGS]
HARD = [("0", 1e-3), ("1e3", 1e-3), ("utm", 1.0), ("utm", 1e-3), ("1e8", 1e-3), ("1e9", 0.05), ("1e9", 1e-3)]
MESHES = (".vtk", ".obj", ".stl", ".glb", ".ply", ".vtp")
SURFACES = (".stl", ".vtp", ".glb", ".ply", ".obj")
LEVEL = 7.5  # no value is nearer than 1.5, nor farther than 7.5: no surface comes near a vertex
ERROR = 30
# From the wall outwards; doubles far away still hold all of them, and differ as they do here.
LAYER = (0.0, *(2.0 ** -power for power in (23, 20, 17, 14, 11, 7, 3, 0)))
CORNERS = numpy.array([[corner >> axis & 1 for axis in range(3)] for corner in range(8)])
KUHN = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7))


def tan(*words, status=0):
    done = subprocess.run([str(TAN), *map(str, words)], capture_output=True, text=True, errors="replace", check=False)
    assert done.returncode == status, f"{words}: {done.returncode}: {done.stdout}{done.stderr}"
    return done.stdout


# Samples: places and values, x fastest, and the files that hold them.

def indices(size):
    return numpy.indices(size[::-1]).reshape(3, -1)[::-1].T


def values_of(count, seed=1):
    """Floats of no pattern, so that no sample follows from others and the finest mesh needs all of them."""
    random = numpy.random.default_rng(seed)
    return (random.random(count) * 6 + 9 * random.integers(0, 2, count)).astype("<f4").astype(float)


def lattice_places(origin, spacing, size):
    return numpy.asarray(origin) + spacing * indices(size)


def write_nrrd(path, origin, spacing, size, values):
    head = (f"NRRD0004\ntype: float\ndimension: 3\nsizes: {size[0]} {size[1]} {size[2]}\nencoding: raw\nendian: little\n"
            f"spacings: {spacing!r} {spacing!r} {spacing!r}\naxis mins: {origin[0]!r} {origin[1]!r} {origin[2]!r}\n\n")
    path.write_bytes(head.encode() + values.astype("<f4").tobytes())


def write_plot3d(path, places, size, values):
    path.write_bytes(struct.pack("<3i", *size) + places.T.astype("<f8").tobytes())
    flow = numpy.zeros((5, len(values)))
    flow[0] = values
    path.with_suffix(".q").write_bytes(struct.pack("<3i4d", *size, 0, 0, 0, 0) + flow.astype("<f8").tobytes())


def write_points(path, places, values):
    rows = (",".join(map(repr, (*map(float, place), float(value)))) for place, value in zip(places, values))
    path.write_text("x,y,z,value\n" + "\n".join(rows) + "\n")


def write_tetrahedra(path, places, size, values):
    """The cells of a grid, each cut into six."""
    step = numpy.array([1, size[0], size[0] * size[1]])
    first = indices(size)[(indices(size) < numpy.array(size) - 1).all(axis=1)] @ step
    cells = numpy.concatenate([first[:, None] + (CORNERS @ step)[list(corners)] for corners in KUHN])
    meshio.write_points_cells(path, places, [("tetra", cells)], {"value": values}, binary=True, compression=None)


def bent(origin, spacing, size):
    """A grid that is gently bent, so that its places have no pattern."""
    index = indices(size)
    return numpy.asarray(origin) + spacing * (index + 0.15 * numpy.sin(1.3 * index[:, [1, 2, 0]] + 0.7 * index[:, [2, 0, 1]]))


def scattered(origin, spacing, count):
    return numpy.asarray(origin) + spacing * 6 * numpy.random.default_rng(5).random((count, 3))


def layered(origin, scale):
    """Along y by LAYER, evenly along x and z."""
    size = (5, len(LAYER), 5)
    index = indices(size)
    return numpy.asarray(origin) + scale * numpy.stack([index[:, 0] / 4, numpy.array(LAYER)[index[:, 1]], index[:, 2] / 4], axis=1), size


# What is in a file: places, cells of three or four corners, values at the vertices (None: none), and what must be added to places.

def by_vtk(path):
    reader = {".vtu": vtkXMLUnstructuredGridReader, ".vtp": vtkXMLPolyDataReader, ".vtk": vtkGenericDataObjectReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    data = reader.GetOutput()
    cells = data.GetPolys() if path.suffix == ".vtp" else data.GetCells()
    corners = vtk_to_numpy(cells.GetConnectivityArray()).reshape(data.GetNumberOfCells(), -1)
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float), corners, vtk_to_numpy(data.GetPointData().GetScalars())


def by_meshio(path):
    mesh = meshio.read(path)
    arrays = [array for name, array in mesh.point_data.items() if name not in ("nx", "ny", "nz")]  # whatever the data call it
    return mesh.points.astype(float), mesh.cells[0].data, arrays[0]


def by_text(path):
    lines = [line.split() for line in path.read_text().splitlines()]
    places = numpy.array([line[1:4] for line in lines if line[:1] == ["v"]], float)
    return places, numpy.array([[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines if line[:1] == ["f"]]), None


def by_stl(path):
    content = path.read_bytes()
    records = numpy.frombuffer(content, numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")]), offset=84)
    words = content[:80].decode().replace(",", "").split()
    shift = numpy.array(words[1:4], float) if words[0] == "add" else numpy.zeros(3)
    places, corners = numpy.unique(records["corners"].reshape(-1, 3).astype(float), axis=0, return_inverse=True)
    return places, corners.reshape(-1, 3), None, shift


def by_glb(path):
    content = path.read_bytes()
    length = struct.unpack_from("<I", content, 12)[0]
    told = json.loads(content[20:20 + length])
    kinds = {("VEC3", 5126): ("<f4", 3), ("SCALAR", 5126): ("<f4", 1), ("SCALAR", 5125): ("<u4", 1)}

    def array(number):
        accessor = told["accessors"][number]
        kind, width = kinds[accessor["type"], accessor["componentType"]]
        start = 28 + length + told["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return numpy.frombuffer(content, kind, width * accessor["count"], start).reshape(-1, width)

    primitive = told["meshes"][0]["primitives"][0]
    columns = numpy.array(told["nodes"][0]["matrix"]).reshape(4, 4)
    shift = columns[:3, :3] @ columns[3, :3]  # back from y up to z up
    return array(primitive["attributes"]["POSITION"]).astype(float), array(primitive["indices"]).reshape(-1, 3), None, shift


def read(path):
    by = {".vtu": by_vtk, ".vtp": by_vtk, ".vtk": by_vtk, ".ply": by_meshio, ".obj": by_text, ".stl": by_stl, ".glb": by_glb}[path.suffix]
    places, cells, values, *shift = by(path)
    return places, cells, values, *(shift or [numpy.zeros(3)])


def picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


# Judging in whole numbers.

def whole(places):
    """Doubles times the power of two that makes all of them whole, as Python's integers."""
    ratios = [number.as_integer_ratio() for number in places.ravel().tolist()]
    scale = max((bottom for _, bottom in ratios), default=1)
    return numpy.array([top * (scale // bottom) for top, bottom in ratios], dtype=object).reshape(places.shape)


def cross(a, b):
    return numpy.stack([a[:, (k + 1) % 3] * b[:, (k + 2) % 3] - a[:, (k + 2) % 3] * b[:, (k + 1) % 3] for k in range(3)], axis=1)


def sixfold_volumes(places, cells):
    a, b, c, d = (whole(places)[cells[:, corner]] for corner in range(4))
    return ((b - a) * cross(c - a, d - a)).sum(axis=1)


def without_area(places, triangles):
    a, b, c = (whole(places)[triangles[:, corner]] for corner in range(3))
    return int((cross(b - a, c - a) == 0).all(axis=1).sum())


def keys(places):
    return [place.tobytes() for place in numpy.ascontiguousarray(places + 0.0)]  # -0 is 0


def edges_of(cells):
    pairs = numpy.concatenate([cells[:, [i, j]] for i in range(cells.shape[1]) for j in range(i)])
    return numpy.unique(numpy.sort(pairs, axis=1), axis=0)


class FarAway(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.pool = concurrent.futures.ThreadPoolExecutor(2)
        cls.addClassCleanup(cls.pool.shutdown, cancel_futures=True)

    def made(self, number, data, name, builder):
        """All that programs make of a dataset; judged() looks at it. Which formats come, `number` says."""
        stem = self.folder / f"{name}-{builder}"
        model = stem.with_suffix(".tan")
        of_mesh = stem.with_suffix(".boundary" + MESHES[number % len(MESHES)])
        of_surface = stem.with_suffix(".surface" + SURFACES[number % len(SURFACES)])
        tan("build", data, "-o", model, "--builder", builder)
        verdict = json.loads(tan("verify", model, "--against", data, "--lod", f"{ERROR},0", "--json"))
        told = {}
        for error, path in ((0, stem.with_suffix(".vtu")), (ERROR, of_mesh)):
            told[path] = json.loads(tan("extract", model, "--error", error, "-o", path, "--json"))
        told[of_surface] = json.loads(tan("isosurface", model, "--error", 0, "--value", LEVEL, "-o", of_surface, "--json"))
        return {"told": told, "verdict": verdict, "mesh": stem.with_suffix(".vtu"), "coarse": of_mesh, "surface": of_surface}

    def judged(self, made, places, values, label):
        samples = dict(zip(keys(places), values))
        spacing = numpy.linalg.norm(numpy.ptp(places, axis=0)) / 20
        self.assertEqual(len(samples), len(places), "neighbours are one")
        self.assertTrue(made["verdict"]["ok"], label)

        # The finest mesh: all samples, each with its value, and no tetrahedron that is flat or turned over.
        found, cells, at, _ = read(made["mesh"])
        self.all_samples(found, at, samples, label)
        self.assertEqual(len(found), len(samples), label)
        self.assertGreater(min(sixfold_volumes(found, cells)), 0, label)

        # A coarse one, or its boundary.
        path = made["coarse"]
        coarse, corners, at, shift = read(path)
        if path.suffix == ".obj" and (places.astype("<f4") == places).all():
            coarse = coarse.astype("<f4").astype(float)  # it has the digits of floats if those hold all places
        if path.suffix in (".stl", ".glb"):
            self.in_floats(path, made["told"][path], places, 0, coarse, shift, spacing, label)
        else:
            self.all_samples(coarse, at, samples, label)
        if corners.shape[1] == 4:
            self.assertGreater(min(sixfold_volumes(coarse, corners)), 0, label)
        else:
            self.assertEqual(without_area(coarse, corners), 0, label)
        self.assertEqual(len(corners) > 0, True, label)
        self.surface_judged(made, found, cells, [samples[key] for key in keys(found)], spacing, label)

    def all_samples(self, found, at, samples, label):
        """Each vertex is another sample, with its value if there are values."""
        self.assertEqual(len(set(keys(found))), len(found), f"{label}: vertices are one")
        strange = [place for place, key in zip(found, keys(found)) if key not in samples]
        self.assertEqual(len(strange), 0, f"{label}: of {len(found)}, as {strange[:1]}")
        if at is not None:
            self.assertEqual([samples[key] for key in keys(found)], list(at), label)

    def surface_judged(self, made, found, cells, values, spacing, label):
        """One vertex on each edge whose ends lie on either side, where the value is linear along it."""
        path = made["surface"]
        edges = edges_of(cells)
        low, high = (numpy.array(values)[edges[:, end]] for end in range(2))
        crossed = (low < LEVEL) != (high < LEVEL)
        share = ((LEVEL - low) / (high - low + ~crossed))[crossed, None]
        base = found[0]
        wanted = (found[edges[crossed, 0]] - base) * (1 - share) + (found[edges[crossed, 1]] - base) * share
        surface, triangles, _, shift = read(path)
        step = numpy.spacing(numpy.abs(found).max())
        if path.suffix in (".stl", ".glb"):
            self.in_floats(path, made["told"][path], wanted + base, 2 * step, surface, shift, spacing, label)
        self.assertEqual(len(triangles), made["told"][path]["triangles"], label)
        self.assertEqual(len(surface), len(wanted), label)
        away = numpy.abs((surface[:, None, :] - (base - shift)) - wanted[None, :, :]).max(axis=2).min(axis=1)
        floats = float(numpy.spacing(numpy.float32(numpy.abs(surface).max()))) if path.suffix in (".stl", ".glb") else 0
        self.assertLessEqual(away.max(), 2 * step + floats + 1e-13 * spacing, label)
        self.assertEqual(without_area(surface, triangles), 0, label)

    def in_floats(self, path, told, places, known, found, shift, spacing, label):
        """Places that are known so well, less a shift, which the report tells if there is any, to the last bit of floats."""
        remarks = [text for text in told.get("remarks", []) if "x, y and z are smaller than in the data by" in text]
        self.assertEqual(len(remarks), 1 if shift.any() else 0, f"{label}: {told}")
        if remarks:
            numbers = remarks[0].split(" by ")[1].split(", because ")[0].replace(" and", ",").split(", ")
            self.assertEqual([float(number) for number in numbers], list(shift), label)
            self.assertIn(str(path), remarks[0])
        step = numpy.spacing(numpy.abs(found).astype("<f4")).astype(float)
        self.assertLessEqual(step.max(), spacing / 100, f"{label}: floats are too coarse")
        away = (numpy.abs(found[:, None, :] - (places - shift)[None, :, :]) / (step / 2 + known)[:, None, :]).max(axis=2).min(axis=1)
        self.assertLessEqual(away.max(), 1, label)

    def judge_all(self, kind, cases):
        """cases: label, data file, places, values, builders."""
        jobs = [(label, places, values, self.pool.submit(self.made, number, data, f"{kind}-{number}", builder))
                for number, (label, data, places, values, builder) in enumerate(cases)]
        for label, places, values, job in jobs:
            with self.subTest(kind=kind, at=label):
                self.judged(job.result(), places, values, label)

    def test_lattices(self):
        cases = []
        for number, (origin, spacing) in enumerate(ALL):
            size = (6, 5, 5)
            places = lattice_places(ORIGINS[origin], spacing, size)
            path, values = self.folder / f"lattice-{number}.nrrd", values_of(len(places))
            write_nrrd(path, ORIGINS[origin], spacing, size, values)
            cases.append(((origin, spacing), path, places, values, "decimation" if number % 5 == 4 else "refinement"))
        self.judge_all("lattice", cases)

    def test_grids(self):
        cases = []
        for number, (origin, spacing) in enumerate(HARD):
            size = (5, 5, 6)
            path, places = self.folder / f"grid-{number}.xyz", bent(ORIGINS[origin], spacing, size)
            values = values_of(len(places))
            write_plot3d(path, places, size, values)
            cases.append(((origin, spacing), path, places, values, "decimation" if number % 4 == 3 else "refinement"))
        self.judge_all("grid", cases)

    def test_tetrahedra(self):
        cases = []
        for number, (origin, spacing) in enumerate(HARD):
            size = (5, 5, 5)
            path, places = self.folder / f"tetrahedra-{number}.vtu", bent(ORIGINS[origin], spacing, size)
            values = values_of(len(places))
            write_tetrahedra(path, places, size, values)
            cases.append(((origin, spacing), path, places, values, "decimation"))
        self.judge_all("tetrahedra", cases)

    def test_points(self):
        cases = []
        for number, (origin, spacing) in enumerate(HARD):
            path, places = self.folder / f"points-{number}.csv", scattered(ORIGINS[origin], spacing, 120)
            values = values_of(len(places))
            write_points(path, places, values)
            cases.append(((origin, spacing), path, places, values, "decimation" if number % 4 == 1 else "refinement"))
        self.judge_all("points", cases)

    def test_boundary_layers(self):
        cases = []
        for number, origin in enumerate(ORIGINS):
            places, size = layered(ORIGINS[origin], 1.0)
            values = values_of(len(places))
            for kind, write in ((".xyz", write_plot3d), (".vtu", write_tetrahedra)):
                path = self.folder / f"layer-{number}{kind}"
                write(path, places, size, values)
                cases.append(((origin, kind), path, places, values, "decimation" if kind == ".vtu" else "refinement"))
        self.judge_all("layer", cases)

    def drawn(self, kind, scale, corner, eye, looks):
        """Pictures of a lattice of this spacing, or of a layer in a domain of this size, from an eye relative to its corner."""
        path = self.folder / f"seen-{scale}-{'_'.join(map(str, (*corner, *eye.values())))}.{'xyz' if kind == 'layer' else 'nrrd'}"
        if kind == "layer":
            places, size = layered(corner, scale)
            write_plot3d(path, places, size, values_of(len(places)))
        else:
            write_nrrd(path, corner, scale, (5, 6, 5), values_of(150))
        tan("build", path, "-o", path.with_suffix(".tan"))
        target = [float(at + begin) for at, begin in zip(eye["target"], corner)]
        path.with_suffix(".json").write_text(json.dumps({**eye, "target": target, "up": "z"}))
        pictures = []
        for look in looks:
            seen = ("--error", 0, "--camera", path.with_suffix(".json"), "--size", "64x64", *look)
            tan("render", path.with_suffix(".tan"), *seen, "-o", path.with_suffix(".png"))
            pictures.append(picture(path.with_suffix(".png")))
        return pictures

    def same_pictures(self, kind, scale, origins, eye, looks, most):
        """At most so many pixels differ by more than 2 of 255 from what is seen with data and eye at the origin."""
        jobs = {origin: self.pool.submit(self.drawn, kind, scale, ORIGINS[origin], eye, looks) for origin in ("0", *origins)}
        for origin in origins:
            for look, near, far in zip(looks, jobs["0"].result(), jobs[origin].result()):
                with self.subTest(of=kind, scale=scale, at=origin, look=look):
                    self.assertGreater(len(numpy.unique(near, axis=0)), 50)
                    self.assertLessEqual((numpy.abs(far - near).max(axis=1) > 2).sum(), most)

    def test_pictures_of_lattices(self):
        looks = ("--isovalue", f"{LEVEL}:gold", "--boundary", "translucent"), ("--mode", "volume")
        # In the first case all places are the same but for the origin; in the others they differ in the last bits, so that a few
        # samples of pixels fall on the other side of an edge.
        for spacing, origins, most in ((2.0 ** -10, ("1e3", "utm", "1e8"), 0), (0.05, ("utm", "1e9"), 8), (1e-3, ("utm", "1e8", "1e9"), 8)):
            eye = {"azimuth": 30, "elevation": 20, "target": [2 * spacing] * 3, "distance": 14 * spacing}
            self.same_pictures("lattice", spacing, origins, eye, looks, most)

    def test_pictures_of_layers_from_near(self):
        """From a few cells away, of which the first is a ten-millionth of the domain, and a hundred steps of doubles."""
        walls, surface, volume = ("--boundary", "values", "--lit", "--isovalue", 900), ("--isovalue", f"{LEVEL}:gold"), ("--mode", "volume")
        for scale, origins in ((1.0, ("1e3", "utm")), (128.0, ("1e8", "1e9"))):
            eye = {"elevation": 0, "target": [scale, scale * 2.0 ** -20, scale / 2], "distance": scale * 2.0 ** -17}
            self.same_pictures("layer", scale, origins, {**eye, "azimuth": 270}, (walls,), 0)
            self.same_pictures("layer", scale, origins, {**eye, "azimuth": 90}, (surface, volume), 0)

    def test_reports(self):
        """A shift is told in one line, and once for each file that has one."""
        path, model, stl = self.folder / "told.nrrd", self.folder / "told.tan", self.folder / "told.stl"
        write_nrrd(path, SURVEY, 0.05, (5, 5, 5), values_of(125))
        tan("build", path, "-o", model)
        line = f"In '{stl}' x, y and z are smaller than in the data by 339385"
        for command in (("extract", model), ("isosurface", model, "--value", LEVEL)):
            lines = tan(*command, "--error", 0, "-o", stl).splitlines()
            self.assertEqual([text.startswith(line) for text in lines], [False] * (len(lines) - 1) + [True], lines)
            self.assertTrue(lines[-1].endswith(": add these numbers to get places of the data."), lines)
        look = ("--isovalue", LEVEL, "--size", "32x32", "-o", self.folder / "told.png")
        told = json.loads(tan("render", model, *look, "--surfaces", stl, "--json"))
        self.assertTrue(told["remarks"][0].startswith(line), told)
        self.assertEqual(len(told["remarks"]), 1)
        self.assertNotIn("remarks", json.loads(tan("extract", model, "-o", self.folder / "told.obj", "--json")))

    def test_a_rounded_place_is_found(self):
        """A model does not pass for that of samples of which one lies elsewhere by less than a float tells."""
        places = bent(SURVEY, 1.0, (5, 5, 5))
        values = values_of(len(places))
        moved = places.copy()
        moved[31] = places[31].astype("<f4")
        self.assertTrue((moved != places).any())
        for name, write in (("rounded.csv", lambda path, at: write_points(path, at, values)),
                            ("rounded.xyz", lambda path, at: write_plot3d(path, at, (5, 5, 5), values)),
                            ("rounded.vtu", lambda path, at: write_tetrahedra(path, at, (5, 5, 5), values))):
            with self.subTest(name=name):
                path = self.folder / name
                write(path, places)
                tan("build", path, "-o", path.with_suffix(".tan"))
                tan("verify", path.with_suffix(".tan"), "--against", path, "--lod", 0)
                write(path, moved)
                told = json.loads(tan("verify", path.with_suffix(".tan"), "--against", path, "--lod", 0, "--json", status=1))
                self.assertTrue(any("does not lie where the original has point 31" in text for text in told["failures"]), told)


unittest.main()
