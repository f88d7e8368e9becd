// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/headers/data_file_names.h"

#include <algorithm>

namespace tetra {

std::string NumberedName::name(std::int64_t number) const
{
    std::string digits = std::to_string(number);
    if (digits.size() < width)
        digits.insert(filler == '0' && number < 0 ? 1 : 0, width - digits.size(), filler);
    return std::string(before) + digits + std::string(behind);
}

std::optional<NumberedName> numberedName(std::string_view text)
{
    constexpr std::size_t mostDigits = 3;
    const auto percent = text.find('%');
    const auto end = text.find_first_not_of("0123456789", percent + 1);
    if (percent == std::string_view::npos || end == std::string_view::npos || end - percent - 1 > mostDigits ||
        (text[end] != 'd' && text[end] != 'i' && text[end] != 'u') || text.find('%', end) != std::string_view::npos)
        return std::nullopt;
    const std::string_view width = text.substr(percent + 1, end - percent - 1);
    return NumberedName{text.substr(0, percent), text.substr(end + 1), parseNumber<std::size_t>(width).value_or(0),
                        width.starts_with('0') ? '0' : ' '};
}

Status checkDataFileNames(const std::vector<std::string>& names)
{
    for (const std::string& name : names)
        if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; }))
            return Error{
                ErrorKind::BadInput,
                Message::say("its data file is called '%1', with characters that no name should contain. Correct it.",
                             printable(name))};
    return {};
}

} // namespace tetra
