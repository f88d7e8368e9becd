#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""module_speed.py BUILD MODEL [--error 1] [--rounds 7]: what the Python module adds to the library's extraction of a mesh, and what two
threads gain that extract from one model. Ratios of medians, of measurements that were taken by turns; pin it to quiet processors."""
import argparse
import pathlib
import statistics
import subprocess
import sys
import threading
import time

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("build", type=pathlib.Path)
arguments.add_argument("model")
arguments.add_argument("--error", type=float, default=1)
arguments.add_argument("--rounds", type=int, default=7)
asked = arguments.parse_args()
sys.path.insert(0, str(asked.build / "lib/python3/dist-packages"))
import tan  # noqa: E402


def seconds(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def against_the_library(model):
    library, module = [], []
    with subprocess.Popen([asked.build / "bin/tan-bench-python-module", asked.model, str(asked.error)], stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, text=True, bufsize=1) as yardstick:
        for _ in range(asked.rounds + 1):
            yardstick.stdin.write("\n")
            library.append(float(yardstick.stdout.readline().split()[0]))
            module.append(seconds(lambda: model.mesh(error=asked.error).tetrahedra))
        yardstick.stdin.close()
    return statistics.median(library[1:]), statistics.median(module[1:])  # the first ones fill the caches


def in_threads(model, count, meshes):
    """Seconds for so many meshes, by so many threads."""
    def work():
        with model.explore() as own:
            for _ in range(meshes // count):
                own.mesh(error=asked.error)

    def all_threads():
        threads = [threading.Thread(target=work) for _ in range(count)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    return seconds(all_threads)


opened = tan.open(asked.model)
size = opened.size_at(error=asked.error)
of_library, of_module = against_the_library(opened)
one, two = (statistics.median(times) for times in zip(*[(in_threads(opened, 1, 4), in_threads(opened, 2, 4)) for _ in range(asked.rounds)]))
print(f"{size.tetrahedra:,} tetrahedra at {asked.error:g} %: the library {of_library:.3f} s, the module {of_module:.3f} s, "
      f"{of_module / of_library:.3f} times; two threads {one / two:.2f} times one")
