#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""truth.py BUILD [--quick] [--only TEXT] [--report FILE] [--processes N] [--list]: the bench of truth. Files of every format that TAn reads are
written by other libraries, or byte by byte, with a known function of the place in the world; TAn has to give back the samples at their places,
and to say what it took. `--quick` takes the few jobs of ./dev test; `--only` those whose line has the text; `--report` puts the table into
that page of the manual (docs/user/formats.md), in place of the one that is there. Exit code 77: nothing failed, but jobs were skipped, since libraries
are missing; it says which to install."""
import argparse
import collections
import concurrent.futures
import multiprocessing
import os
import pathlib
import sys

try:
    import bench
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

import arrays  # noqa: F401  each module adds its jobs
import climate  # noqa: F401
import maps  # noqa: F401
import medicine  # noqa: F401
import meshes  # noqa: F401
import microscopes  # noqa: F401
import solvers  # noqa: F401
import tables  # noqa: F401
import vtk_files  # noqa: F401

FAILED = ("refused", "wrong", "not told")


def judged(number, tan):
    return bench.judged(bench.BENCH[number], tan)


def line(job):
    return f"{job.format} | {job.kind} | {job.name}"


def table(jobs, outcomes):
    """Markdown: a row a format, a column a kind; n jobs that passed, or passed/all."""
    counts = collections.defaultdict(lambda: collections.Counter())
    for job, (outcome, _) in zip(jobs, outcomes):
        counts[job.format, job.kind][outcome] += 1
    formats = list(dict.fromkeys(job.format for job in jobs))
    rows = ["| format | " + " | ".join(bench.KINDS) + " |", "|---" * (len(bench.KINDS) + 1) + "|"]
    for name in formats:
        cells = []
        for kind in bench.KINDS:
            of = counts[name, kind]
            passed, all_of = of["passed"], sum(of.values()) - of["skipped"]
            cells.append("" if not sum(of.values()) else "skipped" if not all_of else str(all_of) if passed == all_of else f"{passed}/{all_of}")
        rows.append(f"| {name} | " + " | ".join(cells) + " |")
    expected = [f"- {line(job)}: {why}" for job, (outcome, why) in zip(jobs, outcomes) if outcome == "refused as expected"]
    return "\n".join(rows + ([""] + expected if expected else [])) + "\n"


def write_table(page, text):
    """In place of the one that the page has."""
    lines = page.read_text().splitlines()
    begin = next(i for i, one in enumerate(lines) if one.startswith("| format | " + bench.KINDS[0]))
    end = next((i for i in range(begin, len(lines)) if not lines[i].startswith("|")), len(lines))
    page.write_text("\n".join(lines[:begin] + text.splitlines() + lines[end:]) + "\n")


def main():
    words = argparse.ArgumentParser(description=__doc__)
    words.add_argument("build", type=pathlib.Path)
    words.add_argument("--quick", action="store_true")
    words.add_argument("--only", default="")
    words.add_argument("--report", type=pathlib.Path)
    words.add_argument("--processes", type=int, default=os.cpu_count())
    words.add_argument("--list", action="store_true")
    given = words.parse_args()
    jobs = [job for job in bench.BENCH if (job.quick or not given.quick) and given.only.lower() in line(job).lower()]
    if given.list:
        print("\n".join(map(line, jobs)))
        return 0
    tan = given.build.resolve() / "bin/tan"
    # Processes that have the jobs since they are forked: functions without a name cannot be sent.
    with concurrent.futures.ProcessPoolExecutor(given.processes, multiprocessing.get_context("fork")) as pool:
        running = [pool.submit(judged, bench.BENCH.index(job), tan) for job in jobs]
        outcomes = []
        for job, each in zip(jobs, running):
            outcomes.append(each.result())
            outcome, why = outcomes[-1]
            if outcome != "passed":
                print(f"{outcome}: {line(job)}: {why[:600]}", flush=True)
    print(table(jobs, outcomes))
    counted = collections.Counter(outcome for outcome, _ in outcomes)
    print(f"{len(jobs)} jobs: " + ", ".join(f"{counted[outcome]} {outcome}" for outcome in bench.OUTCOMES if counted[outcome]))
    if given.report:
        write_table(given.report, table(jobs, outcomes))
    return 1 if any(counted[outcome] for outcome in FAILED) else 77 if counted["skipped"] else 0


if __name__ == "__main__":
    sys.exit(main())
