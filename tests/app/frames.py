#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""frames.py BUILD [LATTICES [SEED]]: lattices in any frame (mirrored, exchanged, turned, sheared, tiny, huge, far away) are where their files
say. Judged by numpy from the meshes that TAn writes: the vertices are the samples' places with their values, every tetrahedron is positive,
together they fill the domain, boundaries point outwards, whether the model was refined as a whole, in blocks or decimated, and whether it is
explicit, packed, at an address or left at a server; windows, focuses, budgets and clip planes are those of the world. ./dev soak (TAN_SOAK) takes
more lattices, each time others. Exit code 77: something is missing."""
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
TAN = BUILD / "bin/tan"
SOAK = os.environ.get("TAN_SOAK")
LATTICES = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 96 if SOAK else 8
SEED = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else int(SOAK or 20260728)

METHODS = {"whole": ("--builder", "refinement", "--block", "none"), "blocks": ("--builder", "refinement", "--block", "3"),
           "decimated": ("--builder", "decimation")}
SIGNED_PERMUTATIONS = [numpy.array([[sign if row == at else 0.0 for row in range(3)] for at, sign in zip(order, signs)]).T
                       for order in itertools.permutations(range(3)) for signs in itertools.product((1.0, -1.0), repeat=3)]


def run(*words, folder=None, code=0):
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    assert done.returncode == code, f"{words}: {done.returncode} {done.stdout}{done.stderr}"
    return done.stdout + done.stderr if code else done.stdout


class Frame:
    """Sample (i, j, k) lies at origin + steps (i, j, k); values are random, so that every sample is a site."""

    def __init__(self, random, number):
        kinds = ("exchanged", "turned", "exchanged", "sheared")
        self.kind = kinds[number % 4]
        self.size = random.integers(3, 8, 3)
        lengths = 10.0 ** random.uniform(-9, 9) * random.choice((1.0, 0.5, 1.3, 3.0), 3)
        if self.kind == "exchanged":
            directions = SIGNED_PERMUTATIONS[number // 2 * 7 % 48]
        else:
            directions, upper = numpy.linalg.qr(random.normal(size=(3, 3)))
            if self.kind == "sheared":
                directions = directions @ numpy.array([[1, random.uniform(-.6, .6), random.uniform(-.6, .6)], [0, 1, random.uniform(-.6, .6)], [0, 0, 1]])
        self.steps = directions / numpy.linalg.norm(directions, axis=0) * lengths
        # As far as the places of neighbours still differ by a thousand units in the last place.
        farthest = min(1e9, lengths.min() * 1e12)
        self.origin = random.choice((0.0, 1.0)) * random.uniform(-1, 1, 3) * farthest
        # Not whole numbers: some of these lie in the middle of others, so that their samples are never off.
        self.values = (100 * random.normal(size=self.size)).astype("<f4")
        self.values += 10 * self.values.std() * (numpy.indices(self.size).sum(axis=0) / self.size.sum()).astype("<f4")

    @property
    def step(self):
        return numpy.linalg.norm(self.steps, axis=0).min()

    def write(self, path, space="left-posterior-superior"):
        vector = lambda numbers: "(" + ",".join(repr(float(number)) for number in numbers) + ")"
        head = (f"NRRD0004\ntype: float\ndimension: 3\nspace: {space}\nsizes: {' '.join(map(str, self.size))}\n"
                f"space directions: {' '.join(vector(step) for step in self.steps.T)}\nspace origin: {vector(self.origin)}\n"
                "encoding: raw\nendian: little\n\n")
        path.write_bytes(head.encode() + self.values.transpose(2, 1, 0).tobytes())

    def places(self):
        """Of all samples, the first index running fastest."""
        indices = numpy.indices(self.size).reshape(3, -1)
        return self.origin + (self.steps @ indices).T

    def indices(self, points):
        """Of places in the world, which are to be those of samples: how far they are from that, in steps, too."""
        exact = numpy.linalg.solve(self.steps, (points - self.origin).T).T
        rounded = numpy.rint(exact)
        slack = 1e-9 + 16 * numpy.finfo(float).eps * numpy.abs(self.origin).max() / self.step
        return rounded.astype(int), numpy.abs(exact - rounded).max() / slack


def volumes(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, corner]] for corner in range(4))
    return numpy.einsum("ij,ij->i", b - a, numpy.cross(c - a, d - a)) / 6


def cells(mesh, kind):
    return numpy.concatenate([block.data for block in mesh.cells if block.type == kind] or [numpy.zeros((0, 4), int)]).astype(int)


class Frames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.models = cls.folder / "models"
        cls.models.mkdir()
        cls.server = subprocess.Popen([TAN, "serve", cls.models, "--port", "0"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        cls.addClassCleanup(cls.server.wait)
        cls.addClassCleanup(cls.server.terminate)
        cls.address = None
        for line in cls.server.stderr:
            if found := re.search(r"http://127\.0\.0\.1:\d+/", line):
                cls.address = found[0]
                break
        cls.random = numpy.random.default_rng(SEED)
        print(f"seed {SEED}, {LATTICES} lattices")
        cls.frames = [Frame(cls.random, number) for number in range(LATTICES)]
        for number, frame in enumerate(cls.frames):
            frame.write(cls.folder / f"{number}.nrrd")

    def built(self, number, method):
        path = self.models / f"{number}-{method}.tan"
        if not path.exists():
            run(TAN, "build", self.folder / f"{number}.nrrd", "-o", path, *METHODS[method])
        return path

    def mesh(self, model, *words, name="mesh.vtu"):
        told = json.loads(run(TAN, "extract", model, *words, "-o", self.folder / name, "--json"))
        return meshio.read(self.folder / name), told

    def judge(self, frame, mesh, told, whole):
        """The mesh of samples in their places: a subset of them, all of them at error 0."""
        points = mesh.points.astype(float)
        self.assertEqual((len(points), len(cells(mesh, "tetra"))), (told["sites"], told["tetrahedra"]))
        indices, off = frame.indices(points)
        self.assertLess(off, 1)
        self.assertTrue(((indices >= 0) & (indices < frame.size)).all())
        self.assertEqual(len(numpy.unique(indices, axis=0)), len(points))
        self.assertTrue((mesh.point_data[next(iter(mesh.point_data))].ravel() == frame.values[tuple(indices.T)]).all())
        if whole:
            self.assertEqual(len(points), frame.size.prod())
        each = volumes(points - points[0], cells(mesh, "tetra"))
        self.assertGreater(each.min(), 0)
        box = abs(numpy.linalg.det(frame.steps)) * (frame.size - 1).prod()
        self.assertAlmostEqual(each.sum() / box, 1, delta=1e-6 + 1e3 * numpy.finfo(float).eps * numpy.abs(frame.origin).max() / frame.step)

    def test_every_way_to_a_mesh(self):
        for number, frame in enumerate(self.frames):
            for method in METHODS:
                model = self.built(number, method)
                packed = self.models / f"{number}-{method}.packed.tan"
                run(TAN, "pack", model, "-o", packed)
                run(TAN, "unpack", packed, "-o", self.folder / "again.tan")
                with self.subTest(number=number, kind=frame.kind, method=method):
                    self.assertEqual((self.folder / "again.tan").read_bytes(), model.read_bytes())
                    ways = {"explicit": (model,), "packed": (packed,), "address": (self.address + model.name,),
                            "server": (self.address + model.name, "--at-server")}
                    error = ("--error", "0") if number % 3 != 1 else ("--error", "20")
                    for way, words in ways.items():
                        with self.subTest(way=way):
                            mesh, told = self.mesh(*words, *error)
                            self.judge(frame, mesh, told, whole=number % 3 != 1)
                    run(TAN, "extract", model, *error, "-o", self.folder / "boundary.ply")
                    boundary = meshio.read(self.folder / "boundary.ply")
                    corners = (boundary.points.astype(float) - boundary.points[0].astype(float))[cells(boundary, "triangle")]
                    inside = numpy.einsum("ij,ij->i", corners[:, 0], numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6
                    self.assertAlmostEqual(inside / (abs(numpy.linalg.det(frame.steps)) * (frame.size - 1).prod()), 1, delta=1e-3)
                    self.assertIn("proved", run(TAN, "verify", model, "--against", self.folder / f"{number}.nrrd").lower())

    def test_same_history_in_every_frame(self):
        """But for the sections that say where the lattice lies, models are the same."""
        frame = Frame(self.random, 0)
        seen = {}
        for name, steps in (("plain", numpy.eye(3)), ("mirrored", numpy.diag((1.0, 1, -1))), ("exchanged", numpy.eye(3)[[2, 0, 1]]),
                            ("turned", numpy.linalg.qr(self.random.normal(size=(3, 3)))[0])):
            frame.steps, frame.origin = steps * numpy.array((0.5, 0.5, 1.5)), self.random.uniform(-9, 9, 3)
            frame.write(self.folder / f"{name}.nrrd")
            for method, words in METHODS.items():
                model = self.folder / f"{name}-{method}.tan"
                run(TAN, "build", self.folder / f"{name}.nrrd", "-o", model, *words)
                seen.setdefault(method, {})[name] = sections(model)
        for method, models in seen.items():
            plain = models["plain"]
            self.assertNotIn(9, set(plain))
            for name, found in models.items():
                if name == "plain":
                    continue
                self.assertEqual(set(found) - set(plain), {9}, name)
                for number in set(plain) - {1, 3}:  # the text names the file; chunk sums follow
                    self.assertEqual(found[number], plain[number], f"{method}, {name}: section {number}")

    def test_windows_and_focuses_of_the_world(self):
        """What lies in a box of the world, by brute force over the whole mesh; a focus keeps its error where it is asked for."""
        for number, frame in enumerate(self.frames):
            model = self.built(number, "whole")
            whole, _ = self.mesh(model, "--error", "0", name="whole.vtu")
            points, tetrahedra = whole.points.astype(float), cells(whole, "tetra")
            corners = frame.places()
            for _ in range(3):
                # Between two places of the domain, so that something lies within.
                between = self.random.uniform(0, 1, (2, 3)) * (frame.size - 1)
                ends = numpy.sort(frame.origin + between @ frame.steps.T, axis=0)
                text = ",".join(repr(float(end)) for end in ends.ravel())
                inside = ((points >= ends[0]) & (points <= ends[1])).all(axis=1)
                with self.subTest(number=number, kind=frame.kind, window=text):
                    mesh, _ = self.mesh(model, "--error", "0", "--window", text, "--border", "contained") if inside[tetrahedra].all(axis=1).any() \
                        else (None, None)
                    expected = {tuple(sorted(map(tuple, frame.indices(points[t])[0].tolist()))) for t in tetrahedra[inside[tetrahedra].all(axis=1)]}
                    found = set() if mesh is None else {tuple(sorted(map(tuple, frame.indices(mesh.points[t].astype(float))[0].tolist())))
                                                        for t in cells(mesh, "tetra")}
                    self.assertEqual(found, expected)
                    touching, _ = self.mesh(model, "--error", "0", "--window", text, "--border", "intersecting")
                    found = {tuple(sorted(map(tuple, frame.indices(touching.points[t].astype(float))[0].tolist()))) for t in cells(touching, "tetra")}
                    meets = meeting(points[tetrahedra], ends)
                    names = [tuple(sorted(map(tuple, frame.indices(points[t])[0].tolist()))) for t in tetrahedra]
                    for name, gap in zip(names, meets / frame.step):
                        if abs(gap) > 1e-6 + 1e4 * numpy.finfo(float).eps * numpy.abs(frame.origin).max() / frame.step:
                            self.assertEqual(name in found, gap < 0, f"a gap of {gap} steps")
                    clipped, _ = self.mesh(model, "--error", "0", "--window", text, "--border", "clipped")
                    volume = volumes(clipped.points.astype(float) - ends[0], cells(clipped, "tetra"))
                    self.assertAlmostEqual(volume.sum() / self.volume_within(frame, ends), 1, delta=0.03)
            for method in ("closed-set", "insertion"):
                centre, radius = corners[self.random.integers(len(corners))], 2.2 * frame.step
                text = "sphere:" + ",".join(repr(float(c)) for c in centre) + f",{radius!r}"
                with self.subTest(number=number, kind=frame.kind, focus=text, method=method):
                    mesh, told = self.mesh(model, "--error", "30", "--focus", text, "--focus-error", "0", "--method", method)
                    self.judge(frame, mesh, told, whole=False)
                    # Nothing is off in the focus, so each sample there is a vertex: values are random.
                    distance = numpy.linalg.norm(corners - centre, axis=1)
                    wanted = {tuple(index) for index in frame.indices(corners[distance < radius * (1 - 1e-6)])[0].tolist()}
                    found = {tuple(index) for index in frame.indices(mesh.points.astype(float))[0].tolist()}
                    self.assertLessEqual(wanted, found)
                    run(TAN, "verify", model, "--against", self.folder / f"{number}.nrrd", "--error", "30", "--focus", text, "--focus-error", "0",
                        "--method", method)

    def test_budgets(self):
        """The finest mesh of one error within a number of tetrahedra: the next finer one of the history has more."""
        for number, frame in enumerate(self.frames):
            model = self.built(number, "whole")
            _, finest = self.mesh(model, "--error", "0", name="finest.vtu")
            budget = int(finest["tetrahedra"] * self.random.uniform(0.05, 0.9))
            with self.subTest(number=number, kind=frame.kind, budget=budget):
                mesh, told = self.mesh(model, "--budget", budget)
                self.judge(frame, mesh, told, whole=False)
                self.assertLessEqual(told["tetrahedra"], budget)
                same, _ = self.mesh(model, "--error", repr(told["reached_error"] * (1 + 1e-9)), name="same.vtu")
                self.assertEqual({tuple(p) for p in same.points}, {tuple(p) for p in mesh.points})
                _, finer = self.mesh(model, "--error", repr(told["reached_error"] * (1 - 1e-9)), name="finer.vtu")
                self.assertGreater(finer["tetrahedra"], budget)

    def test_clip_planes_of_the_world(self):
        """The samples of one ball, stored in any order, are one picture, cut by one plane."""
        size, step, centre = 13, 0.5, numpy.array((7.0, -2.0, 5.0))
        pictures = []
        for directions in SIGNED_PERMUTATIONS if SOAK else SIGNED_PERMUTATIONS[::7]:
            frame = Frame(self.random, 0)
            frame.size, frame.steps = numpy.array((size,) * 3), directions * step
            frame.origin = centre - frame.steps @ ((frame.size - 1) / 2)
            # As far from the middle along each axis of the world as it is, and flatter along y than along x.
            away = (frame.places() - centre) * (1.0, 1.6, 1.2)
            frame.values = (2.2 - numpy.linalg.norm(away, axis=1)).astype("<f4").reshape(frame.size)
            frame.write(self.folder / "ball.nrrd")
            run(TAN, "build", self.folder / "ball.nrrd", "-o", self.folder / "clipped.tan")
            run(TAN, "render", self.folder / "clipped.tan", "--isovalue", "0.3", "--clip", "1,0.5,-0.25,4.5", "--size", "80x60", "--backend", "cpu",
                "-o", self.folder / "clipped.png")
            pictures.append(pixels(self.folder / "clipped.png"))
        run(TAN, "render", self.folder / "clipped.tan", "--isovalue", "0.3", "--size", "80x60", "--backend", "cpu", "-o", self.folder / "whole.png")
        seen = (numpy.abs(pixels(self.folder / "whole.png") - pictures[-1]).max(axis=1) > 8).mean()
        self.assertGreater(seen, 0.015, "the plane cuts nothing away")
        for number, picture in enumerate(pictures[1:]):
            differs = (numpy.abs(picture - pictures[0]).max(axis=1) > 40).mean()
            self.assertLess(differs, 0.01, f"frame {number + 1}: {differs}")

    def volume_within(self, frame, ends):
        """Of the lattice's domain within a box of the world: half-spaces cut the box, one after the other, by a count of small cubes."""
        fine = 90
        axes = [ends[0][axis] + (ends[1] - ends[0])[axis] * (numpy.arange(fine) + .5) / fine for axis in range(3)]
        places = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
        at = numpy.linalg.solve(frame.steps, (places - frame.origin).T).T
        share = ((at >= 0) & (at <= frame.size - 1)).all(axis=1).mean()
        return max(share, 1e-300) * (ends[1] - ends[0]).prod()

    def test_surfaces_face_outwards(self):
        """A ball of the world, in a mirrored lattice and in its mirror image."""
        for directions in (SIGNED_PERMUTATIONS[0], SIGNED_PERMUTATIONS[1], SIGNED_PERMUTATIONS[11]):
            frame = Frame(self.random, 0)
            frame.size, frame.steps, frame.origin = numpy.array((13, 13, 13)), directions * 0.5, -3.0 * directions.sum(axis=1) + (7, -2, 5)
            depth = 2.2 - numpy.linalg.norm(frame.places() - (7, -2, 5), axis=1)
            frame.values = depth.astype("<f4").reshape(frame.size)
            frame.write(self.folder / "ball.nrrd")
            run(TAN, "build", self.folder / "ball.nrrd", "-o", self.folder / "ball.tan")
            run(TAN, "isosurface", self.folder / "ball.tan", "--value", "0", "--error", "0", "-o", self.folder / "ball.ply")
            ball = meshio.read(self.folder / "ball.ply")
            corners = (ball.points.astype(float) - (7, -2, 5))[cells(ball, "triangle")]
            volume = numpy.einsum("ij,ij->i", corners[:, 0], numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6
            self.assertAlmostEqual(volume / (4 / 3 * math.pi * 2.2 ** 3), 1, delta=0.04)
            self.assertLess(abs(numpy.linalg.norm(ball.points - (7, -2, 5), axis=1) - 2.2).max(), 0.05)

    def test_a_place_that_is_set_later(self):
        """Of data without a spacing: the same mesh at the right places; packed in as few bytes, and points still enter it."""
        frame = Frame(self.random, 0)
        frame.size, frame.steps, frame.origin = numpy.array((9, 8, 11)), numpy.eye(3), numpy.zeros(3)
        frame.values = self.random.normal(size=frame.size).astype("<f4")
        frame.write(self.folder / "bare.nrrd")
        for method in METHODS:
            bare, placed = self.folder / f"bare-{method}.tan", self.folder / f"placed-{method}.tan"
            run(TAN, "build", self.folder / "bare.nrrd", "-o", bare, *METHODS[method])
            told = json.loads(run(TAN, "set-frame", bare, "--spacing", "0.5,0.5,4", "--origin", "10,-20,30", "--unit", "mm", "-o", placed, "--json"))
            self.assertEqual((told["spacing"], told["origin"], told["unit"]), ([0.5, 0.5, 4], [10, -20, 30], "mm"))
            moved = Frame(self.random, 0)
            moved.size, moved.values, moved.steps, moved.origin = frame.size, frame.values, numpy.diag((0.5, 0.5, 4)), numpy.array((10, -20, 30))
            mesh, said = self.mesh(placed, "--error", "0")
            self.judge(moved, mesh, said, whole=True)
            before, _ = self.mesh(bare, "--error", "0", name="before.vtu")
            self.assertTrue((cells(mesh, "tetra") == cells(before, "tetra")).all())
            run(TAN, "verify", placed, "--against", self.folder / "bare.nrrd")
            # A unit alone moves nothing, so that older programs still open the model, and weights at places stay right.
            measured = self.folder / "measured.tan"
            run(TAN, "set-frame", bare, "--unit", "mm", "-o", measured)
            self.assertNotIn(10, set(sections(measured)))
            self.assertEqual(json.loads(run(TAN, "info", measured, "--json"))["unit"], "mm")
            sizes = []
            for model in (bare, placed):
                run(TAN, "pack", model, "-o", self.folder / "p.tan")
                run(TAN, "unpack", self.folder / "p.tan", "-o", self.folder / "u.tan")
                self.assertEqual((self.folder / "u.tan").read_bytes(), model.read_bytes())
                sizes.append((self.folder / "p.tan").stat().st_size)
            self.assertLess(sizes[1], sizes[0] + 400)
            if method != "decimated":
                focus = ("--error", "30", "--focus", "box:10,-20,30,12,-18,50", "--focus-error", "0", "--method", "insertion")
                mesh, said = self.mesh(placed, *focus)
                self.judge(moved, mesh, said, whole=False)
                run(TAN, "verify", placed, "--against", self.folder / "bare.nrrd", *focus)

    def test_what_an_older_program_says(self):
        """A lattice that does not lie along the axes needs the section that says so; frames without a volume are refused."""
        model = self.built(1, "whole")
        entry = next(part for part in table(model) if part[0] == 9)
        self.assertEqual(entry[1], 1)
        self.assertLess(entry[2], 16384)
        flat = Frame(self.random, 1)
        flat.steps[:, 2] = flat.steps[:, 0] + flat.steps[:, 1]
        flat.write(self.folder / "flat.nrrd")
        self.assertIn("plane", run(TAN, "build", self.folder / "flat.nrrd", "-o", self.folder / "flat.tan", code=3))


def meeting(tetrahedra, ends):
    """The widest gap between each tetrahedron and the box along the directions that can part them; below 0 where they meet."""
    corners = numpy.stack(numpy.meshgrid(*ends.T, indexing="ij"), axis=-1).reshape(-1, 3)
    middle = ends.mean(axis=0)
    widest = numpy.full(len(tetrahedra), -numpy.inf)
    edges = [tetrahedra[:, b] - tetrahedra[:, a] for a, b in itertools.combinations(range(4), 2)]
    faces = [numpy.cross(tetrahedra[:, b] - tetrahedra[:, a], tetrahedra[:, c] - tetrahedra[:, a]) for a, b, c in itertools.combinations(range(4), 3)]
    directions = [numpy.tile(axis, (len(tetrahedra), 1)) for axis in numpy.eye(3)] + faces
    directions += [numpy.cross(edge, axis) for edge in edges for axis in numpy.eye(3)]
    for direction in directions:
        length = numpy.linalg.norm(direction, axis=1, keepdims=True)
        unit = direction / numpy.where(length > 0, length, 1)
        ofOne = numpy.einsum("nci,ni->nc", tetrahedra - middle, unit)
        ofBox = (corners - middle) @ unit.T
        gap = numpy.maximum(ofOne.min(axis=1) - ofBox.max(axis=0), ofBox.min(axis=0) - ofOne.max(axis=1))
        widest = numpy.where(length[:, 0] > 1e-12 * length.max(), numpy.maximum(widest, gap), widest)
    return widest


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


def table(path):
    """(id, flags, offset, bytes) of each section."""
    data = path.read_bytes()
    count = int.from_bytes(data[20:24], "little")
    entry = lambda at, begin, size: int.from_bytes(data[256 + 64 * at + begin:256 + 64 * at + begin + size], "little")
    return [(entry(at, 0, 4), entry(at, 4, 4), entry(at, 16, 8), entry(at, 24, 8)) for at in range(count)]


def sections(path):
    data = path.read_bytes()
    return {number: data[offset:offset + size] for number, _, offset, size in table(path)}


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
