// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/grid_findings.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr double largestSkew = 1e-9; ///< of a direction that counts as one along an axis

std::array<std::uint32_t, 3> sizeOf(const int* dimensions)
{
    std::array<std::uint32_t, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        size[axis] = dimensions[axis] > 0 ? static_cast<std::uint32_t>(dimensions[axis]) : 0;
    return size;
}

/// The axis of space along which this axis of the image runs; nothing if it runs across them.
std::optional<int> axisAlong(vtkMatrix3x3& directions, int column)
{
    std::optional<int> along;
    for (int row = 0; row < 3; ++row) {
        const double element = std::abs(directions.GetElement(row, column));
        if (std::abs(element - 1) <= largestSkew && !along)
            along = row;
        else if (element > largestSkew)
            return std::nullopt;
    }
    return along;
}

void placeImage(vtkImageData& image, VtkGrid& grid)
{
    vtkMatrix3x3& directions = *image.GetDirectionMatrix();
    image.GetPoint(0, grid.origin.data());
    grid.onLattice = true;
    std::array<bool, 3> taken{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = axisAlong(directions, axis);
        grid.onLattice = grid.onLattice && along && !taken[static_cast<std::size_t>(*along)];
        if (!grid.onLattice)
            return;
        taken[static_cast<std::size_t>(*along)] = true;
        grid.axes[static_cast<std::size_t>(axis)] = *along;
        grid.spacing[axis] = image.GetSpacing()[axis] * (directions.GetElement(*along, axis) < 0 ? -1 : 1);
    }
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
    grid.onLattice = true;
    for (int axis = 0; axis < 3; ++axis)
        grid.onLattice =
            grid.onLattice && coordinates[axis] != nullptr &&
            static_cast<std::uint64_t>(coordinates[axis]->GetNumberOfTuples()) == grid.size[std::size_t(axis)] &&
            isUniform(*coordinates[axis], grid.origin[axis], grid.spacing[axis]);
}

} // namespace

std::optional<VtkGrid> gridOf(vtkDataSet& data)
{
    VtkGrid grid;
    if (auto* image = vtkImageData::SafeDownCast(&data)) {
        grid.size = sizeOf(image->GetDimensions());
        placeImage(*image, grid);
        return grid;
    }
    if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) {
        grid.size = sizeOf(rectilinear->GetDimensions());
        placeRectilinear(*rectilinear, grid);
        return grid;
    }
    if (auto* structured = vtkStructuredGrid::SafeDownCast(&data)) {
        int dimensions[3] = {};
        structured->GetDimensions(dimensions);
        grid.size = sizeOf(dimensions);
        return grid;
    }
    return std::nullopt;
}

} // namespace tetra
