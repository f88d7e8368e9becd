// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/logarithm_text.h"

#include "core/data/value_scale.h"
#include "plugins/widgets/number_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

class LogarithmText {
    Q_DECLARE_TR_FUNCTIONS(LogarithmText)
};

} // namespace

std::optional<ValueRange> logarithmsOf(const ModelDescription& model)
{
    return holdsLogarithms(model.parameters) ? std::optional(model.range) : std::nullopt;
}

QString factorNumber(double percent, const ValueRange& logarithms)
{
    constexpr int fewest = 3, most = 12;
    const double factor = factorOf(percent, logarithms);
    const double wanted = factor > 1 ? 2 - std::floor(std::log10(factor - 1)) : fewest;
    return QLocale().toString(factor, 'g', static_cast<int>(std::clamp<double>(wanted, fewest, most)));
}

QString factorWords(double percent, const ValueRange& logarithms)
{
    return LogarithmText::tr("a factor of %1").arg(factorNumber(percent, logarithms));
}

QString antilogarithmText(double logarithm, const ValueRange& logarithms)
{
    return antilogarithmText(logarithm, logarithms.extent());
}

QString dataValueText(double value, const ModelDescription& model)
{
    const auto logarithms = logarithmsOf(model);
    return logarithms ? antilogarithmText(value, *logarithms) : valueText(value, model.range.extent());
}

QString rangeEndText(double end, const ModelDescription& model)
{
    const auto logarithms = logarithmsOf(model);
    return logarithms ? antilogarithmText(end, *logarithms)
                      : numberInRange(end, model.range.minimum, model.range.maximum);
}

} // namespace tetra
