// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/process/found_dataset.h"

#include "plugins/api/cells_parameters.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace tetra {
namespace {

std::uint64_t product(const std::array<std::uint32_t, 3>& size)
{
    return std::uint64_t(size[0]) * size[1] * size[2];
}

Result<ScalarField> fieldOf(FileFindings& found, std::uint64_t points, const Progress& progress)
{
    if (found.samples.size() / sampleSize(found.type) != points)
        return Error{ErrorKind::BadInput,
                     Message::say("its array '%1' has %2 values for %3 points.", printable(found.arrayName),
                                  found.samples.size() / sampleSize(found.type), points)};
    const auto samples = std::make_shared<const Buffer<std::byte>>(std::move(found.samples));
    return ScalarField::scanned(found.type, points, {samples, samples->data()}, progress);
}

std::vector<double> doublesOf(const FileFindings& found)
{
    std::vector<double> values(found.samples.size() / sizeof(double));
    std::memcpy(values.data(), found.samples.data(), values.size() * sizeof(double));
    return values;
}

Result<Dataset> gridDataset(FileFindings& found, const Progress& progress)
{
    const auto& size = found.lattice.size;
    if (const Status fits = checkLatticeSize({size[0], size[1], size[2]}); !fits)
        return fits.error();
    Dataset dataset;
    dataset.lattice.size = size;
    const bool onLattice = found.kind == FoundKind::Lattice;
    dataset.domain = onLattice ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    if (onLattice) {
        dataset.lattice = found.lattice;
        if (const Status placed = checkLatticePlacement(dataset.lattice); !placed)
            return placed.error();
    } else {
        if (found.positions.size() != product(size))
            return Error{ErrorKind::BadInput, Message::say("it has %1 positions for a grid of %2 points.",
                                                           found.positions.size(), product(size))};
        dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(found.positions));
    }
    const auto values = fieldOf(found, product(size), progress);
    if (!values)
        return values.error();
    dataset.values = *values;
    if (!found.blanked.empty()) {
        std::vector<GridCell> cells(found.blanked.size());
        std::ranges::transform(found.blanked, cells.begin(), [](std::uint8_t cell) {
            return cell == 0 ? GridCell::Kept : cell == blankedForItsValue ? GridCell::NotFinite : GridCell::Blanked;
        });
        dataset.cells = std::make_shared<const std::vector<GridCell>>(std::move(cells));
    }
    if (const Status usable = onLattice || hasHoles(dataset) ? Status() : checkGrid(dataset); !usable)
        return usable.error();
    return dataset;
}

Status checkPoints(const FileFindings& found, std::span<const double> values)
{
    if (values.size() != found.positions.size())
        return Error{ErrorKind::BadInput,
                     Message::say("its array '%1' has %2 values for %3 points.", printable(found.arrayName),
                                  values.size(), found.positions.size())};
    if (values.empty())
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    if (values.size() > std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource,
                     Message::say("it has more than 4294967295 points. Take a part of them.")};
    for (std::size_t point = 0; point < values.size(); ++point)
        if (!isUsablePlace(found.positions[point]))
            return Error{
                ErrorKind::BadInput,
                Message::say("the position of point %1 (from 0) is not a number, or too large. Repair the file.",
                             point)};
    return {};
}

Result<Dataset> pointsDataset(FileFindings& found, const Source& source)
{
    std::vector<double> values = doublesOf(found);
    if (const Status usable = checkPoints(found, values); !usable)
        return usable.error();
    return scatteredDataset(std::move(found.positions), std::move(values), source.name);
}

Result<Dataset> cellsDataset(FileFindings& found, const Source& source,
                             const std::optional<Eigen::AlignedBox3d>& region, const Progress& progress,
                             const ParameterValues& choices)
{
    const ComplexValues values{doublesOf(found), found.perCell, found.type};
    found.samples = {};
    CellComplex complex{std::move(found.positions), std::move(found.shapes),  std::move(found.offsets),
                        std::move(found.corners),   std::move(found.blanked), region};
    if (const Status understood = applyCellsParameters(choices, complex); !understood)
        return understood.error();
    return irregularDataset(complex, values, source, progress);
}

} // namespace

Result<Dataset> datasetOf(FileFindings findings, const Source& source, const std::optional<Eigen::AlignedBox3d>& region,
                          const Progress& progress, const ParameterValues& values)
{
    const std::vector<Message> remarks = std::move(findings.remarks);
    auto dataset = findings.kind == FoundKind::Cells    ? cellsDataset(findings, source, region, progress, values)
                   : findings.kind == FoundKind::Points ? pointsDataset(findings, source)
                                                        : gridDataset(findings, progress);
    if (!dataset)
        return dataset.error();
    dataset->source = source;
    dataset->source.taken = std::move(findings.taken);
    dataset->source.leftOut = std::move(findings.leftOut);
    dataset->space = findings.space;
    dataset->lengthUnit = findings.lengthUnit;
    dataset->remarks.insert(dataset->remarks.begin(), remarks.begin(), remarks.end());
    return dataset;
}

} // namespace tetra
