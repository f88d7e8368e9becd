// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/colour_map.h"

#include <tan/transfer.h>

#include <string>
#include <vector>

namespace tetra {

/// Where a colour curve has a colour.
struct ColourNode {
    double value = 0;
    SrgbColour colour{};
};

/// A colour map as ParaView and VTK have it. Beyond the ends it is constant.
struct ColourCurve {
    std::vector<ColourNode> nodes; ///< values do not descend
    ColourSpace space = ColourSpace::Rgb;
    bool logarithmic = false; ///< between nodes, by the logarithm of the value; values are positive then
};

/// Where an opacity curve has an opacity, and how it goes from there to the next node.
struct OpacityNode {
    double value = 0;
    double opacity = 0;
    double midpoint = 0.5; ///< share of the way at which half of the change is done
    double sharpness = 0;  ///< 0 a line, 1 a step at the midpoint
};

/// The two curves of one of ParaView's presets; either may be missing.
struct CurvePreset {
    std::string name;
    ColourCurve colours;
    std::vector<OpacityNode> opacities; ///< values do not descend
};

/// An error if values descend or are not finite, channels, opacities, midpoints or sharpnesses lie outside [0, 1],
/// or values that are not positive shall be spread by their logarithm.
Status checkCurves(const CurvePreset& preset);

/// What the curves look like within 1/1000 in colour and opacity, with as many points as that takes. What a preset does
/// not have, colours or opacities, is that of `present`, and so is the unit distance. The mask goes with the opacities.
TransferFunction transferFunctionOf(const CurvePreset& preset, const TransferFunction& present);

/// Curves that look like the function within 1/1000: ParaView's opacities are linear between points, ours are
/// extinctions. A step becomes two points a billionth of the range apart, which ParaView keeps in order, and so do the
/// ends of a mask.
CurvePreset curvesOf(const TransferFunction& function, const std::string& name);

} // namespace tetra
