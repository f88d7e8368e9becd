// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/transfer/paraview/curves.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace tetra {
namespace {

Error wrongCurve(const CurvePreset& preset, const std::string& what)
{
    return {ErrorKind::BadInput, "The preset '" + preset.name + "' cannot be used: " + what + "."};
}

bool isShare(double number)
{
    return number >= 0 && number <= 1;
}

template <class Node> Status checkValues(const CurvePreset& preset, std::span<const Node> nodes)
{
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (!std::isfinite(nodes[node].value))
            return wrongCurve(preset, "a value is not a finite number");
        if (node > 0 && nodes[node].value < nodes[node - 1].value)
            return wrongCurve(preset, "its values do not ascend: " + formatNumber(nodes[node].value) + " comes after " +
                                          formatNumber(nodes[node - 1].value));
    }
    return {};
}

} // namespace

Status checkCurves(const CurvePreset& preset)
{
    if (Status ascending = checkValues(preset, std::span(preset.colours.nodes)); !ascending)
        return ascending;
    if (Status ascending = checkValues(preset, std::span(preset.opacities)); !ascending)
        return ascending;
    if (preset.colours.nodes.empty() && preset.opacities.empty())
        return wrongCurve(preset, "it has neither colours nor opacities");
    if (preset.colours.logarithmic && !preset.colours.nodes.empty() && !(preset.colours.nodes.front().value > 0))
        return wrongCurve(preset, "its colours go by the logarithm, and its values are not all positive");
    for (const ColourNode& node : preset.colours.nodes)
        if (!std::ranges::all_of(node.colour, isShare))
            return wrongCurve(preset, "a channel of a colour lies outside 0 to 1");
    for (const OpacityNode& node : preset.opacities)
        if (!isShare(node.opacity) || !isShare(node.midpoint) || !isShare(node.sharpness))
            return wrongCurve(preset, "an opacity, a midpoint or a sharpness lies outside 0 to 1");
    return {};
}

} // namespace tetra
