# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a mesh file with VTK: read_with_vtk.py FILE FOLDER. Writes the bytes of every array into the folder (points,
cells, point.NAME, cell.NAME) and prints, as JSON, the types of the arrays and the field data. Exit code 77: no VTK."""
import json
import os
import sys

try:
    from vtkmodules.vtkCommonCore import vtkObject, vtkIdList
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)


def save(folder, name, array):
    name = name.replace("/", "_")
    with open(os.path.join(folder, name), "wb") as file:
        file.write(bytes(memoryview(array)) if array.GetNumberOfValues() > 0 else b"")


def main(path, folder):
    reader = vtkXMLUnstructuredGridReader() if path.lower().endswith(".vtu") else vtkUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    if not path.lower().endswith(".vtu"):
        reader.ReadAllScalarsOn()
        reader.ReadAllFieldsOn()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    told = {"errors": len(errors), "points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(),
            "arrays": {}, "facts": {}}
    if grid.GetNumberOfPoints() > 0:
        save(folder, "points", grid.GetPoints().GetData())
    corners = vtkIdList()
    told["tetrahedra only"] = all(grid.GetCellType(cell) == 10 for cell in range(grid.GetNumberOfCells()))
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
    print(json.dumps(told))


main(sys.argv[1], sys.argv[2])
