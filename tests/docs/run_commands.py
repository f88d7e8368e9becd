#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_commands.py SOURCE BUILD: runs every command that README and docs show, page by page in a folder of its own, with the programs of
the build and small files of the names that the pages use. Also: the example in the developer's guide is the one that is built."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import sample_inputs

COMMAND = re.compile(r"^(\w+=\S+ )*(tan|tan-desktop|\./dev|\.ci/run|cmake|cp|echo|for|set|apt|sh|sudo|xvfb-run|perf|build/\S+)\b")

# What is not run, and why.
SKIPPED = [
    (r"^\./dev |^\.ci/run", "builds and installs; CI runs these"),
    (r"^cmake --preset|^build/fuzz/", "builds everything again in another way; CI runs these"),
    (r"^tan-desktop |^xvfb-run ", "opens the window; tests/ui and tests/package do"),
    (r"^tan reproduce ", "needs the paper's datasets; test_reproduction runs it"),
]
# Commands that count points want the dataset in its full size.
FULL_SIZE = re.compile(r"^tan build engine\.nrrd --region 0,0,32,255,255,95")


def commands_of(text):
    """The commands of a page: lines of blocks that are indented or marked sh, where the block begins with a command."""
    commands, block, fence = [], [], None

    def end_block():
        if block and COMMAND.match(block[0]):
            commands.extend(re.sub(r"\s{2,}#\s.*$", "", line) for line in block)
        block.clear()

    for line in text.splitlines():
        if line.startswith("```"):
            end_block()
            fence = line[3:].strip() if fence is None else None
        elif fence is not None:
            if fence in ("sh", "shell", "bash"):
                block.append(line)
        elif line.startswith("    ") and line.strip():
            block.append(line.strip())
        else:
            end_block()
    end_block()
    return [command for command in commands if command]


def reason_to_skip(command):
    return next((reason for pattern, reason in SKIPPED if re.search(pattern, command)), None)


class Runner:
    def __init__(self, source, build):
        self.source, self.build, self.failures, self.ran, self.skipped = source, build, [], 0, 0
        self.tan = str(build / "bin/tan")

    def environment(self, folder):
        return {"PATH": f"{self.build}/bin:{os.environ['PATH']}", "HOME": str(folder), "LANG": "C.UTF-8",
                "TAN_SOURCE": str(self.source), "TAN_PREFIX": str(folder / "installed")}

    def run_page(self, name):
        commands = commands_of((self.source / name).read_text(encoding="utf-8"))
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            if any(reason_to_skip(command) is None for command in commands):
                sample_inputs.write_all(folder, self.tan, self.source)
            if any("TAN_PREFIX" in command for command in commands):
                self.install(folder / "installed")
            for command in commands:
                self.run_command(name, command, folder)

    def install(self, prefix):
        for component in ("core", "program", "development"):
            subprocess.run(["cmake", "--install", self.build, "--prefix", prefix, "--component", component], check=True,
                           capture_output=True)

    def run_command(self, page, command, folder):
        if reason := reason_to_skip(command):
            self.skipped += 1
            print(f"skipped: {page}: {command}: {reason}")
            return
        if FULL_SIZE.search(command):
            sample_inputs.write_engine_of_full_size(folder)
        run = subprocess.run(["bash", "-c", command], cwd=folder, env=self.environment(folder), capture_output=True, text=True,
                             errors="replace", timeout=300, check=False, stdin=subprocess.DEVNULL)
        if FULL_SIZE.search(command):
            sample_inputs.write_engine(folder, self.tan)
        self.ran += 1
        if run.returncode != 0:
            self.failures.append(f"{page}: {command}\n  exit code {run.returncode}: {run.stderr[-600:]}")
            print("FAIL: " + self.failures[-1])
        for target in re.findall(r"-o (\S+\.\w+)", command):
            if "$" not in target and run.returncode == 0 and not (folder / target).exists():
                self.failures.append(f"{page}: {command}\n  wrote no {target}")

    def check_example(self):
        guide = (self.source / "docs/developers.md").read_text(encoding="utf-8")
        for file in ("reader/grid_text_reader.json", "reader/CMakeLists.txt", "reader/grid_text_reader.cpp",
                     "builder/budget_builder.cpp", "writer/off_writer.json", "writer/off_writer.cpp",
                     "editor/band_editor.json", "editor/CMakeLists.txt", "editor/band_editor.cpp",
                     "renderer/shells_renderer.cpp"):
            if (self.source / "examples" / file).read_text(encoding="utf-8") not in guide:
                self.failures.append(f"docs/developers.md does not show examples/{file} as it is")
        for folder in (self.source / "examples").iterdir():
            lines = sum(len(file.read_text(encoding="utf-8").splitlines()) for file in folder.iterdir() if file.is_file())
            if folder.name != "library" and lines > 150:
                self.failures.append(f"examples/{folder.name} has {lines} lines, which are more than docs/developers.md says")


def check_own_reading():
    page = "text\n\n    tan a   # why\n    tan b\n\n    key: value\n\n```sh\ncmake c\n```\n```cpp\nfor (;;);\n```\n"
    assert commands_of(page) == ["tan a", "tan b", "cmake c"], commands_of(page)


def main():
    check_own_reading()
    runner = Runner(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
    pages = ["README.md", "CONTRIBUTING.md", "core/README.md"]
    pages += sorted(str(path.relative_to(runner.source)) for path in (runner.source / "docs").glob("*.md"))
    for page in pages:
        runner.run_page(page)
    runner.check_example()
    print(f"{runner.ran} commands ran, {runner.skipped} were skipped, {len(runner.failures)} failures")
    print("\n".join(runner.failures))
    return 1 if runner.failures or runner.ran < 50 else 0


sys.exit(main())
