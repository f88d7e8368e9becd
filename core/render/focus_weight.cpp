// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/focus_weight.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace tetra {

namespace {

double distanceFrom(const std::variant<Box, Sphere>& shape, const Eigen::Vector3d& place)
{
    if (const auto* ball = std::get_if<Sphere>(&shape))
        return std::max(0.0, (place - ball->centre).norm() - ball->radius);
    const Box& box = std::get<Box>(shape);
    return (place - place.cwiseMax(box.least).cwiseMin(box.largest)).norm();
}

} // namespace

double focusWeight(std::span<const FocusRegion> regions, const Eigen::Vector3d& place)
{
    double largest = 0;
    for (const FocusRegion& region : regions) {
        const double away = distanceFrom(region.shape, place);
        largest = std::max(largest, away <= 0 ? 1 : region.border > 0 ? 1 - away / region.border : 0);
    }
    return largest;
}

float opacityAt(float opacity, const FocusShare* share, const Eigen::Vector3d& place)
{
    if (share == nullptr)
        return opacity;
    const double ofFine = focusWeight(share->regions, place);
    return static_cast<float>(
        1 - std::pow(1 - std::min<double>(opacity, mostSharedOpacity), share->fine ? ofFine : 1 - ofFine));
}

RegionShape shapeOf(const FocusRegion& region)
{
    const double border = std::max(0.0, region.border);
    if (const auto* ball = std::get_if<Sphere>(&region.shape))
        return {true, ball->centre, Eigen::Vector3d::Constant(std::max(0.0, ball->radius)), border};
    const Box& box = std::get<Box>(region.shape);
    return {false, (box.least + box.largest) / 2, (box.largest - box.least).cwiseMax(0) / 2, border};
}

} // namespace tetra
