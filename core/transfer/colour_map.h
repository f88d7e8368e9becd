// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_editing.h"

#include <span>
#include <string>

namespace tetra {

/// A colour at a share of the range.
struct ColourMapNode {
    double share = 0; ///< in [0, 1]
    std::array<float, 3> colour{};
};

/// Colours for a range of values without opacities, linear between nodes. All can be told apart by people who do not
/// see red or green as others do, and all but "cool-warm" by their lightness alone.
struct ColourMap {
    std::string id;                   ///< stable: "viridis"
    std::string source;               ///< whose it is, and the licence
    std::vector<ColourMapNode> nodes; ///< ascending, from 0 to 1
};

/// viridis, cividis, inferno, cool-warm, grey: in this order.
std::span<const ColourMap> colourMaps();

std::array<float, 3> colourAt(const ColourMap& map, double share);

/// The function with the map's colours from limits.least to limits.largest, and with the opacities that it has. Limits
/// that are not a range change nothing.
TransferFunction withColourMap(const TransferFunction& function, const ColourMap& map, const TransferLimits& limits);

} // namespace tetra
