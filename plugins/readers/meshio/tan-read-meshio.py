#!/usr/bin/python3 -I
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program in which meshio reads a mesh for the plugin: takes one request from its input and writes messages to its output, as
plugins/process/exchange.h says. It may break down: the plugin bears that. `python3 -I` takes no module from where the data lie.

Sentences are those of meshio_texts.h, which are translated."""
import ctypes
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
        raise Refusal("it names the file '%1', which does not lie in its folder. Move the files together.", name)
    if os.path.exists(path) and not os.path.isfile(path):
        raise Refusal("it names '%1', which is not a regular file. Copy its content into one first.", name)


def check_references(path):
    """An XDMF names files of numbers."""
    import xml.etree.ElementTree as tree
    folder = os.path.realpath(os.path.dirname(path))
    for item in tree.parse(path).getroot().iter("DataItem"):
        if item.get("Format", "XML") != "XML":
            name = (item.text or "").strip().split(":")[0]
            check_named(name, os.path.join(folder, name), folder)


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


class GmshNumbers:
    """What meshio drops of a .msh: the numbers of nodes and elements, by which each value says whose it is. Its readers of the
    versions 2.2 and 4.1 keep them here, and leave the values to values_of(); of 4.0 meshio takes the values as they come."""

    def __init__(self, numpy):
        from meshio.gmsh import _gmsh22, _gmsh41, common
        self.numpy, self.common = numpy, common
        self.nodes, self.elements, self.sections = None, [], []
        for module in (_gmsh22, _gmsh41):
            module._read_data = self.read_section
        self.keep_nodes(_gmsh22, 0)
        self.keep_nodes(_gmsh41, 1)
        self.keep_elements(_gmsh22, "_read_cells_ascii", lambda f, cells, tags, count: [
            int(f.readline().split(None, 1)[0]) for _ in range(count)])
        self.keep_elements(_gmsh22, "_read_cells_binary", lambda f, cells, tags, count: self.elements_of_22(_gmsh22, f, count))
        self.keep_elements(_gmsh41, "_read_elements", lambda f, points, physical, bounds, is_text, size, names: (
            self.elements_of_41(_gmsh41, f, is_text, size)))

    def keep_nodes(self, module, below):
        """`below`: meshio has already taken so much from their numbers."""
        meshios = module._read_nodes

        def read_nodes(*arguments):
            result = meshios(*arguments)
            self.nodes = self.numpy.asarray(result[1]).astype(self.numpy.int64) + below
            return result

        module._read_nodes = read_nodes

    def keep_elements(self, module, name, numbers):
        """Reads the section twice: once as meshio does, once for the numbers of its elements."""
        meshios = getattr(module, name)

        def read_elements(f, *arguments):
            begin = f.tell()
            result = meshios(f, *arguments)
            end = f.tell()
            f.seek(begin)
            self.elements = self.numpy.asarray(numbers(f, *arguments), dtype=self.numpy.int64)
            f.seek(end)
            return result

        setattr(module, name, read_elements)

    def elements_of_22(self, module, f, count):
        numbers = [self.numpy.zeros(0, self.numpy.int64)]
        while sum(map(len, numbers)) < count:
            kind, elements, tags = self.numpy.fromfile(f, count=3, dtype=module.c_int)
            row = 1 + int(tags) + module.num_nodes_per_cell[module._gmsh_to_meshio_type[kind]]
            numbers.append(self.numpy.fromfile(f, count=int(elements) * row, dtype=module.c_int).reshape(-1, row)[:, 0])
        return self.numpy.concatenate(numbers)

    def elements_of_41(self, module, f, is_text, size):
        def fromfile(kind, count):
            return self.numpy.fromfile(f, kind, int(count), sep=" " if is_text else "")

        whole = module._size_type(size)
        numbers = [self.numpy.zeros(0, self.numpy.int64)]
        for _ in range(int(fromfile(whole, 4)[0])):
            kind = fromfile(module.c_int, 3)[2]
            row = 1 + module.num_nodes_per_cell[module._gmsh_to_meshio_type[kind]]
            numbers.append(fromfile(whole, int(fromfile(whole, 1)[0]) * row).reshape(-1, row)[:, 0])
        return self.numpy.concatenate([part.astype(self.numpy.int64) for part in numbers])

    def read_section(self, f, section, _, __, is_text):
        """A view: its name and others, its time and others, its step, components and count; then a number and values a row."""
        words = [f.readline().decode().strip().replace('"', "") for _ in range(int(f.readline()))]
        for _ in range(int(f.readline())):
            f.readline()
        _, components, count = [int(f.readline()) for _ in range(int(f.readline()))][:3]
        if is_text:
            table = self.numpy.fromfile(f, count=count * (1 + components), sep=" ").reshape(count, 1 + components)
            numbers, values = table[:, 0].astype(self.numpy.int64), table[:, 1:]
        else:
            table = self.numpy.fromfile(f, [("number", "i4"), ("values", "f8", (components,))], count)
            numbers, values = table["number"].astype(self.numpy.int64), table["values"]
        if len(numbers) != count:
            raise ValueError("a view ends before its last value")
        self.common._fast_forward_to_end_block(f, section)
        self.sections.append((section == "NodeData", words[0], numbers, values))

    def values_of(self, mesh):
        """Gives the mesh the values, NaN where the file tells none; what of the file is left out."""
        views, of_points, of_cells = {}, {}, {}
        for is_of_nodes, name, numbers, values in self.sections:
            own = self.nodes if is_of_nodes else self.elements
            order = self.numpy.argsort(own, kind="stable")
            places = order[self.numpy.minimum(self.numpy.searchsorted(own, numbers, sorter=order), len(own) - 1)]
            if (own[places] != numbers).any():
                raise Refusal("its values '%1' name a node or an element %2, which it does not have.", name,
                              int(numbers[own[places] != numbers][0]))
            whole = self.numpy.full((len(own), values.shape[1]), self.numpy.nan)
            whole[places] = values
            if values.shape[1] == 1:
                whole = whole[:, 0]
            ends = self.numpy.cumsum([len(block.data) for block in mesh.cells])[:-1]
            if is_of_nodes:
                of_points[name] = whole
            else:
                of_cells[name] = self.numpy.split(whole, ends)
            views[is_of_nodes, name] = views.get((is_of_nodes, name), 0) + 1
        mesh.point_data = {**of_points, **mesh.point_data}  # the views first, as by meshio itself
        mesh.cell_data = {**of_cells, **mesh.cell_data}
        return [message("Of '%1' it has %2 steps; the last one is read.", name, count)
                for (_, name), count in views.items() if count > 1]


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
        gmsh = None
        if request.format == "gmsh":
            import numpy
            gmsh = GmshNumbers(numpy)
        mesh = meshio.read(request.path, file_format=request.format)
        if gmsh is not None and gmsh.sections:
            self.left_out = gmsh.values_of(mesh)
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
            raise Refusal("it has no array '%1'; there are %2.", wanted, ", ".join("'%s'" % a.name for a in arrays),
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
        raise Refusal("its points lie in a plane. A mesh of three dimensions is wanted.")
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
    return listed([message("%1 cells of the kind '%2' were left out: TAn knows none like them.", count, kind)
                   for kind, count in left_out.items()] + series.left_out)


def array_of_bytes(values):
    return struct.pack("=Q", len(values)) + values.tobytes()


def step_of(series, request):
    steps = max(1, len(series.times))
    if request.step > steps:
        raise Refusal("it has %1 time steps, and no step %2.", steps, request.step, kind=WRONG_USAGE)
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
        raise Refusal("meshio, which reads such files, is not installed. Install it by 'apt install python3-meshio' (other "
                      "systems: 'pip install meshio'), or write the mesh as .vtu.") from None
    try:
        series = Series(request)
        if request.contents_only:
            return CONTENTS, list(contents(series, request, numpy))
        return FINDINGS, list(findings(series, request, numpy))
    except (Refusal, MemoryError):
        raise
    except ModuleNotFoundError as problem:
        raise Refusal("meshio needs the Python module '%1' for it. Install it by 'apt install python3-%1', or write the mesh as "
                      ".vtu.", problem.name) from None
    except OSError as problem:
        raise Refusal("the system says: %1. See that the file and those that it names can be read.", problem) from None
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
