#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""typing_test.py FOLDER: the package and a program that uses it pass `mypy --strict`, wrong calls do not; the examples in its docstrings
hold; everything public says what it is; no Qt comes along."""
import doctest
import importlib
import importlib.util
import inspect
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from module import FOLDER, tan

MODULES = ["_build", "_data", "_errors", "_mesh", "_model", "_numbers", "_progress", "_regions", "_verdict", "_view"]
SAMPLE = """
import numpy as np
import numpy.typing as npt
import tan
m = tan.build(np.zeros((4, 4, 4)), "a.tan", spacing=(1, 1, 2.5), name="CT", progress=print)
mesh = m.mesh(error=5, focus=tan.sphere((64, 64, 32), 20, error=0.2, falloff=10), window=tan.box((0, 0, 0), (9, 9, 9)), values=(80, 120))
points: npt.NDArray[np.float64] = mesh.points
values = mesh.sample(points)
surface = mesh.isosurface(100)
area: float = surface.area() + mesh.slice(normal=(0, 0, 1), at=32).area()
picture = m.render(mode="volume", transfer="viridis", size=(800, 600))
sizes = m.size_at(error=1).tetrahedra + len(m.levels["error"])
ok: bool = m.verify(against="engine.nrrd").ok
with m.explore(budget=1_000_000) as x:
    reached = x.mesh(error=1).error
"""
WRONG = {'tan.open("a.tan").mesh(eror=1)': "Unexpected keyword", 'tan.open("a.tan").mesh(error="1")': "incompatible type",
         'tan.sphere(1)': "Missing positional", 'x: str = tan.open("a.tan").sites': "Incompatible types"}


class Types(unittest.TestCase):
    def checked(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "--cache-dir", folder, *arguments],
                                  capture_output=True, text=True, check=False, env={**os.environ, "MYPYPATH": str(FOLDER)})

    @unittest.skipIf(importlib.util.find_spec("mypy") is None, "no mypy")
    def test_mypy(self):
        with tempfile.TemporaryDirectory() as folder:
            sample = pathlib.Path(folder, "sample.py")
            wrong = "\n".join(["import tan", *WRONG])
            sample.write_text(SAMPLE)
            pathlib.Path(folder, "wrong.py").write_text(wrong)
            adapters = [str(FOLDER / "tan" / f"{name}.py") for name in ("vtk", "meshio", "pyvista")]
            found = self.checked("--ignore-missing-imports", str(sample), str(pathlib.Path(folder, "wrong.py")), *adapters,
                                 *(str(FOLDER / "tan" / f"{name}.py") for name in MODULES)).stdout.splitlines()
        said = [line for line in found if "wrong.py" in line and ": error:" in line]
        self.assertEqual([line for line in found if ": error:" in line and line not in said], [])
        for number, words in enumerate(WRONG.values(), 2):
            self.assertTrue(any(f"wrong.py:{number}:" in line and words in line for line in said), (number, words, said))

    def test_examples(self):
        tried = 0
        for name in MODULES:
            outcome = doctest.testmod(importlib.import_module(f"tan.{name}"))
            self.assertEqual(outcome.failed, 0, name)
            tried += outcome.attempted
        self.assertGreater(tried, 15)

    def test_the_manual(self):
        page = (pathlib.Path(__file__).parents[2] / "docs/user/python.md").read_text(encoding="utf-8")
        first = page.split("```python\n")[1].split("```")[0]
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                shown = {}
                exec(compile(first, "docs/user/python.md", "exec"), shown)
                self.assertEqual(shown["picture"].shape, (600, 800, 4))
                self.assertTrue(pathlib.Path("wells.png").exists())
            finally:
                os.chdir(before)

    def test_everything_public_says_what_it_is(self):
        silent = []
        for name in tan.__all__:
            thing = getattr(tan, name)
            silent += [name] if not inspect.getdoc(thing) else []
            if inspect.isclass(thing) and thing.__module__.startswith("tan."):
                silent += [f"{name}.{member}" for member, value in vars(thing).items() if not member.startswith("_")
                           and (callable(value) or isinstance(value, property)) and not inspect.getdoc(getattr(thing, member))]
        self.assertEqual(silent, [])

    def test_no_qt(self):
        loaded = pathlib.Path("/proc/self/maps").read_text()
        self.assertIn("libtan-picture", loaded)
        self.assertNotIn("libQt", loaded)


if __name__ == "__main__":
    unittest.main()
