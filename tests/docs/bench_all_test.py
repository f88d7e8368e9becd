#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench_all_test.py SOURCE: `./dev bench all` with programs that only print what a trial printed once: it survives one that fails, goes
on where it was interrupted, and can be restricted."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(SOURCE / "tests/bench"))
from steps import STEPS  # noqa: E402


class Running(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        (self.folder / "build/bin").mkdir(parents=True)
        for step in STEPS:
            self.write_program(step.program, 'echo \'{"cases": [{"case": "one"}]}\'')

    def write_program(self, name, script):
        path = self.folder / "build/bin" / name
        path.write_text(f"#!/bin/sh\necho {name} >>{self.folder}/log\n{script}\n", encoding="utf-8")
        path.chmod(0o755)

    def run_all(self, *words):
        return subprocess.run([sys.executable, SOURCE / "tests/bench/run_all.py", "--source", self.folder, "--build", self.folder / "build",
                               "--folder", self.folder / "results", "--data", self.folder / "data", *words],
                              capture_output=True, text=True, check=False)

    def results(self):
        return {path.stem for path in (self.folder / "results").glob("*.json")}

    def started(self):
        return (self.folder / "log").read_text(encoding="utf-8").split()

    def test_every_step_leaves_a_result_with_what_made_it(self):
        run = self.run_all()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.results(), {step.name for step in STEPS})
        self.assertRegex(run.stderr, rf"{len(STEPS)} steps, about \d+ minutes")
        self.assertIn(f"[2/{len(STEPS)}] {STEPS[1].name}", run.stderr)
        result = json.loads((self.folder / "results/refinement.json").read_text(encoding="utf-8"))
        self.assertEqual(result["report"], {"cases": [{"case": "one"}]})
        self.assertEqual(result["sizes"]["large"], 128)
        self.assertGreater(result["run"]["cores"], 0)
        self.assertLess(result["run"]["others_share"], 1.01)
        # The paper's tables need the paper's figures, and there is no data here.
        self.assertIsNone(json.loads((self.folder / "results/paper.json").read_text(encoding="utf-8"))["report"])
        self.assertNotIn("tan", self.started())

    def test_one_that_fails_does_not_stop_the_others(self):
        self.write_program("tan-bench-extraction", "exit 4")
        self.write_program("tan-bench-threads", "echo no JSON")
        (self.folder / "build/bin/tan-bench-interaction").unlink()
        (self.folder / "results").mkdir()
        (self.folder / "results/extraction.json").write_text("of an older run", encoding="utf-8")
        run = self.run_all()
        self.assertEqual(run.returncode, 1)
        end = run.stderr.splitlines()[-3:]
        self.assertIn("threads failed: it printed no JSON", end[0])
        self.assertIn("extraction failed: exit code 4", end[1])
        self.assertIn("interaction failed: it cannot be started", end[2])
        self.assertEqual(self.results(), {step.name for step in STEPS} - {"extraction", "threads", "interaction"})

    def test_it_goes_on_with_what_is_missing(self):
        self.write_program("tan-bench-extraction", "exit 4")
        self.assertEqual(self.run_all().returncode, 1)
        (self.folder / "log").unlink()
        self.write_program("tan-bench-extraction", "echo '{}'")
        run = self.run_all("--resume")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.started(), ["tan-bench-extraction"])
        self.assertIn("is there already", run.stderr)

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=self.folder, check=True, capture_output=True)

    def test_only_what_this_revision_has_measured_is_left_out(self):
        def runs(*words):
            (self.folder / "log").unlink(missing_ok=True)
            self.assertEqual(self.run_all("--only", "threads", *words).returncode, 0)
            return (self.folder / "log").exists()
        source = self.folder / "core"
        source.mkdir()
        self.git("init", "-q")
        for revision in ("one", "two"):
            (source / "a.cpp").write_text(revision, encoding="utf-8")
            self.git("add", "core")
            self.git("commit", "-qm", revision)
            self.assertTrue(runs("--resume"), revision)
            self.assertFalse(runs("--resume"), revision)
        self.assertTrue(runs())  # it was not asked for
        (source / "a.cpp").write_text("not committed", encoding="utf-8")
        self.assertTrue(runs("--resume"))
        self.assertTrue(runs("--resume"))

    def test_it_can_be_restricted(self):
        self.assertEqual(self.run_all("--only", "surfaces,threads").returncode, 0)
        self.assertEqual(self.results(), {"surfaces", "threads"})
        run = self.run_all("--only", "surface")
        self.assertEqual(run.returncode, 2)
        self.assertIn("there is no step 'surface'", run.stderr)


unittest.main()
