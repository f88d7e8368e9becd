# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of points as programs write them: the value is the measured quantity, never a counter."""
import numpy

from bench import add, of_points
from samples import numbers, wave

COUNT = 90


def scattered(variant=0, whole=False):
    """Places of no order, of three digits, and values of five."""
    random = numpy.random.default_rng(5)
    places = numpy.round(random.uniform((10, 20, -30), (26, 35, -18), (COUNT, 3)), 3)
    return places, numpy.round(numbers(wave(places, variant), "f8"), 5)


def table(folder, columns, ending=".csv", between=",", head="{names}", title=(), quoted=False, options=(), tail="", crlf=False, opened="points", name=None,
          counts=False, take="value", **said):
    """columns: the name of each in the file -> x, y, z, value, other, index (from 0 or 1), constant, block."""
    places, values = scattered()
    content = {"x": places[:, 0], "y": places[:, 1], "z": places[:, 2], "value": values, "other": numpy.round(numbers(wave(places, 1), "f8"), 5),
               "index": numpy.arange(COUNT), "index1": numpy.arange(1, COUNT + 1), "constant": numpy.full(COUNT, 7), "block": numpy.zeros(COUNT, int),
               "depth": -places[:, 2]}
    names = [f'"{one}"' if quoted else one for one, _ in columns]
    lines = [line.format(names=between.join(names), count=COUNT) for line in (*title, *([head] if head else []))]
    lines += [between.join(repr(content[what][row].item()) for _, what in columns) + tail for row in range(COUNT)]
    file = folder / f"{opened}{ending}"
    file.write_bytes(("\r\n" if crlf else "\n").join(lines + [""]).encode())
    return of_points(file, places, content[take], options, **said)


def col(text, kinds="x y z value"):
    """'a b c' and 'x y z' -> pairs; names with blanks are separated by |."""
    return list(zip(text.split("|") if "|" in text else text.split(), kinds.split()))


TABLES = {
    "x, y, z, temperature": dict(columns=col("x y z temperature"), taken={"array": "temperature", "columns": "x.*y.*z"}),
    "value first": dict(columns=col("T x y z", "value x y z"), taken={"array": "^T$"}),
    "pandas' index": dict(columns=col("|x|y|z|temperature", "index x y z value"), taken={"array": "temperature"}),
    "ANSYS Mechanical": dict(columns=col("Node Number|X Location (mm)|Y Location (mm)|Z Location (mm)|Total Deformation (mm)", "index1 x y z value"),
                             between="\t", ending=".txt", taken={"array": "Total Deformation"}),
    "ANSYS Fluent": dict(columns=col("nodenumber|    x-coordinate|    y-coordinate|    z-coordinate|     temperature", "index1 x y z value"),
                         between=", ", taken={"array": "temperature", "columns": "x-coordinate.*y-coordinate.*z-coordinate"}),
    "ANSYS Fluent, without an ending of its own": dict(columns=col("nodenumber|x-coordinate|y-coordinate|z-coordinate|pressure", "index1 x y z value"),
                                                     between=",", ending=".txt", taken={"array": "pressure"}),
    "ANSYS CFX": dict(columns=col("X [ m ]| Y [ m ]| Z [ m ]| Temperature [ K ]"), title=("", "[Name]", "Domain", "", "[Data]"), between=", ",
                      taken={"array": "Temperature"}),
    "ANSYS CFX, node numbers": dict(columns=col("Node Number| X [ m ]| Y [ m ]| Z [ m ]| Pressure [ Pa ]", "index x y z value"),
                                    title=("", "[Name]", "Domain", "", "[Data]"), between=", ", taken={"array": "Pressure"}),
    "STAR-CCM+": dict(columns=col("Temperature (K)|X (m)|Y (m)|Z (m)", "value x y z"), quoted=True, taken={"array": "Temperature"}),
    "COMSOL": dict(columns=col("x y z T"), head="% {names}", title=("% Model: bench.mph", "% Dimension: 3", "% Nodes: {count}"), between="   ", ending=".txt"),
    "ParaView's points": dict(columns=col("temperature|Points:0|Points:1|Points:2", "value x y z"), quoted=True, taken={"array": "temperature"}),
    "ParaView's spreadsheet": dict(columns=col("Block Number|Point ID|Points_0|Points_1|Points_2|temperature", "block index x y z value"), quoted=True,
                                   taken={"array": "temperature"}),
    "easting, northing, elevation": dict(columns=col("id Easting Northing Elevation Cu_ppm", "index1 x y z value"),
                                         taken={"array": "Cu_ppm", "columns": "Easting.*Northing.*Elevation"}),
    "lon, lat, depth": dict(columns=col("lon lat depth salinity"), taken={"array": "salinity", "columns": "lon.*lat.*depth"}),
    "longitude, latitude, altitude": dict(columns=col("Longitude Latitude Altitude Ozone"), taken={"array": "Ozone"}),
    "coord_x": dict(columns=col("coord_x coord_y coord_z rho"), taken={"array": "rho"}),
    "centroids": dict(columns=col("id xc yc zc grade", "index1 x y z value"), taken={"array": "grade"}),
    "X (mm) with units": dict(columns=col("X (mm)|Y (mm)|Z (mm)|u (m/s)"), taken={"array": "u"}),
    "units under the names": dict(columns=col("x y z temperature"), head="{names}\nm,m,m,K", taken={"array": "temperature"}),
    "a constant first": dict(columns=col("material x y z temperature", "constant x y z value"), taken={"array": "temperature"}),
    "places last, a constant first": dict(columns=col("material temperature x y z", "constant value x y z"), taken={"array": "temperature"}),
    "two values": dict(columns=col("x y z temperature pressure", "x y z value other"), taken={"array": "temperature"}, guessed=("array",)),
    "two values, the second": dict(columns=col("x y z temperature pressure", "x y z value other"), options=("--array", "pressure"), take="other",
                                   taken={"array": "pressure"}),
    "places by number": dict(columns=col("a b c d", "value z y x"), options=("--positions", "4,3,2", "--array", "a")),
    "no names": dict(columns=col("x y z v"), head="", ending=".xyz", between=" "),
    "no names, tabs": dict(columns=col("x y z v"), head="", ending=".tsv", between="\t"),
    "semicolons": dict(columns=col("x y z temperature"), between=";", taken={"array": "temperature"}),
    "trailing comma, CR LF": dict(columns=col("x y z temperature"), tail=",", head="{names},", crlf=True, taken={"array": "temperature"}),
    "comment with names": dict(columns=col("x y z temperature"), head="# {names}", between=" ", ending=".txt", taken={"array": "temperature"}),
    "byte order mark": dict(columns=col("\ufeffx y z temperature"), taken={"array": "temperature"}),
}
GSLIB = ("points of the bench", "4")
for name, words in TABLES.items():
    add("table", "arrays", name, table, quick=name == "ANSYS Fluent", **words)
add("table, GSLIB", "arrays", "x, y, z, grade", table, columns=col("x y z v"), head="", title=(*GSLIB, "x", "y", "z", "grade"), between=" ", ending=".dat",
    taken={"array": "grade"})
add("table, GSLIB", "arrays", "Xlocation, Ylocation, Zlocation, Primary", table, columns=col("x y z v"), head="", ending=".dat", between="  ",
    title=(*GSLIB, "Xlocation", "Ylocation", "Zlocation", "Primary"), taken={"array": "Primary"})
add("table, Leica .pts", "arrays", "count, intensity", table, columns=col("x y z intensity"), head="", title=("{count}",), between=" ", ending=".pts")
