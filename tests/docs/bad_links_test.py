#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""bad_links_test.py SOURCE: the writer of the manual refuses links to what is not there, writes the captions of pictures and leads to
the headings of a page."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

source = pathlib.Path(sys.argv[1])


def run_with(line):
    """The run of the writer, and the page that the line stands in."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "copy"
        shutil.copytree(source / "docs", copy / "docs")
        for name in ("CONTRIBUTING.md", "README.md", "core/history/FORMAT.md", "core/README.md"):
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source / name, copy / name)
        with open(copy / "docs/recipes.md", "a", encoding="utf-8") as page:
            page.write("\n" + line + "\n")
        run = subprocess.run([sys.executable, str(source / "docs/make_manual.py"), str(copy), folder + "/out", "1"],
                             capture_output=True, text=True, check=False)
        written = pathlib.Path(folder) / "out/recipes.html"
        return run, written.read_text(encoding="utf-8") if written.exists() else ""


for good in ("[a](formats.md#meshes)", "![a](images/window.png)", "![a](images/performance/refinement.svg)", "[a](https://example.org)"):
    run, _ = run_with(good)
    assert run.returncode == 0, (good, run.stderr)
for bad in ("[a](gone.md)", "[a](formats.md#gone)", "[a](#gone)", "![a](images/gone.png)", "![a](images/performance/gone.svg)"):
    run, _ = run_with(bad)
    assert run.returncode == 1 and "recipes.md" in run.stderr, (bad, run.stderr)

_, page = run_with("## Two < three\n\n![A cube, half of it](images/window.png)")
assert "<figcaption>A cube, half of it</figcaption>" in page
assert '<a class="heading" href="#two--three">Two &lt; three</a>' in page
