// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json.h"
#include "core/transfer/import/presets.h"
#include "core/transfer/transfer_text.h"

#include <tan/transfer.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// The first letter of the content; 0 if there is none.
char firstOf(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    return first == std::string_view::npos ? '\0' : text[first];
}

bool isXml(std::string_view text)
{
    return firstOf(text) == '<';
}

bool isJson(std::string_view text)
{
    return firstOf(text) == '{' || firstOf(text) == '[';
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

Result<std::vector<ImportedTransfer>> importTransferFunctions(std::string_view text, const ImportContext& context)
{
    Result<std::vector<CurvePreset>> presets = std::vector<CurvePreset>();
    if (!isXml(text) && !isJson(text))
        return Error{ErrorKind::BadInput,
                     Message::say("This file cannot be read as a transfer function. TAn reads its own and ParaView's "
                                  "presets in JSON, and ParaView's colour maps in XML, but not tables of colours.")};
    if (isXml(text)) {
        presets = presetsFromXml(text);
    } else {
        const Result<JsonValue> root = parseJson(text);
        if (!root)
            return Error{ErrorKind::BadInput,
                         Message::say("The transfer function cannot be read. %1", root.error().message)};
        if (root->find("format") != nullptr) {
            Result<TransferFunction> function = transferFunctionFromJson(*root);
            if (!function)
                return function.error();
            return std::vector<ImportedTransfer>{{{}, *std::move(function)}};
        }
        presets = presetsFromJson(*root);
    }
    if (!presets)
        return presets.error();
    std::vector<ImportedTransfer> imported;
    for (CurvePreset& preset : *presets) {
        const bool spreads = context.limits && isForAnyData(preset);
        if (spreads)
            spreadPreset(preset, *context.limits);
        imported.push_back(
            {preset.name, transferFunctionOf(preset, context.present), preset.opacities.empty(), spreads});
    }
    return imported;
}

std::string transferFunctionToParaview(const TransferFunction& function, const std::string& name)
{
    return presetToJson(curvesOf(function, name));
}

} // namespace tetra
