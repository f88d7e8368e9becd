// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/point_check.h"

#include "core/base/half.h"
#include "core/model/scattered_cells.h"
#include "core/model/verify_each.h"

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

constexpr std::size_t cellsPerPointTask = 256;

} // namespace

double PointCheck::ownBound(std::size_t number) const
{
    const auto inHistory = cells_.historyNumber(number);
    return inHistory ? static_cast<double>(halfToFloat(model_.ownErrors()[*inHistory])) * original_.extent
                     : std::numeric_limits<double>::infinity();
}

Status PointCheck::run(const Progress& progress)
{
    return verifyEach(cells_.size(), cellsPerPointTask, "Verifying the error at every point", progress,
                      [this](std::size_t number) { checkCell(number); });
}

void PointCheck::checkCell(std::size_t number)
{
    const PlacedCell cell = placedCell(original_.positions, cells_, number);
    if (volumeSign(cell) <= 0)
        return; // found already, and a flat cell interpolates nothing
    std::array<double, 4> values{};
    std::ranges::transform(cells_.vertices(number), values.begin(),
                           [&](std::uint32_t vertex) { return original_.values[cells_.point(vertex)]; });
    const double tolerance = errorAllowance * original_.extent;
    const double own = ownBound(number);
    std::array<std::uint32_t, 4> corners{};
    std::ranges::transform(cells_.vertices(number), corners.begin(),
                           [&](std::uint32_t vertex) { return cells_.point(vertex); });
    original_.tree.visitNear(cell, [&](std::uint32_t point) {
        if (std::ranges::find(corners, point) != corners.end()) {
            mark(point, Covered | WithinOwnError);
            return;
        }
        const Eigen::Vector3d& place = original_.positions[point];
        if (!holds(cell, place))
            return;
        const double claimed = claims_.error(point);
        const double weight = weights_.empty() ? 1 : static_cast<double>(weights_[point]);
        const CellError quick = quickError(cell, values, place, original_.values[point]);
        const bool clear = (quick.error + quick.doubt) * weight <= std::min(own, claimed);
        const double error =
            weight * (clear ? quick.error : preciseError(cell, values, place, original_.values[point]));
        largest_.local() = std::max(largest_.local(), error);
        mark(point, error <= own + tolerance ? Covered | WithinOwnError : Covered);
        if (error > claimed + tolerance)
            tooLarge_.add(point, [&] {
                return "The error at point " + std::to_string(point) + " " + textOf(place) + " is " +
                       textOf(original_.percent(error)) + " % of the range, more than the claimed " +
                       textOf(original_.percent(claimed)) + " %, in the cell with corners " + textOf(cell) + ".";
            });
    });
}

} // namespace tetra
