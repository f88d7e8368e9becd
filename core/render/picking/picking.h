// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// A line of sight: at(t) is the farther from the viewer the larger t, a length in the units of the dataset.
struct PickingRay {
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Vector3d direction{0, 0, 1};                        ///< of unit length
    double nearest = -std::numeric_limits<double>::infinity(); ///< what is nearer lies behind the eye

    Eigen::Vector3d at(double t) const { return origin + t * direction; }
};

/// What lies between two places of a line of sight.
struct PickingInterval {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();

    bool isEmpty() const noexcept { return !(from < to); }
    bool contains(double t) const noexcept { return t >= from && t <= to; }
};

/// Where the line passes through a box or a sphere; empty if it does not.
PickingInterval partWithin(const PickingRay& line, const Box& box);
PickingInterval partWithin(const PickingRay& line, const Sphere& sphere);

/// Where a line of sight passes through a surface.
struct SurfaceCrossing {
    double at = 0;                     ///< of PickingRay
    const Drawable* surface = nullptr; ///< of the scene
    std::optional<double> value{};     ///< of the field there, if the drawable tells
};

/// The crossings with what is drawn of a scene's surfaces within `part`, the nearest first. Where the line meets an
/// edge of a surface's triangles it passes through the surface once. O(triangles).
std::vector<SurfaceCrossing> surfaceCrossings(const Scene& scene, const PickingRay& line, const PickingInterval& part);

/// What one sees along a line of sight, and where.
struct SeenPlace {
    Eigen::Vector3d place{0, 0, 0};
    std::string drawable{};        ///< its id in the scene
    std::optional<double> value{}; ///< of the field there, if the drawable tells (Drawable::value)
    double share = 0;              ///< of the light that the surface, or the whole volume, takes; in (0, 1]
};

/// What contributes most to the picture at a line of sight, with the light that is left behind what lies before it:
/// that surface which takes most of it, or if all of the volume takes more, the place in the volume where most is taken
/// on a unit of length. That is the largest extinction(t) * e^-depth(t), of which each slab has the largest in closed
/// form: where the extinction is the square root of its rise, or at an end. Where a focus counts for more than a half
/// its volume is looked at; in the border of a box somewhat before the corners.
///
/// Nothing where less than 1/255 of the light is taken, as nothing is seen there. Unlike the largest jump of the
/// opacity (A. Wiebel et al., "WYSIWYP: What You See Is What You Pick", 2012) it needs no smoothing of a sampled curve.
/// O(triangles + cells). Nothing if cancelled, or if back ends refuse the scene's volume. May throw std::bad_alloc, and
/// what an optical model throws.
TAN_INTERNAL std::optional<SeenPlace> seenPlace(const Scene& scene, const PickingRay& line,
                                                const Progress& progress = {});

} // namespace tetra
