# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of solvers: Exodus by netCDF4, CGNS by h5py, and EnSight, Tecplot, PLOT3D, OpenFOAM, Fluent and GAMBIT line by line."""
import functools
import gzip

import numpy

from bench import add, of_cells, of_grid
from mesh_samples import boxes, mesh, values_at_points
from samples import SIZE, axes, curvilinear, grid, library, numbers, rectilinear, some_holes, wave

h5py = library("h5py")
netcdf = library("netCDF4")

# Exodus II: HEX20 has its upright edges before those of the top.
EXODUS = {"tetrahedra": "TETRA4", "hexahedra": "HEX8", "wedges": "WEDGE6", "pyramids": "PYRAMID5", "quadratic tetrahedra": "TETRA10",
          "quadratic hexahedra": "HEX20"}
HEX20 = [*range(12), 16, 17, 18, 19, 12, 13, 14, 15]


def exodus(folder, kind="hexahedra", of="points", names=("temperature",), steps=1, take=(0, 0), word=8, format="NETCDF3_64BIT_OFFSET", file_size=True,
           joined="", ending=".exo", options=(), blocks_in=None, displaced=False, **said):
    points, blocks, judged, _ = mesh(kind)
    if blocks_in:  # one kind of cells in several blocks
        name, cells = blocks[0]
        blocks = [(name, part) for part in numpy.array_split(cells, blocks_in)]
    real = "f8" if word == 8 else "f4"
    points = points.astype(real).astype(float)
    file = netcdf.Dataset(str(folder / f"result{ending}"), "w", format=format)
    file.set_auto_mask(False)
    file.api_version, file.version, file.floating_point_word_size, file.title = numpy.float32(5.14), numpy.float32(5.14), numpy.int32(word), "bench"
    if file_size:
        file.file_size = numpy.int32(1)
    count = sum(len(cells) for _, cells in blocks)
    for name, size in (("len_string", 33), ("len_line", 81), ("four", 4), ("time_step", None), ("num_dim", 3), ("num_nodes", len(points)),
                       ("num_elem", count), ("num_el_blk", len(blocks))):
        file.createDimension(name, size)
    file.createVariable("time_whole", real, ("time_step",))[:] = numpy.arange(steps) * 0.5
    if joined:
        file.createVariable("coord", real, ("num_dim", "num_nodes"))[:] = points.T
    else:
        for name, column in zip("xyz", points.T):
            file.createVariable(f"coord{name}", real, ("num_nodes",))[:] = column
    file.createVariable("eb_status", "i4", ("num_el_blk",))[:] = 1
    identity = file.createVariable("eb_prop1", "i4", ("num_el_blk",))
    identity.setncattr("name", "ID")
    identity[:] = 10 + numpy.arange(len(blocks))
    for number, (name, cells) in enumerate(blocks, 1):
        file.createDimension(f"num_el_in_blk{number}", len(cells))
        file.createDimension(f"num_nod_per_el{number}", cells.shape[1])
        connect = file.createVariable(f"connect{number}", "i4", (f"num_el_in_blk{number}", f"num_nod_per_el{number}"))
        connect.elem_type = EXODUS[name]
        connect[:] = (cells[:, HEX20] if name == "quadratic hexahedra" else cells) + 1
    word_of, place = ("nod", points) if of == "points" else ("elem", numpy.concatenate([points[cells].mean(axis=1) for _, cells in blocks]))
    file.createDimension(f"num_{word_of}_var", len(names))
    texts = numpy.zeros((len(names), 33), "S1")
    for row, name in zip(texts, names):
        row[:len(name)] = list(name)
    file.createVariable(f"name_{word_of}_var", "S1", (f"num_{word_of}_var", "len_string"))[:] = texts
    kept = None
    for variable in range(len(names)):
        for step in range(steps):
            values = numbers(wave(place, variable * 3 + step), real) * (1e-3 if names[variable].startswith("disp") else 1)
            if joined == "all":
                name, dimensions = "vals_nod_var", ("time_step", "num_nod_var", "num_nodes")
                out = file.variables[name] if name in file.variables else file.createVariable(name, real, dimensions)
                out[step, variable] = values
            elif of == "points":
                name, dimensions = f"vals_nod_var{variable + 1}", ("time_step", "num_nodes")
                out = file.variables[name] if name in file.variables else file.createVariable(name, real, dimensions)
                out[step] = values
            else:
                first = 0
                for number, (_, cells) in enumerate(blocks, 1):
                    name = f"vals_elem_var{variable + 1}eb{number}"
                    dimensions = ("time_step", f"num_el_in_blk{number}")
                    out = file.variables[name] if name in file.variables else file.createVariable(name, real, dimensions)
                    out[step] = values[first:first + len(cells)]
                    first += len(cells)
            if (variable, step) == take:
                kept = values.astype(float)
    file.close()
    if of != "points":
        kept = values_at_points(len(points), [cells for _, cells in blocks], kept)
    if displaced:
        points = points + 1e-3 * numpy.stack([numbers(wave(place, variable * 3 + take[1]), real) for variable in range(3)], axis=1)
    return of_cells(folder / f"result{ending}", points, kept, judged, options, value_slack=0 if of == "points" else 3e-7, **said)


for kind in EXODUS:
    add("Exodus II", "cells", kind, exodus, kind=kind, quick=kind == "hexahedra")
add("Exodus II", "cells", "several kinds in blocks", exodus, kind="mixed")
add("Exodus II", "numbers", "single precision", exodus, word=4)
for format in ("NETCDF3_CLASSIC", "NETCDF3_64BIT_DATA", "NETCDF4"):
    add("Exodus II", "storage", format, exodus, format=format)
add("Exodus II", "storage", "no file_size: arrays of all coordinates and of all variables", exodus, file_size=False, joined="all",
    names=("temperature", "pressure"), take=(1, 0), options=("--array", "pressure"))
add("Exodus II", "storage", "no file_size: an array of all coordinates", exodus, file_size=False, joined="coordinates")
add("Exodus II", "storage", "three blocks, *.e", exodus, blocks_in=3, ending=".e")
add("Exodus II", "arrays", "values of elements", exodus, of="elements", blocks_in=2)
add("Exodus II", "arrays", "the second of two", exodus, names=("temperature", "pressure"), take=(1, 0), options=("--array", "pressure"), taken={"array": "pressure"})
add("Exodus II", "steps", "the first of 3", exodus, steps=3, taken={"step": "1 of 3"}, guessed=("step",))
add("Exodus II", "steps", "the third of 3", exodus, steps=3, take=(0, 2), options=("--time", "3"), taken={"step": "3 of 3"})
MOVED = {"names": ("disp_x", "disp_y", "disp_z", "temperature"), "steps": 2, "take": (3, 1)}
add("Exodus II", "places", "displacements are told", exodus, **MOVED, options=("--time", "2", "--array", "temperature"), left_out=("displacement",))
add("Exodus II", "places", "displacements are added", exodus, **MOVED, options=("--time", "2", "--array", "temperature", "--displace"), displaced=True,
    place_slack=1e-15)


# CGNS in HDF5: a node is a group with its name, its kind and " data"; arrays as C has them, the last index fastest.

def cgns_text(group, name, text, length):
    group.attrs.create(name, numpy.bytes_(text), dtype=h5py.string_dtype("ascii", length))


def cgns_node(parent, name, label, data=None):
    node = parent.create_group(name, track_order=True)
    if isinstance(data, str):
        data = numpy.frombuffer(data.encode(), "i1")
    kind = "MT" if data is None else {"i1": "C1", "i4": "I4", "i8": "I8", "f4": "R4", "f8": "R8"}[data.dtype.str[1:]]
    cgns_text(node, "name", name, 33)
    cgns_text(node, "label", label, 33)
    cgns_text(node, "type", kind, 3)
    node.attrs["flags"] = numpy.array([1], "i4")
    if data is not None:
        node.create_dataset(" data", data=data)
    return node


def cgns_file(path):
    file = h5py.File(path, "w", track_order=True, libver=("earliest", "v108"))
    cgns_text(file, "name", "HDF5 MotherNode", 33)
    cgns_text(file, "label", "Root Node of HDF5 File", 33)
    cgns_text(file, "type", "MT", 3)
    file.create_dataset(" format", data=numpy.frombuffer(b"IEEE_LITTLE_32\0", "i1"))
    file.create_dataset(" hdf5version", data=numpy.frombuffer(b"HDF5 Version 1.10.8".ljust(33, b"\0"), "i1"))
    cgns_node(file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", numpy.array([3.1], "f4"))
    return file, cgns_node(file, "Base", "CGNSBase_t", numpy.array([3, 3], "i4"))


def cgns_zone(base, name, sizes, kind, places, solution, location="Vertex"):
    zone = cgns_node(base, name, "Zone_t", numpy.array(sizes, "i4"))
    cgns_node(zone, "ZoneType", "ZoneType_t", kind)
    coordinates = cgns_node(zone, "GridCoordinates", "GridCoordinates_t")
    for axis, values in zip("XYZ", places):
        cgns_node(coordinates, f"Coordinate{axis}", "DataArray_t", numpy.ascontiguousarray(values))
    flow = cgns_node(zone, "FlowSolution", "FlowSolution_t")
    if location != "Vertex":
        cgns_node(flow, "GridLocation", "GridLocation_t", location)
    for array, values in solution.items():
        cgns_node(flow, array, "DataArray_t", numpy.ascontiguousarray(values))
    return zone


def cgns_grid(folder, whole, zones=1, names=("Density",), take=0, real="f8", options=(), **said):
    """Zones share a layer of points."""
    whole = whole()
    whole.places = whole.places.astype(real).astype(float)
    arrays = {name: numbers(wave(whole.places, number), real) for number, name in enumerate(names)}
    file, base = cgns_file(folder / "flow.cgns")
    parts = [slice(None)] if zones == 1 else [slice(0, 4), slice(3, None)]
    for number, part in enumerate(parts, 1):
        size = whole.values[:, :, part].shape
        cgns_zone(base, f"Zone{number}", [size, [n - 1 for n in size], [0, 0, 0]], "Structured",
                  [whole.places[:, :, part, axis].transpose(2, 1, 0).astype(real) for axis in range(3)],
                  {name: values[:, :, part].transpose(2, 1, 0) for name, values in arrays.items()})
    file.close()
    whole.values = arrays[names[take]]
    return of_grid(folder / "flow.cgns", whole, options, **said)


CGNS = {"tetrahedra": 10, "hexahedra": 17, "wedges": 14, "pyramids": 12}


def cgns_mesh(folder, kind, location="Vertex"):
    points, blocks, judged, _ = mesh(kind)
    cells = [of for _, of in blocks]
    count = sum(map(len, cells))
    place = points if location == "Vertex" else numpy.concatenate([points[of].mean(axis=1) for of in cells])
    values = numbers(wave(place), "f8")
    file, base = cgns_file(folder / "flow.cgns")
    zone = cgns_zone(base, "Zone", [[len(points)], [count], [0]], "Unstructured", points.T, {"Temperature": values}, location)
    first = 1
    for number, (name, of) in enumerate(blocks):
        section = cgns_node(zone, f"Cells{number}", "Elements_t", numpy.array([CGNS[name], 0], "i4"))
        cgns_node(section, "ElementRange", "IndexRange_t", numpy.array([first, first + len(of) - 1], "i4"))
        cgns_node(section, "ElementConnectivity", "DataArray_t", (of + 1).ravel().astype("i4"))
        first += len(of)
    file.close()
    if location != "Vertex":
        values = values_at_points(len(points), cells, values)
    return of_cells(folder / "flow.cgns", points, values, judged, value_slack=0 if location == "Vertex" else 3e-7)


add("CGNS", "places", "bent grid", cgns_grid, whole=functools.partial(curvilinear, "f8"))
add("CGNS", "places", "oblique grid", cgns_grid, whole=functools.partial(grid, "oblique, mirrored", "f8"))
add("CGNS", "places", "two zones that meet", cgns_grid, whole=functools.partial(curvilinear, "f8"), zones=2)
add("CGNS", "numbers", "single precision", cgns_grid, whole=functools.partial(curvilinear, "f8"), real="f4")
add("CGNS", "arrays", "the second of two", cgns_grid, whole=functools.partial(curvilinear, "f8"), names=("Density", "Pressure"), take=1,
    options=("--array", "Pressure"), taken={"array": "Pressure"})
for kind in (*CGNS, "mixed"):
    add("CGNS", "cells", kind, cgns_mesh, kind=kind)
add("CGNS", "arrays", "values of cells", cgns_mesh, kind="hexahedra", location="CellCenter")


# EnSight Gold: five digits in text, single precision in binary files.

ENSIGHT = {"tetrahedra": "tetra4", "hexahedra": "hexa8", "wedges": "penta6", "pyramids": "pyramid5", "quadratic tetrahedra": "tetra10"}


class EnsightText:
    def __init__(self):
        self.bytes = b""

    def words(self, text):
        self.bytes += text.encode() + b"\n"

    def whole(self, rows):
        self.bytes += "".join("".join(f"{number:10d}" for number in row) + "\n" for row in numpy.atleast_2d(rows).tolist()).encode()

    def reals(self, values):
        self.bytes += "".join(f"{value:12.5e}\n" for value in values.tolist()).encode()

    @staticmethod
    def rounded(values):
        return numpy.array([float(f"{value:12.5e}") for value in numpy.ravel(values)]).reshape(numpy.shape(values))


class EnsightBinary:
    def __init__(self, order):
        self.bytes, self.order = b"", order

    def words(self, text):
        self.bytes += text.encode().ljust(80)

    def whole(self, rows):
        self.bytes += numpy.asarray(rows).astype(self.order + "i4").tobytes()

    def reals(self, values):
        self.bytes += values.astype(self.order + "f4").tobytes()

    @staticmethod
    def rounded(values):
        return numpy.asarray(values).astype("f4").astype(float)


def ensight_file(out, form, first_line):
    if form != "text":
        out.words("C Binary")
    for text in first_line:
        out.words(text)
    return out


def ensight(folder, kind="hexahedra", form="text", steps=1, take=(0, 0), names=("temperature",), options=(), block="", **said):
    new = EnsightText if form == "text" else functools.partial(EnsightBinary, "<" if form == "little" else ">")
    rounded = EnsightText.rounded if form == "text" else EnsightBinary.rounded
    if block:
        whole = {"block": curvilinear, "block rectilinear": lambda: rectilinear(axes()), "block uniform": lambda: grid("offset")}[block]()
        whole.places = rounded(whole.places)
        points = whole.places.transpose(2, 1, 0, 3).reshape(-1, 3)
    else:
        points, blocks, judged, _ = mesh(kind)
        points = rounded(points)
    geometry = ensight_file(new(), form, ("A mesh of the bench", "second line", "node id assign", "element id assign", "part"))
    geometry.whole([1])
    geometry.words("all of it")
    if block:
        geometry.words(block)
        geometry.whole([list(SIZE)] if form == "text" else SIZE)
        if block == "block":
            for column in points.T:
                geometry.reals(column)
        elif block == "block rectilinear":
            for axis in range(3):
                geometry.reals(numpy.moveaxis(whole.places[..., axis], axis, 0)[:, 0, 0])
        else:
            geometry.reals(whole.origin)
            geometry.reals(whole.spacing)
    else:
        geometry.words("coordinates")
        geometry.whole([len(points)])
        for column in points.T:
            geometry.reals(column)
        for name, cells in blocks:
            geometry.words(ENSIGHT[name])
            geometry.whole([len(cells)])
            geometry.whole(cells + 1)
    (folder / "mesh.geo").write_bytes(geometry.bytes)
    case = ["FORMAT", "type: ensight gold", "GEOMETRY", "model: mesh.geo", "VARIABLE"]
    for number, name in enumerate(names):
        case.append(f"scalar per node: {'1 ' if steps > 1 else ''}{name} {name}{'***' if steps > 1 else ''}.scl")
        for step in range(steps):
            values = rounded(numbers(wave(points, number * 3 + step), "f8"))
            out = new()
            for text in (f"values of {name}", "part"):
                out.words(text)
            out.whole([1])
            out.words("block" if block else "coordinates")
            out.reals(values)
            (folder / (f"{name}{step:03d}.scl" if steps > 1 else f"{name}.scl")).write_bytes(out.bytes)
            if (number, step) == take:
                kept = values
    if steps > 1:
        case += ["TIME", "time set: 1", f"number of steps: {steps}", "filename start number: 0", "filename increment: 1",
                 "time values: " + " ".join(str(step / 2) for step in range(steps))]
    (folder / "result.case").write_text("\n".join(case) + "\n")
    if block:
        whole.values = kept.reshape(SIZE[::-1]).transpose(2, 1, 0)
        return of_grid(folder / "result.case", whole, options, **said, place_slack=1e-6)
    return of_cells(folder / "result.case", points, kept, judged, options, **said)


for kind in ("tetrahedra", "hexahedra", "wedges", "pyramids", "mixed", "quadratic tetrahedra"):
    add("EnSight Gold", "cells", kind, ensight, kind=kind)
for form in ("little", "big"):
    add("EnSight Gold", "storage", f"binary, {form} endian", ensight, form=form)
for block in ("block", "block rectilinear", "block uniform"):
    add("EnSight Gold", "places", block, ensight, block=block)
add("EnSight Gold", "storage", "binary block", ensight, block="block", form="little")
add("EnSight Gold", "arrays", "the second of two", ensight, names=("temperature", "pressure"), take=(1, 0), options=("--array", "pressure"),
    taken={"array": "pressure"})
add("EnSight Gold", "steps", "the first of 3", ensight, steps=3, taken={"step": "1 of 3"}, guessed=("step",))
add("EnSight Gold", "steps", "the third of 3", ensight, steps=3, take=(0, 2), options=("--time", "3"), taken={"step": "3 of 3"})


# Tecplot in text, whose numbers are single unless DT says otherwise.

def lines_of(values, per_line=5):
    texts = [repr(float(value)) for value in numpy.ravel(values)]
    return "\n".join(" ".join(texts[at:at + per_line]) for at in range(0, len(texts), per_line)) + "\n"


def tecplot(folder, kind="ordered", packing="POINT", names=("T",), take=0, steps=1, location="", zones=1, double=False, options=(), **said):
    said.setdefault("place_slack", 0 if double else 1.2e-7)
    more = ", DT=(" + " ".join(["DOUBLE"] * (3 + len(names))) + ")" if double else ""
    text = 'TITLE = "bench"\nVARIABLES = "X", "Y", "Z", ' + ", ".join(f'"{name}"' for name in names) + "\n"
    kept = None
    if kind == "ordered":
        whole = curvilinear("f8")
        for step in range(steps):
            arrays = [numbers(wave(whole.places, number * 3 + step), "f8") for number in range(len(names))]
            for part in ([slice(None)] if zones == 1 else [slice(0, 4), slice(3, None)]):
                columns = [whole.places[:, :, part, axis].transpose(2, 1, 0).ravel() for axis in range(3)] \
                    + [values[:, :, part].transpose(2, 1, 0).ravel() for values in arrays]
                depth = whole.values[:, :, part].shape[2]
                text += f'ZONE T="z", I={SIZE[0]}, J={SIZE[1]}, K={depth}, DATAPACKING={packing}{more}'
                text += f", STRANDID=1, SOLUTIONTIME={step / 2}\n" if steps > 1 else "\n"
                text += lines_of(numpy.stack(columns, axis=1), len(columns)) if packing == "POINT" else "".join(map(lines_of, columns))
            if step == take // 10:
                kept = arrays[take % 10]
        whole.values = kept
        case = of_grid(folder / "flow.tec", whole, options, **said)
    else:
        points, blocks, judged, _ = mesh(kind)
        cells = blocks[0][1]
        shape = {"tetrahedra": "FETETRAHEDRON", "hexahedra": "FEBRICK"}[kind]
        place = points[cells].mean(axis=1) if location else points
        for step in range(steps):
            arrays = [numbers(wave(place, number * 3 + step), "f8") for number in range(len(names))]
            text += f"ZONE N={len(points)}, E={len(cells)}, ZONETYPE={shape}, DATAPACKING={packing}{location}{more}"
            text += f", STRANDID=1, SOLUTIONTIME={step / 2}\n" if steps > 1 else "\n"
            text += lines_of(numpy.column_stack([points, *arrays]), 3 + len(arrays)) if packing == "POINT" else "".join(map(lines_of, [*points.T, *arrays]))
            text += "\n".join(" ".join(str(number + 1) for number in cell) for cell in cells.tolist()) + "\n"
            if step == take // 10:
                kept = arrays[take % 10]
        if location:
            kept = values_at_points(len(points), [cells], kept)
        case = of_cells(folder / "flow.tec", points, kept, judged, options, value_slack=3e-7 if location else 0, **said)
    (folder / "flow.tec").write_text(text)
    return case


for packing in ("POINT", "BLOCK"):
    for kind in ("ordered", "tetrahedra", "hexahedra"):
        add("Tecplot", "cells", f"{kind}, {packing}", tecplot, kind=kind, packing=packing)
add("Tecplot", "arrays", "values of cells", tecplot, kind="hexahedra", packing="BLOCK", location=", VARLOCATION=([4]=CELLCENTERED)")
add("Tecplot", "arrays", "values of cells, blanks", tecplot, kind="tetrahedra", packing="BLOCK", location=", VARLOCATION = ([4] = CELLCENTERED)")
add("Tecplot", "arrays", "the second of two", tecplot, names=("T", "P"), take=1, options=("--array", "P"), taken={"array": "P"})
for kind in ("ordered", "hexahedra"):
    add("Tecplot", "numbers", f"double, {kind}", tecplot, kind=kind, double=True)
add("Tecplot", "places", "two zones that meet", tecplot, zones=2)
for kind in ("ordered", "tetrahedra"):
    add("Tecplot", "steps", f"a zone a time, {kind}, the first of 3", tecplot, kind=kind, steps=3, taken={"step": "1 of 3"}, guessed=("step",))
    add("Tecplot", "steps", f"a zone a time, {kind}, the third of 3", tecplot, kind=kind, steps=3, take=20, options=("--time", "3"), taken={"step": "3 of 3"})


# PLOT3D: a grid and a solution, by records of Fortran or without, in text, of any byte order and precision; several grids; blanked points.

def plot3d_bytes(parts, records, form):
    """parts: arrays; each a record."""
    if form == "text":
        return "".join("".join(repr(number) + "\n" for number in numpy.ravel(part).tolist()) for part in parts).encode()
    order = form[0]
    out = b""
    for part in parts:
        data = numpy.ravel(part).astype(order + numpy.asarray(part).dtype.str[1:]).tobytes()
        length = numpy.array([len(data)], order + "i4").tobytes() if records else b""
        out += length + data + length
    return out


def plot3d(folder, form="<f4", records=False, grids=1, opened=1, blank=False, joined=False, scalar="density", whole=None, options=()):
    real = form if form != "text" else "<f8"
    wholes = [(whole or curvilinear)(real) if not number else curvilinear(real, shift=(0, 0, 9.0 * number)) for number in range(grids)]
    size_part = ([numpy.array([grids], "i4")] if grids > 1 else []) + [numpy.array([SIZE] * grids, "i4")]
    grid_parts, solution_parts = list(size_part), list(size_part)
    for number, one in enumerate(wholes):
        one.places = one.places.astype(real).astype(float)
        one.values = numbers(wave(one.places, number), real)
        holes = numpy.zeros(SIZE, bool)
        if blank:
            holes = some_holes()
        columns = [one.places[..., axis].transpose(2, 1, 0).ravel().astype(real) for axis in range(3)]
        marks = [numpy.where(holes, 0, 1).transpose(2, 1, 0).ravel().astype("i4")] if blank else []
        whole_record = numpy.concatenate(columns) if not blank else None
        if records and blank:  # one record: reals, then whole numbers
            raw = b"".join(part.astype(form[0] + part.dtype.str[1:]).tobytes() for part in columns + marks)
            grid_parts.append(numpy.frombuffer(raw, "u1"))
        elif records:
            grid_parts.append(whole_record)
        else:
            grid_parts += columns + marks
        solution_parts.append(numpy.array([0.5, 1, 2, 3], real))
        q = [one.fastest_first().ravel()] + [numbers(wave(one.places, 5 + n), real).transpose(2, 1, 0).ravel() for n in range(4)]
        solution_parts += [numpy.concatenate(q)]
    (folder / "fin.xyz").write_bytes(plot3d_bytes(grid_parts, records, form))
    (folder / "fin.q").write_bytes(plot3d_bytes(solution_parts, records, form))
    chosen = wholes[opened - 1]
    if scalar == "pressure":
        rho, mx, my, mz, energy = (numbers(wave(chosen.places, n), real).astype(float) for n in (opened - 1, 5, 6, 7, 8))
        chosen.values = 0.4 * (energy - (mx ** 2 + my ** 2 + mz ** 2) / (2 * rho))
    return of_grid(folder / "fin.xyz", chosen, (*options, *(("--grid", str(opened)) if grids > 1 else ())), holes if blank else None)


for form in ("<f4", ">f4", "<f8", ">f8"):
    for records in (False, True):
        add("PLOT3D", "storage", f"{form}{', records' if records else ''}", plot3d, form=form, records=records, quick=form == ">f8" and records)
add("PLOT3D", "storage", "text", plot3d, form="text")
add("PLOT3D", "places", "oblique grid", plot3d, form="<f8", whole=functools.partial(grid, "oblique"))
add("PLOT3D", "places", "uneven axes", plot3d, form="<f8", whole=lambda real: rectilinear(axes(), real))
add("PLOT3D", "series", "the second of two grids", plot3d, form="<f8", grids=2, opened=2)
add("PLOT3D", "holes", "iblank", plot3d, blank=True)
add("PLOT3D", "holes", "iblank, records, big endian", plot3d, blank=True, records=True, form=">f4")


# OpenFOAM: faces, and the cells at both sides of each; values of cells.

FOAM_HEAD = "FoamFile\n{{\n    version 2.0;\n    format {format};\n    class {kind};\n    location \"{place}\";\n    object {name};\n}}\n"
FACES = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))


def faces_of(hexahedra):
    """Inner faces, sorted by the cell that owns them, then those of the boundary: (points, owner, neighbour)."""
    seen = {}
    for cell, corners in enumerate(hexahedra.tolist()):
        for face in FACES:
            points = [corners[corner] for corner in face]
            key = tuple(sorted(points))
            if key in seen:
                seen[key][2] = cell
            else:
                seen[key] = [points, cell, -1]
    every = list(seen.values())
    inner = sorted((face for face in every if face[2] >= 0), key=lambda face: (face[1], face[2]))
    return inner, [face for face in every if face[2] < 0]


def foam_file(path, kind, body, packed=False, format="ascii"):
    path.parent.mkdir(parents=True, exist_ok=True)
    data = FOAM_HEAD.format(format=format, kind=kind, place=path.parent.name, name=path.name).encode() + body
    if packed:
        path.with_name(path.name + ".gz").write_bytes(gzip.compress(data))
    else:
        path.write_bytes(data)


def foam_list(values, binary=False, vector=False):
    values = numpy.asarray(values)
    if binary:
        return f"{len(values)}\n(".encode() + values.astype("<f8" if values.dtype.kind == "f" else "<i4").tobytes() + b")\n"
    rows = ["(" + " ".join(map(repr, row)) + ")" for row in values.tolist()] if vector else [repr(value) for value in values.tolist()]
    return (f"{len(values)}\n(\n" + "\n".join(rows) + "\n)\n").encode()


def foam_case(folder, points, hexahedra, fields, binary=False, packed=False):
    """fields: time -> name -> values of cells."""
    inner, outer = faces_of(hexahedra)
    faces = inner + outer
    form = "binary" if binary else "ascii"
    place = folder / "constant/polyMesh"
    foam_file(place / "points", "vectorField", foam_list(points, binary, True), packed, form)
    face_lines = f"{len(faces)}\n(\n" + "\n".join("4(" + " ".join(map(str, face[0])) + ")" for face in faces) + "\n)\n"
    if binary:  # a list of lists: where each begins, then all
        starts, flat = numpy.arange(0, 4 * len(faces) + 1, 4), numpy.concatenate([face[0] for face in faces])
        foam_file(place / "faces", "faceCompactList", foam_list(starts, True) + foam_list(flat, True), packed, form)
    else:
        foam_file(place / "faces", "faceList", face_lines.encode(), packed, form)
    foam_file(place / "owner", "labelList", foam_list([face[1] for face in faces], binary), packed, form)
    foam_file(place / "neighbour", "labelList", foam_list([face[2] for face in inner], binary), packed, form)
    foam_file(place / "boundary", "polyBoundaryMesh",
              f"1\n(\n    walls\n    {{\n        type wall;\n        nFaces {len(outer)};\n        startFace {len(inner)};\n    }}\n)\n".encode())
    for time, arrays in fields.items():
        for name, values in arrays.items():
            body = b"dimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar> " + foam_list(values, binary) \
                + b";\nboundaryField\n{\n    walls\n    {\n        type zeroGradient;\n    }\n}\n"
            foam_file(folder / time / name, "volScalarField", body, packed, form)


CONTROL = b"application icoFoam;\nstartFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime 2;\ndeltaT 1;\nwriteControl timeStep;\nwriteInterval 1;\n"


def openfoam(folder, opened="case.foam", content=b"", binary=False, packed=False, parts=1, names=("T",), take=("T", 0), options=(), **said):
    points, hexahedra = boxes()
    centres = points[hexahedra].mean(axis=1)
    times = ("0", "0.5", "2")
    fields = {time: {name: numbers(wave(centres, number * 3 + step), "f8") for number, name in enumerate(names)} for step, time in enumerate(times)}
    foam_file(folder / "system/controlDict", "dictionary", CONTROL)
    if parts == 1:
        foam_case(folder, points, hexahedra, fields, binary, packed)
    else:
        for part, cells in enumerate(numpy.array_split(numpy.arange(len(hexahedra)), parts)):
            used, renumbered = numpy.unique(hexahedra[cells], return_inverse=True)
            foam_case(folder / f"processor{part}", points[used], renumbered.reshape(-1, 8),
                      {time: {name: values[cells] for name, values in arrays.items()} for time, arrays in fields.items()}, binary, packed)
    if opened.endswith(".foam"):
        (folder / opened).write_bytes(content)
    values = values_at_points(len(points), [hexahedra], fields[times[take[1]]][take[0]])
    return of_cells(folder / opened, points, values, [hexahedra], options, value_slack=3e-7, **said)


add("OpenFOAM", "storage", "an empty .foam", openfoam)
add("OpenFOAM", "storage", "controlDict", openfoam, opened="system/controlDict")
add("OpenFOAM", "storage", "binary", openfoam, binary=True)
add("OpenFOAM", "storage", "packed by gzip", openfoam, packed=True)
add("OpenFOAM", "storage", "two processors", openfoam, parts=2)
add("OpenFOAM", "steps", "the first of 3", openfoam, taken={"step": "1 of 3"}, guessed=("step",))
add("OpenFOAM", "steps", "the third of 3", openfoam, take=("T", 2), options=("--time", "3"), taken={"step": "3 of 3"})
add("OpenFOAM", "arrays", "the second of two", openfoam, names=("T", "p"), take=("p", 0), options=("--array", "p"), taken={"array": "^p"})


# Fluent: nodes, faces with the cells at both sides, and values of cells beside them.

def fluent(folder):
    points, hexahedra = boxes()
    inner, outer = faces_of(hexahedra)
    # The order of a face's points turns its normal to the first cell.
    text = f'(0 "bench")\n(2 3)\n(10 (0 1 {len(points):x} 0 3))\n(10 (1 1 {len(points):x} 1 3)(\n'
    text += "\n".join(" ".join(repr(number) for number in point) for point in points.tolist()) + "\n))\n"
    text += f"(12 (0 1 {len(hexahedra):x} 0))\n(12 (2 1 {len(hexahedra):x} 1 4))\n(13 (0 1 {len(inner) + len(outer):x} 0))\n"
    first = 1
    for zone, kind, faces in ((3, 2, inner), (4, 3, outer)):
        text += f"(13 ({zone:x} {first:x} {first + len(faces) - 1:x} {kind} 4)(\n"
        text += "\n".join(" ".join(f"{number + 1:x}" for number in points_of[::-1]) + f" {one + 1:x} {other + 1:x}" for points_of, one, other in faces) + "\n))\n"
        first += len(faces)
    text += "(45 (2 fluid fluid)())\n(45 (3 interior interior)())\n(45 (4 wall wall)())\n"
    (folder / "flow.cas").write_text(text)
    values = numbers(wave(points[hexahedra].mean(axis=1)), "f8")
    data = '(0 "bench")\n' + f"(300 (3 2 1 0 0 1 {len(hexahedra)})(\n" + "\n".join(repr(value) for value in values.tolist()) + "\n))\n"
    (folder / "flow.dat").write_text(data)
    return of_cells(folder / "flow.cas", points, values_at_points(len(points), [hexahedra], values), [hexahedra], value_slack=3e-7)


add("Fluent", "cells", "hexahedra", fluent)


# GAMBIT: a mesh whose cells have the number of their material, and no other value.

def gambit(folder, kind):
    points, blocks, judged, _ = mesh(kind)
    cells = blocks[0][1]
    number, order = {"tetrahedra": (6, [0, 1, 2, 3])}[kind]
    groups = [numpy.arange(len(cells))[:33], numpy.arange(len(cells))[33:]]
    text = "        CONTROL INFO 2.4.6\n** GAMBIT NEUTRAL FILE\nbench\nPROGRAM:                Gambit     VERSION:  2.4.6\n 1 Jan 2026\n"
    text += "     NUMNP     NELEM     NGRPS    NBSETS     NDFCD     NDFVL\n"
    text += "".join(f"{n:10d}" for n in (len(points), len(cells), len(groups), 0, 3, 3)) + "\nENDOFSECTION\n   NODAL COORDINATES 2.4.6\n"
    text += "".join(f"{n:10d}{x:20.11e}{y:20.11e}{z:20.11e}\n" for n, (x, y, z) in enumerate(points.tolist(), 1)) + "ENDOFSECTION\n      ELEMENTS/CELLS 2.4.6\n"
    for n, cell in enumerate(cells.tolist(), 1):
        corners = [f"{cell[at] + 1:8d}" for at in order]
        text += f"{n:8d} {number:2d} {len(order):2d} " + "".join(corners[:7]) + "\n" + (" " * 15 + "".join(corners[7:]) + "\n" if len(corners) > 7 else "")
    text += "ENDOFSECTION\n"
    values = numpy.empty(len(cells))
    for n, group in enumerate(groups, 1):
        text += f"       ELEMENT GROUP 2.4.6\nGROUP: {n:10d} ELEMENTS: {len(group):10d} MATERIAL: {n + 1:10d} NFLAGS: {1:10d}\n{'part' + str(n):>32}\n       0\n"
        text += "".join("".join(f"{cell + 1:8d}" for cell in group[at:at + 10]) + "\n" for at in range(0, len(group), 10)) + "ENDOFSECTION\n"
        values[group] = n + 1
    (folder / "mesh.neu").write_text(text)
    points = numpy.array([[float(f"{number:20.11e}") for number in point] for point in points])
    return of_cells(folder / "mesh.neu", points, values_at_points(len(points), [cells], values), judged, value_slack=3e-7)


add("GAMBIT", "cells", "tetrahedra", gambit, kind="tetrahedra")
