# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads mesh and surface files with VTK, as long as it is asked to by lines of JSON, ["FILE", "FOLDER"]. Writes the bytes of
every array into the folder (points, cells, point.NAME, cell.NAME) and answers with a line of JSON, the types of the arrays and
the field data. Exit code 77: no VTK."""
import json
import os
import sys

try:
    from vtkmodules.vtkCommonCore import vtkObject, vtkIdList
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData
    from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkUnstructuredGridReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)


def save(folder, name, array):
    name = name.replace("/", "_")
    with open(os.path.join(folder, name), "wb") as file:
        file.write(bytes(memoryview(array)) if array.GetNumberOfValues() > 0 else b"")


def legacy_reader(path):
    with open(path, "rb") as file:
        surface = b"DATASET POLYDATA" in file.read(200)
    reader = vtkPolyDataReader() if surface else vtkUnstructuredGridReader()
    reader.ReadAllScalarsOn()
    reader.ReadAllNormalsOn()
    reader.ReadAllFieldsOn()
    return reader


def stl_reader(_):
    reader = vtkSTLReader()
    reader.MergingOff()
    return reader


READERS = {"vtu": lambda _: vtkXMLUnstructuredGridReader(), "vtp": lambda _: vtkXMLPolyDataReader(),
           "vtk": legacy_reader, "stl": stl_reader, "obj": lambda _: vtkOBJReader(), "ply": lambda _: vtkPLYReader(),
           "glb": lambda _: vtkGLTFReader()}


def joined(blocks):
    """The surfaces of a tree of blocks as one."""
    appended = vtkAppendPolyData()
    leaves = blocks.NewIterator()
    while not leaves.IsDoneWithTraversal():
        appended.AddInputData(leaves.GetCurrentDataObject())
        leaves.GoToNextItem()
    appended.Update()
    return appended.GetOutput()


def read(path, folder):
    ending = path.lower().rpartition(".")[2]
    reader = READERS[ending](path)
    errors = []
    reader.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    reader.SetFileName(path)
    reader.Update()
    grid = joined(reader.GetOutput()) if ending == "glb" else reader.GetOutput()
    told = {"errors": len(errors), "points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(),
            "arrays": {}, "facts": {}}
    if grid.GetNumberOfPoints() > 0:
        save(folder, "points", grid.GetPoints().GetData())
    corners = vtkIdList()
    told["cell types"] = sorted({grid.GetCellType(cell) for cell in range(grid.GetNumberOfCells())})
    with open(os.path.join(folder, "cells"), "wb") as file:
        for cell in range(grid.GetNumberOfCells()):
            grid.GetCellPoints(cell, corners)
            for corner in range(corners.GetNumberOfIds()):
                file.write(corners.GetId(corner).to_bytes(4, "little"))
    for kind, data in (("point", grid.GetPointData()), ("cell", grid.GetCellData())):
        told["active " + kind] = data.GetScalars().GetName() if data.GetScalars() else ""
        for number in range(data.GetNumberOfArrays()):
            array = data.GetArray(number)
            told["arrays"][kind + "." + array.GetName()] = array.GetDataTypeAsString()
            save(folder, kind + "." + array.GetName(), array)
    facts = grid.GetFieldData()
    for number in range(facts.GetNumberOfArrays()):
        told["facts"][facts.GetArrayName(number)] = facts.GetAbstractArray(number).GetValue(0)
    told["active normals"] = grid.GetPointData().GetNormals().GetName() if grid.GetPointData().GetNormals() else ""
    return told


for line in sys.stdin:
    print(json.dumps(read(*json.loads(line))), flush=True)
