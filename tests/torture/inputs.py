# SPDX-License-Identifier: GPL-3.0-or-later
"""The datasets that the torture bench damages: samples of TAn's own, files of the small writers of the tests and of those below, and where
their libraries are installed those of VTK's writers and of the bench of truth. All are small, so that thousands of attempts take minutes."""
import concurrent.futures
import hashlib
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys
from dataclasses import dataclass

SIZE = (5, 6, 7)
POINTS = [(i, j, k) for k in range(SIZE[2]) for j in range(SIZE[1]) for i in range(SIZE[0])]
VALUES = [40 * (1.3 + math.sin(0.7 * i + 0.1) * math.cos(0.5 * j) + 0.05 * k) for i, j, k in POINTS]


@dataclass(frozen=True)
class Input:
    """A dataset: the file that is opened, and all that belongs to it, in a folder of its own."""
    name: str
    folder: pathlib.Path
    opened: str
    # The file that is opened may end early and be another one: nothing tells how many points, or lines of a header, there were.
    open_ended: bool = False
    options: tuple = ()

    def files(self):
        """Relative to the folder."""
        return sorted(path.relative_to(self.folder) for path in self.folder.rglob("*") if path.is_file())

    def copy_to(self, folder):
        shutil.copytree(self.folder, folder, dirs_exist_ok=True)


def floats(values):
    return struct.pack("<%df" % len(values), *values)


def legacy_vtk():
    head = "# vtk DataFile Version 3.0\nvolume\n%s\nDATASET STRUCTURED_POINTS\nDIMENSIONS %d %d %d\nORIGIN 0 0 0\nSPACING 1 1 1\n" \
           "POINT_DATA %d\nSCALARS density float 1\nLOOKUP_TABLE default\n"
    text = head % ("ASCII", *SIZE, len(VALUES)) + "".join("%.6g\n" % value for value in VALUES)
    yield "ascii", "volume.vtk", {"volume.vtk": text.encode()}
    binary = (head % ("BINARY", *SIZE, len(VALUES))).encode() + struct.pack(">%df" % len(VALUES), *VALUES)
    yield "binary", "volume.vtk", {"volume.vtk": binary}


def hexahedra():
    def number(i, j, k):
        return i + SIZE[0] * (j + SIZE[1] * k)

    for k in range(SIZE[2] - 1):
        for j in range(SIZE[1] - 1):
            for i in range(SIZE[0] - 1):
                low = [number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
                yield low + [corner + SIZE[0] * SIZE[1] for corner in low]


def ucd():
    cells = list(hexahedra())
    text = "%d %d 1 0 0\n" % (len(POINTS), len(cells))
    text += "".join("%d %g %g %g\n" % (n + 1, *point) for n, point in enumerate(POINTS))
    text += "".join("%d 1 hex %s\n" % (n + 1, " ".join(str(c + 1) for c in cell)) for n, cell in enumerate(cells))
    text += "1 1\ndensity, -\n" + "".join("%d %.6g\n" % (n + 1, value) for n, value in enumerate(VALUES))
    yield "text", "mesh.inp", {"mesh.inp": text.encode()}


def vtu():
    cells = list(hexahedra())

    def array(name, kind, values, components=1):
        return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="ascii">%s</DataArray>\n' % (
            kind, name, components, " ".join("%.9g" % value for value in values))

    text = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">\n<UnstructuredGrid>\n'
            '<Piece NumberOfPoints="%d" NumberOfCells="%d">\n<PointData Scalars="density">\n' % (len(POINTS), len(cells)))
    text += array("density", "Float32", VALUES) + "</PointData>\n<Points>\n"
    text += array("Points", "Float32", [x for point in POINTS for x in point], 3) + "</Points>\n<Cells>\n"
    text += array("connectivity", "Int64", [corner for cell in cells for corner in cell])
    text += array("offsets", "Int64", [8 * (n + 1) for n in range(len(cells))])
    text += array("types", "UInt8", [12] * len(cells))
    text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
    yield "ascii", "mesh.vtu", {"mesh.vtu": text.encode()}


def points():
    text = "x,y,z,density\n" + "".join("%g,%g,%g,%.6g\n" % (*p, value) for p, value in zip(POINTS, VALUES))
    yield "csv", "points.csv", {"points.csv": text.encode()}


def nifti():
    header = struct.pack("<i10s18sihcB8h3f4h8f3fhBB4f2i80s24s2h6f4f4f4f16s4s", 348, b"", b"", 0, 0, b"r", 0, 3, *SIZE, 1, 1, 1, 1,
                         0, 0, 0, 0, 16, 32, 0, 1, 1, 1, 1, 0, 0, 0, 0, 352, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, b"", b"", 0, 0,
                         0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, b"", b"n+1\0")
    yield "single", "volume.nii", {"volume.nii": header + b"\0\0\0\0" + floats(VALUES)}


WRITERS = (legacy_vtk, ucd, vtu, points, nifti)
SAMPLES = (("nrrd", "marschner-lobb", "volume.nrrd", 9), ("nhdr", "c60", "volume.nhdr", 9), ("plot3d", "o-grid", "grid.xyz", 9),
           ("irregular", "part", "part.vtu", 6), ("stretched", "stretched", "stretched.vtr", 9), ("scattered", "scattered", "cloud.csv", 6))
# Formats of the bench of truth: tables do not say how many points they have, headers of bricks not how many lines.
OPEN_ENDED = ("table", "table, GSLIB", "BOV")
# What belongs to the file that is opened, of those that VTK's writers make.
COMPANIONS = {"image.mhd": ("image.raw", "image.zraw"), "run.case": ("run.geo", "run.heat00", "run.heat01")}


def own_inputs(folder):
    for writer in WRITERS:
        for variant, opened, files in writer():
            place = folder / ("%s-%s" % (writer.__name__, variant))
            place.mkdir(parents=True, exist_ok=True)
            for name, content in files.items():
                (place / name).write_bytes(content)
            yield Input(place.name, place, opened, open_ended=writer is points)


def test_inputs(build, folder):
    """What the tests of VTK's formats write: a line for each, with what is opened."""
    program = build / "tests/tan-torture-inputs"
    place = folder / "formats"
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    lines = subprocess.run([program, place], capture_output=True, check=True, text=True).stdout.splitlines()
    for told in map(json.loads, lines):
        opened = pathlib.Path(told["opened"])
        home = place / opened.relative_to(place).parts[0]
        yield Input(home.name, home, str(opened.relative_to(home)))


def sample_inputs(tan, folder):
    """Formats that `tan sample` does not write for a sample are left out."""
    for name, sample, opened, size in SAMPLES:
        place = folder / ("sample-" + name)
        place.mkdir(parents=True, exist_ok=True)
        made = subprocess.run([tan, "sample", sample, "--size", str(size), "-o", place / opened], capture_output=True, check=False)
        if made.returncode == 0:
            yield Input(place.name, place, opened, open_ended=opened.endswith(".csv"))


def vtk_inputs(source, folder):
    """Nothing where VTK's Python is not installed."""
    script = source / "tests/plugins/readers/vtk/make_vtk_files.py"
    made = folder / "by-vtk"
    made.mkdir(parents=True, exist_ok=True)
    if subprocess.run([sys.executable, script, made], capture_output=True, check=False).returncode != 0:
        return
    for reference in sorted(made.glob("*.ref")):
        whole = made / reference.stem
        if not whole.is_file():
            continue
        place = folder / ("vtk-" + whole.name)
        place.mkdir(exist_ok=True)
        for name in (whole.name, *COMPANIONS.get(whole.name, ())):
            if (made / name).is_file():
                (place / name).write_bytes((made / name).read_bytes())
        yield Input(place.name, place, whole.name)


def truth_inputs(source, folder):
    """Files of every format, by other libraries. They are kept until their writers change: some hold the time at which they were written,
    and an attempt that is repeated is to meet the same bytes."""
    writers = sorted((source / "tests/truth").glob("*.py"))
    mark = hashlib.sha256(b"".join(path.read_bytes() for path in writers)).hexdigest()[:16]
    place = folder / ("truth-" + mark)
    listing = place / "written"
    if not listing.is_file():
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        # By the interpreter that Debian's packages belong to; nothing where it lacks them, or is not there.
        words = ["env", "/usr/bin/python3", source / "tests/truth/written.py", place]
        written = subprocess.run(words, capture_output=True, check=False)
        if written.returncode not in (0, 77, 127):
            raise RuntimeError(written.stderr.decode("utf-8", "replace")[-300:])
        listing.write_bytes(written.stdout)
    for told in map(json.loads, listing.read_text(encoding="utf-8").splitlines()):
        yield Input("truth-" + told["folder"], place / told["folder"], told["opened"], told["format"] in OPEN_ENDED, tuple(told["options"]))


def make_inputs(build, source, folder, by_others=True):
    """Those that can be opened as they are: what cannot be opened whole tells nothing when it is cut."""
    made = [*own_inputs(folder), *test_inputs(build, folder), *sample_inputs(build / "bin/tan", folder),
            *((*vtk_inputs(source, folder), *truth_inputs(source, folder)) if by_others else ())]

    def opens(one):
        words = [build / "bin/tan", "info", one.folder / one.opened, *one.options]
        return subprocess.run(words, capture_output=True, check=False).returncode == 0

    with concurrent.futures.ThreadPoolExecutor() as pool:
        return [one for one, can_be in zip(made, pool.map(opens, made)) if can_be]
