// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/lattice_frame.h"

#include "core/data/dataset_checks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tetra {

using format::SectionId;

std::vector<FrameSection> frameSections(const ModelDescription& description)
{
    std::vector<FrameSection> sections;
    if (const Eigen::Matrix3d& directions = description.lattice.directions; !description.lattice.isAlongAxes())
        sections.push_back({SectionId::Frame, {directions.data(), directions.data() + directions.size()}});
    if (description.metric)
        sections.push_back({SectionId::Metric, {description.metric->data(), description.metric->data() + 3}});
    return sections;
}

bool isBoxOfLattice(const Lattice& lattice, const Eigen::AlignedBox3d& box)
{
    constexpr double rounding = 1e-6;
    const Eigen::AlignedBox3d expected = lattice.bounds();
    for (int axis = 0; axis < 3; ++axis) {
        const double low = expected.min()[axis], high = expected.max()[axis];
        const double slack = rounding * std::max(std::abs(low), std::abs(high));
        if (!std::isfinite(low) || !std::isfinite(high) || std::abs(box.min()[axis] - low) > slack ||
            std::abs(box.max()[axis] - high) > slack)
            return false;
    }
    return true;
}

bool takeFrameSection(SectionId id, std::span<const std::byte> bytes, ModelDescription& description)
{
    Lattice& lattice = description.lattice;
    if (description.domain != DomainClass::RegularLattice)
        return false;
    if (id == SectionId::Frame) {
        static_assert(sizeof(Eigen::Matrix3d) == 9 * sizeof(double) && !Eigen::Matrix3d::IsRowMajor);
        if (bytes.size() != sizeof(Eigen::Matrix3d))
            return false;
        std::memcpy(lattice.directions.data(), bytes.data(), bytes.size());
        description.leftHanded = lattice.isLeftHanded();
        return areDirections(lattice.directions) && isBoxOfLattice(lattice, description.bounds);
    }
    if (bytes.size() != sizeof(Eigen::Vector3d))
        return false;
    Eigen::Vector3d& metric = description.metric.emplace();
    std::memcpy(metric.data(), bytes.data(), bytes.size());
    return std::ranges::all_of(
        metric, [](double length) { return length <= farthestCoordinate && length * farthestCoordinate >= 1; });
}

} // namespace tetra
