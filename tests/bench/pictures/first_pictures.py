#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""First pictures, ours beside ParaView's: of twenty datasets the volume and the surface that each program shows after opening, with its defaults, at the
same size, without text, bar or box. In these steps:

    first_pictures.py draw BUILD DATA FOLDER    FOLDER/tan/NAME-volume.png and NAME-surface.png; the samples as files in FOLDER/samples
    first_pictures.py convert DATA FOLDER       FOLDER/converted/NAME.vtk, by VTK: files with appended data, which Debian 12's ParaView does not read
    paraview_pictures.py DATA FOLDER            the same by ParaView, in FOLDER/paraview (run it by ParaView's pvbatch)
    first_pictures.py ballot FOLDER             FOLDER/ballot/NUMBER.png, pairs side by side in random order, and FOLDER/key.json
    first_pictures.py count FOLDER VOTES...     of files with a line "NUMBER left|right|draw" each

A draw counts against us. The datasets were chosen before the first picture was made."""
import json
import pathlib
import random
import subprocess
import sys

SIZE = 800, 600
NOTHING_WRITTEN = dict.fromkeys(("colour_bar", "axes", "scale_bar", "title", "accuracy", "box_axes"), False)
DATASETS = {  # a name and its file
    "bucky": "buckyball/bucky_32x32x32_uint8.nhdr",
    "c60": "buckyball/c60large_128x128x128_uint8.nhdr",
    "aneurism": "regular/aneurism_256x256x256_uint8.nrrd",
    "bonsai": "regular/bonsai_256x256x256_uint8.nrrd",
    "engine": "regular/engine_256x256x128_uint8.nrrd",
    "headsq": "regular/headsq_64x64x93_int16.nrrd",
    "hydrogen": "regular/hydrogen_64x64x64_float.nrrd",
    "protein": "regular/ironProt.vtk",
    "lobster": "regular/lobster_120x120x34_uint8.nrrd",
    "neghip": "regular/neghip_64x64x64_uint8.nhdr",
    "sod": "sod/sod_97x97x116_uint8.nhdr",
    "bluntfin": "bluntfin/bluntfin.vts",
    "post": "post/post.vts",
    "bracket": "irregular/bracket_57k.vtu",
    "disk": "irregular/disk_out_ref_tet.vtu",
    "spx": "irregular/spx.vtu",
    "bluntfin-cells": "bluntfin/bluntfin_tet.vtu",
    "marschner-lobb": "samples/marschner-lobb.nrrd",
    "blunt-body": "samples/blunt-body.xyz",
    "part": "samples/part.vtu",
}


def input_of(name, data, folder):
    place = DATASETS[name]
    return (folder if place.startswith("samples/") else data) / place


def draw(build, data, folder):
    """As the window shows them: all that is not said is as the model is seen at first."""
    sys.path.insert(0, str(build / "lib" / "python3" / "dist-packages"))
    import tan as module  # only here: the other steps need none

    tan = build / "bin" / "tan"
    for part in ("samples", "models", "tan"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    for name, place in DATASETS.items():
        source = input_of(name, data, folder)
        if place.startswith("samples/") and not source.exists():
            subprocess.run([tan, "sample", source.stem, "-o", source], check=True)
        model = folder / "models" / f"{name}.tan"
        if not model.exists():
            subprocess.run([tan, "build", source, "-o", model], check=True)
        opened = module.open(str(model))
        for what, mode in (("volume", "volume"), ("surface", "isosurface")):
            opened.save_picture(str(folder / "tan" / f"{name}-{what}.png"), mode=mode, size=SIZE, settings={"outline": False}, **NOTHING_WRITTEN)


def convert(data, folder):
    from vtkmodules import vtkIOLegacy, vtkIOXML  # only here: ParaView has its own
    kinds = {".vts": (vtkIOXML.vtkXMLStructuredGridReader, vtkIOLegacy.vtkStructuredGridWriter), ".vtu": (vtkIOXML.vtkXMLUnstructuredGridReader, vtkIOLegacy.vtkUnstructuredGridWriter)}
    (folder / "converted").mkdir(parents=True, exist_ok=True)
    for name in DATASETS:
        source = input_of(name, data, folder)
        if source.suffix in kinds:
            reader, writer = (kind() for kind in kinds[source.suffix])
            reader.SetFileName(str(source))
            writer.SetInputConnection(reader.GetOutputPort())
            writer.SetFileName(str(folder / "converted" / f"{name}.vtk"))
            writer.SetFileTypeToBinary()
            writer.SetFileVersion(42)  # what ParaView and other programs of that age read
            writer.Write()


def ballot(folder):
    from PIL import Image  # only here: whoever draws need not have it
    (folder / "ballot").mkdir(exist_ok=True)
    pairs = [(name, what) for name in DATASETS for what in ("volume", "surface")]
    random.SystemRandom().shuffle(pairs)
    key = {}
    for number, (name, what) in enumerate(pairs, 1):
        sides = ["tan", "paraview"]
        random.SystemRandom().shuffle(sides)
        both = Image.new("RGB", (2 * SIZE[0] + 20, SIZE[1]), (128, 128, 128))
        for place, side in enumerate(sides):
            both.paste(Image.open(folder / side / f"{name}-{what}.png").convert("RGB"), (place * (SIZE[0] + 20), 0))
        both.save(folder / "ballot" / f"{number:02}.png")
        key[f"{number:02}"] = {"dataset": name, "what": what, "left": sides[0], "right": sides[1]}
    (folder / "key.json").write_text(json.dumps(key, indent=1))


def count(folder, votes):
    key = json.loads((folder / "key.json").read_text())
    for file in votes:
        ours = {"volume": [], "surface": []}
        theirs = {"volume": [], "surface": []}
        for line in file.read_text().splitlines():
            number, vote = line.split()[:2]
            pair = key[number]
            (ours if vote != "draw" and pair[vote] == "tan" else theirs)[pair["what"]].append(pair["dataset"] + (" (draw)" if vote == "draw" else ""))
        for what in ours:
            print(f"{file.name}: {what}: ours better in {len(ours[what])} of {len(ours[what]) + len(theirs[what])}; not in {', '.join(theirs[what]) or 'none'}")


if __name__ == "__main__":
    step, *places = sys.argv[1:]
    places = [pathlib.Path(place).resolve() for place in places]
    {"draw": draw, "convert": convert, "ballot": ballot, "count": lambda folder, *votes: count(folder, votes)}[step](*places)
