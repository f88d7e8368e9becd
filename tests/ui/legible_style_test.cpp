// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/legible_style.h"

#include <QApplication>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOptionButton>
#include <QTest>

#include <memory>

using namespace tetra;

/// Check boxes and radio buttons are seen in any palette.
class LegibleStyleTest : public QObject {
    Q_OBJECT
private slots:
    void contrastIsThatOfTheGuidelines();
    void indicatorsStandOut_data() { addPalettes(); }
    void indicatorsStandOut();
    void pressedButtonsStandOut_data() { addPalettes(); }
    void pressedButtonsStandOut();
    void hintsCanBeRead_data() { addPalettes(); }
    void hintsCanBeRead();
    void whatIsDisabledStepsBack();
    void theDesktopsColoursStay();

private:
    static void addPalettes();
};

namespace {

QPalette paletteOf(const QColor& window, const QColor& base, const QColor& text)
{
    QPalette palette(window);
    palette.setColor(QPalette::Base, base);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(role, text);
    return palette;
}

QImage picture(QStyle& style, QStyle::PrimitiveElement element, const QPalette& palette, QStyle::State state)
{
    QStyleOptionButton option;
    option.palette = palette;
    option.state = state;
    constexpr int side = 14;
    option.rect = QRect(2, 2, side, side);
    QImage image(side + 4, side + 4, QImage::Format_RGB32);
    image.fill(palette.color(QPalette::Window));
    QPainter painter(&image);
    style.drawPrimitive(element, &option, &painter);
    return image;
}

/// The least contrast of the outline, on its way through the middle from the left and from above, to what is outside
/// and inside of it.
double outlineContrast(const QImage& image, const QPalette& palette)
{
    const int middle = image.width() / 2;
    double least = 21;
    for (const bool isRow : {true, false}) {
        double best = 0;
        for (int i = 1; i < 5; ++i) {
            const QColor colour = isRow ? image.pixelColor(i, middle) : image.pixelColor(middle, i);
            best = std::max(best, std::min(contrast(colour, palette.color(QPalette::Window)),
                                           contrast(colour, palette.color(QPalette::Base))));
        }
        least = std::min(least, best);
    }
    return least;
}

double leastContrast(QStyle& style, const QPalette& palette, QStyle::State state)
{
    const QStyle::State off = state | QStyle::State_Off;
    return std::min(outlineContrast(picture(style, QStyle::PE_IndicatorCheckBox, palette, off), palette),
                    outlineContrast(picture(style, QStyle::PE_IndicatorRadioButton, palette, off), palette));
}

} // namespace

void LegibleStyleTest::contrastIsThatOfTheGuidelines()
{
    QCOMPARE(contrast(Qt::black, Qt::white), 21.0);
    QCOMPARE(contrast(Qt::white, Qt::white), 1.0);
    QVERIFY(std::abs(contrast(QColor("#767676"), Qt::white) - 4.54) < 0.01); // the known least grey for texts
}

void LegibleStyleTest::addPalettes()
{
    QTest::addColumn<QPalette>("palette");
    const std::unique_ptr<QStyle> fusion(QStyleFactory::create("fusion"));
    QTest::newRow("Fusion's light") << fusion->standardPalette();
    QTest::newRow("dark grey") << paletteOf(QColor(53, 54, 58), QColor(32, 33, 36), Qt::white);
    QTest::newRow("Breeze Dark") << paletteOf(QColor(42, 46, 50), QColor(27, 30, 32), QColor(252, 252, 252));
    QTest::newRow("Adwaita Dark") << paletteOf(QColor(53, 53, 53), QColor(45, 45, 45), QColor(238, 238, 236));
    QTest::newRow("black") << paletteOf(Qt::black, Qt::black, Qt::white);
    QTest::newRow("Solarized Light") << paletteOf(QColor("#eee8d5"), QColor("#fdf6e3"), QColor("#073642"));
}

void LegibleStyleTest::indicatorsStandOut()
{
    QFETCH(QPalette, palette);
    LegibleStyle style;
    const QStyle::State on = QStyle::State_Enabled;
    for (const QStyle::State state :
         {on, on | QStyle::State_MouseOver, on | QStyle::State_HasFocus | QStyle::State_KeyboardFocusChange})
        QVERIFY2(leastContrast(style, palette, state) >= 3,
                 qPrintable(QString::number(leastContrast(style, palette, state))));
}

void LegibleStyleTest::pressedButtonsStandOut()
{
    QFETCH(QPalette, palette);
    LegibleStyle style;
    const QStyle::State on = QStyle::State_Enabled | QStyle::State_On;
    QVERIFY(outlineContrast(picture(style, QStyle::PE_PanelButtonCommand, palette, on), palette) >= 3);
}

void LegibleStyleTest::hintsCanBeRead()
{
    QFETCH(QPalette, palette);
    LegibleStyle style;
    style.polish(palette);
    const QColor window = palette.color(QPalette::Window);
    QImage pixel(1, 1, QImage::Format_RGB32);
    pixel.fill(window);
    QPainter(&pixel).fillRect(pixel.rect(), palette.color(QPalette::PlaceholderText));
    QVERIFY(contrast(pixel.pixelColor(0, 0), window) >= 4.4); // rounded to whole steps of a channel
    QVERIFY(contrast(pixel.pixelColor(0, 0), window) < contrast(palette.color(QPalette::WindowText), window));
}

void LegibleStyleTest::whatIsDisabledStepsBack()
{
    LegibleStyle style;
    const QPalette palette = paletteOf(QColor(53, 54, 58), QColor(32, 33, 36), Qt::white);
    const double off = leastContrast(style, palette, QStyle::State_None);
    QVERIFY(off > 1.5 && off < leastContrast(style, palette, QStyle::State_Enabled));
}

void LegibleStyleTest::theDesktopsColoursStay()
{
    QApplication::setStyle("fusion");
    const QPalette before = QApplication::palette();
    useLegibleStyle();
    QVERIFY(qobject_cast<LegibleStyle*>(QApplication::style()) != nullptr);
    for (int role = 0; role < QPalette::NColorRoles; ++role)
        if (role != QPalette::PlaceholderText)
            QCOMPARE(QApplication::palette().color(static_cast<QPalette::ColorRole>(role)),
                     before.color(static_cast<QPalette::ColorRole>(role)));
    QApplication::setStyle("windows");
    useLegibleStyle();
    QVERIFY(qobject_cast<LegibleStyle*>(QApplication::style()) == nullptr);
}

QTEST_MAIN(LegibleStyleTest)
#include "legible_style_test.moc"
