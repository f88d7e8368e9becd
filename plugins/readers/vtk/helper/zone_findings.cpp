// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/zone_findings.h"

#include "plugins/readers/vtk/helper/blanking.h"
#include "plugins/readers/vtk/helper/grid_findings.h"

#include <tan/zones.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

namespace tetra {
namespace {

using Blanked = std::vector<std::uint8_t>;

std::shared_ptr<const std::vector<GridCell>> gridCells(const Blanked& blanked)
{
    if (blanked.empty())
        return nullptr;
    std::vector<GridCell> cells(blanked.size());
    std::ranges::transform(blanked, cells.begin(), [](std::uint8_t cell) {
        return cell == 0 ? GridCell::Kept : cell == blankedForItsValue ? GridCell::NotFinite : GridCell::Blanked;
    });
    return std::make_shared<const std::vector<GridCell>>(std::move(cells));
}

/// Adds the cells whose own value is no finite number.
void blankNotFinite(std::span<const double> values, Blanked& blanked)
{
    if (std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
        return;
    blanked.resize(values.size(), 0);
    for (std::size_t cell = 0; cell < values.size(); ++cell)
        if (blanked[cell] == 0 && !std::isfinite(values[cell]))
            blanked[cell] = blankedForItsValue;
}

/// The grid with its values of points, or zeros at them where those are of cells, which are added to `ofCells`.
Result<Dataset> zoneDataset(VtkZone zone, bool perCell, std::vector<double>& ofCells)
{
    const auto grid = gridOf(*zone.data);
    const auto points = static_cast<std::uint64_t>(zone.data->GetNumberOfPoints());
    if (!grid || points != grid->lattice.pointCount())
        return Error{ErrorKind::BadInput,
                     Message::say("its part '%1' has %2 points, and its size states another number.",
                                  printable(zone.name), points)};
    Dataset dataset;
    dataset.source.name = std::move(zone.name);
    dataset.domain = grid->onLattice ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    dataset.lattice.size = grid->lattice.size;
    if (grid->onLattice) {
        dataset.lattice = grid->lattice;
    } else {
        std::vector<Eigen::Vector3d> positions(points);
        for (std::size_t point = 0; point < points; ++point)
            zone.data->GetPoint(static_cast<vtkIdType>(point), positions[point].data());
        dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions));
    }
    Blanked blanked = blankedCells(*zone.data);
    if (perCell) {
        const std::vector<double> values = toDoubles(zone.samples);
        blankNotFinite(values, blanked);
        ofCells.insert(ofCells.end(), values.begin(), values.end());
        dataset.values = ScalarField::of(std::vector<std::uint8_t>(points, 0));
    } else {
        const auto samples = std::make_shared<const Buffer<std::byte>>(std::move(zone.samples.samples));
        dataset.values = ScalarField(zone.samples.type, points, {samples, samples->data()});
    }
    dataset.cells = gridCells(blanked);
    return dataset;
}

} // namespace

Result<VtkFindings> zoneFindings(std::vector<VtkZone> zones, bool perCell)
{
    VtkFindings found;
    found.kind = VtkDataKind::Cells;
    found.perCell = perCell;
    found.arrayName = zones.front().samples.name;
    found.type = zones.front().samples.type;
    std::vector<Dataset> grids;
    std::vector<double> values;
    for (VtkZone& zone : zones) {
        if (zone.samples.type != found.type)
            found.type = SampleType::Float64;
        for (const Message& remark : zone.samples.remarks)
            if (std::ranges::find(found.remarks, remark) == found.remarks.end())
                found.remarks.push_back(remark);
        auto grid = zoneDataset(std::move(zone), perCell, values);
        if (!grid)
            return grid.error();
        grids.push_back(*std::move(grid));
    }
    auto joined = joinZones(grids);
    if (!joined)
        return joined.error();
    grids.clear();
    CellComplex& complex = joined->complex;
    found.positions = std::move(complex.positions);
    found.shapes = std::move(complex.shapes);
    found.offsets = std::move(complex.offsets);
    found.corners = std::move(complex.corners);
    found.blanked = std::move(complex.blanked);
    std::ranges::move(joined->remarks, std::back_inserter(found.remarks));
    const std::span bytes = std::as_bytes(std::span(perCell ? values : joined->values.values));
    found.samples.insert(found.samples.end(), bytes.begin(), bytes.end());
    return found;
}

} // namespace tetra
