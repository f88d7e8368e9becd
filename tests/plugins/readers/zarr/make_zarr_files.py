# SPDX-License-Identifier: GPL-3.0-or-later
# Writes stores into the folder named first, each an array of 5 x 4 x 7 numbers i + 10 j + 25 k (k slowest), by zarr and numcodecs in all the
# ways of packing and with the filters that TAn reads. Exits with 77 without these libraries.
import os
import sys

try:
    import numcodecs
    import numpy
    import zarr
except ImportError:
    sys.exit(77)

folder = sys.argv[1]
k, j, i = numpy.ogrid[:5, :4, :7]
values = i + 10 * j + 25 * k


def write(name, dtype="<i2", compressor=None, **words):
    stored = zarr.open(os.path.join(folder, name), mode="w", shape=values.shape, chunks=(2, 3, 4), dtype=dtype, compressor=compressor, **words)
    stored[:] = values.astype(dtype)


for inner in numcodecs.blosc.list_compressors():
    for shuffle, way in ((numcodecs.Blosc.NOSHUFFLE, "plain"), (numcodecs.Blosc.SHUFFLE, "bytes"), (numcodecs.Blosc.BITSHUFFLE, "bits")):
        write(f"blosc-{inner}-{way}.zarr", compressor=numcodecs.Blosc(cname=inner, clevel=5, shuffle=shuffle))
write("zlib.zarr", compressor=numcodecs.Zlib(level=5))
write("gzip.zarr", ">f8", numcodecs.GZip(level=5))
write("zstd.zarr", "<f4", numcodecs.Zstd(level=5))
write("fortran.zarr", "<u4", numcodecs.Blosc(), order="F")
write("nested.zarr", "<u8", numcodecs.Zstd(), dimension_separator="/")
write("shuffle.zarr", "<i4", numcodecs.Zlib(), filters=[numcodecs.Shuffle(4)])
write("delta.zarr", "<i2", numcodecs.Zlib(), filters=[numcodecs.Delta("<i2")])
write("delta-big.zarr", ">i4", numcodecs.Zlib(), filters=[numcodecs.Delta(">i4")], order="F")
write("delta-float.zarr", "<f8", numcodecs.Zlib(), filters=[numcodecs.Delta("<f8")])
write("both.zarr", "<i4", numcodecs.Blosc(), filters=[numcodecs.Delta("<i4"), numcodecs.Shuffle(4)])
write("quantize.zarr", "<f8", numcodecs.Zlib(), filters=[numcodecs.Quantize(digits=1, dtype="<f8")])
