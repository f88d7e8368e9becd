#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""written.py FOLDER: files of the bench of truth for other tests, each job's in a folder of its own, and a line of JSON for each that names
the job's format, its folder, what a user opens there, and the options. Of each format: every way of storing it, the cells that others do not
have, and one job of each other kind. Jobs whose libraries are missing are left out; exit code 77: all of them."""
import json
import pathlib
import re
import shutil
import sys

import truth  # noqa: F401  which has the jobs of all modules, and ends this where a library is missing that all of them need

import bench

OTHER_CELLS = re.compile("polyhedra|Lagrange|mixed|several kinds|quadratic tetrahedra")


def chosen():
    known = set()
    for job in bench.BENCH:
        if job.refused:
            continue
        of_format = (job.format, job.kind)
        if job.kind == "storage" or of_format not in known or (job.kind == "cells" and OTHER_CELLS.search(job.name)):
            yield job
        known.add(of_format)


def main():
    place = pathlib.Path(sys.argv[1]).resolve()
    for job in chosen():
        name = re.sub("[^a-z0-9.]+", "-", f"{job.format} {job.kind} {job.name}".lower()).strip("-")
        folder = next(path for path in (place / (name + "'" * n) for n in range(99)) if not path.exists())
        folder.mkdir(parents=True)
        try:
            case = job.write(folder)
        except (bench.Missing, ImportError):
            shutil.rmtree(folder)
            continue
        print(json.dumps({"format": job.format, "folder": folder.name, "opened": str(case.file.resolve().relative_to(folder)),
                          "options": [str(word) for word in case.options]}))


if __name__ == "__main__":
    main()
