// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/annotation_language.h"

#include "ui/session/message_text.h"

#include <QFont>
#include <QGuiApplication>

namespace tetra {

NumberSigns numberSigns(const QLocale& locale)
{
    return {.decimalPoint = locale.decimalPoint().toStdString(),
            .minus = locale.negativeSign().toStdString(),
            .plus = locale.positiveSign().toStdString(),
            .exponent = locale.exponential().toStdString(),
            .zero = locale.zeroDigit().toStdU32String().front()};
}

AnnotationLanguage annotationLanguage()
{
    return {numberSigns(QLocale()), [](const Message& message) { return translatedMessage(message).toStdString(); }};
}

std::shared_ptr<const Fonts> windowFonts()
{
    if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr)
        return nullptr;
    const auto fonts = openFonts(QGuiApplication::font().family().toStdString());
    return fonts ? *fonts : nullptr;
}

PixelView pixelsOf(QImage& image)
{
    Q_ASSERT(image.format() == QImage::Format_RGBA8888);
    const auto count = static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
    return {{reinterpret_cast<std::array<std::uint8_t, 4>*>(image.bits()), count}, image.width(), image.height()};
}

} // namespace tetra
