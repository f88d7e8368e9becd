# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of `./dev bench all`: which program with which words, and about how long it takes on two quiet cores."""
from dataclasses import dataclass

# Points, cells of a block and cells along an axis, sides of pictures, runs of which the median counts, datasets. A trial is over
# quickly; it shows that everything fits together, and its figures mean nothing.
FULL = {"small": 32, "middle": 64, "large": 128, "block": 16, "large_block": 32, "cells": 64, "picture": 512, "large_picture": 1024,
        "repeats": 5, "large_repeats": 2, "extractions": 9, "frames": 3, "surfaces": 7,
        "meshes": "BluntFin,Post,bracket,Bucky", "models": "c60,engine", "tables": "1,2,3,4", "vtk": ""}
TRIAL = {"small": 9, "middle": 17, "large": 18, "block": 4, "large_block": 8, "cells": 6, "picture": 32, "large_picture": 64,
         "repeats": 1, "large_repeats": 1, "extractions": 5, "frames": 3, "surfaces": 3,
         "meshes": "Bucky", "models": "c60", "tables": "2,4", "vtk": "--without-vtk"}


@dataclass(frozen=True)
class Step:
    name: str
    what: str
    program: str
    words: str  # with the names of sizes in braces
    minutes: float
    one_core: bool = True  # what runs on one thread is pinned: that makes runs comparable
    data: str = ""  # without this file in the folder of data the step is left out


STEPS = (
    Step("refinement", "building by refinement beside CGAL", "tan-bench-refinement",
         "--sizes {small},{middle} --types uint16 --blocks 0,{block},{large_block} --repeats {repeats}", 0.6),
    Step("refinement-large", "the same at the largest size", "tan-bench-refinement",
         "--sizes {large} --types uint16 --blocks 0,{block},{large_block} --repeats {large_repeats}", 2.5),
    Step("threads", "building in blocks on one thread and on two", "tan-bench-threads",
         "--size {large} --block {block} --repeats {large_repeats}", 0.8, one_core=False),
    Step("extraction", "meshes and foci out of a model", "tan-bench-extraction",
         "--size {large} --repeats {extractions}", 1.5),
    Step("volume", "pictures of volumes beside VTK", "tan-bench-rendering",
         "--parts volume --cells {cells} --frames {frames} --sizes {picture},{large_picture} {vtk}", 3, one_core=False),
    Step("surfaces", "isosurfaces beside VTK, and visibility orders", "tan-bench-rendering",
         "--parts isosurface,order --cells {cells} --frames {surfaces} {vtk}", 0.8, one_core=False),
    Step("hybrid", "volumes with surfaces, clip planes and light", "tan-bench-rendering",
         "--parts hybrid --cells {cells} --sizes {picture}", 0.6, one_core=False),
    Step("interaction", "a turntable, and edits in the window", "tan-bench-interaction",
         "--models {models} --size {large} --data {data}", 1.5, one_core=False),
    Step("decimation", "building by decimation beside VTK and CGAL", "tan-bench-decimation",
         "--meshes {meshes} --sizes 0 --data {data}", 1.5),
    Step("growth", "how the time of decimation grows", "tan-bench-decimation",
         "--meshes none --sizes {small},{middle},{large}", 1.5),
    Step("packed", "packing and unpacking", "tan-bench-packed", "c60:{small}:uint8 c60:{middle}:uint16 c60:{middle}:float", 1),
    Step("remote", "models by URL, far away", "tan-bench-remote", "--size {middle} --tetrahedra 100000", 0.5, one_core=False),
    Step("paper", "the paper's tables, made again", "tan",
         "reproduce --tables {tables} --data {data} -o {folder}/reproduction --json", 0.7, one_core=False,
         data="paper/table4.csv"),
)
