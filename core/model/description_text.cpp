// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/description_text.h"

#include "core/data/grid_handedness.h"
#include "core/model/format.h"

namespace tetra {

namespace {

constexpr std::string_view parameterPrefix = "parameter.";

std::string escaped(std::string_view text, bool isKey)
{
    std::string result;
    for (const char character : text) {
        if (character == '\\')
            result += "\\\\";
        else if (character == '\n')
            result += "\\n";
        else if (character == '=' && isKey)
            result += "\\e";
        else
            result += character;
    }
    return result;
}

std::string unescaped(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        ++i;
        result += text[i] == 'n' ? '\n' : text[i] == 'e' ? '=' : text[i];
    }
    return result;
}

void appendLine(std::string& text, std::string_view key, std::string_view value)
{
    text += escaped(key, true) + "=" + escaped(value, false) + "\n";
}

void readLine(std::string_view line, ModelDescription& description)
{
    const std::size_t separator = line.find('=');
    if (separator == std::string_view::npos)
        return;
    const std::string key = unescaped(line.substr(0, separator));
    std::string value = unescaped(line.substr(separator + 1));
    if (key == "source")
        description.sourceName = std::move(value);
    else if (key == "builder")
        description.builder = std::move(value);
    else if (key.starts_with(parameterPrefix))
        description.parameters.emplace_back(key.substr(parameterPrefix.size()), std::move(value));
}

} // namespace

void describeSource(ModelDescription& description, const Dataset& dataset)
{
    description.domain = dataset.domain;
    description.lattice = dataset.lattice;
    description.bounds = dataset.bounds();
    description.leftHanded = dataset.domain == DomainClass::Curvilinear && isLeftHanded(dataset);
    description.sampleType = dataset.values.type();
    description.range = dataset.values.range();
    description.sourceName = dataset.source.name;
    description.sourceHash = dataset.source.hash;
}

Result<std::string> textOf(const ModelDescription& description, const std::filesystem::path& target)
{
    std::string text;
    appendLine(text, "source", description.sourceName);
    appendLine(text, "builder", description.builder);
    for (const auto& [name, value] : description.parameters)
        appendLine(text, std::string(parameterPrefix) + name, value);
    if (text.size() > format::longestText)
        return Error{ErrorKind::OutOfResource, "Cannot write '" + target.string() +
                                                   "': the names and parameters of the model are longer than 1 MiB. "
                                                   "Shorten them."};
    return text;
}

void readText(std::string_view text, ModelDescription& description)
{
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        readLine(text.substr(0, end), description);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
}

} // namespace tetra
