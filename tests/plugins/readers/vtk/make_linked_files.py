# SPDX-License-Identifier: GPL-3.0-or-later
# Writes into the folder named first, as files of NetCDF-4, CGNS and VTK HDF, for each a good one, and those whose values lie in another
# file: KIND.WAY/a.ENDING, the other file beside these folders. Exits with 77 without h5py.
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "torture"))
import bomb_files  # noqa: E402

if not bomb_files.h5py:
    sys.exit(77)

home = pathlib.Path(sys.argv[1])
WAYS = "a link", "a link by its whole path", "a virtual array", "values elsewhere"


def written(kind, way, write):
    folder = home / ("%s.%s" % (kind, way))
    folder.mkdir()
    write(folder)


def netcdf(folder):
    with bomb_files.h5py.File(folder / "a.nc", "w") as file:
        file["values"] = bomb_files.numpy.arange(27.).reshape(3, 3, 3)


bomb_files.secrets(home)
written("netcdf", "good", netcdf)
written("cgns", "good", lambda folder: bomb_files.cgns(folder, (3, 3, 3)))
written("vtkhdf", "good", bomb_files.vtkhdf)
for name, _, write in (*bomb_files.hdf5s(), *bomb_files.solvers_hdf5()):
    kind, _, way = name.partition(", ")
    if kind in ("netcdf", "cgns", "vtkhdf") and way in WAYS:
        written(kind, way, write)
