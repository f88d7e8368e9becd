#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes meshes.csv: what the models in this folder say of their meshes, read by FORMAT.md alone, by no code of the program's.

A line is a mesh that the model's levels name: sites, tetrahedra, and the SHA-1 of each site's point (u32), place (3 f32) and value (f32),
then of each tetrahedron's four points (u64), ascending, the tetrahedra in order.
"""
import csv
import hashlib
import pathlib
import struct

HERE = pathlib.Path(__file__).resolve().parent
SAMPLE_CODES = "BbHhIifd"


class Model:
    def __init__(self, path):
        data = path.read_bytes()
        section_count, = struct.unpack_from("<I", data, 20)
        sections = {}
        for number in range(section_count):
            entry = struct.unpack_from("<IIIIQQ", data, 256 + 64 * number)
            sections[entry[0]] = data[entry[4]:entry[4] + entry[5]]
        sample_type, size_x, size_y, _, sites = struct.unpack_from("<IIIII", data, 36)
        tetrahedra, = struct.unpack_from("<Q", data, 56)
        self.size = (size_x, size_y)
        self.spacing = struct.unpack_from("<3d", data, 64)
        self.origin = struct.unpack_from("<3d", data, 88)
        self.points = struct.unpack(f"<{sites}I", sections[16])
        self.values = struct.unpack(f"<{sites}{SAMPLE_CODES[sample_type]}", sections[17])
        self.star_offsets = struct.unpack(f"<{sites + 1}Q", sections[19])
        self.other_sites = struct.unpack(f"<{3 * tetrahedra}I", sections[32])
        self.destroyers = struct.unpack(f"<{tetrahedra}I", sections[33])
        self.positions = None
        if 22 in sections:
            code = "d" if len(sections[22]) == 24 * sites else "f"
            self.positions = struct.unpack(f"<{3 * sites}{code}", sections[22])

    def place(self, site):
        if self.positions:
            return self.positions[3 * site:3 * site + 3]
        point = self.points[site]
        x, y = self.size
        lattice = (point % x, point // x % y, point // x // y)
        return [self.origin[axis] + self.spacing[axis] * lattice[axis] for axis in range(3)]

    def mesh(self, sites):
        """The number of its tetrahedra, and the sum."""
        tetrahedra = []
        for creator in range(sites):
            for number in range(self.star_offsets[creator], self.star_offsets[creator + 1]):
                if self.destroyers[number] >= sites:
                    corners = (creator, *self.other_sites[3 * number:3 * number + 3])
                    tetrahedra.append(sorted(self.points[corner] for corner in corners))
        total = hashlib.sha1()
        for site in range(sites):
            total.update(struct.pack("<I4f", self.points[site], *self.place(site), float(self.values[site])))
        for tetrahedron in sorted(tetrahedra):
            total.update(struct.pack("<4Q", *tetrahedron))
        return len(tetrahedra), total.hexdigest()


def main():
    with open(HERE / "meshes.csv", "w", encoding="ascii", newline="\n") as output:
        output.write("model,sites,tetrahedra,sha1\n")
        for path in sorted(HERE.glob("*/*.tan")):
            model = Model(path)
            with open(path.with_suffix(".csv"), encoding="ascii") as levels:
                site_counts = sorted({int(level["sites"]) for level in csv.DictReader(levels)})
            for sites in site_counts:
                tetrahedra, total = model.mesh(sites)
                output.write(f"{path.parent.name}/{path.stem},{sites},{tetrahedra},{total}\n")


main()
