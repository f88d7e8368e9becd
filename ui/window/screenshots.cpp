// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/screenshots.h"

#include "ui/widgets/dark_palette.h"
#include "ui/window/photographer.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>

namespace tetra {
int makeScreenshots(PluginHost& host, const QString& folder)
{
    if (!QDir().mkpath(folder))
        return 4;
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    const QPalette light = QApplication::style()->standardPalette();
    bool isWhole = true;
    for (const bool dark : {false, true}) {
        QApplication::setPalette(dark ? darkPalette() : light);
        isWhole &= Photographer(host, QDir(folder), dark ? "dark" : "light").takeAll();
    }
    return isWhole ? 0 : 4;
}

} // namespace tetra
