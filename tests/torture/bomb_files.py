# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that ask for more than there is, lead out of their folder, wait for ever or go round: small, and each of them well-formed up to
that. A bomb is its name, the file that is opened, and a function that writes all of it into a folder; beside that folder lie good files
with the values SECRET, which no bomb may get at."""
import json
import os
import pathlib
import struct
import zlib

try:
    import h5py
    import numpy
except ImportError:  # then without those
    h5py = None

SECRET = 31415.9265
CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))


def put(folder, name, content):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content.encode() if isinstance(content, str) else content)


def files(**named):
    """A bomb of plain files: their names with __ for /; a text in brackets for a link, None for a pipe, a function for what is large."""
    def write(folder):
        for name, content in named.items():
            name, content = name.replace("__", "/"), content() if callable(content) else content
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            if content is None:
                os.mkfifo(folder / name)
            elif isinstance(content, tuple):
                os.symlink(content[0], folder / name)
            else:
                put(folder, name, content)
    return write


def bomb(name, opened, write=None, **named):
    return name, opened, write or files(**named)


# -- what lies outside -------------------------------------------------------------------------------------------------------------

def secret_vtu():
    points = " ".join("%g %g %g" % corner for corner in CORNERS)
    return ('<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>'
            '<Piece NumberOfPoints="4" NumberOfCells="1"><PointData><DataArray type="Float64" Name="secret" format="ascii">%s</DataArray>'
            '</PointData><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">%s</DataArray></Points><Cells>'
            '<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>'
            '<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray><DataArray type="UInt8" Name="types" format="ascii">10'
            '</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>' % (" ".join(["%r" % SECRET] * 3 + ["0"]), points))


def secret_vti(size=2):
    values = " ".join(["%r" % SECRET] * (size ** 3 - 1) + ["0"])
    extent = "0 %d 0 %d 0 %d" % ((size - 1,) * 3)
    return ('<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="%s" Origin="0 0 0" Spacing="1 1 1">'
            '<Piece Extent="%s"><PointData Scalars="secret"><DataArray type="Float64" Name="secret" format="ascii">%s</DataArray></PointData>'
            '</Piece></ImageData></VTKFile>' % (extent, extent, values))


def good_vti(size=2):
    return secret_vti(size).replace("%r" % SECRET, "7").replace("secret", "heat")


def gold_geometry(count="4"):
    return ("description\nmore\nnode id off\nelement id off\npart\n1\npart\ncoordinates\n%s\n" % count +
            "".join("%12.5e\n" % corner[axis] for axis in range(3) for corner in CORNERS) + "tetra4\n1\n         1         2         3         4\n")


def gold_values():
    return "values\npart\n1\ncoordinates\n" + "".join("%12.5e\n" % value for value in (SECRET, SECRET, SECRET, 0))


def secrets(folder):
    """The good files beside the folder of a bomb."""
    put(folder, "secret.vtu", secret_vtu())
    put(folder, "secret.vti", secret_vti())
    put(folder, "secret.geo", gold_geometry())
    put(folder, "secret.heat", gold_values())
    put(folder, "secret.txt", "%r %r %r 0" % ((SECRET,) * 3))
    put(folder, "secret.bin", struct.pack("<4d", SECRET, SECRET, SECRET, 0))
    put(folder, "secret.foam", foam_head("volScalarField", "T") + foam_field("nonuniform List<scalar> 1(%r)" % SECRET))
    put(folder, "chunks/0.0.0", struct.pack("<8d", *[SECRET] * 7, 0))
    if h5py:
        with h5py.File(folder / "secret.h5", "w") as file:
            file["secret"] = numpy.full(4, SECRET) * [1, 1, 1, 0]
            file["cube"] = numpy.full((3, 3, 3), SECRET)
            file["cube"][0, 0, 0] = 0


# -- XML and lists of files of VTK -------------------------------------------------------------------------------------------------

LAUGHS = '<!DOCTYPE x [<!ENTITY a0 "ha">%s]>' % "".join('<!ENTITY a%d "%s">' % (n + 1, "&a%d;" % n * 10) for n in range(10))
LONG_ENTITY = '<!DOCTYPE x [<!ENTITY long "%s">]>' % ("x" * 100_000)
OUTSIDE_ENTITY = '<!DOCTYPE x [<!ENTITY out SYSTEM "%s">]>'


def collection(entries, before=""):
    return '<?xml version="1.0"?>%s<VTKFile type="Collection" version="0.1"><Collection>%s</Collection></VTKFile>' % (
        before, "".join('<DataSet timestep="%s" file="%s"/>' % entry for entry in entries))


def blocks(names, before=""):
    return ('<?xml version="1.0"?>%s<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>%s</vtkMultiBlockDataSet></VTKFile>'
            % (before, "".join('<DataSet index="%d" file="%s"/>' % (n, name) for n, name in enumerate(names))))


def parallel(source):
    return ('<VTKFile type="PImageData" version="0.1"><PImageData WholeExtent="0 1 0 1 0 1" GhostLevel="0" Origin="0 0 0" Spacing="1 1 1">'
            '<PPointData Scalars="secret"><PDataArray type="Float64" Name="secret"/></PPointData>'
            '<Piece Extent="0 1 0 1 0 1" Source="%s"/></PImageData></VTKFile>' % source)


def series(names):
    return json.dumps({"file-series-version": "1.0", "files": [{"name": name, "time": n} for n, name in enumerate(names)]})


OUTSIDE = "../secret.vtu", "%s/secret.vtu", "http://127.0.0.1:9/secret.vtu", "file://%s/secret.vtu", "/dev/zero", "pipe.vtu", "/proc/self/mem"


def naming(kind, ending, write_list, inner="secret.vtu"):
    """Lists that name files elsewhere, and what is no file."""
    for where in OUTSIDE:
        def write(folder, where=where):
            os.mkfifo(folder / "pipe.vtu")
            name = where.replace("%s", str(folder.parent)).replace("secret.vtu", inner)
            put(folder, "list" + ending, write_list(name))
        yield bomb("%s names %s" % (kind, where), "list" + ending, write)


def lists():
    yield from naming("pvd", ".pvd", lambda name: collection([(0, name)]))
    yield from naming("series", ".vtu.series", lambda name: series([name]))
    yield from naming("vtm", ".vtm", lambda name: blocks([name]))
    yield from naming("pvti", ".pvti", parallel, "secret.vti")
    yield bomb("pvd of itself", "a.pvd", **{"a.pvd": collection([(0, "a.pvd")])})
    yield bomb("pvd in a circle", "a.pvd", **{"a.pvd": collection([(0, "b.pvd")]), "b.pvd": collection([(0, "a.pvd")])})
    yield bomb("pvd, 20,000 steps that are missing", "a.pvd", **{"a.pvd": collection([(n, "%d.vtu" % n) for n in range(20_000)])})
    yield bomb("pvd, one file 20,000 times in a step", "a.pvd", **{"a.pvd": collection([(0, "b.vti")] * 20_000), "b.vti": good_vti(24)})
    yield bomb("pvd, laughs", "a.pvd", **{"a.pvd": collection([("&a10;", "b.vtu")], LAUGHS)})
    yield bomb("pvd, a long entity", "a.pvd", **{"a.pvd": collection([(0, "&long;" * 20_000)], LONG_ENTITY)})
    yield bomb("pvd, an entity from outside", "a.pvd", lambda folder: put(
        folder, "a.pvd", collection([("&out;", "b.vtu")], OUTSIDE_ENTITY % (folder.parent / "secret.txt"))))
    yield bomb("pvd, times that are none", "a.pvd", **{"a.pvd": collection([("1e999", "b.vtu"), ("nan", "b.vtu")])})
    yield bomb("series of itself", "a.vtm.series", **{"a.vtm.series": series(["a.vtm.series"])})
    yield bomb("series, nested brackets", "a.vtu.series", **{"a.vtu.series": '{"file-series-version": "1.0", "files": ' + "[" * 500_000})
    yield bomb("series, 100,000 steps", "a.vtu.series", **{"a.vtu.series": series(["b.vtu"] * 100_000)})
    yield bomb("vtm of itself, 1,000 times", "a.vtm", **{"a.vtm": blocks(["a.vtm"] * 1000)})
    yield bomb("vtm in a circle", "a.vtm", **{"a.vtm": blocks(["b.vtm"] * 50), "b.vtm": blocks(["a.vtm"] * 50)})
    yield bomb("vtm, one file 30,000 times", "a.vtm", **{"a.vtm": blocks(["b.vti"] * 30_000), "b.vti": good_vti(24)})
    yield bomb("vtm, laughs", "a.vtm", **{"a.vtm": blocks(["&a10;"], LAUGHS)})
    yield bomb("vtm, elements 100,000 deep", "a.vtm", **{"a.vtm": blocks([]).replace("</vtk", "<Block index='0'>" * 100_000 + "</vtk", 1)})
    yield bomb("vtm, an index of 4 billion", "a.vtm", **{"a.vtm": blocks(["b.vti"]).replace('"0"', '"4294967294"'), "b.vti": good_vti()})
    yield bomb("vti, an extent of 2^31", "a.vti", **{"a.vti": secret_vti().replace("0 1 0 1 0 1", "0 2147483646 0 2147483646 0 1")})
    yield bomb("vtu, counts of 10^18", "a.vtu", **{"a.vtu": secret_vtu().replace('OfPoints="4"', 'OfPoints="1000000000000000000"')})
    yield bomb("vtu, components of 10^9", "a.vtu", **{"a.vtu": secret_vtu().replace('Name="secret"', 'Name="secret" NumberOfComponents="1000000000"')})


# -- XDMF --------------------------------------------------------------------------------------------------------------------------

def xdmf(values='<DataItem Dimensions="4" Format="XML">1 2 3 4</DataItem>', before="", inside="", points=None):
    points = points or '<DataItem Dimensions="4 3" Format="XML">%s</DataItem>' % " ".join("%g %g %g" % corner for corner in CORNERS)
    return ('<?xml version="1.0"?>%s<Xdmf Version="3.0" xmlns:xi="http://www.w3.org/2001/XInclude"><Domain>%s<Grid Name="a"><Topology '
            'TopologyType="Tetrahedron" NumberOfElements="1"><DataItem Dimensions="1 4" DataType="Int" Format="XML">0 1 2 3</DataItem></Topology>'
            '<Geometry GeometryType="XYZ">%s</Geometry><Attribute Name="heat" Center="Node">%s</Attribute></Grid></Domain></Xdmf>'
            % (before, inside, points, values))


def data_item(text, form="HDF", dimensions="4"):
    return '<DataItem Dimensions="%s" DataType="Float" Precision="8" Format="%s">%s</DataItem>' % (dimensions, form, text)


def xdmf_beside(values, **more):
    """One whose path has that of the folder above in the place of %s."""
    def write(folder):
        files(**more)(folder)
        put(folder, "a.xdmf", xdmf(values.replace("%s", str(folder.parent))))
    return write


def xdmfs():
    for form, inside in (("HDF", "secret.h5:/secret"), ("Binary", "secret.bin"), ("XML", None)):
        if inside:
            yield bomb("xdmf, %s above" % form, "a.xdmf", xdmf_beside(data_item("../" + inside, form)))
            yield bomb("xdmf, %s by its whole path" % form, "a.xdmf", xdmf_beside(data_item("%s/" + inside, form)))
            yield bomb("xdmf, %s by a link" % form, "a.xdmf", xdmf_beside(data_item(inside, form), **{inside.split(":")[0]: ("../" + inside.split(":")[0],)}))
    yield bomb("xdmf, /dev/zero", "a.xdmf", xdmf_beside(data_item("/dev/zero", "Binary")))
    yield bomb("xdmf, a pipe", "a.xdmf", xdmf_beside(data_item("pipe", "Binary"), pipe=None))
    yield bomb("xdmf, a pipe for HDF5", "a.xdmf", xdmf_beside(data_item("pipe:/a"), pipe=None))
    yield bomb("xdmf, XInclude", "a.xdmf", **{"a.xdmf": xdmf(inside='<xi:include href="../secret.txt" parse="text"/>')})
    yield bomb("xdmf, XInclude in the values", "a.xdmf", **{"a.xdmf": xdmf(data_item('<xi:include href="../secret.txt" parse="text"/>', "XML"))})
    yield bomb("xdmf, laughs", "a.xdmf", **{"a.xdmf": xdmf(data_item("&a10;", "XML"), LAUGHS)})
    yield bomb("xdmf, a long entity", "a.xdmf", **{"a.xdmf": xdmf(data_item("&long;" * 20_000, "XML"), LONG_ENTITY)})
    yield bomb("xdmf, an entity from outside", "a.xdmf", lambda folder: put(
        folder, "a.xdmf", xdmf(data_item("&out;", "XML"), OUTSIDE_ENTITY % (folder.parent / "secret.txt"))))
    for size in ("1000000000000 3", "99999999999999999999 3", "-4 3", "4294967296 4294967296", " ".join(["2"] * 100_000)):
        yield bomb("xdmf, %s points" % size[:30], "a.xdmf", **{"a.xdmf": xdmf(points='<DataItem Dimensions="%s" Format="XML">0</DataItem>' % size)})
    yield bomb("xdmf, 10^12 values of 32 bytes", "a.xdmf", xdmf_beside(data_item("b", "Binary", "1000000000000"), b=b"\0" * 32))
    yield bomb("xdmf, elements 100,000 deep", "a.xdmf", **{"a.xdmf": xdmf(inside="<Grid>" * 100_000)})
    steps = "".join('<Grid><Time Value="%d"/><xi:include xpointer="xpointer(//Grid[@Name=&quot;a&quot;]/*)"/></Grid>' % n for n in range(20_000))
    yield bomb("xdmf, 20,000 steps", "a.xdmf", **{"a.xdmf": xdmf(inside='<Grid CollectionType="Temporal" GridType="Collection">%s</Grid>' % steps)})
    for name, add in outside_hdf5("values", (4,)):
        def write(folder, add=add):
            with h5py.File(folder / "b.h5", "w") as file:
                add(file, folder.parent / "secret.h5")
            put(folder, "a.xdmf", xdmf(data_item("b.h5:/values")))
        yield bomb("xdmf, HDF5 with " + name, "a.xdmf", write)


# -- HDF5: arrays, MED, CGNS, VTK HDF, NetCDF --------------------------------------------------------------------------------------

def outside_hdf5(name, shape, source="secret"):
    """Ways in which an array of an HDF5 file lies in another one."""
    if not h5py:
        return

    def virtual(file, other):
        layout = h5py.VirtualLayout(shape=shape, dtype="f8")
        layout[:] = h5py.VirtualSource(str(other), source, shape=shape)
        file.create_virtual_dataset(name, layout)

    yield "a link", lambda file, other: file.__setitem__(name, h5py.ExternalLink("../" + other.name, "/" + source))
    yield "a link by its whole path", lambda file, other: file.__setitem__(name, h5py.ExternalLink(str(other), "/" + source))
    yield "a virtual array", virtual
    yield "values elsewhere", lambda file, other: file.create_dataset(
        name, shape, "f8", external=[(str(other.with_name("secret.bin")), 0, h5py.h5f.UNLIMITED)])


def hdf5(write):
    def whole(folder):
        with h5py.File(folder / "a.h5", "w") as file:
            write(file)
    return whole


def gzip_bomb(file, path="a", shape=(1024, 1024, 4096), chunk=(1024, 1024, 256)):
    """An array of zeros whose only chunk that is there unpacks to a quarter of a gigabyte."""
    array = file.create_dataset(path, shape, "u1", chunks=chunk, compression="gzip")
    array.id.write_direct_chunk((0, 0, 0), zlib.compress(bytes(chunk[0] * chunk[1] * chunk[2]), 1))


def imaris(file):
    """As Imaris keeps a picture: levels, times, channels."""
    level = file.create_group("DataSet/ResolutionLevel 0/TimePoint 0/Channel 0")
    level.create_dataset("Data", (2 ** 20, 2 ** 20, 2 ** 20), "u2", chunks=(16, 16, 16))
    for axis in "XYZ":
        level.attrs["ImageSize" + axis] = numpy.frombuffer(b"1048576", "S1")
    file.create_group("DataSetInfo/Image").attrs["ExtMax0"] = numpy.frombuffer(b"1e308", "S1")


def nested_groups(file):
    group = file
    for _ in range(5000):
        group = group.create_group("g")
    group["a"] = numpy.zeros((3, 3, 3))


def ring(file):
    file["a/b/c"] = numpy.arange(27.).reshape(3, 3, 3)
    file["a/b/a"] = file["a"]
    file["a/x"] = h5py.SoftLink("/a/x")


def hdf5s():
    if not h5py:
        return
    for shape in ((2 ** 40, 2 ** 20, 2), (2 ** 20,) * 3, (2 ** 62, 2, 2), (3, 3, 2 ** 60)):
        yield bomb("hdf5, %s points" % "x".join(map(str, shape)), "a.h5",
                   hdf5(lambda file, shape=shape: file.create_dataset("a", shape, "f8", chunks=(2, 2, 2))))
    yield bomb("hdf5, chunks of 4 GB", "a.h5", hdf5(lambda file: file.create_dataset("a", (2 ** 20,) * 3, "u1", chunks=(1024, 1024, 4095))))
    yield bomb("hdf5, gzip", "a.h5", hdf5(gzip_bomb))
    yield bomb("hdf5, Imaris", "a.h5", hdf5(imaris))
    yield bomb("hdf5, groups 5,000 deep", "a.h5", hdf5(nested_groups))
    yield bomb("hdf5, in a circle", "a.h5", hdf5(ring))
    yield bomb("hdf5, 3,000 arrays", "a.h5", hdf5(lambda file: [file.create_dataset("a%d" % n, (3, 3, 3), "u1") for n in range(3000)]))
    yield bomb("hdf5, an axis of 2^40", "a.h5", hdf5(lambda file: file.create_dataset("a", (3, 3, 3), "f8").attrs.__setitem__(
        "element_size_um", numpy.array([1e308, 1e-308, numpy.inf]))))
    for ending, kind in ((".h5", "hdf5"), (".nc", "netcdf"), (".ims", "imaris")):
        for name, add in outside_hdf5("values", (3, 3, 3), "cube"):
            def write(folder, add=add, ending=ending):
                with h5py.File(folder / ("a" + ending), "w") as file:
                    add(file, folder.parent / "secret.h5")
            yield bomb("%s, %s" % (kind, name), "a" + ending, write)


def med(folder, change):
    """A mesh of a tetrahedron as Salome keeps it."""
    text = numpy.bytes_
    with h5py.File(folder / "a.med", "w") as file:
        info = file.create_group("INFOS_GENERALES")
        info.attrs.update({"MAJ": 3, "MIN": 0, "REL": 0})
        file.create_group("FAS/mesh")
        mesh = file.create_group("ENS_MAA/mesh")
        mesh.attrs.update({"DIM": 3, "ESP": 3, "REP": 0, "NOM": text("X Y Z"), "UNI": text(" "), "DES": text(" "),
                           "SRT": 1, "TYP": 0, "UNT": text(" "), "NXI": -1, "NXT": -1})
        step = mesh.create_group("-0000000000000000001-0000000000000000001")
        step.attrs.update({"CGT": 1, "NDT": -1, "NOR": -1, "PDT": -1.0, "NXI": -1, "NXT": -1, "PVI": -1, "PVT": -1})
        places = step.create_group("NOE").create_dataset("COO", data=numpy.array(CORNERS, "f8").T.ravel())
        places.attrs.update({"CGT": 1, "NBR": 4})
        cells = step.create_group("MAI/TE4").create_dataset("NOD", data=numpy.array([1, 2, 3, 4]))
        cells.attrs.update({"CGT": 1, "NBR": 1})
        field = file.create_group("CHA/heat")
        field.attrs.update({"MAI": text("mesh"), "NCO": 1, "NOM": text(" "), "TYP": 6, "UNI": text(" "), "UNT": text(" ")})
        place = field.create_group("0000000000000000000100000000000000000001/NOE")
        field["0000000000000000000100000000000000000001"].attrs.update({"NDT": 1, "NOR": 1, "PDT": 0.0, "RDT": -1, "ROR": -1})
        place.attrs.update({"GAU": text(" "), "PFL": text("MED_NO_PROFILE_INTERNAL")})
        profile = place.create_group("MED_NO_PROFILE_INTERNAL")
        profile.attrs.update({"NBR": 4, "NGA": 1, "GAU": text(" ")})
        profile["CO"] = numpy.array([1., 2, 3, 4])
        change(file, step, profile)


def cgns_node(parent, name, label, data=None):
    node = parent.create_group(name, track_order=True)
    data = numpy.frombuffer(data.encode(), "i1") if isinstance(data, str) else data
    kind = "MT" if data is None else {"i1": "C1", "i4": "I4", "i8": "I8", "f4": "R4", "f8": "R8"}[data.dtype.str[1:]]
    for key, text, length in (("name", name, 33), ("label", label, 33), ("type", kind, 3)):
        node.attrs.create(key, numpy.bytes_(text), dtype=h5py.string_dtype("ascii", length))
    node.attrs["flags"] = numpy.array([1], "i4")
    if data is not None:
        node.create_dataset(" data", data=data)
    return node


def cgns(folder, size, change=None, claimed=None):
    """A grid of 3 x 3 x 3 points whose zone says another size."""
    with h5py.File(folder / "a.cgns", "w", track_order=True, libver=("earliest", "latest")) as file:
        for key, text, length in (("name", "HDF5 MotherNode", 33), ("label", "Root Node of HDF5 File", 33), ("type", "MT", 3)):
            file.attrs.create(key, numpy.bytes_(text), dtype=h5py.string_dtype("ascii", length))
        file.create_dataset(" format", data=numpy.frombuffer(b"IEEE_LITTLE_32\0", "i1"))
        file.create_dataset(" hdf5version", data=numpy.frombuffer(b"HDF5 Version 1.10.8".ljust(33, b"\0"), "i1"))
        cgns_node(file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", numpy.array([3.1], "f4"))
        base = cgns_node(file, "Base", "CGNSBase_t", numpy.array([3, 3], "i4"))
        zone = cgns_node(base, "Zone", "Zone_t", numpy.array([size, [n - 1 for n in size], [0, 0, 0]], claimed or "i4"))
        cgns_node(zone, "ZoneType", "ZoneType_t", "Structured")
        grid = cgns_node(zone, "GridCoordinates", "GridCoordinates_t")
        places = numpy.mgrid[0:3., 0:3., 0:3.]
        for axis in range(3):
            cgns_node(grid, "Coordinate" + "XYZ"[axis], "DataArray_t", numpy.ascontiguousarray(places[2 - axis]))
        flow = cgns_node(zone, "FlowSolution", "FlowSolution_t")
        node = cgns_node(flow, "Density", "DataArray_t", numpy.arange(27.).reshape(3, 3, 3))
        if change:
            change(file, flow, node)


def vtkhdf(folder, change=lambda file, group: None, extent=(0, 2, 0, 2, 0, 2)):
    with h5py.File(folder / "a.vtkhdf", "w") as file:
        group = file.create_group("VTKHDF")
        group.attrs["Version"] = numpy.array([1, 0])
        group.attrs["Type"] = numpy.bytes_("ImageData")
        group.attrs["WholeExtent"] = numpy.array(extent)
        group.attrs["Origin"], group.attrs["Spacing"] = numpy.zeros(3), numpy.ones(3)
        group.attrs["Direction"] = numpy.eye(3).ravel()
        group.create_group("PointData")
        change(file, group)
        if "values" not in group["PointData"]:
            group["PointData/values"] = numpy.arange(27.).reshape(3, 3, 3)


def unstructured_hdf(folder, **counts):
    with h5py.File(folder / "a.vtkhdf", "w") as file:
        group = file.create_group("VTKHDF")
        group.attrs["Version"], group.attrs["Type"] = numpy.array([1, 0]), numpy.bytes_("UnstructuredGrid")
        for name, data in {"NumberOfPoints": [4], "NumberOfCells": [1], "NumberOfConnectivityIds": [4], **counts}.items():
            group[name] = numpy.array(data)
        group["Points"], group["Types"] = numpy.array(CORNERS, "f8"), numpy.array([10], "u1")
        group["Connectivity"], group["Offsets"] = numpy.arange(4), numpy.array([0, 4])
        group["PointData/values"] = numpy.arange(4.)


def solvers_hdf5():
    if not h5py:
        return
    none = lambda *of: None
    for number in (10 ** 12, 2 ** 62, -4, 0):
        yield bomb("med, %d points" % number, "a.med", lambda folder, number=number: med(
            folder, lambda file, step, profile: step["NOE/COO"].attrs.__setitem__("NBR", number)))
        yield bomb("med, %d values" % number, "a.med", lambda folder, number=number: med(
            folder, lambda file, step, profile: profile.attrs.update({"NBR": number, "NGA": number})))
    yield bomb("med, corners beyond the points", "a.med", lambda folder: med(
        folder, lambda file, step, profile: step["MAI/TE4/NOD"].write_direct(numpy.array([1, 2, 3, 2 ** 62]))))
    yield bomb("med, chunks that unpack to much", "a.med", lambda folder: med(folder, lambda file, step, profile: (
        step["NOE"].__delitem__("COO"), step["NOE"].create_dataset("COO", (2 ** 36,), "f8", chunks=(2 ** 16,)).attrs.update({"CGT": 1, "NBR": 4}))))
    for size, kind in (((2 ** 31 - 1,) * 3, "i4"), ((2 ** 40, 2 ** 20, 2), "i8"), ((0, 0, 0), "i4"), ((-3, 3, 3), "i4"), ((4, 4, 4), "i4")):
        yield bomb("cgns, a zone of %s" % "x".join(map(str, size)), "a.cgns", lambda folder, size=size, kind=kind: cgns(folder, size, claimed=kind))
    yield bomb("cgns, an array that does not end", "a.cgns", lambda folder: cgns(folder, (3, 3, 3), lambda file, flow, node: (
        node.__delitem__(" data"), node.create_dataset(" data", (2 ** 20,) * 3, "f8", chunks=(16, 16, 16)))))
    yield bomb("cgns, in a circle", "a.cgns", lambda folder: cgns(folder, (3, 3, 3), lambda file, flow, node: flow.__setitem__("Ring", file["Base"])))
    for kind, write in (("med", None), ("cgns", None), ("vtkhdf", None)):
        for name, add in outside_hdf5({"med": "CO", "cgns": " data", "vtkhdf": "values"}[kind], {"med": (4,)}.get(kind, (3, 3, 3)),
                                      {"med": "secret"}.get(kind, "cube")):
            def write(folder, kind=kind, add=add):
                other = folder.parent / "secret.h5"
                if kind == "med":
                    med(folder, lambda file, step, profile: (profile.__delitem__("CO"), add(profile, other)))
                elif kind == "cgns":
                    cgns(folder, (3, 3, 3), lambda file, flow, node: (node.__delitem__(" data"), add(node, other)))
                else:
                    vtkhdf(folder, lambda file, group: add(group["PointData"], other))
            yield bomb("%s, %s" % (kind, name), "a." + kind, write)
    yield bomb("vtkhdf, an extent of 2^31", "a.vtkhdf", lambda folder: vtkhdf(folder, extent=(0, 2 ** 31 - 2) * 3))
    yield bomb("vtkhdf, an extent that ends before it begins", "a.vtkhdf", lambda folder: vtkhdf(folder, extent=(5, -5) * 3))
    yield bomb("vtkhdf, gzip", "a.vtkhdf", lambda folder: vtkhdf(
        folder, lambda file, group: gzip_bomb(group, "PointData/values"), extent=(0, 4095, 0, 1023, 0, 1023)))
    for counts in ({"NumberOfPoints": [2 ** 62]}, {"NumberOfCells": [2 ** 62]}, {"NumberOfConnectivityIds": [2 ** 62]}, {"NumberOfPoints": [-4]},
                   {"NumberOfPoints": [4] * 100_000}, {"NumberOfPoints": []}):
        yield bomb("vtkhdf, %s" % json.dumps(counts)[:50], "a.vtkhdf", lambda folder, counts=counts: unstructured_hdf(folder, **counts))


# -- solvers' texts ----------------------------------------------------------------------------------------------------------------

def case(model="run.geo", values="run.heat", time="", kind="ensight gold"):
    return "FORMAT\ntype: %s\nGEOMETRY\nmodel: %s\nVARIABLE\nscalar per node: heat %s\n%s" % (kind, model, values, time)


def ensight(name, change_case=None, geometry=None, heat=None, **more):
    return bomb("ensight, " + name, "run.case", **{"run.case": change_case or case(), "run.geo": geometry or gold_geometry(),
                                                   "run.heat": heat or gold_values(), **more})


def ensights():
    for name, model in (("above", "../secret.geo"), ("/dev/zero", "/dev/zero"), ("itself", "run.case"), ("a folder", "."), ("missing", "none.geo")):
        yield ensight("geometry " + name, case(model))
    yield ensight("geometry a pipe", case("pipe"), pipe=None)
    yield ensight("values above", case(values="../secret.heat"))
    yield ensight("a comment that made the checks pass it over", "# master_server\n" + case("../secret.geo", "../secret.heat"))
    yield bomb("ensight, all above by its whole path", "run.case", lambda folder: put(
        folder, "run.case", case(folder.parent / "secret.geo", folder.parent / "secret.heat")))
    steps = "TIME\ntime set: 1\nnumber of steps: %s\nfilename start number: %s\nfilename increment: %s\ntime values: 0\n"
    yield ensight("10^9 steps", case("run.geo", "1 run.heat****", steps % (10 ** 9, 0, 1)))
    yield ensight("10^7 steps", case("run.geo", "1 run.heat****", steps % (10 ** 7, 0, 1)))
    yield ensight("numbers of files that overflow", case("run.geo", "1 run.heat****", steps % (3, 2 ** 63 - 1, 2 ** 63 - 1) + "1 2\n"))
    yield ensight("100,000 stars", case("*" * 100_000))
    yield ensight("a name of 1 MB", case("a" * 1_000_000))
    yield ensight("100,000 variables", case() + "".join("scalar per node: v%d run.heat\n" % n for n in range(100_000)))
    for count in (10 ** 18, 2 ** 31 - 1, -1, 2 ** 64):
        yield ensight("%d points" % count, geometry=gold_geometry(count))
        yield ensight("%d points, 6" % count, case(kind="ensight"), "a\nb\nnode id off\nelement id off\ncoordinates\n%d\n" % count)
    yield ensight("blocks of 2^31", geometry="a\nb\nnode id off\nelement id off\npart\n1\nblock\nblock\n2147483647 2147483647 2147483647\n")
    head = b"".join(text.ljust(80, b" ") for text in (b"C Binary", b"a", b"b", b"node id off", b"element id off", b"part"))
    binary = head + struct.pack("<i", 1) + b"part".ljust(80) + b"coordinates".ljust(80)
    for count in (2 ** 31 - 1, -1, 10 ** 8):
        yield ensight("binary, %d points" % count, geometry=binary + struct.pack("<i", count) + b"\0" * 48)
    yield ensight("binary, part 2^31 - 1", geometry=head + struct.pack("<i", 2 ** 31 - 1) + b"part".ljust(80) + b"coordinates".ljust(80) + struct.pack("<i", 1))


def tecplot(zone, values="", variables='"x" "y" "z" "v"'):
    return 'TITLE = "a"\nVARIABLES = %s\nZONE %s\n%s\n' % (variables, zone, values)


def tecplots():
    cube = "\n".join("%d %d %d 1" % (i, j, k) for k in range(2) for j in range(2) for i in range(2))
    for zone in ("I=1000000, J=1000000, K=1000000, F=POINT", "I=4294967296, J=4294967296, F=POINT", "I=-2, J=-2, K=2, F=POINT",
                 "I=0, J=0, K=0, F=BLOCK", "N=1000000000, E=1000000000, ET=BRICK, F=FEPOINT", "N=8, E=2000000000, ET=BRICK, F=FEBLOCK",
                 "ZONETYPE=FEPOLYHEDRON, N=8, E=1, FACES=4000000000", "I=2, J=2, K=2, F=POINT, VARLOCATION=([1-1000000000]=CELLCENTERED)",
                 "I=2, J=2, K=2, F=POINT, VARSHARELIST=([1-4000000000]=1)", "I=2, J=2, K=2, F=POINT, PASSIVEVARLIST=[1-99999999999999999999]",
                 "I=2, J=2, K=2, F=POINT, VARLOCATION=(" + "[" * 100_000):
        yield bomb("tecplot, " + zone[:60], "a.tec", **{"a.tec": tecplot(zone, cube)})
    yield bomb("tecplot, a number 10^9 times", "a.tec", **{"a.tec": tecplot("I=1000, J=1000, K=1000, F=BLOCK", "4000000000*1")})
    yield bomb("tecplot, 100,000 zones", "a.tec", **{"a.tec": tecplot("I=1, J=1, K=1", "0 0 0 1") + "ZONE I=1, J=1, K=1\n0 0 0 1\n" * 100_000})
    yield bomb("tecplot, 50,000 variables, 20,000 zones", "a.tec", **{"a.tec": tecplot(
        "I=0, J=0, K=0", variables='"x" "y" "z" ' + " ".join('"%d"' % n for n in range(50_000))) + "ZONE I=0, J=0, K=0\n" * 20_000})
    yield bomb("tecplot, binary", "a.plt", **{"a.plt": b"#!TDV112" + struct.pack("<5i", 1, 0, 2 ** 31 - 1, 2 ** 31 - 1, 2 ** 31 - 1)})


def foam_head(kind, name, form="ascii"):
    return "FoamFile\n{\n version 2.0;\n format %s;\n class %s;\n object %s;\n}\n" % (form, kind, name)


def foam_field(values):
    return "dimensions [0 0 0 0 0 0 0];\ninternalField %s;\nboundaryField\n{\n    walls { type zeroGradient; }\n}\n" % values


def foam(name, heat=None, **changed):
    faces = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
    mesh = "constant__polyMesh__"
    whole = {
        "a.foam": "", "system__controlDict": foam_head("dictionary", "controlDict") + "startTime 0;\nendTime 1;\ndeltaT 1;\nwriteInterval 1;\n",
        mesh + "points": foam_head("vectorField", "points") + "4(%s)\n" % "".join("(%g %g %g)" % corner for corner in CORNERS),
        mesh + "faces": foam_head("faceList", "faces") + "4(%s)\n" % "".join("3(%d %d %d)" % face for face in faces),
        mesh + "owner": foam_head("labelList", "owner") + "4(0 0 0 0)\n", mesh + "neighbour": foam_head("labelList", "neighbour") + "0()\n",
        mesh + "boundary": foam_head("polyBoundaryMesh", "boundary") + "1(walls { type wall; nFaces 4; startFace 0; })\n",
        "0__T": foam_head("volScalarField", "T") + (heat or foam_field("uniform 1"))}
    whole.update({key.replace("MESH__", mesh): value for key, value in changed.items()})
    return bomb("openfoam, " + name, "a.foam", **whole)


def foams():
    points = foam_head("vectorField", "points")
    for what in ('"../../secret.foam"', '"/dev/zero"', '"T"', '"/proc/self/environ"', '"$HOME/.bashrc"', '"~/.bashrc"', '"none"', '"pipe"'):
        yield foam("#include " + what, "#include %s\n" % what + foam_field("uniform 1"), **({"0__pipe": None} if what == '"pipe"' else {}))
        yield foam("#include %s in the controls" % what, system__controlDict=foam_head("dictionary", "controlDict") + "#include %s\n" % what)
    yield bomb("openfoam, #include by its whole path", "a.foam", lambda folder: foam(
        "", '#include "%s"\n' % (folder.parent / "secret.foam"))[2](folder))
    for what in ('#includeEtc "caseDicts"', '#calc "1 + 1"', '#codeStream { code #{ system("touch made"); #}; }', "#inputMode merge", "#remove walls", "#eval{ 1 }"):
        yield foam(what[:20], what + ";\n" + foam_field("uniform 1"))
    yield foam("values from a #calc", foam_field('#calc "3"'))
    for count in (10 ** 12, 2 ** 31 - 1, -1, 2 ** 64):
        yield foam("%d points" % count, MESH__points=points + "%d((0 0 0))\n" % count)
        yield foam("%d faces" % count, MESH__faces=foam_head("faceList", "faces") + "%d(3(0 1 2))\n" % count)
        yield foam("%d values" % count, foam_field("nonuniform List<scalar> %d(1)" % count))
        yield foam("%d equal points" % count, MESH__points=points + "%d{(0 0 0)}\n" % count)
    yield foam("binary, 10^9 points", MESH__points=foam_head("vectorField", "points", "binary") + "1000000000(")
    yield foam("a face of 10^9 corners", MESH__faces=foam_head("faceList", "faces") + "4(1000000000(0 1 2) 3(0 1 3) 3(1 2 3) 3(0 3 2))\n")
    yield foam("corners beyond the points", MESH__faces=foam_head("faceList", "faces") + "4(3(0 1 99999999) 3(0 1 -3) 3(1 2 3) 3(0 3 2))\n")
    yield foam("owners beyond the cells", MESH__owner=foam_head("labelList", "owner") + "4(0 0 0 2000000000)\n")
    yield foam("brackets 100,000 deep", foam_head("dictionary", "T") + "a " + "(" * 100_000)
    yield foam("dictionaries 100,000 deep", "a {" * 100_000)
    yield foam("patches of 2^31 faces", MESH__boundary=foam_head("polyBoundaryMesh", "boundary") + "1(walls { type wall; nFaces 2147483647; startFace 2147483647; })\n")
    yield foam("10^9 patches", MESH__boundary=foam_head("polyBoundaryMesh", "boundary") + "1000000000(walls { type wall; nFaces 4; startFace 0; })\n")
    for name in ("points", "faces", "owner"):
        yield foam("a pipe for the %s" % name, **{"MESH__" + name: None})
    yield foam("a pipe for the values", **{"0__T": None, "0__p": None})
    yield foam("a device for the points", MESH__points=("/dev/zero",))
    yield foam("10^7 steps in the controls", system__controlDict=foam_head("dictionary", "controlDict") + "startTime 0;\nendTime 1e7;\ndeltaT 1e-3;\n"
               "writeControl timeStep;\nwriteInterval 1;\n")


def fluents():
    def cas(nodes="4", cells="1", faces="4"):
        points = "\n".join("%g %g %g" % corner for corner in CORNERS)
        return ("(0 \"a\")\n(2 3)\n(10 (0 1 %s 0 3))\n(10 (1 1 %s 1 3)(\n%s))\n(12 (0 1 %s 0))\n(12 (2 1 %s 1 2))\n(13 (0 1 %s 0))\n"
                "(13 (3 1 %s 3 3)(\n1 3 2 1 0\n1 2 4 1 0\n2 3 4 1 0\n1 4 3 1 0))\n(45 (2 fluid inside)())\n" % (
                    nodes, nodes, points, cells, cells, faces, faces))

    dat = '(33 (1 1 1))\n(300 (1 2 1 0 0 1 1)(\n7\n))\n'
    for name, changed in (("nodes", {"nodes": "ffffffff"}), ("nodes of 2^31", {"nodes": "7fffffff"}), ("cells", {"cells": "7fffffff"}),
                          ("faces", {"faces": "7fffffff"}), ("cells of 2^28", {"cells": "10000000"}), ("no nodes", {"nodes": "0"}), ("nodes of 16 digits", {"nodes": "f" * 16})):
        yield bomb("fluent, " + name, "a.cas", **{"a.cas": cas(**changed), "a.dat": dat})
    yield bomb("fluent, 2^31 values", "a.cas", **{"a.cas": cas(), "a.dat": dat.replace("1 1)(", "1 7fffffff)(")})
    yield bomb("fluent, a field of 10^9 components", "a.cas", **{"a.cas": cas(), "a.dat": dat.replace("2 1 0 0", "2 1000000000 0 0")})
    yield bomb("fluent, 100,000 brackets", "a.cas", **{"a.cas": "(" * 100_000 + ")" * 100_000, "a.dat": dat})
    yield bomb("fluent, binary nodes", "a.cas", **{"a.cas": "(3010 (1 1 7fffffff 1 3)(\0\0\0\0End of Binary Section   3010)\n" + cas(), "a.dat": dat})
    yield bomb("fluent, a pipe for the values", "a.cas", **{"a.cas": cas(), "a.dat": None})
    yield bomb("fluent, corners of nowhere", "a.cas", **{"a.cas": cas().replace("1 3 2 1 0", "7ffffff 3 2 1 0"), "a.dat": dat})
    yield bomb("gambit, 2^31 nodes", "a.neu", **{"a.neu": "        CONTROL INFO 2.3.16\n** GAMBIT NEUTRAL FILE\na\nPROGRAM: Gambit VERSION: 2\n\n NUMNP NELEM NGRPS NBSETS "
                                                 "NDFCD NDFVL\n 2147483647 2147483647 1 0 3 3\nENDOFSECTION\n"})


def plot3ds():
    for dims in ("1000000 1000000 1000000", "2147483647 2147483647 2147483647", "4294967296 4294967296 1", "-2 -2 -2", "0 0 0"):
        yield bomb("plot3d, text, " + dims, "a.xyz", **{"a.xyz": dims + "\n0 0 0\n", "a.q": dims + "\n0 0 0 0\n1 2 3 4 5\n"})
        numbers = [max(-2 ** 31, min(2 ** 31 - 1, int(word))) for word in dims.split()]
        for mark in (False, True):
            def record(content, mark=mark):
                length = struct.pack("<i", len(content)) if mark else b""
                return length + content + length
            grid = record(struct.pack("<3i", *numbers)) + record(b"\0" * 96)
            yield bomb("plot3d, binary%s, %s" % (" with marks" if mark else "", dims), "a.xyz", **{
                "a.xyz": grid, "a.q": record(struct.pack("<3i", *numbers)) + record(b"\0" * 16) + record(b"\0" * 160)})
    for count in (10 ** 9, 2 ** 31 - 1, -5):
        yield bomb("plot3d, %d grids" % count, "a.xyz", **{"a.xyz": struct.pack("<4i", count, 2, 2, 2) + b"\0" * 96, "a.q": struct.pack("<4i", count, 2, 2, 2) + b"\0" * 200})
        yield bomb("plot3d, text, %d grids" % count, "a.xyz", **{"a.xyz": "%d\n2 2 2\n" % count + "0 " * 24, "a.q": "%d\n2 2 2\n" % count + "0 " * 44})
    yield bomb("plot3d, a number 10^9 times", "a.xyz", **{"a.xyz": "1000 1000 1000\n3000000000*0\n", "a.q": "1000 1000 1000\n4*0\n5000000000*0\n"})
    yield bomb("plot3d, a pipe for the solution", "a.xyz", **{"a.xyz": "2 2 2\n" + "0 " * 24, "a.q": None})


def tables():
    def sparse(size, head=b""):
        def write(folder):
            with open(folder / "a.csv", "wb") as file:
                file.write(head)
                file.truncate(size)
        return write

    def rows(names=""):
        return names + "\n".join([",".join(map(str, range(1_000_000)))] * 4)

    yield bomb("table, a line of 1 GB", "a.csv", sparse(1 << 30, b"x,y,z,v\n0,0,0,"))
    yield bomb("table, 1 GB without text", "a.csv", sparse(1 << 30))
    yield bomb("table, 1 TB without text", "a.csv", sparse(1 << 40, b"x,y,z,v\n"))
    yield bomb("table, a word of 64 MB", "a.csv", **{"a.csv": lambda: "x,y,z,v\n0,0,0," + "7" * (64 << 20)})
    yield bomb("table, a name of 64 MB", "a.csv", **{"a.csv": lambda: "x,y,z," + "v" * (64 << 20) + "\n0,0,0,1\n"})
    yield bomb("table, a million columns", "a.csv", **{"a.csv": rows})
    yield bomb("table, a million columns with names", "a.csv", **{"a.csv": lambda: rows(",".join("n%d" % n for n in range(1_000_000)) + "\n")})
    yield bomb("table, zero bytes between", "a.csv", **{"a.csv": b"x,y,z,v\n" + b"0,0,0,1\0\n\0,1,0,2\n0,0\0,1,3\n1,1,1,4\n"})
    yield bomb("table, two million empty lines", "a.csv", **{"a.csv": lambda: "\n" * 2_000_000})
    yield bomb("table, quotes without end", "a.csv", **{"a.csv": lambda: 'x,y,z,v\n0,0,0,"' + '""\n' * 500_000})
    yield bomb("table, long numbers", "a.csv", **{"a.csv": lambda: "x,y,z,v\n" + "0,0,0,0.%s\n" % ("1" * 100_000) * 50})
    yield bomb("table, exponents", "a.csv", **{"a.csv": "x,y,z,v\n1e308,0,0,1\n-1e308,0,0,2\n0,1e308,0,3\n0,0,1e308,1e999\n1,1,1,-1e308\n"})
    yield bomb("table, 2 million equal points", "a.csv", **{"a.csv": lambda: "x,y,z,v\n" + "0,0,0,1\n" * 2_000_000})


# -- Zarr --------------------------------------------------------------------------------------------------------------------------

def zarray(**changed):
    return json.dumps({"zarr_format": 2, "shape": [2, 2, 2], "chunks": [2, 2, 2], "dtype": "<f8", "order": "C", "fill_value": 0, "compressor": None,
                       "filters": None, **changed})


def zarr3(codecs=({"name": "bytes", "configuration": {"endian": "little"}},), shape=(2, 2, 2), chunk=(2, 2, 2), **changed):
    return json.dumps({"zarr_format": 3, "node_type": "array", "shape": shape, "data_type": "float64", "fill_value": 0, "chunk_grid": {
        "name": "regular", "configuration": {"chunk_shape": chunk}}, "chunk_key_encoding": {"name": "default"}, "codecs": codecs, **changed})


def shards(outer, inner):
    whole = {"name": "bytes", "configuration": {"endian": "little"}}
    return ({"name": "sharding_indexed", "configuration": {"chunk_shape": inner, "codecs": [whole], "index_codecs": [whole]}},), outer


def zarr(name, metadata, chunk=struct.pack("<8d", *range(8)), **more):
    """Opened by its metadata, in a folder of its own."""
    is_3 = '"zarr_format": 3' in metadata
    opened = "a.zarr/zarr.json" if is_3 else "a.zarr/.zarray"
    return bomb("zarr, " + name, opened, **{opened.replace("/", "__"): metadata, "a.zarr__c__0__0__0" if is_3 else "a.zarr__0.0.0": chunk, **more})


def zarrs():
    for shape in ([2 ** 40] * 3, [2 ** 31 - 1] * 3, [2 ** 62, 2, 2], [0, 2, 2], [2] * 40, [2 ** 21] * 3):
        yield zarr("%s points" % "x".join(map(str, shape))[:40], zarray(shape=shape, chunks=[max(1, min(size, 2 ** 20)) for size in shape]))
    for chunk in ([2 ** 40, 1, 1], [2 ** 20] * 3, [2 ** 62, 2, 2], [2 ** 33, 1, 1]):
        yield zarr("chunks of %s" % "x".join(map(str, chunk)), zarray(chunks=chunk))
        yield zarr("packed chunks of %s" % "x".join(map(str, chunk)), zarray(chunks=chunk, compressor={"id": "zlib"}), zlib.compress(b"\0" * 64))
        yield zarr("3, chunks of %s" % "x".join(map(str, chunk)), zarr3(chunk=chunk))
    yield zarr("2^24 chunks", zarray(shape=[256] * 3, chunks=[1] * 3), struct.pack("<d", 1))
    yield zarr("2^24 chunks, none there", zarray(shape=[256] * 3, chunks=[1] * 3), **{"a.zarr__0.0.0": b""})
    yield zarr("chunks of 1 GB of which one number is wanted", zarray(shape=[4] * 3, chunks=[512] * 3, compressor={"id": "zlib"}),
               lambda: zlib.compress(bytes(1 << 30), 1))
    yield zarr("zlib that unpacks to more than it says", zarray(compressor={"id": "zlib"}), lambda: zlib.compress(bytes(64 << 20), 9))
    yield zarr("400 times packed", zarr3([{"name": "bytes", "configuration": {"endian": "little"}}] + [{"name": "gzip", "configuration": {}}] * 400))
    yield zarr("200,000 times packed", zarr3([{"name": "bytes", "configuration": {"endian": "little"}}] + [{"name": "crc32c"}] * 200_000))
    yield zarr("100,000 filters", zarray(filters=[{"id": "shuffle", "elementsize": 8}] * 100_000))
    yield zarr("a codec that nobody knows", zarr3([{"name": "bytes", "configuration": {"endian": "little"}}, {"name": "numcodecs.bz2"}]))
    yield zarr("a frame of Zstandard of 2^62 bytes", zarray(compressor={"id": "zstd"}), b"\x28\xb5\x2f\xfd\xe0" + struct.pack("<Q", 2 ** 62) + b"\1\0\0")
    yield zarr("Blosc of 2 GB", zarray(compressor={"id": "blosc"}), struct.pack("<4B3I", 2, 1, 0x21, 8, 2 ** 31 - 1, 2 ** 31 - 1, 20) + b"\0\0\0\0")
    for outer, inner in (((2 ** 20,) * 3, (1, 1, 1)), ((2 ** 40, 2, 2), (2, 2, 2)), ((4, 4, 4), (1, 1, 1))):
        codecs, grid = shards(outer, inner)
        yield zarr("shards of %s" % "x".join(map(str, outer)), zarr3(codecs, shape=(4, 4, 4), chunk=grid), struct.pack("<2Q", 0, 2 ** 63) * 64)
    yield zarr("brackets 500,000 deep", '{"zarr_format": 2, "shape": ' + "[" * 500_000)
    yield zarr("10^400", zarray().replace("[2, 2, 2]", "[1e400, 2, 2]", 1))
    yield zarr("a pipe for a chunk", zarray(), None)
    yield zarr("a chunk by a link above", zarray(), ("../../chunks/0.0.0",))
    yield zarr("a chunk that is a device", zarray(), ("/dev/zero",))
    yield zarr("chunks in a folder above", zarr3(), **{"a.zarr__c__0__0__0": b"", "a.zarr__zarr.json": zarr3().replace('"default"', '"../../chunks"')})
    image = '{"multiscales": [{"version": "0.4", "axes": ["z", "y", "x"], "datasets": [{"path": "%s"}]}]}'
    for path in ("../../chunks", "/etc", ".", "", "0/" * 5000, "0\\u0000"):
        yield bomb("zarr, an image whose level is '%s'" % path[:20], "a.zarr/.zattrs", **{
            "a.zarr__.zattrs": image % path, "a.zarr__.zgroup": '{"zarr_format": 2}', "a.zarr__0__.zarray": zarray()})

    def nested(folder):
        place = folder / "a.zarr"
        for _ in range(400):
            put(place, ".zgroup", '{"zarr_format": 2}')
            place = place / "g"
        put(place, ".zarray", zarray())

    def many(folder):
        put(folder, "a.zarr/.zgroup", '{"zarr_format": 2}')
        for number in range(6000):
            put(folder, "a.zarr/%d/.zarray" % number, zarray())

    def round_about(folder):
        put(folder, "a.zarr/.zgroup", '{"zarr_format": 2}')
        os.symlink(".", folder / "a.zarr/self")
        os.symlink("..", folder / "a.zarr/above")

    yield bomb("zarr, groups 400 deep", "a.zarr/.zgroup", nested)
    yield bomb("zarr, 6,000 arrays", "a.zarr/.zgroup", many)
    yield bomb("zarr, links in a circle", "a.zarr/.zgroup", round_about)


KINDS = {"lists": lists, "xdmf": xdmfs, "hdf5": hdf5s, "med, cgns, vtk hdf": solvers_hdf5, "ensight": ensights, "tecplot": tecplots, "openfoam": foams,
         "fluent": fluents, "plot3d": plot3ds, "tables": tables, "zarr": zarrs}


def all_bombs():
    """One after the other, and none kept: some are large."""
    return ((kind, *one) for kind, make in KINDS.items() for one in make())
