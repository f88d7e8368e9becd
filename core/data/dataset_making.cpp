// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/dataset_checks.h"
#include "core/data/merged_points.h"
#include "core/geometry/orientation.h"

#include <tan/data.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace tetra {

namespace {

Error cannotUse(const std::string& name, const Message& reason)
{
    return {ErrorKind::BadInput, Message::say("Cannot use '%1': %2", name, reason)};
}

Status checkCount(const std::string& name, std::uint64_t values, std::uint64_t points)
{
    if (values == points)
        return {};
    return cannotUse(name,
                     Message::say("it has %1 values for %2 points. Give one value for each point.", values, points));
}

/// They say nothing of the field. How many there were.
std::uint64_t leaveOutNotFinite(std::vector<Eigen::Vector3d>& positions, std::vector<double>& values)
{
    std::size_t kept = 0;
    for (std::size_t point = 0; point < values.size(); ++point)
        if (std::isfinite(values[point])) {
            positions[kept] = positions[point];
            values[kept++] = values[point];
        }
    const std::uint64_t without = values.size() - kept;
    positions.resize(kept);
    values.resize(kept);
    return without;
}

/// Whether four of the points are not in one plane, exactly. O(points).
bool fillSpace(std::span<const Eigen::Vector3d> positions)
{
    const Eigen::Vector3d& first = positions.front();
    const auto farthest = [&](const auto& distance) -> const Eigen::Vector3d& {
        return *std::ranges::max_element(positions, {}, distance);
    };
    const Eigen::Vector3d& second = farthest([&](const auto& place) { return (place - first).squaredNorm(); });
    const Eigen::Vector3d along = (second - first).stableNormalized();
    const Eigen::Vector3d& third =
        farthest([&](const auto& place) { return along.cross(place - first).squaredNorm(); });
    return std::ranges::any_of(positions, [&](const auto& place) { return orientation(first, second, third, place); });
}

Dataset named(Dataset dataset, std::string name)
{
    dataset.source = {std::move(name), {}, contentHash(dataset.values, dataset.positions, dataset.tetrahedra)};
    return dataset;
}

} // namespace

Result<Dataset> latticeDataset(const Lattice& lattice, ScalarField values, std::string name)
{
    if (const Status usable = checkLatticeSize({lattice.size[0], lattice.size[1], lattice.size[2]}); !usable)
        return cannotUse(name, usable.error().message);
    if (const Status usable = checkLatticePlacement(lattice); !usable)
        return cannotUse(name, usable.error().message);
    if (const Status usable = checkCount(name, values.count(), lattice.pointCount()); !usable)
        return usable.error();
    if (const Status usable = checkFinite(lattice, values); !usable)
        return cannotUse(name, usable.error().message);
    return named(Dataset{.lattice = lattice, .values = std::move(values), .source = {}}, std::move(name));
}

Result<Dataset> curvilinearDataset(const std::array<std::uint32_t, 3>& size, std::vector<Eigen::Vector3d> positions,
                                   ScalarField values, std::string name)
{
    if (const Status usable = checkLatticeSize({size[0], size[1], size[2]}); !usable)
        return cannotUse(name, usable.error().message);
    Dataset dataset{.domain = DomainClass::Curvilinear, .lattice = {.size = size}, .values = {}, .source = {}};
    for (const std::uint64_t count : {values.count(), std::uint64_t(positions.size())})
        if (const Status usable = checkCount(name, count, dataset.lattice.pointCount()); !usable)
            return usable.error();
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions));
    dataset.values = std::move(values);
    if (const Status usable = checkGrid(dataset); !usable)
        return cannotUse(name, usable.error().message);
    dataset.convex = hasConvexDomain(dataset);
    return named(std::move(dataset), std::move(name));
}

Result<Dataset> scatteredDataset(std::vector<Eigen::Vector3d> positions, std::vector<double> values, std::string name)
{
    if (const Status usable = checkCount(name, values.size(), positions.size()); !usable)
        return usable.error();
    for (std::size_t point = 0; point < positions.size(); ++point)
        if (!isUsablePlace(positions[point]))
            return cannotUse(
                name,
                Message::say("the position of point %1 is not a finite number, or too large. Leave it out.", point));
    if (positions.empty())
        return cannotUse(name, Message::say("it has no points."));
    const std::uint64_t withoutValue = leaveOutNotFinite(positions, values);
    if (positions.empty())
        return cannotUse(name, Message::say("none of its values is a finite number."));
    if (positions.size() > std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource,
                     Message::say("'%1' has more than 4294967295 points. Take a part of them.", name)};
    Dataset dataset{.domain = DomainClass::Scattered, .lattice = {}, .values = {}, .source = {}};
    if (withoutValue > 0)
        dataset.remarks.push_back(withoutValue == 1
                                      ? Message::say("1 point without a finite value was left out.")
                                      : Message::say("%1 points without a finite value were left out.", withoutValue));
    if (const Message merged = mergeRemark(mergePoints(positions, values)); !merged.empty())
        dataset.remarks.push_back(merged);
    if (positions.size() >= 4 && !fillSpace(positions))
        dataset.remarks.push_back(Message::say(
            "All its points lie in a plane: there is no volume between them, and no model can be built of them."));
    dataset.lattice.size = {static_cast<std::uint32_t>(values.size()), 1, 1};
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions));
    dataset.values = ScalarField::of(std::move(values));
    return named(std::move(dataset), std::move(name));
}

} // namespace tetra
