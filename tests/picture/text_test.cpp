// SPDX-License-Identifier: GPL-3.0-or-later
// Texts: their metrics against those of the programs that fontconfig and HarfBuzz come with, and what is painted by
// what has to be the same, or larger, or elsewhere.
#include "core/picture/drawing/text.h"
#include "tests/lacks.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <thread>
#include <vector>

using namespace tetra;

namespace {

constexpr int width = 400, height = 80;
constexpr double baseline = 50;
constexpr std::string_view noCharacter = "\U0010fffd"; ///< for private use, in no font of a system

std::shared_ptr<const Fonts> fonts(const std::string& family = {})
{
    const auto opened = openFonts(family);
    return opened ? *opened : nullptr;
}

/// Black on white, from 20 on.
Picture painted(const Fonts& fonts, std::string_view text, const TextStyle& style = {.size = 24}, double scale = 1,
                const TextRim& rim = {})
{
    Picture picture{static_cast<int>(width * scale), static_cast<int>(height * scale), {}};
    picture.pixels.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
                          {255, 255, 255, 255});
    paintText(PixelCanvas(pixelsOf(picture), scale), fonts, text, style, {20, baseline}, {0, 0, 0}, rim);
    return picture;
}

struct InkedPart {
    int left = width, right = -1, top = height, bottom = -1; ///< of the pixels with ink, the last ones with
    double sum = 0;                                          ///< of ink, in pixels
};

InkedPart inkOf(Picture picture)
{
    InkedPart part{picture.width, -1, picture.height, -1, 0};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (const int ink = 255 - pixelsOf(picture).row(y)[x][0]; ink > 0) {
                part.left = std::min(part.left, x);
                part.right = std::max(part.right, x);
                part.top = std::min(part.top, y);
                part.bottom = std::max(part.bottom, y);
                part.sum += ink / 255.0;
            }
    return part;
}

double advanceOf(const Fonts& fonts, std::string_view text, const TextStyle& style = {.size = 24})
{
    return measured(fonts, text, style).advance;
}

QByteArray outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished() && process.exitCode() == 0 ? process.readAllStandardOutput().trimmed()
                                                                : QByteArray();
}

/// The file of the system's sans-serif, as fontconfig's own program finds it.
QString fontFile(bool bold)
{
    return QString::fromUtf8(outputOf("fc-match", {"-f", "%{file}", bold ? "sans-serif:bold" : "sans-serif"}));
}

bool someFontHas(char32_t character)
{
    return !outputOf("fc-list", {QString(":outline=true:charset=%1").arg(static_cast<uint>(character), 0, 16), "file"})
                .isEmpty();
}

} // namespace

class PictureTextTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        fonts_ = fonts();
        QVERIFY(fonts_ != nullptr);
    }

    void advancesAreThoseOfHarfBuzz_data();
    void advancesAreThoseOfHarfBuzz();
    void inkLiesBetweenAscentAndDescent();
    void aTextIsAsLargeAsItsScale();
    void whatNoFontHasIsABox();
    void otherFontsHelp();
    void textIsReadFromRightToLeft();
    void marksAreWrittenOntoTheirLetters();
    void rimsSurroundLetters();
    void anyTextCanBePainted();
    void threadsShareFonts();

private:
    std::shared_ptr<const Fonts> fonts_;
};

void PictureTextTest::advancesAreThoseOfHarfBuzz_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("bold");
    for (const bool bold : {false, true})
        for (const char* text : {"Error 0.5 %", "AVATAR To.", "office", "Größe µm", "θερμοκρασία"})
            QTest::addRow("%s%s", text, bold ? ", bold" : "") << QString(text) << bold;
}

/// By its own functions for fonts, not FreeType's, in the font's own units.
void PictureTextTest::advancesAreThoseOfHarfBuzz()
{
    QFETCH(QString, text);
    QFETCH(bool, bold);
    if (QStandardPaths::findExecutable("hb-shape").isEmpty() || QStandardPaths::findExecutable("fc-match").isEmpty())
        QSKIP_WITHOUT("hb-shape and fc-match");
    const QByteArray shaped = outputOf(
        "hb-shape", {"--font-funcs=ot", "--font-size=4800", "--no-glyph-names", "--no-clusters", fontFile(bold), text});
    QVERIFY(shaped.startsWith('['));
    double expected = 0; // "[36+1368|57@-12,0+1368]"
    for (const QByteArray& glyph : shaped.mid(1, shaped.size() - 2).split('|'))
        expected += glyph.mid(glyph.lastIndexOf('+') + 1).toDouble();
    const TextStyle style{.size = 48, .bold = bold};
    const double advance = advanceOf(*fonts_, text.toStdString(), style);
    QVERIFY2(std::abs(advance - expected / 100) < 0.02 * static_cast<double>(text.size()),
             shaped + ": " + QByteArray::number(advance));
}

void PictureTextTest::inkLiesBetweenAscentAndDescent()
{
    for (const bool bold : {false, true}) {
        const TextStyle style{.size = 24, .bold = bold};
        const TextMetrics metrics = measured(*fonts_, "Hgj|", style);
        const InkedPart ink = inkOf(painted(*fonts_, "Hgj|", style));
        QVERIFY(ink.top >= baseline - metrics.ascent - 1 && ink.bottom <= baseline + metrics.descent);
        QVERIFY(ink.left >= 18 && ink.right <= 20 + metrics.advance + 2);
        QVERIFY(metrics.ascent > 15 && metrics.descent > 3 && metrics.height() < 48);
        // Letters without descenders stand on the baseline.
        QCOMPARE(inkOf(painted(*fonts_, "HH", style)).bottom, static_cast<int>(baseline) - 1);
    }
    QVERIFY(inkOf(painted(*fonts_, "Hn", {.size = 24, .bold = true})).sum >
            1.2 * inkOf(painted(*fonts_, "Hn", {.size = 24})).sum);
    QCOMPARE(advanceOf(*fonts_, ""), 0.0);
}

void PictureTextTest::aTextIsAsLargeAsItsScale()
{
    const double once = inkOf(painted(*fonts_, "Temperature 12.5")).sum;
    for (const double scale : {1.5, 2.0, 3.0}) {
        const InkedPart ink = inkOf(painted(*fonts_, "Temperature 12.5", {.size = 24}, scale));
        QVERIFY2(std::abs(ink.sum / (once * scale * scale) - 1) < 0.06, QByteArray::number(ink.sum / once));
        QVERIFY(std::abs((ink.right + 1) / scale - (20 + advanceOf(*fonts_, "Temperature 12.5"))) < 3);
    }
    // Metrics are proportional to the size.
    const double ten = advanceOf(*fonts_, "Temperature", {.size = 10});
    QVERIFY(std::abs(advanceOf(*fonts_, "Temperature", {.size = 37}) / 3.7 - ten) < 0.2);
}

void PictureTextTest::whatNoFontHasIsABox()
{
    const InkedPart box = inkOf(painted(*fonts_, noCharacter));
    QVERIFY(box.sum > 10 && advanceOf(*fonts_, noCharacter) > 5);
    QVERIFY(painted(*fonts_, noCharacter).pixels == painted(*fonts_, "\U0010fffc").pixels);
    QVERIFY(painted(*fonts_, noCharacter).pixels != painted(*fonts_, "a").pixels);
    // What is not UTF-8 is a sign that says so, one for each byte.
    QVERIFY(painted(*fonts_, "\xff\xc3").pixels == painted(*fonts_, "\ufffd\ufffd").pixels);
}

/// The characters of three scripts that the first font lacks, each where a font has it.
void PictureTextTest::otherFontsHelp()
{
    int helped = 0;
    for (const char32_t character : {U'\u0e01', U'\u0915', U'\u1230'}) {
        const std::string text = QString::fromUcs4(&character, 1).toStdString();
        if (!someFontHas(character))
            continue;
        ++helped;
        QVERIFY(painted(*fonts_, text).pixels != painted(*fonts_, noCharacter).pixels);
        QVERIFY(painted(*fonts_, "a " + text + " b").pixels != painted(*fonts_, "a  b").pixels);
        // The others stay those of the first font, so the text is as wide as its parts.
        QVERIFY(std::abs(advanceOf(*fonts_, "a " + text) - advanceOf(*fonts_, "a ") - advanceOf(*fonts_, text)) < 0.1);
    }
    if (helped == 0)
        QSKIP_WITHOUT("fonts of Thai, Devanagari or Ethiopic");
}

void PictureTextTest::textIsReadFromRightToLeft()
{
    if (!someFontHas(U'\u05d0') || !someFontHas(U'\u0633'))
        QSKIP_WITHOUT("fonts of Hebrew and Arabic");
    // The same as the letters the other way around with an order to write them from left to right.
    QVERIFY(painted(*fonts_, "אבג").pixels == painted(*fonts_, "\u202dגבא\u202c").pixels);
    QVERIFY(painted(*fonts_, "אבג").pixels != painted(*fonts_, "\u202dאבג\u202c").pixels);
    QVERIFY(painted(*fonts_, "a אבג 12 b").pixels == painted(*fonts_, "\u202da 12 גבא b\u202c").pixels);
    // Parentheses turn around.
    QVERIFY(painted(*fonts_, "(א)").pixels == painted(*fonts_, "(\u202dא\u202c)").pixels);
    // Arabic letters are joined.
    QVERIFY(advanceOf(*fonts_, "سلام") < 0.9 * (advanceOf(*fonts_, "س") + advanceOf(*fonts_, "ل") +
                                                advanceOf(*fonts_, "ا") + advanceOf(*fonts_, "م")));
}

void PictureTextTest::marksAreWrittenOntoTheirLetters()
{
    QVERIFY(std::abs(advanceOf(*fonts_, "e\u0301") - advanceOf(*fonts_, "e")) < 0.1);
    QVERIFY(inkOf(painted(*fonts_, "e\u0301")).top < inkOf(painted(*fonts_, "e")).top - 2);
    // Signs without a shape take no room.
    QCOMPARE(advanceOf(*fonts_, "a\u200bb\u200e"), advanceOf(*fonts_, "ab"));
}

void PictureTextTest::rimsSurroundLetters()
{
    const TextRim rim{6, {200, 0, 0}};
    Picture with = painted(*fonts_, "o", {.size = 24}, 1, rim), without = painted(*fonts_, "o");
    const InkedPart letter = inkOf(without);
    // What the letter covers wholly stays; three pixels around it there is the rim.
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        if (without.pixels[i][0] == 0)
            QCOMPARE(with.pixels[i], without.pixels[i]);
    int left = width, right = -1;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (pixelsOf(with).row(y)[x][1] < 250) {
                left = std::min(left, x);
                right = std::max(right, x);
            }
    QVERIFY(std::abs(letter.left - 3 - left) <= 1 && std::abs(letter.right + 3 - right) <= 1);
    // A rim of half the opacity is that wherever rims cross.
    const Picture crossing = painted(*fonts_, "ooooo", {.size = 24}, 1, {6, {0, 0, 255, 128}});
    const Picture letters = painted(*fonts_, "ooooo");
    for (std::size_t i = 0; i < crossing.pixels.size(); ++i)
        if (letters.pixels[i][0] == 255)
            QVERIFY(crossing.pixels[i][0] >= 127);
}

/// Long, empty, beyond the picture, with signs of control.
void PictureTextTest::anyTextCanBePainted()
{
    QVERIFY(inkOf(painted(*fonts_, "")).sum == 0);
    QVERIFY(inkOf(painted(*fonts_, std::string(5000, 'W'))).sum > 100);
    QVERIFY(painted(*fonts_, "a\nb\tc").pixels == painted(*fonts_, "a b c").pixels);
    Picture nothing;
    paintText(PixelCanvas(pixelsOf(nothing), 1), *fonts_, "text", {}, {0, 0}, {}, {});
    Picture small{4, 4, std::vector<std::array<std::uint8_t, 4>>(16, {1, 2, 3, 4})};
    paintText(PixelCanvas(pixelsOf(small), 1), *fonts_, "text", {.size = 12}, {1e6, -1e6}, {}, {3, {}});
    QVERIFY(std::ranges::all_of(small.pixels, [](const auto& pixel) { return pixel[0] == 1 && pixel[3] == 4; }));
}

void PictureTextTest::threadsShareFonts()
{
    const auto shared = fonts();
    const Picture expected = painted(*fonts_, "Temperature θ क");
    std::array<bool, 4> same{};
    {
        std::vector<std::jthread> threads;
        for (bool& one : same)
            threads.emplace_back([&] {
                one = true;
                for (int round = 0; round < 5; ++round)
                    one = one && painted(*shared, "Temperature θ क").pixels == expected.pixels &&
                          advanceOf(*shared, "x", {.size = 10.0 + round}) > 0;
            });
    }
    QVERIFY(std::ranges::all_of(same, std::identity()));
}

QTEST_GUILESS_MAIN(PictureTextTest)
#include "text_test.moc"
