// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/field_name.h"

#include "core/base/text.h"

#include <tan/model.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace tetra {
namespace {

/// "region 0,0,0,31,31,15" or "stride 2,2,1": what was taken of the dataset.
bool isPart(std::string_view text)
{
    return text.starts_with("region ") || text.starts_with("stride ");
}

/// "file.bin, array" where readers know more than the file's name.
std::vector<std::string> namesIn(std::string_view source)
{
    constexpr std::string_view comma = ", ";
    std::vector<std::string> names;
    for (auto end = source.find(comma); end != std::string_view::npos; end = source.find(comma)) {
        names.emplace_back(source.substr(0, end));
        source.remove_prefix(end + comma.size());
    }
    names.emplace_back(source);
    return names;
}

} // namespace

std::string completeBaseName(std::string_view path)
{
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return std::string(name.substr(0, name.rfind('.')));
}

std::string fieldName(const ModelDescription& description, const AnnotationLanguage& language)
{
    if (!description.valueName.empty())
        return visibleText(description.valueName);
    for (const auto& [parameter, text] : description.parameters)
        if (parameter.ends_with(".array") && !text.empty())
            return visibleText(text);
    auto source = namesIn(visibleText(description.sourceName));
    source.erase(std::remove_if(source.begin() + 1, source.end(), isPart), source.end());
    const std::string name = source.size() > 1 ? source.back() : completeBaseName(source.front());
    return name.empty() ? language.say(Message(Message::marked("Value"))) : name;
}

} // namespace tetra
