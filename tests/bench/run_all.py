#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs all benchmarks one after the other and leaves what each found, and on which machine, as a JSON file in a folder. A step that
fails does not stop the others; the exit code is 1 then. `./dev bench all` calls it."""
import argparse
import json
import os
import pathlib
import subprocess
import sys

import machine
from steps import FULL, STEPS, TRIAL

PATIENCE = 10  # times as long as a step should take on a quiet machine, before it is given up
LEAST_MINUTES = 5
DATA = {"paper": "paper/table4.csv", "BluntFin": "bluntfin/bluntfinxyz.bin", "Post's grid": "post/postxyz.bin",
        "SOD": "sod/sod_sub_32x32x32_uint8.nhdr", "Bucky": "buckyball/bucky_32x32x32_uint8.raw",
        "BluntFin's tetrahedra": "bluntfin/bluntfin_tet.vtu", "Post's tetrahedra": "post/post_tet.vtu",
        "bracket's tetrahedra": "irregular/bracket_454k.vtu", "engine": "regular/engine_256x256x128_uint8.nrrd"}


def say(text):
    print(text, file=sys.stderr, flush=True)


class Runner:
    def __init__(self, options):
        self.options, self.sizes = options, TRIAL if options.trial else FULL
        self.data = options.data or options.source.parent / "shared/data"
        self.has_vtk = bool(machine.output_of("/usr/bin/python3", "-c", "import vtkmodules, numpy; print(1)"))
        self.about = {**machine.describe_machine(options.build), **machine.describe_revision(options.source), "trial": options.trial}

    def file_of(self, step):
        return self.options.folder / f"{step.name}.json"

    def is_done(self, step):
        """Whether an earlier run of the same program on the same machine has left its result."""
        try:
            run = json.loads(self.file_of(step).read_text(encoding="utf-8"))["run"]
        except (OSError, ValueError, KeyError, TypeError):
            return False
        return all(run.get(key) == value for key, value in self.about.items()) and not self.about["changed"]

    def available(self):
        """Which data and programs there are; a trial leaves the large ones out."""
        there = {name: (self.data / file).exists() for name, file in DATA.items()}
        there["VTK"] = self.has_vtk and not self.sizes["vtk"]
        for name in FULL["meshes"].split(","):
            if name not in self.sizes["meshes"].split(","):
                there[f"{name}'s tetrahedra"] = False
        there["engine"] &= "engine" in self.sizes["models"]
        there.update({f"table {number}": number in self.sizes["tables"] for number in FULL["tables"].split(",")})
        return there

    def command(self, step):
        values = {**self.sizes, "data": self.data, "folder": self.options.folder}
        words = [value for word in step.words.split() if (value := word.format(**values))]
        return [str(self.options.build / "bin" / step.program), *words] + ([] if step.program == "tan" else ["--json"])

    def report_of(self, step):
        """What the step's program printed. Raises RuntimeError with a text."""
        core = max(os.sched_getaffinity(0))
        patience = 60 * max(LEAST_MINUTES, PATIENCE * step.minutes)
        try:
            run = subprocess.run(self.command(step), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=False, timeout=patience,
                                 preexec_fn=(lambda: os.sched_setaffinity(0, {core})) if step.one_core else None)
        except OSError as error:
            raise RuntimeError(f"it cannot be started: {error}") from error
        except subprocess.TimeoutExpired as error:
            raise RuntimeError(f"it was given up after {patience / 60:.0f} minutes") from error
        if run.returncode != 0:
            raise RuntimeError(f"exit code {run.returncode}")
        try:
            return json.loads(run.stdout)
        except ValueError as error:
            raise RuntimeError(f"it printed no JSON: {error}") from error

    def run(self, step):
        self.file_of(step).unlink(missing_ok=True)
        available = self.available()
        date, watch = machine.now(), machine.Watch()
        left_out = step.data and not (self.data / step.data).exists()
        report = None if left_out else self.report_of(step)
        result = {"step": step.name, "run": {**self.about, "date": date, **watch.stop()}, "sizes": self.sizes,
                  "available": available, "report": report}
        part = self.file_of(step).with_suffix(".part")
        part.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
        part.rename(self.file_of(step))
        return result["run"]

    def run_all(self, chosen):
        """The texts of what failed."""
        failed = []
        for number, step in enumerate(chosen, 1):
            left = sum(later.minutes for later in chosen[number - 1:])
            head = f"[{number}/{len(chosen)}] {step.name}: {step.what}"
            if self.options.resume and self.is_done(step):
                say(f"{head}: is there already")
                continue
            say(head if self.options.trial else f"{head}, about {step.minutes:.1f} min; all that is left about {left:.0f} min")
            try:
                run = self.run(step)
                say(f"    {run['seconds']:.0f} s; other programs took {100 * run['others_share']:.0f} % of the machine")
            except RuntimeError as error:
                failed.append(f"{step.name} failed: {error}")
                say(f"    {failed[-1]}")
        return failed


def read_options():
    parser = argparse.ArgumentParser(prog="./dev bench all", description="Runs all benchmarks; what they find goes into a folder.")
    parser.add_argument("--source", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--data", type=pathlib.Path, help="the datasets; by default ../shared/data beside the repository")
    parser.add_argument("--only", metavar="NAME[,NAME]", help="these steps: " + ", ".join(step.name for step in STEPS))
    parser.add_argument("--resume", action="store_true", help="leave out what this revision has measured already on this machine")
    parser.add_argument("--trial", action="store_true", help="tiny sizes: shows that everything works, and measures nothing")
    options = parser.parse_args()
    options.source, options.build, options.folder = (path.resolve() for path in (options.source, options.build, options.folder))
    names = [step.name for step in STEPS]
    only = options.only.split(",") if options.only else names
    for name in only:
        if name not in names:
            parser.error(f"there is no step '{name}'; there are {', '.join(names)}")
    return options, [step for step in STEPS if step.name in only]


def main():
    options, chosen = read_options()
    options.folder.mkdir(parents=True, exist_ok=True)
    runner = Runner(options)
    if not options.trial:
        say(f"{len(chosen)} steps, about {sum(step.minutes for step in chosen):.0f} minutes on two quiet cores. "
            "What else runs meanwhile falsifies what is measured.")
    try:
        failed = runner.run_all(chosen)
    except KeyboardInterrupt:
        say("\nInterrupted. What is done is kept: go on with ./dev bench all --resume")
        return 130
    for text in failed:
        say(text)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
