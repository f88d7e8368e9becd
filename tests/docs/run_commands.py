#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_commands.py SOURCE BUILD EXAMPLES: runs every command that README and docs show, page by page in a folder of its own, with the
programs of the build and small files of the names that the pages use. Those that build an example have been run by build_examples.py,
in the folder EXAMPLES: what they made is used. Also: the example in the developer's guide is the one that is built."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import sample_inputs
from page_commands import commands_of, examples_built

# What is not run, and why.
SKIPPED = [
    (r"^\./dev |^\.ci/run", "builds and installs; CI runs these"),
    (r"^cmake --preset|^cmake -S|^cmake --build build[ -]|^cmake --install build/|^build/fuzz/", "builds everything again in another way"),
    (r"^tan-desktop |^xvfb-run ", "opens the window; tests/ui and tests/package do"),
    (r"https?://example", "needs a server; test_model_forms has one"),
    (r"^tan serve |^ssh |--at-server", "serves until it is stopped; test_serve runs it"),
    (r"--faulty-cells", "needs a mesh with faulty cells; test_command_line has one"),
    (r"^tan reproduce ", "needs the paper's datasets; test_reproduction runs it"),
    (r"^tan sample c60 --size 1700", "makes 5 GB; the commands that follow find a small large.nrrd"),
]
# Pages whose commands another test runs.
ELSEWHERE = {"docs/user/gallery.md": "gallery_test.py makes its pictures"}
# These are about files that other programs write, as python3-tifffile, python3-pydicom and python3-netcdf4 do here.
OF_OTHERS = re.compile(r"\b(cells|bone|era5|europe)\.|\bscan/")
# Commands that count points want the dataset in its full size.
FULL_SIZE = re.compile(r"^tan build engine\.nrrd --region 0,0,32,255,255,95")


def reason_to_skip(command, has_files_of_others=True):
    if not has_files_of_others and OF_OTHERS.search(command):
        return "needs python3-tifffile, python3-pydicom and python3-netcdf4"
    return next((reason for pattern, reason in SKIPPED if re.search(pattern, command)), None)


class Runner:
    def __init__(self, source, build, examples):
        self.source, self.build, self.examples, self.failures, self.ran, self.skipped = source, build, examples, [], 0, 0
        self.tan = str(build / "bin/tan")
        self.samples = tempfile.TemporaryDirectory()
        sample_inputs.write_all(pathlib.Path(self.samples.name), self.tan, source)
        self.has_files_of_others = sample_inputs.write_recipe_inputs(pathlib.Path(self.samples.name))

    def environment(self, folder):
        return {"PATH": f"{self.build}/bin:{os.environ['PATH']}", "HOME": str(folder), "LANG": "C.UTF-8",
                "TAN_SOURCE": str(self.source)}

    def run_page(self, name):
        text = (self.source / name).read_text(encoding="utf-8")
        commands, examples = commands_of(text), examples_built(text).values()
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            if any(reason_to_skip(command) is None for command in commands):
                shutil.copytree(self.samples.name, folder, dirs_exist_ok=True)
            for example, _ in examples:
                shutil.copytree(self.examples / example, folder / example)
            built = [command for _, building in examples for command in building]
            for command in commands:
                if command in built:
                    self.ran += 1
                else:
                    self.run_command(name, command, folder)

    def run_command(self, page, command, folder):
        if reason := reason_to_skip(command, self.has_files_of_others):
            self.skipped += 1
            print(f"skipped: {page}: {command}: {reason}")
            return
        if FULL_SIZE.search(command):
            sample_inputs.write_engine_of_full_size(folder)
        run = subprocess.run(["bash", "-c", command], cwd=folder, env=self.environment(folder), capture_output=True, text=True,
                             errors="replace", timeout=300, check=False, stdin=subprocess.DEVNULL)
        if FULL_SIZE.search(command):
            shutil.copy(pathlib.Path(self.samples.name) / "engine.nrrd", folder)
        self.ran += 1
        if run.returncode != 0:
            self.failures.append(f"{page}: {command}\n  exit code {run.returncode}: {run.stderr[-600:]}")
            print("FAIL: " + self.failures[-1])
        for target in re.findall(r"-o (\S+\.\w+)", command):
            if "$" not in target and run.returncode == 0 and not (folder / target).exists():
                self.failures.append(f"{page}: {command}\n  wrote no {target}")

    def check_example(self):
        guide = (self.source / "docs/developer/guide.md").read_text(encoding="utf-8")
        for file in ("reader/grid_text_reader.json", "reader/CMakeLists.txt", "reader/grid_text_reader.cpp",
                     "builder/budget_builder.cpp", "writer/off_writer.json", "writer/off_writer.cpp",
                     "editor/band_editor.json", "editor/CMakeLists.txt", "editor/band_editor.cpp",
                     "renderer/shells_renderer.cpp"):
            if (self.source / "examples" / file).read_text(encoding="utf-8") not in guide:
                self.failures.append(f"docs/developer/guide.md does not show examples/{file} as it is")
        for folder in (self.source / "examples").iterdir():
            lines = sum(len(file.read_text(encoding="utf-8").splitlines()) for file in folder.iterdir() if file.is_file())
            if folder.name != "library" and lines > 150:
                self.failures.append(f"examples/{folder.name} has {lines} lines, which are more than docs/developer/guide.md says")


def main():
    runner = Runner(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:4]))
    pages = ["README.md", "CONTRIBUTING.md", "core/README.md"]
    pages += sorted(str(path.relative_to(runner.source)) for path in (runner.source / "docs").glob("*/*.md"))
    for page in pages:
        if page in ELSEWHERE:
            print(f"skipped: {page}: {ELSEWHERE[page]}")
        else:
            runner.run_page(page)
    runner.check_example()
    print(f"{runner.ran} commands ran, {runner.skipped} were skipped, {len(runner.failures)} failures")
    print("\n".join(runner.failures))
    return 1 if runner.failures or runner.ran < 50 else 0


sys.exit(main())
