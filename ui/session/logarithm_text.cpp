// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/logarithm_text.h"

#include "core/data/value_scale.h"
#include "plugins/widgets/number_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

class LogarithmText {
    Q_DECLARE_TR_FUNCTIONS(LogarithmText)
};

/// How many digits tell numbers apart that differ by this part of them.
int digitsFor(double part, int fewest)
{
    constexpr int most = 12;
    const double wanted = part > 0 && part < 1 ? 1 - std::floor(std::log10(part)) : fewest;
    return static_cast<int>(std::clamp<double>(wanted, fewest, most));
}

} // namespace

std::optional<ValueRange> logarithmsOf(const ModelDescription& model)
{
    return holdsLogarithms(model.parameters) ? std::optional(model.range) : std::nullopt;
}

QString factorNumber(double percent, const ValueRange& logarithms)
{
    constexpr int fewest = 3;
    const double factor = factorOf(percent, logarithms);
    return QLocale().toString(factor, 'g', digitsFor((factor - 1) / 10, fewest));
}

QString factorWords(double percent, const ValueRange& logarithms)
{
    return LogarithmText::tr("a factor of %1").arg(factorNumber(percent, logarithms));
}

QString antilogarithmText(double logarithm, const ValueRange& logarithms)
{
    constexpr int fewest = 3;
    const double part = std::numbers::ln10 * logarithms.extent() / 1000;
    return QLocale().toString(std::pow(10.0, logarithm), 'g', digitsFor(part, fewest));
}

QString dataValueText(double value, const ModelDescription& model)
{
    const auto logarithms = logarithmsOf(model);
    return logarithms ? antilogarithmText(value, *logarithms) : valueText(value, model.range.extent());
}

} // namespace tetra
