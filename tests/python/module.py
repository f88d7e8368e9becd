# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the module tan share: `NAME_test.py FOLDER` tests the package that lies in FOLDER. Exit code 77: something is
missing, as ctest is told."""
import os
import pathlib
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 and pathlib.Path(sys.argv[1]).is_dir() else None
SANITIZED = "libasan" in os.environ.get("LD_PRELOAD", "")  # by what needs terabytes of addresses, and several times as long


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


try:
    import numpy as np
except ImportError as missing:
    skip(missing)
if FOLDER is None:
    sys.exit("The folder is missing that has the package tan.")
sys.path.insert(0, str(FOLDER))
import tan  # noqa: E402


def lattice(size=13):
    """Coordinates of a lattice of size^3 points from -1 to 1, with the axes z, y and x."""
    steps = np.linspace(-1, 1, size)
    z, y, x = np.meshgrid(steps, steps, steps, indexing="ij")
    return x, y, z


def placed(size=13):
    """The keywords that put an array of that lattice there."""
    return {"spacing": [2 / (size - 1)] * 3, "origin": (-1, -1, -1)}


class ModuleTest(unittest.TestCase):
    """With a folder for files, and a model of the distance from the middle."""

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        x, y, z = lattice()
        cls.distances = np.sqrt(x * x + y * y + z * z)
        cls.ball = tan.build(cls.distances, cls.folder / "ball.tan", name="ball", value_name="distance", length_unit="cm", **placed())

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def refused(self, kind, words, call, *arguments, **keywords):
        """It raises this kind, and says so."""
        with self.assertRaises(kind) as caught:
            call(*arguments, **keywords)
        self.assertRegex(str(caught.exception), words)
        return caught.exception


def volumes(mesh):
    a, b, c, d = (mesh.points[mesh.tetrahedra[:, corner]] for corner in range(4))
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6
