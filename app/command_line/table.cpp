// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table.h"

#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tetra {

std::string table(std::vector<std::vector<std::string>> rows)
{
    for (auto& row : rows)
        for (std::string& cell : row)
            cell = visibleText(std::move(cell));
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t column = 0; column < row.size(); ++column)
            text += std::string(widths[column] - row[column].size() + 2, ' ') + row[column];
        text += '\n';
    }
    return text;
}

std::string rounded(double number, int digits)
{
    char text[64];
    const auto [end, problem] = std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits);
    return problem == std::errc() ? std::string(text, end) : std::string();
}

std::string rangeText(double least, double largest)
{
    constexpr int fewest = 6, most = 17;
    const double extent = largest - least;
    const double size = std::max(std::abs(least), std::abs(largest));
    const double wanted = extent > 0 ? 4 + std::ceil(std::log10(size / extent)) : fewest;
    const int digits = std::isfinite(wanted) ? static_cast<int>(std::clamp<double>(wanted, fewest, most)) : fewest;
    return rounded(least, digits) + " to " + rounded(largest, digits);
}

std::string factorText(double factor)
{
    return rounded(factor, factorDigits(factor));
}

std::string byteText(std::uint64_t bytes)
{
    constexpr const char* units[] = {"bytes", "kB", "MB", "GB", "TB"};
    auto number = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (number >= 999.5 && unit + 1 < std::size(units)) {
        number /= 1000;
        ++unit;
    }
    return rounded(number, 3) + " " + units[unit];
}

std::string durationText(double seconds)
{
    if (seconds < 1)
        return "less than 1 s";
    const auto whole = static_cast<std::uint64_t>(std::ceil(std::min(seconds, 1e15)));
    if (whole < 60)
        return std::to_string(whole) + " s";
    if (whole < 3600)
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

} // namespace tetra
