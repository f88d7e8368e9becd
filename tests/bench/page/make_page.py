#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_page.py RESULTS PAGE PICTURES: writes the page of what was measured, and its plots as SVG into the folder PICTURES, from what
`./dev bench all` left in the folder RESULTS. Where a result is missing or broken it says which, and writes nothing."""
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

import building
import pictures
import queries
from page_text import page_text
from plots import plots_of
from results import Results, Unusable
from steps import STEPS

SECTIONS = (building.REFINEMENT, building.DECIMATION, queries.QUERIES, pictures.VOLUMES, pictures.SURFACES, pictures.PAPER,
            pictures.INTERACTION)


def main():
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    folder, page, drawings = map(pathlib.Path, sys.argv[1:])
    try:
        results = Results(folder, STEPS)
        plots = plots_of(SECTIONS, results)
        text = page_text(SECTIONS, results, plots, os.path.relpath(drawings, page.parent))
    except Unusable as error:
        print(f"The page was not written.\n{error}", file=sys.stderr)
        return 1
    drawings.mkdir(parents=True, exist_ok=True)
    for old in drawings.glob("*.svg"):
        old.unlink()
    for name, drawing in plots.items():
        (drawings / f"{name}.svg").write_text(drawing, encoding="utf-8")
    page.write_text(text, encoding="utf-8")
    print(f"{page} and {len(plots)} plots were written.", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
