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


def error_of(number):
    """Never the same twice, as a mesh that is there is not extracted again."""
    return asked.error * (1 + number % 2)


def seconds(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def against_the_library(model):
    library, module = [], []
    with subprocess.Popen([asked.build / "bin/tan-bench-python-module", asked.model], stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, text=True, bufsize=1) as yardstick:
        for number in range(asked.rounds + 1):
            error = error_of(number)
            yardstick.stdin.write(f"{error}\n")
            library.append(float(yardstick.stdout.readline().split()[0]))
            module.append(seconds(lambda: model.mesh(error=error).tetrahedra))
        yardstick.stdin.close()
    return statistics.median(library[1:]), statistics.median(module[1:])  # the first ones fill the caches


def in_threads(model, count, meshes, focused=False):
    """Seconds for so many meshes, by so many threads."""
    least, largest = model.bounds
    middle, radius = (least + largest) / 2, (largest - least).min() / 8

    def work():
        with model.explore() as own:
            for number in range(meshes // count):
                if focused:
                    own.mesh(error=4 * error_of(number), focus=tan.sphere(middle, radius, error=asked.error))
                else:
                    own.mesh(error=error_of(number))

    def all_threads():
        threads = [threading.Thread(target=work) for _ in range(count)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    return seconds(all_threads)


def gained(model, focused):
    """How many times as fast two threads are as one."""
    one, two = zip(*[(in_threads(model, 1, 4, focused), in_threads(model, 2, 4, focused)) for _ in range(asked.rounds)])
    return statistics.median(one) / statistics.median(two)


opened = tan.open(asked.model)
size = opened.size_at(error=asked.error)
of_library, of_module = against_the_library(opened)
print(f"{size.tetrahedra:,} tetrahedra at {asked.error:g} %: the library {of_library:.4f} s, the module {of_module:.4f} s, "
      f"{of_module / of_library:.3f} times; two threads {gained(opened, False):.2f} times one, with a focus {gained(opened, True):.2f} times")
