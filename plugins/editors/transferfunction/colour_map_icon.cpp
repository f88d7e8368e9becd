// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/colour_map_icon.h"

#include <QCoreApplication>
#include <QImage>
#include <QPixmap>

namespace tetra {
namespace {

class ColourMapNames {
    Q_DECLARE_TR_FUNCTIONS(ColourMapNames)
};

QPixmap preview(const ColourMap& map, int edge)
{
    QImage image(edge, edge, QImage::Format_RGB32);
    for (int x = 0; x < edge; ++x) {
        const auto [red, green, blue] = colourAt(map, (x + 0.5) / edge);
        for (int y = 0; y < edge; ++y)
            image.setPixelColor(x, y, QColor::fromRgbF(red, green, blue));
    }
    return QPixmap::fromImage(image);
}

} // namespace

QIcon colourMapIcon(const ColourMap& map)
{
    constexpr int menuIcon = 16;
    QIcon icon;
    for (const int scale : {1, 2, 3})
        icon.addPixmap(preview(map, menuIcon * scale));
    return icon;
}

QString colourMapName(const std::string& id)
{
    if (id == "cool-warm")
        return ColourMapNames::tr("&Cool to warm");
    if (id == "grey")
        return ColourMapNames::tr("&Grey");
    return QString::fromStdString(id);
}

} // namespace tetra
