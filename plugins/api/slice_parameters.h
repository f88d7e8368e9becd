// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/mesh.h>
#include <tan/render.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The planes that are seen in the data: std::string, a list that parseSlices() reads; the shell knows the id.
inline constexpr const char* slicesId = "slices";

/// A plane, and how the user writes it. Its points have normal . x = offset; the normal may have any length.
struct SlicePlane {
    HalfSpace plane;
    std::string text;
};

/// A plane across an axis as "z=12.5", one of any direction as "nx,ny,nz,offset"; nothing if the text is neither.
inline std::optional<HalfSpace> parseSlice(std::string_view text)
{
    constexpr std::string_view blanks = " \t", axes = "xyz";
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) {
        const auto planes = parseClipPlanes(text);
        if (!planes || planes->size() != 1)
            return std::nullopt;
        return HalfSpace{planes->front().normal, planes->front().offset};
    }
    std::string_view place = text.substr(sign + 1);
    place.remove_prefix(std::min(place.find_first_not_of(blanks), place.size()));
    const auto offset = parseNumber<double>(place);
    const std::string_view name = text.substr(0, text.substr(0, sign).find_last_not_of(blanks) + 1);
    const std::size_t axis = name.size() == 1 ? axes.find(name) : std::string_view::npos;
    if (axis == std::string_view::npos || !offset || !std::isfinite(*offset))
        return std::nullopt;
    return HalfSpace{Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)), *offset};
}

/// The offsets of the planes of this normal that pass through a box.
inline ValueRange offsetsIn(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& normal)
{
    const double middle = normal.dot(box.center()), reach = normal.cwiseAbs().dot(box.sizes()) / 2;
    return {middle - reach, middle + reach};
}

/// Planes as text, each as parseSlice() reads it, separated by ';'. No text is no plane. Errors (WrongUsage), each a
/// sentence about the plane: one that is not understood, and unless the bounds are empty one that does not meet them.
inline Result<std::vector<SlicePlane>> parseSlices(std::string_view text, const Eigen::AlignedBox3d& bounds = {})
{
    constexpr double rounding = 1e-9;
    std::vector<SlicePlane> slices;
    while (!text.empty()) {
        std::string_view part = text.substr(0, text.find(';'));
        text.remove_prefix(std::min(part.size() + 1, text.size()));
        part.remove_prefix(std::min(part.find_first_not_of(" \t"), part.size()));
        part = part.substr(0, part.find_last_not_of(" \t") + 1);
        if (part.empty())
            continue;
        const auto plane = parseSlice(part);
        if (!plane)
            return Error{
                ErrorKind::WrongUsage,
                Message::say("'%1' is not a plane: give x, y or z and a position, as in z=12.5, or nx,ny,nz,offset for "
                             "the points with nx x + ny y + nz z = offset, the first three not all zero.",
                             printable(part))};
        if (!bounds.isEmpty()) {
            const ValueRange met = offsetsIn(bounds, plane->normal);
            const double slack = rounding * (met.extent() + std::abs(met.minimum) + std::abs(met.maximum));
            if (plane->offset < met.minimum - slack || plane->offset > met.maximum + slack)
                return Error{
                    ErrorKind::WrongUsage,
                    Message::say("The plane '%1' misses the data, which extend from %2 to %3 in its direction.",
                                 printable(part), formatNumber(met.minimum), formatNumber(met.maximum))};
        }
        slices.push_back({*plane, std::string(part)});
    }
    return slices;
}

} // namespace tetra
