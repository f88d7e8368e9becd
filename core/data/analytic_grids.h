// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <functional>
#include <string_view>

namespace tetra {

/// Where a point of a grid lies, and the field there.
struct GridPoint {
    Eigen::Vector3d position{0, 0, 0};
    double value = 0; ///< in [0, 1]
};

/// A grid as a mapping of the unit cube of computational space; the same bits on every machine. Called from many
/// threads.
using GridFunction = std::function<GridPoint(const std::array<double, 3>& place)>;

/// The grid called `name`, empty if there is none. The kinds of trouble that real grids have:
/// - "blunt-body": the flow in front of a hemisphere. i goes from the body outwards, j from the axis, where all points
///   of k coincide (a collapsed axis, S6), k half around it. The field is the density behind a bow shock.
/// - "o-grid": potential flow around a cylinder. i goes around and the last plane is the first one, j outwards, getting
///   coarser, k along the cylinder; left-handed. The field is the pressure.
/// - "bent-duct": a square duct that turns by 90 degrees, i along it. The field is the speed, faster on the outside.
/// - "stretched": a box with spacings that grow from one wall (rectilinear). The field is a layer at that wall.
GridFunction gridFunction(std::string_view name);

} // namespace tetra
