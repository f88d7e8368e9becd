// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/cell_findings.h"

#include "plugins/readers/vtk/helper/blanking.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkCellTypes.h>

#include <optional>
#include <span>

namespace tetra {
namespace {

std::optional<CellShape> shapeOf(int vtkType)
{
    switch (vtkType) {
    case VTK_TETRA: return CellShape::Tetrahedron;
    case VTK_PYRAMID: return CellShape::Pyramid;
    case VTK_WEDGE: return CellShape::Prism;
    case VTK_HEXAHEDRON: return CellShape::Hexahedron;
    case VTK_VOXEL: return CellShape::Voxel;
    case VTK_QUADRATIC_TETRA: return CellShape::QuadraticTetrahedron;
    case VTK_QUADRATIC_PYRAMID: return CellShape::QuadraticPyramid;
    case VTK_QUADRATIC_WEDGE: return CellShape::QuadraticPrism;
    case VTK_QUADRATIC_HEXAHEDRON: return CellShape::QuadraticHexahedron;
    case VTK_TRIQUADRATIC_HEXAHEDRON: return CellShape::TriquadraticHexahedron;
    case VTK_POLYHEDRON: return CellShape::Polyhedron;
    case VTK_QUADRATIC_EDGE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_QUADRATIC_POLYGON:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_CURVE:
    case VTK_BEZIER_TRIANGLE:
    case VTK_BEZIER_QUADRILATERAL: return CellShape::Flat;
    default: return vtkType >= VTK_EMPTY_CELL && vtkType <= VTK_QUAD ? std::optional(CellShape::Flat) : std::nullopt;
    }
}

/// The quadratic shape of so many corners, for cells that are called linear; nothing else has as many.
std::optional<CellShape> quadraticShape(CellShape shape, vtkIdType corners)
{
    switch (shape) {
    case CellShape::Tetrahedron: return corners == 10 ? std::optional(CellShape::QuadraticTetrahedron) : std::nullopt;
    case CellShape::Pyramid: return corners == 13 ? std::optional(CellShape::QuadraticPyramid) : std::nullopt;
    case CellShape::Prism: return corners == 15 ? std::optional(CellShape::QuadraticPrism) : std::nullopt;
    case CellShape::Hexahedron: return corners == 20 ? std::optional(CellShape::QuadraticHexahedron) : std::nullopt;
    default: return std::nullopt;
    }
}

void appendDoubles(const VtkSamples& samples, VtkFindings& found)
{
    const std::vector<double> values = toDoubles(samples);
    const std::span bytes = std::as_bytes(std::span(values));
    found.samples.insert(found.samples.end(), bytes.begin(), bytes.end());
}

void appendPositions(vtkDataSet& data, VtkFindings& found)
{
    const std::size_t before = found.positions.size();
    found.positions.resize(before + static_cast<std::size_t>(data.GetNumberOfPoints()));
    for (std::size_t point = before; point < found.positions.size(); ++point)
        data.GetPoint(static_cast<vtkIdType>(point - before), found.positions[point].data());
}

Error unknownShape(int vtkType)
{
    const char* name = vtkCellTypes::GetClassNameFromTypeId(vtkType);
    return {ErrorKind::BadInput,
            Message::say("it has cells of a shape that TAn does not know: %1. Divide them into simpler ones.",
                         name == nullptr ? Message::say("number %1", vtkType) : Message(name))};
}

void appendBlanked(vtkDataSet& data, std::size_t cellsBefore, VtkFindings& found)
{
    const std::vector<std::uint8_t> blanked = blankedCells(data);
    if (blanked.empty() && found.blanked.empty())
        return;
    found.blanked.resize(cellsBefore, 0);
    found.blanked.insert(found.blanked.end(), blanked.begin(), blanked.end());
    found.blanked.resize(found.shapes.size(), 0);
}

} // namespace

Status addCells(vtkUnstructuredGrid& mesh, const VtkArray& array, const VtkSamples& samples, VtkFindings& found)
{
    const std::uint64_t firstPoint = found.positions.size();
    const std::size_t cellsBefore = found.shapes.size();
    vtkCellArray* cells = mesh.GetCells();
    if (cells != nullptr && !cells->IsValid())
        return Error{ErrorKind::BadInput,
                     Message::say("the lists of its cells' corners contradict each other. It is damaged.")};
    if (found.offsets.empty())
        found.offsets.push_back(0);
    std::uint64_t wronglyLinear = 0;
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell) {
        const auto shape = shapeOf(mesh.GetCellType(cell));
        if (!shape)
            return unknownShape(mesh.GetCellType(cell));
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        cells->GetCellAtId(cell, count, corners);
        const auto quadratic = quadraticShape(*shape, count);
        wronglyLinear += quadratic ? 1 : 0;
        found.shapes.push_back(quadratic.value_or(*shape));
        for (vtkIdType corner = 0; corner < count; ++corner)
            if (corners[corner] < 0 || corners[corner] >= mesh.GetNumberOfPoints())
                return Error{ErrorKind::BadInput,
                             Message::say("cell %1 (from 0) has the corner %2, and there are %3 points. It is damaged.",
                                          cell, corners[corner], mesh.GetNumberOfPoints())};
            else
                found.corners.push_back(firstPoint + static_cast<std::uint64_t>(corners[corner]));
        found.offsets.push_back(found.corners.size());
    }
    if (wronglyLinear == 1)
        found.remarks.push_back(
            Message::say("1 cell is called linear and has the corners of a quadratic one: it was taken as such."));
    else if (wronglyLinear > 1)
        found.remarks.push_back(
            Message::say("%1 cells are called linear and have the corners of quadratic ones: they were taken as such.",
                         wronglyLinear));
    appendPositions(mesh, found);
    appendDoubles(samples, found);
    appendBlanked(mesh, cellsBefore, found);
    found.kind = VtkDataKind::Cells;
    found.type = samples.type;
    found.arrayName = samples.name;
    found.perCell = array.perCell;
    return {};
}

Result<VtkFindings> pointFindings(vtkDataSet& data, const VtkArray& array, const VtkSamples& samples)
{
    if (array.perCell)
        return Error{
            ErrorKind::BadInput,
            Message::say("its array '%1' has values for its polygons, not its points. Choose an array of points.",
                         printable(array.name))};
    VtkFindings found;
    found.kind = VtkDataKind::Points;
    found.type = samples.type;
    found.arrayName = samples.name;
    found.remarks = samples.remarks;
    appendPositions(data, found);
    appendDoubles(samples, found);
    return found;
}

} // namespace tetra
