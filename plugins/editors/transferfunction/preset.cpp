// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/preset.h"

#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/widgets/curves/whole_function.h"

#include <tan/transfer.h>

#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

/// What scanners have for air, or for what lies outside of their circle.
constexpr std::array paddings{-3024.0, -2048.0, -2000.0};
constexpr double leastAir = -1100, largestAir = -900;

/// The values that a preview goes over: a function in Hounsfield units is narrow in them.
TransferLimits previewedValues(const Preset& preset, const TransferFunction& function)
{
    return preset.isHounsfield ? extentOf(function).value_or(TransferLimits{}) : TransferLimits{};
}

QPixmap previewOf(const TransferFunction& function, const TransferLimits& values, QSize size, qreal scale)
{
    QPixmap pixmap(size * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const double height = size.height();
    const double width = size.width();
    for (double x = 0; x < width; x += 1 / scale) {
        const double value = std::lerp(values.least, values.largest, (x + 0.5 / scale) / width);
        const double opaque = std::sqrt(std::clamp(opacityOf(function, value), 0.0, 1.0)) * height;
        const QColor colour = colourAt(function, value);
        painter.fillRect(QRectF(x, 0, 1 / scale, height), faded(colour, 0.35));
        painter.fillRect(QRectF(x, height - opaque, 1 / scale, opaque), colour);
    }
    return pixmap;
}

} // namespace

bool isMeant(const Preset& preset, const QString& text)
{
    const QString found = preset.name + ' ' + preset.words;
    return std::ranges::all_of(text.split(' ', Qt::SkipEmptyParts), [&found](const QString& word) {
        return found.contains(word, Qt::CaseInsensitive); //
    });
}

HounsfieldUnits hounsfieldUnits(const ValueFacts& facts, const TransferLimits& range)
{
    const QString unit = QString::fromStdString(facts.unit).trimmed().toLower();
    if (unit == "hu" || unit == "[hu]" || unit.startsWith("hounsfield"))
        return HounsfieldUnits::Told;
    const bool isSigned = facts.sampleType == SampleType::Int16 || facts.sampleType == SampleType::Int32;
    const bool beginsWithAir = (range.least >= leastAir && range.least <= largestAir) ||
                               std::ranges::find(paddings, range.least) != paddings.end();
    return unit.isEmpty() && isSigned && beginsWithAir && range.largest > 0 ? HounsfieldUnits::Likely
                                                                            : HounsfieldUnits::None;
}

TransferLimits rangeOf(const Preset& preset, HounsfieldUnits units, const TransferLimits& range)
{
    return preset.isHounsfield && units != HounsfieldUnits::None ? hounsfieldRange : range;
}

std::optional<Message> assumptionOf(const Preset& preset, HounsfieldUnits units, const TransferLimits& range)
{
    if (!preset.isHounsfield || units == HounsfieldUnits::Told)
        return std::nullopt;
    if (units == HounsfieldUnits::Likely)
        return Message::say(
            "The preset is for Hounsfield units, and the values are assumed to be these: they are whole "
            "numbers from %1 to %2.",
            formatNumber(range.least), formatNumber(range.largest));
    return Message::say("The preset is for Hounsfield units, which the data do not seem to have: it is stretched over "
                        "their values, %1 to %2, as if these were -1024 to 3071.",
                        formatNumber(range.least), formatNumber(range.largest));
}

TransferFunction withPreset(const TransferFunction& function, const Preset& preset, PresetPart part,
                            const TransferLimits& range, double diagonal)
{
    if (!(range.least < range.largest) || (part == PresetPart::Opacities && !preset.hasOpacities))
        return function;
    TransferFunction made = preset.make(range, function.unitDistance);
    if (part == PresetPart::Colours || !preset.hasOpacities) {
        TransferFunction coloured = function;
        coloured.colours = made.colours;
        return coloured;
    }
    if (preset.unitDistance && diagonal > 0)
        made.unitDistance = *preset.unitDistance * diagonal;
    if (part == PresetPart::Opacities)
        made.colours = function.colours;
    return made;
}

QIcon presetIcon(const Preset& preset, QSize size)
{
    QIcon icon;
    const TransferFunction function = preset.make({0, 1}, 1);
    for (const int scale : {1, 2, 3}) {
        const QPixmap preview = previewOf(function, previewedValues(preset, function), size, scale);
        for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) // a chosen one keeps its colours
            icon.addPixmap(preview, mode);
    }
    return icon;
}

TransferFunction presetOf(const TransferFunction& function, const TransferLimits& range, double diagonal)
{
    const auto share = [&range](double value) { return (value - range.least) / (range.largest - range.least); };
    TransferFunction preset = function;
    for (ColourPoint& point : preset.colours)
        point.value = share(point.value);
    for (OpacityPoint& point : preset.opacities)
        point.value = share(point.value);
    if (auto& mask = preset.mask)
        mask = {share(mask->least), share(mask->largest)};
    if (diagonal > 0)
        preset.unitDistance /= diagonal;
    return preset;
}

} // namespace tetra
