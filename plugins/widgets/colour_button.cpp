// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/colour_button.h"

#include <tan/render.h>

#include <QColorDialog>
#include <QCoreApplication>
#include <QMenu>
#include <QPainter>

#include <array>

namespace tetra {
namespace {

/// The names of distinctColour()'s colours, in its order.
constexpr std::array paletteNames{
    QT_TRANSLATE_NOOP("Palette", "Orange"),       QT_TRANSLATE_NOOP("Palette", "Sky blue"),
    QT_TRANSLATE_NOOP("Palette", "Bluish green"), QT_TRANSLATE_NOOP("Palette", "Vermilion"),
    QT_TRANSLATE_NOOP("Palette", "Blue"),         QT_TRANSLATE_NOOP("Palette", "Reddish purple"),
    QT_TRANSLATE_NOOP("Palette", "Yellow"),
};

/// With a rim of half the strength of texts, as the colour may be that of the window.
QIcon swatch(const QColor& colour, const QPalette& palette, qreal ratio)
{
    constexpr int side = 16;
    QColor rim = palette.color(QPalette::WindowText);
    rim.setAlphaF(0.5F);
    QPixmap pixmap(QSize(side, side) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(rim);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(0.5, 0.5, side - 1, side - 1), 3, 3);
    return QIcon(pixmap);
}

} // namespace

QColor qtColour(const Colour& colour)
{
    return QColor::fromRgbF(colour.red, colour.green, colour.blue);
}

Colour colourOf(const QColor& colour)
{
    return {colour.redF(), colour.greenF(), colour.blueF()};
}

ColourButton::ColourButton(QWidget* parent) : QToolButton(parent)
{
    setPopupMode(QToolButton::InstantPopup);
    setToolTip(tr("Colour"));
    setAccessibleName(tr("Colour"));
    setAutoRaise(true);
    auto* menu = new QMenu(this);
    setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(menu); });
}

void ColourButton::setColour(const QColor& colour)
{
    colour_ = colour;
    setIcon(swatch(colour, palette(), devicePixelRatioF()));
}

void ColourButton::fillMenu(QMenu* menu)
{
    menu->clear();
    const auto add = [&](const QString& name, const QColor& colour, std::size_t index) {
        QAction* action = menu->addAction(swatch(colour, palette(), devicePixelRatioF()), name);
        action->setObjectName(QString("%1.%2").arg(objectName()).arg(index));
        connect(action, &QAction::triggered, this, [this, colour] { emit colourChosen(colour); });
    };
    for (std::size_t index = 0; index < paletteNames.size(); ++index) {
        const auto [red, green, blue] = distinctColour(index);
        add(QCoreApplication::translate("Palette", paletteNames[index]), QColor::fromRgbF(red, green, blue), index);
    }
    menu->addSection(tr("Materials"));
    for (std::size_t index = 0; index < materials.size(); ++index) {
        const auto [red, green, blue] = materials[index].colour;
        add(QCoreApplication::translate("tetra::Message", materials[index].name.text),
            QColor::fromRgbF(red, green, blue), paletteNames.size() + index);
    }
    menu->addSeparator();
    add(tr("White"), Qt::white, paletteNames.size() + materials.size());
    add(tr("Black"), Qt::black, paletteNames.size() + materials.size() + 1);
    menu->addSeparator();
    QAction* other = menu->addAction(tr("Other Colour…"), this, &ColourButton::chooseOther);
    other->setObjectName(objectName() + ".other");
}

void ColourButton::chooseOther()
{
    auto* dialog = new QColorDialog(colour_, window());
    dialog->setObjectName("colourDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QColorDialog::colorSelected, this, &ColourButton::colourChosen);
    dialog->open();
}

} // namespace tetra
