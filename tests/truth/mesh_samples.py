# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes of every kind of cell, whose points are those of a bent block."""
import numpy

from samples import curvilinear

# name -> VTK's number, meshio's name, points
CELLS = {"tetrahedra": (10, "tetra", 4), "hexahedra": (12, "hexahedron", 8), "wedges": (13, "wedge", 6), "pyramids": (14, "pyramid", 5),
         "voxels": (11, "voxel", 8), "quadratic tetrahedra": (24, "tetra10", 10), "quadratic hexahedra": (25, "hexahedron20", 20),
         "triquadratic hexahedra": (29, "hexahedron27", 27), "quadratic wedges": (26, "wedge15", 15), "triangles": (5, "triangle", 3),
         "lines": (3, "line", 2)}
KUHN = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))
EDGES = {"tetrahedra": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
         "hexahedra": ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)),
         "wedges": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5))}
FACES_OF_HEXAHEDRON = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
SMALL = (4, 4, 5)
MESH = ("tetrahedra", "hexahedra", "wedges", "pyramids", "voxels", "mixed", "quadratic tetrahedra", "quadratic hexahedra", "triquadratic hexahedra",
        "quadratic wedges", "with triangles and lines")


def boxes(size=SMALL, bent=True):
    """Points, and hexahedra in VTK's order of corners."""
    whole = curvilinear(size=size)
    points = whole.places if bent else numpy.moveaxis(numpy.indices(size), 0, -1) * (4.0, 3.0, 2.0) + (10, 20, -30)
    number = numpy.arange(numpy.prod(size)).reshape(size)
    low, high = slice(None, -1), slice(1, None)
    corners = ((low, low, low), (high, low, low), (high, high, low), (low, high, low), (low, low, high), (high, low, high), (high, high, high), (low, high, high))
    return points.reshape(-1, 3), numpy.stack([number[at].ravel() for at in corners], axis=1)


def with_middles(points, cells, groups):
    """Cells with a point more in the middle of each group of corners; groups that are shared have one."""
    seen, points, more = {}, list(points), []
    for cell in cells.tolist():
        row = []
        for group in groups:
            key = tuple(sorted(cell[corner] for corner in group))
            if key not in seen:
                seen[key] = len(points)
                points.append(numpy.mean([points[number] for number in key], axis=0))
            row.append(seen[key])
        more.append(row)
    return numpy.array(points), numpy.hstack([cells, more])


def pyramids_of(cells):
    """Of hexahedra with a point in the middle: six of each."""
    faces = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))
    return numpy.concatenate([cells[:, [*face, 8]] for face in faces])


def mesh(kind):
    """Points; [(kind of cells, their points)]; the cells that make the domain; cells that TAn leaves out."""
    points, hexahedra = boxes(bent=kind != "voxels")
    tetrahedra = numpy.concatenate([hexahedra[:, corners] for corners in KUHN])
    wedges = numpy.concatenate([hexahedra[:, (0, 1, 2, 4, 5, 6)], hexahedra[:, (0, 2, 3, 4, 6, 7)]])
    if kind == "tetrahedra":
        blocks = [(kind, tetrahedra)]
    elif kind == "hexahedra":
        blocks = [(kind, hexahedra)]
    elif kind == "wedges":
        blocks = [(kind, wedges[:, (0, 2, 1, 3, 5, 4)])]
    elif kind == "voxels":
        blocks = [(kind, hexahedra[:, (0, 1, 3, 2, 4, 5, 7, 6)])]
    elif kind == "pyramids":
        # The middle of each hexahedron is the top of six.
        points, cells = with_middles(points, hexahedra, [range(8)])
        blocks = [(kind, pyramids_of(cells))]
    elif kind == "mixed":
        # A layer of pyramids between hexahedra.
        layer = numpy.arange(len(hexahedra)) % (SMALL[2] - 1)
        points, cells = with_middles(points, hexahedra[layer == 1], [range(8)])
        blocks = [("hexahedra", hexahedra[layer != 1]), ("pyramids", pyramids_of(cells))]
    elif kind == "quadratic tetrahedra":
        points, cells = with_middles(points, tetrahedra, EDGES["tetrahedra"])
        blocks = [(kind, cells)]
    elif kind in ("quadratic hexahedra", "triquadratic hexahedra"):
        groups = EDGES["hexahedra"] + (FACES_OF_HEXAHEDRON + (range(8),) if kind.startswith("tri") else ())
        points, cells = with_middles(points, hexahedra, groups)
        blocks = [(kind, cells)]
    elif kind == "quadratic wedges":
        points, cells = with_middles(points, wedges[:, (0, 2, 1, 3, 5, 4)], EDGES["wedges"])
        blocks = [(kind, cells)]
    else:
        points, hexahedra = boxes()
        blocks = [("tetrahedra", tetrahedra), ("triangles", tetrahedra[:7, :3]), ("lines", tetrahedra[:5, :2])]
    judged = [cells for name, cells in blocks if name not in ("triangles", "lines")] if kind != "voxels" else [hexahedra]
    return points, blocks, judged, [cells for name, cells in blocks if name in ("triangles", "lines")]


def values_at_points(count, blocks, values):
    """Values of cells -> the mean of the cells around each point."""
    total, number = numpy.zeros(count), numpy.zeros(count)
    first = 0
    for cells in blocks:
        for corner in cells.T:
            numpy.add.at(total, corner, values[first:first + len(cells)])
            numpy.add.at(number, corner, 1)
        first += len(cells)
    return total / numpy.where(number, number, 1)


def lagrange(kind, order):
    """Points, VTK's number, cells, and the cells that make the domain, of Lagrange cells of order 1 and 2."""
    points, hexahedra = boxes()
    if kind == "tetrahedron":
        cells = numpy.concatenate([hexahedra[:, corners] for corners in KUHN])
        if order == 2:
            points, cells = with_middles(points, cells, EDGES["tetrahedra"])
        return points, 71, cells, [cells]
    if order == 2:
        # VTK 9's order of edges: those of the bottom, of the top, then upright ones 0-4, 1-5, 3-7, 2-6 in files of versions before 2.2.
        points, hexahedra = with_middles(points, hexahedra, EDGES["hexahedra"] + FACES_OF_HEXAHEDRON + (range(8),))
    return points, 72, hexahedra, [hexahedra]
