// SPDX-License-Identifier: GPL-3.0-or-later
// On a system without a font a text in a picture is an error that says so. A program of its own process, as the fonts
// of a system are looked for once.
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/annotations/lens_painter.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class NoFontsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QFile file(folder_.filePath("fonts.conf"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("<?xml version=\"1.0\"?>\n<!DOCTYPE fontconfig SYSTEM \"fonts.dtd\">\n<fontconfig/>\n");
        file.close();
        qputenv("FONTCONFIG_FILE", file.fileName().toUtf8());
    }

    void anErrorSaysSo()
    {
        const auto fonts = openFonts();
        QVERIFY(!fonts.ok());
        QVERIFY(fonts.error().kind == ErrorKind::OutOfResource);
        QVERIFY2(fonts.error().text().starts_with("This system has no font"), fonts.error().text().c_str());
        QVERIFY(!openFonts("Helvetica").ok());
    }

    void thePictureStaysAsItWas()
    {
        const std::vector<std::array<std::uint8_t, 4>> before(300 * 200, {10, 20, 30, 255});
        Picture picture{300, 200, before};
        AnnotationContent content;
        const Status painted = paintAnnotations(pixelsOf(picture), content, 1);
        QVERIFY(!painted.ok() && painted.error().text().find("no font") != std::string::npos);
        DrawnLens lens;
        lens.place.square = {50, 50, 80, 80};
        QVERIFY(!paintLens(pixelsOf(picture), lens, {}, 1).ok());
        QVERIFY(picture.pixels == before);
        for (AnnotationPlace& place : content.state.places)
            place.shown = false;
        QVERIFY(paintAnnotations(pixelsOf(picture), content, 1).ok());
    }

private:
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(NoFontsTest)
#include "no_fonts_test.moc"
