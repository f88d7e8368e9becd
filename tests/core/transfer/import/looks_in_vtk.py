# SPDX-License-Identifier: GPL-3.0-or-later
"""What presets look like to VTK, whose classes are those of ParaView: reads a JSON list of
{"file": text of a ParaView JSON file, "values": [...]} from stdin and writes for each a list of [red, green, blue,
opacity]; null where a preset has no opacities. Ends with 77 without python3-vtk9."""
import json
import sys

try:
    from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
    from vtkmodules.vtkRenderingCore import vtkColorTransferFunction
except ImportError:
    sys.exit(77)


def colours(preset):
    function = vtkColorTransferFunction()
    function.AllowDuplicateScalarsOn()
    getattr(function, "SetColorSpaceTo" + preset["ColorSpace"])()
    function.SetHSVWrap(int(preset.get("HSVWrap", 0)))
    points = preset["RGBPoints"]
    for i in range(0, len(points), 4):
        function.AddRGBPoint(*points[i:i + 4])
    if preset.get("UseLogScale"):
        function.SetScaleToLog10()
    return function


def opacities(preset):
    function = vtkPiecewiseFunction()
    function.AllowDuplicateScalarsOn()
    points = preset["Points"]
    for i in range(0, len(points), 4):
        function.AddPoint(*points[i:i + 4])
    return function


def looks(request):
    preset = json.loads(request["file"])[0]
    colour, opacity = colours(preset), opacities(preset)
    return [list(colour.GetColor(value)) + [opacity.GetValue(value) if preset["Points"] else None]
            for value in request["values"]]


json.dump([looks(request) for request in json.load(sys.stdin)], sys.stdout)
