#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""work_test.py FOLDER: long work: threads, progress, Ctrl-C; files that the program `tan` reads; the server."""
import _thread
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest
import urllib.request

from module import FOLDER, ModuleTest, np, skip, tan

try:
    from tan import _program
    PROGRAM = _program.program()
except tan.Error as missing:
    skip(missing)


def bumpy(size):
    return np.random.default_rng(1).random((size,) * 3, dtype="f4")


class Work(ModuleTest):
    def test_progress(self):
        told = []
        here = threading.get_ident()
        tan.build(bumpy(24), self.folder / "told.tan", progress=lambda fraction, text: told.append((fraction, text, threading.get_ident())))
        self.assertGreater(len(told), 0)
        self.assertTrue(all(0 <= fraction <= 1 and isinstance(text, str) and thread == here for fraction, text, thread in told), told)

    def test_bars(self):
        class Bar:
            def __init__(self, total=None):
                self.total, self.n, self.closed, self.said = total, 0, False, set()
                bars.append(self)

            def update(self, n):
                self.n += n

            def set_description_str(self, text, refresh=True):
                self.said.add(text)

            def close(self):
                self.closed = True

        bars = []
        tan.build(bumpy(24), self.folder / "bar.tan", progress=Bar)
        tan.build(bumpy(12), self.folder / "bar.tan", progress=Bar(total=4))
        self.assertEqual([(round(bar.n, 6), bar.closed) for bar in bars], [(100, True), (4, False)])

    def test_what_progress_raises_stops_the_work(self):
        def stop(fraction, text):
            raise LookupError("enough")

        path = self.folder / "stopped.tan"
        with self.assertRaisesRegex(LookupError, "enough"):
            tan.build(bumpy(40), path, progress=stop)
        self.assertFalse(path.exists())
        self.assertEqual([name for name in os.listdir(self.folder) if "stopped" in name], [])

    def interrupted(self, work):
        """How long it takes from Ctrl-C until the exception is there."""
        sent = []

        def send():
            time.sleep(0.4)
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        sender = threading.Thread(target=send)
        sender.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                work()
            return time.monotonic() - sent[0]
        finally:
            sender.join()

    def test_ctrl_c(self):
        data = tan.Lattice(bumpy(100))
        data.dataset()
        path = self.folder / "never.tan"
        places = np.zeros((20_000_000, 3))
        mesh = self.ball.mesh(error=0)
        mesh.sample(places[:1])
        waits = [self.interrupted(work) for work in (lambda: tan.build(data, path, method="refinement", block="none"),
                                                     lambda: tan.build(data, path, method="refinement", block=20), lambda: mesh.sample(places))]
        self.assertFalse(path.exists())
        self.assertEqual([name for name in os.listdir(self.folder) if "never" in name], [])
        print("Ctrl-C after", ", ".join(f"{1000 * wait:.0f} ms" for wait in waits))  # others may work on this machine: not judged

    def test_others_go_on_meanwhile(self):
        count, ends = [0], threading.Event()

        def counting():
            while not ends.is_set():
                count[0] += 1
                time.sleep(0.001)

        other = threading.Thread(target=counting)
        other.start()
        tan.build(bumpy(32), self.folder / "others.tan")
        ends.set()
        other.join()
        self.assertGreater(count[0], 10)

    def test_two_threads(self):
        wanted = {error: self.ball.mesh(error=error).tetrahedra.copy() for error in (0, 1, 5, 20)}
        failures = []

        def ask(errors):
            try:
                for error in errors:
                    mesh = self.ball.mesh(error=error)
                    np.testing.assert_array_equal(mesh.tetrahedra, wanted[error])
                    mesh.isosurface(0.5)
                    mesh.sample([[0, 0, 0.1]])
            except Exception as failure:  # noqa: BLE001
                failures.append(failure)

        threads = [threading.Thread(target=ask, args=(errors * 3,)) for errors in ((0, 5), (20, 1), (5, 0))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])

    def test_one_mesh_in_two_threads(self):
        mesh = self.ball.mesh(error=1)
        areas = []
        threads = [threading.Thread(target=lambda: areas.append(mesh.isosurface(0.7).area())) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(set(areas)), 1)
        self.assertEqual(len(areas), 4)

    def test_ends_while_working(self):
        """A program that ends with work in a thread that nobody waits for ends."""
        code = ("import sys, threading, time; sys.path.insert(0, sys.argv[1]); import numpy as np, tan\n"
                "data = tan.Lattice(np.random.default_rng(1).random((60,) * 3))\n"
                "threading.Thread(target=lambda: tan.build(data, sys.argv[2]), daemon=True).start(); time.sleep(0.3)\n")
        ended = subprocess.run([sys.executable, "-c", code, str(FOLDER), str(self.folder / "daemon.tan")], timeout=120, check=False,
                               capture_output=True, text=True)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))


class Files(ModuleTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        values = cls.distances.astype("<f4")
        header = ("NRRD0004\ntype: float\ndimension: 3\nsizes: 13 13 13\nencoding: raw\nendian: little\n"
                  "space dimension: 3\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n\n")
        cls.file = cls.folder / "ball.nrrd"
        cls.file.write_bytes(header.encode() + values.tobytes())

    def test_a_file(self):
        m = tan.build(self.file, self.folder / "file.tan", error=1, method="refinement", block="none")
        mesh = m.mesh(error=2)
        i, j, k = mesh.points.astype(int).T
        np.testing.assert_allclose(mesh.values, self.distances[k, j, i], rtol=1e-6)
        self.assertEqual(m.provenance["source"], "ball.nrrd")
        self.assertLessEqual(m.levels["error"][-1], 1)
        verdict = m.verify(self.file, levels=[5])
        self.assertTrue(verdict, verdict.text)
        self.assertEqual(tan.open(m.path).remarks, ())
        np.save(self.folder / "told.npy", np.zeros((3, 4, 5)) + np.arange(5))
        remarks = tan.build(self.folder / "told.npy", self.folder / "told.tan").remarks
        self.assertTrue(any(remark.startswith("a guess: the array's dimensions are") for remark in remarks), remarks)
        self.assertTrue(any("does not state its spacing" in remark for remark in remarks), remarks)
        other = self.folder / "other.nrrd"
        other.write_bytes(self.file.read_bytes()[:-4] + np.float32(0.5).tobytes())
        refuted = m.verify(other, levels=[5])
        self.assertFalse(refuted.ok)
        part = tan.build(str(self.file), self.folder / "part.tan", options={"stride": 2})
        self.assertEqual(part.shape, (7, 7, 7))

    def test_files_that_are_none(self):
        self.refused(OSError, "none.nrrd.*does not exist", tan.build, self.folder / "none.nrrd", self.folder / "x.tan")
        (self.folder / "text.nrrd").write_text("nothing")
        self.refused(tan.BadInput, "text.nrrd", tan.build, self.folder / "text.nrrd", self.folder / "x.tan")
        (self.folder / "red.bov").write_bytes(b"DATA_FILE: red\x1b[31m.raw\nDATA_SIZE: 4 4 4\nDATA_FORMAT: FLOAT\nVARIABLE: a\n")
        self.assertNotIn("\x1b", str(self.refused(tan.BadInput, r"red\\x1b\[31m.raw", tan.build, self.folder / "red.bov", self.folder / "x.tan")))
        self.refused(tan.WrongUsage, "magic", tan.build, self.file, self.folder / "x.tan", method="magic")
        self.refused(tan.WrongUsage, "nothing", tan.build, self.file, self.folder / "x.tan", options={"nothing": 1})
        self.refused(tan.WrongUsage, "option", tan.build, self.file, self.folder / "x.tan", options={"; ls": 1})
        self.refused(tan.WrongUsage, "spacing", tan.build, self.file, self.folder / "x.tan", spacing=(1, 1, 1))
        self.refused(OSError, "nowhere", tan.build, self.file, self.folder / "nowhere" / "x.tan")

    def large_file(self):
        size = 100
        large = self.folder / "large.nrrd"
        large.write_bytes(f"NRRD0004\ntype: float\ndimension: 3\nsizes: {size} {size} {size}\nencoding: raw\nendian: little\n\n".encode()
                          + bumpy(size).tobytes())
        return large

    def test_killed(self):
        """The program does not go on for nobody."""
        code = "import sys; sys.path.insert(0, sys.argv[1]); import tan; tan.build(sys.argv[2], sys.argv[3], method='refinement')"
        target = self.folder / "killed.tan"
        running = subprocess.Popen([sys.executable, "-c", code, str(FOLDER), str(self.large_file()), str(target)], stderr=subprocess.DEVNULL)
        try:
            self.until(lambda: self.builds(target))
        finally:
            running.kill()
            running.wait()
        self.until(lambda: not self.builds(target))
        self.assertEqual([name for name in os.listdir(self.folder) if "killed" in name], [])

    @staticmethod
    def builds(target):
        """Processes that build this model."""
        found = []
        for command in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = command.read_bytes().split(b"\0")
            except OSError:  # it has ended
                continue
            if b"build" in words and str(target).encode() in words:
                found.append(command)
        return found

    def until(self, holds, seconds=60):
        end = time.monotonic() + seconds
        while not holds():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def test_ctrl_c(self):
        large = self.large_file()
        timer = threading.Timer(1, _thread.interrupt_main)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            tan.build(large, self.folder / "never.tan", method="refinement")
        timer.join()
        self.assertEqual([name for name in os.listdir(self.folder) if "never" in name], [])

    def test_the_server(self):
        served = self.folder / "served"
        served.mkdir()
        (served / "ball.tan").write_bytes(pathlib.Path(self.ball.path).read_bytes())
        os.environ["XDG_CACHE_HOME"] = str(self.folder / "cache")
        with tan.serve(served) as server:
            self.assertIn(b"ball.tan", urllib.request.urlopen(server.address, timeout=30).read())
            remote = tan.open(server.address + "ball.tan", error=5)
            np.testing.assert_array_equal(remote.mesh(error=5).tetrahedra, self.ball.mesh(error=5).tetrahedra)
            there = tan.open("tan+" + server.address + "ball.tan")
            self.assertAlmostEqual(there.mesh(error=5).volume(), 8)
        self.refused(tan.Error, ".", tan.open, server.address + "other.tan")
        self.refused(tan.Error, "nowhere", tan.serve, self.folder / "nowhere")


if __name__ == "__main__":
    unittest.main()
