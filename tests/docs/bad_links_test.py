#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""bad_links_test.py SOURCE: what writes the manual refuses links to what is not there, and pages for users that lead to pages for
developers. What it writes has captions and a search, and asks nothing of a network."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1])
GOOD = ["[a](formats.md#meshes)", "![A cube, half of it](images/window.png)", "[a](https://example.org)", "[a](#two--three)"]
BAD = ["[a](gone.md)", "[a](formats.md#gone)", "[a](#gone-too)", "![a](images/gone.png)", "[a](../lab/measured.md)"]


def run_with(lines, folder):
    """The run over a copy of the pages, one of which has these paragraphs more."""
    copy = folder / "docs"
    shutil.copytree(SOURCE / "docs/user", copy)
    with open(copy / "recipes.md", "a", encoding="utf-8") as page:
        page.write("\n\n## Two < three\n\n" + "\n\n".join(lines) + "\n")
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-c", SOURCE / "docs", "-d", folder / "trees", copy, folder / "out"]
    return subprocess.run(command, capture_output=True, text=True, check=False)


with tempfile.TemporaryDirectory() as place:
    run = run_with(GOOD, pathlib.Path(place))
    assert run.returncode == 0, run.stderr
    written = pathlib.Path(place) / "out"
    page = (written / "recipes.html").read_text(encoding="utf-8")
    assert re.search(r'<span class="caption-text">A cube, half of it</span>', page)
    assert 'href="#two' in page
    assert '"recip' in (written / "searchindex.js").read_text(encoding="utf-8")
    theme = (written / "_static/scripts/furo.js").read_text(encoding="utf-8")
    assert "Gumshoe = factory" in theme and not re.search(r"^import ", theme, re.MULTILINE)
    for file in written.rglob("*.html"):
        fetched = re.findall(r'<(?:script|link|img|iframe)[^>]*(?:src|href)="(https?:|//)', file.read_text(encoding="utf-8"))
        assert not fetched, file

with tempfile.TemporaryDirectory() as place:
    run = run_with(BAD, pathlib.Path(place))
    assert run.returncode != 0
    warnings = [line for line in run.stderr.splitlines() if "WARNING" in line]
    assert len(warnings) == len(BAD) and all("recipes.md" in line for line in warnings), run.stderr
