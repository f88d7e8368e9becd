#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""build_examples.py SOURCE PREFIX FOLDER: builds every folder of examples/ in FOLDER against what is installed in PREFIX, by the commands
that docs/developers.md shows, or as it shows it for a reader. A warning of the compiler is a failure. The plugins are gathered in
FOLDER/plugins. Other tests use what is built here, so that nothing is compiled twice."""
import os
import pathlib
import shutil
import subprocess
import sys

from page_commands import examples_built

SOURCE, PREFIX, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
NOT_SHOWN = ("editor", "projection", "slice")


def environment():
    """Ninja is quicker than make. One compiler at a time: other tests run meanwhile."""
    found = dict(os.environ, LC_ALL="C.UTF-8", HOME=str(FOLDER), TAN_SOURCE=str(SOURCE), TAN_PREFIX=str(PREFIX),
                 CMAKE_BUILD_PARALLEL_LEVEL="1")
    if shutil.which("ninja"):
        found["CMAKE_GENERATOR"] = "Ninja"
    return found


def run(commands):
    ran = subprocess.run(["bash", "-ec", "\n".join(commands)], cwd=FOLDER, env=environment(), stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    if ran.returncode != 0 or "warning:" in ran.stdout:
        sys.exit("\n".join([*commands, ran.stdout, "exit code %d" % ran.returncode]))


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    shown = examples_built((SOURCE / "docs/developers.md").read_text(encoding="utf-8"))
    like, commands = shown["reader"]
    for name in NOT_SHOWN:
        assert name not in shown, "%s is shown" % name
        shown[name] = (like.replace("reader", name), [command.replace("reader", name) for command in commands])
    there = {folder.name for folder in (SOURCE / "examples").iterdir() if folder.is_dir()}
    assert set(shown) == there, "examples: %s, built: %s" % (sorted(there), sorted(shown))
    for name in sorted(shown):
        run(shown[name][1])
    # The library alone, as on a machine without Qt.
    programs = shown["library"][0] + "/build"
    run(["cmake %s -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON" % programs, "cmake --build %s" % programs])
    plugins = FOLDER / "plugins"
    plugins.mkdir()
    for name in there - {"library"}:
        built = list((FOLDER / shown[name][0] / "build").glob("lib*.so"))
        assert len(built) == 1, "%s: %s" % (name, built)
        shutil.copy(built[0], plugins)


main()
