// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/import_options.h"

#include "plugins/host/parameter_text.h"

#include <algorithm>

namespace tetra {

namespace {

constexpr std::string_view valuePrefix = "value.";

std::string key(std::string_view name)
{
    return std::string(importPrefix) + std::string(name);
}

std::optional<std::string> textOf(const ModelDescription& description, const std::string& name)
{
    const auto found = std::ranges::find(description.parameters, name, &std::pair<std::string, std::string>::first);
    return found == description.parameters.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

std::vector<std::pair<std::string, std::string>> importTexts(const ImportOptions& options)
{
    std::vector<std::pair<std::string, std::string>> texts;
    const auto add = [&](const std::string& name, const std::string& text) {
        if (!text.empty())
            texts.emplace_back(key(name), text);
    };
    add("reader", options.reader.value_or(""));
    add("region", regionText(options.part));
    add("stride", strideText(options.part));
    add("scale", scaleText(options.scale));
    for (const auto& [id, value] : options.values)
        add(std::string(valuePrefix) + id, parameterText(value));
    return texts;
}

Result<ImportOptions> importOf(const ModelDescription& description, const std::vector<Parameter>& parameters)
{
    ImportOptions options{.reader = importReaderOf(description)};
    const auto region = parseRegion(textOf(description, key("region")).value_or(""));
    if (!region)
        return region.error();
    const auto stride = parseStride(textOf(description, key("stride")).value_or(""));
    if (!stride)
        return stride.error();
    const auto scale = parseScale(textOf(description, key("scale")).value_or(""));
    if (!scale)
        return scale.error();
    options.part = {.region = *region, .stride = *stride};
    options.scale = *scale;
    for (const Parameter& parameter : parameters)
        if (const auto text = textOf(description, key(std::string(valuePrefix) + parameter.id))) {
            const auto value = parseParameter(parameter, *text);
            if (!value)
                return value.error();
            options.values[parameter.id] = *value;
        }
    return options;
}

std::optional<std::string> importReaderOf(const ModelDescription& description)
{
    return textOf(description, key("reader"));
}

} // namespace tetra
