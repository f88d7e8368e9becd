// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/focus_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

/// The box around a region; infinite if the region is.
Box boundsOf(const Region& region)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return *box;
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return {sphere->centre.array() - sphere->radius, sphere->centre.array() + sphere->radius};
    const Eigen::Vector3d infinite = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    return {-infinite, infinite};
}

} // namespace

FocusLimits::FocusLimits(const SpaceRamp& ramp, const Lattice& lattice, double valueExtent)
    : field_(ramp), lattice_(lattice), extent_(valueExtent)
{
    const SpaceRamp& clean = *field_.asSpaceRamp();
    least = clean.inner / 100 * extent_;
    most = clean.outer / 100 * extent_;
    quick_ = std::holds_alternative<Box>(clean.region) && clean.falloff == 0;
    twoValued = quick_;
    findRange();
}

void FocusLimits::findRange()
{
    const SpaceRamp& ramp = *field_.asSpaceRamp();
    const Box bounds = boundsOf(ramp.region);
    // Rounding may make a distance a little less than it is.
    const double reach = ramp.falloff * (1 + 1e-9);
    for (int axis = 0; axis < 3; ++axis) {
        const auto count = lattice_.size[static_cast<std::size_t>(axis)];
        std::vector<char> inside(count);
        const double room =
            quick_ ? 0 : reach + 1e-9 * (std::abs(lattice_.origin[axis]) + lattice_.spacing[axis] * count);
        std::array<std::uint32_t, 3> point{0, 0, 0};
        for (std::uint32_t i = 0; i < count; ++i) {
            point[static_cast<std::size_t>(axis)] = i;
            const double place = lattice_.position(point[0], point[1], point[2])[axis];
            inside[i] = !(place < bounds.least[axis] - room) && !(place > bounds.largest[axis] + room);
        }
        const auto from = std::ranges::find(inside, 1);
        const auto to = std::find(inside.rbegin(), inside.rend(), 1).base();
        first[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(from - inside.begin());
        last[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(to - inside.begin()) - 1;
        inside_[static_cast<std::size_t>(axis)] = std::move(inside);
    }
    firstAsked = first;
    lastAsked = last;
    for (std::size_t axis = 0; axis < 3 && quick_; ++axis) {
        firstAsked[axis] = std::max(first[axis] - 1, 0);
        lastAsked[axis] = std::min(lastAsked[axis] + 1, static_cast<std::int32_t>(lattice_.size[axis]) - 1);
    }
    if (quick_ && (first[0] > last[0] || first[1] > last[1] || first[2] > last[2]))
        lastAsked = {-1, -1, -1};
}

double FocusLimits::fieldAt(const std::array<std::uint32_t, 3>& point) const
{
    return field_.at(lattice_.position(point[0], point[1], point[2]), 0) / 100 * extent_;
}

bool FocusLimits::mayHoldIn(const std::array<std::uint32_t, 3>& cube, std::uint32_t edge) const
{
    if (quick_)
        return true;
    const SpaceRamp& ramp = *field_.asSpaceRamp();
    const Eigen::Vector3d size = lattice_.spacing * edge;
    const Eigen::Vector3d middle = lattice_.position(cube[0], cube[1], cube[2]) + size / 2;
    const double room = size.norm() / 2 + ramp.falloff + 1e-9 * (middle.cwiseAbs().maxCoeff() + size.maxCoeff());
    return !(distanceTo(ramp.region, middle) > room);
}

} // namespace tetra
