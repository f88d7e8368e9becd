// SPDX-License-Identifier: GPL-3.0-or-later
// What the window writes over its picture is what is written over saved ones, with the numbers of the user's locale.
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/annotations/axis_ticks.h"
#include "tests/ui/window_fixture.h"
#include "ui/session/annotation_language.h"

#include <QLocale>
#include <QPainter>
#include <QTest>

using namespace tetra;

class AnnotationOverlayTest : public QObject {
    Q_OBJECT
private slots:
    void theWindowIsWrittenOverAsPicturesAre_data();
    void theWindowIsWrittenOverAsPicturesAre();
    void numbersAreThoseOfTheLocale();
};

void AnnotationOverlayTest::theWindowIsWrittenOverAsPicturesAre_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

/// Over an opaque ground, in as many pixels as the screen has; but for what blending in two steps rounds.
void AnnotationOverlayTest::theWindowIsWrittenOverAsPicturesAre()
{
    QFETCH(bool, dark);
    WindowFixture window;
    window.window.open(QString::fromStdString(buildSampleModel(*window.host, sampleDataset(8), window.folderPath())));
    window.window.show();
    QTRY_VERIFY(window.workbench.session().model() && window.settled());
    AnnotationState all;
    for (AnnotationPlace& place : all.places)
        place.shown = true;
    window.workbench.session().setAnnotations(all);
    const Colour ground = dark ? Colour{0.1F, 0.1F, 0.2F} : Colour{1, 1, 1};
    window.workbench.session().setBackground(ground);
    auto& overlay = window.find<QWidget>("viewport.annotations");
    const double pixelsPerUnit = overlay.devicePixelRatioF();

    QImage expected((QSizeF(overlay.size()) * pixelsPerUnit).toSize(), QImage::Format_RGBA8888);
    expected.fill(QColor::fromRgbF(ground.red, ground.green, ground.blue));
    QImage seen = expected.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    const QImage before = seen;
    seen.setDevicePixelRatio(pixelsPerUnit);
    overlay.render(&seen, {}, {}, {});
    const Viewport& viewport = window.viewport();
    const auto content = window.workbench.scenes().annotations(viewport.shownCamera(), viewport.background());
    QVERIFY(content.fonts != nullptr && !content.title.empty() && !content.accuracy.empty());
    QVERIFY(paintAnnotations(pixelsOf(expected), content, pixelsPerUnit).ok());
    int different = 0, largest = 0;
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x) {
            const QColor one = seen.pixelColor(x, y), other = expected.pixelColor(x, y);
            largest = std::max({largest, std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                                std::abs(one.blue() - other.blue())});
            different += other != before.pixelColor(x, y) ? 1 : 0;
        }
    QVERIFY2(largest <= 2, QByteArray::number(largest));
    QVERIFY2(different > 2000 * pixelsPerUnit * pixelsPerUnit, QByteArray::number(different));
}

/// In every locale that Qt knows.
void AnnotationOverlayTest::numbersAreThoseOfTheLocale()
{
    int compared = 0;
    for (QLocale locale : QLocale::matchingLocales(QLocale::AnyLanguage, QLocale::AnyScript, QLocale::AnyTerritory)) {
        if (locale.zeroDigit().size() > 1)
            continue; // of such digits Qt counts the halves, and leaves one of the exponent's away
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        const NumberSigns signs = numberSigns(locale);
        for (const double value : {0.0, -1.25, 1809.5, 0.0001, 123456.0, -2.5e-5, 1e20, 5e-7, 3.0}) {
            const QString expected = locale.toString(value, 'g', 4);
            const QString text = QString::fromStdString(shortNumber(value, signs));
            QVERIFY2(text == expected, qPrintable(locale.name() + ": " + text + " for " + expected));
            ++compared;
        }
        QCOMPARE(tickTexts({-0.5, 0, 0.5}, signs).front(), locale.toString(-0.5, 'f', 1).toStdString());
        QCOMPARE(tickTexts({1e7, 1.5e7}, signs).back(), locale.toString(1.5e7, 'e', 1).toStdString());
    }
    QVERIFY(compared > 1000);
}

QTEST_MAIN(AnnotationOverlayTest)
#include "annotation_overlay_test.moc"
