#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mpi_build.py BUILD MPIEXEC: a model built by the ranks of an MPI job has the bytes of one that a single process builds in the same
blocks, for lattices and for grids whose blocks agree in rounds; a job that fails or is stopped says so, and goes on when it is started
again."""
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

BUILD, MPIEXEC = pathlib.Path(sys.argv[1]), sys.argv[2]
TAN, TAN_MPI = BUILD / "bin/tan", BUILD / "bin/tan-mpi"
# Both kinds of MPI look at what they know: Open MPI refuses the superuser and more ranks than cores unless it is told otherwise.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "OMPI_MCA_plm": "isolated", "OMPI_MCA_btl": "self,vader", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}


def starts():
    """Whether jobs can be started here at all."""
    try:
        return subprocess.run([MPIEXEC, "-n", "2", "true"], env=ENVIRONMENT, capture_output=True, timeout=60, check=False).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


class MpiBuild(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def tan(self, *words):
        subprocess.run([TAN, *words], cwd=self.folder, capture_output=True, check=True)

    def job(self, ranks, *words):
        return [MPIEXEC, "-n", str(ranks), TAN_MPI, *words]

    def run_job(self, ranks, *words):
        return subprocess.run(self.job(ranks, *words), cwd=self.folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=120,
                              check=False)

    def hash_of(self, name):
        return hashlib.sha256((self.folder / name).read_bytes()).hexdigest()

    def same(self, data, *options):
        self.tan("build", data, *options, "-o", "alone.tan")
        for ranks in (1, 2, 4):
            done = self.run_job(ranks, "build", data, *options, "-o", "model.tan", "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(done.stdout)["model"], "model.tan")
            self.assertEqual(self.hash_of("model.tan"), self.hash_of("alone.tan"), ranks)
            self.assertFalse((self.folder / "model.tan.parts").exists())
            (self.folder / "model.tan").unlink()

    def test_lattice(self):
        self.tan("sample", "marschner-lobb", "--size", "30", "-o", "data.nrrd")
        self.same("data.nrrd", "--block", "7", "--error", "0.5")

    def test_grid_in_rounds(self):
        self.tan("sample", "o-grid", "--size", "20", "-o", "grid.xyz")
        self.same("grid.xyz", "--builder", "refinement", "--block", "6")

    def test_a_job_that_was_stopped_goes_on(self):
        self.tan("sample", "noise", "--size", "84", "-o", "data.nrrd")
        self.tan("build", "data.nrrd", "--block", "8", "-o", "alone.tan")
        job = subprocess.Popen(self.job(2, "build", "data.nrrd", "--block", "8", "-o", "model.tan", "--parts", "shared"), cwd=self.folder,
                               env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        deadline = time.monotonic() + 60
        while sum(part.stat().st_size for part in self.folder.glob("shared/part-*")) < 1_000_000 and time.monotonic() < deadline:
            time.sleep(0.01)
        job.send_signal(signal.SIGTERM)
        job.communicate(timeout=60)
        self.assertNotEqual(job.returncode, 0)
        self.assertFalse((self.folder / "model.tan").exists())
        done = self.run_job(2, "build", "data.nrrd", "--block", "8", "-o", "model.tan", "--parts", "shared", "--keep-parts")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.hash_of("model.tan"), self.hash_of("alone.tan"))
        self.assertTrue((self.folder / "shared/part-2-of-2.runs").exists())

    def test_what_cannot_be_built_is_told(self):
        self.tan("sample", "scattered", "--size", "10", "-o", "points.csv")
        for words, code, says in ((("build", "points.csv", "-o", "model.tan"), 2, "cannot be built in parts"),
                                  (("build", "none.nrrd", "-o", "model.tan"), 3, "does not exist"),
                                  (("build", "points.csv"), 2, "Usage: mpirun"), (("info", "points.csv"), 2, "Usage: mpirun")):
            done = self.run_job(2, *words)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(says, done.stderr)
            self.assertFalse((self.folder / "model.tan").exists())


if __name__ == "__main__":
    if not starts():
        print("skipped: no MPI job can be started here")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
