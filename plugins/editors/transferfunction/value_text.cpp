// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/value_text.h"

#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/widgets/number_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

class ValueReadOut {
    Q_DECLARE_TR_FUNCTIONS(ValueReadOut)
};

/// How many values lie in the part of the histogram that holds `value`.
std::optional<std::uint64_t> countAt(const EditorState& state, double value)
{
    const auto histogram = histogramOn(state.valueAxis(), state.host());
    const double place = placeOnAxis(value, state.valueAxis());
    if (!histogram || histogram->counts.empty() || !(place >= histogram->least && place <= histogram->largest))
        return std::nullopt;
    const double extent = histogram->largest - histogram->least;
    const double share = extent > 0 ? (place - histogram->least) / extent : 0;
    const auto parts = static_cast<double>(histogram->counts.size());
    return histogram->counts[static_cast<std::size_t>(std::min(std::floor(share * parts), parts - 1))];
}

} // namespace

QString textOfValue(double value, const TransferLimits& seen, bool ofLogarithms)
{
    if (ofLogarithms)
        return antilogarithmText(value, seen.largest - seen.least);
    const double largest = std::max(std::abs(seen.least), std::abs(seen.largest));
    const double extent = seen.largest - seen.least;
    const int digits = extent > 0 ? 3 + static_cast<int>(std::ceil(std::log10(std::max(largest / extent, 1.0)))) : 6;
    return QLocale().toString(value, 'g', std::clamp(digits + 1, 4, 15));
}

QString plainReadOutOf(const EditorState& state, double value)
{
    QString text =
        ValueReadOut::tr("%1: %2, %3")
            .arg(textOfValue(value, state.shown(), state.ofLogarithms()),
                 percentText(100 * opacityOf(state.function(), value)), colourAt(state.function(), value).name());
    if (const auto count = countAt(state, value))
        text += ", " +
                (*count == 1 ? ValueReadOut::tr("1 vertex") : ValueReadOut::tr("%1 vertices").arg(countText(*count)));
    return text;
}

QString readOutOf(const EditorState& state, double value)
{
    return QString("<span style='background-color:%1'>&nbsp;&nbsp;&nbsp;&nbsp;</span> ")
               .arg(colourAt(state.function(), value).name()) +
           plainReadOutOf(state, value).toHtmlEscaped();
}

} // namespace tetra
