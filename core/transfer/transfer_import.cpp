// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/transfer_import.h"

#include "core/base/json.h"
#include "core/transfer/paraview/preset_text.h"
#include "core/transfer/transfer_text.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

bool isOurs(std::string_view text)
{
    const Result<JsonValue> root = parseJson(text);
    return root && root->find("format") != nullptr;
}

/// Presets for any data have values from 0 to 1.
bool isForAnyData(const CurvePreset& preset)
{
    const auto unit = [](const auto& nodes) {
        return nodes.empty() || (nodes.front().value == 0 && nodes.back().value == 1);
    };
    return unit(preset.colours.nodes) && unit(preset.opacities);
}

void spreadPreset(CurvePreset& preset, const TransferLimits& limits)
{
    for (ColourNode& node : preset.colours.nodes)
        node.value = std::lerp(limits.least, limits.largest, node.value);
    for (OpacityNode& node : preset.opacities)
        node.value = std::lerp(limits.least, limits.largest, node.value);
}

} // namespace

Result<std::vector<ImportedTransfer>> importTransferFunctions(std::string_view text,
                                                              const ImportSurroundings& surroundings)
{
    std::vector<ImportedTransfer> imported;
    if (isOurs(text)) {
        Result<TransferFunction> function = transferFunctionFromText(text);
        if (!function)
            return function.error();
        imported.push_back({{}, *std::move(function)});
        return imported;
    }
    Result<std::vector<CurvePreset>> presets = presetsFromText(text);
    if (!presets)
        return presets.error();
    for (CurvePreset& preset : *presets) {
        if (surroundings.limits && isForAnyData(preset))
            spreadPreset(preset, *surroundings.limits);
        imported.push_back({preset.name, transferFunctionOf(preset, surroundings.present), preset.opacities.empty()});
    }
    return imported;
}

std::string transferFunctionToParaview(const TransferFunction& function, const std::string& name)
{
    return presetToJson(curvesOf(function, name));
}

} // namespace tetra
