# SPDX-License-Identifier: GPL-3.0-or-later
"""The sections of the page about pictures: volumes, isosurfaces, orders, the paper's Table 4, the window."""
from building import of_paper
from figures import AskedPlot, BesidePlot, Figure, Section
from results import Source

PROJECTED = "vtkProjectedTetrahedraMapper"
CASTER = "vtkUnstructuredGridVolumeRayCastMapper"
CONTOUR = "vtkContour3DLinearGrid"
BLUNTFIN, SIGNAL = "BluntFin", "Marschner-Lobb {cells}^3"
SCENES = [(scene, size, threads) for scene in (BLUNTFIN, SIGNAL) for size in ("{picture}", "{large_picture}")
          for threads in ("1 thread", "2 threads")]
MESHES = (BLUNTFIN, "C60 {cells}^3", SIGNAL)


def needs(scene, *more):
    return (("BluntFin",) if scene == BLUNTFIN else ()) + more


def frame(scene, size, threads, key, mapper=PROJECTED):
    return Source("volume", f"{scene}, {size}, {threads}", key, mapper, needs=needs(scene, "VTK"))


def faster(mapper, asked, asked_large):
    return tuple(Figure(f"{scene}, {size}, {threads}", frame(scene, size, threads, "times_faster", mapper),
                        asked_large if size == "{large_picture}" else asked, least=True) for scene, size, threads in SCENES)


def surface(scene, threads, key, beside=CONTOUR, scale=1.0):
    return Source("surfaces", f"isosurface {scene}, {threads}", key, beside, scale, needs(scene, "VTK"))


def contours():
    figures = []
    for scene in MESHES:
        for threads in ("1 thread", "2 threads"):
            figures.append(Figure(f"{scene}, {threads}, as it comes", surface(scene, threads, "yardstick_seconds"), 8, least=True,
                                  over=surface(scene, threads, "without_index_seconds")))
            figures.append(Figure(f"{scene}, {threads}, with an index", surface(scene, threads, "times_faster"), 9, least=True))
    return tuple(figures)


def orders():
    return tuple(Figure(f"{scene}, {threads}", Source("surfaces", f"order {scene}, {threads}", "million_tetrahedra_per_second",
                                                      needs=needs(scene)), 60, least=True)
                 for scene in MESHES for threads in ("1 thread", "2 threads"))


VOLUMES = Section(
    "Pictures of volumes",
    "By the processor while the camera turns, so that each frame has its visibility order made anew; VTK draws the same mesh with the same "
    "transfer function, cameras and number of threads in the same run.",
    (BesidePlot("frames", "Seconds a frame", "Smaller is better; the axis is logarithmic.", "seconds", ("TAn", "VTK, projected", "VTK, ray caster"),
                tuple((f"{scene}, {size}, {threads}",
                       (frame(scene, size, threads, "seconds"), frame(scene, size, threads, "yardstick_seconds"),
                        frame(scene, size, threads, "yardstick_seconds", CASTER))) for scene, size, threads in SCENES)),
     AskedPlot("projected", "Times faster than VTK's projected tetrahedra", f"{PROJECTED}; larger is better.", "times faster", faster(PROJECTED, 6.5, 4)),
     AskedPlot("caster", "Times faster than VTK's ray caster", f"{CASTER}; larger is better.", "times faster", faster(CASTER, 9, 9)),
     AskedPlot("hybrid", "What comes with a volume", "One thread; time over that of the volume alone. Nothing was asked for.",
               "seconds / seconds of the volume alone",
               tuple(Figure(f"{scene}, {case}", Source("hybrid", f"{scene}, {{picture}}, {case}", "ratio", "the volume alone", needs=needs(scene)))
                     for scene in (BLUNTFIN, SIGNAL) for case in ("with two isosurfaces", "cut in halves", "lit", "with depth")))))

SURFACES = Section(
    "Isosurfaces and orders",
    f"Both make merged points and normals; the isovalue is the middle of the range. VTK's filter is {CONTOUR} without its scalar tree, on as many "
    "threads. *As it comes* looks at every tetrahedron; *with an index* skips groups of tetrahedra that the isovalue does not meet.",
    (AskedPlot("contour", "Times faster than VTK's contours", f"{CONTOUR}; larger is better.", "times faster", contours()),
     AskedPlot("order", "Visibility order", "Exact, from front to back; larger is better.", "million tetrahedra a second", orders())))


def table4(level, variant, whose, key):
    return of_paper(4, BLUNTFIN, variant, level, whose, key)


def table4_rows(key, paper_key):
    return tuple((f"BluntFin at {level} %", (table4(level, "normalised", "ours", key), table4(level, "as in the paper", "ours", key),
                                             table4(level, "normalised", "paper", paper_key))) for level in (0, 1, 4))


def sites_rows():
    models = ((1, "BluntFin 40x32x32", "normalised", "BluntFin"), (1, "Post 38x76x38", "normalised", "Post"), (2, "SOD 32x32x32", "", "SOD"),
              (2, "BuckyBall 32x32x32", "", "Bucky"), (3, "BuckyBall 32x32x32", "", "Bucky in blocks of 8 cells"))
    return tuple((f"Table {table}: {label}", tuple(of_paper(table, dataset, variant, 1, whose) for whose in ("ours", "paper")))
                 for table, dataset, variant, label in models)


PAPER = Section(
    "The paper's tables",
    "All levels of Tables 1 to 3 are written by `tan reproduce`; here are the sites at 1 %. Table 4 is BluntFin drawn as a volume. The paper's machine was of 1997; ours draws 512 x 512 pixels by the processor. *As in the paper* is the "
    "mesh that the paper's choice of points gives, which has more sites; the other one is TAn's own choice.",
    (BesidePlot("tables", "Sites at an error of 1 %", "By refinement, with a warping of 1 % for curvilinear grids; smaller is better.",
                "sites", ("TAn", "the paper"), sites_rows(), logarithmic=False),
     BesidePlot("table4", "BluntFin as a volume", "Smaller is better; the axis is logarithmic.", "seconds a picture",
                ("TAn, own choice", "TAn, as in the paper", "the paper"), table4_rows("volume_seconds", "volume_seconds")),
     BesidePlot("table4-sites", "The sites of these meshes of BluntFin", "At the same accuracy; smaller is better.", "sites",
                ("TAn, own choice", "TAn, as in the paper", "the paper"), table4_rows("sites", "sites"), logarithmic=False)))

MODELS = (("c60 {large}^3", "C60 {large}^3", ()), ("engine 256x256x128", "engine", ("engine",)))


def moved(key, asked, least, scale=1.0):
    return tuple(Figure(label, Source("interaction", f"{name}, ... 2 threads, median frame", key, scale=scale, needs=lacking), asked, least)
                 for name, label, lacking in MODELS)


def edited(case, key, label, asked=None):
    return tuple(Figure(f"{model}, {label}", Source("interaction", f"{name}, {case}", key, scale=1e3, needs=lacking), asked)
                 for name, model, lacking in MODELS)


INTERACTION = Section(
    "In the window",
    "A turntable of 200 frames at 800x600 as a volume by the processor, two threads, with the mesh that the window shows at first; then it "
    "is let go. After that edits of the transfer function in the window at 1366x768.",
    (AskedPlot("interaction", "Pictures while the camera moves", "Frames a second; larger is better.", "frames a second",
               moved("frames_per_second", 15, True)),
     AskedPlot("budget", "Frames within a fifteenth of a second", "After the first second; larger is better.", "% of the frames",
               moved("share_in_budget", 95, True, 100)),
     AskedPlot("full-picture", "After letting go", "Up to the full picture; smaller is better.", "seconds", moved("full_picture_seconds", 2, False)),
     AskedPlot("edits", "From an edit to its picture", "Medians, and the worst; smaller is better.", "milliseconds",
               edited("edit to picture while dragging", "seconds", "dragging", 100)
               + edited("edit to picture while dragging", "worst_seconds", "dragging, the worst")
               + edited("edit to first picture, one at a time", "seconds", "one at a time", 100)
               + edited("edit to first picture, one at a time", "worst_seconds", "one at a time, worst"))))
