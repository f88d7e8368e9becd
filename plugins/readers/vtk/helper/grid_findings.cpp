// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/grid_findings.h"

#include "plugins/readers/vtk/helper/blanking.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

/// The mean of the cells around each point: in double precision for the wider types, else single.
VtkSamples meansAtPoints(const Size& size, const VtkSamples& cells)
{
    const std::vector<double> values = toDoubles(cells);
    std::vector<double> sums(product(size), 0);
    std::vector<std::uint8_t> counts(sums.size(), 0);
    forEachCell(size, [&](std::uint64_t cell, const auto& corners) {
        for (const std::uint64_t corner : corners) {
            sums[corner] += values[cell];
            ++counts[corner];
        }
    });
    VtkSamples points;
    points.name = cells.name;
    points.remarks = cells.remarks;
    points.remarks.push_back(
        Message::say("The values of the cells were brought to the points, as the mean of the cells around."));
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

/// Brings the samples of a lattice whose axes run backwards or are exchanged into the order of ascending x, y, z.
void straighten(const VtkGrid& grid, VtkFindings& found)
{
    std::array<std::int64_t, 3> stride{}; // in the samples, along each axis of space
    std::int64_t start = 0;
    std::int64_t step = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = static_cast<std::size_t>(grid.axes[axis]);
        const double spacing = grid.spacing[static_cast<Eigen::Index>(axis)];
        const std::int64_t last = std::int64_t(grid.size[axis]) - 1;
        found.size[along] = grid.size[axis];
        found.spacing[static_cast<Eigen::Index>(along)] = std::abs(spacing);
        if (spacing < 0) {
            found.origin[static_cast<Eigen::Index>(along)] += static_cast<double>(last) * spacing;
            start += last * step;
        }
        stride[along] = spacing < 0 ? -step : step;
        step *= grid.size[axis];
    }
    if (stride == std::array<std::int64_t, 3>{1, grid.size[0], std::int64_t(grid.size[0]) * grid.size[1]})
        return;
    const Buffer<std::byte> before = std::move(found.samples);
    const std::size_t bytes = sampleSize(found.type);
    found.samples = Buffer<std::byte>(before.size());
    std::byte* to = found.samples.data();
    for (std::int64_t k = 0; k < found.size[2]; ++k)
        for (std::int64_t j = 0; j < found.size[1]; ++j)
            for (std::int64_t i = 0; i < found.size[0]; ++i, to += bytes)
                std::memcpy(to,
                            before.data() +
                                static_cast<std::size_t>(start + i * stride[0] + j * stride[1] + k * stride[2]) * bytes,
                            bytes);
}

std::uint64_t countNotFinite(const VtkSamples& samples)
{
    return visitSampleType(samples.type, [&]<class T>() -> std::uint64_t {
        const T* first = reinterpret_cast<const T*>(samples.samples.data());
        return static_cast<std::uint64_t>(std::count_if(first, first + samples.samples.size() / sizeof(T), [](T value) {
            return !std::isfinite(static_cast<double>(value));
        }));
    });
}

/// The grid as hexahedra, for domains with holes.
Result<VtkFindings> asCells(vtkDataSet& data, const VtkGrid& grid, bool perCell, const VtkSamples& samples,
                            std::vector<std::uint8_t> blanked)
{
    constexpr std::uint64_t most = 20'000'000;
    const std::uint64_t cells = product({grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1});
    if (cells > most)
        return Error{
            ErrorKind::OutOfResource,
            Message::say(
                "some of its %1 cells are blanked out or have values that are no numbers, so that it is an irregular "
                "mesh, which is too large for that. Take a part of it, or replace those values by numbers.",
                cells)};
    VtkFindings found;
    found.kind = VtkDataKind::Cells;
    found.type = samples.type;
    found.arrayName = samples.name;
    found.remarks = samples.remarks;
    found.remarks.push_back(Message::say(
        "A grid with cells that are blanked out, or whose values are no numbers: an irregular mesh without them."));
    found.perCell = perCell;
    found.positions = positionsOf(data);
    const std::vector<double> values = toDoubles(samples);
    const std::span bytes = std::as_bytes(std::span(values));
    found.samples.assign(bytes.begin(), bytes.end());
    found.shapes.assign(cells, CellShape::Hexahedron);
    found.offsets.push_back(0);
    forEachCell(grid.size, [&](std::uint64_t, const auto& corners) {
        found.corners.insert(found.corners.end(), corners.begin(), corners.end());
        found.offsets.push_back(found.corners.size());
    });
    found.blanked = std::move(blanked);
    return found;
}

} // namespace

Result<VtkFindings> gridFindings(vtkDataSet& data, const VtkGrid& grid, const VtkArray& array, VtkSamples samples)
{
    const bool isVolume = std::ranges::all_of(grid.size, [](std::uint32_t points) { return points > 1; });
    const bool fits = static_cast<std::uint64_t>(data.GetNumberOfPoints()) == product(grid.size);
    if (isVolume && fits) { // otherwise it will be refused for its size
        std::vector<std::uint8_t> blanked = blankedCells(data);
        if (!blanked.empty() || countNotFinite(samples) > 0)
            return asCells(data, grid, array.perCell, samples, std::move(blanked));
        if (array.perCell)
            samples = meansAtPoints(grid.size, samples);
    }
    VtkFindings found;
    found.kind = grid.onLattice ? VtkDataKind::Lattice : VtkDataKind::Grid;
    found.size = grid.size;
    found.origin = grid.origin;
    found.type = samples.type;
    found.samples = std::move(samples.samples);
    found.arrayName = std::move(samples.name);
    found.remarks = std::move(samples.remarks);
    if (!grid.onLattice)
        found.positions = positionsOf(data);
    else if (isVolume && fits)
        straighten(grid, found);
    return found;
}

} // namespace tetra
