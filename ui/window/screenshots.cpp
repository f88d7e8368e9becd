// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/screenshots.h"

#include "ui/widgets/legible_style.h"
#include "ui/window/photographer.h"

#include <QApplication>
#include <QStyle>

namespace tetra {
namespace {

QPalette darkPalette()
{
    QPalette palette(QColor(53, 54, 58), QColor(42, 43, 46));
    palette.setColor(QPalette::Base, QColor(32, 33, 36));
    palette.setColor(QPalette::AlternateBase, QColor(42, 43, 46));
    palette.setColor(QPalette::Highlight, QColor(64, 120, 192));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, QColor(53, 54, 58));
    palette.setColor(QPalette::ToolTipText, Qt::white);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(128, 128, 128));
    return palette;
}

} // namespace

int makeScreenshots(PluginHost& host, const QString& folder)
{
    if (!QDir().mkpath(folder))
        return 4;
    QApplication::setStyle(new LegibleStyle);
    const QPalette light = QApplication::style()->standardPalette();
    bool isWhole = true;
    for (const bool dark : {false, true}) {
        QPalette palette = dark ? darkPalette() : light;
        QApplication::style()->polish(palette);
        QApplication::setPalette(palette);
        isWhole &= Photographer(host, QDir(folder), dark ? "dark" : "light").takeAll();
    }
    return isWhole ? 0 : 4;
}

} // namespace tetra
