# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as meshio writes them: Gmsh, MED, XDMF, Nastran, Medit, UCD, and again Exodus, VTK and Tecplot; UCD line by line."""
import meshio
import numpy

from bench import add, of_cells
from mesh_samples import CELLS, mesh, values_at_points
from samples import numbers, wave


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


TWO = {"names": ("temperature", "pressure"), "take": 1, "options": ("--array", "pressure"), "taken": {"array": "pressure"}}
LINEAR = ("tetrahedra", "hexahedra", "wedges", "pyramids", "mixed")
for version, format in (("2.2", "gmsh22"), ("4.1", "gmsh")):
    for binary in (False, True):
        add("Gmsh", "storage", f"{version}, {'binary' if binary else 'text'}", by_meshio, ending=".msh", format=format, binary=binary)
    for kind in (*LINEAR[:None if version == "2.2" else -1], "quadratic tetrahedra"):
        add("Gmsh", "cells", f"{version}, {kind}", by_meshio, ending=".msh", format=format, kind=kind)
add("Gmsh", "arrays", "values of cells", by_meshio, ending=".msh", format="gmsh", of="cells")
add("Gmsh", "arrays", "the second of two", by_meshio, ending=".msh", format="gmsh", **TWO)
for kind in LINEAR:
    add("MED", "cells", kind, by_meshio, ending=".med", format="med", kind=kind)
add("MED", "arrays", "the second of two", by_meshio, ending=".med", format="med", **TWO)
for data_format in ("XML", "HDF", "Binary"):
    add("XDMF", "storage", data_format, by_meshio, ending=".xdmf", format="xdmf", data_format=data_format)
for kind in (*LINEAR, "quadratic tetrahedra"):
    add("XDMF", "cells", kind, by_meshio, ending=".xdmf", format="xdmf", kind=kind)
add("XDMF", "arrays", "values of cells", by_meshio, ending=".xdmf", format="xdmf", of="cells")
add("XDMF", "arrays", "the second of two", by_meshio, ending=".xdmf", format="xdmf", **TWO)
add("Medit", "cells", "tetrahedra, with references", references, ending=".mesh", format="medit", name="medit:ref")
add("Medit", "cells", "hexahedra, with references", references, ending=".mesh", format="medit", name="medit:ref", kind="hexahedra")
add("Nastran", "cells", "tetrahedra, with references", references, ending=".bdf", format="nastran", name="nastran:ref")
add("Nastran", "cells", "hexahedra, with references", references, ending=".bdf", format="nastran", name="nastran:ref", kind="hexahedra")
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
add("Tecplot", "storage", "by meshio", by_meshio, ending=".tec", format="tecplot", kind="hexahedra")
add("Tecplot", "storage", "by meshio, values of cells", by_meshio, ending=".tec", format="tecplot", of="cells")
