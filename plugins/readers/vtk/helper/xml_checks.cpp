// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/xml_checks.h"

#include "core/base/mapped_file.h"
#include "core/base/number_text.h"
#include "core/base/shown_text.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tetra {
namespace {

constexpr std::string_view blanks = " \t\r\n";

template <class Number, std::size_t Count> std::optional<std::array<Number, Count>> numbersIn(std::string_view text)
{
    std::array<Number, Count> numbers{};
    for (Number& number : numbers) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        const std::string_view word = text.substr(0, text.find_first_of(blanks));
        const auto parsed = parseNumber<Number>(word);
        if (!parsed || !std::isfinite(static_cast<double>(*parsed)))
            return std::nullopt;
        number = *parsed;
        text.remove_prefix(word.size());
    }
    return text.find_first_not_of(blanks) == std::string_view::npos ? std::optional(numbers) : std::nullopt;
}

/// The cells of an extent, where an axis with one point counts as one; nothing if it is none.
std::optional<double> cellsIn(std::string_view extent)
{
    const auto numbers = numbersIn<std::int32_t, 6>(extent);
    if (!numbers)
        return std::nullopt;
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double steps = double((*numbers)[2 * axis + 1]) - (*numbers)[2 * axis];
        if (steps < 0)
            return std::nullopt;
        cells *= std::max(1., steps);
    }
    return cells;
}

/// The next element of this name from `place` on, without its brackets; moves `place` behind it.
std::optional<std::string_view> nextElement(std::string_view text, std::string_view start, std::size_t& place)
{
    const auto begin = text.find(start, place);
    const auto end = begin == std::string_view::npos ? begin : text.find('>', begin);
    if (end == std::string_view::npos)
        return std::nullopt;
    place = end;
    return text.substr(begin, end - begin);
}

Error wrong(const std::string& what)
{
    return {ErrorKind::BadInput, what + " It is damaged, or written by a faulty program: write it anew."};
}

} // namespace

std::string_view xmlAttribute(std::string_view element, std::string_view name)
{
    const std::string start = std::string(name) + "=";
    for (auto place = element.find(start); place != std::string_view::npos; place = element.find(start, place + 1)) {
        const auto value = place + start.size();
        if (place == 0 || blanks.find(element[place - 1]) == std::string_view::npos || value >= element.size())
            continue;
        const auto end = element.find(element[value], value + 1);
        return end == std::string_view::npos ? std::string_view{} : element.substr(value + 1, end - value - 1);
    }
    return {};
}

Status checkXmlGrid(const std::string& path, std::string_view type)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
    text = text.substr(0, text.find("<AppendedData"));
    std::size_t place = 0;
    const auto grid = nextElement(text, "<" + std::string(type), place);
    if (!grid)
        return wrong("its element " + std::string(type) + " is missing.");
    for (const std::string_view name : {"Spacing", "Origin"})
        if (const auto value = xmlAttribute(*grid, name); !value.empty() && !numbersIn<double, 3>(value))
            return wrong("its " + std::string(name) + " is '" + shownText(value) + "' and not three numbers.");
    const auto whole = cellsIn(xmlAttribute(*grid, "WholeExtent"));
    double covered = 0;
    while (const auto piece = nextElement(text, "<Piece", place))
        covered += cellsIn(xmlAttribute(*piece, "Extent")).value_or(0);
    if (!whole || covered < *whole)
        return wrong("the pieces in it do not fill the WholeExtent that it names.");
    return {};
}

} // namespace tetra
