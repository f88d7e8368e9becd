#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the page of what was measured, and its plots as SVG into a folder, from what `./dev bench all` left in another one. Where a
result is missing or broken it says which, and writes nothing."""
import argparse
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

import building
import pictures
import queries
from page_text import page_text
from plots import draw, plots_of
from results import Results, Unusable
from steps import STEPS

SECTIONS = (building.REFINEMENT, building.DECIMATION, queries.QUERIES, pictures.VOLUMES, pictures.SURFACES, pictures.PAPER,
            pictures.INTERACTION)


def read_options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path, help="the folder with what the steps found")
    parser.add_argument("page", type=pathlib.Path, help="the page to write, as Markdown")
    parser.add_argument("pictures", type=pathlib.Path, help="the folder for the plots; other SVG files in it are removed")
    parser.add_argument("--drawer", required=True, metavar="PROGRAM", help="tan-bench-plots, as it was built")
    parser.add_argument("--without", metavar="NAME[,NAME]", default="", help="steps that were not run; the page says so")
    options = parser.parse_args()
    without = [name for name in options.without.split(",") if name]
    for name in without:
        if name not in [step.name for step in STEPS]:
            parser.error(f"there is no step '{name}'; there are {', '.join(step.name for step in STEPS)}")
    return options, without


def main():
    options, without = read_options()
    page, drawings = options.page, options.pictures
    try:
        results = Results(options.results, STEPS, without)
        plots = plots_of(SECTIONS, results)
        text = page_text(SECTIONS, results, plots, os.path.relpath(drawings, page.parent))
        drawings.mkdir(parents=True, exist_ok=True)
        for old in drawings.glob("*.svg"):
            old.unlink()
        draw(options.drawer, plots, drawings)
    except Unusable as error:
        print(f"The page was not written.\n{error}", file=sys.stderr)
        return 1
    page.write_text(text, encoding="utf-8")
    print(f"{page} and {len(plots)} plots were written.", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
