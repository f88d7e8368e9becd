// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/logarithm_text.h"

#include "plugins/widgets/number_text.h"
#include "ui/session/annotation_language.h"

#include <QCoreApplication>

namespace tetra {
namespace {

class LogarithmText {
    Q_DECLARE_TR_FUNCTIONS(LogarithmText)
};

} // namespace

QString factorNumber(double percent, const ValueRange& logarithms)
{
    return QString::fromStdString(factorNumber(percent, logarithms, numberSigns(QLocale())));
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
