// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/grid_findings.h"

#include "plugins/readers/vtk/helper/blanking.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

using Size = std::array<std::uint32_t, 3>;

std::uint64_t product(const Size& size)
{
    return std::uint64_t(size[0]) * size[1] * size[2];
}

std::vector<Eigen::Vector3d> positionsOf(vtkDataSet& data)
{
    std::vector<Eigen::Vector3d> positions(static_cast<std::size_t>(data.GetNumberOfPoints()));
    for (std::size_t point = 0; point < positions.size(); ++point)
        data.GetPoint(static_cast<vtkIdType>(point), positions[point].data());
    return positions;
}

/// Calls `function(cell, corners)` with the eight corners of each cell in VTK's order of a hexahedron.
template <class Function> void forEachCell(const Size& size, const Function& function)
{
    const std::uint64_t row = size[0];
    const std::uint64_t slice = row * size[1];
    std::uint64_t cell = 0;
    for (std::uint64_t k = 0; k + 1 < size[2]; ++k)
        for (std::uint64_t j = 0; j + 1 < size[1]; ++j)
            for (std::uint64_t i = 0; i + 1 < size[0]; ++i) {
                const std::uint64_t p = k * slice + j * row + i;
                function(cell++, std::array{p, p + 1, p + row + 1, p + row, p + slice, p + slice + 1,
                                            p + slice + row + 1, p + slice + row});
            }
}

/// The mean of the cells around each point, NaN without any: in double precision for the wider types, else single.
/// Cells that are blanked out do not count, and those whose value is not finite are blanked out.
VtkSamples meansAtPoints(const Size& size, const VtkSamples& cells, std::vector<std::uint8_t>& blanked)
{
    const std::vector<double> values = toDoubles(cells);
    if (blanked.empty() && !std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
        blanked.resize(values.size(), 0);
    std::vector<double> sums(product(size), 0);
    std::vector<std::uint8_t> counts(sums.size(), 0);
    forEachCell(size, [&](std::uint64_t cell, const auto& corners) {
        if (!blanked.empty() && blanked[cell] == 0 && !std::isfinite(values[cell]))
            blanked[cell] = blankedForItsValue;
        if (!blanked.empty() && blanked[cell] != 0)
            return;
        for (const std::uint64_t corner : corners) {
            sums[corner] += values[cell];
            ++counts[corner];
        }
    });
    VtkSamples points;
    points.name = cells.name;
    points.remarks = cells.remarks;
    points.remarks.push_back(
        Message::say("The values of the cells were transferred to the points, as the mean of the cells around each."));
    points.type =
        cells.type == SampleType::Float64 || cells.type == SampleType::Int32 || cells.type == SampleType::UInt32
            ? SampleType::Float64
            : SampleType::Float32;
    points.samples.resize(sums.size() * sampleSize(points.type));
    for (std::size_t point = 0; point < sums.size(); ++point) {
        const double mean = sums[point] / counts[point];
        if (points.type == SampleType::Float64)
            reinterpret_cast<double*>(points.samples.data())[point] = mean;
        else
            reinterpret_cast<float*>(points.samples.data())[point] = static_cast<float>(mean);
    }
    return points;
}

} // namespace

Result<VtkFindings> gridFindings(vtkDataSet& data, const VtkGrid& grid, const VtkArray& array, VtkSamples samples)
{
    const bool isVolume = std::ranges::all_of(grid.lattice.size, [](std::uint32_t points) { return points > 1; });
    const bool fits = static_cast<std::uint64_t>(data.GetNumberOfPoints()) == product(grid.lattice.size);
    VtkFindings found;
    if (isVolume && fits) { // otherwise it will be refused for its size
        found.blanked = blankedCells(data);
        if (array.perCell)
            samples = meansAtPoints(grid.lattice.size, samples, found.blanked);
    }
    found.kind = grid.onLattice ? VtkDataKind::Lattice : VtkDataKind::Grid;
    found.lattice = grid.lattice;
    found.type = samples.type;
    found.samples = std::move(samples.samples);
    found.arrayName = std::move(samples.name);
    found.remarks = std::move(samples.remarks);
    if (!grid.onLattice)
        found.positions = positionsOf(data);
    return found;
}

} // namespace tetra
