// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/number_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

class NumberText {
    Q_DECLARE_TR_FUNCTIONS(NumberText)
};

} // namespace

QString countText(std::uint64_t count)
{
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString percentText(double percent)
{
    return NumberText::tr("%1 %").arg(QLocale().toString(percent, 'g', 3));
}

QString durationText(double seconds)
{
    const QLocale locale;
    if (seconds < 0.00995)
        return NumberText::tr("%1 ms").arg(locale.toString(seconds * 1000, 'f', 1));
    if (seconds < 0.9995)
        return NumberText::tr("%1 ms").arg(locale.toString(seconds * 1000, 'f', 0));
    if (seconds < 9.95)
        return NumberText::tr("%1 s").arg(locale.toString(seconds, 'f', 1));
    if (seconds < 59.5)
        return NumberText::tr("%1 s").arg(locale.toString(seconds, 'f', 0));
    const auto whole = static_cast<qlonglong>(std::llround(seconds));
    if (whole < 3600)
        return NumberText::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
    return NumberText::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

QString bytesText(std::uint64_t bytes)
{
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1);
}

int decimalsFor(double extent)
{
    if (!(extent > 0) || !std::isfinite(extent))
        return 2;
    return std::clamp(3 - static_cast<int>(std::floor(std::log10(extent))), 0, 12);
}

QString numberInRange(double value, double least, double largest)
{
    constexpr int fewest = 6, most = 17;
    const double extent = largest - least;
    const double size = std::max(std::abs(least), std::abs(largest));
    const double wanted = extent > 0 ? 4 + std::ceil(std::log10(size / extent)) : fewest;
    const int digits = std::isfinite(wanted) ? static_cast<int>(std::clamp<double>(wanted, fewest, most)) : fewest;
    return QLocale().toString(value, 'g', digits);
}

QString antilogarithmText(double logarithm, double extent)
{
    constexpr int fewest = 3, most = 12;
    const double part = std::numbers::ln10 * extent / 1000;
    const double wanted = part > 0 && part < 1 ? 1 - std::floor(std::log10(part)) : fewest;
    return QLocale().toString(std::pow(10.0, logarithm), 'g',
                              static_cast<int>(std::clamp<double>(wanted, fewest, most)));
}

QString valueText(double value, double extent)
{
    return QLocale().toString(value, 'f', decimalsFor(extent));
}

} // namespace tetra
