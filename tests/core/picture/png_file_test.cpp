// SPDX-License-Identifier: GPL-3.0-or-later
// PNG files of ours are what Qt reads them as, pixel by pixel and text by text; and texts are found in files that Qt
// wrote, as TAn did up to version 0.1.
#include "core/picture/picture_file.h"
#include "core/picture/png_file.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QImageReader>
#include <QTemporaryDir>
#include <QTest>

#include <limits>
#include <random>

using namespace tetra;

namespace {

constexpr const char* longText = "Ein langer Text, der gepackt wird: {\"format\": \"tan-session\", \"version\": 1}";

Picture randomPicture(int width, int height)
{
    std::mt19937 random(7);
    Picture picture{.width = width, .height = height, .pixels = {}};
    for (int i = 0; i < width * height; ++i) {
        const auto bits = random();
        picture.pixels.push_back({static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                                  static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 24)});
    }
    return picture;
}

QByteArray bytesOf(const Result<std::vector<std::byte>>& file)
{
    return file ? QByteArray(reinterpret_cast<const char*>(file->data()), static_cast<qsizetype>(file->size()))
                : QByteArray();
}

std::span<const std::byte> spanOf(const QByteArray& bytes)
{
    return std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

QByteArray writtenByQt(const QString& keyword, const QString& text)
{
    QImage image(3, 2, QImage::Format_RGB32);
    image.fill(Qt::red);
    image.setText(keyword, text);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace

class PngFileTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreThoseOfThePicture_data()
    {
        QTest::addColumn<bool>("transparent");
        QTest::newRow("opaque") << false;
        QTest::newRow("transparent") << true;
    }
    void pixelsAreThoseOfThePicture()
    {
        QFETCH(bool, transparent);
        const Picture picture = randomPicture(37, 11);
        const QImage image = QImage::fromData(bytesOf(pngOf(picture, {.transparent = transparent})), "PNG");
        QCOMPARE(image.size(), QSize(37, 11));
        QCOMPARE(image.hasAlphaChannel(), transparent);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const auto& [red, green, blue, alpha] = picture.pixels[std::size_t(y) * 37 + std::size_t(x)];
                QCOMPARE(image.pixelColor(x, y), QColor(red, green, blue, transparent ? alpha : 255));
            }
    }

    void greysKeepTheir16Bits()
    {
        const std::vector<std::uint16_t> greys = {0, 1, 255, 256, 65534, 65535};
        const QImage image = QImage::fromData(bytesOf(pngOfGreys(greys, 3, 2)), "PNG");
        QCOMPARE(image.format(), QImage::Format_Grayscale16);
        for (std::size_t i = 0; i < greys.size(); ++i)
            QCOMPARE(reinterpret_cast<const std::uint16_t*>(image.constScanLine(int(i / 3)))[i % 3], greys[i]);
    }

    void aFileSaysWhatItIs()
    {
        const QByteArray file =
            bytesOf(pngOf(randomPicture(4, 4),
                          {.dotsPerInch = 300,
                           .texts = {{"Title", "Kopf"}, {"Description", "Fehler ≤ 1 %"}, {"Software", longText}}}));
        const QImage image = QImage::fromData(file, "PNG");
        QCOMPARE(image.dotsPerMeterX(), 11811);
        QCOMPARE(image.dotsPerMeterY(), 11811);
        QCOMPARE(image.text("Title"), QString("Kopf"));
        QCOMPARE(image.text("Description"), QString::fromUtf8("Fehler ≤ 1 %"));
        QCOMPARE(image.text("Software"), QString(longText));
        for (const auto& [keyword, text] :
             {std::pair("Title", "Kopf"), std::pair("Description", "Fehler ≤ 1 %"), std::pair("Software", longText)})
            QCOMPARE(textInPng(spanOf(file), keyword), std::string(text));
        QCOMPARE(textInPng(spanOf(file), "title"), std::string());
        QVERIFY(!bytesOf(pngOf(randomPicture(4, 4))).contains("pHYs"));
    }

    void textsOfOlderPicturesAreFound_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("short") << QString("one");
        QTest::newRow("long") << QString(longText);
        QTest::newRow("of Latin 1") << QString::fromUtf8("größer");
        QTest::newRow("long, of Latin 1") << QString::fromUtf8("größer ").repeated(30).trimmed();
        QTest::newRow("of any letters") << QString::fromUtf8("κεφαλή ≤ 1");
        QTest::newRow("long, of any letters") << QString::fromUtf8("κεφαλή ").repeated(30).trimmed();
    }
    void textsOfOlderPicturesAreFound()
    {
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(textInPng(spanOf(writtenByQt("TAn-session", text)), "TAn-session")), text);
    }

    /// Wherever it ends, and whatever byte of it is another one: no text, or the right one.
    void damagedFilesHaveNone()
    {
        const QByteArray file = writtenByQt("TAn-session", longText);
        for (qsizetype size = 0; size < file.size(); ++size) {
            const std::string found = textInPng(spanOf(file.first(size)), "TAn-session");
            QVERIFY(found.empty() || found == longText);
        }
        for (qsizetype at = 0; at < file.size(); ++at) {
            QByteArray damaged = file;
            damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
            const std::string found = textInPng(spanOf(damaged), "TAn-session");
            QVERIFY(found.empty() || found == longText);
        }
        QCOMPARE(textInPng(spanOf("no picture"), "TAn-session"), std::string());
    }

    /// In the places that their formats have for it, in UTF-8; what is long in several pieces.
    void otherFormatsSayItToo()
    {
        const std::string session(100'000, '7');
        const PngFacts facts{
            .dotsPerInch = 300,
            .texts = {
                {"Title", "Kopf"}, {"Description", "Fehler ≤ 1 %"}, {"Software", "TAn 0"}, {"TAn-session", session}}};
        const QByteArray lines = "Description: Fehler ≤ 1 %\n";
        if (writesTiff()) {
            const QByteArray tiff = bytesOf(tiffOf(randomPicture(4, 4), facts));
            QVERIFY(tiff.contains(lines + "TAn-session: 777"));
            QVERIFY(tiff.contains("777\nTitle: Kopf") && tiff.contains("TAn 0") && !tiff.contains("Software: "));
        }
        if (writesJpeg()) {
            const QByteArray jpeg = bytesOf(jpegOf(randomPicture(4, 4), facts));
            QVERIFY(jpeg.contains(lines + "Software: TAn 0\nTAn-session: 777"));
            QVERIFY(jpeg.contains("777\nTitle: Kopf"));
            QCOMPARE(QImage::fromData(jpeg, "JPEG").dotsPerMeterX(), 11811);
            QCOMPARE(QImage::fromData(jpeg, "JPEG").size(), QSize(4, 4));
        }
        if (writesPdf()) {
            const QTemporaryDir folder;
            const QString path = folder.filePath("picture.pdf");
            QVERIFY(writePicture(randomPicture(4, 4), path.toStdString(), facts));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray pdf = file.readAll();
            QVERIFY(pdf.contains("/Title (Kopf)") && pdf.contains("/Creator (TAn 0)") && pdf.contains("777"));
        }
    }

    /// Which format a file has, its ending says, in whatever letters; others are PNG, as ever.
    void theEndingIsTheFormat()
    {
        QCOMPARE(pictureFormatOf("a.TIFF"), std::optional(PictureFormat::Tiff));
        QCOMPARE(pictureFormatOf("a.jpeg"), std::optional(PictureFormat::Jpeg));
        QVERIFY(!pictureFormatOf("png") && !pictureFormatOf("a.svg"));
        QVERIFY(!checkPictureFormat("a.svg", false).ok() && checkPictureFormat("a.PNG", true).ok());
        if (writesJpeg())
            QVERIFY(checkPictureFormat("a.jpg", false).ok() && !checkPictureFormat("a.jpg", true).ok());
        const QTemporaryDir folder;
        QVERIFY(writePicture(randomPicture(4, 4), folder.filePath("picture.unknown").toStdString()));
        QCOMPARE(QImage(folder.filePath("picture.unknown"), "PNG").size(), QSize(4, 4));
        QVERIFY(!jpegOf(randomPicture(4, 4), {.transparent = true}).ok());
    }

    void whatIsTooLargeIsRefused()
    {
        const Picture picture{
            .width = std::numeric_limits<int>::max(), .height = std::numeric_limits<int>::max(), .pixels = {}};
        const auto file = pngOf(picture);
        QVERIFY(!file.ok() && file.error().kind == ErrorKind::OutOfResource);
    }

    void aFileAppearsWholeOrNotAtAll()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("picture.png").toStdString();
        QVERIFY(writePicture(randomPicture(8, 8), path));
        QCOMPARE(QImage(folder.filePath("picture.png")).size(), QSize(8, 8));
        const Status none = writePicture(randomPicture(8, 8), folder.filePath("no/picture.png").toStdString());
        QVERIFY(!none.ok() && none.error().kind == ErrorKind::CannotWrite);
    }
};

QTEST_GUILESS_MAIN(PngFileTest)
#include "png_file_test.moc"
