// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/lattice_steps.h"
#include "plugins/readers/vtk/helper/grid_findings.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <cmath>
#include <limits>

namespace tetra {
namespace {

std::array<std::uint32_t, 3> sizeOf(const int* dimensions)
{
    std::array<std::uint32_t, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        size[axis] = dimensions[axis] > 0 ? static_cast<std::uint32_t>(dimensions[axis]) : 0;
    return size;
}

void placeImage(vtkImageData& image, VtkGrid& grid)
{
    Eigen::Matrix3d directions;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            directions(row, column) = image.GetDirectionMatrix()->GetElement(row, column);
    Eigen::Vector3d origin;
    image.GetPoint(0, origin.data());
    grid.onLattice = true;
    placeByDirections(grid.lattice, directions, Eigen::Vector3d(image.GetSpacing()), origin);
}

/// Whether the coordinates are equal steps within the rounding of their type.
bool isUniform(vtkDataArray& coordinates, double& first, double& step)
{
    const vtkIdType count = coordinates.GetNumberOfTuples();
    if (count < 2)
        return false;
    first = coordinates.GetComponent(0, 0);
    const double last = coordinates.GetComponent(count - 1, 0);
    step = (last - first) / static_cast<double>(count - 1);
    const double unit = coordinates.GetDataType() == VTK_FLOAT ? std::numeric_limits<float>::epsilon()
                                                               : std::numeric_limits<double>::epsilon();
    const double rounding = 4 * unit * std::max(std::abs(first), std::abs(last));
    for (vtkIdType i = 0; i < count; ++i)
        if (!(std::abs(coordinates.GetComponent(i, 0) - (first + static_cast<double>(i) * step)) <= rounding))
            return false;
    return step != 0 && rounding < std::abs(step) / 100;
}

void placeRectilinear(vtkRectilinearGrid& data, VtkGrid& grid)
{
    vtkDataArray* const coordinates[] = {data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates()};
    Eigen::Vector3d first{0, 0, 0}, step{1, 1, 1};
    grid.onLattice = true;
    for (int axis = 0; axis < 3; ++axis)
        grid.onLattice = grid.onLattice && coordinates[axis] != nullptr &&
                         static_cast<std::uint64_t>(coordinates[axis]->GetNumberOfTuples()) ==
                             grid.lattice.size[std::size_t(axis)] &&
                         isUniform(*coordinates[axis], first[axis], step[axis]);
    if (grid.onLattice)
        placeBySteps(grid.lattice, step.asDiagonal(), first);
}

} // namespace

std::optional<VtkGrid> gridOf(vtkDataSet& data)
{
    VtkGrid grid;
    if (auto* image = vtkImageData::SafeDownCast(&data)) {
        grid.lattice.size = sizeOf(image->GetDimensions());
        placeImage(*image, grid);
        return grid;
    }
    if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) {
        grid.lattice.size = sizeOf(rectilinear->GetDimensions());
        placeRectilinear(*rectilinear, grid);
        return grid;
    }
    if (auto* structured = vtkStructuredGrid::SafeDownCast(&data)) {
        int dimensions[3] = {};
        structured->GetDimensions(dimensions);
        grid.lattice.size = sizeOf(dimensions);
        return grid;
    }
    return std::nullopt;
}

} // namespace tetra
