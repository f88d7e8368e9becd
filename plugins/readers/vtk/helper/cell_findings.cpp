// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/cell_findings.h"

#include "plugins/readers/vtk/helper/blanking.h"
#include "plugins/readers/vtk/helper/cell_shapes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>

#include <array>
#include <span>

namespace tetra {
namespace {

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
    return {ErrorKind::BadInput, Message::say("it has cells of a shape that TAn does not support: %1. Divide them into "
                                              "simpler ones, in ParaView with the filter Tetrahedralize or Tessellate.",
                                              cellTypeName(vtkType))};
}

Error noSuchPoint(vtkIdType cell, vtkIdType corner, vtkIdType points)
{
    return {ErrorKind::BadInput,
            Message::say("cell %1 (from 0) has the corner %2, and there are %3 points. It is damaged.", cell, corner,
                         points)};
}

/// Reads the cells of one mesh behind those that were found before.
class MeshCells {
public:
    MeshCells(vtkUnstructuredGrid& mesh, VtkFindings& found)
        : mesh_(mesh), found_(found), firstPoint_(found.positions.size()),
          degrees_(mesh.GetCellData()->GetHigherOrderDegrees())
    {
    }

    Status run()
    {
        if (found_.offsets.empty())
            found_.offsets.push_back(0);
        for (vtkIdType cell = 0; cell < mesh_.GetNumberOfCells(); ++cell)
            if (const Status added = add(cell); !added)
                return added;
        for (std::size_t change = 1; change < changed_.size(); ++change)
            if (changed_[change] > 0)
                found_.remarks.push_back(shapeChangeText(static_cast<ShapeChange>(change), changed_[change]));
        return {};
    }

private:
    Status add(vtkIdType cell)
    {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        mesh_.GetCells()->GetCellAtId(cell, count, corners);
        const int type = mesh_.GetCellType(cell);
        const auto reading = cellReading(type, count, degreesOf(cell));
        if (!reading)
            return unknownShape(type);
        ++changed_[static_cast<std::size_t>(reading->change)];
        found_.shapes.push_back(reading->shape);
        const Status added = reading->shape == CellShape::Polyhedron
                                 ? addFaces(cell, type, corners, count)
                                 : addCorners(cell, {corners, corners + reading->nodes});
        found_.offsets.push_back(found_.corners.size());
        return added;
    }

    /// The orders of a cell along its axes, which files tell of Lagrange and Bezier cells; zeros if this one does not.
    std::array<int, 3> degreesOf(vtkIdType cell) const
    {
        if (degrees_ == nullptr || degrees_->GetNumberOfComponents() != 3 || cell >= degrees_->GetNumberOfTuples())
            return {};
        const auto degree = [&](int axis) { return static_cast<int>(degrees_->GetComponent(cell, axis)); };
        return {degree(0), degree(1), degree(2)};
    }

    Status addCorners(vtkIdType cell, std::span<const vtkIdType> corners)
    {
        for (const vtkIdType corner : corners) {
            if (corner < 0 || corner >= mesh_.GetNumberOfPoints())
                return noSuchPoint(cell, corner, mesh_.GetNumberOfPoints());
            found_.corners.push_back(firstPoint_ + static_cast<std::uint64_t>(corner));
        }
        return {};
    }

    /// A polyhedron is told by its faces, of each the number of its points before them.
    Status addFaces(vtkIdType cell, int type, const vtkIdType* corners, vtkIdType count)
    {
        if (type != VTK_POLYHEDRON) {
            const std::vector<vtkIdType> faces = prismFaces(corners, count);
            return addFaces(cell, faces, count / 2 + 2);
        }
        vtkIdTypeArray* all = mesh_.GetFaces();
        vtkIdTypeArray* places = mesh_.GetFaceLocations();
        const vtkIdType length = all == nullptr ? 0 : all->GetNumberOfValues();
        const vtkIdType place = places == nullptr || cell >= places->GetNumberOfValues() ? -1 : places->GetValue(cell);
        if (place < 0 || place >= length)
            return Error{ErrorKind::BadInput,
                         Message::say("cell %1 (from 0) is a polyhedron, and VTK 9.1 finds no faces of it: since VTK "
                                      "9.4 they are written differently, which TAn reads in a single .vtu that is not "
                                      "compressed, or compressed with zlib. Save it as one.",
                                      cell)};
        const std::span<const vtkIdType> faces(all->GetPointer(0), static_cast<std::size_t>(length));
        const auto start = static_cast<std::size_t>(place);
        return addFaces(cell, faces.subspan(start + 1), faces[start]);
    }

    Status addFaces(vtkIdType cell, std::span<const vtkIdType> stream, vtkIdType faceCount)
    {
        for (; faceCount > 0; --faceCount) {
            const vtkIdType points = stream.empty() ? 0 : stream.front();
            if (points < 3 || points >= static_cast<vtkIdType>(stream.size()))
                return Error{ErrorKind::BadInput,
                             Message::say("a face of cell %1 (from 0) has %2 points, more than are listed, or fewer "
                                          "than three. It is damaged.",
                                          cell, points)};
            found_.corners.push_back(static_cast<std::uint64_t>(points));
            const auto length = static_cast<std::size_t>(points);
            if (const Status added = addCorners(cell, stream.subspan(1, length)); !added)
                return added;
            stream = stream.subspan(length + 1);
        }
        return {};
    }

    vtkUnstructuredGrid& mesh_;
    VtkFindings& found_;
    std::uint64_t firstPoint_;
    vtkDataArray* degrees_;
    std::array<std::uint64_t, 4> changed_{}; ///< how many cells, by ShapeChange
};

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
    const std::size_t cellsBefore = found.shapes.size();
    vtkCellArray* cells = mesh.GetCells();
    if (cells != nullptr && !cells->IsValid())
        return Error{ErrorKind::BadInput,
                     Message::say("the lists of its cells' corners contradict each other. It is damaged.")};
    if (const Status added = MeshCells(mesh, found).run(); !added)
        return added;
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
