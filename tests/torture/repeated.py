# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of ./dev test that repeat more of what they do, with chances of their own, and tests that are too long for it: those that
ctest knows by the labels `repeated`, `soak` and `latency` (tests/CMakeLists.txt)."""
import json
import pathlib
import subprocess
from dataclasses import dataclass

HANGS_AFTER = 1800
PASSED, SKIPPED = 0, 77


@dataclass(frozen=True)
class Test:
    name: str
    command: tuple
    environment: dict
    folder: pathlib.Path


def tests_of(bench, label):
    """In the order of their names."""
    def ask():
        told = subprocess.run(["ctest", "--show-only=json-v1", "-L", "^%s$" % label], cwd=bench.build, capture_output=True, check=True)
        found = []
        for one in json.loads(told.stdout)["tests"]:
            properties = {prop["name"]: prop["value"] for prop in one["properties"]}
            environment = dict(word.split("=", 1) for word in properties.get("ENVIRONMENT", ()))
            found.append(Test(one["name"], tuple(one["command"]), environment, pathlib.Path(properties["WORKING_DIRECTORY"])))
        return sorted(found, key=lambda test: test.name)
    return bench.once(("tests", label), ask)


def repetitions(bench):
    return tests_of(bench, "repeated") + tests_of(bench, "soak")


def run_test(bench, folder, test, chance):
    seed = chance.randrange(1, 1 << 31)
    (folder / "runtime").mkdir(mode=0o700)
    own = {"HOME": "", "XDG_CONFIG_HOME": "config", "XDG_DATA_HOME": "data", "XDG_CACHE_HOME": "cache", "XDG_RUNTIME_DIR": "runtime"}
    environment = {**test.environment, **{name: str(folder / place) for name, place in own.items()}, "TAN_SOAK": str(seed),
                   "QTEST_FUNCTION_TIMEOUT": str(HANGS_AFTER * 1000)}
    process = bench.start(test.command, test.folder, environment=environment, stderr=subprocess.STDOUT)
    ran = bench.finish(process, hangs_after=HANGS_AFTER)
    if crash := ran.crash():
        return "failed", ["%s, TAN_SOAK=%d: %s" % (test.name, seed, crash)]
    if ran.code in (PASSED, SKIPPED):
        return "skipped" if ran.code == SKIPPED else "passed", []
    lines = ran.out.decode("utf-8", "replace").splitlines()
    # QtTest marks them; of others the end tells most.
    wrong = [line for line in lines if line.startswith(("FAIL!", "   Loc:", "QFATAL"))] or lines[-5:]
    return "failed", ["%s, TAN_SOAK=%d: %s" % (test.name, seed, " ".join(wrong)[:500])]


def repeated(bench, folder, chance, number):
    return run_test(bench, folder, repetitions(bench)[number], chance)


def latency(bench, folder, chance, number):
    return run_test(bench, folder, tests_of(bench, "latency")[number], chance)
