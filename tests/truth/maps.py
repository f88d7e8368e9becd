# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of molecules: MRC and CCP4 by mrcfile, by gemmi and byte by byte; Gaussian's .cube and OpenDX as text."""
import numpy

from bench import add, of_grid
from samples import ORIGIN, SIZE, SPACING, grid, library, numbers, placed, wave

gemmi = library("gemmi")
mrcfile = library("mrcfile")

MODES = {"i1": 0, "i2": 1, "f4": 2, "u2": 6, "f2": 12}


def half(grid_of_floats):
    """Rounded to 16 bits, as the file holds them."""
    grid_of_floats.values = grid_of_floats.values.astype("<f2")
    return grid_of_floats


def microscope_map(folder, dtype="<f4", origin=ORIGIN, ending=".mrc", packed=None):
    """As an electron microscope's program writes it: voxels, and ORIGIN."""
    whole = grid((SPACING, origin), "<f4" if dtype == "<f2" else dtype)
    if dtype == "<f2":
        half(whole)
    file = folder / f"map{ending}"
    with mrcfile.new(str(file), compression=packed) as out:
        out.set_data(whole.fastest_first())
        out.voxel_size = tuple(whole.spacing)
        out.header.origin.x, out.header.origin.y, out.header.origin.z = whole.origin
    return of_grid(file, whole, place_slack=1e-6)


def cell_matrix(lengths, angles):
    """Columns: the cell's edges, the first along x, the second in the plane of x and y."""
    a, b, c = lengths
    cos_a, cos_b, cos_c = numpy.cos(numpy.radians(angles))
    sin_c = numpy.sin(numpy.radians(angles[2]))
    up = (cos_a - cos_b * cos_c) / sin_c
    return numpy.array([[a, b * cos_c, c * cos_b], [0, b * sin_c, c * up], [0, 0, c * numpy.sqrt(1 - cos_b ** 2 - up ** 2)]])


def crystal_map(folder, order="xyz", start=(0, 0, 0), angles=(90, 90, 90), dtype="<f4", intervals=(20, 24, 28), symmetry=b"", ending=".ccp4"):
    """Byte by byte: columns, rows and sections run along the axes that `order` names, and begin at `start` intervals of the cell."""
    lengths = numpy.array([4.0, 3.0, 2.0]) * intervals
    steps_of_cell = cell_matrix(lengths, angles) / intervals
    along = ["xyz".index(axis) for axis in order]
    steps = steps_of_cell[:, along]
    whole = grid((steps, steps @ numpy.array(start)), "<f4" if "f2" in dtype else dtype)
    if "f2" in dtype:
        half(whole)
    big = numpy.dtype(dtype).byteorder == ">"
    head = numpy.zeros(256, ">i4" if big else "<i4")
    reals = head.view(">f4" if big else "<f4")
    head[:3], head[3], head[4:7], head[7:10] = SIZE, MODES[numpy.dtype(dtype).str[1:]], start, intervals
    reals[10:13], reals[13:16], head[16:19] = lengths, angles, numpy.array(along) + 1
    reals[19:22], head[22], head[23] = (whole.values.min(), whole.values.max(), whole.values.mean()), 1, len(symmetry)
    head[27] = 20140
    raw = bytearray(head.tobytes())
    raw[208:216] = b"MAP " + (b"\x11\x11\0\0" if big else b"DD\0\0")
    (folder / f"map{ending}").write_bytes(bytes(raw) + symmetry + whole.fastest_first().astype(dtype).tobytes())
    return of_grid(folder / f"map{ending}", whole, place_slack=1e-6)


def gemmi_map(folder, cell, mode=2):
    """A whole cell."""
    lengths, angles = cell[:3], cell[3:]
    whole = grid((cell_matrix(lengths, angles) / SIZE, (0, 0, 0)))
    if mode != 2:
        whole.values = numbers(wave(whole.places), {0: "i1", 1: "<i2", 6: "<u2"}[mode])
    out = gemmi.Ccp4Map()
    out.grid = gemmi.FloatGrid(whole.values.astype("f4"))
    out.grid.set_unit_cell(gemmi.UnitCell(*cell))
    out.grid.spacegroup = gemmi.SpaceGroup("P 1")
    out.update_ccp4_header(mode, True)
    out.write_ccp4_map(str(folder / "map.ccp4"))
    return of_grid(folder / "map.ccp4", whole, place_slack=1e-6)


MAPS = "MRC, CCP4"
add(MAPS, "places", "ORIGIN", microscope_map, quick=True)
add(MAPS, "places", "no origin", microscope_map, origin=(0, 0, 0))
for order in ("xyz", "zyx", "yzx", "xzy", "zxy", "yxz"):
    add(MAPS, "places", f"columns, rows, sections along {order}", crystal_map, order=order, start=(2, -3, 5))
add(MAPS, "places", "angle gamma 120", crystal_map, angles=(90, 90, 120))
add(MAPS, "places", "monoclinic, zyx", crystal_map, angles=(90, 104.5, 90), order="zyx", start=(1, 2, -3))
add(MAPS, "places", "triclinic, yzx", crystal_map, angles=(80, 95, 110), order="yzx", start=(-4, 0, 3))
add(MAPS, "places", "gemmi, orthogonal", gemmi_map, cell=(20, 18, 14, 90, 90, 90))
add(MAPS, "places", "gemmi, triclinic", gemmi_map, cell=(20, 18, 14, 75, 100, 115))
for dtype in ("i1", "<i2", "<u2", "<f4", "<f2"):
    add(MAPS, "numbers", f"mode {MODES[numpy.dtype(dtype).str[1:]]}", microscope_map, dtype=dtype)
add(MAPS, "numbers", "gemmi, mode 1", gemmi_map, cell=(20, 18, 14, 90, 90, 90), mode=1)
for dtype in (">i2", ">f4", ">u2"):
    add(MAPS, "storage", f"big endian {dtype}", crystal_map, dtype=dtype, order="zyx")
add(MAPS, "storage", "symmetry records", crystal_map, symmetry=b"X,Y,Z".ljust(80) * 2)
add(MAPS, "storage", "*.map", crystal_map, ending=".map")
add(MAPS, "storage", "*.mrc.gz", microscope_map, ending=".mrc.gz", packed="gzip")


# .cube: z runs fastest; lengths in Bohr, if the number of voxels is positive. Signs of life of a molecule come first.

def cube(folder, frame="offset", atoms=2, orbitals=0, options=(), take=0, angstrom=False, **said):
    whole = grid(frame, "<f8")
    fields = [numbers(wave(whole.places, variant), "<f8") for variant in range(max(1, orbitals))]
    number = lambda value: f"{value:12.6f}"
    whole.steps, whole.origin = (numpy.array([[float(number(n)) for n in row] for row in numpy.atleast_2d(part)]) for part in (whole.steps, whole.origin))
    whole.origin = whole.origin[0]
    whole.places = placed(whole.steps, whole.origin)
    lines = ["A molecule", "OUTER LOOP: X, MIDDLE LOOP: Y, INNER LOOP: Z", f"{-atoms if orbitals else atoms:5d}" + "".join(map(number, whole.origin))]
    lines += [f"{-count if angstrom else count:5d}" + "".join(map(number, step)) for count, step in zip(SIZE, whole.steps.T)]
    lines += [f"{8 if atom == 0 else 1:5d}" + "".join(map(number, (8 if atom == 0 else 1, 0.1 * atom, 0.2, 0.3))) for atom in range(atoms)]
    if orbitals:
        lines.append("".join(f"{number:5d}" for number in (orbitals, *range(5, 5 + orbitals))))
    texts = [f"{value:13.5E}" for value in numpy.stack(fields, axis=-1).ravel()]
    whole.values = numpy.array([float(text) for text in texts]).reshape(*SIZE, -1)[..., take]
    per_row = SIZE[2] * len(fields)
    for begin in range(0, len(texts), per_row):
        lines += ["".join(texts[at:min(at + 6, begin + per_row)]) for at in range(begin, begin + per_row, 6)]
    (folder / "density.cube").write_text("\n".join(lines) + "\n")
    return of_grid(folder / "density.cube", whole, options, **said)


for name in ("identity", "offset", "mirrored", "permuted", "oblique", "sheared"):
    add("Gaussian cube", "places", name, cube, frame=name)
add("Gaussian cube", "places", "in Angstrom", cube, angstrom=True)
add("Gaussian cube", "storage", "no atoms", cube, atoms=0)
add("Gaussian cube", "arrays", "the second of two orbitals", cube, orbitals=2, options=("--array", "2"), take=1, taken={"array": "6|2"})


# OpenDX: z runs fastest.

def opendx(folder, frame="offset", dtype="float", form="text", comments=True):
    whole = grid(frame, {"float": "<f4", "double": "<f8", "int": "<i4", "short": "<i2", "ubyte": "u1"}[dtype])
    row = lambda vector: " ".join(repr(float(number)) for number in vector)
    count = " ".join(map(str, SIZE))
    head = ["# Data of the bench", "#"] if comments else []
    head += [f"object 1 class gridpositions counts {count}", f"origin {row(whole.origin)}"] + [f"delta {row(step)}" for step in whole.steps.T]
    head += [f"object 2 class gridconnections counts {count}"]
    kind = {"text": "", "lsb": "lsb ieee ", "msb": "msb ieee "}[form]
    words = "unsigned byte" if dtype == "ubyte" else dtype
    head += [f"object 3 class array type {words} rank 0 items {whole.values.size} {kind}data follows"]
    data = whole.values.astype(whole.values.dtype.newbyteorder(">" if form == "msb" else "<")).tobytes()
    if form == "text":
        texts = [repr(value) for value in whole.values.ravel().tolist()]
        data = "\n".join(" ".join(texts[at:at + 3]) for at in range(0, len(texts), 3)).encode()
    tail = '\nattribute "dep" string "positions"\nobject "regular positions regular connections" class field\ncomponent "positions" value 1\n' \
           'component "connections" value 2\ncomponent "data" value 3\n'
    (folder / "potential.dx").write_bytes("\n".join(head).encode() + b"\n" + data + tail.encode())
    return of_grid(folder / "potential.dx", whole)


for name in ("identity", "offset", "mirrored", "exchanged", "oblique", "sheared"):
    add("OpenDX", "places", name, opendx, frame=name)
for dtype in ("double", "int", "short", "ubyte"):
    add("OpenDX", "numbers", dtype, opendx, dtype=dtype)
for form in ("lsb", "msb"):
    add("OpenDX", "storage", f"binary, {form}", opendx, form=form)
