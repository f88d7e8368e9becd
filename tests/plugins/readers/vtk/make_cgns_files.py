# SPDX-License-Identifier: GPL-3.0-or-later
# Writes CGNS files into the folder named first: grids of two steps, grids of two bases, meshes of which one has no values, and a
# grid whose headers are not as they should be. Exits with 77 without h5py.
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "torture"))
import bomb_files  # noqa: E402

if not bomb_files.h5py:
    sys.exit(77)

from bomb_files import cgns_node, h5py, numpy  # noqa: E402

folder = pathlib.Path(sys.argv[1])
SI = "Kilogram", "Meter", "Second", "Kelvin", "Degree"


def words(*texts):
    """As CGNS keeps them: 32 letters each."""
    return numpy.frombuffer("".join(text.ljust(32) for text in texts).encode(), "i1").reshape(len(texts), 32)


def array(parent, name, values, powers=None):
    node = cgns_node(parent, name, "DataArray_t", numpy.ascontiguousarray(values))
    if powers:
        cgns_node(node, "DimensionalExponents", "DimensionalExponents_t", numpy.array(powers, "f4"))


def zone(base, name, sizes, kind, places):
    made = cgns_node(base, name, "Zone_t", numpy.array(sizes, "i4"))
    cgns_node(made, "ZoneType", "ZoneType_t", kind)
    grid = cgns_node(made, "GridCoordinates", "GridCoordinates_t")
    for axis, numbers in zip("XYZ", places):
        array(grid, "Coordinate" + axis, numbers)
    return made


def grid(base, name, first):
    """3 x 3 x 4 points, bent, from x = first on."""
    z, y, x = numpy.mgrid[0:4., 0:3., 0:3.]
    return zone(base, name, [[3, 3, 4], [2, 2, 3], [0, 0, 0]], "Structured", (x + first + 0.25 * y * z, y, z))


def values(count):
    return numpy.arange(float(count))


def with_file(name):
    file = h5py.File(folder / name, "w", track_order=True, libver=("earliest", "latest"))
    for key, text, length in (("name", "HDF5 MotherNode", 33), ("label", "Root Node of HDF5 File", 33), ("type", "MT", 3)):
        file.attrs.create(key, numpy.bytes_(text), dtype=h5py.string_dtype("ascii", length))
    file.create_dataset(" format", data=numpy.frombuffer(b"IEEE_LITTLE_32\0", "i1"))
    file.create_dataset(" hdf5version", data=numpy.frombuffer(b"HDF5 Version 1.10.8".ljust(33, b"\0"), "i1"))
    cgns_node(file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", numpy.array([3.1], "f4"))
    return file


def new_base(file, name="Base"):
    return cgns_node(file, name, "CGNSBase_t", numpy.array([3, 3], "i4"))


with with_file("steps.cgns") as file:
    base = new_base(file)
    cgns_node(base, "DataClass", "DataClass_t", "Dimensional")
    cgns_node(base, "DimensionalUnits", "DimensionalUnits_t", words(*SI))
    times = cgns_node(base, "Times", "BaseIterativeData_t", numpy.array([2], "i4"))
    array(times, "TimeValues", numpy.array([0, 2.5]))
    for number in range(2):
        part = grid(base, "Zone%d" % (number + 1), 2 * number)
        for step in range(2):
            flow = cgns_node(part, "Flow%d" % step, "FlowSolution_t")
            array(flow, "Density", values(36).reshape(4, 3, 3) + 100 * step, (1, -3, 0, 0, 0))
            for axis in "XYZ":
                array(flow, "Velocity" + axis, values(36).reshape(4, 3, 3), (0, 1, -1, 0, 0))
        pointers = cgns_node(part, "Pointers", "ZoneIterativeData_t")
        cgns_node(pointers, "FlowSolutionPointers", "DataArray_t", words("Flow0", "Flow1"))

with with_file("bases.cgns") as file:
    for number in range(2):
        part = grid(new_base(file, "Base%d" % (number + 1)), "Zone", 2 * number)
        array(cgns_node(part, "Flow", "FlowSolution_t"), "Pressure", values(36).reshape(4, 3, 3))
        flow = cgns_node(part, "Cells", "FlowSolution_t")
        cgns_node(flow, "GridLocation", "GridLocation_t", "CellCenter")
        array(flow, "Heat", values(12).reshape(3, 2, 2), (0, 0, 0, 1, 0))  # of units that are not told
        flow["Ring"] = file["Base1"]  # which leads back here

with with_file("odd.cgns") as file:
    flow = cgns_node(grid(new_base(file), "Zone", 0), "Flow", "FlowSolution_t")
    array(flow, "Density", values(36).reshape(4, 3, 3), range(2000))

with with_file("mesh.cgns") as file:
    base = new_base(file)
    for number, name in enumerate(("Solid", "Fluid")):
        z, y, x = numpy.mgrid[0:2., 0:2., 0:2.]
        part = zone(base, name, [[8], [1], [0]], "Unstructured", ((x + number).ravel(), y.ravel(), z.ravel()))
        cells = cgns_node(part, "Cells", "Elements_t", numpy.array([17, 0], "i4"))
        cgns_node(cells, "ElementRange", "IndexRange_t", numpy.array([1, 1], "i4"))
        cgns_node(cells, "ElementConnectivity", "DataArray_t", numpy.array([1, 2, 4, 3, 5, 6, 8, 7], "i4"))
        flow = cgns_node(part, "Flow", "FlowSolution_t")
        cgns_node(flow, "DimensionalUnits", "DimensionalUnits_t", words(*SI))
        if name == "Fluid":
            array(flow, "Temperature", values(8), (0, 0, 0, 1, 0))
