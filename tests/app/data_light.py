#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""data_light.py BUILD: the samples of lattices as `tan render --show data` draws them, judged by numpy, which takes the trilinear field in small
steps along each ray and follows docs/developer/tetrahedral-graphics.md, "The data beside the mesh"; what a difference is of two pictures; when
the samples are refused. Exit code 77: something is missing."""
import pathlib
import subprocess
import unittest

import numpy
import volume_light as judged

STEPS = 24  # of a cell
CASES = {  # type, spacings, and the axes of the lattice as rows
    "bytes": (numpy.uint8, (1, 1, 1), numpy.eye(3)),
    "16 bits, thick slices": (numpy.int16, (0.5, 0.6, 1.7), numpy.eye(3)),
    "floats, turned": (numpy.float32, (1, 1.3, 0.8), numpy.array([(0.8, 0.6, 0), (-0.48, 0.64, 0.6), (0.36, -0.48, 0.8)])),
    "doubles, mirrored": (numpy.float64, (1, 1, 1.2), numpy.diag([-1, 1, 1])),
}


class Samples:
    """values[k, j, i] at the places of a lattice."""

    def __init__(self, values, steps):
        self.values, self.steps = values.astype(float), steps
        self.size = numpy.array(values.shape[::-1])
        corners = numpy.array(numpy.meshgrid(*[(0, n - 1) for n in self.size])).reshape(3, -1).T @ steps
        self.box = numpy.array([corners.min(axis=0), corners.max(axis=0)])
        self.diagonal = judged.lengths(self.box[1] - self.box[0])
        along = [numpy.gradient(self.values, axis=axis) for axis in (2, 1, 0)]
        for axis, gradient in zip((2, 1, 0), along):  # one-sided at the border, as numpy does, and central elsewhere
            assert gradient.shape == values.shape, axis
        self.gradients = numpy.stack(along, axis=-1) @ numpy.linalg.inv(steps).T
        self.longest = judged.lengths(self.gradients).max()
        self.gradients /= self.longest

    def at(self, field, places):
        """A field of the samples, trilinear between them, at places in steps of the indices."""
        places = numpy.clip(places, 0, self.size - 1)
        first = numpy.minimum(places.astype(int), self.size - 2)
        share = places - first
        total = 0
        for corner in numpy.ndindex(2, 2, 2):
            weight = numpy.prod(numpy.where(corner, share, 1 - share), axis=-1)
            i, j, k = (first + corner).T
            of_corner = field[k, j, i]
            total = total + (weight if of_corner.ndim == 1 else weight[:, None]) * of_corner
        return total


class SampledPieces(judged.Pieces):
    """Of rays, in small steps: where they begin and end, and the value and the light there."""

    def __init__(self, samples, axes, origins, directions):
        inverse = numpy.linalg.inv(samples.steps)
        at, along = origins @ inverse, directions @ inverse
        with numpy.errstate(divide="ignore", invalid="ignore"):
            ends = numpy.stack([-at / along, (samples.size - 1 - at) / along])
        begin, end = numpy.maximum(ends.min(axis=0).max(axis=1), 0), ends.max(axis=0).min(axis=1)
        self.rays = len(directions)
        meets = numpy.flatnonzero(begin < end)
        count = numpy.ceil((end - begin)[meets] * numpy.abs(along[meets]).max(axis=1) * STEPS).astype(int)
        self.ray = numpy.repeat(meets, count)
        number = numpy.arange(count.sum()) - numpy.repeat(numpy.cumsum(count) - count, count)
        step = numpy.repeat((end - begin)[meets] / count, count)
        first = begin[self.ray] + number * step
        self.lengths, self.values, self.lights = step, [], []
        for place in (first, first + step):
            here = at[self.ray] + place[:, None] * along[self.ray]
            self.values.append(samples.at(samples.values, here))
            self.lights.append(self.light(samples.at(samples.gradients, here), directions[self.ray], axes))


def write_nrrd(path, values, steps):
    types = {numpy.uint8: "uint8", numpy.int16: "int16", numpy.float32: "float", numpy.float64: "double"}
    vectors = " ".join("(" + ",".join(repr(float(number)) for number in row) + ")" for row in steps)
    header = (f"NRRD0004\ntype: {types[values.dtype.type]}\ndimension: 3\nsizes: {' '.join(map(str, values.shape[::-1]))}\n"
              f"space dimension: 3\nspace directions: {vectors}\nendian: little\nencoding: raw\n\n")
    path.write_bytes(header.encode() + values.tobytes())


def waves(kind, random):
    """A smooth field with a little noise."""
    k, j, i = numpy.meshgrid(*[numpy.linspace(0, 1, n) for n in (11, 12, 14)], indexing="ij")
    field = numpy.sin(5 * i + 2 * k) + numpy.cos(6 * j - i) + 0.8 * numpy.sin(7 * k) + random.normal(0, 0.05, i.shape)
    share = (field - field.min()) / numpy.ptp(field)
    return (share * {numpy.uint8: 255, numpy.int16: 4000}.get(kind, 3.7) - (1000 if kind is numpy.int16 else 0)).astype(kind)


class DataLight(judged.LightTest):
    tolerances, pieces, options = {"unlit": 1, "lit": 2, "faded": 2}, SampledPieces, ("--show", "data")
    top, fewest = 34, 150  # below what is written there

    def prepare(self, name, build=("--error", 3)):
        kind, spacing, axes = CASES[name]
        self.folder = pathlib.Path(self.kept.name) / f"{name}{len(build)}".replace(" ", "-").replace(",", "")
        self.folder.mkdir(exist_ok=True)
        values, steps = waves(kind, self.random), numpy.diag(spacing) @ axes
        write_nrrd(self.folder / "data.nrrd", values, steps)
        judged.tan(self.folder, "build", "data.nrrd", "-o", "model.tan", *build)
        return Samples(values, steps)

    def test_samples_of_every_kind(self):
        for name in CASES:
            self.compare_all(self.prepare(name), name)

    def render(self, *options):
        return judged.tan(self.folder, "render", "model.tan", "--mode", "volume", "--size", "90x80", "--samples", 1, "--error", 8, *options, "-o", "p.png")

    def drawn(self, *options):
        figures = self.render(*options)
        return figures, judged.picture(self.folder / "p.png")

    def test_a_model_of_all_samples_needs_no_file(self):
        self.prepare("floats, turned", ())
        beside = self.drawn("--show", "data")
        self.assertEqual(beside[0]["shown"], "data")
        (self.folder / "data.nrrd").unlink()
        numpy.testing.assert_array_equal(self.drawn("--show", "data")[1], beside[1])

    def test_a_difference_is_that_of_the_pictures(self):
        self.prepare("bytes")
        plain = ("--no-outline", "--background", "#102030", "--clip", "1,0.2,0,2")
        mesh, data = self.drawn(*plain)[1], self.drawn(*plain, "--show", "data")[1]
        # What is written into the lower left corner or the upper one says what is shown.
        figures, difference = self.drawn(*plain, "--show", "difference")
        written = numpy.zeros(mesh.shape[:2], bool)
        written[:30, :] = written[-30:, :] = True
        expected = numpy.minimum(255, 8 * numpy.abs(mesh - data))
        numpy.testing.assert_array_equal(difference[~written], expected[~written])
        self.assertEqual(figures["shown"], "difference")
        self.assertGreater(figures["largest_difference"], 5)
        self.assertGreaterEqual(figures["largest_difference"], numpy.abs(mesh - data)[~written].max())

    def refused(self, *options):
        done = subprocess.run([str(judged.TAN), "render", "model.tan", "--mode", "volume", "--show", "data", *options, "-o", "p.png"], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def test_other_data_are_refused(self):
        self.prepare("floats, turned", ("--error", 3, "--threads", 1))
        values = waves(numpy.float32, self.random)
        write_nrrd(self.folder / "data.nrrd", values, numpy.eye(3))
        self.assertIn("contains other values", self.refused())
        (self.folder / "data.nrrd").unlink()
        self.assertIn("Put the file from which the model was built, 'data.nrrd', beside the model.", self.refused())

    def test_grids_have_no_samples_to_show(self):
        self.folder = pathlib.Path(self.kept.name) / "grid"
        self.folder.mkdir()
        judged.tan(self.folder, "sample", "bent-duct", "--size", 6, "-o", "data.xyz")
        judged.tan(self.folder, "build", "data.xyz", "-o", "model.tan")
        self.assertIn("Only the samples of a lattice can be shown", self.refused())

    def test_a_focus_shows_the_mesh_and_says_so(self):
        self.prepare("bytes", ("--error", 3, "--threads", 2))
        done = subprocess.run([str(judged.TAN), "render", "model.tan", "--mode", "hybrid", "--show", "data", "--error", "8", "--focus", "sphere:5,5,5,3", "--focus-error",
                               "3", "-o", "p.png", "--json"], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertIn("The mesh is shown, not the data", done.stderr)
        self.assertIn('"shown": "mesh"', done.stdout)


if __name__ == "__main__":
    unittest.main()
