// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/metaimage/metaimage_header.h"

#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <cmath>

namespace tetra {

std::string_view MetaHeader::text(std::string_view name) const
{
    const auto field = fields.find(name);
    return field == fields.end() ? std::string_view() : std::string_view(field->second);
}

bool MetaHeader::isTrue(std::string_view name) const
{
    const std::string_view value = text(name);
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

Result<MetaHeader> metaHeaderOf(std::string_view bytes)
{
    constexpr std::size_t longest = 1 << 20; // real ones have some hundred bytes
    MetaHeader header;
    for (std::size_t place = 0; place < std::min(bytes.size(), longest);) {
        const auto end = bytes.find('\n', place);
        const std::string_view line = bytes.substr(place, end == std::string_view::npos ? end : end - place);
        place = end == std::string_view::npos ? bytes.size() : end + 1;
        const auto separator = line.find_first_of("=:");
        if (separator == std::string_view::npos)
            continue;
        const std::string name(trimmed(line.substr(0, separator)));
        header.fields[name] = trimmed(line.substr(separator + 1));
        if (name == "ElementDataFile") {
            header.end = place;
            return header;
        }
    }
    return Error{ErrorKind::BadInput, Message::say("its header has no line 'ElementDataFile = ...': it is cut short or "
                                                   "not a MetaImage. Copy the file again.")};
}

std::optional<std::int64_t> metaWholeNumber(std::string_view text)
{
    const auto number = parseNumber<double>(text);
    if (!number || !(*number >= -9e15 && *number <= 9e15))
        return std::nullopt;
    return static_cast<std::int64_t>(*number);
}

Result<std::optional<std::vector<double>>> metaNumbers(const MetaHeader& header,
                                                       const std::vector<std::string_view>& names, std::size_t count)
{
    std::optional<std::vector<double>> numbers;
    for (const std::string_view name : names) {
        if (!header.has(name))
            continue;
        const auto words = split(header.text(name), " \t\r\n\v\f");
        numbers.emplace();
        for (std::size_t i = 0; i < std::min(count, words.size()); ++i)
            if (const auto number = parseNumber<double>(words[i]); number && std::isfinite(*number))
                numbers->push_back(*number);
        if (numbers->size() != count)
            return wrongMetaHeader(
                Message::say("its %1 is '%2' and not %3 finite numbers.", name, printable(header.text(name)), count));
    }
    return numbers;
}

Error wrongMetaHeader(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("%1 The file is damaged: copy or export it again.", what)};
}

} // namespace tetra
