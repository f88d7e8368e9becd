# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of microscopes: TIFF of every kind by tifffile, OME-Zarr byte by byte."""
import json
import zlib

import numpy

from bench import add, of_grid
from samples import SIZE, grid, library, numbers, wave

tifffile = library("tifffile")

VOXEL = (0.5, 0.25, 2.0)  # along x, y, z
MICROSCOPE = (numpy.diag(VOXEL), (0.0, 0.0, 0.0))
ONES = (numpy.eye(3), (0.0, 0.0, 0.0))
GIVEN = ("--spacing", "x".join(map(str, VOXEL)))


def hyperstack(whole, axes, counts, dtype):
    """Samples of several channels and times, in the order of `axes`; each has a wave of its own, number time * channels + channel."""
    channels, times = counts.get("C", 1), counts.get("T", 1)
    all_of = numpy.stack([numpy.stack([numbers(wave(whole.places, t * channels + c), dtype) for c in range(channels)]) for t in range(times)])
    return numpy.einsum("tcxyz->" + axes.lower(), all_of) if counts else all_of[0, 0].transpose(2, 1, 0), all_of


def stack(folder, dtype="u2", order="<", options=GIVEN, frame=MICROSCOPE, **words):
    """Pages without a word about their size."""
    whole = grid(frame, dtype)
    tifffile.imwrite(str(folder / "stack.tif"), whole.fastest_first(), photometric="minisblack", byteorder=order, metadata=None, **words)
    return of_grid(folder / "stack.tif", whole, options)


def colours(folder, take=1):
    whole = grid(MICROSCOPE, "u1")
    samples = numpy.stack([numbers(wave(whole.places, variant), "u1").transpose(2, 1, 0) for variant in range(3)], axis=-1)
    tifffile.imwrite(str(folder / "stack.tif"), samples, photometric="rgb", metadata=None)
    whole.values = samples[..., take].transpose(2, 1, 0)
    return of_grid(folder / "stack.tif", whole, (*GIVEN, "--component", str(take)), taken={"component": str(take)})


def slices(folder, names, opened, channels=1, take=0, dtype="u2", left_out=()):
    """A file a slice, of each channel."""
    whole = grid(MICROSCOPE, dtype)
    for channel in range(channels):
        values = numbers(wave(whole.places, channel), dtype)
        for k in range(SIZE[2]):
            tifffile.imwrite(str(folder / names.format(k=k, c=channel + 1)), values[:, :, k].T, photometric="minisblack", metadata=None)
        if channel == take:
            whole.values = values
    return of_grid(folder / opened, whole, GIVEN, left_out=left_out)


def imagej(folder, axes="ZYX", dtype="u2", counts=None, options=(), take=0, truncate=False, unit="um", order=None, **said):
    whole = grid(MICROSCOPE, dtype)
    counts = counts or {}
    samples, all_of = hyperstack(whole, axes, counts, dtype)
    tifffile.imwrite(str(folder / "stack.tif"), samples, imagej=True, resolution=(1 / VOXEL[0], 1 / VOXEL[1]), byteorder=order, truncate=truncate,
                     metadata={"axes": axes, "spacing": VOXEL[2], "unit": unit})
    whole.values = all_of.reshape(-1, *SIZE)[take]
    return of_grid(folder / "stack.tif", whole, options, place_slack=1e-6, **said)


def ome(folder, axes="ZYX", dtype="u2", counts=None, options=(), take=0, unit="µm", ending=".ome.tif", **said):
    whole = grid(MICROSCOPE, dtype)
    counts = counts or {}
    samples, all_of = hyperstack(whole, axes, counts, dtype)
    described = {"axes": axes} | {f"PhysicalSize{axis}": length for axis, length in zip("XYZ", VOXEL)} | {f"PhysicalSize{axis}Unit": unit for axis in "XYZ"}
    if "C" in counts:
        described["Channel"] = {"Name": ["DAPI", "GFP", "RFP"][:counts["C"]]}
    tifffile.imwrite(str(folder / f"cells{ending}"), samples, ome=True, photometric="minisblack", metadata=described)
    whole.values = all_of.reshape(-1, *SIZE)[take]
    return of_grid(folder / f"cells{ending}", whole, options, place_slack=1e-6, **said)


for dtype in ("u1", "i1", "u2", "i2", "u4", "i4", "f4", "f8", "f2"):
    add("TIFF", "numbers", dtype, stack, dtype=dtype)
add("TIFF", "places", "no voxels: 1 x 1 x 1", stack, options=(), frame=ONES)
add("TIFF", "places", "voxels given", stack)
for dtype in ("u2", "i2", "f4", "f8"):
    add("TIFF", "storage", f"big endian {dtype}", stack, order=">", dtype=dtype)
add("TIFF", "storage", "BigTIFF", stack, bigtiff=True)
add("TIFF", "storage", "packed by zlib", stack, compression="zlib")
add("TIFF", "storage", "tiles", stack, tile=(16, 16))
add("TIFF", "storage", "strips of two rows", stack, rowsperstrip=2)
add("TIFF", "storage", "a file a slice", slices, names="cell{k:03d}.tif", opened="cell000.tif")
add("TIFF", "storage", "a file a slice, numbers without zeros", slices, names="cell{k}.tif", opened="cell4.tif")
add("TIFF", "series", "two channels as files", slices, names="cell_z{k:02d}_c{c}.tif", opened="cell_z00_c2.tif", channels=2, take=1)
add("TIFF", "arrays", "green of three colours", colours)

add("TIFF, ImageJ", "places", "voxels", imagej, quick=True)
add("TIFF, ImageJ", "storage", "little endian", imagej, order="<")
add("TIFF, ImageJ", "storage", "a large stack, of one page", imagej, truncate=True)
for dtype in ("u1", "f4"):
    add("TIFF, ImageJ", "numbers", dtype, imagej, dtype=dtype)
add("TIFF, ImageJ", "series", "the first of 2 channels", imagej, axes="ZCYX", counts={"C": 2}, taken={"channel": "1 of 2"})
add("TIFF, ImageJ", "series", "the second of 2 channels", imagej, axes="ZCYX", counts={"C": 2}, options=("--channel", "2"), take=1, taken={"channel": "2 of 2"})
add("TIFF, ImageJ", "steps", "the first of 3 times", imagej, axes="TZYX", counts={"T": 3}, taken={"step": "1 of 3"}, guessed=("step",))
add("TIFF, ImageJ", "steps", "the second of 3 times", imagej, axes="TZYX", counts={"T": 3}, options=("--time", "2"), take=1, taken={"step": "2 of 3"})
add("TIFF, ImageJ", "series", "time 2, channel 2 of 3 x 2", imagej, axes="TZCYX", counts={"T": 3, "C": 2}, options=("--time", "2", "--channel", "2"), take=3)

add("TIFF, OME", "places", "voxels", ome, quick=True)
add("TIFF, OME", "places", "voxels in nanometres", ome, unit="nm")
for dtype in ("u1", "i2", "f4", "f8"):
    add("TIFF, OME", "numbers", dtype, ome, dtype=dtype)
for axes in ("CZYX", "ZCYX"):
    add("TIFF, OME", "series", f"the second of 3 channels, {axes}", ome, axes=axes, counts={"C": 3}, options=("--channel", "2"), take=1,
        taken={"channel": "2 of 3|GFP"})
add("TIFF, OME", "series", "the first of 3 channels", ome, axes="CZYX", counts={"C": 3}, taken={"channel": "1 of 3|DAPI"}, left_out=("channel",))
for axes in ("TZYX", "ZTYX"):
    add("TIFF, OME", "steps", f"the third of 3 times, {axes}", ome, axes=axes, counts={"T": 3}, options=("--time", "3"), take=2, taken={"step": "3 of 3"})
for axes in ("TCZYX", "TZCYX", "CTZYX", "ZCTYX"):
    add("TIFF, OME", "series", f"time 2, channel 3, {axes}", ome, axes=axes, counts={"T": 2, "C": 3}, options=("--time", "2", "--channel", "3"), take=5)


# OME-Zarr: chunks in files, JSON that says what they are.

def chunks_of(array, shape):
    """Number of a chunk along each axis -> its samples, filled up to the whole chunk."""
    counts = [-(-size // chunk) for size, chunk in zip(array.shape, shape)]
    for at in numpy.ndindex(*counts):
        part = array[tuple(slice(n * chunk, (n + 1) * chunk) for n, chunk in zip(at, shape))]
        yield at, numpy.pad(part, [(0, chunk - size) for chunk, size in zip(shape, part.shape)])


def zarr_array(folder, array, version, chunk, packed, separator, absent):
    folder.mkdir(parents=True)
    pack = zlib.compress if packed else bytes
    if version == 2:
        (folder / ".zarray").write_text(json.dumps({
            "zarr_format": 2, "shape": array.shape, "chunks": chunk, "dtype": array.dtype.str, "order": "C", "fill_value": 0, "filters": None,
            "compressor": {"id": "zlib", "level": 1} if packed else None, "dimension_separator": separator}))
    else:
        names = {"u1": "uint8", "u2": "uint16", "i2": "int16", "f4": "float32", "f8": "float64"}
        codecs = [{"name": "bytes", "configuration": {"endian": "big" if array.dtype.byteorder == ">" else "little"}}]
        pack = (lambda data: __import__("gzip").compress(data)) if packed else bytes
        (folder / "zarr.json").write_text(json.dumps({
            "zarr_format": 3, "node_type": "array", "shape": array.shape, "data_type": names[array.dtype.str[1:]], "fill_value": 0,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": chunk}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": separator}},
            "codecs": codecs + ([{"name": "gzip", "configuration": {"level": 1}}] if packed else []), "attributes": {}}))
    for at, samples in chunks_of(array, chunk):
        if at == absent:
            continue
        name = separator.join((["c"] if version == 3 else []) + [str(n) for n in at])
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(pack(numpy.ascontiguousarray(samples).tobytes()))


def zarr(folder, version=2, dtype="<u2", counts=None, axes="zyx", packed=True, separator="/", translation=(0, 0, 0), options=(), take=0, level=0,
         absent=False, **said):
    whole = grid((numpy.diag(VOXEL), translation), dtype)
    counts = counts or {}
    samples, all_of = hyperstack(whole, axes.upper(), counts, dtype)
    whole.values = all_of.reshape(-1, *SIZE)[take]
    chunk = [{"t": 1, "c": 1, "z": 3, "y": 4, "x": 2}[axis] for axis in axes]
    gone = None
    if absent:  # a chunk that nobody wrote has the fill value: the one at the end of all axes
        gone = tuple((size - 1) // one for size, one in zip(samples.shape, chunk))
        samples = samples.copy()
        samples[tuple(slice(n * one, None) for n, one in zip(gone, chunk))] = 0
        whole.values = samples.transpose(2, 1, 0)
    root = folder / "cells.ome.zarr"
    zarr_array(root / "0", samples, version, chunk, packed, separator, gone)
    coarser = numpy.ascontiguousarray(samples[..., ::2, ::2, ::2])
    zarr_array(root / "1", coarser, version, chunk, packed, separator, None)
    scale = {"t": 1.0, "c": 1.0, "z": VOXEL[2], "y": VOXEL[1], "x": VOXEL[0]}
    move = {"t": 0.0, "c": 0.0, "z": translation[2], "y": translation[1], "x": translation[0]}
    datasets = [{"path": str(number), "coordinateTransformations": [
        {"type": "scale", "scale": [scale[axis] * (2 ** number if axis in "xyz" else 1) for axis in axes]},
        {"type": "translation", "translation": [move[axis] for axis in axes]}]} for number in range(2)]
    kinds = {"t": "time", "c": "channel"}
    multiscales = [{"version": "0.4" if version == 2 else "0.5", "name": "cells", "datasets": datasets,
                    "axes": [{"name": axis, "type": kinds.get(axis, "space")} | ({"unit": "micrometer"} if axis in "xyz" else {}) for axis in axes]}]
    if version == 2:
        (root / ".zgroup").write_text('{"zarr_format": 2}')
        (root / ".zattrs").write_text(json.dumps({"multiscales": multiscales}))
    else:
        (root / "zarr.json").write_text(json.dumps({"zarr_format": 3, "node_type": "group", "attributes": {
            "ome": {"version": "0.5", "multiscales": multiscales}}}))
    if level == 1:
        values = coarser.reshape(-1, *coarser.shape[-3:])[take].transpose(2, 1, 0)
        coarse = grid((numpy.diag(VOXEL) * 2, translation), dtype, size=values.shape)
        coarse.values = values
        whole = coarse
    return of_grid(root, whole, options, **said)


for version in (2, 3):
    name = f"OME-Zarr, version {version}"
    add(name, "places", "scale", zarr, version=version)
    add(name, "places", "scale and translation", zarr, version=version, translation=(10.5, -20.25, 30))
    for dtype in ("u1", "<i2", "<f4", "<f8"):
        add(name, "numbers", dtype, zarr, version=version, dtype=dtype)
    add(name, "storage", "big endian >u2", zarr, version=version, dtype=">u2")
    add(name, "storage", "not packed", zarr, version=version, packed=False)
    add(name, "storage", "names with dots", zarr, version=version, separator=".")
    add(name, "storage", "a chunk that nobody wrote", zarr, version=version, absent=True)
    add(name, "series", "the second of 2 channels", zarr, version=version, axes="czyx", counts={"C": 2}, options=("--channel", "2"), take=1,
        taken={"channel": "2 of 2"})
    add(name, "steps", "time 2 of 3, channel 2", zarr, version=version, axes="tczyx", counts={"T": 3, "C": 2}, options=("--time", "2", "--channel", "2"),
        take=3, taken={"step": "2 of 3"})
    add(name, "arrays", "the coarser level", zarr, version=version, level=1, options=("--part", "1"), taken={"block": "1"})
