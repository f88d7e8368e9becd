// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/appearance.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

/// Opacities below this cannot be seen, and a surface that cannot be seen is hidden, not transparent.
constexpr float leastOpacity = 0.01F;

bool fits(const Parameter& parameter, const ParameterValue& value)
{
    if (!haveOneType(value, parameter.defaultValue))
        return false;
    const auto* text = std::get_if<std::string>(&value);
    return text == nullptr || parameter.choices.empty() ||
           std::ranges::find(parameter.choices, *text) != parameter.choices.end();
}

bool hasColour(const Isovalue& isovalue, const Colour& colour)
{
    return isovalue.red == colour.red && isovalue.green == colour.green && isovalue.blue == colour.blue;
}

/// The first colour of surfaces that none has; n isovalues cannot have more than n of them.
Colour freeColour(const std::vector<Isovalue>& existing)
{
    std::size_t index = 0;
    const auto inUse = [&](const Isovalue& isovalue) { return hasColour(isovalue, surfaceColour(index)); };
    while (index < existing.size() && std::ranges::any_of(existing, inUse))
        ++index;
    return surfaceColour(index);
}

double middleOfWidestGap(const std::vector<Isovalue>& existing, const ValueRange& range)
{
    std::vector<double> values{range.minimum, range.maximum};
    for (const Isovalue& isovalue : existing)
        values.push_back(std::clamp(isovalue.value, range.minimum, range.maximum));
    std::ranges::sort(values);
    std::size_t widest = 1;
    for (std::size_t i = 2; i < values.size(); ++i)
        if (values[i] - values[i - 1] > values[widest] - values[widest - 1])
            widest = i;
    return values[widest - 1] + (values[widest] - values[widest - 1]) / 2;
}

} // namespace

bool showsFaultyCells(const Appearance& appearance)
{
    const auto found = appearance.settings.find(faultyCellsId);
    const bool* const shown = found != appearance.settings.end() ? std::get_if<bool>(&found->second) : nullptr;
    return shown != nullptr && *shown;
}

Isovalue corrected(Isovalue isovalue, const ValueRange& range)
{
    isovalue.value = std::clamp(isovalue.value, range.minimum, range.maximum);
    isovalue.opacity = std::clamp(isovalue.opacity, leastOpacity, 1.0F);
    return isovalue;
}

ParameterValues rendererValues(const std::vector<Parameter>& parameters, const Appearance& appearance,
                               const std::vector<Isovalue>& isovalues)
{
    ParameterValues values;
    for (const Parameter& parameter : parameters) {
        if (parameter.id == isovaluesId && std::holds_alternative<std::vector<Isovalue>>(parameter.defaultValue))
            values[parameter.id] = isovalues;
        else if (parameter.id == transferId && std::holds_alternative<TransferFunction>(parameter.defaultValue))
            values[parameter.id] = appearance.transfer;
        else if (const auto found = appearance.settings.find(parameter.id);
                 found != appearance.settings.end() && fits(parameter, found->second))
            values[parameter.id] = found->second;
        else if (std::holds_alternative<TransferFunction>(parameter.defaultValue) ||
                 std::holds_alternative<bool>(parameter.defaultValue)) // which depend on what is known of the field
            values[parameter.id] = parameter.defaultValue;
    }
    return values;
}

std::vector<Parameter> matteringParameters(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    std::vector<Parameter> mattering;
    for (const Parameter& parameter : parameters)
        if (matters(parameter, parameters, values))
            mattering.push_back(parameter);
    return mattering;
}

bool hasParameter(const std::vector<Parameter>& parameters, std::string_view id)
{
    return std::ranges::find(parameters, id, &Parameter::id) != parameters.end();
}

std::vector<Parameter> settingParameters(const std::vector<Parameter>& parameters)
{
    std::vector<Parameter> settings;
    for (const Parameter& parameter : parameters)
        if (!std::holds_alternative<std::vector<Isovalue>>(parameter.defaultValue) &&
            !std::holds_alternative<TransferFunction>(parameter.defaultValue) &&
            !std::holds_alternative<OwnValue>(parameter.defaultValue))
            settings.push_back(parameter);
    return settings;
}

const Parameter* mainTransfer(const std::vector<Parameter>& parameters)
{
    const Parameter* first = nullptr;
    for (const Parameter& parameter : parameters)
        if (std::holds_alternative<TransferFunction>(parameter.defaultValue) &&
            (first == nullptr || parameter.id == transferId))
            first = &parameter;
    return first;
}

const Parameter* editedTransfer(const std::vector<Parameter>& parameters, std::string_view wanted)
{
    const auto found = std::ranges::find(parameters, wanted, &Parameter::id);
    const bool isThere = found != parameters.end() && std::holds_alternative<TransferFunction>(found->defaultValue);
    return isThere ? &*found : mainTransfer(parameters);
}

const TransferFunction* chosenTransfer(const std::string& id, const Appearance& appearance)
{
    if (id == transferId)
        return &appearance.transfer;
    const auto found = appearance.settings.find(id);
    return found != appearance.settings.end() ? std::get_if<TransferFunction>(&found->second) : nullptr;
}

Isovalue nextIsovalue(const std::vector<Isovalue>& existing, const ValueRange& range)
{
    Isovalue isovalue;
    isovalue.value = middleOfWidestGap(existing, range);
    isovalue.opacity = existing.empty() ? 1.0F : 0.5F; // so that it does not hide the others
    const Colour colour = freeColour(existing);
    isovalue.red = colour.red;
    isovalue.green = colour.green;
    isovalue.blue = colour.blue;
    return isovalue;
}

} // namespace tetra
