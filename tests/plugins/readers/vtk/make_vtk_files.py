# SPDX-License-Identifier: GPL-3.0-or-later
# Writes a file of each format into the folder named first, and beside it NAME.ref with what VTK itself reads in it: five
# 64-bit integers (points, cells, three dimensions or zeros), then the positions and the values as doubles.
# Exits with 77 without VTK.
import ctypes
import ctypes.util
import math
import os
import struct
import sys

try:
    import vtk
except ImportError:
    sys.exit(77)

folder = sys.argv[1]
SIZE = (4, 5, 6)


def path(name):
    return os.path.join(folder, name)


def field(data, name, vtk_type=vtk.VTK_FLOAT, scale=40.0):
    """A smooth field at the points of a dataset."""
    array = vtk.vtkDataArray.CreateDataArray(vtk_type)
    array.SetName(name)
    array.SetNumberOfTuples(data.GetNumberOfPoints())
    for i in range(data.GetNumberOfPoints()):
        x, y, z = data.GetPoint(i)
        value = scale * (1.3 + math.sin(0.7 * x + 0.1) * math.cos(0.5 * y) + 0.05 * z)
        array.SetTuple1(i, value if vtk_type in (vtk.VTK_FLOAT, vtk.VTK_DOUBLE) else int(value))
    return array


def with_fields(data, vtk_type=vtk.VTK_FLOAT):
    data.GetPointData().SetScalars(field(data, "density", vtk_type))
    vector = vtk.vtkFloatArray()
    vector.SetName("velocity")
    vector.SetNumberOfComponents(3)
    for i in range(data.GetNumberOfPoints()):
        x, y, z = data.GetPoint(i)
        vector.InsertNextTuple3(y - z, 0.5 * x, x * y)
    data.GetPointData().AddArray(vector)
    return data


def image(vtk_type=vtk.VTK_FLOAT):
    data = vtk.vtkImageData()
    data.SetDimensions(*SIZE)
    data.SetSpacing(0.5, 0.25, 1.5)
    data.SetOrigin(-1, 2, 3)
    return with_fields(data, vtk_type)


def scalar_image(vtk_type):
    data = vtk.vtkImageData()
    data.SetDimensions(*SIZE)
    data.SetSpacing(0.5, 0.25, 1.5)
    data.SetOrigin(-1, 2, 3)
    data.GetPointData().SetScalars(field(data, "scalars", vtk_type))
    return data


def rectilinear():
    data = vtk.vtkRectilinearGrid()
    data.SetDimensions(*SIZE)
    for axis, name in enumerate(("X", "Y", "Z")):
        values = vtk.vtkDoubleArray()
        for i in range(SIZE[axis]):
            values.InsertNextValue(0.3 * i * i + i + axis)
        getattr(data, "Set" + name + "Coordinates")(values)
    return with_fields(data, vtk.VTK_DOUBLE)


def structured():
    points = vtk.vtkPoints()
    for k in range(SIZE[2]):
        for j in range(SIZE[1]):
            for i in range(SIZE[0]):
                points.InsertNextPoint(i + 0.1 * j, j + 0.05 * k * k, k + 0.2 * i)
    data = vtk.vtkStructuredGrid()
    data.SetDimensions(*SIZE)
    data.SetPoints(points)
    return with_fields(data)


def tetrahedra():
    triangulate = vtk.vtkDataSetTriangleFilter()
    triangulate.SetInputData(image())
    triangulate.Update()
    return triangulate.GetOutput()


def cloud():
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    vertices = vtk.vtkCellArray()
    for i in range(50):
        points.InsertNextPoint(math.sin(i * 1.7) * 5, math.cos(i * 2.3) * 4, (i * 7 % 50) * 0.1)
        vertices.InsertNextCell(1, [i])
    data.SetPoints(points)
    data.SetVerts(vertices)
    return with_fields(data)


def leaves(data):
    if data.IsA("vtkDataSet"):
        return [data]
    at = data.NewIterator()
    found = []
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        if at.GetCurrentDataObject().GetNumberOfPoints() > 0:
            found.append(at.GetCurrentDataObject())
        at.GoToNextItem()
    return found


def write_reference(name, reader, array=None):
    """What VTK reads; `array` is the first one if it is not named."""
    reader.Update()
    data = leaves(reader.GetOutputDataObject(0))[0]
    values = data.GetPointData().GetArray(array) if array else data.GetPointData().GetScalars()
    if values is None:
        values = data.GetPointData().GetArray(0)
    dimensions = data.GetDimensions() if hasattr(data, "GetDimensions") else (0, 0, 0)
    with open(path(name) + ".ref", "wb") as file:
        file.write(struct.pack("<5q", data.GetNumberOfPoints(), data.GetNumberOfCells(), *dimensions))
        for i in range(data.GetNumberOfPoints()):
            file.write(struct.pack("<3d", *data.GetPoint(i)))
        for i in range(data.GetNumberOfPoints()):
            file.write(struct.pack("<d", values.GetComponent(i, 0)))


def written(name, writer, data, reader, **settings):
    writer.SetFileName(path(name))
    for setting, value in settings.items():
        getattr(writer, setting)(value)
    writer.SetInputData(data)
    writer.Write()
    reader.SetFileName(path(name))
    write_reference(name, reader)


def write_xml():
    kinds = {"vti": (vtk.vtkXMLImageDataWriter, vtk.vtkXMLImageDataReader, image()),
             "vtr": (vtk.vtkXMLRectilinearGridWriter, vtk.vtkXMLRectilinearGridReader, rectilinear()),
             "vts": (vtk.vtkXMLStructuredGridWriter, vtk.vtkXMLStructuredGridReader, structured()),
             "vtu": (vtk.vtkXMLUnstructuredGridWriter, vtk.vtkXMLUnstructuredGridReader, tetrahedra()),
             "vtp": (vtk.vtkXMLPolyDataWriter, vtk.vtkXMLPolyDataReader, cloud())}
    for ending, (writer, reader, data) in kinds.items():
        for mode, label in enumerate(("ascii", "binary", "appended")):
            written(label + "." + ending, writer(), data, reader(), SetDataMode=mode)
    for vtk_type in (vtk.VTK_UNSIGNED_CHAR, vtk.VTK_SIGNED_CHAR, vtk.VTK_UNSIGNED_SHORT, vtk.VTK_SHORT,
                     vtk.VTK_UNSIGNED_INT, vtk.VTK_INT, vtk.VTK_DOUBLE):
        written("type%d.vti" % vtk_type, vtk.vtkXMLImageDataWriter(), image(vtk_type), vtk.vtkXMLImageDataReader())
    pieces = vtk.vtkXMLPImageDataWriter()
    written("pieces.pvti", pieces, image(), vtk.vtkXMLPImageDataReader(), SetNumberOfPieces=2, SetStartPiece=0,
            SetEndPiece=1)
    written("pieces.pvtu", vtk.vtkXMLPUnstructuredGridWriter(), tetrahedra(), vtk.vtkXMLPUnstructuredGridReader(),
            SetNumberOfPieces=1, SetStartPiece=0, SetEndPiece=0)
    write_halves()
    blocks = vtk.vtkMultiBlockDataSet()
    blocks.SetBlock(0, structured())
    blocks.SetBlock(1, rectilinear())
    written("blocks.vtm", vtk.vtkXMLMultiBlockDataWriter(), blocks, vtk.vtkXMLMultiBlockDataReader())


def write_halves():
    """A lattice in two pieces that meet in a layer."""
    data = image()
    pieces = ""
    for number, (first, last) in enumerate(((0, 3), (3, 5))):
        part = vtk.vtkExtractVOI()
        part.SetInputData(data)
        part.SetVOI(0, 3, 0, 4, first, last)
        writer = vtk.vtkXMLImageDataWriter()
        writer.SetFileName(path("halves_%d.vti" % number))
        writer.SetInputConnection(part.GetOutputPort())
        writer.Write()
        pieces += '<Piece Extent="0 3 0 4 %d %d" Source="halves_%d.vti"/>' % (first, last, number)
    with open(path("halves.pvti"), "w") as file:
        file.write('<?xml version="1.0"?><VTKFile type="PImageData" version="0.1" byte_order="LittleEndian">'
                   '<PImageData WholeExtent="0 3 0 4 0 5" GhostLevel="0" Origin="-1 2 3" Spacing="0.5 0.25 1.5">'
                   '<PPointData Scalars="density"><PDataArray type="Float32" Name="density"/>'
                   '<PDataArray type="Float32" Name="velocity" NumberOfComponents="3"/></PPointData>' + pieces +
                   '</PImageData></VTKFile>')
    reader = vtk.vtkXMLPImageDataReader()
    reader.SetFileName(path("halves.pvti"))
    write_reference("halves.pvti", reader)


def write_legacy():
    for name, data in (("points", image()), ("rectilinear", rectilinear()), ("structured", structured()),
                       ("tetrahedra", tetrahedra()), ("cloud", cloud())):
        for binary in (0, 1):
            written("%s%d.vtk" % (name, binary), vtk.vtkGenericDataObjectWriter(), data,
                    vtk.vtkGenericDataObjectReader(), SetFileType=2 if binary else 1)


def write_images():
    for vtk_type in (vtk.VTK_UNSIGNED_CHAR, vtk.VTK_SHORT, vtk.VTK_FLOAT):
        data = scalar_image(vtk_type)
        written("image%d.mha" % vtk_type, vtk.vtkMetaImageWriter(), data, vtk.vtkMetaImageReader())
        written("image%d.mhd" % vtk_type, vtk.vtkMetaImageWriter(), data, vtk.vtkMetaImageReader())
        written("image%d.nii" % vtk_type, vtk.vtkNIFTIImageWriter(), data, vtk.vtkNIFTIImageReader())
    writer = vtk.vtkNIFTIImageWriter()
    writer.SetFileName(path("rescaled.nii"))
    writer.SetRescaleSlope(2)
    writer.SetRescaleIntercept(5)
    writer.SetInputData(scalar_image(vtk.VTK_SHORT))
    writer.Write()
    header = struct.pack("<4i3i3i6f3i3f", 4, 5, 6, 2, 0, 0, 0, 4, 5, 6, 4, 5, 6, 90, 90, 90, 1, 2, 3, 0, 119, 60)
    header += struct.pack("<2i", 0, 0) + bytes(100) + struct.pack("<3f", 0, 0, 0) + b"MAP " + b"\x44\x44\x00\x00"
    with open(path("map.mrc"), "wb") as file:
        file.write(header.ljust(1024, b"\0") + struct.pack("<120f", *range(120)))
    reader = vtk.vtkMRCReader()
    reader.SetFileName(path("map.mrc"))
    write_reference("map.mrc", reader)


def netcdf_name(text):
    raw = text.encode()
    return struct.pack(">i", len(raw)) + raw + b"\0" * (-len(raw) % 4)


def write_netcdf():
    """Classic NetCDF: temperature(z, y, x) with coordinate variables."""
    sizes = {"z": 6, "y": 5, "x": 4}
    variables = [(n, [i], 6, struct.pack(">%dd" % s, *[k * (i + 0.5) for k in range(s)]))
                 for i, (n, s) in enumerate(sizes.items())]
    variables.append(("temperature", [0, 1, 2], 5, struct.pack(">120f", *[math.sin(k * 0.1) for k in range(120)])))
    head = b"CDF\1" + struct.pack(">i", 0) + struct.pack(">2i", 10, 3)
    head += b"".join(netcdf_name(n) + struct.pack(">i", s) for n, s in sizes.items()) + struct.pack(">2i", 0, 0)

    def listed(first):
        text, begin = struct.pack(">2i", 11, len(variables)), first
        for name, dimensions, number_type, values in variables:
            text += netcdf_name(name) + struct.pack(">i", len(dimensions)) + struct.pack(">%di" % len(dimensions), *dimensions)
            text += struct.pack(">2i", 0, 0) + struct.pack(">3i", number_type, len(values), begin)
            begin += len(values)
        return text

    first = len(head) + len(listed(0))
    with open(path("grid.nc"), "wb") as file:
        file.write(head + listed(first) + b"".join(variable[3] for variable in variables))
    reader = vtk.vtkNetCDFCFReader()
    reader.SetFileName(path("grid.nc"))
    reader.SphericalCoordinatesOff()
    reader.UpdateMetaData()
    reader.SetDimensions("(z, y, x)")
    write_reference("grid.nc", reader, "temperature")


def write_plot3d():
    """Two grids in one text file, with a solution."""
    def grid(shift):
        data = structured()
        return [[data.GetPoint(i)[axis] + shift for i in range(data.GetNumberOfPoints())] for axis in range(3)]

    def text(values):
        return " ".join("%.9g" % value for value in values) + "\n"

    count = SIZE[0] * SIZE[1] * SIZE[2]
    for name, shifts, blanking in (("one", [0], False), ("two", [0, 20], False), ("blanked", [0], True)):
        sizes = ("%d\n" % len(shifts) if len(shifts) > 1 else "") + "%d %d %d\n" % SIZE * len(shifts)
        with open(path(name + ".xyz"), "w") as file:
            file.write(sizes)
            for shift in shifts:
                file.write("".join(text(values) for values in grid(shift)))
                if blanking:
                    file.write(" ".join("0" if i % 4 == 3 else "1" for i in range(count)) + "\n")
        with open(path(name + ".q"), "w") as file:
            file.write(sizes)
            for shift in shifts:
                file.write("0.5 0 1000 1\n" + "".join(text([k + 1 + 0.01 * i for i in range(count)]) for k in range(5)))
        reader = vtk.vtkMultiBlockPLOT3DReader()
        reader.SetXYZFileName(path(name + ".xyz"))
        reader.SetQFileName(path(name + ".q"))
        reader.BinaryFileOff()
        reader.SetMultiGrid(len(shifts) > 1)
        reader.SetIBlanking(blanking)
        write_reference(name + ".xyz", reader, "Density")


def write_exodus():
    data = tetrahedra()
    writer = vtk.vtkExodusIIWriter()
    writer.SetFileName(path("mesh.ex2"))
    writer.SetInputData(data)
    writer.WriteOutBlockIdArrayOff()
    writer.Write()
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path("mesh.ex2"))
    reader.UpdateInformation()
    reader.SetAllArrayStatus(vtk.vtkExodusIIReader.NODAL, 1)
    write_reference("mesh.ex2", reader, "density")


def write_ensight():
    data = tetrahedra()
    positions = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    cells = [[data.GetCell(c).GetPointId(i) + 1 for i in range(4)] for c in range(data.GetNumberOfCells())]
    with open(path("run.case"), "w") as file:
        file.write("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: run.geo\nVARIABLE\nscalar per node: 1 heat run.heat**\n"
                   "TIME\ntime set: 1\nnumber of steps: 2\nfilename start number: 0\nfilename increment: 1\n"
                   "time values: 0.5 1.5\n")
    with open(path("run.geo"), "w") as file:
        file.write("one\ntwo\nnode id assign\nelement id assign\npart\n%10d\nfluid\ncoordinates\n%10d\n" % (1, len(positions)))
        for axis in range(3):
            file.write("".join("%12.5e\n" % position[axis] for position in positions))
        file.write("tetra4\n%10d\n" % len(cells))
        file.write("".join("%10d%10d%10d%10d\n" % tuple(cell) for cell in cells))
    for step in range(2):
        with open(path("run.heat%02d" % step), "w") as file:
            file.write("heat\npart\n%10d\ncoordinates\n" % 1)
            file.write("".join("%12.5e\n" % (position[0] + 10 * step) for position in positions))
    reader = vtk.vtkGenericEnSightReader()
    reader.SetCaseFileName(path("run.case"))
    reader.ReadAllVariablesOn()
    write_reference("run.case", reader, "heat")


def write_texts():
    """Tecplot: a zone of points."""
    size = (3, 3, 3)
    nodes = [(i, j, k) for k in range(3) for j in range(3) for i in range(3)]
    with open(path("block.tec"), "w") as file:
        file.write('TITLE = "t"\nVARIABLES = "X", "Y", "Z", "P"\nZONE I=%d, J=%d, K=%d, F=POINT\n' % size)
        file.write("".join("%g %g %g %g\n" % (i, j, k, i * 2 + j * j + k) for i, j, k in nodes))
    reader = vtk.vtkTecplotReader()
    reader.SetFileName(path("block.tec"))
    write_reference("block.tec", reader, "P")


class Hdf5:
    """As much of the library of HDF5, which VTK brings, as is needed to write groups, attributes and arrays."""
    SCALAR, SIMPLE, ORDERED = 0, 1, 3  # H5S_SCALAR, H5S_SIMPLE, creation order tracked and indexed

    def __init__(self, library, name):
        self.lib = library
        library.H5open()
        for function in ("H5Fcreate", "H5Gcreate2", "H5Acreate2", "H5Dcreate2", "H5Screate", "H5Screate_simple", "H5Tcopy",
                         "H5Pcreate"):
            getattr(library, function).restype = ctypes.c_int64
        self.ordered = {kind: self.create_list("H5P_CLS_%s_CREATE_ID_g" % kind) for kind in ("FILE", "GROUP")}
        self.file = self.call("H5Fcreate", name.encode(), 2, self.ordered["FILE"], 0)

    def constant(self, name):
        return ctypes.c_int64(ctypes.c_int64.in_dll(self.lib, name).value)

    def call(self, function, *arguments):
        return ctypes.c_int64(getattr(self.lib, function)(*[
            ctypes.c_int64(a) if isinstance(a, int) else a for a in arguments]))

    def create_list(self, kind):
        made = self.call("H5Pcreate", self.constant(kind))
        self.call("H5Pset_link_creation_order", made, self.ORDERED)
        return made

    def group(self, parent, name):
        return self.call("H5Gcreate2", parent, name.encode(), 0, self.ordered["GROUP"], 0)

    def text_type(self, size):
        made = self.call("H5Tcopy", self.constant("H5T_C_S1_g"))
        self.call("H5Tset_size", made, size)
        return made

    def space(self, shape):
        if shape is None:
            return self.call("H5Screate", self.SCALAR)
        return self.call("H5Screate_simple", len(shape), (ctypes.c_uint64 * len(shape))(*shape), None)

    def attribute(self, parent, name, kind, shape, raw):
        made = self.call("H5Acreate2", parent, name.encode(), kind, self.space(shape), 0, 0)
        self.call("H5Awrite", made, kind, raw)
        self.call("H5Aclose", made)

    def text(self, parent, name, text, size=None):
        size = size or len(text)
        self.attribute(parent, name, self.text_type(size), None, text.encode().ljust(size, b"\0"))

    def array(self, parent, name, kind, shape, raw):
        made = self.call("H5Dcreate2", parent, name.encode(), kind, self.space(shape), 0, 0, 0)
        self.call("H5Dwrite", made, kind, 0, 0, 0, raw)
        self.call("H5Dclose", made)

    def close(self):
        self.lib.H5close()


def write_hdf():
    name = ctypes.util.find_library("hdf5_serial") or ctypes.util.find_library("hdf5")
    if name is None:
        return
    library = ctypes.CDLL(name)
    samples = struct.pack("<120f", *range(120))
    hdf = Hdf5(library, path("image.vtkhdf"))
    long, double, single = [hdf.constant("H5T_NATIVE_%s_g" % kind) for kind in ("LLONG", "DOUBLE", "FLOAT")]
    top = hdf.group(hdf.file, "VTKHDF")
    hdf.attribute(top, "Version", long, (2,), struct.pack("<2q", 1, 0))
    hdf.text(top, "Type", "ImageData")
    hdf.attribute(top, "WholeExtent", long, (6,), struct.pack("<6q", 0, 3, 0, 4, 0, 5))
    hdf.attribute(top, "Origin", double, (3,), struct.pack("<3d", -1, 2, 3))
    hdf.attribute(top, "Spacing", double, (3,), struct.pack("<3d", 0.5, 0.25, 1.5))
    hdf.attribute(top, "Direction", double, (9,), struct.pack("<9d", 1, 0, 0, 0, 1, 0, 0, 0, 1))
    hdf.array(hdf.group(top, "PointData"), "density", single, (6, 5, 4), samples)
    hdf.close()
    reader = vtk.vtkHDFReader()
    reader.SetFileName(path("image.vtkhdf"))
    write_reference("image.vtkhdf", reader, "density")

    hdf = Hdf5(library, path("grid.cgns"))
    integer, double, single, byte = [hdf.constant("H5T_NATIVE_%s_g" % kind) for kind in ("INT", "DOUBLE", "FLOAT", "SCHAR")]

    def node(parent, name, label, kind, raw=None, shape=None, data_type=None):
        made = parent if name is None else hdf.group(parent, name)
        hdf.text(made, "name", name or "HDF5 MotherNode", 33)
        hdf.text(made, "label", label, 33)
        hdf.text(made, "type", kind, 3)
        if name is not None:
            hdf.attribute(made, "flags", integer, (1,), struct.pack("<i", 1))
        if raw is not None:
            hdf.array(made, " data", data_type, shape, raw)
        return made

    node(hdf.file, None, "Root Node of HDF5 File", "MT")
    for name, text in ((" format", "IEEE_LITTLE_32"), (" hdf5version", "HDF5 Version 1.10.8")):
        hdf.array(hdf.file, name, byte, (len(text) + 1,), text.encode() + b"\0")
    node(hdf.file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", "R4", struct.pack("<f", 3.1), (1,), single)
    base = node(hdf.file, "Base", "CGNSBase_t", "I4", struct.pack("<2i", 3, 3), (2,), integer)
    zone = node(base, "Zone", "Zone_t", "I4", struct.pack("<9i", 4, 5, 6, 3, 4, 5, 0, 0, 0), (3, 3), integer)
    node(zone, "ZoneType", "ZoneType_t", "C1", b"Structured", (10,), byte)
    positions = node(zone, "GridCoordinates", "GridCoordinates_t", "MT")
    grid = structured()
    for axis, name in enumerate("XYZ"):
        raw = struct.pack("<120d", *[grid.GetPoint(i)[axis] for i in range(120)])
        node(positions, "Coordinate" + name, "DataArray_t", "R8", raw, (6, 5, 4), double)
    solution = node(zone, "FlowSolution", "FlowSolution_t", "MT")
    node(solution, "GridLocation", "GridLocation_t", "C1", b"Vertex", (6,), byte)
    node(solution, "Pressure", "DataArray_t", "R8", struct.pack("<120d", *range(120)), (6, 5, 4), double)
    hdf.close()
    reader = vtk.vtkCGNSReader()
    reader.SetFileName(path("grid.cgns"))
    reader.UpdateInformation()
    reader.EnableAllBases()
    reader.EnableAllPointArrays()
    write_reference("grid.cgns", reader, "Pressure")


for write in (write_xml, write_legacy, write_images, write_netcdf, write_plot3d, write_exodus, write_ensight,
              write_texts, write_hdf):
    write()
