#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""build_examples.py SOURCE PREFIX FOLDER: builds every folder of examples/ in FOLDER against what is installed in PREFIX: the programs
and one plugin by the commands that docs/developer/guide.md shows; the other plugins, of which it shows the same commands or none, within one
project and without optimising, because configuring takes as long as compiling. A warning of the compiler is a failure. The plugins are gathered in FOLDER/plugins. Other tests use what is built here, so that nothing is compiled
twice."""
import os
import pathlib
import shutil
import subprocess
import sys

from page_commands import examples_built

SOURCE, PREFIX, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
NOT_SHOWN = ("editor", "projection", "slice", "tool")
# Without a build type plugins are optimised; of this one nothing is known.
QUICKLY = "-DCMAKE_BUILD_TYPE=Quick -DCMAKE_CXX_FLAGS_QUICK=-O0"


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


def of_reader(shown, name):
    """The folder and the commands that are shown for a reader, of another plugin."""
    folder, commands = shown["reader"]
    return folder.replace("reader", name), [command.replace("reader", name) for command in commands]


def build_together(folders):
    """Each in the folder "build" within it, as it would be by itself; each finds TAn for itself, as what it finds is known to it alone."""
    project = ["cmake_minimum_required(VERSION 3.25)", "project(Examples LANGUAGES CXX)"]
    project += ['add_subdirectory(%s "%s/build")' % (folder, FOLDER / folder) for folder in folders]
    (FOLDER / "CMakeLists.txt").write_text("\n".join(project) + "\n")
    run(['cmake -S . -B together -DCMAKE_PREFIX_PATH="$TAN_PREFIX" ' + QUICKLY, "cmake --build together"])


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    shown = examples_built((SOURCE / "docs/developer/guide.md").read_text(encoding="utf-8"))
    for name in NOT_SHOWN:
        assert name not in shown, "%s is shown" % name
        shown[name] = of_reader(shown, name)
    there = {folder.name for folder in (SOURCE / "examples").iterdir() if folder.is_dir()}
    assert set(shown) == there, "examples: %s, built: %s" % (sorted(there), sorted(shown))
    for name in ("library", "reader"):
        run(shown[name][1])
    others = sorted(there - {"library", "reader"})
    for name in others:
        assert shown[name] == of_reader(shown, name), "%s is built in another way than a reader" % name
        run(shown[name][1][:1])  # which copies it
    build_together([shown[name][0] for name in others])
    # The library alone, and a plugin that is no editor, as on a machine without Qt.
    for name in ("library", "reader"):
        built = shown[name][0] + "/build"
        run(["cmake %s -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON" % built, "cmake --build %s" % built])
    plugins = FOLDER / "plugins"
    plugins.mkdir()
    for name in there - {"library"}:
        built = list((FOLDER / shown[name][0] / "build").glob("lib*.so"))
        assert len(built) == 1, "%s: %s" % (name, built)
        shutil.copy(built[0], plugins)


main()
