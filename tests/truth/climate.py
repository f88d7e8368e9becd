# SPDX-License-Identifier: GPL-3.0-or-later
"""NetCDF by its Python library: variables over longitude, latitude and height, which are x, y and z."""
import numpy

from bench import add, of_grid
from samples import SIZE, Grid, axes, curvilinear, grid, library, numbers, rectilinear, some_holes, wave

netcdf = library("netCDF4")

UNITS = {"lon": "degrees_east", "lat": "degrees_north", "height": "m"}
FORMATS = ("NETCDF3_CLASSIC", "NETCDF3_64BIT_OFFSET", "NETCDF3_64BIT_DATA", "NETCDF4", "NETCDF4_CLASSIC")
REGULAR = (numpy.diag((0.5, 0.25, 100.0)), (5.0, 45.0, 200.0))


def create(folder, format="NETCDF4", name="field.nc"):
    file = netcdf.Dataset(str(folder / name), "w", format=format)
    file.Conventions = "CF-1.8"
    return file


def add_axes(file, along, order, dtype="f8", positive="up"):
    for name in order:
        file.createDimension(name, len(along[name]))
        axis = file.createVariable(name, dtype, (name,))
        axis.units, axis[:] = UNITS[name], along[name]
        if name == "height":
            axis.axis, axis.positive = "Z", positive


def field(folder, format="NETCDF4", dtype="f4", where=REGULAR, order=("height", "lat", "lon"), variables=("temperature",), steps=0, options=(), take=0,
          axis_type="f8", packing=None, positive="up", unsigned=False, missing=None, unwritten=False, holes=None, **said):
    """`variables`, each a wave of its own, at `steps` times; `missing`: attribute -> number of those that say which stored numbers are no values;
    packing: scale and offset."""
    whole = grid(where, "f8") if isinstance(where, tuple) else rectilinear(where)
    along = dict(zip(("lon", "lat", "height"), (whole.places[:, 0, 0, 0], whole.places[0, :, 0, 1], whole.places[0, 0, :, 2])))
    along = {name: values.astype(axis_type).astype(float) for name, values in along.items()}
    if isinstance(where, list):
        whole.places = numpy.stack(numpy.meshgrid(*(along[name] for name in ("lon", "lat", "height")), indexing="ij"), axis=-1)
    file = create(folder, format)
    file.set_auto_maskandscale(False)
    if steps:
        file.createDimension("time", None)
        time = file.createVariable("time", "f8", ("time",))
        time.units, time[:] = "hours since 2026-01-01", numpy.arange(steps) * 6.0
    add_axes(file, along, order, axis_type, positive)
    letters = {"lon": "x", "lat": "y", "height": "z"}
    missing = missing or {}
    for number, name in enumerate(variables):
        fill = missing.get("_FillValue", None)
        variable = file.createVariable(name, dtype, (("time",) if steps else ()) + tuple(order), fill_value=fill)
        variable.set_auto_maskandscale(False)
        variable.units, variable.long_name = "K", name
        for attribute, value in missing.items():
            if attribute != "_FillValue":
                variable.setncattr(attribute, numpy.array(value, dtype) if not isinstance(value, str) else value)
        if unsigned:
            variable.setncattr("_Unsigned", "true")
        if packing:
            variable.scale_factor, variable.add_offset = packing
        for step in range(max(1, steps)):
            # One time with holes has the same holes at all.
            stored = numbers(wave(whole.places, number * 7 + step), dtype)
            if holes is not None:
                stored = numpy.where(some_holes(), numpy.array(holes).astype(stored.dtype), stored)
            out = numpy.einsum("xyz->" + "".join(letters[one] for one in order), stored)
            if unwritten:  # the library fills what nobody writes
                for at in numpy.argwhere(~numpy.einsum("xyz->" + "".join(letters[one] for one in order), some_holes())):
                    variable[tuple(at)] = out[tuple(at)]
            elif steps:
                variable[step] = out
            else:
                variable[:] = out
            if number * 7 + step == take:
                whole.values = (stored.view(stored.dtype.str.replace("i", "u")) if unsigned else stored).astype(float)
    if packing:
        whole.values = whole.values * packing[0] + packing[1]
    file.close()
    nothing = some_holes() if holes is not None or unwritten else None
    return of_grid(folder / "field.nc", whole, options, nothing, value_slack=2e-7 if packing else 0, place_slack=1e-6 if axis_type == "f4" else 1e-12, **said)


def bare(folder):
    """No coordinates: places are the numbers of the samples."""
    whole = grid("identity")
    file = create(folder)
    for name, size in zip("zyx", SIZE[::-1]):
        file.createDimension(name, size)
    file.createVariable("density", "f4", ("z", "y", "x"))[:] = whole.fastest_first()
    file.close()
    return of_grid(folder / "field.nc", whole)


def two_dimensional(folder, holes=None):
    """Longitude and latitude of each column, as ocean models have them."""
    flat = curvilinear()
    longitude, latitude, height = flat.places[:, :, 0, 0], flat.places[:, :, 0, 1], 10.0 * numpy.arange(SIZE[2])
    places = numpy.empty((*SIZE, 3))
    places[..., 0], places[..., 1], places[..., 2] = longitude[:, :, None], latitude[:, :, None], height
    whole = Grid(flat.steps, flat.origin, places, numbers(wave(places), "f4"))
    file = create(folder)
    for name, size in (("depth", SIZE[2]), ("nj", SIZE[1]), ("ni", SIZE[0])):
        file.createDimension(name, size)
    depth = file.createVariable("depth", "f8", ("depth",))
    depth.units, depth.axis, depth.positive, depth[:] = "m", "Z", "up", height
    for name, values, unit in (("lon", longitude, "degrees_east"), ("lat", latitude, "degrees_north")):
        variable = file.createVariable(name, "f8", ("nj", "ni"))
        variable.units, variable[:] = unit, values.T
    variable = file.createVariable("salinity", "f4", ("depth", "nj", "ni"), fill_value=holes)
    variable.coordinates = "lat lon"
    variable.set_auto_mask(False)
    variable[:] = whole.fastest_first() if holes is None else numpy.where(some_holes().transpose(2, 1, 0), numpy.float32(holes), whole.fastest_first())
    file.close()
    return of_grid(folder / "field.nc", whole, (), None if holes is None else some_holes(), place_slack=1e-12)


def wrf(folder, step=1, options=("--time", "2")):
    """The weather model WRF: longitudes and latitudes of columns, heights by the geopotential at the faces between layers; times are texts."""
    flat = curvilinear()
    longitude, latitude = flat.places[:, :, 0, 0] + 5, flat.places[:, :, 0, 1] + 45
    faces = 9.81 * (100 + 50.0 * numpy.arange(SIZE[2] + 1) + 3 * numpy.indices((SIZE[0], SIZE[1], 1)).sum(axis=0))  # [i, j, faces]
    base = numpy.round(0.9 * faces)
    file = create(folder, "NETCDF3_64BIT_OFFSET", "wrfout_d01")
    for name, size in (("Time", None), ("DateStrLen", 19), ("west_east", SIZE[0]), ("south_north", SIZE[1]), ("bottom_top", SIZE[2]),
                       ("bottom_top_stag", SIZE[2] + 1)):
        file.createDimension(name, size)
    file.createVariable("Times", "S1", ("Time", "DateStrLen"))[:] = numpy.array([list(f"2026-01-01_{hour:02d}:00:00") for hour in (0, 6)], "S1")
    for name, values, unit in (("XLAT", latitude, "degree_north"), ("XLONG", longitude, "degree_east")):
        variable = file.createVariable(name, "f8", ("Time", "south_north", "west_east"))
        variable.units, variable[:] = unit, numpy.stack([values.T] * 2)
    for name, values in (("PH", faces - base), ("PHB", base)):
        variable = file.createVariable(name, "f8", ("Time", "bottom_top_stag", "south_north", "west_east"))
        variable.units, variable.stagger, variable[:] = "m2 s-2", "Z", numpy.stack([values.transpose(2, 1, 0)] * 2)
    places = numpy.empty((*SIZE, 3))
    places[..., 0], places[..., 1] = longitude[:, :, None], latitude[:, :, None]
    places[..., 2] = (faces[:, :, 1:] + faces[:, :, :-1]) / 2 / 9.81
    fields = [numbers(wave(places, number), "f4") for number in range(2)]
    variable = file.createVariable("T", "f4", ("Time", "bottom_top", "south_north", "west_east"))
    variable.units, variable.coordinates, variable[:] = "K", "XLONG XLAT XTIME", numpy.stack([values.transpose(2, 1, 0) for values in fields])
    file.close()
    (folder / "wrfout_d01").rename(folder / "wrfout_d01.nc")
    return of_grid(folder / "wrfout_d01.nc", Grid(flat.steps, flat.origin, places, fields[step]), ("--array", "T", *options), place_slack=1e-12,
                   taken={"step": f"{step + 1} of 2", "array": "^/?T$"})


for format in FORMATS:
    add("NetCDF", "storage", format, field, format=format, quick=format == "NETCDF4")
    add("NetCDF", "holes", f"{format}, packed, _FillValue and missing_value", field, format=format, dtype="i2", packing=(0.002, 280.0), holes=-32767,
        missing={"_FillValue": -32767, "missing_value": -32767}, quick=format == "NETCDF3_64BIT_OFFSET")
add("NetCDF", "places", "uneven heights", field, where=axes())
add("NetCDF", "places", "latitudes that fall", field, where=(numpy.diag((0.5, -0.25, 100.0)), (5.0, 45.0, 200.0)))
add("NetCDF", "places", "uneven, latitudes and heights that fall", field, where=[axes()[0], axes()[1][::-1], axes()[2][::-1]])
add("NetCDF", "places", "single precision axes", field, axis_type="f4", where=(numpy.diag((0.1, 0.3, 0.7)), (5.1, 45.2, 0.3)))
add("NetCDF", "places", "order lat, lon, height", field, order=("lat", "lon", "height"))
add("NetCDF", "places", "depths stay as they are", field, positive="down", left_out=("downwards",))
add("NetCDF", "places", "no coordinates", bare)
add("NetCDF", "places", "WRF", wrf)
add("NetCDF", "steps", "WRF, the first of 2 times", wrf, step=0, options=())
add("NetCDF", "places", "2-D longitude and latitude", two_dimensional)
for dtype in ("i1", "i2", "i4", "f4", "f8"):
    add("NetCDF", "numbers", dtype, field, dtype=dtype, format="NETCDF3_CLASSIC")
for dtype in ("u1", "u2", "u4", "i8", "u8"):
    add("NetCDF", "numbers", dtype, field, dtype=dtype)
for dtype in ("i1", "i2"):
    add("NetCDF", "numbers", f"{dtype} that is unsigned by _Unsigned", field, dtype=dtype, unsigned=True, format="NETCDF3_CLASSIC")
add("NetCDF", "numbers", "packed i2", field, dtype="i2", packing=(0.01, 250.0))
add("NetCDF", "numbers", "packed u1", field, dtype="u1", packing=(0.5, -60.0))
add("NetCDF", "holes", "_FillValue", field, holes=1e20, missing={"_FillValue": 1e20})
add("NetCDF", "holes", "_FillValue of doubles", field, dtype="f8", holes=-9999.0, missing={"_FillValue": -9999.0})
add("NetCDF", "holes", "missing_value alone", field, holes=-999.0, missing={"missing_value": -999.0}, taken={"fill": "-999"})
add("NetCDF", "holes", "_FillValue that is another than missing_value", field, holes=-999.0, missing={"_FillValue": 1e20, "missing_value": -999.0})
add("NetCDF", "holes", "valid_range", field, holes=5000.0, missing={"valid_range": [-200.0, 200.0]})
add("NetCDF", "holes", "valid_min and valid_max", field, dtype="i2", holes=32000, missing={"valid_min": -30000, "valid_max": 30000})
add("NetCDF", "holes", "valid_max of stored numbers", field, dtype="i2", packing=(0.01, 250.0), holes=30001, missing={"valid_max": 30000})
add("NetCDF", "holes", "packed, missing_value alone", field, dtype="i2", packing=(0.01, 250.0), holes=-32767, missing={"missing_value": -32767})
add("NetCDF", "holes", "NaN", field, holes=numpy.nan)
add("NetCDF", "holes", "the library's own fill value", field, unwritten=True)
add("NetCDF", "holes", "2-D longitude and latitude", two_dimensional, holes=1e20)
TWO = ("temperature", "humidity")
add("NetCDF", "arrays", "the first of two", field, variables=TWO, taken={"array": "^temperature"}, guessed=("array",))
add("NetCDF", "arrays", "the second of two", field, variables=TWO, options=("--array", "humidity"), take=7, taken={"array": "^humidity"})
add("NetCDF", "steps", "the first of 3 times", field, steps=3, taken={"step": "1 of 3"}, guessed=("step",))
add("NetCDF", "steps", "the third of 3 times", field, steps=3, options=("--time", "3"), take=2, taken={"step": "3 of 3"}, format="NETCDF3_CLASSIC")
add("NetCDF", "steps", "time 2 of the second of two", field, steps=3, variables=TWO, options=("--time", "2", "--array", "humidity"), take=8,
    taken={"array": "^humidity", "step": "2 of 3"})
