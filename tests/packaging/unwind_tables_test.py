#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""unwind_tables_test.py LEAST PATH...: an exception finds its way through every function of the programs and libraries.

Where one is thrown, the C++ library looks up each function on its way in a table that is sorted by where functions begin, and
takes the last entry that does not begin behind the place. The compiler cuts functions in two, a part that runs often and one
that does not, and the second may be empty: its entry begins where another function does. Should the linker put it behind that
function's, the function cannot be found, and the program ends where an error should be told.
"""
import struct
import sys
from pathlib import Path

EH_FRAME_HEADER = 0x6474E550  # PT_GNU_EH_FRAME
SORTED_TABLE = bytes([1, 0x1B, 0x03, 0x3B])  # version, pointer from here, 32 bits of count, 32 bits relative to the table
LOADED = 1


def segments(data):
    """(type, offset, address, size) of each program header of a 64-bit ELF file."""
    offset, = struct.unpack_from("<Q", data, 32)
    size, count = struct.unpack_from("<HH", data, 54)
    for header in range(offset, offset + size * count, size):
        kind, _, at, address, _, length = struct.unpack_from("<IIQQQQ", data, header)
        yield kind, at, address, length


def unwind_table(data):
    """(where a function begins, how long it is) of each entry, in the table's order."""
    parts = list(segments(data))
    header = next((part for part in parts if part[0] == EH_FRAME_HEADER), None)
    if header is None:
        return []
    _, at, address, _ = header
    if data[at : at + 4] != SORTED_TABLE:
        raise ValueError("its table of functions is of another kind than this test reads")

    def offset_of(place):
        for kind, start, first, length in parts:
            if kind == LOADED and first <= place < first + length:
                return place - first + start
        raise ValueError(f"nothing is loaded at {place:#x}")

    count, = struct.unpack_from("<I", data, at + 8)
    entries = []
    for begin, entry in struct.iter_unpack("<ii", data[at + 12 : at + 12 + 8 * count]):
        # length, common part, begin and size of the function
        size, = struct.unpack_from("<I", data, offset_of(address + entry) + 12)
        entries.append((begin, size))
    return entries


def hidden(entries):
    """The functions before which an empty one is found."""
    for i, (begin, size) in enumerate(entries):
        isLast = i + 1 == len(entries) or entries[i + 1][0] != begin
        if isLast and size == 0 and any(b == begin and s > 0 for b, s in entries[max(0, i - 8) : i]):
            yield begin


def files_of(path):
    files = sorted(path.rglob("*")) if path.is_dir() else [path]
    for file in files:
        if file.is_file() and not file.is_symlink() and file.open("rb").read(5) == b"\x7fELF\x02":
            yield file


def main(least, *paths):
    assert list(hidden([(0, 8), (8, 0), (8, 4), (12, 4)])) == []  # what the unwinder takes is the function
    assert list(hidden([(0, 8), (8, 4), (8, 0), (12, 4)])) == [8]
    checked = bad = 0
    for file in (file for path in paths for file in files_of(Path(path))):
        entries = unwind_table(file.read_bytes())
        checked += bool(entries)
        places = list(hidden(entries))
        if places:
            bad += 1
            print(f"FAIL: {file}: an exception cannot pass {len(places)} of {len(entries)} functions. Use another linker.")
    if checked < int(least):
        print(f"FAIL: only {checked} files have a table")
        bad += 1
    print(f"{checked} files")
    return bad > 0


sys.exit(main(*sys.argv[1:]))
