# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's formats by VTK's own writers, and its HDF files by h5py."""
import functools

import numpy

from bench import add, of_cells, of_grid, of_points
from mesh_samples import CELLS, MESH, lagrange, mesh, values_at_points
from samples import FRAMES, SIZE, axes, curvilinear, grid, library, numbers, rectilinear, some_holes, wave

h5py = library("h5py")
vtk_data = library("vtkmodules.vtkCommonDataModel", "vtk9")
vtk_core = library("vtkmodules.vtkCommonCore", "vtk9")
vtk_numpy = library("vtkmodules.util.numpy_support", "vtk9")
vtk_xml = library("vtkmodules.vtkIOXML", "vtk9")
vtk_parallel = library("vtkmodules.vtkIOParallelXML", "vtk9")
vtk_legacy = library("vtkmodules.vtkIOLegacy", "vtk9")

TYPES = ("u1", "i1", "u2", "i2", "u4", "i4", "i8", "u8", "f4", "f8")


def vtk_array(values, name):
    array = vtk_numpy.numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    return array


def image(whole, first=(0, 0, 0)):
    """`first`: the number of the first sample along each axis; the origin is where number 0 would be."""
    data = vtk_data.vtkImageData()
    data.SetExtent(*(end for start, size in zip(first, whole.values.shape) for end in (start, start + size - 1)))
    data.SetSpacing(*whole.spacing)
    data.SetOrigin(*(whole.origin - whole.steps @ numpy.array(first)))
    data.SetDirectionMatrix(*whole.directions.ravel())
    return data


def rectilinear_grid(whole):
    data = vtk_data.vtkRectilinearGrid()
    data.SetDimensions(*whole.values.shape)
    for axis, give in enumerate((data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates)):
        give(vtk_array(numpy.moveaxis(whole.places[..., axis], axis, 0)[:, 0, 0], "XYZ"[axis]))
    return data


def vtk_points(places):
    points = vtk_core.vtkPoints()
    points.SetData(vtk_numpy.numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    return points


def structured(whole):
    data = vtk_data.vtkStructuredGrid()
    data.SetDimensions(*whole.values.shape)
    data.SetPoints(vtk_points(whole.places.transpose(2, 1, 0, 3).reshape(-1, 3)))
    return data


def unstructured(points, blocks):
    """Of cells of several kinds: (number of the kind, corners of each)."""
    data = vtk_data.vtkUnstructuredGrid()
    data.SetPoints(vtk_points(points))
    data.Allocate(sum(len(cells) for _, cells in blocks))
    for kind, cells in blocks:
        for cell in cells.tolist():
            data.InsertNextCell(kind, len(cell), cell)
    return data


def point_cloud(whole):
    data = vtk_data.vtkPolyData()
    data.SetPoints(vtk_points(whole.places.reshape(-1, 3)))
    vertices = vtk_data.vtkCellArray()
    for number in range(whole.values.size):
        vertices.InsertNextCell(1, [number])
    data.SetVerts(vertices)
    return data


XML = {"vti": ("ImageData", image), "vtr": ("RectilinearGrid", rectilinear_grid), "vts": ("StructuredGrid", structured), "vtu": ("UnstructuredGrid", None),
       "vtp": ("PolyData", None)}


def save_xml(data, file, storage="appended raw", pieces=0):
    """`storage` has the words: ascii, binary, appended, raw, base64; zlib, lz4, lzma; big; UInt64."""
    ending = file.suffix[1:].lstrip("p") if file.suffix != ".pvtp" else "vtp"
    name = XML["vtp" if file.suffix in (".vtp", ".pvtp") else ending][0]
    writer = getattr(vtk_parallel, f"vtkXMLP{name}Writer")() if pieces else getattr(vtk_xml, f"vtkXML{name}Writer")()
    words = storage.split()
    {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary, "appended": writer.SetDataModeToAppended}[words[0]]()
    writer.SetEncodeAppendedData("base64" in words)
    {"zlib": writer.SetCompressorTypeToZLib, "lz4": writer.SetCompressorTypeToLZ4, "lzma": writer.SetCompressorTypeToLZMA}.get(
        next((word for word in words if word in ("zlib", "lz4", "lzma")), ""), writer.SetCompressorTypeToNone)()
    if "big" in words:
        writer.SetByteOrderToBigEndian()
    if "UInt64" in words:
        writer.SetHeaderTypeToUInt64()
    if pieces:
        writer.SetNumberOfPieces(pieces)
        writer.SetStartPiece(0)
        writer.SetEndPiece(pieces - 1)
    writer.SetInputData(data)
    writer.SetFileName(str(file))
    if not writer.Write():
        raise RuntimeError(f"VTK cannot write {file}")


def save_legacy(data, file, binary, version=51):
    writer = vtk_legacy.vtkGenericDataObjectWriter()
    writer.SetFileName(str(file))
    writer.SetFileVersion(version)
    writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
    writer.SetInputData(data)
    if not writer.Write():
        raise RuntimeError(f"VTK cannot write {file}")


def save(data, file, storage, pieces=0):
    if file.suffix == ".vtk":
        save_legacy(data, file, "binary" in storage, 42 if "42" in storage else 51)
    else:
        save_xml(data, file, storage, pieces)


def samples_of(whole, names):
    """Arrays of the names, each a wave of its own, in the order of VTK."""
    return {name: numbers(wave(whole.places, number), whole.values.dtype) for number, name in enumerate(names)}


def structured_file(folder, ending, whole, make, storage="appended raw", names=("density",), take=0, active="", holes=None, pieces=0, options=(), first=None,
                    **said):
    """Of any kind of grid."""
    whole = whole()
    data = make(whole, first) if first else make(whole)
    arrays = samples_of(whole, names)
    for name, values in arrays.items():
        data.GetPointData().AddArray(vtk_array(values.transpose(2, 1, 0).ravel(), name))
    if active:
        data.GetPointData().SetActiveScalars(active)
    if holes == "blanked":
        ghosts = numpy.where(some_holes().transpose(2, 1, 0).ravel(), vtk_data.vtkDataSetAttributes.HIDDENPOINT, 0).astype("u1")
        data.GetPointData().AddArray(vtk_array(ghosts, "vtkGhostType"))
    file = folder / f"grid.{ending}"
    save(data, file, storage, pieces)
    whole.values = arrays[names[take]]
    said.setdefault("name", names[take])
    return of_grid(file, whole, options, some_holes() if holes else None, **said)


def of_cells_of_grid(folder, ending, storage):
    """Values of cells: each sample is the mean of the cells around it."""
    whole = grid("oblique")
    data = image(whole)
    centres = (whole.places[:-1, :-1, :-1] + whole.places[1:, 1:, 1:]) / 2
    values = numbers(wave(centres), "f8")
    data.GetCellData().SetScalars(vtk_array(values.transpose(2, 1, 0).ravel(), "density"))
    save(data, folder / f"grid.{ending}", storage)
    total, count = numpy.zeros(SIZE), numpy.zeros(SIZE)
    for at in numpy.ndindex(2, 2, 2):
        part = tuple(slice(n, n + size - 1) for n, size in zip(at, SIZE))
        total[part] += values
        count[part] += 1
    whole.values = total / count
    return of_grid(folder / f"grid.{ending}", whole, value_slack=3e-7)


def vectors(folder, ending, storage, component):
    whole = grid("offset", "f8")
    three = numpy.stack([numbers(wave(whole.places, number), "f8") for number in range(3)], axis=-1)
    data = image(whole)
    data.GetPointData().AddArray(vtk_array(three.transpose(2, 1, 0, 3).reshape(-1, 3), "velocity"))
    save(data, folder / f"grid.{ending}", storage)
    whole.values = numpy.linalg.norm(three, axis=-1) if component == "magnitude" else three[..., component]
    return of_grid(folder / f"grid.{ending}", whole, ("--component", str(component)), value_slack=2e-7,
                   taken={"array": "velocity", "component": str(component)})


def cloud(folder, ending, storage):
    whole = curvilinear("f8")
    data = point_cloud(whole)
    data.GetPointData().SetScalars(vtk_array(whole.values.ravel(), "density"))
    save(data, folder / f"points.{ending}", storage, 2 if ending == "pvtp" else 0)
    return of_points(folder / f"points.{ending}", whole.places.reshape(-1, 3), whole.values.ravel())


def mesh_file(folder, kind, ending="vtu", storage="appended raw", dtype="f8", of="points", names=("temperature",), take=0, options=(), pieces=0, order=1,
              **said):
    points, blocks, judged, unused = mesh(kind)
    if order:
        blocks = [(CELLS[name][0], cells) for name, cells in blocks]
    data = unstructured(points, blocks)
    count = len(points) if of == "points" else sum(len(cells) for _, cells in blocks)
    places = points if of == "points" else numpy.concatenate([points[cells].mean(axis=1) for _, cells in blocks])
    arrays = [numbers(wave(places, number), dtype) for number in range(len(names))]
    attributes = data.GetPointData() if of == "points" else data.GetCellData()
    for name, values in zip(names, arrays):
        attributes.AddArray(vtk_array(values[:count], name))
    save(data, folder / f"mesh.{ending}", storage, pieces)
    values = arrays[take] if of == "points" else values_at_points(len(points), [cells for _, cells in blocks], arrays[take])
    return of_cells(folder / f"mesh.{ending}", points, values, judged, options, value_slack=0 if of == "points" else 3e-7, **said)


def lagrange_file(folder, kind, order):
    points, number, cells, judged = lagrange(kind, order)
    data = unstructured(points, [(number, cells)])
    values = numbers(wave(points), "f8")
    data.GetPointData().SetScalars(vtk_array(values, "temperature"))
    save(data, folder / "mesh.vtu", "binary")
    return of_cells(folder / "mesh.vtu", points, values, judged)


def polyhedra(folder, ending="vtu", storage="ascii"):
    """Hexahedra as polyhedra: six faces of four points each."""
    points, blocks, judged, _ = mesh("hexahedra")
    faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    data = vtk_data.vtkUnstructuredGrid()
    data.SetPoints(vtk_points(points))
    for cell in blocks[0][1].tolist():
        stream = vtk_core.vtkIdList()
        for number in [6] + [number for face in faces for number in [4, *(cell[corner] for corner in face)]]:
            stream.InsertNextId(number)
        data.InsertNextCell(vtk_data.VTK_POLYHEDRON, stream)
    values = numbers(wave(points), "f8")
    data.GetPointData().SetScalars(vtk_array(values, "temperature"))
    save(data, folder / f"mesh.{ending}", storage)
    return of_cells(folder / f"mesh.{ending}", points, values, judged)


def blocks_of(folder, kind):
    """A .vtm of two halves that share a layer: of meshes, or of grids."""
    multiblock = vtk_data.vtkMultiBlockDataSet()
    if kind == "grids":
        whole = curvilinear("f8")
        halves = [curvilinear("f8"), curvilinear("f8")]
        for half, part in zip(halves, (slice(0, 4), slice(3, None))):
            half.places, half.values = whole.places[:, :, part], whole.values[:, :, part]
        data = [structured(half) for half in halves]
        values = [half.values.transpose(2, 1, 0).ravel() for half in halves]
        case = of_grid(folder / "all.vtm", whole)
    else:
        points, blocks, judged, _ = mesh("hexahedra")
        cells, every = blocks[0][1], numbers(wave(points), "f8")
        data, values = [], []
        for part in (cells[:len(cells) // 2], cells[len(cells) // 2:]):
            used, renumbered = numpy.unique(part, return_inverse=True)
            data.append(unstructured(points[used], [(12, renumbered.reshape(part.shape))]))
            values.append(every[used])
        case = of_cells(folder / "all.vtm", points, every, judged)
    for number, (part, of) in enumerate(zip(data, values)):
        part.GetPointData().SetScalars(vtk_array(of, "density"))
        multiblock.SetBlock(number, part)
    writer = vtk_xml.vtkXMLMultiBlockDataWriter()
    writer.SetFileName(str(folder / "all.vtm"))
    writer.SetInputData(multiblock)
    writer.Write()
    return case


def collection(folder, form, take, options):
    """Three steps in files of their own."""
    whole = grid("oblique", "f8")
    for step in range(3):
        values = numbers(wave(whole.places, step), "f8")
        data = image(whole)
        data.GetPointData().SetScalars(vtk_array(values.transpose(2, 1, 0).ravel(), "density"))
        save_xml(data, folder / f"step{step}.vti")
        if step == take:
            kept = values
    whole.values = kept
    if form == "pvd":
        lines = "".join(f'<DataSet timestep="{step / 2}" group="" part="0" file="step{step}.vti"/>\n' for step in range(3))
        (folder / "all.pvd").write_text(f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n{lines}</Collection>\n</VTKFile>\n')
        file = folder / "all.pvd"
    else:
        file = folder / "all.vti.series"
        file.write_text('{"file-series-version": "1.0", "files": [' + ", ".join(f'{{"name": "step{step}.vti", "time": {step / 2}}}' for step in range(3)) + "]}")
    return of_grid(file, whole, options, taken={"step": f"{take + 1} of 3"}, guessed=() if options else ("step",))


def hdf(folder, kind, dtype="f8", frame="oblique"):
    """VTKHDF, version 1."""
    with h5py.File(folder / "data.vtkhdf", "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = numpy.array([1, 0], "i8")
        text = b"ImageData" if kind == "image" else b"UnstructuredGrid"
        root.attrs.create("Type", text, dtype=h5py.string_dtype("ascii", len(text)))
        if kind == "image":
            whole = grid(frame, dtype)
            root.attrs["WholeExtent"] = numpy.array([0, SIZE[0] - 1, 0, SIZE[1] - 1, 0, SIZE[2] - 1], "i8")
            root.attrs["Origin"], root.attrs["Spacing"], root.attrs["Direction"] = whole.origin, whole.spacing, whole.directions.ravel()
            root.create_dataset("PointData/density", data=whole.fastest_first())
            return of_grid(folder / "data.vtkhdf", whole)
        points, blocks, judged, _ = mesh("hexahedra")
        cells, values = blocks[0][1], numbers(wave(points), dtype)
        for name, number in (("NumberOfPoints", len(points)), ("NumberOfCells", len(cells)), ("NumberOfConnectivityIds", cells.size)):
            root[name] = numpy.array([number], "i8")
        root["Points"], root["Connectivity"] = points, cells.ravel().astype("i8")
        root["Offsets"], root["Types"] = numpy.arange(0, cells.size + 1, 8, dtype="i8"), numpy.full(len(cells), 12, "u1")
        root.create_dataset("PointData/density", data=values)
        return of_cells(folder / "data.vtkhdf", points, values, judged)


GRIDS = {"vti": ("VTK image (.vti)", lambda dtype="f8": grid("offset", dtype), image),
         "vtr": ("VTK rectilinear (.vtr)", lambda dtype="f8": rectilinear(axes(), dtype), rectilinear_grid),
         "vts": ("VTK structured (.vts)", lambda dtype="f8": curvilinear(dtype), structured)}

for name in FRAMES:
    add(GRIDS["vti"][0], "places", name, structured_file, ending="vti", whole=functools.partial(grid, name, "f8"), make=image, quick=name == "sheared")
add(GRIDS["vti"][0], "places", "numbers that do not begin at 0", structured_file, ending="vti", whole=functools.partial(grid, "oblique", "f8"), make=image,
    first=(3, -2, 10))
add(GRIDS["vtr"][0], "places", "axes that fall", structured_file, ending="vtr", make=rectilinear_grid,
    whole=lambda: rectilinear([axis[::-1] for axis in axes()], "f8"))
add(GRIDS["vts"][0], "places", "mirrored", structured_file, ending="vts", make=structured, whole=functools.partial(grid, "oblique, mirrored", "f8"))
add(GRIDS["vts"][0], "places", "single precision", structured_file, ending="vts", make=structured, whole=lambda: curvilinear("f8", precision="f4"))
add(GRIDS["vts"][0], "places", "far away", structured_file, ending="vts", make=structured, whole=lambda: curvilinear("f8", shift=(4e5, 5e6, 0)))
for ending, (format, whole, make) in GRIDS.items():
    for dtype in TYPES if ending == "vti" else ("u1", "i4", "f4"):
        add(format, "numbers", dtype, structured_file, ending=ending, whole=functools.partial(whole, dtype), make=make)
    for storage in ("ascii", "binary", "binary zlib", "appended raw lz4", "appended base64", "appended raw big", "binary lzma UInt64")[:None if ending == "vti" else 3]:
        add(format, "storage", storage, structured_file, ending=ending, whole=whole, make=make, storage=storage)
    add(format, "storage", f"pieces (.p{ending})", structured_file, ending=f"p{ending}", whole=whole, make=make, pieces=2)
    add(format, "holes", "blanked points", structured_file, ending=ending, whole=whole, make=make, holes="blanked")
    add(format, "arrays", "the first of two", structured_file, ending=ending, whole=whole, make=make, names=("density", "speed"),
        taken={"array": "density"}, guessed=("array",))
    add(format, "arrays", "the second of two", structured_file, ending=ending, whole=whole, make=make, names=("density", "speed"), take=1,
        options=("--array", "speed"), taken={"array": "speed"})
    add(format, "arrays", "the active one", structured_file, ending=ending, whole=whole, make=make, names=("density", "speed"), take=1, active="speed",
        taken={"array": "speed"})
for storage in ("ascii", "binary", "binary 42"):
    for ending, (_, whole, make) in GRIDS.items():
        label = {"vti": "structured points", "vtr": "rectilinear grid", "vts": "structured grid"}[ending]
        add("VTK legacy (.vtk)", "storage", f"{label}, {storage}", structured_file, ending="vtk", whole=whole, make=make, storage=storage)
for dtype in TYPES:
    add("VTK legacy (.vtk)", "numbers", dtype, structured_file, ending="vtk", whole=functools.partial(GRIDS["vti"][1], dtype), make=image, storage="binary")
add("VTK legacy (.vtk)", "arrays", "the second of two", structured_file, ending="vtk", whole=GRIDS["vtr"][1], make=rectilinear_grid, storage="ascii",
    names=("density", "speed"), take=1, options=("--array", "speed"), taken={"array": "speed"})
add(GRIDS["vti"][0], "arrays", "values of cells", of_cells_of_grid, ending="vti", storage="binary")
for component in (0, 2, "magnitude"):
    add(GRIDS["vti"][0], "arrays", f"component {component}", vectors, ending="vti", storage="binary", component=component)
for ending, storage in (("vtp", "binary"), ("vtp", "ascii"), ("pvtp", "binary"), ("vtk", "binary"), ("vtk", "ascii")):
    add("VTK points (.vtp, .vtk)", "storage", f".{ending}, {storage}", cloud, ending=ending, storage=storage)

UNSTRUCTURED = "VTK unstructured (.vtu)"
for kind in MESH:
    add(UNSTRUCTURED, "cells", kind, mesh_file, kind=kind, quick=kind == "mixed")
    add("VTK legacy (.vtk)", "cells", kind, mesh_file, kind=kind, ending="vtk", storage="binary")
for storage in ("ascii", "binary", "binary zlib", "appended base64", "appended raw zlib UInt64", "appended raw big", "binary lz4", "binary lzma"):
    add(UNSTRUCTURED, "storage", storage, mesh_file, kind="tetrahedra", storage=storage)
add(UNSTRUCTURED, "storage", "pieces (.pvtu)", mesh_file, kind="hexahedra", ending="pvtu", pieces=2)
for dtype in TYPES:
    add(UNSTRUCTURED, "numbers", dtype, mesh_file, kind="tetrahedra", dtype=dtype)
add(UNSTRUCTURED, "arrays", "values of cells", mesh_file, kind="mixed", of="cells")
add(UNSTRUCTURED, "arrays", "the second of two", mesh_file, kind="mixed", names=("temperature", "pressure"), take=1, options=("--array", "pressure"),
    taken={"array": "pressure"})
for kind in ("tetrahedron", "hexahedron"):
    for order in (1, 2):
        add(UNSTRUCTURED, "cells", f"Lagrange {kind} of order {order}", lagrange_file, kind=kind, order=order)
add(UNSTRUCTURED, "cells", "polyhedra", polyhedra)
add("VTK legacy (.vtk)", "cells", "polyhedra", polyhedra, ending="vtk", storage="binary")
for kind in ("meshes", "grids"):
    add("VTK blocks (.vtm)", "places", f"two {kind} that meet", blocks_of, kind=kind)
for form in ("pvd", "series"):
    add("VTK steps (.pvd, .series)", "steps", f"{form}, the first of 3", collection, form=form, take=0, options=())
    add("VTK steps (.pvd, .series)", "steps", f"{form}, the third of 3", collection, form=form, take=2, options=("--time", "3"))
for frame in ("offset", "oblique", "mirrored"):
    add("VTK HDF", "places", f"image, {frame}", hdf, kind="image", frame=frame)
for dtype in ("u1", "i2", "f4"):
    add("VTK HDF", "numbers", f"image, {dtype}", hdf, kind="image", dtype=dtype)
add("VTK HDF", "cells", "hexahedra", hdf, kind="mesh")
