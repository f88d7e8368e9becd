// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/preset.h"

#include "plugins/editors/transferfunction/canvas_painting.h"

#include <tan/transfer.h>

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

class PresetNames {
    Q_DECLARE_TR_FUNCTIONS(PresetNames)
};

/// What the map is called in the user's language: names that are known everywhere stay.
QString colourMapName(const std::string& id)
{
    if (id == "cool-warm")
        return PresetNames::tr("Cool to warm");
    if (id == "grey")
        return PresetNames::tr("Grey");
    return QString::fromStdString(id);
}

/// Opaque everywhere.
TransferFunction functionOf(const ColourMap& map, const TransferLimits& range, double unitDistance)
{
    TransferFunction function;
    function.opacities = {{range.least, 1}};
    function.unitDistance = unitDistance;
    return withColourMap(function, map, range);
}

QPixmap previewOf(const TransferFunction& function, QSize size, qreal scale)
{
    QPixmap pixmap(size * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const double height = size.height();
    const double width = size.width();
    for (double x = 0; x < width; x += 1 / scale) {
        const double value = (x + 0.5 / scale) / width;
        const double opaque = std::sqrt(std::clamp(opacityOf(function, value), 0.0, 1.0)) * height;
        painter.fillRect(QRectF(x, 0, 1 / scale, height), faded(colourAt(function, value), 0.35));
        painter.fillRect(QRectF(x, height - opaque, 1 / scale, opaque), colourAt(function, value));
    }
    return pixmap;
}

} // namespace

std::vector<Preset> suppliedPresets()
{
    std::vector<Preset> presets{{"preset.sequential",
                                 PresetNames::tr("Sequential: opaque where values are large"),
                                 {},
                                 [](const TransferLimits& range, double unit) {
                                     return sequentialTransferFunction(range.least, range.largest, unit);
                                 }},
                                {"preset.diverging",
                                 PresetNames::tr("Diverging: opaque at both ends"),
                                 {},
                                 [](const TransferLimits& range, double unit) {
                                     return divergingTransferFunction(range.least, range.largest, unit);
                                 }}};
    for (const ColourMap& map : colourMaps())
        presets.push_back(
            {QString::fromStdString("colours." + map.id), colourMapName(map.id), QString::fromStdString(map.source),
             [&map](const TransferLimits& range, double unit) { return functionOf(map, range, unit); }, false});
    return presets;
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
    for (const int scale : {1, 2, 3})
        for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) // a chosen one keeps its colours
            icon.addPixmap(previewOf(preset.make({0, 1}, 1), size, scale), mode);
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
