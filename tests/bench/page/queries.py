# SPDX-License-Identifier: GPL-3.0-or-later
"""The section of the page about meshes out of models: extraction, foci."""
from figures import AskedPlot, Figure, Section
from results import Source

TYPES = ("uint8", "float")
BOXES = ("1", "5", "12.5", "25")
FOCI = ("1", "2", "5", "12.5", "25")


def of(kind, case, key, scale=1.0):
    return Source("extraction", f"c60 {{large}}^3 {kind}, {case}", key, scale=scale)


def closed_sets():
    figures = []
    for kind in TYPES:
        for case, label in [(f"box of {box} % by closed set", f"{kind}, box of {box} %") for box in BOXES] + [
                ("graded", f"{kind}, graded over the domain"), ("isovalue", f"{kind}, near an isovalue")]:
            figures.append(Figure(label, of(kind, case, "sites_per_second", 1e-6), 0.8, least=True))
    return tuple(figures)


def foci(what, key, asked, scale=1.0):
    return tuple(Figure(f"{kind}, {box} % {place}", of(kind, f"focus of {box} % {place}, {what}", key, scale), asked)
                 for kind in TYPES for place in ("at the centre", "on detail") for box in FOCI)


QUERIES = Section(
    "Meshes out of a model",
    "From the model of C60 at {large}^3, on one thread, with the file's pages in memory. Extraction is compared with copying as many bytes; "
    "a focus (0.5 % in a box, 4 % elsewhere; the percentage given is the box's share of the volume) inserts its sites, so that its time "
    "grows with the box; what is asked for is what somebody waits for who drags it.",
    (AskedPlot("extraction", "Extraction beside memcpy", "Share of the bandwidth of copying as many bytes; larger is better.", "% of memcpy",
               tuple(Figure(f"{kind}, mesh of {error} %", of(kind, f"extraction at {error} %", "share_of_copy_bandwidth", 100), 50, least=True)
                     for kind in TYPES for error in ("1", "0"))),
     AskedPlot("closed-sets", "Closed sets", "Meshes whose accuracy varies, found in the history alone; larger is better. The "
               "prototype found 0.8 to 2.5 million sites a second.",
               "million sites a second", closed_sets()),
     AskedPlot("focus", "A focus, afresh", "A quarter of a second is asked for; smaller is better.", "milliseconds",
               foci("afresh", "seconds", 250, 1e3), logarithmic=True),
     AskedPlot("focus-moved", "A focus that is dragged by 2 %", "25 steps a second are asked for; smaller is better.",
               "milliseconds", foci("dragged by 2 %", "seconds", 40, 1e3), logarithmic=True),
     AskedPlot("overhead", "What a focus costs in tetrahedra",
               "Over the number of uniform fine tetrahedra that meet the box plus coarse ones that do not; smaller is better.",
               "tetrahedra / fewest possible", foci("afresh", "overhead", 1.5)),
     AskedPlot("first-mesh", "From a file to a first mesh",
               "Opening the file and extracting the best mesh of so many tetrahedra; smaller is better.",
               "milliseconds",
               tuple(Figure(f"{kind}, {label} tetrahedra, {state}",
                            of(kind, f"opening and a first mesh of {number} tetrahedra, {state}", "seconds", 1e3))
                     for kind in TYPES for number, label in (("100000", "100,000"), ("1000000", "1,000,000")) for state in ("cold", "warm")))))
