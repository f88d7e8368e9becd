# SPDX-License-Identifier: GPL-3.0-or-later
"""The sections of the page about building: refinement and decimation."""
from figures import AskedPlot, BesidePlot, Figure, LinePlot, Section
from results import Source

CGAL = "CGAL EPICK bulk insertion of all points"
LEVELS = (4, 3, 2, 1, 0.5, 0.2, 0.1)
BUCKY = "Bucky 32^3 to its coarsest mesh"
QUADRIC = "vtkUnstructuredGridQuadricDecimation"


def step_of(size):
    return "refinement-large" if size == "large" else "refinement"


def refined(size, key, block="", scale=1.0):
    blocks = f"in blocks of {{{block}}} " if block else ""
    return Source(step_of(size), f"c60 {{{size}}}^3 uint16 {blocks}to error 0, one thread", key, scale=scale)


def over_cgal(size, asked, block=""):
    label = f"{{{size}}}^3, " + (f"blocks of {{{block}}} cells" if block else "whole")
    return Figure(label, refined(size, "ratio", block), asked)


def per_site(block=""):
    return tuple((size, refined(size, "microseconds_per_site", block)) for size in ("small", "middle", "large")[1 if block else 0:])


def cgal_per_point():
    return tuple((size, Source(step_of(size), f"c60 {{{size}}}^3 uint16 to error 0, one thread", "yardstick_seconds", scale=1e6, points=size))
                 for size in ("small", "middle", "large"))


REFINEMENT = Section(
    "Refinement",
    "The synthetic C60 as uint16, refined to error 0 with its whole history on one thread, compared with CGAL's bulk insertion of *all* its "
    "points (EPICK, compact location) in the same run. Nine tenths of the points become sites.",
    (AskedPlot("refinement", "Refinement over CGAL's bulk insertion",
               "Time of a build to error 0, over CGAL's time for all points; smaller is better. Asked for is what the prototype took, which kept "
               "no model, and a tenth for the noise of machines.",
               "seconds / seconds of CGAL",
               (over_cgal("small", 0.40), over_cgal("middle", 0.52), over_cgal("large", 0.78), over_cgal("middle", 0.35, "block"),
                over_cgal("middle", 0.37, "large_block"), over_cgal("large", 0.35, "block"), over_cgal("large", 0.39, "large_block"))),
     LinePlot("refinement-growth", "What a site costs as the dataset grows", "One thread; lower is better. Blocks stay in the cache of the processor.",
              "points along an axis", "microseconds a site",
              (("TAn, whole", per_site()), ("CGAL, each point", cgal_per_point()), ("TAn, blocks", per_site("block")))),
     AskedPlot("memory", "Memory of a build into a file", "The peak of the process, data and program included; smaller is better.",
               "bytes a point",
               tuple(Figure(f"{{{size}}}^3, as a whole",
                            Source(step_of(size), f"c60 {{{size}}}^3 uint16, build into a file", "peak_bytes_per_site"))
                     for size in ("middle", "large"))),
     AskedPlot("threads", "Two threads against one", "Building in blocks into a file, times faster than on one thread; larger is better.",
               "times faster",
               (Figure("{large}^3, blocks of {block} cells",
                       Source("threads", "c60 {large}^3 uint16 in blocks of {block} into a file, 2 threads", "times_faster")),))))


def of_paper(table, dataset, variant, level, whose, key="sites"):
    name = f"table {table}, {dataset}{', ' + variant if variant else ''}, {level:g} %"
    first = dataset.partition(" ")[0]
    data = {"BluntFin": "BluntFin", "Post": "Post's grid", "SOD": "SOD"}.get(first, "Bucky")
    return Source("paper", name, f"{whose}_{key}", needs=("paper", f"table {table}", data))


def paper_bucky(level, whose):
    return of_paper(2, "BuckyBall 32x32x32", "", level, whose)


def decimated_bucky(level):
    return Source("decimation", BUCKY, f"sites_at_{level:g}_percent", needs=("Bucky",))


def fewer_sites(over):
    whose = "the paper's refinement" if over == "paper" else "our refinement"
    return tuple(Figure(f"{level:g} %, over {whose}", decimated_bucky(level), 1, over=paper_bucky(level, over)) for level in (4, 1, 0.1))


def judged(what):
    """Rows for each dataset and share of its tetrahedra: ours, VTK's."""
    rows = []
    for dataset in ("BluntFin", "Post", "bracket"):
        for share in (50, 20, 10):
            name = f"{dataset}, {share} % of ..."
            rows.append((f"{dataset}, {share} % kept",
                         tuple(Source("decimation", name, key, QUADRIC, needs=(f"{dataset}'s tetrahedra", "VTK")) for key in what)))
    return tuple(rows)


def over_vtk(mean):
    key = f"{'mean' if mean else 'largest'}_error_percent"
    return tuple(Figure(f"{label}, {'mean' if mean else 'largest'} error", ours, 1, over=vtk)
                 for label, (ours, vtk) in judged((f"ours_{key}", f"vtk_{key}")))


def of_c60(size, key, asked=None, scale=1.0):
    return Figure(f"C60 {{{size}}}^3", Source("growth", f"c60 {{{size}}}^3 to its coarsest mesh", key, scale=scale), asked)


DECIMATION = Section(
    "Decimation",
    "Half-edge collapse, the smallest exact error first. Compared with the paper: the sites of Bucky 32^3, with five tetrahedra in each "
    "cell, at the accuracies of Table 2. Compared with VTK: meshes of as many tetrahedra, both judged by the same code at all original "
    "vertices.",
    (LinePlot("sites", "Sites of Bucky 32^3 at each accuracy", "How many points a mesh needs; lower is better.", "error in % of the value range",
              "sites",
              (("the paper", tuple((level, paper_bucky(level, "paper")) for level in LEVELS)),
               ("our refinement", tuple((level, paper_bucky(level, "ours")) for level in LEVELS)),
               ("our decimation", tuple((level, decimated_bucky(level)) for level in LEVELS)))),
     AskedPlot("fewer-sites", "Sites of decimation over those of refinement", "Bucky 32^3; smaller is better, 1 is as many.", "sites / sites",
               fewer_sites("paper") + fewer_sites("ours")),
     BesidePlot("decimation-errors", "Largest errors of decimated meshes", "At the same number of tetrahedra; smaller is better.",
                "% of the value range", ("TAn", "VTK's quadrics"), judged(("ours_largest_error_percent", "vtk_largest_error_percent"))),
     AskedPlot("decimation-over-vtk", "Errors over those of VTK's quadrics", f"{QUADRIC}; smaller is better, 1 is the same.", "error / error",
               over_vtk(False) + over_vtk(True), logarithmic=True),
     BesidePlot("decimation-seconds", "Time of decimation",
                "Down to the mesh that was judged, with its history; smaller is better. Nothing was asked for.",
                "seconds", ("TAn", "VTK's quadrics"), judged(("seconds", "yardstick_seconds"))),
     AskedPlot("collapses", "Collapses a second", "One thread, down to the coarsest mesh; larger is better. How many depends on the machine.",
               "thousand a second",
               (Figure("Bucky 32^3", Source("decimation", BUCKY, "collapses_per_second", scale=1e-3, needs=("Bucky",))),)
               + tuple(of_c60(size, "collapses_per_second", scale=1e-3) for size in ("small", "middle", "large"))),
     AskedPlot("decimation-over-cgal", "Decimation over CGAL's bulk insertion",
               "Time of all collapses, with their history, over CGAL's time for inserting all points in the same run; smaller is better.",
               "seconds / seconds of CGAL",
               (Figure("Bucky 32^3", Source("decimation", BUCKY, "ratio", needs=("Bucky",)), 1.5),)
               + tuple(of_c60(size, "ratio") for size in ("small", "middle", "large"))),
     AskedPlot("growth", "How the time of decimation grows",
               "Time over n log n, where the smallest size is 1. The collapses grow no faster; a quarter is allowed for what no longer fits into "
               "the caches of the processor.",
               "times n log n",
               (of_c60("middle", "time_over_n_log_n", 1.25), of_c60("large", "time_over_n_log_n", 1.25)))))
