// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/legible_style.h"

#include <QApplication>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tetra {
namespace {

const QString fusion = "fusion";
constexpr double enough = 3.5;       ///< a little more than 3, as the edge of a circle is blurred
constexpr double enoughForOff = 1.8; ///< of what is disabled, which is to step back
constexpr double enoughForText = 4.5;
constexpr double buttonRadius = 2; ///< of Fusion's buttons

/// How bright a screen shows a colour, 0 to 1.
double luminance(const QColor& colour)
{
    const auto linear = [](double channel) {
        return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

QColor mixed(const QColor& from, const QColor& to, float share)
{
    const auto between = [share](float a, float b) { return a + share * (b - a); };
    return QColor::fromRgbF(between(from.redF(), to.redF()), between(from.greenF(), to.greenF()),
                            between(from.blueF(), to.blueF()));
}

/// `colour`, taken towards that of texts until it stands out from the window and from fields.
QColor legible(const QColor& colour, const QPalette& palette, double wanted)
{
    constexpr int parts = 20;
    QColor found = colour;
    for (int part = 0; part <= parts; ++part) {
        found = mixed(colour, palette.color(QPalette::Text), static_cast<float>(part) / parts);
        if (std::min(contrast(found, palette.color(QPalette::Window)),
                     contrast(found, palette.color(QPalette::Base))) >= wanted)
            break;
    }
    return found;
}

QColor outlineColour(const QStyleOption& option)
{
    const QPalette& palette = option.palette;
    const bool byKeys = option.state.testFlag(QStyle::State_KeyboardFocusChange);
    if (byKeys && option.state.testFlag(QStyle::State_HasFocus))
        return legible(palette.color(QPalette::Highlight), palette, enough);
    const bool isOn = option.state.testFlag(QStyle::State_Enabled);
    return legible(palette.color(QPalette::Window), palette, isOn ? enough : enoughForOff);
}

void strokeOutline(QPainter& painter, const QColor& colour, const std::function<void()>& draw)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colour);
    painter.setBrush(Qt::NoBrush);
    draw();
    painter.restore();
}

/// The circle that Fusion draws.
QRectF radioCircle(const QRect& rect)
{
    const double radius = (rect.width() + (rect.width() + 1) % 2) / 2.0 - 1;
    const QPointF centre = rect.center() + QPoint(1, 1);
    return {centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)};
}

} // namespace

double contrast(const QColor& one, const QColor& other)
{
    const auto [darker, brighter] = std::minmax({luminance(one), luminance(other)});
    return (brighter + 0.05) / (darker + 0.05);
}

LegibleStyle::LegibleStyle() : QProxyStyle(QStyleFactory::create(fusion)) {}

void LegibleStyle::polish(QPalette& palette)
{
    QProxyStyle::polish(palette);
    const QColor window = palette.color(QPalette::Window);
    QColor hint = palette.color(QPalette::PlaceholderText);
    const QColor ink(hint.rgb());
    while (hint.alphaF() < 1 && contrast(mixed(window, ink, hint.alphaF()), window) < enoughForText)
        hint.setAlphaF(std::min(hint.alphaF() + 0.05F, 1.0F));
    palette.setColor(QPalette::Active, QPalette::PlaceholderText, hint);
    palette.setColor(QPalette::Inactive, QPalette::PlaceholderText, hint);
}

void LegibleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const QRectF edge = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    if (element == PE_IndicatorCheckBox)
        strokeOutline(*painter, outlineColour(*option), [&] { painter->drawRect(edge); });
    else if (element == PE_IndicatorRadioButton)
        strokeOutline(*painter, outlineColour(*option), [&] { painter->drawEllipse(radioCircle(option->rect)); });
    else if (element == PE_PanelButtonCommand && option->state.testFlag(State_On))
        strokeOutline(*painter, legible(option->palette.color(QPalette::Highlight), option->palette, enough),
                      [&] { painter->drawRoundedRect(edge, buttonRadius, buttonRadius); });
}

void useLegibleStyle()
{
    if (QApplication::style()->name().compare(fusion, Qt::CaseInsensitive) == 0)
        QApplication::setStyle(new LegibleStyle);
}

} // namespace tetra
