// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/axis_ticks.h"

#include "core/picture/drawing/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tetra {
namespace {

constexpr double largestPlain = 1e6; ///< numbers from here on are written in powers of ten
constexpr double smallestPlain = 1e-4;
constexpr int fewestDigits = 4; ///< of a number by itself

/// 1, 2 or 5 times a power of ten, not below `step`.
double niceStep(double step)
{
    const double power = std::pow(10, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= step * (1 - 1e-9))
            return factor * power;
    return 10 * power;
}

/// Multiples of `step` in the range; near zero exactly that.
std::vector<double> multiples(double least, double largest, double step)
{
    std::vector<double> ticks;
    const double room = 1e-9 * step;
    for (double count = std::ceil((least - room) / step); count * step <= largest + room; ++count)
        ticks.push_back(std::clamp(count == 0 ? 0 : count * step, least, largest));
    return ticks;
}

int decimalsOf(double step)
{
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

/// As the C locale writes it: `general` with as many significant digits as it needs, at most `digits`.
std::string plain(double value, std::chars_format format, int digits)
{
    std::array<char, 400> text{}; // 1.8e308 with decimals
    const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
    return problem == std::errc() ? std::string(text.data(), end) : std::string();
}

double numberOf(const std::string& plain)
{
    double number = 0;
    std::from_chars(plain.data(), plain.data() + plain.size(), number);
    return number;
}

double largestMagnitude(const std::vector<double>& values)
{
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

double smallestDistance(const std::vector<double>& values)
{
    double smallest = std::abs(values.front());
    for (std::size_t i = 1; i < values.size(); ++i)
        smallest = i == 1 ? values[1] - values[0] : std::min(smallest, values[i] - values[i - 1]);
    return smallest;
}

} // namespace

std::string withSigns(std::string_view plain, const NumberSigns& signs)
{
    std::string text;
    for (const char sign : plain)
        switch (sign) {
        case '.': text += signs.decimalPoint; break;
        case '-': text += signs.minus; break;
        case '+': text += signs.plus; break;
        case 'e': text += signs.exponent; break;
        default:
            text += sign >= '0' && sign <= '9' ? utf8Of(signs.zero + static_cast<char32_t>(sign - '0'))
                                               : std::string(1, sign);
            break;
        }
    return text;
}

std::vector<double> niceTicks(double least, double largest, int most)
{
    const double extent = largest - least;
    if (!(extent > 0) || !std::isfinite(extent) || most < 1)
        return {};
    double step = niceStep(extent / most);
    // Steps that no longer change the numbers would never end.
    if (!(step > 1e-12 * std::max(std::abs(least), std::abs(largest))) || !std::isfinite(step))
        return {};
    std::vector<double> ticks = multiples(least, largest, step);
    while (static_cast<int>(ticks.size()) > most) {
        step = niceStep(step * 1.5);
        ticks = multiples(least, largest, step);
    }
    return ticks;
}

double niceLength(double length)
{
    if (!(length > 0) || !std::isfinite(length))
        return 0;
    const double power = std::pow(10, std::floor(std::log10(length)));
    for (const double factor : {10.0, 5.0, 2.0})
        if (factor * power <= length)
            return factor * power;
    return power <= length ? power : power / 2;
}

std::vector<std::string> tickTexts(const std::vector<double>& values, const NumberSigns& signs)
{
    if (values.empty())
        return {};
    if (values.size() == 1)
        return {ownText(values.front(), signs)};
    const double largest = largestMagnitude(values);
    const double distance = smallestDistance(values);
    const double apart = distance > 0 ? distance : 1;
    const bool isPlain = (largest < largestPlain && apart >= smallestPlain) || largest == 0;
    // The digits from the first of the largest number down to the first of the distance.
    const int digits =
        isPlain ? 0
                : std::clamp(static_cast<int>(std::floor(std::log10(largest)) - std::floor(std::log10(apart))), 0, 12);
    std::vector<std::string> texts;
    for (const double value : values)
        texts.push_back(withSigns(isPlain || value == 0 ? plain(value == 0 ? 0 : value, std::chars_format::fixed,
                                                                isPlain ? decimalsOf(apart) : 0)
                                                        : plain(value, std::chars_format::scientific, digits),
                                  signs));
    return texts;
}

std::string ownText(double value, const NumberSigns& signs)
{
    constexpr int mostDigits = 12;
    const double magnitude = std::abs(value);
    if (magnitude == 0 || (magnitude >= smallestPlain && magnitude < largestPlain))
        return shortNumber(value, signs, mostDigits);
    for (int digits = 0; digits < mostDigits; ++digits)
        if (const std::string text = plain(value, std::chars_format::scientific, digits);
            std::abs(numberOf(text) - value) <= 1e-12 * magnitude)
            return withSigns(text, signs);
    return withSigns(plain(value, std::chars_format::scientific, mostDigits), signs);
}

std::string shortNumber(double value, const NumberSigns& signs, int digits)
{
    return withSigns(plain(value == 0 ? 0 : value, std::chars_format::general, digits), signs);
}

std::string formattedNumber(double value, const NumberFormat& format, const NumberSigns& signs)
{
    constexpr double largestWritten = 1e15; // doubles have no more digits before the point
    if (format.style == NumberFormat::Style::Automatic)
        return ownText(value, signs);
    const bool isPlain = format.style == NumberFormat::Style::Plain && std::abs(value) < largestWritten;
    const std::string text = plain(value, isPlain ? std::chars_format::fixed : std::chars_format::scientific,
                                   std::clamp(format.decimals, 0, mostDecimals));
    // What is rounded to zero has no sign.
    const bool isZero = text.starts_with('-') && numberOf(text) == 0;
    return withSigns(isZero ? std::string_view(text).substr(1) : std::string_view(text), signs);
}

std::string numberAmong(double value, const std::vector<double>& ticks, const NumberSigns& signs)
{
    const double apart = ticks.empty() ? 0 : smallestDistance(ticks);
    if (!(apart > 0) || value == 0 || !std::isfinite(value))
        return shortNumber(value, signs, fewestDigits);
    constexpr int mostDigits = 15;
    // From the first of the number down to the one below the first of the distance.
    const double first = std::floor(std::log10(std::abs(value)));
    double digits = first - std::floor(std::log10(apart)) + 2;
    if (std::max(largestMagnitude(ticks), std::abs(value)) < largestPlain)
        digits = std::max(digits, first + 1); // without a power of ten, as the ticks
    return shortNumber(value, signs, static_cast<int>(std::clamp<double>(digits, fewestDigits, mostDigits)));
}

} // namespace tetra
