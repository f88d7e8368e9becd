# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as meshio writes them: UCD, MED, and again Exodus, VTK and Tecplot. What meshio itself reads for TAn is written byte by byte besides:
Gmsh, XDMF, Medit, Nastran."""
import meshio
import numpy

from bench import add, of_cells
from mesh_samples import CELLS, mesh, values_at_points
from samples import library, numbers, wave

h5py = library("h5py")


def by_meshio(folder, ending, format, kind="tetrahedra", of="points", names=("temperature",), take=0, dtype="f8", options=(), round_trip=False, **words):
    said = {name: words.pop(name) for name in ("taken", "left_out", "value_slack", "place_slack") if name in words}
    points, blocks, judged, _ = mesh(kind)
    count = sum(len(cells) for _, cells in blocks)
    place = points if of == "points" else numpy.concatenate([points[cells].mean(axis=1) for _, cells in blocks])
    arrays = [numbers(wave(place, number), dtype) for number in range(len(names))]
    ends = numpy.cumsum([len(cells) for _, cells in blocks])[:-1]
    data = {name: values for name, values in zip(names, arrays)} if of == "points" else {name: numpy.split(values, ends) for name, values in zip(names, arrays)}
    whole = meshio.Mesh(points, [(CELLS[name][1], cells) for name, cells in blocks], **{"point_data" if of == "points" else "cell_data": data})
    file = folder / f"mesh{ending}"
    meshio.write(str(file), whole, file_format=format, **words)
    values = arrays[take].astype(float)
    if of != "points":
        values = values_at_points(len(points), [cells for _, cells in blocks], values)
    return of_cells(file, points, values, judged, options, **({"value_slack": 0 if of == "points" else 3e-7} | said))


def references(folder, ending, format, name, kind="tetrahedra"):
    """Formats that hold no other value than the number of a region, of each cell."""
    points, blocks, judged, _ = mesh(kind)
    cells = blocks[0][1]
    numbers_of = 1 + (numpy.arange(len(cells)) * 7 % 5)
    meshio.write(str(folder / f"mesh{ending}"), meshio.Mesh(points, [(CELLS[kind][1], cells)], cell_data={name: [numbers_of]}), file_format=format)
    return of_cells(folder / f"mesh{ending}", points, values_at_points(len(points), [cells], numbers_of.astype(float)), judged, value_slack=3e-7,
                    place_slack=1e-9)


# Gmsh, versions 2.2 and 4.1. Its quadratic cells have their edges in an order of its own.
GMSH = {"tetrahedra": (4, range(4)), "hexahedra": (5, range(8)), "wedges": (6, range(6)), "pyramids": (7, range(5)), "triangles": (2, range(3)),
        "lines": (1, range(2)), "quadratic tetrahedra": (11, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]),
        "quadratic hexahedra": (17, [*range(8), 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14])}


def gmsh(folder, version="2.2", kind="tetrahedra", of="points", names=("temperature",), take=0, binary=False, options=(), **said):
    points, blocks, judged, _ = mesh(kind)
    cells = [(GMSH[name][0], of_kind[:, list(GMSH[name][1])] + 1) for name, of_kind in blocks]
    count = sum(len(of_kind) for _, of_kind in cells)
    place = points if of == "points" else numpy.concatenate([points[of_kind].mean(axis=1) for _, of_kind in blocks])
    arrays = [numbers(wave(place, number), "f8") for number in range(len(names))]
    rows = lambda table: "".join(" ".join(map(repr, row)) + "\n" for row in numpy.asarray(table).tolist()).encode()
    out = f"$MeshFormat\n{version} {int(binary)} 8\n".encode() + (numpy.array([1], "<i4").tobytes() + b"\n" if binary else b"") + b"$EndMeshFormat\n"
    tags = numpy.arange(1, len(points) + 1)
    if version == "2.2":
        record = numpy.rec.fromarrays([tags.astype("<i4"), *points.T], dtype=[("tag", "<i4"), ("x", "<f8"), ("y", "<f8"), ("z", "<f8")])
        out += f"$Nodes\n{len(points)}\n".encode() + (record.tobytes() + b"\n" if binary else rows(record)) + b"$EndNodes\n"
        out += f"$Elements\n{count}\n".encode()
        first = 1
        for number, of_kind in cells:
            table = numpy.column_stack([numpy.arange(first, first + len(of_kind)), numpy.full((len(of_kind), 2), 1), of_kind])
            if binary:
                out += numpy.array([number, len(of_kind), 2], "<i4").tobytes() + table.astype("<i4").tobytes()
            else:
                out += rows(numpy.column_stack([table[:, :1], numpy.full((len(of_kind), 1), number), numpy.full((len(of_kind), 1), 2), table[:, 1:]]))
            first += len(of_kind)
        out += (b"\n" if binary else b"") + b"$EndElements\n"
    else:
        low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        out += b"$Entities\n0 0 0 1\n" + rows([[1, *low, *high]]).replace(b"1.0 ", b"1 ", 1).strip() + b" 0 0\n$EndEntities\n"
        out += f"$Nodes\n1 {len(points)} 1 {len(points)}\n3 1 0 {len(points)}\n".encode() + rows(tags[:, None]) + rows(points) + b"$EndNodes\n"
        out += f"$Elements\n{len(cells)} {count} 1 {count}\n".encode()
        first = 1
        for number, of_kind in cells:
            out += f"3 1 {number} {len(of_kind)}\n".encode() + rows(numpy.column_stack([numpy.arange(first, first + len(of_kind)), of_kind]))
            first += len(of_kind)
        out += b"$EndElements\n"
    section = "NodeData" if of == "points" else "ElementData"
    for name, values in zip(names, arrays):
        out += f'${section}\n1\n"{name}"\n1\n0.0\n3\n0\n1\n{len(values)}\n'.encode()
        if binary:
            record = numpy.rec.fromarrays([numpy.arange(1, len(values) + 1), values], dtype=[("tag", "<i4"), ("value", "<f8")])
            out += record.tobytes() + b"\n"
        else:
            out += b"".join(f"{tag} {value!r}\n".encode() for tag, value in enumerate(values.tolist(), 1))
        out += f"$End{section}\n".encode()
    (folder / "mesh.msh").write_bytes(out)
    values = arrays[take] if of == "points" else values_at_points(len(points), [of_kind for _, of_kind in blocks], arrays[take])
    return of_cells(folder / "mesh.msh", points, values, judged, options, name=names[take], value_slack=0 if of == "points" else 3e-7, **said)


XDMF = {"tetrahedra": "Tetrahedron", "hexahedra": "Hexahedron", "wedges": "Wedge", "pyramids": "Pyramid", "quadratic tetrahedra": "Tetrahedron_10",
        "quadratic hexahedra": "Hexahedron_20"}


def xdmf(folder, kind="tetrahedra", form="XML", of="points", steps=1, take=0, options=(), **said):
    """As solvers write it: items of numbers in the text or in an HDF5 file; steps are a collection in time."""
    points, blocks, judged, _ = mesh(kind)
    name, cells = blocks[0]
    place = points if of == "points" else points[cells].mean(axis=1)
    heavy = h5py.File(folder / "mesh.h5", "w") if form == "HDF" else None

    def item(path, values):
        kind_of = {"f": "Float", "i": "Int"}[values.dtype.kind]
        attributes = f'DataType="{kind_of}" Precision="8" Dimensions="{" ".join(map(str, values.shape))}"'
        if form == "HDF":
            if path not in heavy:
                heavy[path] = values
            return f'<DataItem {attributes} Format="HDF">mesh.h5:{path}</DataItem>'
        return f'<DataItem {attributes} Format="XML">{" ".join(map(repr, values.ravel().tolist()))}</DataItem>'

    grids = ""
    for step in range(steps):
        values = numbers(wave(place, step), "f8")
        kept = values if step == take else kept if step else None
        grids += f'<Grid Name="mesh" GridType="Uniform"><Time Value="{step / 2}"/>' if steps > 1 else '<Grid Name="mesh" GridType="Uniform">'
        grids += f'<Topology TopologyType="{XDMF[name]}" NumberOfElements="{len(cells)}">{item("/cells", cells)}</Topology>'
        grids += f'<Geometry GeometryType="XYZ">{item("/points", points)}</Geometry>'
        centre = "Node" if of == "points" else "Cell"
        grids += f'<Attribute Name="temperature" AttributeType="Scalar" Center="{centre}">{item(f"/temperature{step}", values)}</Attribute></Grid>\n'
    if steps > 1:
        grids = f'<Grid Name="series" GridType="Collection" CollectionType="Temporal">\n{grids}</Grid>\n'
    (folder / "mesh.xdmf").write_text(f'<?xml version="1.0"?>\n<Xdmf Version="3.0"><Domain>\n{grids}</Domain></Xdmf>\n')
    if heavy:
        heavy.close()
    if of != "points":
        kept = values_at_points(len(points), [cells], kept)
    return of_cells(folder / "mesh.xdmf", points, kept, judged, options, name="temperature", value_slack=0 if of == "points" else 3e-7, **said)


def xdmf_of_meshio(folder, take, options=(), **said):
    """Its steps: a mesh, and a collection of grids that point to it."""
    points, blocks, judged, _ = mesh("tetrahedra")
    fields = [numbers(wave(points, step), "f8") for step in range(3)]
    with meshio.xdmf.TimeSeriesWriter(str(folder / "mesh.xdmf"), data_format="XML") as out:
        out.write_points_cells(points, [("tetra", blocks[0][1])])
        for step, values in enumerate(fields):
            out.write_data(step / 2, point_data={"temperature": values})
    return of_cells(folder / "mesh.xdmf", points, fields[take], judged, options, name="temperature", taken={"step": f"{take + 1} of 3"}, **said)


def numbered_cells(kind):
    """Points, cells, and a number of a region of each cell."""
    points, blocks, judged, _ = mesh(kind)
    cells = blocks[0][1]
    regions = 1 + numpy.arange(len(cells)) * 7 % 5
    return points, cells, regions, judged, values_at_points(len(points), [cells], regions.astype(float))


def medit(folder, kind):
    points, cells, regions, judged, values = numbered_cells(kind)
    text = f"MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n{len(points)}\n" + "".join(f"{x!r} {y!r} {z!r} 0\n" for x, y, z in points.tolist())
    text += f"\n{kind.capitalize()}\n{len(cells)}\n" + "".join(" ".join(str(n + 1) for n in cell) + f" {region}\n" for cell, region in zip(cells.tolist(), regions))
    (folder / "mesh.mesh").write_text(text + "\nEnd\n")
    return of_cells(folder / "mesh.mesh", points, values, judged, value_slack=3e-7)


def nastran(folder, kind):
    """Fields of eight letters; the property of an element is its region."""
    points, cells, regions, judged, values = numbered_cells(kind)
    word = lambda number: f"{number:8.5f}"[:8]
    points = numpy.array([[float(word(number)) for number in point] for point in points.tolist()])
    lines = ["SOL 101", "CEND", "BEGIN BULK"]
    lines += [f"GRID    {number:<8d}{'':8s}{word(x)}{word(y)}{word(z)}" for number, (x, y, z) in enumerate(points.tolist(), 1)]
    card = {"tetrahedra": "CTETRA", "hexahedra": "CHEXA"}[kind]
    for number, (cell, region) in enumerate(zip(cells.tolist(), regions.tolist()), 1):
        corners = [f"{corner + 1:<8d}" for corner in cell]
        lines.append(f"{card:<8s}{number:<8d}{region:<8d}" + "".join(corners[:6]) + ("+" if corners[6:] else ""))
        lines += [f"{'+':<8s}" + "".join(corners[6:])] if corners[6:] else []
    (folder / "mesh.bdf").write_text("\n".join([*lines, "ENDDATA", ""]))
    return of_cells(folder / "mesh.bdf", points, values, judged, value_slack=3e-7)


TWO = {"names": ("temperature", "pressure"), "take": 1, "options": ("--array", "pressure"), "taken": {"array": "pressure"}}
LINEAR = ("tetrahedra", "hexahedra", "wedges", "pyramids", "mixed")
for version, format in (("2.2", "gmsh22"), ("4.1", "gmsh")):
    for kind in (*LINEAR, "quadratic tetrahedra", "quadratic hexahedra", "with triangles and lines")[:7 if version == "4.1" else None]:
        add("Gmsh", "cells", f"{version}, {kind}", gmsh, version=version, kind=kind)
    for binary in (False, True):
        add("Gmsh", "storage", f"{version}, {'binary' if binary else 'text'}, by meshio", by_meshio, ending=".msh", format=format, binary=binary)
    add("Gmsh", "arrays", f"{version}, values of cells", gmsh, version=version, of="cells", kind="mixed")
    add("Gmsh", "arrays", f"{version}, the second of two", gmsh, version=version, **TWO)
add("Gmsh", "storage", "2.2, binary", gmsh, binary=True)
for kind in LINEAR:
    add("MED", "cells", kind, by_meshio, ending=".med", format="med", kind=kind)
add("MED", "arrays", "the second of two", by_meshio, ending=".med", format="med", **TWO)
for data_format in ("XML", "HDF", "Binary"):
    add("XDMF", "storage", f"{data_format}, by meshio", by_meshio, ending=".xdmf", format="xdmf", data_format=data_format)
for form in ("XML", "HDF"):
    add("XDMF", "storage", form, xdmf, form=form)
for kind in XDMF:
    add("XDMF", "cells", kind, xdmf, kind=kind)
add("XDMF", "cells", "mixed, by meshio", by_meshio, ending=".xdmf", format="xdmf", kind="mixed")
add("XDMF", "arrays", "values of cells", xdmf, of="cells")
add("XDMF", "arrays", "the second of two", by_meshio, ending=".xdmf", format="xdmf", **TWO)
add("XDMF", "steps", "the third of 3", xdmf, form="HDF", steps=3, take=2, options=("--time", "3"), taken={"step": "3 of 3"})
add("XDMF", "steps", "the first of 3", xdmf, steps=3, taken={"step": "1 of 3"}, guessed=("step",))
add("XDMF", "steps", "the first of 3, by meshio", xdmf_of_meshio, take=0, guessed=("step",))
add("XDMF", "steps", "the third of 3, by meshio", xdmf_of_meshio, take=2, options=("--time", "3"))
for kind in ("tetrahedra", "hexahedra"):
    add("Medit", "cells", f"{kind}, with numbers of regions", medit, kind=kind)
    add("Nastran", "cells", f"{kind}, with properties", nastran, kind=kind)
add("Medit", "storage", "by meshio", references, ending=".mesh", format="medit", name="medit:ref")
add("Nastran", "storage", "by meshio", references, ending=".bdf", format="nastran", name="nastran:ref")
for kind in LINEAR:
    add("AVS UCD", "cells", kind, by_meshio, ending=".inp", format="avsucd", kind=kind)
add("AVS UCD", "arrays", "values of cells", by_meshio, ending=".inp", format="avsucd", of="cells")
add("AVS UCD", "arrays", "the second of two", by_meshio, ending=".inp", format="avsucd", **TWO)
add("Exodus II", "storage", "by meshio", by_meshio, ending=".e", format="exodus")
add("VTK unstructured (.vtu)", "storage", "by meshio", by_meshio, ending=".vtu", format="vtu")
add("VTK unstructured (.vtu)", "storage", "by meshio, text", by_meshio, ending=".vtu", format="vtu", binary=False)
for format in ("vtk42", "vtk51"):
    for binary in (False, True):
        add("VTK legacy (.vtk)", "storage", f"{format} by meshio, {'binary' if binary else 'text'}", by_meshio, ending=".vtk", format=format, binary=binary)
add("Tecplot", "storage", "by meshio", by_meshio, ending=".tec", format="tecplot", kind="hexahedra", place_slack=1.2e-7)
add("Tecplot", "storage", "by meshio, values of cells", by_meshio, ending=".tec", format="tecplot", of="cells", place_slack=1.2e-7)
