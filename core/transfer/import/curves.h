// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/colour_map.h"
#include "core/transfer/transfer_function.h"

#include <cmath>
#include <numeric>
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

/// How many times a stretch may be halved.
inline constexpr int deepestHalving = 12;
/// Places inside a stretch at which it is compared.
inline constexpr int placesCompared = 8;

/// Shares of the way from 0 to 1, both included and ascending, between which a curve may be replaced by whatever
/// `matches` compares it with: stretches are halved until matches(from, to, place) holds at places inside, or they are
/// very short.
template <class Matches> std::vector<double> adaptivePoints(const Matches& matches)
{
    std::vector<double> points{0};
    const auto divide = [&](const auto& self, double from, double to, int depth) -> void {
        bool good = true;
        for (int place = 1; good && place <= placesCompared; ++place)
            good = matches(from, to, std::lerp(from, to, place / (placesCompared + 1.0)));
        if (good || depth == deepestHalving) {
            points.push_back(to);
            return;
        }
        const double middle = std::midpoint(from, to);
        self(self, from, middle, depth + 1);
        self(self, middle, to, depth + 1);
    };
    divide(divide, 0, 1, 0);
    return points;
}

/// The least distance of two values of the function that ParaView keeps in order: a billionth of the range.
double leastApart(const TransferFunction& function);

/// A function without a mask that looks as the one with it: what the mask hides has points of opacity 0. The mask's
/// largest value is still seen, so the step there is leastApart() above it.
TransferFunction withMaskAsSteps(const TransferFunction& function);

} // namespace tetra
