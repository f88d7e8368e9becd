# SPDX-License-Identifier: GPL-3.0-or-later
"""What the parts of the torture bench share: running programs within limits, whole models and what they answer, folders that are
looked at for what was left behind."""
import json
import os
import platform
import resource
import shutil
import signal
import subprocess
import threading
import time
from dataclasses import dataclass

import inputs

# A command of these takes a fraction of a second; on a machine with other work a few.
HANGS_AFTER = 120
DONE, USAGE, BAD_INPUT, OUT_OF_RESOURCE, CANCELLED = 0, 2, 3, 4, 130


@dataclass
class Ran:
    code: int  # negative: the signal that ended it
    seconds: float
    out: bytes
    err: bytes
    hung: bool = False
    processor: float = 0  # seconds of it, where they were measured

    def crash(self):
        """Why this was no orderly end, or nothing."""
        if self.hung:
            return "hung for %d s" % self.seconds
        if self.code < 0:
            return "ended by " + signal.Signals(-self.code).name
        if b"erminate called" in self.err or b"AddressSanitizer" in self.err or b"runtime error" in self.err:
            return "said " + self.err.decode("utf-8", "replace")[-300:]
        return None

    def said(self):
        return " ".join(self.err.decode("utf-8", "replace").split())[-300:]


def limited(limits):
    """To be called in the child: {resource.RLIMIT_AS: bytes, ...}."""
    def apply():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        for which, most in limits.items():
            resource.setrlimit(which, (most, most))
    return apply


def content(folder):
    """Every file of a folder with its bytes, every folder with None, whatever their names are."""
    found = {}
    for path in sorted(folder.rglob("*")):
        found[str(path.relative_to(folder))] = path.read_bytes() if path.is_file() and not path.is_symlink() else None
    return found


@dataclass(frozen=True)
class Kind:
    """A way to make a model."""
    name: str
    sample: str
    opened: str
    size: int
    options: tuple = ()

    @property
    def is_packed(self):
        return "--packed" in self.options


KINDS = (
    Kind("lattice", "c60", "c60.nrrd", 14),
    Kind("blocks", "marschner-lobb", "ml.nrrd", 17, ("--block", "8")),
    Kind("decimated", "hydrogen", "hydrogen.nrrd", 12, ("--builder", "decimation")),
    Kind("curvilinear", "o-grid", "grid.xyz", 9, ("--builder", "refinement")),
    Kind("irregular", "part", "part.vtu", 8, ("--builder", "decimation")),
    Kind("packed", "marschner-lobb", "ml.nrrd", 13, ("--block", "6", "--packed")),
    Kind("packed by parts", "hydrogen", "hydrogen.nrrd", 9, ("--builder", "decimation", "--packed")),
)

# What is asked of a model; OUT is the file that is written.
QUERIES = {
    "extract": ("extract", "--error", "2", "-o", "OUT.vtu"),
    "finest": ("extract", "--error", "0", "-o", "OUT.vtu"),
    "focus": ("extract", "--error", "10", "--focus", "sphere:0,0,0,3", "--focus-error", "1", "-o", "OUT.vtu"),
    "budget": ("extract", "--budget", "700", "-o", "OUT.vtu"),
    "range": ("extract", "--error", "3", "--window", "0,0,0,2,2,2", "-o", "OUT.vtu"),
    "isosurface": ("isosurface", "--error", "2", "--value", "VALUE", "-o", "OUT.stl"),
    "volume": ("render", "--mode", "volume", "--error", "5", "--size", "64x48", "--backend", "cpu", "-o", "OUT.png"),
    "surface": ("render", "--error", "5", "--size", "64x48", "--backend", "cpu", "-o", "OUT.png"),
    "info": ("info", "--json"),
}
# From one form into the other, of the kinds that have it.
FORMS = {"pack": ("pack", "-o", "OUT.tan"), "unpack": ("unpack", "-o", "OUT.tan")}


class Bench:
    """The programs under test, a folder to work in, and the whole datasets and models, made once."""

    def __init__(self, build, source, home, is_short):
        self.build, self.source, self.by_others = build, source, not is_short
        # Runs of which the shortest tells how long a command takes: the first ones read their files from the disk.
        self.timed = 2 if is_short else 4
        self.tan = build / "bin/tan"
        self.work = home / "work"
        self.whole = home / "whole"
        self.at_once = os.cpu_count() or 1
        self.lock = threading.RLock()
        self.found = {}
        self.environment = dict(os.environ, LC_ALL="C.UTF-8", QT_QPA_PLATFORM="offscreen", HOME=str(home),
                                XDG_CONFIG_HOME=str(home / "config"), XDG_DATA_HOME=str(home / "data"),
                                XDG_RUNTIME_DIR=str(home / "runtime"))
        for folder in (self.work, self.whole, home / "runtime"):
            folder.mkdir(parents=True, exist_ok=True)
        (home / "runtime").chmod(0o700)

    def machine(self):
        return "%d cores, %s" % (self.at_once, platform.machine())

    def once(self, key, make):
        """What make() gives, made by whoever asks first."""
        with self.lock:
            if key not in self.found:
                self.found[key] = make()
            return self.found[key]

    def command(self, arguments):
        return [str(self.tan), *[str(one) for one in arguments]]

    @staticmethod
    def cache(folder):
        """The cache of programs that work in a folder, beside it: what one attempt leaves there serves no other."""
        return folder.with_name(folder.name + ".cache")

    def start(self, arguments, folder, limits=None, environment=None, **how):
        environment = {"XDG_CACHE_HOME": str(self.cache(folder)), **(environment or {})}
        how = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **how}
        return subprocess.Popen(arguments, cwd=folder, env=dict(self.environment, **environment),
                                preexec_fn=limited(limits or {}), start_new_session=True, **how)

    def run(self, arguments, folder, **how):
        """tan ARGUMENTS to its end."""
        return self.finish(self.start(self.command(arguments), folder, **how))

    @staticmethod
    def finish(process, began=None, hangs_after=HANGS_AFTER):
        began = began or time.monotonic()
        try:
            out, err = process.communicate(timeout=hangs_after)
            return Ran(process.returncode, time.monotonic() - began, out or b"", err or b"")
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, err = process.communicate()
            return Ran(process.returncode, time.monotonic() - began, out or b"", err or b"", hung=True)

    def inputs(self):
        return self.once("inputs", lambda: inputs.make_inputs(self.build, self.source, self.whole / "inputs", self.by_others))

    def sample(self, kind):
        def make():
            place = self.whole / kind.name
            place.mkdir(parents=True, exist_ok=True)
            made = self.run(("sample", kind.sample, "--size", kind.size, "-o", kind.opened), place)
            assert made.code == DONE, made.said()
            return place
        return self.once(("sample", kind.name), make)

    def put_sample(self, kind, folder):
        for path in self.sample(kind).iterdir():
            if path.is_file() and path.suffix != ".tan":
                shutil.copy(path, folder)

    def build_command(self, kind, target="model.tan"):
        return ("build", kind.opened, *kind.options, "-o", target)

    def model(self, kind):
        """The bytes of the whole model, and the seconds that building it takes at least."""
        def make():
            place = self.whole / (kind.name + "-model")
            shutil.rmtree(place, ignore_errors=True)
            place.mkdir(parents=True)
            self.put_sample(kind, place)
            builds = [self.run(self.build_command(kind), place) for _ in range(self.timed)]
            assert all(built.code == DONE for built in builds), builds[-1].said()
            return (place / "model.tan").read_bytes(), min(built.seconds for built in builds)
        return self.once(("model", kind.name), make)

    def query(self, kind, name):
        """Its arguments, and the file that it writes, if any."""
        arguments = list({**QUERIES, **FORMS}[name])
        arguments.insert(1, "model.tan")
        target = None
        for at, one in enumerate(arguments):
            if one.startswith("OUT."):
                arguments[at] = target = name + one[3:]
            elif one == "VALUE":
                arguments[at] = self.middle(kind)
        return arguments, target

    def middle(self, kind):
        """A value in the middle of the model's range."""
        def make():
            place = self.model_folder(kind)
            low, high = json.loads(self.run(("info", "model.tan", "--json"), place).out)["range"]
            return "%.4g" % (low + 0.5 * (high - low))
        return self.once(("middle", kind.name), make)

    def model_folder(self, kind):
        self.model(kind)
        return self.whole / (kind.name + "-model")

    def ask(self, kind, name, folder):
        """Asks the model of the folder: how the program ended, and what it answered (None without an answer)."""
        arguments, target = self.query(kind, name)
        ran = self.run(arguments, folder)
        if target is None:
            return ran, ran.out if ran.code == DONE else None
        path = folder / target
        return ran, path.read_bytes() if path.is_file() else None

    def answer(self, kind, name):
        """Of the whole model, and the seconds that it takes at least."""
        def make():
            place = self.whole / ("%s-%s" % (kind.name, name))
            for old in (place, self.cache(place)):  # what another build has unpacked would be found there
                shutil.rmtree(old, ignore_errors=True)
            place.mkdir(parents=True)
            (place / "model.tan").write_bytes(self.model(kind)[0])
            asked = [self.ask(kind, name, place) for _ in range(self.timed)]
            for ran, told in asked:
                assert ran.code == DONE and told == asked[0][1] is not None, "%s of %s: %s" % (name, kind.name, ran.said())
            return asked[0][1], min(ran.seconds for ran, told in asked)
        return self.once(("answer", kind.name, name), make)

    def prepare(self, kind, query, folder):
        """Puts into the folder what a build of this kind (query None), or a query of its model, needs. Gives its arguments, the file
        that it writes, that file's right bytes, and the seconds that it takes at least."""
        if query is None:
            self.put_sample(kind, folder)
            return self.build_command(kind), "model.tan", *self.model(kind)
        (folder / "model.tan").write_bytes(self.model(kind)[0])
        return *self.query(kind, query), *self.answer(kind, query)
