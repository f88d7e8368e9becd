// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/process/further_dimensions.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

std::string_view trimmed(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

} // namespace

Result<std::map<std::string, std::uint64_t>> parseFurtherDimensions(const std::string& text)
{
    std::map<std::string, std::uint64_t> numbers;
    for (std::string_view rest = trimmed(text); !rest.empty();) {
        const std::string_view entry = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(entry.size() + 1, rest.size()));
        const auto sign = entry.find('=');
        const std::string name(trimmed(entry.substr(0, sign)));
        const auto number =
            sign == std::string_view::npos ? std::nullopt : parseNumber<std::uint64_t>(trimmed(entry.substr(sign + 1)));
        if (name.empty() || !number || *number == 0)
            return Error{ErrorKind::WrongUsage,
                         Message::say("'%1' for 'index' is not understood. Give the name of each dimension with a "
                                      "number from 1, as in member=3,type=1.",
                                      printable(text))};
        numbers[name] = *number;
    }
    return numbers;
}

} // namespace tetra
