// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/units.h"

#include "plugins/readers/points/small_letters.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

namespace tetra {

namespace {

constexpr std::string_view prefixes[] = {"k", "M", "G", "T", "h",  "d",        "c", "m",       "u",
                                         "n", "p", "f", "P", "da", "\xc2\xb5", "E", "\xce\xbc"};

/// Those that take prefixes.
constexpr std::string_view symbols[] = {"m",  "g", "s", "K",   "A",  "mol", "cd",  "Hz", "N",        "Pa", "J",
                                        "W",  "C", "V", "F",   "T",  "Wb",  "lm",  "lx", "Bq",       "S",  "Gy",
                                        "Sv", "L", "l", "bar", "eV", "cal", "rad", "pc", "\xce\xa9", "Ohm"};

/// Those that take none, and parts of longer ones, in small letters.
constexpr std::string_view words[] = {
    "in",   "inch",   "inches",  "ft",      "feet",    "foot",        "mi",       "mile",    "miles",   "yd",
    "yard", "yards",  "micron",  "microns", "au",      "ly",          "angstrom", "deg",     "degc",    "degf",
    "degk", "degree", "degrees", "dd",      "east",    "north",       "west",     "south",   "celsius", "kelvin",
    "min",  "minute", "minutes", "h",       "hr",      "hour",        "hours",    "day",     "days",    "yr",
    "year", "years",  "sec",     "second",  "seconds", "utc",         "psi",      "ksi",     "atm",     "mmhg",
    "torr", "lb",     "lbf",     "lbm",     "kip",     "darcy",       "md",       "cp",      "poise",   "gal",
    "oe",   "gauss",  "ppm",     "ppb",     "ppt",     "psu",         "pct",      "percent", "db",      "dbz",
    "kt",   "knot",   "knots",   "f",       "%",       "\xe2\x80\xb0"};

constexpr std::string_view lengths[] = {"in",    "inch",   "inches", "ft",     "feet",     "foot",    "mi", "mile",
                                        "miles", "yd",     "yard",   "yards",  "micron",   "microns", "au", "angstrom",
                                        "meter", "meters", "metre",  "metres", "\xc3\x85", "ly"};
constexpr std::string_view lengthPrefixes[] = {"kilo", "centi", "milli", "micro", "nano", "deci"};
constexpr std::string_view angles[] = {"deg", "degree", "degrees", "dd", "\xc2\xb0", "radian", "radians"};

/// What stands between the symbols of a unit: operators, numbers, exponents.
constexpr std::string_view operators[] = {"\xc2\xb2", "\xc2\xb3", "\xc2\xb9",    "\xc2\xb7",
                                          "\xc2\xb0", "\xc3\x97", "\xe2\x81\xbb"};

bool isSymbol(std::string_view text)
{
    if (isAmong(text, symbols) || isLengthUnit(text) || isAmong(inSmallLetters(text), words))
        return true;
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) {
        return text.starts_with(prefix) && isAmong(text.substr(prefix.size()), symbols);
    });
}

/// The length of what stands at the beginning and is no part of a symbol.
std::size_t operatorLength(std::string_view text)
{
    for (const std::string_view sign : operators)
        if (text.starts_with(sign))
            return sign.size();
    return std::string_view(" 0123456789.*/^+-_()").find(text[0]) != std::string_view::npos ? 1 : 0;
}

} // namespace

bool isUnit(std::string_view text)
{
    constexpr std::size_t longest = 40;
    if (text.size() > longest)
        return false;
    std::size_t found = 0;
    bool hasDegree = false;
    while (!text.empty()) {
        if (const std::size_t length = operatorLength(text); length > 0) {
            hasDegree = hasDegree || text.starts_with("\xc2\xb0");
            text.remove_prefix(length);
            continue;
        }
        std::size_t end = 1;
        while (end < text.size() && operatorLength(text.substr(end)) == 0)
            ++end;
        if (!isSymbol(text.substr(0, end)))
            return false;
        ++found;
        text.remove_prefix(end);
    }
    return found > 0 || hasDegree;
}

bool isLengthUnit(std::string_view text)
{
    const std::string lower = inSmallLetters(text);
    if (isAmong(lower, lengths) || isAmong(text, lengths))
        return true;
    for (const std::string_view prefix : prefixes)
        if (text.starts_with(prefix) && (text.substr(prefix.size()) == "m" || text.substr(prefix.size()) == "pc"))
            return true;
    for (const std::string_view prefix : lengthPrefixes)
        if (lower.starts_with(prefix) && isAmong(std::string_view(lower).substr(prefix.size()), lengths))
            return true;
    return text == "m" || text == "M" || text == "pc";
}

bool isAngleUnit(std::string_view text)
{
    const std::string lower = inSmallLetters(text);
    return isAmong(std::string_view(lower).substr(0, lower.find_first_of(" _")), angles) || lower == "rad";
}

} // namespace tetra
