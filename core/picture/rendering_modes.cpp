// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/rendering_modes.h"

#include "plugins/api/boundary_parameters.h"
#include "plugins/api/scene_parameters.h"

#include <tan/parameter.h>
#include <tan/transfer.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tetra {
namespace {

constexpr std::array<std::string_view, 6> firstModes{"isosurface", "volume", "hybrid", "focus", "slice", "projection"};

auto rank(const Provided<Renderer>& mode)
{
    return std::ranges::find(firstModes, std::string_view(mode.id)) - firstModes.begin();
}

/// The default that the first mode with this parameter has.
template <class T> const T* firstDefault(const std::vector<std::vector<Parameter>>& modes, std::string_view id)
{
    for (const auto& parameters : modes)
        for (const Parameter& parameter : parameters)
            if (const T* value = std::get_if<T>(&parameter.defaultValue); value != nullptr && parameter.id == id)
                return value;
    return nullptr;
}

std::vector<std::vector<Parameter>> parametersOf(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field)
{
    std::vector<std::vector<Parameter>> parameters;
    for (const Provided<Renderer>& mode : modes)
        parameters.push_back(mode.plugin->parameters(field));
    return parameters;
}

} // namespace

std::vector<Provided<Renderer>> renderingModes(PluginHost& host)
{
    auto modes = host.renderers();
    std::ranges::stable_sort(modes, {}, rank);
    return modes;
}

Appearance startingAppearance(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field,
                              DomainClass domain)
{
    const auto parameters = parametersOf(modes, field);
    const auto* transfer = firstDefault<TransferFunction>(parameters, transferId);
    Appearance appearance{modes.empty() ? std::string() : modes.front().id,
                          transfer != nullptr ? *transfer
                                              : sequentialTransferFunction(field.range.minimum, field.range.maximum,
                                                                           usualUnitDistance(field.bounds))};
    if (domain != DomainClass::RegularLattice)
        appearance.settings[boundaryId] = std::string(boundaryTranslucent);
    return appearance;
}

std::vector<Isovalue> startingIsovalues(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field)
{
    const auto parameters = parametersOf(modes, field);
    const auto* isovalues = firstDefault<std::vector<Isovalue>>(parameters, isovaluesId);
    return isovalues != nullptr ? *isovalues : std::vector<Isovalue>{};
}

} // namespace tetra
