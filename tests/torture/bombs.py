# SPDX-License-Identifier: GPL-3.0-or-later
"""The part 'bombs' of the torture bench: every file of bomb_files.py is shown and built of, with 4 GB of address space and 90 s of the
processor."""
import itertools
import os
import re
import resource
import shutil
import traceback

import bomb_files
from bench import BAD_INPUT, DONE, OUT_OF_RESOURCE, USAGE
from mutants import measured

# A reading program ends after a minute of the processor by itself.
MOST_SPACE, MOST_MEMORY, MOST_SECONDS = 4 << 30, 500 << 20, 90
COMMANDS = (("info", "OPENED"), ("build", "OPENED", "-o", "out.tan", "--error", "5"))
# How the names of those end whose values lie in another file, so that nothing can be built of them: not even of zeros.
ELSEWHERE = "a link", "a link by its whole path", "a virtual array", "values elsewhere"
COUNT = sum(1 for _ in bomb_files.all_bombs())


def announced(said):
    """The most memory that the program says it needs, in bytes."""
    units = {b"MB": 1e6, b"GB": 1e9, b"TB": 1e12}
    return max((float(number) * units[unit] for number, unit in re.findall(rb"(\d+(?:\.\d+)?) ([MGT]B)", said)), default=0)


def wrong(ran, memory, names):
    """What is wrong with the end of a command."""
    if problem := ran.crash():
        return problem
    if ran.processor > MOST_SECONDS:
        return "took %d s of the processor" % ran.processor
    if ran.code not in (DONE, USAGE, BAD_INPUT, OUT_OF_RESOURCE):  # of usage: which columns of a table are x, y and z?
        return "exit code %d: %s" % (ran.code, ran.said())
    if ran.code != DONE and not ran.err.strip():
        return "exit code %d without a word" % ran.code
    if memory > MOST_MEMORY + announced(ran.out):
        return "%d MB of memory" % (memory >> 20)
    if b"%d" % bomb_files.SECRET in ran.out:
        return "read what lies outside: " + ran.said()
    if re.search(rb"[\0-\x08\x0b-\x1f\x7f]", ran.out):
        return "printed control characters"
    left = set(names) - {"out.tan"}
    return "left behind: " + ", ".join(sorted(left)) if left else None


def write_apart(write, place):
    """In a process of its own: some of it is large, and a program begins with the memory of who starts it."""
    if (child := os.fork()) == 0:
        status = 1
        try:
            write(place)
            status = 0
        except BaseException:
            traceback.print_exc()
        os._exit(status)
    _, status = os.waitpid(child, 0)
    assert status == 0, "the bomb cannot be written"


def attempt(bench, folder, _, number):
    kind, name, opened, write = next(itertools.islice(bomb_files.all_bombs(), number, None))
    place = folder / "data"
    place.mkdir()
    bomb_files.secrets(folder)
    write_apart(write, place)
    before = {path.name for path in place.iterdir()}
    failures, codes = [], []
    for command in COMMANDS:
        words = [opened if word == "OPENED" else word for word in command]
        ran, memory = measured(bench, words, place, limits={resource.RLIMIT_AS: MOST_SPACE})
        codes.append(ran.code)
        new = {path.name for path in place.iterdir()} - before
        if problem := wrong(ran, memory, new):
            failures.append("%s, tan %s: %s" % (name, command[0], problem))
        elif command[0] == "build" and ran.code == DONE and name.endswith(ELSEWHERE):
            failures.append("%s: built without the values, which lie elsewhere" % name)
        elif command[0] == "build" and ran.code == DONE:
            shown, _ = measured(bench, ("info", "out.tan"), place)
            if b"%d" % bomb_files.SECRET in shown.out:
                failures.append("%s: built of what lies outside" % name)
    shutil.rmtree(place, ignore_errors=True)
    outcome = "read" if codes[-1] == DONE else "shown" if codes[0] == DONE else "refused"
    return outcome, failures, {kind: 1}
