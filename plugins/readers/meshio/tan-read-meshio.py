#!/usr/bin/python3 -I
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program in which meshio reads a mesh for the plugin: takes one request from its input and writes messages to its output, as
plugins/process/exchange.h says. It may break down: the plugin bears that. `python3 -I` takes no module from where the data lie.

Sentences are those of meshio_texts.h, which are translated."""
import ctypes
import mmap
import os
import re
import resource
import signal
import struct
import sys

LIMIT_NOTE = "\ntan-read met a limit: "  # limitNote
PROGRESS, ERROR, FINDINGS, CONTENTS = b"p", b"e", b"f", b"c"
CELLS = 2  # FoundKind::Cells
IRREGULAR = 2  # DomainClass
BAD_INPUT, WRONG_USAGE = "BadInput", "WrongUsage"
ARRAY, COMPONENT, TIME_STEP = 0, 1, 6  # TakenPart

# CellShape of each of meshio's types of cells that has a volume, and how many of its nodes that shape has.
SHAPES = {
    "tetra": (0, 4), "pyramid": (1, 5), "wedge": (2, 6), "hexahedron": (3, 8), "tetra10": (5, 10), "pyramid13": (6, 13),
    "pyramid14": (6, 13), "wedge15": (7, 15), "wedge18": (7, 15), "hexahedron20": (8, 20), "hexahedron24": (8, 20),
    "hexahedron27": (9, 27)}
FLAT = 11
FLAT_TYPES = ("vertex", "line", "line3", "triangle", "triangle6", "triangle7", "quad", "quad8", "quad9", "polygon")
# Numbers of groups, which are taken only if they are asked for by name.
HELPING = ("ref", "tag", "tags", "physical", "geometrical", "cell_ids", "id", "ids", "group", "groups")


class Refusal(Exception):
    """What is wrong with the file, or with what is asked of it: a sentence with its arguments."""

    def __init__(self, sentence, *arguments, kind=BAD_INPUT):
        super().__init__(sentence)
        self.sentence, self.arguments, self.kind = sentence, arguments, kind


# -- the exchange ------------------------------------------------------------------------------------------------------

def text(value):
    data = value.encode("utf-8", "replace")
    return struct.pack("=Q", len(data)) + data


def filled(sentence, arguments):
    return re.sub("%([1-9])", lambda place: str(arguments[int(place[1]) - 1]), sentence)


def message(sentence, *arguments):
    """A Message of a sentence with its arguments."""
    said = text(filled(sentence, arguments)) + text(sentence) + struct.pack("=Q", len(arguments))
    return said + b"".join(plain(str(argument)) for argument in arguments)


def plain(words):
    """A Message of what every language has in common: a name, a number."""
    return text(words) + text("") + struct.pack("=Q", 0)


def listed(items):
    return struct.pack("=Q", len(items)) + b"".join(items)


def taken(part, what, guessed):
    return struct.pack("=B", part) + what + struct.pack("=?", guessed)


class Input:
    def __init__(self, stream):
        self.stream = stream

    def number(self, kind):
        return struct.unpack("=" + kind, self.stream.read(struct.calcsize("=" + kind)))[0]

    def words(self):
        return self.stream.read(self.number("Q")).decode("utf-8", "surrogateescape")


class Request:
    """MeshioRequest, member by member."""

    def __init__(self, stream):
        given = Input(stream)
        self.contents_only = given.number("?")
        self.path = given.words()
        self.format = given.words()
        self.array = given.words()
        self.component = given.words()
        asked_for = given.number("q")
        self.step, self.step_is_guessed = max(1, asked_for), asked_for == 0
        self.kinds = {BAD_INPUT: given.number("i"), WRONG_USAGE: given.number("i")}
        self.memory = given.number("Q")
        self.is_half = given.number("?")
        self.seconds = given.number("Q")


# -- limits, as process_limits.cpp sets them ---------------------------------------------------------------------------

def limit_this_process(request):
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG
    try:
        with open("/proc/self/oom_score_adj", "w", encoding="ascii") as file:
            file.write("1000")
    except OSError:
        pass

    def limited(kind, soft):
        hard = resource.getrlimit(kind)[1]
        resource.setrlimit(kind, (soft if hard == resource.RLIM_INFINITY else min(soft, hard), hard))

    def end_of_time(*_):
        os.write(2, (LIMIT_NOTE + "seconds %d" % request.seconds).encode())
        os._exit(1)

    limited(resource.RLIMIT_CORE, 0)
    limited(resource.RLIMIT_DATA, request.memory)
    signal.signal(signal.SIGXCPU, end_of_time)
    limited(resource.RLIMIT_CPU, request.seconds)


# -- reading -----------------------------------------------------------------------------------------------------------

def check_named(name, path, folder):
    """A file that another one names, at a path: beside that or below, and no pipe, which would be waited for."""
    if not os.path.realpath(path).startswith(folder.rstrip("/") + "/"):
        raise Refusal("it refers to the file '%1', which is not in its folder. Put the files into one folder.", name)
    if os.path.exists(path) and not os.path.isfile(path):
        raise Refusal("it names '%1', which is not a regular file. Copy its content into one first.", name)


def check_hdf5(path):
    """An HDF5 file may have arrays, and whole groups, that lie in others, which h5py would open."""
    import h5py
    seen = set()
    with h5py.File(path, "r") as file:
        waiting = [file]
        while waiting:
            group = waiting.pop()
            for name in group:
                link = group.get(name, getlink=True)
                if isinstance(link, h5py.HardLink):
                    one = group[name]
                    place = h5py.h5o.get_info(one.id).addr
                    if isinstance(one, h5py.Group) and place not in seen:
                        waiting.append(one)
                    seen.add(place)
                    elsewhere = isinstance(one, h5py.Dataset) and (one.is_virtual or one.external)
                else:
                    elsewhere = isinstance(link, h5py.ExternalLink)
                if elsewhere:
                    raise Refusal("the values of its array '%1' lie in other files or arrays, which are not opened. Copy them into "
                                  "an array of their own, for instance with h5py.", group.name.rstrip("/") + "/" + name)


def check_references(path):
    """An XDMF names files of numbers."""
    import xml.etree.ElementTree as tree
    folder, looked = os.path.realpath(os.path.dirname(path)), set()
    for item in tree.parse(path).getroot().iter("DataItem"):
        if item.get("Format", "XML") != "XML":
            name = (item.text or "").strip().split(":")[0]
            check_named(name, os.path.join(folder, name), folder)
            if item.get("Format") == "HDF" and name not in looked and os.path.isfile(os.path.join(folder, name)):
                looked.add(name)
                check_hdf5(os.path.join(folder, name))


def check_includes(path):
    """A file of Abaqus names others that are read in its place, which may name more; found as meshio finds them."""
    folder = os.path.realpath(os.path.dirname(path))
    waiting, seen = [os.path.realpath(path)], set()
    while waiting:
        file = waiting.pop()
        if file in seen or not os.path.isfile(file):
            continue
        seen.add(file)
        with open(file, encoding="utf-8", errors="replace") as lines:
            for line in lines:
                if line.partition(",")[0].strip().replace("*", "").upper() == "INCLUDE":
                    name = line.split("=")[-1].strip()
                    beside = os.path.join(os.path.dirname(file), name)
                    named = os.path.join(folder, name)
                    waiting.append(named if os.path.exists(named) else beside)
                    check_named(name, waiting[-1], folder)


class GmshFile:
    """A .msh in text or binary. meshio drops the numbers of nodes and elements, by which each view says whose its values are, and
    takes some views for damaged that are not; so of the versions 2.2 and 4.1 it is given a copy without views, and these and the
    numbers are read here. Of 4.0 it takes the values as they come."""
    VIEWS = ("NodeData", "ElementData", "ElementNodeData")

    def __init__(self, path, numpy):
        self.numpy, self.file = numpy, open(path, "rb")
        self.bytes = mmap.mmap(self.file.fileno(), 0, access=mmap.ACCESS_READ)
        self.sections = list(self.sections_in_file())
        version, kind, size = (self.line_of("MeshFormat").split() + [b"", b"", b""])[:3]
        self.is_text, self.whole = kind != b"1", "u4" if size == b"4" else "u8"
        self.is_of_2 = version.split(b".")[0] == b"2"
        is_known = self.is_of_2 or (version.split(b".")[0] == b"4" and version != b"4.0")
        self.views = [section for section in self.sections if is_known and section[0] in self.VIEWS]

    def sections_in_file(self):
        """Of each its name, where its first line begins, where what is in it begins, where its last line begins, and what follows."""
        place = 0
        while place < len(self.bytes):
            begin, place = place, self.next_line(place)
            line = self.bytes[begin:place].strip()
            if line and not line.startswith(b"$"):
                return  # meshio says what is wrong
            if line:
                inside = place
                last, place = self.end_of(line[1:].strip(), inside)
                yield line[1:].strip().decode("utf-8", "replace"), begin, inside, last, place

    def next_line(self, place):
        return self.bytes.find(b"\n", place) + 1 or len(self.bytes)

    def end_of(self, name, inside):
        """Where the line that ends a section begins, and the next one; a section without such a line goes to the end of the file."""
        mark = b"$End" + name
        place = self.bytes.find(mark, inside)
        while place >= 0:
            begin = self.bytes.rfind(b"\n", inside - 1, place) + 1
            if self.bytes[begin:self.next_line(place)].strip() == mark:
                return begin, self.next_line(place)
            place = self.bytes.find(mark, place + 1)
        return len(self.bytes), len(self.bytes)

    def enter(self, name):
        """From now on the last section of that name is read."""
        self.file.seek(max((inside for section, _, inside, _, _ in self.sections if section == name), default=len(self.bytes)))

    def line_of(self, name):
        """The first line of a section; what follows is read next."""
        self.enter(name)
        return self.file.readline()

    def copy_without_views(self, most):
        """A file in memory, which has no name in any folder and ends with this process or when it is closed."""
        begins = [0] + [follows for *_, follows in self.views]
        ends = [begin for _, begin, *_ in self.views] + [len(self.bytes)]
        if sum(ends) - sum(begins) > most:
            raise MemoryError
        copy, piece = open(os.memfd_create("mesh"), "wb"), 1 << 24
        for begin, end in zip(begins, ends):
            for place in range(begin, end, piece):
                copy.write(self.bytes[place:min(place + piece, end)])
        copy.flush()
        return copy

    def numbers(self, kind, count):
        return self.numpy.fromfile(self.file, kind, int(count), sep=" " if self.is_text else "")

    def node_numbers(self):
        if self.is_of_2:
            count = int(self.line_of("Nodes"))
            if self.is_text:
                return self.numbers("f8", 4 * count).reshape(count, 4)[:, 0]
            return self.numbers([("number", "i4"), ("place", "f8", (3,))], count)["number"]
        return self.numbers_in_blocks("Nodes", lambda block, count: self.numbers(self.whole, count),
                                      lambda count: self.numbers("f8", 3 * count))

    def element_numbers(self, mesh):
        if not self.is_of_2:
            def of_block(block, count):
                row = 1 + mesh.cells[block].data.shape[1]
                return self.numbers(self.whole, count * row).reshape(-1, row)[:, 0]

            return self.numbers_in_blocks("Elements", of_block, lambda count: None)
        count = int(self.line_of("Elements"))
        if self.is_text:
            return self.numpy.array([int(self.file.readline().split(None, 1)[0]) for _ in range(count)], self.numpy.int64)
        return self.element_numbers_in_binary(mesh, count)

    def element_numbers_in_binary(self, mesh, count):
        """Of 2.2: meshio joins neighbouring blocks of one kind of elements, whose rows are equally long."""
        ends, parts, done = self.numpy.cumsum([len(block.data) for block in mesh.cells]), [], 0
        while done < count:
            _, elements, tags = self.numbers("i4", 3)
            nodes = mesh.cells[int(self.numpy.searchsorted(ends, done, side="right"))].data.shape[1]
            row = 1 + int(tags) + nodes
            parts.append(self.numbers("i4", int(elements) * row).reshape(-1, row)[:, 0])
            done += len(parts[-1])
        return self.numpy.concatenate(parts or [self.numpy.zeros(0)])

    def numbers_in_blocks(self, section, read, pass_over):
        """Of 4.1: the number of blocks and three others; of each block three numbers, how much is in it, and that."""
        self.enter(section)
        parts = [self.numpy.zeros(0, self.numpy.int64)]
        for block in range(int(self.numbers(self.whole, 4)[0])):
            self.numbers("i4", 3)
            count = int(self.numbers(self.whole, 1)[0])
            parts.append(read(block, count).astype(self.numpy.int64))
            pass_over(count)
        return self.numpy.concatenate(parts)

    def read_view(self, inside):
        """Its name and others, its time and others, its step, components and count; then a number and values a row."""
        self.file.seek(inside)
        words = [self.file.readline().decode().strip().replace('"', "") for _ in range(int(self.file.readline()))]
        for _ in range(int(self.file.readline())):
            self.file.readline()
        _, components, count = [int(self.file.readline()) for _ in range(int(self.file.readline()))][:3]
        if self.is_text:
            table = self.numbers("f8", count * (1 + components)).reshape(count, 1 + components)
            return words[0], table[:, 0].astype(self.numpy.int64), table[:, 1:]
        table = self.numbers([("number", "i4"), ("values", "f8", (components,))], count)
        if len(table) != count:
            raise ValueError("a view ends before its last value")
        return words[0], table["number"].astype(self.numpy.int64), table["values"]

    def give_values(self, mesh):
        """Gives the mesh the values, NaN where the file tells none; what of the file is left out."""
        numbers = {"NodeData": self.node_numbers().astype(self.numpy.int64), "ElementData": self.element_numbers(mesh).astype(self.numpy.int64)}
        ends = self.numpy.cumsum([len(block.data) for block in mesh.cells])
        if len(numbers["NodeData"]) != len(mesh.points) or len(numbers["ElementData"]) != (ends[-1] if len(ends) else 0):
            raise ValueError("its nodes or elements are not as many as it says")
        steps, of_points, of_cells, left_out = {}, {}, {}, []
        for section, _, inside, _, _ in self.views:
            name, owners, values = self.read_view(inside) if section in numbers else (self.name_of_view(inside), None, None)
            steps[section, name] = steps.get((section, name), 0) + 1
            if section == "NodeData":
                of_points[name] = self.placed(name, numbers[section], owners, values)
            elif section == "ElementData":
                of_cells[name] = self.numpy.split(self.placed(name, numbers[section], owners, values), ends[:-1])
            elif steps[section, name] == 1:
                left_out.append(message("Its values '%1' at the corners of elements are not read: elements that share a node may have "
                                        "different ones there.", name))
        mesh.point_data = {**of_points, **mesh.point_data}  # the views first, as by meshio itself
        mesh.cell_data = {**of_cells, **mesh.cell_data}
        return left_out + [message("'%1' has %2 steps; the last one is read.", name, count)
                           for (section, name), count in steps.items() if count > 1 and section in numbers]

    def name_of_view(self, inside):
        self.file.seek(inside)
        return self.file.readline().decode().strip().replace('"', "") if int(self.file.readline()) > 0 else ""

    def placed(self, name, own, owners, values):
        """One row for each of `own`, those of `owners` being `values`."""
        order = self.numpy.argsort(own, kind="stable")
        places = order[self.numpy.minimum(self.numpy.searchsorted(own, owners, sorter=order), len(own) - 1)]
        if (own[places] != owners).any():
            raise Refusal("its values '%1' refer to a node or an element %2, which it does not have.", name,
                          int(owners[own[places] != owners][0]))
        whole = self.numpy.full((len(own), values.shape[1]), self.numpy.nan)
        whole[places] = values
        return whole[:, 0] if values.shape[1] == 1 else whole


def read_gmsh(request, meshio):
    """The mesh with its values, and what of the file is left out."""
    import numpy
    gmsh = GmshFile(request.path, numpy)
    if not gmsh.views:
        return meshio.read(request.path, file_format="gmsh"), []
    with gmsh.copy_without_views(request.memory) as copy:
        mesh = meshio.read("/proc/self/fd/%d" % copy.fileno(), file_format="gmsh")
    return mesh, gmsh.give_values(mesh)


class Series:
    """The steps of a file: one, but of XDMF as many as it has."""

    def __init__(self, request):
        import meshio
        self.times, self.mesh_of, self.left_out = [], None, []
        if request.format == "xdmf":
            check_references(request.path)
            os.chdir(os.path.dirname(request.path) or "/")  # its files are named from there; nothing is imported any more
            import xml.etree.ElementTree as tree
            kinds = [grid.get("CollectionType") for grid in tree.parse(request.path).getroot().iter("Grid")]
            if "Temporal" in kinds:
                self.of_xdmf(request, meshio)
                return
        if request.format == "abaqus":
            check_includes(request.path)
            os.chdir(os.path.dirname(request.path) or "/")
        if request.format == "med":
            check_hdf5(request.path)
        if request.format == "gmsh":
            mesh, self.left_out = read_gmsh(request, meshio)
        else:
            mesh = meshio.read(request.path, file_format=request.format)
        self.mesh_of = lambda step: mesh

    def of_xdmf(self, request, meshio):
        series = meshio.xdmf.TimeSeriesReader(request.path)
        series.__enter__()
        points, cells = series.read_points_cells()

        def mesh_of(step):
            _, point_data, cell_data = series.read_data(step)
            return meshio.Mesh(points, cells, point_data, cell_data)

        for step in range(series.num_steps):
            self.times.append(float(series.read_data(step)[0]))
        self.mesh_of = mesh_of


class Array:
    def __init__(self, name, values, per_cell):
        self.name, self.values, self.per_cell = name, values, per_cell
        self.components = 1 if values.ndim == 1 else int(values.shape[1])
        last = name.replace(":", "_").replace("-", "_").split("_")[-1].lower()
        self.is_helping = last in HELPING


def arrays_of(mesh, numpy):
    """Those with one number or several for each point, then for each cell of all blocks."""
    found = []
    for name, values in mesh.point_data.items():
        values = numpy.asarray(values)
        if values.ndim <= 2 and values.dtype.kind in "fiub" and len(values) == len(mesh.points):
            found.append(Array(name, values, False))
    for name, parts in mesh.cell_data.items():
        parts = [numpy.asarray(part) for part in parts]
        whole = len(parts) == len(mesh.cells) and all(len(p) == len(b.data) for p, b in zip(parts, mesh.cells))
        if whole and parts and all(part.ndim <= 2 and part.dtype.kind in "fiub" for part in parts):
            if len({part.shape[1:] for part in parts}) == 1:
                found.append(Array(name, numpy.concatenate(parts), True))
    return found


def choose_array(arrays, wanted, numpy):
    """As readers of VTK's formats choose: by name or number from 1; else arrays of points before those of cells, one component
    before several, and what is the same everywhere only if there is nothing else. Also whether that was a guess."""
    if not arrays:
        raise Refusal("it holds a mesh, and no values at its points or cells. Export the results with the mesh, as .vtu if the "
                      "program can.")
    if wanted not in ("", "automatic"):
        named = [array for array in arrays if array.name == wanted]
        if not named and wanted.isdigit() and 1 <= int(wanted) <= len(arrays):
            named = [arrays[int(wanted) - 1]]
        if not named:
            raise Refusal("it has no array '%1'. Available: %2.", wanted, ", ".join("'%s'" % a.name for a in arrays),
                          kind=WRONG_USAGE)
        return named[0], False

    def rank(array):
        values = array.values[numpy.isfinite(array.values)]
        is_constant = values.size == 0 or values.min() == values.max()
        return array.is_helping, is_constant, array.per_cell, array.components > 1

    chosen = min(arrays, key=rank)
    return chosen, chosen.is_helping or sum(not array.is_helping for array in arrays) > 1


def samples_of(array, component, numpy):
    """One double for each point or cell, and what was taken of several components."""
    values = array.values.astype(numpy.float64)
    if array.components == 1:
        return values.reshape(len(values)), None
    if component in ("", "magnitude"):
        return numpy.sqrt((values * values).sum(axis=1)), "magnitude"
    if not component.isdigit() or int(component) >= array.components:
        raise Refusal("its array '%1' has the components 0 to %2, and no component %3.", array.name, array.components - 1,
                      component, kind=WRONG_USAGE)
    return values[:, int(component)].copy(), component


def sample_type(array):
    """SampleType: the one that the file has, as far as TAn has it."""
    types = {"u1": 0, "i1": 1, "u2": 2, "i2": 3, "u4": 4, "i4": 5, "f4": 6}
    return types.get(array.values.dtype.newbyteorder("=").str[1:], 7)


def cells_of(mesh, numpy):
    """Shapes, offsets and corners of all blocks, and what of them cannot be read."""
    shapes, offsets, corners, left_out = [], [numpy.zeros(1, numpy.uint64)], [], {}
    end = 0
    for block in mesh.cells:
        count = len(block.data)
        if block.type in SHAPES:
            shape, nodes = SHAPES[block.type]
            data = numpy.asarray(block.data, dtype=numpy.int64)[:, :nodes]
        else:
            if block.type not in FLAT_TYPES:
                left_out[block.type] = left_out.get(block.type, 0) + count
            shape, nodes, data = FLAT, 0, numpy.zeros((count, 0), numpy.int64)
        if data.size and (data.min() < 0 or data.max() >= len(mesh.points)):
            raise Refusal("one of its cells has a corner that is not one of its %1 points. It is damaged.", len(mesh.points))
        shapes.append(numpy.full(count, shape, numpy.uint8))
        offsets.append(end + nodes * numpy.arange(1, count + 1, dtype=numpy.uint64))
        corners.append(data.astype(numpy.uint64).reshape(-1))
        end += nodes * count
    empty = numpy.zeros(0, numpy.uint8)
    return (numpy.concatenate(shapes or [empty]), numpy.concatenate(offsets).astype(numpy.uint64),
            numpy.concatenate(corners or [empty]).astype(numpy.uint64), left_out)


def positions_of(mesh, numpy):
    points = numpy.asarray(mesh.points, dtype=numpy.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise Refusal("its points lie in a plane. A three-dimensional mesh is needed.")
    return numpy.ascontiguousarray(points)


def provenance(array, component, guessed, series, request):
    parts = [taken(ARRAY, plain(array.name), guessed)]
    if component is not None:
        parts.append(taken(COMPONENT, plain(component), request.component == ""))
    if len(series.times) > 1:
        time = "%g" % series.times[request.step - 1]
        parts.append(taken(TIME_STEP, message("%1 of %2, time %3", request.step, len(series.times), time), request.step_is_guessed))
    return listed(parts)


def left_out_of(left_out, series):
    return listed([message("%1 cells of the kind '%2' were left out: TAn does not support them.", count, kind)
                   for kind, count in left_out.items()] + series.left_out)


def array_of_bytes(values):
    return struct.pack("=Q", len(values)) + values.tobytes()


def step_of(series, request):
    steps = max(1, len(series.times))
    if request.step > steps == 1:
        raise Refusal("it has one time step, and number %1 was requested. Leave '--time' out.", request.step, kind=WRONG_USAGE)
    if request.step > steps:
        raise Refusal("it has %1 time steps, and number %2 was requested. Give one from 1 to %1.", steps, request.step, kind=WRONG_USAGE)
    return series.mesh_of(request.step - 1)


def no_lattice():
    return struct.pack("=3I", 0, 0, 0) + struct.pack("=3d", 1, 1, 1) + struct.pack("=3d", 0, 0, 0) + struct.pack(
        "=9d", 1, 0, 0, 0, 1, 0, 0, 0, 1)


def findings(series, request, numpy):
    mesh = step_of(series, request)
    array, guessed = choose_array(arrays_of(mesh, numpy), request.array, numpy)
    values, component = samples_of(array, request.component, numpy)
    shapes, offsets, corners, left_out = cells_of(mesh, numpy)
    positions = positions_of(mesh, numpy)
    name = array.name if component is None else "%s, %s" % (array.name, component)
    yield struct.pack("=B", CELLS) + no_lattice() + text("") + text("") + listed([text("unit")])
    yield struct.pack("=B?", sample_type(array) if component is None else 7, array.per_cell) + text(name) + listed([])
    yield provenance(array, component, guessed, series, request) + left_out_of(left_out, series)
    yield struct.pack("=Q", len(positions)) + positions.tobytes()
    yield struct.pack("=Q", values.nbytes) + values.tobytes()
    for part in (shapes, offsets, corners):
        yield array_of_bytes(part)
    yield struct.pack("=Q", 0)  # none is blanked


def contents(series, request, numpy):
    mesh = step_of(series, request)
    arrays = arrays_of(mesh, numpy)
    array, guessed = choose_array(arrays, request.array, numpy)
    _, component = samples_of(array, request.component, numpy)
    left_out = cells_of(mesh, numpy)[3]
    volumes = sum(len(block.data) for block in mesh.cells if block.type in SHAPES)
    yield struct.pack("=?I", True, IRREGULAR) + no_lattice() + struct.pack("=QQ", len(mesh.points), volumes)
    yield struct.pack("=?B", True, sample_type(array)) + listed([]) + listed([text("unit")]) + listed([]) + listed([])
    yield provenance(array, component, guessed, series, request) + left_out_of(left_out, series)
    yield struct.pack("=Q", len(series.times)) + struct.pack("=%dd" % len(series.times), *series.times)

    def described(one):
        finite = one.values[numpy.isfinite(one.values)] if one.components == 1 else numpy.zeros(0)
        told = struct.pack("=?dd", True, finite.min(), finite.max()) if finite.size else struct.pack("=?", False)
        return text(one.name) + struct.pack("=i?", one.components, one.per_cell) + told + text("")

    yield listed([described(one) for one in arrays])


def refusal(request, problem):
    sentence = "Cannot read '%1': %2"
    inner = filled(problem.sentence, problem.arguments)
    said = text(filled(sentence, (request.path, inner))) + text(sentence) + struct.pack("=Q", 2)
    said += plain(request.path) + message(problem.sentence, *problem.arguments)
    return struct.pack("=i", request.kinds[problem.kind]) + said + text(request.path)


def answer(request):
    try:
        import meshio  # noqa: F401
        import numpy
    except ImportError:
        raise Refusal("meshio, which reads such files, is not installed. Install it with 'apt install python3-meshio' (other "
                      "systems: 'pip install meshio'), or write the mesh as .vtu.") from None
    try:
        series = Series(request)
        if request.contents_only:
            return CONTENTS, list(contents(series, request, numpy))
        return FINDINGS, list(findings(series, request, numpy))
    except (Refusal, MemoryError):
        raise
    except ModuleNotFoundError as problem:
        raise Refusal("meshio needs the Python module '%1' for it. Install it with 'apt install python3-%1', or write the mesh as "
                      ".vtu.", problem.name) from None
    except OSError as problem:
        raise Refusal("the system says: %1. Check that the file and those that it refers to can be read.", problem) from None
    except (Exception, SystemExit) as problem:  # meshio raises whatever its parts do
        raise Refusal("meshio does not understand it (%1). Open it in the program that wrote it, and export it again, as .vtu if "
                      "the program can.", " ".join(str(problem).split())[:200] or type(problem).__name__) from None


def main():
    request = Request(sys.stdin.buffer)
    limit_this_process(request)
    output = os.fdopen(os.dup(1), "wb")
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)  # meshio prints
    try:
        kind, parts = answer(request)
    except Refusal as problem:
        kind, parts = ERROR, [refusal(request, problem)]
    except MemoryError:
        os.write(2, (LIMIT_NOTE + ("half %d" if request.is_half else "memory %d") % request.memory).encode())
        os._exit(1)
    output.write(kind)
    for part in parts:
        output.write(part)
    output.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
