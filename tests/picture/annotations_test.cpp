// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations by values: round ticks, and places that never overlap or leave the picture.
#include "core/picture/annotations/annotation_layout.h"
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/annotations/annotation_parts.h"
#include "core/picture/annotations/axis_ticks.h"
#include "core/picture/annotations/picture_projection.h"

#include <QTest>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace tetra;

namespace {

double numberOf(const std::string& text)
{
    double number = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// Every character is as wide as any other.
double charactersIn(const std::string& text)
{
    return static_cast<double>(QString::fromStdString(text).size());
}

const TextMeasure measure{[](const std::string& text) { return 7 * charactersIn(text); },
                          [](const std::string& text) { return 8 * charactersIn(text); }, 15};

AnnotationContent fullContent()
{
    AnnotationContent content;
    for (AnnotationPlace& place : content.state.places)
        place.shown = true;
    content.range = {0.2, 4.98};
    content.transfer = transferFunctionFromPoints({{0.2, {0, 0, 1}, 0}, {4.98, {1, 0, 0}, 0.9F}}, 1);
    content.isovalues = std::vector<Isovalue>{{.value = 1}, {.value = 1.02}, {.value = 3}};
    content.field = "density";
    content.title = "bluntfin";
    content.accuracy = "Error 1 %";
    content.background = {1, 1, 1};
    return content;
}

/// All that is written or drawn, but for ticks without a label.
std::vector<Rectangle> labelsOf(const AnnotationLayout& layout)
{
    std::vector<Rectangle> labels;
    const auto add = [&labels](const PlacedText& text) {
        if (!text.text.empty())
            labels.push_back(text.place);
    };
    if (layout.colourBar) {
        add(layout.colourBar->field);
        for (const auto* marks : {&layout.colourBar->ticks, &layout.colourBar->isovalues})
            for (const AxisMark& mark : *marks)
                add(mark.label);
    }
    if (layout.axes)
        for (const AxisLayout& axis : layout.axes->axes)
            add(axis.label);
    if (layout.scaleBar)
        add(layout.scaleBar->label);
    for (const auto& text : {layout.title, layout.accuracy})
        if (text)
            add(*text);
    return labels;
}

int count(const AnnotationLayout& layout)
{
    return static_cast<int>(
        std::ranges::count_if(layout.places, [](const Rectangle& place) { return !place.isEmpty(); }));
}

/// Greater for a layout that has something more important, whatever else it lacks.
int importance(const AnnotationLayout& layout)
{
    constexpr std::array weights{16, 4, 8, 2, 1, 0}; // by kind
    int sum = 0;
    for (std::size_t i = 0; i < annotationCount; ++i)
        sum += layout.places[i].isEmpty() ? 0 : weights[i];
    return sum;
}

} // namespace

class AnnotationsTest : public QObject {
    Q_OBJECT
private slots:
    void numbersHaveTheSignsOfALanguage();
    void ticksAreRoundAndFew();
    void ticksOfBadRangesAreNone();
    void tickTextsTellTicksApart();
    void anIsovalueIsMorePreciseThanTheTicks();
    void oneUnitIsNotMany();
    void longTextsAreCutAtOnce();
    void lengthsAreRound();
    void everythingFitsInALargePicture();
    void nothingOverlapsOrLeavesThePicture();
    void whatHasNoRoomGoesByImportance();
    void theScaleBarIsAsLongAsItSays();
    void theBarTellsWhatThePictureFollows();
    void axesTurnWithTheCamera();
    void textsCanBeTyped();
    void aTypedNameHasRoomAndKeepsItsUnit();
    void numbersAreWrittenAsAskedFor();
};

void AnnotationsTest::ticksAreRoundAndFew()
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1), power(-12, 12);
    for (int round = 0; round < 2000; ++round) {
        const double scale = std::pow(10, power(random));
        const double least = scale * any(random);
        const double largest = least + scale * std::abs(any(random)) + 1e-3 * scale;
        const int most = 2 + static_cast<int>(random() % 12);
        const auto ticks = niceTicks(least, largest, most);
        QVERIFY(static_cast<int>(ticks.size()) <= most);
        QVERIFY(most < 3 || !ticks.empty());
        for (const double tick : ticks)
            QVERIFY(tick >= least && tick <= largest);
        for (std::size_t i = 1; i < ticks.size(); ++i) {
            const double step = ticks[i] - ticks[i - 1];
            const double digits = step / std::pow(10, std::floor(std::log10(step * (1 + 1e-6))));
            QVERIFY2(std::abs(digits - 1) < 1e-3 || std::abs(digits - 2) < 1e-3 || std::abs(digits - 5) < 1e-3,
                     qPrintable(QString::number(digits)));
        }
    }
    QCOMPARE(niceTicks(0, 255, 6), (std::vector<double>{0, 50, 100, 150, 200, 250}));
    QCOMPARE(niceTicks(-1, 1, 5), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
}

void AnnotationsTest::numbersHaveTheSignsOfALanguage()
{
    const NumberSigns german{.decimalPoint = ",", .minus = "−"};
    QCOMPARE(shortNumber(-1.25, german), std::string("−1,25"));
    QCOMPARE(ownText(1.5e-7, german), std::string("1,5e−07"));
    const NumberSigns arabic{
        .decimalPoint = "٫", .minus = "\u061c-", .plus = "\u061c+", .exponent = "أس", .zero = U'\u0660'};
    QCOMPARE(shortNumber(1809.2, arabic), std::string("١٨٠٩"));
    QCOMPARE(tickTexts({-0.5, 0, 0.5}, arabic), (std::vector<std::string>{"\u061c-٠٫٥", "٠٫٠", "٠٫٥"}));
    QCOMPARE(ownText(2e20, arabic), std::string("٢أس\u061c+٢٠"));
    // Digits of one to four bytes.
    QCOMPARE(withSigns("19", {.zero = U'\U0001e950'}), std::string("\U0001e951\U0001e959"));
    QCOMPARE(withSigns("19", {.zero = U'\u0966'}), std::string("१९"));
    AnnotationContent content = fullContent();
    content.state.barEnds = BarEnds{0, 1};
    content.language = {german, [](const Message& message) { return "<" + message.sentence() + ">"; }};
    const AnnotationLayout layout = layOutAnnotations(content, {1000, 700}, measure);
    QCOMPARE(layout.scaleBar->label.text, std::string("<%1 units at the target>"));
    QVERIFY(std::ranges::any_of(layout.colourBar->ticks,
                                [](const AxisMark& mark) { return mark.label.text.starts_with("0,"); }));
}

void AnnotationsTest::ticksOfBadRangesAreNone()
{
    const double infinity = std::numeric_limits<double>::infinity();
    QVERIFY(niceTicks(1, 1, 5).empty() && niceTicks(2, 1, 5).empty() && niceTicks(0, infinity, 5).empty());
    QVERIFY(niceTicks(0, std::nan(""), 5).empty() && niceTicks(0, 1, 0).empty());
    QVERIFY(niceTicks(1, 1 + 1e-15, 5).empty());
}

void AnnotationsTest::anIsovalueIsMorePreciseThanTheTicks()
{
    const auto among = [](double value, double least, double largest) {
        return numberAmong(value, niceTicks(least, largest, 6));
    };
    QCOMPARE(among(101325.22, 101325.0, 101325.4), std::string("101325.22"));
    QCOMPARE(among(1000030880, 1000020000, 1000040000), std::string("1.0000309e+09"));
    QCOMPARE(among(76.5, 0, 255), std::string("76.5"));
    QCOMPARE(among(128, 0, 255), std::string("128"));
    QCOMPARE(among(0.123456, 0, 1), std::string("0.1235"));
    QCOMPARE(among(0, -1, 1), std::string("0"));
    QCOMPARE(among(15000, 0, 30000), std::string("15000")); // as the ticks, 20000 and 25000
    QCOMPARE(among(17384.6, 0, 30000), std::string("17385"));
    QCOMPARE(numberAmong(1518.123, {}), std::string("1518"));
    // Whatever the scale: what is read back lies between the same ticks, a tenth of their distance off at most.
    for (const double offset : {0.0, 3.0, 1e3, -1e6})
        for (double scale = 1e-9; scale < 1e12; scale *= 7) {
            const double least = offset * scale, value = least + 0.377 * scale;
            const auto ticks = niceTicks(least, least + scale, 6);
            QVERIFY(ticks.size() > 1);
            const std::string text = numberAmong(value, ticks);
            QVERIFY2(std::abs(numberOf(text) - value) <= 0.1 * (ticks[1] - ticks[0]), text.c_str());
        }
}

void AnnotationsTest::tickTextsTellTicksApart()
{
    QCOMPARE(tickTexts({0, 0.5, 1}), (std::vector<std::string>{"0.0", "0.5", "1.0"}));
    QCOMPARE(tickTexts({0, 2e-7, 4e-7}), (std::vector<std::string>{"0", "2e-07", "4e-07"}));
    QCOMPARE(tickTexts({1.5}), (std::vector<std::string>{"1.5"}));
    QCOMPARE(tickTexts({1.5e7}), (std::vector<std::string>{"1.5e+07"}));
    QCOMPARE(tickTexts({1e7, 1.5e7}), (std::vector<std::string>{"1.0e+07", "1.5e+07"}));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-1, 1), power(-9, 9);
    for (int round = 0; round < 500; ++round) {
        const double scale = std::pow(10, power(random));
        const double least = scale * any(random);
        auto texts = tickTexts(niceTicks(least, least + scale, 6));
        const std::size_t before = texts.size();
        std::ranges::sort(texts);
        texts.erase(std::ranges::unique(texts).begin(), texts.end());
        QCOMPARE(texts.size(), before);
    }
}

/// Each measure takes as long as the text: there are few, and the ends of the text stay.
void AnnotationsTest::longTextsAreCutAtOnce()
{
    std::size_t characters = 0;
    const TextMeasure counting{[&](const std::string& text) {
                                   characters += text.size();
                                   return measure.width(text);
                               },
                               {},
                               16};
    const std::string text = "begin" + std::string(100'000, 'x') + "end";
    const PlacedText fitted = fittedText(text, 210, counting);
    QCOMPARE(charactersIn(fitted.text), 30.0);
    QVERIFY(fitted.text.starts_with("begin") && fitted.text.ends_with("end"));
    QVERIFY(fitted.text.find("…") != std::string::npos);
    QVERIFY2(characters < 200'000, std::to_string(characters).c_str());
    QCOMPARE(fittedText("short", 210, counting).text, std::string("short"));
    QCOMPARE(fittedText("abcdef", 28, counting).text, std::string("ab…f"));
    // Characters of several bytes stay whole.
    QCOMPARE(fittedText("Größenmaß", 35, measure).text, std::string("Gr…aß"));
    QCOMPARE(fittedText("温度温度温度", 28, measure).text, std::string("温度…度"));
}

void AnnotationsTest::lengthsAreRound()
{
    QCOMPARE(niceLength(1), 1.0);
    QCOMPARE(niceLength(7.3), 5.0);
    QCOMPARE(niceLength(4.9), 2.0);
    QCOMPARE(niceLength(0.0199), 0.01);
    QCOMPARE(niceLength(0), 0.0);
    QCOMPARE(niceLength(std::nan("")), 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> power(-20, 20);
    for (int round = 0; round < 500; ++round) {
        const double length = std::pow(10, power(random));
        QVERIFY(niceLength(length) <= length && niceLength(length) > 0.39 * length);
    }
}

void AnnotationsTest::everythingFitsInALargePicture()
{
    const AnnotationLayout layout = layOutAnnotations(fullContent(), {1000, 700}, measure);
    QCOMPARE(count(layout), 5);
    QCOMPARE(layout.title->text, std::string("bluntfin"));
    QVERIFY(layout.title->place.bottom() <= layout.accuracy->place.top);
    QVERIFY(layout.colourBar->ticks.size() >= 4);
    QCOMPARE(layout.colourBar->isovalues.size(), std::size_t(3));
}

void AnnotationsTest::nothingOverlapsOrLeavesThePicture()
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> side(20, 900), angle(-180, 180), height(-90, 90), value(0.2, 4.98);
    for (int round = 0; round < 3000; ++round) {
        AnnotationContent content = fullContent();
        for (AnnotationPlace& place : content.state.places)
            place = {random() % 4 != 0, static_cast<Corner>(random() % 4)};
        if (random() % 2 == 0)
            content.transfer.reset();
        for (Isovalue& isovalue : *content.isovalues)
            isovalue.value = value(random);
        content.title = std::string(random() % 60, 'm');
        content.camera = {.distance = 0.1 + std::abs(height(random)),
                          .azimuth = angle(random),
                          .elevation = height(random),
                          .perspective = random() % 2 == 0};
        const Size picture{side(random), side(random)};
        const AnnotationLayout layout = layOutAnnotations(content, picture, measure);
        const Rectangle whole{0, 0, picture.width, picture.height};
        for (std::size_t i = 0; i < annotationCount; ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!layout.places[i].intersects(layout.places[j]));
        const auto labels = labelsOf(layout);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(whole.contains(labels[i]));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!labels[i].intersects(labels[j]));
        }
    }
}

void AnnotationsTest::whatHasNoRoomGoesByImportance()
{
    AnnotationContent content = fullContent();
    QCOMPARE(count(layOutAnnotations(content, {40, 40}, measure)), 0);
    QCOMPARE(count(layOutAnnotations(content, {0, 0}, measure)), 0);
    int last = 0;
    for (double side = 40; side < 900; side += 5) { // more room is never worse
        const int now = importance(layOutAnnotations(content, {side, side}, measure));
        QVERIFY2(now >= last, qPrintable(QString("%1: %2 after %3").arg(side).arg(now).arg(last)));
        last = now;
    }
    QCOMPARE(last, 31);
    const AnnotationLayout small = layOutAnnotations(content, {150, 130}, measure);
    QVERIFY(small.colourBar && count(small) < 5);
}

void AnnotationsTest::theScaleBarIsAsLongAsItSays()
{
    AnnotationContent content = fullContent();
    for (const bool perspective : {false, true}) {
        content.camera = {.target = {1, 2, 3}, .distance = 40, .perspective = perspective};
        const Size picture{800, 600};
        const AnnotationLayout layout = layOutAnnotations(content, picture, measure);
        QVERIFY(layout.scaleBar);
        const PictureProjection projection(content.camera, picture);
        const auto from = projection.pixelOf(content.camera.target);
        const auto to = projection.pixelOf(content.camera.target + layout.scaleBar->length * projection.right());
        QVERIFY(std::abs((layout.scaleBar->to - layout.scaleBar->from).norm() - (*to - *from).norm()) < 1e-9);
        QCOMPARE(layout.scaleBar->label.text.find("target") != std::string::npos, perspective);
    }
}

void AnnotationsTest::oneUnitIsNotMany()
{
    AnnotationContent content = fullContent();
    std::set<std::string> texts;
    for (const bool perspective : {false, true})
        for (double distance = 1; distance < 20; distance *= 1.2) {
            content.camera = {.target = {1, 2, 3}, .distance = distance, .perspective = perspective};
            const AnnotationLayout layout = layOutAnnotations(content, {800, 600}, measure);
            if (layout.scaleBar && layout.scaleBar->length == 1)
                texts.insert(layout.scaleBar->label.text);
        }
    QCOMPARE(texts, (std::set<std::string>{"1 unit", "1 unit at the target"}));
}

void AnnotationsTest::theBarTellsWhatThePictureFollows()
{
    AnnotationContent content = fullContent();
    content.isovalues.reset();
    QVERIFY(layOutAnnotations(content, {800, 600}, measure).colourBar->isovalues.empty());
    content.isovalues = std::vector<Isovalue>{{.value = 2.5}};
    content.transfer.reset();
    const auto surfaces = layOutAnnotations(content, {800, 600}, measure).colourBar;
    QCOMPARE(surfaces->isovalues.front().label.text, std::string("2.5"));
    const double expected = surfaces->bar.bottom() - surfaces->bar.height * (2.5 - 0.2) / (4.98 - 0.2);
    QVERIFY(std::abs(surfaces->isovalues.front().position - expected) < 1e-9);
    content.isovalues->clear();
    QVERIFY(!layOutAnnotations(content, {800, 600}, measure).colourBar);
}

void AnnotationsTest::axesTurnWithTheCamera()
{
    AnnotationContent content = fullContent();
    content.camera = {.azimuth = 0, .elevation = 0};
    auto axes = layOutAnnotations(content, {800, 600}, measure).axes->axes;
    QVERIFY(axes[0].tip.x() > 20 && std::abs(axes[0].tip.y()) < 1e-9);
    QVERIFY(axes[2].tip.y() < -20 && axes[1].depth < -0.99);
    content.camera.azimuth = 90;
    axes = layOutAnnotations(content, {800, 600}, measure).axes->axes;
    QVERIFY(axes[1].tip.x() > 20 && axes[0].depth > 0.99);
    QCOMPARE(axes[0].label.text + axes[1].label.text + axes[2].label.text, std::string("xyz"));
    content.space = "LPS"; // what the letters say is what the axes lead to
    axes = layOutAnnotations(content, {800, 600}, measure).axes->axes;
    QCOMPARE(axes[0].label.text + axes[1].label.text + axes[2].label.text, std::string("LPS"));
    content.lengthUnit = "mm";
    QVERIFY(layOutAnnotations(content, {800, 600}, measure).scaleBar->label.text.ends_with(" mm at the target"));
}

void AnnotationsTest::textsCanBeTyped()
{
    AnnotationContent content = fullContent();
    const auto texts = [&] {
        const AnnotationLayout layout = layOutAnnotations(content, {1000, 700}, measure);
        return std::pair(layout.title->text, layout.colourBar->field.text);
    };
    QCOMPARE(texts(), std::pair(std::string("bluntfin"), std::string("density")));
    content.state.unit = "kg/m³";
    QCOMPARE(texts(), std::pair(std::string("bluntfin"), std::string("density (kg/m³)")));
    content.state.title = "Blunt fin";
    content.state.quantity = "Density of air";
    QCOMPARE(texts(), std::pair(std::string("Blunt fin"), std::string("Density of air (kg/m³)")));
    content.state.unit = {};
    QCOMPARE(texts().second, std::string("Density of air"));
    content.state.quantity = "two\nlines"; // of a session that somebody wrote
    QCOMPARE(texts().second, std::string("two\\nlines"));
}

/// Where there is too little of it, the name is cut and not the unit; in no picture does the bar go because of them.
void AnnotationsTest::aTypedNameHasRoomAndKeepsItsUnit()
{
    AnnotationContent content = fullContent();
    content.state.quantity = "The density of the air around it";
    const auto field = [&](const Size& picture) {
        const AnnotationLayout layout = layOutAnnotations(content, picture, measure);
        return layout.colourBar ? layout.colourBar->field.text : std::string("no bar");
    };
    QCOMPARE(field({1000, 700}), content.state.quantity);
    content.state.unit = "kg/m³";
    const std::string cut = field({400, 300});
    QVERIFY2(cut.starts_with("The") && cut.ends_with(" (kg/m³)") && cut.find("…") != std::string::npos, cut.c_str());
    content.state.quantity.clear();
    for (double width = 250; width < 1500; width += 50) {
        content.state = fullContent().state;
        const bool hasBar = field({width, 300}) != "no bar";
        content.state.quantity = std::string(200, 'w');
        content.state.unit = std::string(30, 'u');
        QCOMPARE(field({width, 300}) != "no bar", hasBar);
    }
}

void AnnotationsTest::numbersAreWrittenAsAskedFor()
{
    using Style = NumberFormat::Style;
    const auto text = [](double value, Style style, int decimals) {
        return formattedNumber(value, {style, decimals}, {});
    };
    QCOMPARE(text(1234.5678, Style::Plain, 0), std::string("1235"));
    QCOMPARE(text(1234.5678, Style::Plain, 2), std::string("1234.57"));
    QCOMPARE(text(12345678, Style::Plain, 1), std::string("12345678.0"));
    QCOMPARE(text(-0.004, Style::Plain, 2), std::string("0.00")); // no zero has a sign
    QCOMPARE(text(-0.004, Style::Powers, 1), std::string("-4.0e-03"));
    QCOMPARE(text(0, Style::Powers, 1), std::string("0.0e+00"));
    QCOMPARE(text(1e300, Style::Plain, 1), std::string("1.0e+300"));
    QCOMPARE(text(1234.5678, Style::Automatic, 2), ownText(1234.5678));
    QCOMPARE(formattedNumber(-1.5, {Style::Plain, 1}, {.decimalPoint = ",", .minus = "−"}), std::string("−1,5"));
    AnnotationContent content = fullContent();
    content.transfer.reset();
    content.state.numbers = {Style::Plain, 3};
    const AnnotationLayout layout = layOutAnnotations(content, {1000, 700}, measure);
    for (const auto* marks : {&layout.colourBar->ticks, &layout.colourBar->isovalues})
        for (const AxisMark& mark : *marks)
            QVERIFY(mark.label.text.empty() || mark.label.text.size() == 5);
    content.logarithms = true; // then the numbers are those of the data
    content.range = {1, 3};
    const auto texts = barTickTexts(barAxisOf(content), {2}, {}, content.state.numbers);
    QCOMPARE(texts, (std::vector<std::string>{"100.000"}));
}

QTEST_GUILESS_MAIN(AnnotationsTest)
#include "annotations_test.moc"
