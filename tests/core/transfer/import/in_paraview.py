# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView itself as the judge of its presets; run by pvpython 5.11. Without its registry it forgets them afterwards.

    pvpython --disable-registry in_paraview.py looks < requests > looks
        Loads presets as ParaView's user does. Reads a JSON list of {"file": text of a ParaView file, "values": [...]}
        and writes for each a list of [red, green, blue, opacity]; null where a preset has no opacities.
    pvpython --disable-registry in_paraview.py facts > paraview_5_11.json
        Makes presets of its own, lets ParaView write them, and samples what ParaView makes of them: a JSON list of
        {"file": ..., "first": value, "last": value, "looks": [...]}, 256 samples over the values.
"""
import json
import os
import sys
import tempfile
import uuid

from paraview import servermanager, simple

SAMPLES = 256
# Value, red, green, blue: a dark and a pale colour, a grey, and two that lie far apart on the colour wheel.
COLOURS = [0.5, 0.05, 0.1, 0.4, 1.25, 0.9, 0.3, 0.15, 2.0, 0.6, 0.6, 0.6, 3.5, 0.95, 0.9, 0.2, 4.5, 0.1, 0.55, 0.85]
TWO_SIDES = [-1.0, 0.23, 0.3, 0.75, 2.0, 0.865, 0.865, 0.865, 3.0, 0.7, 0.02, 0.15]
# Value, opacity, midpoint, sharpness.
LINES = [0.5, 0.0, 0.5, 0.0, 1.0, 0.8, 0.5, 0.0, 2.25, 0.1, 0.5, 0.0, 4.5, 1.0, 0.5, 0.0]
BENT = [0.5, 0.1, 0.25, 0.0, 1.5, 0.9, 0.7, 0.4, 2.5, 0.2, 0.5, 0.8, 3.5, 0.7, 0.4, 1.0, 4.5, 0.3, 0.5, 0.0]
PRESETS = [
    ("RGB", COLOURS, LINES, {}),
    ("HSV", COLOURS, BENT, {}),
    ("HSV", COLOURS, LINES, {"HSVWrap": 1}),
    ("Lab", COLOURS, LINES, {}),
    ("Diverging", TWO_SIDES, BENT, {}),
    ("Step", COLOURS, LINES, {}),
    ("RGB", COLOURS, BENT, {"UseLogScale": 1}),
    ("Lab", COLOURS, None, {"UseLogScale": 1}),
]


def write(colours, opacities, name):
    """The file that ParaView writes."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "preset.json")
        proxy = opacities.SMProxy if opacities else None
        if not servermanager.vtkSMTransferFunctionProxy.ExportTransferFunction(colours.SMProxy, proxy, name, path):
            sys.exit("ParaView cannot write " + name)
        with open(path, encoding="utf-8") as file:
            return file.read()


def presets_of(text):
    """The names of the presets in a text that ParaView has loaded."""
    presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
    before = presets.GetNumberOfPresets()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "preset.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        if not presets.ImportPresets(path):
            sys.exit("ParaView refuses " + text)
    return [presets.GetPresetName(i) for i in range(before, presets.GetNumberOfPresets())]


def proxies(number):
    colours = simple.GetColorTransferFunction("colours%d" % number)
    colours.Discretize = 0
    return colours, simple.GetOpacityTransferFunction("opacities%d" % number)


def sampled(colours, opacities, values):
    colours.UpdateVTKObjects()
    colour = colours.GetClientSideObject()
    colour.Build()
    if opacities:
        opacities.UpdateVTKObjects()
    opacity = opacities.GetClientSideObject() if opacities else None
    looks = []
    for value in values:
        look = [0.0, 0.0, 0.0]
        colour.GetColor(value, look)
        looks.append(look + [opacity.GetValue(value) if opacity else None])
    return looks


def looks():
    answers = []
    with open(0, encoding="utf-8") as stdin:  # pvpython has another sys.stdin
        requests = json.load(stdin)
    for number, request in enumerate(requests):
        named = json.loads(request["file"])
        named[0]["Name"] = uuid.uuid4().hex  # ParaView may know others of the same name, from before
        name = presets_of(json.dumps(named))[0]
        colours, opacities = proxies(number)
        colours.ApplyPreset(name, False)
        has_opacities = bool(json.loads(request["file"])[0].get("Points"))
        if has_opacities:
            opacities.ApplyPreset(name, False)
        answers.append(sampled(colours, opacities if has_opacities else None, request["values"]))
        presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
        presets.RemovePreset(presets.GetNumberOfPresets() - 1)
    return answers


def facts():
    found = []
    for number, (space, points, nodes, more) in enumerate(PRESETS):
        colours, opacities = proxies(number)
        colours.RGBPoints = points
        colours.ColorSpace = space
        for name, value in more.items():
            setattr(colours, name, value)
        if nodes:
            opacities.Points = nodes
        opacities = opacities if nodes else None
        first, last = points[0] + 1e-4, points[-4] - 1e-4
        values = [first + (last - first) * i / (SAMPLES - 1) for i in range(SAMPLES)]
        rounded = [[None if channel is None else round(channel, 4) for channel in look]
                   for look in sampled(colours, opacities, values)]
        text = write(colours, opacities, "%s %d" % (space, number))
        found.append({"file": text, "first": first, "last": last, "looks": rounded})
    return found


if len(sys.argv) != 2 or sys.argv[1] not in ("looks", "facts"):
    sys.exit(__doc__)
answer = looks() if sys.argv[1] == "looks" else facts()
lines = [json.dumps(entry, separators=(",", ":")) for entry in answer]
print("[\n" + ",\n".join(lines) + "\n]")
