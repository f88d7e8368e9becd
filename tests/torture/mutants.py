# SPDX-License-Identifier: GPL-3.0-or-later
"""Models that somebody changed and whose checksums are right, as only intent makes them: explicit and packed ones. Written after
core/history/FORMAT.md, in which every number here is explained."""
import ctypes
import ctypes.util
import json
import math
import os
import re
import shutil
import signal
import struct
import time

from bench import BAD_INPUT, DONE, HANGS_AFTER, OUT_OF_RESOURCE, USAGE, Kind, KINDS, Ran

NOT_PROVED = 1
MOST_MEMORY = 500 << 20

HEADER, ENTRY, ALIGNMENT = 256, 64, 64
TEXT, HISTORY_KIND, CHUNK_SUMS, LEVEL_INDEX, FACTS, LEVELS, SUMS, CHUNKS = 1, 2, 3, 4, 5, 6, 7, 8
POINTS, VALUES, KEYS, OFFSETS, SIZES, GROUPS, POSITIONS, SAMPLES, SAMPLE_POSITIONS = 16, 17, 18, 19, 20, 21, 22, 23, 24
OTHERS, DESTROYERS, OWN_ERRORS, OWN_WARPINGS = 32, 33, 34, 35
BATCH_ENDS, BATCH_ERRORS, BATCH_WARPINGS, BLOCKS, FAULTS, FAULTY_CELLS = 48, 49, 50, 51, 52, 53
SAMPLE_TYPES = "BbHhIifd"
NEVER = 0xffffffff


def xxh3():
    name = ctypes.util.find_library("xxhash")
    assert name, "the library libxxhash, which the program itself needs, is not found"
    function = ctypes.CDLL(name).XXH3_64bits
    function.restype, function.argtypes = ctypes.c_uint64, (ctypes.c_char_p, ctypes.c_size_t)
    return lambda content: function(bytes(content), len(content))


checksum = xxh3()


class Missing(Exception):
    """What was to be changed, a section or its chunks, is not there: another change has taken it."""


class Section:
    def __init__(self, entry, file):
        self.id, self.flags, self.element, self.codec, self.offset, size, _ = struct.unpack_from("<4I3Q", entry)
        self.content = bytearray(file[self.offset:self.offset + size])
        self.gap = None  # bytes that are kept free behind it, of the level index


class TanFile:
    """A .tan file in its parts; bytes() puts it together again with right checksums."""

    def __init__(self, file):
        self.header = bytearray(file[:HEADER])
        count = struct.unpack_from("<I", file, 20)[0]
        self.sections = [Section(file[HEADER + ENTRY * i:HEADER + ENTRY * (i + 1)], file) for i in range(count)]
        self.first = self.sections[0].offset
        for one, following in zip(self.sections, self.sections[1:]):
            if one.id == LEVEL_INDEX:
                one.gap = following.offset - one.offset

    def has(self, number):
        return any(one.id == number for one in self.sections)

    def __getitem__(self, number):
        for one in self.sections:
            if one.id == number:
                return one
        raise Missing

    @property
    def is_packed(self):
        return self.has(CHUNKS)

    def number(self, form, offset):
        return struct.unpack_from("<" + form, self.header, offset)[0]

    def set_number(self, form, offset, value):
        struct.pack_into("<" + form, self.header, offset, value)

    @property
    def sample_type(self):
        return SAMPLE_TYPES[self.number("I", 36)]

    def chunks(self):
        """Of a packed file: [kind, bytes]."""
        content, found, at = self[CHUNKS].content, [], 0
        while at + 16 <= len(content):
            _, kind, size = struct.unpack_from("<QII", content, at)
            found.append([kind, bytearray(content[at + 16:at + 16 + size])])
            at += 16 + size
        return found

    def set_chunks(self, chunks):
        content = bytearray()
        for kind, own in chunks:
            rest = struct.pack("<II", kind & NEVER, len(own)) + own
            content += struct.pack("<Q", checksum(rest)) + rest
        self[CHUNKS].content = content

    def sum_chunks(self):
        """The checksums of the chunks of all other sections."""
        if not self.has(CHUNK_SUMS) or len(self[CHUNK_SUMS].content) < 8:
            return
        size = struct.unpack_from("<Q", self[CHUNK_SUMS].content)[0]
        if size < 64 or size & (size - 1) != 0:
            return
        sums = [checksum(one.content[at:at + size]) for one in self.sections if one.id != CHUNK_SUMS
                for at in range(0, len(one.content), size)]
        self[CHUNK_SUMS].content = bytearray(struct.pack("<Q%dQ" % len(sums), size, *sums))

    def bytes(self):
        self.sum_chunks()
        file = bytearray(max(self.first, HEADER + ENTRY * len(self.sections)))
        table = bytearray()
        for one in self.sections:
            file += bytes(-len(file) % ALIGNMENT)
            one.offset = len(file)
            file += one.content
            if one.gap and one is not self.sections[-1]:
                file += bytes(max(one.gap - len(one.content), 0))
            table += struct.pack("<4I3Q24x", one.id, one.flags, one.element, one.codec, one.offset, len(one.content),
                                 checksum(one.content))
        self.set_number("I", 20, len(self.sections))
        self.set_number("Q", 24, len(file))
        self.set_number("Q", 248, checksum(self.header[:248] + table))
        file[:HEADER] = self.header
        file[HEADER:HEADER + len(table)] = table
        return bytes(file)


# --- Changes -----------------------------------------------------------------------------------------------------------------------

class Elements:
    """The numbers of a section."""

    def __init__(self, section, form):
        self.section, self.form, self.size = section, "<" + form, struct.calcsize(form)

    def __len__(self):
        return len(self.section.content) // self.size

    def __getitem__(self, at):
        return struct.unpack_from(self.form, self.section.content, at * self.size)[0]

    def __setitem__(self, at, value):
        struct.pack_into(self.form, self.section.content, at * self.size, value)


def forms_of(file):
    """What the sections of an explicit model hold."""
    coordinate = "f" if file.has(POSITIONS) and file[POSITIONS].element == 12 else "d"
    return {POINTS: "I", VALUES: file.sample_type, KEYS: "f", OFFSETS: "Q", SIZES: "I", GROUPS: "B", POSITIONS: coordinate,
            SAMPLES: file.sample_type, SAMPLE_POSITIONS: coordinate, OTHERS: "I", DESTROYERS: "I", OWN_ERRORS: "H", OWN_WARPINGS: "H",
            BATCH_ENDS: "I", BATCH_ERRORS: "f", BATCH_WARPINGS: "f", BLOCKS: "I", FAULTS: "Q", FAULTY_CELLS: "Q"}


def odd_number(form, now, chance):
    """A number that programs trip over."""
    if form in "fd":
        return chance.choice((math.nan, math.inf, -math.inf, -1.0, 0.0, 1e38, -now, 2 * now, now + 1, 1e-40))
    if form == "H":  # a half: not a number, infinite, negative, one
        return chance.choice((0x7e00, 0x7c00, 0x8001, 0xffff, 0x3c00, 0, 1))
    bits = 8 * struct.calcsize(form)
    low, high = (0, 2 ** bits - 1) if form.isupper() else (-2 ** (bits - 1), 2 ** (bits - 1) - 1)
    wanted = chance.choice((low, high, now + 1, now - 1, now ^ 1 << chance.randrange(bits - 1), chance.randint(low, high), 7, 0))
    return min(max(wanted, low), high)


def change_numbers(file, other, chance):
    """Some numbers of an array."""
    forms = forms_of(file)
    number = chance.choice([one.id for one in file.sections if one.id in forms and one.content])
    elements = Elements(file[number], forms[number])
    if len(elements) == 0:
        return "nothing"
    for _ in range(chance.choice((1, 1, 3, 20))):
        at = chance.randrange(len(elements))
        elements[at] = odd_number(forms[number], elements[at], chance)
    return "numbers of section %d" % number


def change_order(file, other, chance):
    """Two elements of an array in each other's place, or a part of it backwards."""
    number = chance.choice([one.id for one in file.sections if one.id in forms_of(file) and len(one.content) > 2 * one.element])
    section = file[number]
    size, count = section.element, len(section.content) // section.element
    first, last = sorted((chance.randrange(count), chance.randrange(count)))
    if chance.random() < 0.5:
        a, b = slice(first * size, (first + 1) * size), slice(last * size, (last + 1) * size)
        section.content[a], section.content[b] = section.content[b], section.content[a]
    else:
        part = [section.content[at * size:(at + 1) * size] for at in range(first, last)]
        section.content[first * size:last * size] = b"".join(reversed(part))
    return "order in section %d" % number


def change_history(file, other, chance):
    """Tetrahedra that die before they are made, at each other's hands, or never; of sites that come later."""
    offsets, destroyers, others = (Elements(file[number], form) for number, form in ((OFFSETS, "Q"), (DESTROYERS, "I"), (OTHERS, "I")))
    sites = len(offsets) - 1
    for _ in range(chance.choice((1, 1, 4, 30))):
        site = chance.randrange(sites)
        begin, end = offsets[site], offsets[site + 1]
        if not begin < end <= len(destroyers):
            continue
        t = chance.randrange(begin, end)
        way = chance.randrange(6)
        if way == 0:
            destroyers[t] = chance.randrange(site + 1)
        elif way == 1:
            destroyers[t] = site
        elif way == 2:
            destroyers[t] = NEVER if destroyers[t] != NEVER else chance.randrange(sites)
        elif way == 3:
            destroyers[t] = chance.choice((sites, sites + 1, NEVER - 1, chance.randrange(sites)))
        elif way == 4:
            others[3 * t + chance.randrange(3)] = chance.choice((site, min(site + 1, sites - 1), sites, NEVER, chance.randrange(sites)))
        else:
            others[3 * t] = others[3 * t + 1]
    return "history"


def change_stars(file, other, chance):
    """Where stars begin, and which sites belong together."""
    offsets, groups = Elements(file[OFFSETS], "Q"), Elements(file[GROUPS], "B")
    for _ in range(chance.choice((1, 2, 10))):
        at = chance.randrange(len(groups))
        if chance.random() < 0.5:
            groups[at] = chance.choice((0, 1, 1, 2, 255))
        else:
            offsets[at] = chance.choice((0, offsets[at] + 1, max(offsets[at], 1) - 1, offsets[len(offsets) - 1], 2 ** 40, 2 ** 64 - 1))
    return "stars"


def change_index(file, other, chance):
    """What is told of levels, batches, blocks and faults."""
    number = chance.choice([one.id for one in file.sections
                            if one.id in (LEVEL_INDEX, BATCH_ENDS, BATCH_ERRORS, BATCH_WARPINGS, BLOCKS, FAULTS, FAULTY_CELLS, SIZES)])
    section = file[number]
    way = chance.randrange(3)
    if way == 0 and section.content:
        for _ in range(chance.choice((1, 8))):
            section.content[chance.randrange(len(section.content))] = chance.randrange(256)
    elif way == 1:
        section.content = section.content[:chance.randrange(len(section.content) // section.element + 1) * section.element]
    else:
        section.content = section.content + section.content[:chance.choice((1, 4)) * section.element]
    return "index %d" % number


def change_header(file, other, chance):
    fields = (("I", 32), ("I", 36), ("I", 40), ("I", 44), ("I", 48), ("I", 52), ("Q", 56), ("d", 64), ("d", 72), ("d", 88), ("d", 112),
              ("d", 120), ("d", 128), ("d", 152), ("Q", 176), ("f", 184), ("I", 188), ("d", 192), ("H", 10))
    form, offset = chance.choice(fields)
    file.set_number(form, offset, odd_number(form if form != "H" else "I", file.number(form, offset), chance) if form != "H" else 9)
    return "header at %d" % offset


def change_text(file, other, chance):
    lines = bytes(file[TEXT].content).split(b"\n")
    at = chance.randrange(len(lines))
    way = chance.randrange(4)
    if way == 0:
        lines[at] = lines[at].split(b"=")[0] + b"=" + chance.choice((b"", b"nan", b"-1", b"1e999", b"\xff\xfe", b"999999999999", b"none", b"0"))
    elif way == 1:
        del lines[at]
    elif way == 2:
        lines.insert(at, lines[chance.randrange(len(lines))])
    else:
        lines[at] = bytes(chance.randrange(256) for _ in range(20))
    file[TEXT].content = bytearray(b"\n".join(lines))
    return "text"


def take_section(file, other, chance):
    """A section of another model; or none, or twice, or of another kind."""
    way = chance.randrange(3)
    one = chance.choice(file.sections)
    if way == 0 and other.has(one.id):
        one.content = bytearray(other[one.id].content)
    elif way == 1:
        file.sections.remove(one)
    else:
        one.id = chance.choice((2, 3, 4, 8, 20, 49, 52, 77, one.id + 1))
        one.flags = chance.choice((0, 1))
    return "section"


def change_bytes(file, other, chance):
    """Bits, zeros and noise anywhere in a section."""
    section = chance.choice([one for one in file.sections if one.content])
    begin = chance.randrange(len(section.content))
    end = min(len(section.content), begin + chance.choice((1, 8, 64, 4096)))
    way = chance.randrange(3)
    if way == 0:
        section.content[begin] ^= 1 << chance.randrange(8)
    else:
        section.content[begin:end] = bytes(end - begin) if way == 1 else chance.randbytes(end - begin)
    return "bytes of section %d" % section.id


def change_chunk(file, other, chance):
    """The bytes of a packed chunk."""
    chunks = file.chunks()
    if not chunks:  # another change has taken them all
        raise Missing
    own = chance.choice(chunks)
    for _ in range(chance.choice((1, 1, 2, 40))):
        if not own[1]:
            break
        at = chance.randrange(len(own[1])) if chance.random() < 0.7 else chance.randrange(min(len(own[1]), 32))
        way = chance.randrange(4)
        if way == 0:
            own[1][at] ^= 1 << chance.randrange(8)
        elif way == 1:
            own[1][at:at + 16] = bytes(len(own[1][at:at + 16]))
        elif way == 2:
            own[1][at] = chance.choice((0, 255, chance.randrange(256)))
        else:
            del own[1][at:at + chance.choice((1, 100))]
    file.set_chunks(chunks)
    return "a chunk"


def change_chunks(file, other, chance):
    """Packed chunks in another order, twice, left out, of another kind or from another model."""
    chunks = file.chunks()
    if not chunks:
        raise Missing
    at, where = chance.randrange(len(chunks)), chance.randrange(len(chunks))
    way = chance.randrange(6)
    if way == 0:
        chunks[at], chunks[where] = chunks[where], chunks[at]
    elif way == 1:
        chunks.insert(where, [chunks[at][0], bytearray(chunks[at][1])])
    elif way == 2:
        del chunks[at]
    elif way == 3:
        chunks[at][0] = chance.choice((0, 1, 2, 3, 4, 5, 6, 7, 2 ** 31))
    elif way == 4 and other.is_packed:
        strange = other.chunks()
        chunks[at] = strange[chance.randrange(len(strange))]
    else:
        chunks += [[chance.choice((1, 2, 3)), bytearray()] for _ in range(chance.choice((1, 10_000)))]
    file.set_chunks(chunks)
    return "chunks"


def change_front(file, other, chance):
    """What a packed file tells before its chunks."""
    number = chance.choice((FACTS, LEVELS, LEVELS, SUMS))
    section = file[number]
    words = Elements(section, "I")
    for _ in range(chance.choice((1, 1, 5))):
        if chance.random() < 0.3 and number == LEVELS:
            Elements(section, "f")[6 * chance.randrange(len(section.content) // 24) + chance.randrange(2)] = \
                chance.choice((math.nan, math.inf, -1, 0, 1e30))
        elif len(words):
            at = chance.randrange(len(words))
            words[at] = odd_number("I", words[at], chance)
    if chance.random() < 0.1:
        section.content += section.content[-section.element:] * chance.choice((1, 600))
    return "front %d" % number


EXPLICIT = (change_numbers, change_numbers, change_numbers, change_order, change_history, change_history, change_stars, change_index,
            change_header, change_text, take_section, change_bytes)
PACKED = (change_chunk, change_chunk, change_chunk, change_chunks, change_chunks, change_front, change_header, change_text, take_section,
          change_bytes)


def change(ways, file, other, chance):
    """One or two changes, in words."""
    told = []
    for _ in range(chance.choice((1, 1, 2))):
        try:
            told.append(chance.choice(ways)(file, other, chance))
        except Missing:
            told.append("nothing more")
    return told


# --- Running -----------------------------------------------------------------------------------------------------------------------

def measured(bench, arguments, folder, limits=None):
    """A run of the program, and the most memory that it had."""
    output = folder.with_name(folder.name + ".output")
    with open(output, "w+b") as out:
        began = time.monotonic()
        process = bench.start(bench.command(arguments), folder, limits, stdout=out, stderr=out)
        hung = False
        while True:
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
            if done:
                break
            if not hung and time.monotonic() - began > HANGS_AFTER:
                hung = True
                os.killpg(process.pid, signal.SIGKILL)
            time.sleep(0.003)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        said = out.read()
    output.unlink()
    return Ran(process.returncode, time.monotonic() - began, said, said, hung, usage.ru_utime + usage.ru_stime), usage.ru_maxrss * 1024


def legacy_mesh(path):
    """Coordinates, tetrahedra and values of a legacy VTK file as TAn writes it."""
    content = path.read_bytes()
    found = re.search(rb"\nPOINTS (\d+) (float|double)\n", content)
    count, form = int(found[1]), {b"float": "f", b"double": "d"}[found[2]]
    points = struct.unpack_from(">%d%s" % (3 * count, form), content, found.end())
    cells = re.compile(rb"\nCELLS (\d+) \d+\n").search(content, found.end() + len(points) * struct.calcsize(form))
    tetrahedra = struct.unpack_from(">%dI" % (5 * int(cells[1])), content, cells.end())
    values = re.compile(rb"\nSCALARS \S+ (\w+) 1\nLOOKUP_TABLE default\n").search(content, cells.end())
    form = {b"float": "f", b"double": "d", b"unsigned_char": "B", b"unsigned_short": "H", b"unsigned_int": "I"}[values[1]]
    return points, tetrahedra, struct.unpack_from(">%d%s" % (count, form), content, values.end())


def unusable(points, tetrahedra, values):
    """Why nobody can use a mesh, or nothing: a vertex without a place or a value."""
    if not all(map(math.isfinite, points)) or not all(map(math.isfinite, values)):
        return "a mesh with a number that is not finite"
    if any(corner >= len(points) // 3 for at, corner in enumerate(tetrahedra) if at % 5 != 0):
        return "a mesh with a corner that is not there"
    return None


def wrong_mesh(path, file):
    """The same, or a vertex out of all that the header allows."""
    points, tetrahedra, values = legacy_mesh(path)
    if problem := unusable(points, tetrahedra, values):
        return problem
    low, high = file.number("d", 112), file.number("d", 120)
    slack = 1e-6 * max(abs(low), abs(high))
    if any(value < low - slack or value > high + slack for value in values):
        return "a mesh with a value out of the range"
    box = struct.unpack_from("<6d", file.header, 128)
    for axis in range(3):
        slack = 1e-6 * max(abs(box[axis]), abs(box[axis + 3]), 1)
        if any(place < box[axis] - slack or place > box[axis + 3] + slack for place in points[axis::3]):
            return "a mesh with a vertex out of the bounding box"
    return None


# Of other ways to make and to pack a model than the bench's own kinds.
MORE_KINDS = (
    Kind("scattered", "scattered", "cloud.csv", 6),
    Kind("grid by collapses", "o-grid", "grid.xyz", 7, ("--builder", "decimation", "--space", "computational")),
    Kind("few sites", "marschner-lobb", "ml.nrrd", 16, ("--error", "5")),
    Kind("weighted", "c60", "c60.nrrd", 10, ("--weight", "value:0.5,0.2")),
)
WHOLE = tuple(kind for kind in KINDS if not kind.is_packed) + MORE_KINDS


def packed_form(bench, kind):
    def make():
        place = bench.model_folder(kind)
        ran = bench.run(("pack", "model.tan", "-o", "packed.tan"), place)
        assert ran.code == DONE, ran.said()
        return (place / "packed.tan").read_bytes()
    return bench.once(("packed form", kind.name), make)


class Judge:
    """Runs commands on a mutant, and collects what went wrong."""

    def __init__(self, bench, folder, kind, file):
        self.bench, self.folder, self.kind, self.file = bench, folder, kind, file
        self.failures, self.refused, self.done = [], 0, 0
        self.known = {path.name for path in folder.iterdir()}

    def run(self, *arguments, writes=None, allowed=()):
        ran, memory = measured(self.bench, arguments, self.folder)
        name = arguments[0]
        problem = ran.crash()
        if problem is None and ran.code not in (DONE, BAD_INPUT, *allowed):
            problem = "exit code %d: %s" % (ran.code, ran.said())
        if problem is None and ran.code != DONE and not ran.err.strip():
            problem = "exit code %d without a word" % ran.code
        if problem is None and memory > MOST_MEMORY:
            problem = "%d MB of memory" % (memory >> 20)
        if problem is None:
            left = {path.name for path in self.folder.iterdir()} - self.known - {writes}
            cache = self.bench.cache(self.folder) / "tan"
            left |= {path.name for path in cache.iterdir() if path.suffix} if cache.is_dir() else set()
            if left:
                problem = "left behind: " + ", ".join(sorted(left))
        if problem is None and writes and (self.folder / writes).exists() != (ran.code == DONE):
            problem = "exit code %d, and %s is %s" % (ran.code, writes, "there" if ran.code != DONE else "not there")
        if problem is not None:
            self.failures.append("%s: %s" % (" ".join(map(str, arguments)), problem))
        self.done += ran.code == DONE
        self.refused += ran.code != DONE
        return ran, problem is None and ran.code == DONE

    def meshes(self):
        for error in ("8", "1", "0"):
            target = "mesh-%s.vtk" % error
            _, done = self.run("extract", "mutant.tan", "--error", error, "-o", target, writes=target)
            if done:
                if problem := wrong_mesh(self.folder / target, self.file):
                    self.failures.append("extract --error %s: %s" % (error, problem))
                (self.folder / target).unlink()
        self.run("render", "mutant.tan", "--error", "5", "--size", "64x48", "--backend", "cpu", "-o", "picture.png",
                 writes="picture.png", allowed=(USAGE,))
        (self.folder / "picture.png").unlink(missing_ok=True)

    def proof(self, whole):
        """No proof of what differs in what is proved."""
        _, proved = self.run("verify", "mutant.tan", "--against", self.kind.opened, "--lod", "8,1,0", allowed=(NOT_PROVED, USAGE))
        return proved


def attempt_explicit(bench, folder, chance, number):
    kind = WHOLE[number % len(WHOLE)]
    bench.put_sample(kind, folder)
    whole = bench.model(kind)[0]
    file, other = TanFile(whole), TanFile(bench.model(chance.choice(WHOLE))[0])
    changes = change(EXPLICIT, file, other, chance)
    mutant = file.bytes()
    (folder / "mutant.tan").write_bytes(mutant)
    judge = Judge(bench, folder, kind, file)
    judge.run("info", "mutant.tan", "--json")
    judge.meshes()
    judge.proof(whole)
    _, packed = judge.run("pack", "mutant.tan", "-o", "packed.tan", writes="packed.tan")
    if packed:
        judge.known.add("packed.tan")
        ran, back = judge.run("unpack", "packed.tan", "-o", "again.tan", writes="again.tan")
        if not back:
            judge.failures.append("was packed, and does not come back: " + ran.said())
        elif (folder / "again.tan").read_bytes() != mutant:
            judge.failures.append("was packed, and comes back as another file")
    failures = ["%s of %s: %s" % (", ".join(changes), kind.name, one) for one in judge.failures]
    outcome = "refused by all" if judge.done == 0 else "packed and the same again" if packed else "refused by some"
    return outcome, failures, {"runs": judge.done + judge.refused}


def attempt_packed(bench, folder, chance, number):
    kind = WHOLE[number % len(WHOLE)]
    bench.put_sample(kind, folder)
    whole = bench.model(kind)[0]
    file, other = TanFile(packed_form(bench, kind)), TanFile(packed_form(bench, chance.choice(WHOLE)))
    changes = change(PACKED, file, other, chance)
    (folder / "mutant.tan").write_bytes(file.bytes())
    judge = Judge(bench, folder, kind, file)
    judge.run("info", "mutant.tan", "--json")
    judge.meshes()
    judge.proof(whole)
    ran, done = judge.run("unpack", "mutant.tan", "-o", "again.tan", "--json", writes="again.tan")
    if done and (folder / "again.tan").read_bytes() != whole:
        told = json.loads(ran.out)
        if not told.get("derived"):
            judge.failures.append("unpacked to another model, and nothing is said")
    (folder / "again.tan").unlink(missing_ok=True)
    judge.run("pack", "mutant.tan", "-o", "packed.tan", writes="packed.tan")
    failures = ["%s of %s: %s" % (", ".join(changes), kind.name, one) for one in judge.failures]
    outcome = "refused by all" if judge.done == 0 else "unpacked" if done else "refused by some"
    return outcome, failures, {"runs": judge.done + judge.refused}
