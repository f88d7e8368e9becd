# SPDX-License-Identifier: GPL-3.0-or-later
"""What TAn gives, kept, so that a change of its insides shows whether it changed anything else.

    record.py BUILD [--only NAME;...] [--update]

Of datasets of every kind, by each builder that takes them: hashes of the model (each section by its content, so that an added section
hides nothing), of meshes, isosurfaces and pictures made of it; and the most memory and disk that the build took. All of it is compared
with record.json beside this file; --update writes what was found there, and the commit says why it may.

Where ../shared/data is not there, what is made of its datasets is skipped, and the exit code is 77; where it is, all have to be there.
Pictures are kept by instruction set, because each rounds sums of floats in its own way; a machine whose set is not in the record is told
so."""
import argparse
import array
import hashlib
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import zlib
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
DATA = SOURCE.parent / "shared" / "data"
RECORD = HERE / "record.json"
SKIPPED = 77  # what ctest takes for skipped


# --- What is made ----------------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Model:
    """How a model is made, and whether it is drawn, too."""
    name: str
    dataset: str  # a file of ../shared/data, or "sample NAME SIZE"
    options: tuple = ()
    pictures: bool = False


BY_THE_GRID = ("--builder", "refinement", "--error-in", "grid")
MODELS = (
    Model("c60 sample", "sample c60 24 nrrd", pictures=True),
    Model("c60 sample, decimated", "sample c60 20 nrrd", ("--builder", "decimation")),
    Model("marschner-lobb sample in blocks", "sample marschner-lobb 33 nrrd", ("--block", "8")),
    Model("hydrogen sample, paper's order", "sample hydrogen 16 nrrd", ("--builder", "decimation", "--order", "paper")),
    Model("noise sample, weighted", "sample noise 16 nrrd", ("--weight", "point:8,8,8,5")),
    Model("o-grid sample", "sample o-grid 17 xyz", BY_THE_GRID, pictures=True),
    Model("o-grid sample, decimated", "sample o-grid 12 xyz", ("--builder", "decimation", "--space", "computational")),
    Model("bent duct sample in blocks", "sample bent-duct 33 xyz", ("--builder", "refinement", "--block", "8")),
    Model("part sample", "sample part 16 vtu", pictures=True),
    Model("part sample, by rounds", "sample part 16 vtu", ("--order", "rounds")),
    Model("scattered sample", "sample scattered 12 csv", pictures=True),
    Model("bucky", "buckyball/bucky_32x32x32_uint8.nhdr", pictures=True),
    Model("bucky, decimated", "buckyball/bucky_32x32x32_uint8.nhdr", ("--builder", "decimation")),
    Model("fiji quakes", "scattered/fiji_quakes.csv"),
    Model("spx", "irregular/spx.vtu", pictures=True),
    Model("bracket", "irregular/bracket_57k.vtu"),
    Model("BluntFin", "bluntfin/bluntfin.vts", BY_THE_GRID, pictures=True),
    Model("BluntFin in blocks", "bluntfin/bluntfin.vts", ("--builder", "refinement", "--block", "16")),
    Model("BluntFin, decimated", "bluntfin/bluntfin.vts",
          ("--builder", "decimation", "--space", "computational", "--finest", "0.2")),
    Model("Post", "post/post.vts", BY_THE_GRID),
    Model("c60large", "buckyball/c60large_128x128x128_uint8.nhdr", ("--block", "none", "--error", "0.5")),
    Model("c60large in blocks", "buckyball/c60large_128x128x128_uint8.nhdr", ("--block", "32", "--error", "0.5")),
    Model("c60large, decimated", "buckyball/c60large_128x128x128_uint8.nhdr", ("--builder", "decimation", "--stride", "2")),
)


def box(bounds, low, high):
    """A part of the bounding box, as the options take it."""
    ends = [[bounds[axis] + part * (bounds[axis + 3] - bounds[axis]) for axis in range(3)] for part in (low, high)]
    return ",".join("%.6g" % number for end in ends for number in end)


def queries(bounds, values, budget, takes_insertion):
    """name -> the words of the command, but for the model's name and the output."""
    middle = "box:" + box(bounds, 0.4, 0.6)
    isovalues = ["%.6g" % (values[0] + part * (values[1] - values[0])) for part in (0.35, 0.6)]
    found = {
        "finest": ("extract", "--error", "0"),
        "uniform": ("extract", "--error", "2"),
        "coarse": ("extract", "--error", "10"),
        "window": ("extract", "--error", "2", "--window", box(bounds, 0.3, 0.7)),
        "window, clipped": ("extract", "--error", "2", "--window", box(bounds, 0.3, 0.7), "--border", "clipped"),
        "focus": ("extract", "--error", "8", "--focus", middle, "--focus-error", "1", "--method", "closed-set"),
        "focus with a falloff": ("extract", "--error", "8", "--focus", middle, "--focus-error", "1",
                                 "--falloff", "%.6g" % (0.2 * (bounds[3] - bounds[0]))),
        "budget": ("extract", "--budget", budget),
        "focus within a budget": ("extract", "--error", "8", "--focus", middle, "--focus-error", "0.5", "--budget", 2 * budget),
        "values": ("extract", "--error", "2", "--values", ",".join(isovalues)),
        "near an isovalue": ("extract", "--field", "isovalues(%s; 0.5, 8, %.6g)" % (isovalues[0], 0.2 * (values[1] - values[0]))),
        "range": ("extract", "--range", "2,4"),
        "isosurface": ("isosurface", "--error", "2", "--value", isovalues[0]),
        "isosurfaces": ("isosurface", "--error", "0", "--value", ",".join(isovalues)),
    }
    if takes_insertion:
        found["focus by insertion"] = ("extract", "--error", "8", "--focus", middle, "--focus-error", "1", "--method", "insertion")
    return found


def pictures(bounds, values):
    isovalue = "%.6g:gold:0.6" % (values[0] + 0.4 * (values[1] - values[0]))
    size = ("--size", "160x120", "--backend", "cpu", "--error", "2")
    return {
        "isosurface": ("--mode", "isosurface", "--isovalue", isovalue, *size),
        "volume": ("--mode", "volume", "--no-shaded", *size),
        "shaded volume": ("--mode", "volume", "--background", "white", *size),
        "hybrid": ("--mode", "hybrid", "--no-shaded", "--isovalue", isovalue, *size),
        "focus": ("--mode", "focus", "--no-shaded", *size, "--focus", "box:" + box(bounds, 0.3, 0.6), "--focus-error", "0.5",
                  "--falloff", "%.6g" % (0.1 * (bounds[3] - bounds[0]))),
    }


# --- How it is hashed ------------------------------------------------------------------------------------------------------------

HEADER_FIELDS = slice(32, 200)  # what FORMAT.md says of the dataset and the mesh; before it sizes, after it checksums
TEXT, CHECKSUMS = 1, 3
SECTIONS = {2: "kind", 16: "points", 17: "values", 18: "running errors", 19: "stars", 20: "mesh sizes", 21: "groups", 22: "positions",
            23: "samples", 24: "sample positions", 32: "other sites", 33: "destroyers", 34: "own errors", 35: "own warpings",
            4: "level index", 48: "batch ends", 49: "batch errors", 50: "batch warpings", 51: "blocks", 52: "faults",
            53: "faulty cells"}


def short_hash(data):
    return hashlib.sha256(data).hexdigest()[:16]


def hashes_of_model(path):
    """Of the header's fields and of each section's content."""
    data = path.read_bytes()
    found = {"header": short_hash(data[HEADER_FIELDS])}
    for number in range(struct.unpack_from("<I", data, 20)[0]):
        section, _, _, codec, offset, size = struct.unpack_from("<IIIIQQ", data, 256 + 64 * number)
        if section in SECTIONS:
            assert codec == 0, "section %d is packed: unpack it here first" % section
            found[SECTIONS[section]] = short_hash(data[offset:offset + size])
        elif section not in (TEXT, CHECKSUMS):
            print("record: section %d is not looked at" % section)
    return found


def kept_form(legacy):
    """A mesh in a legacy VTK file as the record has it: the facts of its title, then its vertices with their values, then its
    tetrahedra with theirs, as a PLY file would hold them. What the data call the values makes no difference, nor what a
    file says beside its error: which one it is, and how large the other one is."""
    beside = (b"array: ", b"error_kind: ", b"error_in_space: ")
    title = [fact for fact in re.split(rb"; (?=[a-z_]+: )", legacy.split(b"\n", 2)[1]) if not fact.startswith(beside)]
    at = 0

    def block(pattern, count, form):
        nonlocal at
        found = re.compile(pattern).search(legacy, at)
        at = found.end()
        form = form[found[2]] if isinstance(form, dict) else form
        size = struct.calcsize(form) * count(found)
        numbers = struct.unpack_from(">%d%s" % (count(found), form), legacy, at)
        at += size
        return found, numbers

    found, places = block(rb"\nPOINTS (\d+) (float|double)\n", lambda found: 3 * int(found[1]), {b"float": "f", b"double": "d"})
    places = array.array("f", places)  # as meshes were when they were recorded first
    _, corners = block(rb"\nCELLS (\d+) \d+\n", lambda found: 5 * int(found[1]), "I")
    vertices, cells = len(places) // 3, len(corners) // 5
    lives = []
    if legacy.find(b"\nCELL_DATA ", at) > 0:
        lives.append(block(rb"\nSCALARS (birth_error) float 1\nLOOKUP_TABLE default\n", lambda _: cells, "f"))
        lives.append(block(rb"\n(death_error) 1 \d+ float\n", lambda _: cells, "f"))
    _, values = block(rb"\nSCALARS (\S+) float 1\nLOOKUP_TABLE default\n", lambda _: vertices, "f")
    head = [b"ply", b"format binary_little_endian 1.0", *(b"comment " + fact for fact in title), b"element vertex %d" % vertices,
            *(b"property float " + axis for axis in (b"x", b"y", b"z", b"value")), b"element cell %d" % cells,
            b"property list uchar int vertex_indices", *(b"property float " + found[1] for found, _ in lives), b"end_header", b""]
    body = bytearray()
    for vertex in range(vertices):
        body += struct.pack("<4f", *places[3 * vertex:3 * vertex + 3], values[vertex])
    for cell in range(cells):
        body += struct.pack("<B4I", *corners[5 * cell:5 * cell + 5])
        for _, numbers in lives:
            body += struct.pack("<f", numbers[cell])
    return b"\n".join(head) + bytes(body)


def hash_of_mesh(path):
    """By a process of its own: what this one has taken counts for the programs that it starts, until they are loaded."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        content = path.read_bytes()
        beside = rb"\ncomment (?:array|error_kind|error_in_space): .*"  # as in kept_form()
        content = re.sub(beside, b"", content, count=3) if path.suffix == ".ply" else kept_form(content)
        os.write(writing, short_hash(content).encode())
        os._exit(0)
    os.close(writing)
    with open(reading, encoding="ascii") as pipe:
        found = pipe.read()
    os.waitpid(child, 0)
    return found


def hash_of_picture(path):
    """Of the pixels, however they are packed."""
    data = path.read_bytes()
    at, packed, header = 8, b"", b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            header = data[at + 8:at + 8 + size]
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    return short_hash(header + zlib.decompress(packed))


def instruction_set():
    """That of the kernels of pictures which this machine takes (core/base/simd.h)."""
    flags = set()
    for line in open("/proc/cpuinfo", encoding="ascii", errors="replace"):
        if line.startswith("flags"):
            flags = set(line.split())
            break
    sets = ["x86-64"]
    if {"avx2", "fma", "bmi2", "movbe", "f16c"} <= flags:  # and abm, which some virtual machines have and do not tell
        sets.append("x86-64-v3")
        if {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"} <= flags:
            sets.append("x86-64-v4")
    asked = os.environ.get("TAN_INSTRUCTION_SET")
    return asked if asked in sets else sets[-1]


# --- How it is made --------------------------------------------------------------------------------------------------------------

class Failure(Exception):
    pass


class Peak:
    """The most disk that a folder takes while a program runs, looked at every 20 ms; and then the program's most memory."""

    def __init__(self, folder):
        self.folder, self.disk, self.ended = folder, 0, threading.Event()

    def used(self):
        total = 0
        for folder, _, names in os.walk(self.folder):  # which passes over folders that are gone meanwhile
            for name in names:
                try:
                    total += os.stat(os.path.join(folder, name)).st_blocks * 512
                except OSError:
                    pass  # gone meanwhile
        return total

    def watch(self, process):
        before = self.used()
        looker = threading.Thread(target=self.look)
        looker.start()
        _, status, usage = os.wait4(process.pid, 0)
        self.ended.set()
        looker.join()
        process.returncode = os.waitstatus_to_exitcode(status)
        return {"memory": usage.ru_maxrss * 1024, "disk": max(self.disk, self.used()) - before}

    def look(self):
        while not self.ended.wait(0.02):
            self.disk = max(self.disk, self.used())


class Recorder:
    def __init__(self, build, folder):
        self.tan, self.folder = build / "bin/tan", folder
        self.environment = dict(os.environ, LC_ALL="C.UTF-8", QT_QPA_PLATFORM="offscreen", HOME=str(folder))

    def start(self, words):
        with open(self.folder / "messages", "wb") as messages:
            return subprocess.Popen([str(self.tan), *map(str, words)], cwd=self.folder, env=self.environment,
                                    stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=messages)

    def messages(self):
        return (self.folder / "messages").read_text("utf-8", "replace").strip()[-300:]

    def run(self, *words):
        if self.start(words).wait() != 0:
            raise Failure("tan %s: %s" % (" ".join(map(str, words)), self.messages()))

    def tetrahedra(self, model, error):
        """Of its mesh of this error."""
        told = subprocess.run([str(self.tan), "info", str(model), "--lod", str(error), "--json"], env=self.environment, capture_output=True)
        return json.loads(told.stdout)["levels"][0]["tetrahedra"]

    def dataset(self, model):
        """The file to read, or nothing where it is not there."""
        if not model.dataset.startswith("sample "):
            path = DATA / model.dataset
            return path if path.is_file() else None
        _, name, size, ending = model.dataset.split()
        path = self.folder / ("%s%s.%s" % (name, size, ending))
        if not path.is_file():
            self.run("sample", name, "--size", size, "-o", path)
        return path

    def record(self, model, dataset):
        """All that is kept of a model."""
        built = self.folder / "model.tan"
        built.unlink(missing_ok=True)
        arguments = ("build", dataset, *model.options, "--threads", "2", "-o", built)
        peak = Peak(self.folder)
        began = time.monotonic()
        process = self.start(arguments)
        peaks = peak.watch(process)
        seconds = time.monotonic() - began
        if process.returncode != 0:
            raise Failure("tan %s: %s" % (" ".join(map(str, arguments)), self.messages()))
        with open(built, "rb") as file:
            header = file.read(256)
        kind, = struct.unpack_from("<I", header, 32)
        values, bounds = struct.unpack_from("<2d", header, 112), struct.unpack_from("<6d", header, 128)
        found = {"model": hashes_of_model(built), "peaks": peaks}
        is_lattice = kind == 0
        takes_insertion = is_lattice and not {"decimation", "--weight"} & set(model.options)
        found["meshes"] = {}
        for name, (command, *words) in queries(bounds, values, self.tetrahedra(built, 4), takes_insertion).items():
            written = self.folder / ("mesh.ply" if command == "isosurface" else "mesh.vtk")
            self.run(command, built, *words, "-o", written)
            found["meshes"][name] = hash_of_mesh(written)
        if model.pictures:
            found["pictures"] = {}
            for name, words in pictures(bounds, values).items():
                written = self.folder / "picture.png"
                self.run("render", built, *words, "-o", written)
                found["pictures"][name] = hash_of_picture(written)
        if is_lattice and "--block" in model.options and model.options[model.options.index("--block") + 1] != "none":
            self.check_resuming(arguments, found["model"], seconds)
        return found

    def ended_after(self, seconds, arguments):
        """Whether the program was done by then; else it is told to end."""
        process = self.start(arguments)
        time.sleep(seconds)
        process.send_signal(signal.SIGTERM)
        return process.wait() == 0

    def check_resuming(self, arguments, expected, seconds):
        """A build in blocks that is ended twice on its way, and goes on, gives the same."""
        built = arguments[-1]
        built.unlink()
        arguments = [*arguments, "--resume"]
        for _ in range(2):
            while self.ended_after(0.3 * seconds, arguments):
                seconds /= 2  # it was slower the first time
                built.unlink()
        self.run(*arguments)
        if hashes_of_model(built) != expected:
            raise Failure("a build that was interrupted and went on gives another model")


# --- How it is compared ----------------------------------------------------------------------------------------------------------

MORE, SLACK = 1.1, 16 << 20  # peaks may grow so much: what a machine's libraries and threads take differs


def differences(found, kept):
    """In words."""
    told = []
    for part in ("model", "meshes", "pictures"):
        for name, value in found.get(part, {}).items():
            if part in kept and kept[part].get(name) != value:
                told.append("%s: %s %s" % (part, name, "is new" if name not in kept[part] else "differs"))
        told += ["%s: %s is missing" % (part, name) for name in kept.get(part, {}) if name not in found.get(part, {})]
    for name, most in kept["peaks"].items():
        if found["peaks"][name] > MORE * most + SLACK:
            told.append("peak of %s: %.1f MB, was %.1f" % (name, found["peaks"][name] / 1e6, most / 1e6))
    return told


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", action="append", default=[], help="these models alone, separated by semicolons; may be repeated")
    parser.add_argument("--update", action="store_true", help="keep what is found in place of what was")
    options = parser.parse_args()
    only = {name for names in options.only for name in names.split(";")}
    kept = json.loads(RECORD.read_text()) if RECORD.is_file() else {}
    pictures_kept = kept.setdefault("pictures by instruction set", {})
    on_this_machine = instruction_set()
    wrong, skipped = [], []
    with tempfile.TemporaryDirectory() as folder:
        recorder = Recorder(options.build.resolve(), pathlib.Path(folder))
        for model in MODELS:
            if only and model.name not in only:
                continue
            dataset = recorder.dataset(model)
            if dataset is None:
                skipped.append(model.name)
                continue
            began = time.monotonic()
            try:
                found = recorder.record(model, dataset)
            except Failure as failure:
                wrong.append("%s: %s" % (model.name, failure))
                print("%s: FAILED" % model.name, flush=True)
                continue
            drawn = found.pop("pictures", None)
            if options.update:
                kept.setdefault("models", {})[model.name] = found
                if drawn:
                    pictures_kept.setdefault(on_this_machine, {})[model.name] = drawn
            elif model.name not in kept.get("models", {}):
                wrong.append("%s is not in the record" % model.name)
            else:
                expected = dict(kept["models"][model.name])
                if drawn and model.name in pictures_kept.get(on_this_machine, {}):
                    found["pictures"], expected["pictures"] = drawn, pictures_kept[on_this_machine][model.name]
                elif drawn:
                    print("skipped: no pictures of %s by %s" % (model.name, on_this_machine))
                wrong += ["%s: %s" % (model.name, one) for one in differences(found, expected)]
            print("%s: %.1f s, memory %.0f MB, disk %.1f MB" % (model.name, time.monotonic() - began, found["peaks"]["memory"] / 1e6,
                                                               found["peaks"]["disk"] / 1e6), flush=True)
    if not only:
        known = {model.name for model in MODELS}
        wrong += ["%s is in the record, and nothing makes it" % name for name in kept.get("models", {}) if name not in known]
    if options.update:
        RECORD.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n")
    for name in skipped:
        print("%s skipped: no data" % name)
    if skipped and os.environ.get("TAN_MAY_SKIP", "0" if DATA.is_dir() else "1") == "0":
        wrong.append("not all of ../shared/data is there, and nothing may be skipped")
    for one in wrong:
        print(one)
    return 1 if wrong else SKIPPED if skipped else 0


if __name__ == "__main__":
    sys.exit(main())
