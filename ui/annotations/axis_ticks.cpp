// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/annotations/axis_ticks.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

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

QString plain(double value, int decimals)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals);
}

/// Significant ones, as many as the number needs.
QString withDigits(double value, int digits)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', digits);
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

std::vector<QString> tickTexts(const std::vector<double>& values)
{
    if (values.empty())
        return {};
    if (values.size() == 1)
        return {ownText(values.front())};
    const double largest = largestMagnitude(values);
    const double distance = smallestDistance(values);
    const double apart = distance > 0 ? distance : 1;
    const bool isPlain = (largest < largestPlain && apart >= smallestPlain) || largest == 0;
    // The digits from the first of the largest number down to the first of the distance.
    const int digits =
        isPlain ? 0
                : std::clamp(static_cast<int>(std::floor(std::log10(largest)) - std::floor(std::log10(apart))), 0, 12);
    std::vector<QString> texts;
    for (const double value : values)
        texts.push_back(value == 0 ? plain(0, isPlain ? decimalsOf(apart) : 0)
                        : isPlain  ? plain(value, decimalsOf(apart))
                                   : QLocale().toString(value, 'e', digits));
    return texts;
}

QString ownText(double value)
{
    constexpr int mostDigits = 12;
    const double magnitude = std::abs(value);
    if (magnitude == 0 || (magnitude >= smallestPlain && magnitude < largestPlain))
        return withDigits(value, mostDigits);
    const QLocale locale;
    for (int digits = 0; digits < mostDigits; ++digits)
        if (const QString text = locale.toString(value, 'e', digits);
            std::abs(locale.toDouble(text) - value) <= 1e-12 * magnitude)
            return text;
    return locale.toString(value, 'e', mostDigits);
}

QString shortNumber(double value)
{
    return withDigits(value, fewestDigits);
}

QString numberAmong(double value, const std::vector<double>& ticks)
{
    const double apart = ticks.empty() ? 0 : smallestDistance(ticks);
    if (!(apart > 0) || value == 0 || !std::isfinite(value))
        return shortNumber(value);
    constexpr int mostDigits = 15;
    // From the first of the number down to the one below the first of the distance.
    const double digits = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(apart)) + 2;
    return withDigits(value, static_cast<int>(std::clamp<double>(digits, fewestDigits, mostDigits)));
}

} // namespace tetra
