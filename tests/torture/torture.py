# SPDX-License-Identifier: GPL-3.0-or-later
"""./dev soak: repeats what went wrong with programs of this kind, thousands of times: kills, damage, cut and mutated files, full disks,
failed allocations and writes, tight limits, signals, races, data of hard shapes, and the tests that do more here than in ./dev test.
Nothing may crash, hang, be wrong with exit code 0, be lost, or be left behind.

    torture.py BUILD [--only PART,...] [--seed S] [--count N] [--number I] [--minutes M] [--short] [--report FILE]

Attempt I of a part depends on the seed and I alone (and, where a program is killed, on the moment that the machine gives it):
--only PART --seed S --number I repeats it and keeps its folder. What is done is kept in BUILD/torture: a run that was stopped goes on
where it was, with its seed; when it is done, and for another program, another one begins, with another seed."""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import random
import shutil
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import parts  # noqa: E402
from bench import Bench  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SHORT_SEED = 1
DONE, FAILED, UNFINISHED = 0, 1, 2  # exit codes


def fingerprint(build):
    """Of the program and of the tests: what another one did tells nothing of this one."""
    found = hashlib.sha256()
    for path in sorted(build.glob("bin/tan")) + sorted(build.glob("lib/**/*.so*")) + sorted(build.glob("tests/tests-*")):
        if path.is_file():
            found.update(path.read_bytes())
    return found.hexdigest()[:16]


class Journal:
    """A line of JSON for each attempt, written when it is done."""

    def __init__(self, path, keep):
        self.done = {}
        self.lock = threading.Lock()
        if keep and path.is_file():
            for line in path.read_text().splitlines():
                try:
                    entry = json.loads(line)
                except ValueError:
                    continue  # the last line of a run that was killed
                self.done[entry["number"]] = entry
        self.file = open(path, "a" if keep else "w", encoding="utf-8")

    def add(self, entry):
        with self.lock:
            self.done[entry["number"]] = entry
            self.file.write(json.dumps(entry) + "\n")
            self.file.flush()


def attempt(bench, part, seed, number, keep_folder=False):
    """One attempt in a folder of its own: what was tried, and what went wrong."""
    folder = bench.work / ("%s-%d-%d" % (part.name, seed, number))
    for old in (folder, bench.cache(folder)):
        shutil.rmtree(old, ignore_errors=True)
    folder.mkdir(parents=True)
    chance = random.Random("%s:%d:%d" % (part.name, seed, number))
    try:
        outcome, failures, *counts = part.attempt(bench, folder, chance, number)
    except Exception as problem:  # a mistake of the bench is no success of the program
        outcome, failures, counts = "bench failed", ["%s: %s" % (type(problem).__name__, problem)], []
    if not keep_folder:
        for old in (folder, bench.cache(folder)):
            shutil.rmtree(old, ignore_errors=True)
    return {"number": number, "outcome": outcome, "failures": failures, "counts": counts[0] if counts else {}}


def run_part(bench, part, seed, numbers, journal, end):
    """Those of the attempts that are done; none begins after the moment `end`."""
    waiting = [number for number in numbers if number not in journal.done]
    began = time.monotonic()

    def attempt_in_time(number):
        return attempt(bench, part, seed, number) if time.monotonic() < end else None

    with concurrent.futures.ThreadPoolExecutor(bench.at_once if part.in_parallel else 1) as pool:
        running = [pool.submit(attempt_in_time, number) for number in waiting]
        for finished, future in enumerate(concurrent.futures.as_completed(running), 1):
            entry = future.result()
            if entry is None:
                continue
            journal.add(entry)
            for failure in entry["failures"]:
                print("FAILED %s --seed %d --number %d: %s" % (part.name, seed, entry["number"], failure), flush=True)
            if finished % 200 == 0:
                left = (time.monotonic() - began) / finished * (len(running) - finished)
                print("%s: %d of %d, %d s left" % (part.name, finished, len(running), left), file=sys.stderr, flush=True)
    return [journal.done[number] for number in numbers if number in journal.done]


def row(part, entries):
    outcomes = collections.Counter(entry["outcome"] for entry in entries)
    failures = sum(1 for entry in entries if entry["failures"])
    told = ", ".join("%s %s" % (format(n, ","), outcome) for outcome, n in outcomes.most_common())
    counts = collections.Counter()
    for entry in entries:
        counts.update(entry.get("counts", {}))
    if counts:
        told += "; in all " + ", ".join("%s %s" % (format(n, ","), name) for name, n in counts.items())
    return "| %s | %s | %s | %s | %d |" % (part.name, part.purpose, format(len(entries), ","), told, failures)


def write_report(path, rows, seed, machine):
    begin, end = "<!-- table -->", "<!-- end of table -->"
    text = path.read_text(encoding="utf-8")
    head, rest = text.split(begin, 1)
    tail = rest.split(end, 1)[1]
    table = ["", "Seed %d, %s." % (seed, machine), "", "| part | what is done | attempts | what came of them | failures |",
             "|---|---|---|---|---|"] + rows + [""]
    partial = path.with_suffix(".new")
    partial.write_text(head + begin + "\n".join(table) + end + tail, encoding="utf-8")
    os.replace(partial, path)


def arguments():
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    reader.add_argument("build", type=pathlib.Path, help="the folder of the build")
    reader.add_argument("--only", default="", help="these parts alone: " + ", ".join(part.name for part in parts.PARTS))
    reader.add_argument("--seed", type=int, help="that of the chances; one that was not used yet without it")
    reader.add_argument("--count", type=int, help="so many attempts in place of each part's own number")
    reader.add_argument("--number", type=int, help="this attempt alone, and keep its folder")
    reader.add_argument("--minutes", type=float, default=90, help="no attempt begins after so many (90)")
    reader.add_argument("--short", action="store_true", help="one or two of everything, in less than a minute")
    reader.add_argument("--report", type=pathlib.Path, help="write the table into this page")
    return reader.parse_args()


def seed_of(asked, home, same_program):
    """That which was asked for, that of the run that was stopped, or a new one; kept in the file `seed`."""
    if asked.short:
        return SHORT_SEED if asked.seed is None else asked.seed
    kept = home / "seed"
    seed = asked.seed
    if seed is None and same_program and kept.is_file():
        seed = int(kept.read_text())
        print("Going on with the run of seed %d." % seed, flush=True)
    if seed is None:
        seed = int.from_bytes(os.urandom(4), "little")
    kept.write_text(str(seed))
    print("Seed %d." % seed, flush=True)
    return seed


def main():
    asked = arguments()
    end = time.monotonic() + 60 * asked.minutes
    names = [name for name in asked.only.split(",") if name]
    chosen = [part for part in parts.PARTS if not names or part.name in names]
    unknown = set(names) - {part.name for part in chosen}
    if asked.short:
        chosen = [part for part in chosen if part.short]
    if unknown:
        sys.exit("There is no part '%s'." % "', '".join(sorted(unknown)))
    build = asked.build.resolve()
    home = build / ("torture-short" if asked.short else "torture")
    home.mkdir(parents=True, exist_ok=True)
    bench = Bench(build, SOURCE, home, asked.short)

    if asked.number is not None:
        if asked.seed is None:
            sys.exit("--number needs --seed: which run is it that an attempt is repeated of?")
        bad = 0
        for part in chosen:
            entry = attempt(bench, part, asked.seed, asked.number, keep_folder=True)
            print(json.dumps(entry, indent=2))
            bad += len(entry["failures"])
        sys.exit(1 if bad else 0)

    mark = home / "program"
    same = mark.is_file() and mark.read_text() == fingerprint(build) and not asked.short
    mark.write_text(fingerprint(build))
    if not same:
        for journal in home.glob("*.jsonl"):
            journal.unlink()
    seed = seed_of(asked, home, same)
    rows, failures, missing = [], 0, 0
    for part in chosen:
        if time.monotonic() >= end:
            missing += 1
            continue
        numbers = part.some_numbers(bench) if asked.short else part.numbers(bench, asked.count)
        began = time.monotonic()
        entries = run_part(bench, part, seed, numbers, Journal(home / ("%s-%d.jsonl" % (part.name, seed)), same), end)
        missing += len(entries) < len(numbers)
        rows.append(row(part, entries))
        failures += sum(1 for entry in entries if entry["failures"])
        print("%s  [%.0f s]" % (rows[-1], time.monotonic() - began), flush=True)
    if missing:
        print("The %g minutes are over, and %d parts are not done: the same command goes on from here." % (asked.minutes, missing))
        sys.exit(FAILED if failures else UNFINISHED)
    whole = not names and asked.count is None
    if whole and not asked.short:
        (home / "seed").unlink()  # the next run takes another one
    if asked.report and whole:
        write_report(asked.report, rows, seed, bench.machine())
    sys.exit(FAILED if failures else DONE)


if __name__ == "__main__":
    main()
