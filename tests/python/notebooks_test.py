#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""notebooks_test.py FOLDER [NAME...]: the notebooks of the manual (docs/user/notebooks) are stored without outputs, what they link to is
there, and each runs from its first cell to its last in a folder of its own, with the package that lies in FOLDER. They assert what they
claim. Of ./dev soak alone (tests/CMakeLists.txt)."""
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time
import unittest

from module import FOLDER, skip

NAMES = sys.argv[1:] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None
if NAMES:
    del sys.argv[1:]
BOOKS = pathlib.Path(__file__).resolve().parents[2] / "docs/user/notebooks"
PATHS = sorted(BOOKS.glob("*.ipynb")) if NAMES is None else [BOOKS / f"{name}.ipynb" for name in NAMES]
SECONDS = 600  # for a cell, on a machine that does much else

try:
    import ipykernel  # noqa: F401
    import matplotlib  # noqa: F401
    import meshio  # noqa: F401
    import nbclient
    import nbformat
    import vtkmodules  # noqa: F401
except ImportError as missing:
    skip(f"the notebooks need nbclient, ipykernel, matplotlib, meshio and VTK: {missing}")


def anchors(page):
    """Of the headings of a page of Markdown, as MyST and others name them."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def without_colours(text):
    return re.sub(r"\x1b\[[0-9;]*m", "", text)


class Notebooks(unittest.TestCase):
    def test_how_they_are_stored(self):
        self.assertGreater(len(PATHS), 0)
        for path in PATHS:
            book = json.loads(path.read_text(encoding="utf-8"))
            with self.subTest(path.name):
                nbformat.validate(nbformat.read(path, as_version=4))
                self.assertEqual(book["nbformat"], 4)
                self.assertEqual(set(book["metadata"]), {"kernelspec", "language_info"})
                self.assertEqual(book["metadata"]["kernelspec"]["name"], "python3")
                self.assertRegex("".join(book["cells"][0]["source"]), r"^# \w")
                for cell in book["cells"]:
                    self.assertEqual(cell["metadata"], {})
                    if cell["cell_type"] == "code":
                        self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), "".join(cell["source"]))

    def test_what_they_link_to(self):
        for path in PATHS:
            book = json.loads(path.read_text(encoding="utf-8"))
            text = "\n".join("".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "markdown")
            for link in re.findall(r"\]\(([^)]*)\)", text):
                place, _, anchor = link.partition("#")
                with self.subTest(f"{path.name}: {link}"):
                    self.assertTrue((BOOKS / place).is_file())
                    if anchor:
                        self.assertIn(anchor, anchors(BOOKS / place))

    def test_they_run(self):
        for path in PATHS:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                begin = time.monotonic()
                self.run_one(path, folder)
                print(f"{path.name}: {time.monotonic() - begin:.1f} s", flush=True)

    def run_one(self, path, folder):
        own = {"PYTHONPATH": str(FOLDER), "IPYTHONDIR": f"{folder}/ipython", "JUPYTER_RUNTIME_DIR": f"{folder}/runtime",
               "PYDEVD_DISABLE_FILE_VALIDATION": "1"}
        os.makedirs(f"{folder}/ipython")
        place = pathlib.Path(folder, "work")
        place.mkdir()
        shutil.copy(path, place)
        book = nbformat.read(path, as_version=4)
        client = nbclient.NotebookClient(book, timeout=SECONDS, kernel_name="python3", resources={"metadata": {"path": str(place)}})
        try:
            client.execute(env={**os.environ, **own})
        except nbclient.exceptions.CellExecutionError as problem:
            self.fail(without_colours(str(problem)))
        outputs = [output for cell in book.cells if cell.cell_type == "code" for output in cell.outputs]
        self.assertTrue(any("image/png" in output.get("data", {}) for output in outputs), "it shows no picture")
        made = {one.name for one in place.iterdir()} - {path.name}
        self.assertEqual(made, {path.stem}, "all files lie in a folder of the notebook's name")


if __name__ == "__main__":
    unittest.main()
