#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""leaks_test.py FOLDER: thousands of calls do not let the process grow, arrays keep what they show and no longer, exceptions keep nothing;
fork, faulthandler and Ctrl-C while a mesh is made. ./dev soak (TAN_SOAK) makes ten times as many calls."""
import contextlib
import ctypes
import gc
import os
import pathlib
import resource
import signal
import subprocess
import sys
import threading
import time
import traceback
import unittest
import weakref

from module import FOLDER, SANITIZED, ModuleTest, np, tan

CALLS = 100_000 if os.environ.get("TAN_SOAK") else 10_000
MEGABYTE = 1 << 20
IN_PARALLEL = ("a surface", "progress", "progress that raises")  # of quick_calls(): what is divided among threads


class Heap(ctypes.Structure):
    """What mallinfo2 of the GNU C library gives."""

    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks",
                                                     "keepcost")]


try:
    mallinfo = ctypes.CDLL(None).mallinfo2
    mallinfo.restype = Heap
except AttributeError:
    mallinfo = None
if SANITIZED:
    mallinfo = None  # it counts nothing


def resident():
    """Bytes of this process in memory, but for those that the allocator keeps for later: how many threads ran at once says how many these are."""
    gc.collect()
    with contextlib.suppress(AttributeError):
        ctypes.CDLL(None).malloc_trim(0)
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def in_use():
    """Bytes that were allocated and not freed, which does not depend on what the allocator keeps."""
    gc.collect()
    heap = mallinfo()
    return heap.uordblks + heap.hblkhd


def quick_calls(model, folder):
    """Calls that are over at once, by what they are about; among them some that raise."""
    mesh, view, missing = model.mesh(error=20), tan.View(mode="slice"), folder / "none.tan"
    surface = mesh.isosurface(0.7)
    places = np.random.default_rng(1).uniform(-1, 1, (5, 3))
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]

    def refused(kind, call, *arguments, **keywords):
        try:
            call(*arguments, **keywords)
        except kind:
            return
        raise AssertionError(f"{call} was to be refused")

    return {
        "views of a mesh": lambda: (mesh.points, mesh.values, mesh.tetrahedra, mesh.sites),
        "parts of views": lambda: mesh.points[::2].T.base is not None,
        "properties of a mesh": lambda: (mesh.error, mesh.warping, mesh.scale, mesh.volume(), repr(mesh)),
        "views of a surface": lambda: (surface.points, surface.normals, surface.triangles, surface.values, surface.area()),
        "properties of a model": lambda: (model.bounds, model.range, model.provenance, model.shape, model.spacing, model.directions, model.dtype,
                                          repr(model)),
        "sizes": lambda: (model.size_at(error=3), model.size_at(budget=900), model.levels["error"].max()),
        "values at places": lambda: (mesh.sample(places), mesh.sample(places[0])),
        "a mesh": lambda: model.mesh(error=20).points,
        "a surface": lambda: (mesh.isosurface(0.9).points, mesh.slice((0, 0, 1), 0.1).values),
        "progress": lambda: mesh.isosurface(0.9, progress=lambda fraction, text: None),
        "data": lambda: tan.Points(corners, [1, 2, 3, 4]).range,
        "a view": lambda: (view.changed(azimuth=3, isovalues=[0.5]).text, tan.View.from_text(view.text).mode),
        "opening": lambda: tan.open(model.path).sites,
        "a wrong number": lambda: refused(tan.WrongUsage, model.mesh, error=float("nan")),
        "a wrong type": lambda: refused(TypeError, mesh.sample, [["a", "b", "c"]]),
        "a wrong field": lambda: refused(tan.WrongUsage, model.mesh, field="none"),
        "a missing file": lambda: refused(tan.BadInput, tan.open, missing),
        "wrong data": lambda: refused(tan.BadInput, lambda: tan.Lattice(np.full((2, 2, 2), np.nan)).range),
        "progress that raises": lambda: refused(ZeroDivisionError, mesh.isosurface, 0.9, progress=lambda fraction, text: 1 / 0),
    }


class Memory(ModuleTest):
    def repeated(self, calls, count):
        """So many calls, each kind in turn."""
        for number in range(count):
            calls[number % len(calls)]()

    def check_growth(self, calls, count):
        """The process is as large after so many calls as after a fifth of them."""
        self.repeated(calls, count // 5)
        pages, objects = resident(), sys.getallocatedblocks()
        self.repeated(calls, count - count // 5)
        self.assertLess(resident() - pages, 2 * MEGABYTE)
        self.assertLess(sys.getallocatedblocks() - objects, count // 20)

    @unittest.skipIf(SANITIZED, "the sanitizer keeps what is freed")
    def test_thousands_of_calls(self):
        self.check_growth([call for name, call in quick_calls(self.ball, self.folder).items() if name not in IN_PARALLEL], CALLS)

    # TBB keeps some 10 kB for every thread that ever worked in parallel.
    @unittest.skipIf(SANITIZED, "the sanitizer keeps what is freed")
    def test_hundreds_of_parallel_calls(self):
        self.check_growth([call for name, call in quick_calls(self.ball, self.folder).items() if name in IN_PARALLEL], CALLS // 20)

    @unittest.skipIf(mallinfo is None, "no mallinfo2")
    def test_each_kind_of_call(self):
        """Not a byte for each call, but for what others keep meanwhile."""
        for name, call in quick_calls(self.ball, self.folder).items():
            with self.subTest(name):
                grown = []
                for _ in range(10):  # what is made only once may be made late, but what leaks leaks each time
                    before, objects = in_use(), sys.getallocatedblocks()
                    self.repeated([call], 60)
                    grown.append((in_use() - before, sys.getallocatedblocks() - objects))
                    if grown[-1][0] < 16 * 60 and grown[-1][1] < 30:
                        break
                else:
                    self.fail(f"bytes and objects of 60 calls: {grown}")

    @unittest.skipIf(mallinfo is None, "no mallinfo2")
    def test_views_keep_their_memory_and_no_longer(self):
        mesh = self.ball.mesh(error=0)
        size = mesh.points.nbytes + mesh.values.nbytes + mesh.tetrahedra.nbytes + mesh.sites.nbytes
        del mesh
        before = in_use()
        parts = []
        for _ in range(20):
            parts.append(self.ball.mesh(error=0).tetrahedra[5:6, 1:])
            self.ball.mesh(error=50)
        self.assertGreater(in_use() - before, 18 * size, "a part of a view keeps the mesh")
        for part in parts:
            np.testing.assert_array_equal(part, parts[0])
        del part
        parts.clear()
        self.assertLess(in_use() - before, 2 * size, "nothing keeps it any more")

    def test_objects_end(self):
        """Nothing keeps a model, a mesh or a surface but those who use them."""
        model = tan.open(self.ball.path)
        mesh = model.mesh(error=5)
        surface = mesh.isosurface(0.7)
        kept = [mesh.points, surface.triangles, model.levels]
        ends = [weakref.ref(thing) for thing in (model, mesh, surface, model._held, mesh._held, surface._held)]
        del model, mesh, surface
        gc.collect()
        self.assertEqual([end() for end in ends], [None] * len(ends))
        self.assertTrue(all(len(array) for array in kept))

    def test_arrays_that_were_given_end(self):
        values, places = np.random.default_rng(2).random((6, 6, 6)), np.random.default_rng(3).random((9, 3))
        ends = [weakref.ref(values), weakref.ref(places)]
        data = tan.Lattice(values)
        self.assertGreater(data.range[1], 0)
        del values
        gc.collect()
        self.assertIsNotNone(ends[0](), "data that are not copied keep their array")
        tan.build(data, self.folder / "kept.tan").sample(places)
        del data, places
        gc.collect()
        self.assertEqual([end() for end in ends], [None, None])

    def failing(self, ends):
        """Objects that are in use when an exception is raised."""
        model = tan.open(self.ball.path)
        mesh = model.mesh(error=10)
        values = np.random.default_rng(4).random((6, 6, 6))
        data = tan.Lattice(values)

        class Told:
            def __call__(self, fraction, text):
                raise LookupError("enough")

        told = Told()
        ends += [weakref.ref(thing) for thing in (model, mesh, values, data, told, model._held, mesh._held)]
        for call in (lambda: model.mesh(error=-1), lambda: model.mesh(field="none"), lambda: mesh.sample([["a"]]), lambda: mesh.slice((0, 0, 0), 1),
                     lambda: tan.build(data, self.folder / "nowhere" / "a.tan"), lambda: tan.build(data, self.folder / "a.tan", progress=told),
                     lambda: mesh.isosurface(0.7, progress=told), lambda: model.pack(self.folder), lambda: model.render(size=(9, 9), mode="none")):
            try:
                call()
            except (tan.Error, TypeError, LookupError):
                continue
            self.fail("was to raise")

    def test_objects_end_after_exceptions(self):
        ends = []
        self.failing(ends)
        gc.collect()
        self.assertEqual([end() for end in ends], [None] * 7)


BEGINNING = "import sys; sys.path.insert(0, sys.argv[1]); import faulthandler, os, signal, numpy as np, tan\nm = tan.open(sys.argv[2])\n"


class Processes(ModuleTest):
    def ended(self, code, seconds=600 if SANITIZED else 60):
        """A program that has the model open as `m`, until it ends."""
        return subprocess.run([sys.executable, "-c", BEGINNING + code, str(FOLDER), str(self.ball.path)], cwd=self.folder, timeout=seconds,
                              check=False,
                              capture_output=True, text=True)

    def test_fork(self):
        """A process that has built, extracted and drawn can be forked; the child does the same, and ends in either way."""
        code = ("def use(name):\n"
                "    built = tan.build(np.random.default_rng(1).random((16,) * 3), name)\n"
                "    surface, sizes = tan.open(sys.argv[2]).mesh(error=2).isosurface(0.7), (len(m.mesh(error=2).points), "
                "len(built.mesh(error=0).points))\n"
                "    return sizes, surface.area(), m.render(size=(16, 12), samples=1).tolist(), m.sample([[0, 0, 0.1]]).tolist()\n"
                "wanted = use('parent.tan')\n"
                "for end in (os._exit, sys.exit):\n"
                "    child = os.fork()\n"
                "    if child == 0:\n"
                "        end(0 if use('child.tan') == wanted else 3)\n"
                "    print(os.waitpid(child, 0)[1])\n"
                "print(use('parent.tan') == wanted)\n")
        done = self.ended(code)
        self.assertEqual((done.returncode, done.stdout.split(), done.stderr), (0, ["0", "0", "True"], ""))

    @unittest.skipIf(SANITIZED, "signals of faults are the sanitizer's")
    def test_faulthandler(self):
        """It tells where the program was, also while the module works; the module leaves the handlers of signals as they are."""
        told = self.ended("before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGSEGV)]\nfaulthandler.enable()\n"
                          "m.mesh(error=1).isosurface(0.7)\n"
                          "print(before == [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGSEGV)], flush=True)\n"
                          "def broken():\n    os.kill(os.getpid(), signal.SIGSEGV)\nbroken()\n")
        self.assertEqual((told.returncode, told.stdout), (-signal.SIGSEGV, "True\n"))
        self.assertRegex(told.stderr, "(?s)Segmentation fault.*in broken")
        told = self.ended("values = np.random.default_rng(1).random((100,) * 3, dtype='f4')\nfaulthandler.dump_traceback_later(0.3, exit=True)\n"
                          "tan.build(values, 'never.tan')\n")
        self.assertEqual(told.returncode, 1, told.stderr)
        self.assertRegex(told.stderr, r"(?s)Timeout.*_build\.py")

    @unittest.skipIf(SANITIZED, "the sanitizer needs terabytes of addresses")
    def test_too_little_memory(self):
        """An exception, and the program goes on."""
        code = ("import resource\nmesh, places = m.mesh(error=0), np.zeros((1, 3))\n"
                "size = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
                "def limited(to):\n    resource.setrlimit(resource.RLIMIT_AS, (to, resource.RLIM_INFINITY))\n"
                "mesh.sample(places), m.mesh(error=0)\n"
                "limited(size + (64 << 20))\n"
                "for call in (lambda: m.render(size=(9000, 9000), samples=1), "
                "lambda: tan.Lattice(np.broadcast_to(np.uint8(1), (2000, 2000, 2000))).range):\n"
                "    try:\n        call()\n        print('taken')\n"
                "    except MemoryError as problem:\n        print('bad_alloc' not in str(problem) and len(str(problem)) > 9)\n"
                "limited(resource.RLIM_INFINITY)\nprint(len(m.mesh(error=0).points) == len(mesh.points))\n")
        done = self.ended(code)
        self.assertEqual((done.returncode, done.stdout.split()), (0, ["True"] * 3), done.stderr)


class Interrupted(ModuleTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.large = tan.build(np.random.default_rng(1).random((48,) * 3, dtype="f4"), cls.folder / "large.tan")

    def interrupted(self, work):
        """Ctrl-C while the work is done again and again; once more if it met this loop and not the module."""
        for delay in (0.08, 0.05, 0.03, 0.02, 0.01) * 3:
            sender = threading.Timer(delay, os.kill, (os.getpid(), signal.SIGINT))
            try:
                sender.start()
                while sender.is_alive():
                    work()
                time.sleep(0.1)
            except KeyboardInterrupt as caught:
                frames = [frame.filename for frame in traceback.extract_tb(caught.__traceback__)]
                if any(os.path.dirname(name).endswith("tan") for name in frames):
                    return
            finally:
                sender.join()
        self.fail("the work was never interrupted")

    def test_extraction(self):
        focus = tan.sphere((24, 24, 24), 20, error=0)
        whole = self.large.mesh(error=40)
        wanted = whole.tetrahedra.copy()
        self.interrupted(lambda: self.large.mesh(error=50, focus=focus, method="insertion"))
        self.interrupted(lambda: [self.large.mesh(error=error) for error in (0, 60, 0, 60, 0)])
        self.interrupted(lambda: self.large.mesh(error=0).isosurface(0.5))
        np.testing.assert_array_equal(self.large.mesh(error=40).tetrahedra, wanted)
        np.testing.assert_array_equal(whole.tetrahedra, wanted)
        self.assertAlmostEqual(self.large.mesh(error=0).volume(), 47**3, delta=1)
        self.assertGreater(self.large.mesh(error=40).isosurface(0.5).area(), 0)


if __name__ == "__main__":
    unittest.main()
