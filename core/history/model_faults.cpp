// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sort_unique.h"
#include "core/history/derived_sections.h"
#include "core/history/site_positions.h"

#include <tan/model.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tetra {

namespace {

using format::Fault;
using format::FaultKind;

/// The faults of a grid's cells; behind them are those of tetrahedra.
std::span<const Fault> faultsOfCells(std::span<const Fault> faults)
{
    const auto end = std::ranges::partition_point(faults, [](const Fault& fault) {
        return fault.kind < static_cast<std::uint32_t>(FaultKind::InvertedTetrahedron);
    });
    return {faults.begin(), end};
}

/// The points at the corners of a grid's cell, as those of a hexahedron; below the number of cells.
std::array<std::uint64_t, 8> cornersOfGridCell(const Lattice& lattice, std::uint64_t cell)
{
    const std::uint64_t cellsX = lattice.size[0] - 1, cellsY = lattice.size[1] - 1;
    const auto x = static_cast<std::uint32_t>(cell % cellsX), y = static_cast<std::uint32_t>(cell / cellsX % cellsY),
               z = static_cast<std::uint32_t>(cell / cellsX / cellsY);
    std::array<std::uint64_t, 8> corners{};
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
        const std::uint32_t inLayer = corner & 3;
        corners[corner] =
            lattice.index(x + (inLayer == 1 || inLayer == 2 ? 1 : 0), y + (inLayer >> 1), z + (corner >> 2));
    }
    return corners;
}

/// Where some points of a grid lie, as far as its model knows.
class GridPlaces {
public:
    /// `points` ascend.
    static Result<GridPlaces> find(const Model& model, std::vector<std::uint64_t> points)
    {
        GridPlaces found(std::move(points));
        const auto ofSamples = [&](auto positions) {
            for (std::size_t i = 0; i < found.points_.size(); ++i)
                if (model.check(positions[found.points_[i]]))
                    found.places_[i] = positions[found.points_[i]].template cast<double>();
        };
        if (!model.floatSamplePositions().empty())
            ofSamples(model.floatSamplePositions());
        else if (!model.doubleSamplePositions().empty())
            ofSamples(model.doubleSamplePositions());
        else
            found.findSites(model);
        if (const Status intact = model.checkIntact(); !intact)
            return intact.error();
        return found;
    }

    const std::optional<Eigen::Vector3d>& of(std::uint64_t point) const
    {
        return places_[static_cast<std::size_t>(std::ranges::lower_bound(points_, point) - points_.begin())];
    }

private:
    explicit GridPlaces(std::vector<std::uint64_t> points) : points_(std::move(points)), places_(points_.size()) {}

    void findSites(const Model& model)
    {
        if (!model.check(model.points()) || !model.check(model.floatPositions()) ||
            !model.check(model.doublePositions()))
            return;
        for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
            const auto point = std::ranges::lower_bound(points_, std::uint64_t(model.points()[site]));
            if (point != points_.end() && *point == model.points()[site])
                places_[static_cast<std::size_t>(point - points_.begin())] = model.position(site);
        }
    }

    std::vector<std::uint64_t> points_;
    std::vector<std::optional<Eigen::Vector3d>> places_;
};

Result<std::vector<FaultyCell>> faultyCellsOfGrid(const Model& model, std::span<const Fault> faults)
{
    const Lattice& lattice = model.description().lattice;
    std::vector<FaultyCell> cells;
    std::vector<std::uint64_t> points;
    for (const Fault& fault : faults) {
        const bool isFolded = fault.kind == static_cast<std::uint32_t>(FaultKind::FoldedCell);
        if (fault.number >= lattice.cellCount())
            return inconsistentModel(model, Message::say("it lists a faulty cell that its grid does not have"));
        cells.push_back({fault.number, isFolded ? CellFault::Folded : CellFault::NoVolume, {}});
        std::ranges::copy(cornersOfGridCell(lattice, fault.number), std::back_inserter(points));
    }
    sortUnique(points);
    const Result<GridPlaces> places = GridPlaces::find(model, std::move(points));
    if (!places)
        return places.error();
    for (FaultyCell& cell : cells) {
        const std::array corners = cornersOfGridCell(lattice, cell.cell);
        if (std::ranges::all_of(corners, [&](std::uint64_t point) { return places->of(point).has_value(); }))
            for (const std::uint64_t point : corners)
                cell.corners.push_back(*places->of(point));
    }
    return cells;
}

Result<std::vector<FaultyCell>> cellsLeftOut(const Model& model, std::span<const format::FaultyCell> listed)
{
    std::vector<FaultyCell> cells;
    for (const format::FaultyCell& one : listed) {
        constexpr std::uint32_t fewest = 4, most = 8, none = 7;
        const auto isFinite = [](const std::array<double, 3>& place) {
            return std::ranges::all_of(place, [](double number) { return std::isfinite(number); });
        };
        if (one.corners < fewest || one.corners > most || one.corners == none ||
            one.fault > static_cast<std::uint32_t>(CellFault::Overlap) || !std::ranges::all_of(one.places, isFinite))
            return inconsistentModel(model, Message::say("it lists a faulty cell that is not faulty"));
        FaultyCell& cell = cells.emplace_back();
        cell.cell = one.number;
        cell.fault = static_cast<CellFault>(one.fault);
        for (const std::array<double, 3>& place : std::span(one.places).first(one.corners))
            cell.corners.emplace_back(place.data());
    }
    return cells;
}

} // namespace

std::uint64_t faultyCellCount(const Model& model)
{
    const DerivedSections derived = derivedSections(model);
    return derived.faultyCells.size() + (derived.faults ? faultsOfCells(*derived.faults).size() : 0);
}

Result<std::vector<FaultyCell>> faultyCells(const Model& model)
{
    const DerivedSections derived = derivedSections(model);
    const std::span<const Fault> faults = derived.faults.value_or(std::span<const Fault>());
    if (!model.check(derived.faultyCells) || !model.check(faults))
        return model.checkIntact().error();
    return model.description().domain == DomainClass::Curvilinear ? faultyCellsOfGrid(model, faultsOfCells(faults))
                                                                  : cellsLeftOut(model, derived.faultyCells);
}

} // namespace tetra
