// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"

#include <Eigen/Core>

#include <limits>
#include <span>

namespace tetra {

/// A line of sight: at(t) is the farther from the viewer the larger t, a length in the units of the dataset.
struct SightLine {
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Vector3d direction{0, 0, 1};                        ///< of unit length
    double nearest = -std::numeric_limits<double>::infinity(); ///< what is nearer lies behind the eye

    Eigen::Vector3d at(double t) const { return origin + t * direction; }
};

/// What lies between two places of a line of sight.
struct SightPart {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();

    bool isEmpty() const noexcept { return !(from < to); }
    bool contains(double t) const noexcept { return t >= from && t <= to; }
};

/// What both have.
SightPart common(const SightPart& one, const SightPart& other);

/// What is before the eye and left by the clip planes.
SightPart shownPart(const SightLine& line, std::span<const ClipPlane> planes);

/// Where the line passes through a box or a sphere; empty if it does not.
SightPart partWithin(const SightLine& line, const Box& box);
SightPart partWithin(const SightLine& line, const Sphere& sphere);

} // namespace tetra
