# SPDX-License-Identifier: GPL-3.0-or-later
"""Bare arrays: raw files, NumPy's .npy, BOV, and arrays in HDF5 files."""
import numpy

from bench import add, of_grid
from samples import SIZE, grid, library, numbers, wave

h5py = library("h5py")

GIVEN = ("--spacing", "4x3x2", "--origin", "10,20,-30")
NAMES = {"u1": "uint8", "i1": "int8", "u2": "uint16", "i2": "int16", "u4": "uint32", "i4": "int32", "f4": "float", "f8": "double"}


def raw(folder, dtype="<f4", skip=0, placed=True, ending=".raw"):
    whole = grid("offset" if placed else "identity", dtype)
    (folder / f"volume{ending}").write_bytes(b"h" * skip + whole.fastest_first().tobytes())
    options = ["--size", "x".join(map(str, SIZE)), "--type", NAMES[numpy.dtype(dtype).str[1:]]]
    options += ["--byte-order", "big" if ">" in dtype else "little"] + (["--skip", str(skip)] if skip else []) + (list(GIVEN) if placed else [])
    return of_grid(folder / f"volume{ending}", whole, options)


def npy(folder, dtype="<f4", order="C", version=None, placed=True, axes=None):
    """array[i, j, k] is the sample at (i, j, k), in either order of storage; with the axes z, y, x it is that at (k, j, i)."""
    whole = grid("offset" if placed else "identity", dtype)
    array = numpy.array(whole.values.transpose(2, 1, 0) if axes == "zyx" else whole.values, order=order)
    with open(folder / "volume.npy", "wb") as file:
        numpy.lib.format.write_array(file, array, version=version)
    options = (*(GIVEN if placed else ()), *(("--axes", axes) if axes else ()))
    return of_grid(folder / "volume.npy", whole, options, taken={"columns": "dimensions are " + ("z, y, x" if axes == "zyx" else "x, y, z")},
                   guessed=() if axes else ("columns",))


BOV = {"u1": "BYTE", "i2": "SHORT", "i4": "INT", "f4": "FLOAT", "f8": "DOUBLE"}


def bov(folder, dtype="<f4", skip=0, frame="offset", centering="nodal"):
    """Brick of values: from the origin on, of the size of the brick; the samples of values of nodes are its corners."""
    whole = grid(frame, dtype)
    (folder / "density.raw").write_bytes(b"h" * skip + whole.fastest_first().tobytes())
    steps = numpy.array(SIZE) - 1
    lines = ["TIME: 0.5", "DATA_FILE: density.raw", "DATA_SIZE: " + " ".join(map(str, SIZE)), f"DATA_FORMAT: {BOV[numpy.dtype(dtype).str[1:]]}",
             "VARIABLE: density", f"DATA_ENDIAN: {'BIG' if '>' in dtype else 'LITTLE'}", f"CENTERING: {centering}",
             "BRICK_ORIGIN: " + " ".join(repr(float(n)) for n in whole.origin),
             "BRICK_SIZE: " + " ".join(repr(float(n)) for n in whole.spacing * steps)] + ([f"BYTE_OFFSET: {skip}"] if skip else [])
    (folder / "density.bov").write_text("\n".join(lines) + "\n")
    return of_grid(folder / "density.bov", whole, name="density")


def hdf5(folder, dtype="<f4", path="/fields/density", others=(), options=(), placed=True, steps=0, take=0, taken=None, **storage):
    whole = grid("offset" if placed else "identity", dtype)
    array = whole.fastest_first()
    if steps:
        all_of = [numbers(wave(whole.places, step), dtype) for step in range(steps)]
        array, whole.values = numpy.stack([values.transpose(2, 1, 0) for values in all_of]), all_of[take]
    with h5py.File(folder / "volume.h5", "w") as file:
        for number, other in enumerate(others, 1):
            file.create_dataset(other, data=numbers(wave(whole.places, number), dtype).transpose(2, 1, 0))
        file.create_dataset(path, data=array, **storage)
    return of_grid(folder / "volume.h5", whole, (*options, *(GIVEN if placed else ())), taken=taken or {})


for dtype in ("u1", "i1", "<u2", "<i2", "<u4", "<i4", "<f4", "<f8"):
    add("raw", "numbers", dtype, raw, dtype=dtype)
for dtype in (">u2", ">i4", ">f4", ">f8"):
    add("raw", "storage", f"big endian {dtype}", raw, dtype=dtype)
add("raw", "storage", "after a header", raw, skip=37)
add("raw", "places", "none given", raw, placed=False)
for dtype in ("u1", "i1", "<u2", "<i2", "<u4", "<i4", "<i8", "<u8", "<f4", "<f8", "<f2"):
    add("NumPy (.npy)", "numbers", dtype, npy, dtype=dtype)
for dtype in (">u2", ">i4", ">f4", ">f8"):
    add("NumPy (.npy)", "storage", f"big endian {dtype}", npy, dtype=dtype)
add("NumPy (.npy)", "storage", "Fortran's order", npy, order="F")
add("NumPy (.npy)", "storage", "version 2", npy, version=(2, 0))
add("NumPy (.npy)", "storage", "version 3", npy, version=(3, 0))
add("NumPy (.npy)", "places", "none given", npy, placed=False)
for order in "CF":
    add("NumPy (.npy)", "places", f"axes z, y, x in {order}'s order", npy, order=order, axes="zyx")
for dtype in ("u1", "<i2", "<i4", "<f8"):
    add("BOV", "numbers", dtype, bov, dtype=dtype)
add("BOV", "storage", "big endian", bov, dtype=">f4")
add("BOV", "storage", "after a header", bov, skip=13)
for frame in ("identity", "offset", "far away"):
    add("BOV", "places", frame, bov, frame=frame)
for dtype in ("u1", "i1", "<u2", "<i2", "<u4", "<i4", "<i8", "<f4", "<f8"):
    add("HDF5 array", "numbers", dtype, hdf5, dtype=dtype)
for dtype in (">i2", ">f8"):
    add("HDF5 array", "storage", f"big endian {dtype}", hdf5, dtype=dtype)
add("HDF5 array", "storage", "chunks, packed", hdf5, chunks=(3, 4, 2), compression="gzip")
add("HDF5 array", "storage", "chunks, shuffled, packed, with checksums", hdf5, chunks=(7, 2, 5), compression="gzip", shuffle=True, fletcher32=True)
add("HDF5 array", "places", "none given", hdf5, placed=False)
add("HDF5 array", "arrays", "one of three, by path", hdf5, others=("/aaa", "/fields/zzz"), options=("--array", "/fields/density"),
    taken={"array": "/?fields/density"})
