#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""volume_light.py BUILD: the light of rays through volumes, without shading, with it and with opacities by the gradient, as `tan render` draws it, judged by numpy, which cuts
each ray with every cell of the mesh that `tan extract` writes and follows docs/developer/tetrahedral-graphics.md, "The light of a ray through a volume".
Exit code 77: something is missing."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TAN = pathlib.Path(sys.argv.pop(1)).resolve() / "bin/tan"
SAMPLES = {"lattice": ("c60", 10, "data.nrrd"), "curvilinear": ("bent-duct", 8, "data.xyz"), "irregular": ("part", 8, "data.vtu")}
WIDTH, HEIGHT, RAYS = 96, 80, 150
BACKGROUND = (0x20, 0x40, 0x60)
STEPS = 16  # of a slab
TOLERANCES = {"unlit": 1, "lit": 1, "faded": 1}  # of 255
FULL_GRADIENT = 0.4  # of the longest
BESIDE = numpy.array([(0, 0), (0.002, 0), (-0.002, 0), (0, 0.002), (0, -0.002)])  # in pixels

# To the right, up and back of the camera.
SIDE_LIGHTS = [(0.45, numpy.array([-96, 72, 119]) / 169), (0.1, numpy.array([0.8, -0.36, 0.48])), (0.1, numpy.array([0.36, 0.8, -0.48]))]
HIGHLIGHT = numpy.array([-4, 3, 12]) / 13

# Values as shares of the range, unit distances as shares of the diagonal.
SMOOTH = {"unit": 0.05, "colours": [(0.05, (0.1, 0.2, 0.9)), (0.35, (0.2, 0.9, 0.3)), (0.6, (0.95, 0.85, 0.2)), (0.9, (0.9, 0.1, 0.6))],
          "opacities": [(0.08, 0), (0.3, 0.05), (0.55, 0.3), (0.83, 0.9), (0.97, 0.2)]}
STEPPED = {"unit": 0.04, "mask": (0.043, 0.937),
           "colours": [(0.1, (0.9, 0.8, 0.1)), (0.37, (0.3, 0.5, 0.95)), (0.37, (1, 0.25, 0.1)), (0.71, (0.3, 1, 0.4)), (0.71, (0.9, 0.9, 1))],
           "opacities": [(0.2, 0.01), (0.42, 0.06), (0.42, 0.7), (0.53, 0.6), (0.53, 0.03), (0.77, 0.1), (0.77, 0.97)]}
FUNCTIONS = {"smooth": SMOOTH, "stepped": STEPPED}

VIEWS = {"perspective": {"azimuth": 35, "elevation": 48, "roll": 10, "fieldOfView": 45, "perspective": True},
         "orthographic": {"azimuth": -160, "elevation": -40, "roll": 0, "fieldOfView": 30, "perspective": False}}


def tan(folder, *words):
    done = subprocess.run([str(TAN), *map(str, words), "--json"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return json.loads(done.stdout)


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def picture(path):
    """Rows from the top, channels red, green, blue."""
    image = read(vtkPNGReader(), path)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].astype(float)


def lengths(vectors):
    return numpy.linalg.norm(vectors, axis=-1)


class Mesh:
    """Of each cell what makes its four barycentric coordinates linear functions of the place; of each vertex the gradient for light."""

    def __init__(self, path):
        grid = read(vtkXMLUnstructuredGridReader(), path)
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        self.values = vtk_to_numpy(grid.GetPointData().GetArray(0)).astype(float)
        self.corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        self.places = self.points[self.corners]
        edges = (self.places[:, 1:] - self.places[:, :1]).transpose(0, 2, 1)
        self.volumes = numpy.abs(numpy.linalg.det(edges)) / 6
        three = numpy.linalg.inv(edges)
        self.slopes = numpy.concatenate([-three.sum(axis=1, keepdims=True), three], axis=1)
        self.centres = self.places.mean(axis=1)
        self.radii = lengths(self.places - self.centres[:, None]).max(axis=1)
        self.box = numpy.array([self.points.min(axis=0), self.points.max(axis=0)])
        self.diagonal = lengths(self.box[1] - self.box[0])
        self.gradients = self.vertex_gradients()

    def vertex_gradients(self):
        """Means of those of the cells, weighted by volume; the longest has the length 1."""
        of_cells = numpy.einsum("cki,ck->ci", self.slopes, self.values[self.corners])
        sums, weights = numpy.zeros_like(self.points), numpy.zeros(len(self.points))
        for corner in self.corners.T:
            numpy.add.at(sums, corner, of_cells * self.volumes[:, None])
            numpy.add.at(weights, corner, self.volumes)
        means = sums / numpy.maximum(weights, 1e-300)[:, None]
        self.longest = lengths(means).max()
        return means / self.longest

    def corner_gradients(self, axes):
        """Those of the corners of each cell; of cells that are too thin in the view of these axes their mean, four times."""
        gradients = self.gradients[self.corners]
        thin = 6 * self.volumes <= 1e-5 * numpy.ptp(self.places @ axes.T, axis=1).prod(axis=1)
        gradients[thin] = gradients[thin].mean(axis=1, keepdims=True)
        return gradients


class Camera:
    """At the azimuth and the elevation 0 it looks along y, with x to the right and z up; the azimuth turns the eye towards x, the elevation
    towards z, and the roll the picture clockwise. The field of view is that of the height, for parallel rays at the target."""

    def __init__(self, view, mesh):
        turn, rise, roll = numpy.radians([view["azimuth"], view["elevation"], view["roll"]])
        half = 0.33 * mesh.diagonal
        self.reach = numpy.tan(numpy.radians(view["fieldOfView"] / 2))
        self.target = mesh.box.mean(axis=0)
        self.settings = {**view, "target": list(self.target), "distance": half / self.reach}
        forward = numpy.array([-numpy.sin(turn) * numpy.cos(rise), numpy.cos(turn) * numpy.cos(rise), -numpy.sin(rise)])
        right = numpy.array([numpy.cos(turn), numpy.sin(turn), 0])
        up = numpy.cross(right, forward)
        self.axes = numpy.array([numpy.cos(roll) * right + numpy.sin(roll) * up, numpy.cos(roll) * up - numpy.sin(roll) * right, forward])

    def rays(self, columns, rows):
        """Origins and directions of length 1 of the samples of pixels."""
        right, up, forward = self.axes
        distance = self.settings["distance"]
        x = (columns + 0.5 + 0.00137 - WIDTH / 2) / (HEIGHT / 2) * self.reach
        y = (HEIGHT / 2 - rows - 0.5 - 0.00211) / (HEIGHT / 2) * self.reach
        beside, eye = x[:, None] * right + y[:, None] * up, self.target - distance * forward
        if self.settings["perspective"]:
            directions = forward + beside
            return numpy.broadcast_to(eye, directions.shape), directions / lengths(directions)[:, None]
        return eye + distance * beside, numpy.broadcast_to(forward, beside.shape)


class Function:
    """A transfer function: colours and extinctions between and at its points."""

    def __init__(self, shares, mesh):
        least, reach = mesh.values.min(), numpy.ptp(mesh.values)
        colours = [(least + share * reach, colour) for share, colour in shares["colours"]]
        opacities = [(least + share * reach, opacity) for share, opacity in shares["opacities"]]
        unit = shares["unit"] * mesh.diagonal
        self.mask = [least + share * reach for share in shares.get("mask", (-1, 2))]
        self.text = json.dumps({"format": "tan-transfer-function", "version": 2, "unitDistance": unit,
                                "mask": {"least": self.mask[0], "largest": self.mask[1]},
                                "colours": [{"value": value, "colour": colour} for value, colour in colours],
                                "opacities": [{"value": value, "opacity": opacity} for value, opacity in opacities]})
        self.colour_at, self.colours = (numpy.array(list(column), dtype=float) for column in zip(*colours))
        self.extinction_at, opacity = (numpy.array(column) for column in zip(*opacities))
        self.extinctions = -numpy.log(1 - opacity) / unit
        self.borders = numpy.unique(numpy.concatenate([self.colour_at, self.extinction_at, self.mask]))

    @staticmethod
    def curve(places, heights, middles, values):
        """Of the piece of the curve that has the middle of a slab, the heights at values of this slab."""
        piece = numpy.searchsorted(places, middles, side="right")
        below, above = numpy.maximum(piece - 1, 0), numpy.minimum(piece, len(places) - 1)
        spans = places[above] - places[below]
        shares = numpy.where(spans > 0, (values - places[below]) / numpy.where(spans > 0, spans, 1), 0)
        shares = shares if heights.ndim == 1 else shares[:, None]
        return heights[below] + shares * (heights[above] - heights[below])

    def colour(self, middles, values):
        return self.curve(self.colour_at, self.colours, middles, values)

    def extinction(self, middles, values):
        seen = (middles >= self.mask[0]) & (middles <= self.mask[1])
        return numpy.where(seen, self.curve(self.extinction_at, self.extinctions, middles, values), 0)


class Pieces:
    """Of rays, in cells, front to back for each ray: where they begin and end, and the value, the light and the share of the extinction there."""

    def __init__(self, mesh, axes, origins, directions):
        along = mesh.centres @ directions.T - (origins * directions).sum(axis=1)
        squares = (mesh.centres**2).sum(axis=1)[:, None] - 2 * mesh.centres @ origins.T + (origins**2).sum(axis=1)
        cell, ray = numpy.nonzero(squares - along**2 <= 1.001 * mesh.radii[:, None] ** 2 + 1e-9 * mesh.diagonal**2)
        at = numpy.einsum("cki,ci->ck", mesh.slopes[cell], origins[ray] - mesh.places[cell, 0]) + numpy.array([1, 0, 0, 0])
        change = numpy.einsum("cki,ci->ck", mesh.slopes[cell], directions[ray])
        with numpy.errstate(divide="ignore", invalid="ignore"):
            zero = -at / change
        begin = numpy.maximum(numpy.where(change > 0, zero, -numpy.inf).max(axis=1), 0)
        end = numpy.where(change < 0, zero, numpy.inf).min(axis=1)
        passed = numpy.flatnonzero((begin < end) & ~((change == 0) & (at < 0)).any(axis=1))
        passed = passed[numpy.lexsort(((begin + end)[passed], ray[passed]))]
        cell, self.ray, begin, end, at, change = cell[passed], ray[passed], begin[passed], end[passed], at[passed], change[passed]
        self.rays, self.lengths = len(directions), end - begin
        shares = [at + place[:, None] * change for place in (begin, end)]
        self.values = [(share * mesh.values[mesh.corners[cell]]).sum(axis=1) for share in shares]
        gradients = mesh.corner_gradients(axes)[cell]
        self.lights = [self.light(numpy.einsum("pk,pki->pi", share, gradients), directions[self.ray], axes) for share in shares]

    @staticmethod
    def light(gradients, directions, axes):
        """Factor, highlight, and the share of the extinction."""
        size = lengths(gradients)
        known = size >= 1e-6
        normals = gradients / numpy.where(known, size, 1)[:, None]
        cosine = (normals * directions).sum(axis=1)
        right, up, forward = axes
        towards_eye = numpy.where(cosine > 0, -1, 1)[:, None] * normals @ numpy.array([right, up, -forward]).T
        front = numpy.minimum(1, 0.5 + 2 * numpy.abs(cosine))
        falls = [(strength, towards_eye @ place) for strength, place in SIDE_LIGHTS]
        factor = 0.08 + 0.52 * numpy.abs(cosine) + sum(strength * (front * numpy.maximum(0, fall) + (1 - front) * numpy.maximum(0, -fall))
                                                       for strength, fall in falls)
        light = numpy.where(known, [factor, 0.18 * numpy.maximum(0, towards_eye @ HIGHLIGHT) ** 32], [[1.0], [0.0]])
        return numpy.stack([*light, numpy.minimum(1, size / FULL_GRADIENT)])

    def seen(self, function, name):
        """The colours, from 0 to 1, at the eye."""
        first, last = self.values
        with numpy.errstate(divide="ignore", invalid="ignore"):
            cuts = (function.borders - first[:, None]) / (last - first)[:, None]
        cuts = numpy.clip(numpy.nan_to_num(cuts, nan=0, posinf=0, neginf=0), 0, 1)
        cuts = numpy.sort(numpy.concatenate([cuts, numpy.zeros((len(cuts), 1)), numpy.ones((len(cuts), 1))], axis=1), axis=1)
        piece, slab = numpy.nonzero(cuts[:, 1:] > cuts[:, :-1])
        ends = [cuts[piece, slab], cuts[piece, slab + 1]]
        values = [first[piece] + end * (last - first)[piece] for end in ends]
        middles = (values[0] + values[1]) / 2
        extinctions = [function.extinction(middles, value) for value in values]
        colours = [function.colour(middles, value) for value in values]
        lights = [self.lights[0][:, piece] + end * (self.lights[1] - self.lights[0])[:, piece] for end in ends]
        if name != "unlit":
            colours = [numpy.minimum(1, colour * factor[:, None] + highlight[:, None]) for colour, (factor, highlight, _) in zip(colours, lights)]
        if name == "faded":
            extinctions = [extinction * (lights[0][2] + lights[1][2]) / 2 for extinction in extinctions]
        return self.sum(self.ray[piece], self.lengths[piece] * (ends[1] - ends[0]), extinctions, colours)

    def sum(self, ray, length, extinctions, colours):
        """Each slab in steps of one extinction, its mean there, which are exact in themselves."""
        shares = (numpy.arange(STEPS) + 0.5) / STEPS
        depths = (extinctions[0][:, None] + shares * (extinctions[1] - extinctions[0])[:, None]) * length[:, None] / STEPS
        before = numpy.cumsum(depths).reshape(depths.shape) - depths
        starts = numpy.searchsorted(ray, ray)
        transmitted = numpy.exp(before[starts, :1] - before)
        absorbed = -numpy.expm1(-depths)
        towards_end = numpy.where(depths > 1e-6, absorbed / numpy.where(depths > 1e-6, depths, 1) - numpy.exp(-depths), depths / 2)
        later = absorbed * (shares - 0.5 / STEPS) + towards_end / STEPS
        weights = [(transmitted * (absorbed - later)).sum(axis=1), (transmitted * later).sum(axis=1)]
        light = weights[0][:, None] * colours[0] + weights[1][:, None] * colours[1]
        left = numpy.exp(-numpy.bincount(ray, depths.sum(axis=1), self.rays))
        summed = numpy.stack([numpy.bincount(ray, channel, self.rays) for channel in light.T], axis=1)
        return summed + left[:, None] * numpy.array(BACKGROUND) / 255


class Tally:
    """What all rays of a kind of picture came to."""

    def __init__(self):
        self.rays, self.doubtful, self.largest, self.by_light = 0, 0, 0.0, 0.0


class LightTest(unittest.TestCase):
    """Compares pictures with what is seen of pieces of rays."""

    tolerances, pieces, options, top, fewest = TOLERANCES, Pieces, (), 0, 250

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.random = numpy.random.default_rng(20240611)

    def pictures(self, mesh, camera, function):
        (self.folder / "camera.json").write_text(json.dumps(camera.settings))
        (self.folder / "function.json").write_text(function.text)
        for name, more in (("unlit", ("--no-shaded",)), ("lit", ("--shaded",)), ("faded", ("--shaded", "--full-gradient", repr(float(FULL_GRADIENT * mesh.longest))))):
            tan(self.folder, "render", "model.tan", "--error", 2, "--mode", "volume", "--transfer", "function.json", "--camera", "camera.json", "--size",
                f"{WIDTH}x{HEIGHT}", "--samples", 1, "--background", "#" + bytes(BACKGROUND).hex(), "--no-outline", *self.options, *more, "-o",
                f"{name}.png")
        return {name: picture(self.folder / f"{name}.png") for name in self.tolerances}

    def compare(self, mesh, camera, function, tallies, what):
        drawn = self.pictures(mesh, camera, function)
        for name, other in (("lit", "unlit"), ("faded", "lit")):
            tallies[name].by_light = max(tallies[name].by_light, numpy.abs(drawn[name] - drawn[other]).max())
        columns, rows = self.random.integers(WIDTH, size=RAYS), self.random.integers(self.top, HEIGHT, size=RAYS)
        places = (numpy.stack([columns, rows], axis=1)[:, None] + BESIDE).reshape(-1, 2)
        pieces = self.pieces(mesh, camera.axes, *camera.rays(*places.T))
        meets = numpy.isin(numpy.arange(RAYS), pieces.ray // len(BESIDE))
        for name, tolerance in self.tolerances.items():
            expected = 255 * pieces.seen(function, name).reshape(RAYS, len(BESIDE), 3)
            doubtful = numpy.abs(expected[:, 1:] - expected[:, :1]).max(axis=(1, 2)) > tolerance / 2
            off = numpy.where(doubtful, 0, numpy.abs(drawn[name][rows, columns] - expected[:, 0]).max(axis=1))
            worst, tally = off.argmax(), tallies[name]
            tally.rays, tally.doubtful, tally.largest = tally.rays + meets.sum(), tally.doubtful + doubtful.sum(), max(tally.largest, off[worst])
            with self.subTest(what, light=name):
                self.assertLessEqual(off[worst], tolerance, f"at {columns[worst]}, {rows[worst]}: {expected[worst, 0]}")

    def compare_all(self, mesh, kind):
        tallies = {name: Tally() for name in self.tolerances}
        for view in VIEWS:
            for function in FUNCTIONS:
                self.compare(mesh, Camera(VIEWS[view], mesh), Function(FUNCTIONS[function], mesh), tallies, f"{kind}, {view}, {function}")
        for name, tally in tallies.items():
            print(f"{kind}, {name}: {tally.rays} rays through the volume, off by {tally.largest:.2f} of 255 at most, {tally.doubtful} doubtful")
            self.assertGreater(tally.rays, self.fewest)
            self.assertLess(tally.doubtful, 0.05 * tally.rays)
        for name in ("lit", "faded"):
            self.assertGreater(tallies[name].by_light, 20)


class VolumeLight(LightTest):
    def check(self, kind):
        sample, size, data = SAMPLES[kind]
        self.folder = pathlib.Path(self.kept.name) / kind
        self.folder.mkdir()
        tan(self.folder, "sample", sample, "--size", size, "-o", data)
        tan(self.folder, "build", data, "-o", "model.tan")
        tan(self.folder, "extract", "model.tan", "--error", 2, "-o", "mesh.vtu")
        mesh = Mesh(self.folder / "mesh.vtu")
        self.compare_all(mesh, kind)

    def test_lattices(self):
        self.check("lattice")

    def test_curvilinear_grids(self):
        self.check("curvilinear")

    def test_irregular_meshes(self):
        self.check("irregular")


if __name__ == "__main__":
    unittest.main()
