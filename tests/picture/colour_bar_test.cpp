// SPDX-License-Identifier: GPL-3.0-or-later
// The colour bar as a measure: values stand where they belong, on linear and logarithmic axes, neighbouring ticks have
// different texts, and a value can be read back from its colour within a tick. Places are worked out here, by closed
// forms; colours by the map's own straight pieces.
#include "core/picture/annotations/annotation_layout.h"
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/annotations/axis_ticks.h"
#include "core/picture/annotations/bar_axis.h"
#include "core/picture/annotations/placed_text.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

using namespace tetra;

namespace {

const TextMeasure measure{[](const std::string& text) { return 7.0 * static_cast<double>(text.size()); },
                          [](const std::string& text) { return 8.0 * static_cast<double>(text.size()); }, 15};

double numberOf(const std::string& text)
{
    double number = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

AnnotationContent contentOver(double least, double largest, const TransferFunction& function)
{
    AnnotationContent content;
    for (AnnotationPlace& place : content.state.places)
        place.shown = false;
    content.state[AnnotationKind::ColourBar].shown = true;
    content.range = {least, largest};
    content.transfer = function;
    content.background = {1, 1, 1};
    return content;
}

/// As ParaView writes a map whose colours go with the logarithm of the value.
TransferFunction logarithmicMap(const ColourMap& map, double least, double largest)
{
    QString points;
    for (const ColourMapNode& node : map.nodes) {
        points += points.isEmpty() ? "" : ", ";
        points += QString::number(least * std::pow(largest / least, node.share), 'g', 17);
        for (const float channel : node.colour)
            points += ", " + QString::number(channel, 'g', 9);
    }
    const QString file =
        "[{\"Name\": \"map\", \"ColorSpace\": \"RGB\", \"UseLogScale\": 1, \"RGBPoints\": [" + points + "]}]";
    auto imported = importTransferFunctions(file.toStdString(), {});
    if (!imported)
        qFatal("%s", imported.error().text().c_str());
    return imported->front().function;
}

TransferFunction linearMap(const ColourMap& map, double least, double largest)
{
    return withColourMap({}, map, {least, largest});
}

/// Linear between the map's nodes.
std::array<double, 3> colourOf(const ColourMap& map, double share)
{
    std::size_t above = 1;
    while (above + 1 < map.nodes.size() && map.nodes[above].share < share)
        ++above;
    const ColourMapNode &from = map.nodes[above - 1], &to = map.nodes[above];
    std::array<double, 3> colour{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        colour[channel] = std::lerp(double(from.colour[channel]), double(to.colour[channel]),
                                    (share - from.share) / (to.share - from.share));
    return colour;
}

ColourBarLayout barOf(const AnnotationContent& content, const Size& picture = {800, 600})
{
    return layOutAnnotations(content, picture, measure).colourBar.value();
}

} // namespace

class ColourBarTest : public QObject {
    Q_OBJECT
private slots:
    void endsCanBeFixed()
    {
        const TransferFunction function = linearMap(colourMaps()[0], 0, 10);
        AnnotationContent content = contentOver(0, 10, function);
        content.isovalues = std::vector<Isovalue>{{.value = 5}, {.value = -1}, {.value = 25}};
        content.state.barEnds = BarEnds{-20, 20};
        const ColourBarLayout bar = barOf(content);
        QCOMPARE(bar.ticks.front().label.text, std::string("-20"));
        QCOMPARE(bar.ticks.back().label.text, std::string("20"));
        QVERIFY(std::abs(bar.ticks.front().position - bar.bar.bottom()) < 1e-9);
        QVERIFY(std::abs(bar.isovalues[0].position - (bar.bar.bottom() - bar.bar.height * 25 / 40)) < 1e-9);
        QVERIFY(!bar.isovalues[0].beyond && !bar.isovalues[1].beyond && bar.isovalues[2].beyond);
        content.state.barEnds.reset();
        QVERIFY(barOf(content).isovalues[1].beyond && !barOf(content).isovalues[0].beyond);
        QVERIFY(!isUsable({1, 1}) && !isUsable({2, 1}) && !isUsable({0, std::numeric_limits<double>::infinity()}));
    }

    /// Over decades, of which a linear axis leaves all but the last hardly any room.
    void theAxisIsLogarithmicWhereTheMapIs()
    {
        std::vector<ColourMap> maps(colourMaps().begin(), colourMaps().end());
        // Steps say nothing of what lies between them.
        std::erase_if(maps, [](const ColourMap& map) { return map.id == "categories"; });
        for (const ColourMap& map : maps)
            for (const double least : {1e-7, 0.02, 3.0, 4e5})
                for (const double decades : {2.5, 4.0, 6.0}) {
                    const double largest = least * std::pow(10, decades);
                    const QByteArray name = QByteArray::fromStdString(map.id) + " " + QByteArray::number(decades);
                    const TransferFunction linear = linearMap(map, least, largest);
                    QVERIFY2(!followsLogarithm(linear, {least, largest}), name);
                    QVERIFY2(!followsLogarithm(logarithmicMap(map, least, largest), {-least, largest}), name);
                    QVERIFY2(followsLogarithm(logarithmicMap(map, least, largest), {least, largest}),
                             name + " from " + QByteArray::number(least));
                    const ColourBarLayout bar = barOf(contentOver(least, largest, logarithmicMap(map, least, largest)));
                    QVERIFY2(bar.ticks.size() > 1, name);
                    for (const AxisMark& tick : bar.ticks) {
                        if (tick.label.text.empty())
                            continue;
                        const double value = numberOf(tick.label.text);
                        const double share = std::log10(value / least) / decades;
                        const double position = bar.bar.bottom() - share * bar.bar.height;
                        QVERIFY2(std::abs(tick.position - position) < 1e-6 * bar.bar.height, name);
                    }
                }
    }

    /// What is crowded at small values, but straight between points that are far apart, follows no logarithm; nor does
    /// what has one colour.
    void otherMapsStayLinear()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> channel(0, 1);
        for (int round = 0; round < 200; ++round) {
            TransferFunction function;
            for (int point = 0; point <= 8; ++point)
                function.colours.push_back({1 + 9999 * std::pow(point / 8.0, 1 + round % 4),
                                            {channel(random), channel(random), channel(random)}});
            QVERIFY(!followsLogarithm(function, {1, 10000}));
        }
        QVERIFY(!followsLogarithm({}, {1, 10000}));
        QVERIFY(!followsLogarithm({.colours = {{5, {1, 0, 0}}}}, {1, 10000}));
        QVERIFY(!followsLogarithm(logarithmicMap(colourMaps()[0], 1, 100), {0, 100}));
        QVERIFY(!followsLogarithm(logarithmicMap(colourMaps()[0], 1, 100), {7, 7}));
    }

    void neighbouringTicksDiffer()
    {
        std::mt19937 random(4);
        std::uniform_real_distribution<double> power(-30, 30), decades(0.01, 40);
        for (int round = 0; round < 2000; ++round) {
            const double least = std::pow(10, power(random));
            const BarAxis axis{{least, least * std::pow(10, decades(random))}, round % 4 != 0};
            const int most = 2 + static_cast<int>(random() % 8);
            const auto ticks = barTicks(axis, most);
            const auto texts = barTickTexts(axis, ticks);
            QVERIFY(std::ssize(ticks) <= most && texts.size() == ticks.size());
            QVERIFY(std::ranges::is_sorted(ticks) &&
                    std::ranges::all_of(ticks, [&](double tick) { return axis.contains(tick); }));
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                QVERIFY2(i == 0 || texts[i] != texts[i - 1], texts[i].c_str());
                const double read = numberOf(texts[i]);
                const double apart = i > 0              ? ticks[i] - ticks[i - 1]
                                     : ticks.size() > 1 ? ticks[1] - ticks[0]
                                                        : ticks[i];
                QVERIFY2(std::abs(read - ticks[i]) <= 0.01 * apart, texts[i].c_str());
            }
        }
        QCOMPARE(barTicks({{1, 1000}, true}, 4), (std::vector<double>{1, 10, 100, 1000}));
        QCOMPARE(barTicks({{0.5, 20}, true}, 9), (std::vector<double>{0.5, 1, 2, 5, 10, 20}));
        QCOMPARE(barTickTexts({{1e-5, 1}, true}, {1e-5, 0.001, 0.1}),
                 (std::vector<std::string>{"1e-05", "0.001", "0.1"}));
    }

    /// Of a model of logarithms the axis tells the values: where the bar has -3 it says 0.001.
    void logarithmsAreToldAsValues()
    {
        const BarAxis axis{.ends = {-8, 2}, .ofLogarithms = true};
        QCOMPARE(axis.shareOf(-3), 0.5);
        const auto ticks = barTicks(axis, 11);
        QCOMPARE(ticks.size(), std::size_t(11));
        const auto texts = barTickTexts(axis, ticks);
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            QVERIFY(std::abs(ticks[i] - (-8.0 + static_cast<double>(i))) < 1e-12);
            QVERIFY2(std::abs(std::log10(numberOf(texts[i])) - ticks[i]) < 1e-12, texts[i].c_str());
        }
        QVERIFY(std::abs(numberOf(barValueText(axis, std::log10(3e-5), ticks)) / 3e-5 - 1) < 1e-3);
        // Of less than a decade round values, too.
        const BarAxis narrow{.ends = {std::log10(2.0), std::log10(4.0)}, .ofLogarithms = true};
        for (const std::string& text : barTickTexts(narrow, barTicks(narrow, 5)))
            QVERIFY2(text.size() <= 4, text.c_str());
        AnnotationContent content;
        content.range = {-8, 2};
        content.logarithms = true;
        QVERIFY(barAxisOf(content).ofLogarithms && !barAxisOf(content).logarithmic);
    }

    /// The axis and its inverse, against each other and against a power.
    void sharesAndValuesAreInverse()
    {
        for (const bool logarithmic : {false, true}) {
            const BarAxis axis{{0.25, 4000}, logarithmic};
            for (double share = 0; share <= 1; share += 0.03125) {
                const double value = logarithmic ? 0.25 * std::pow(16000, share) : 0.25 + share * 3999.75;
                QVERIFY(std::abs(axis.valueAt(share) - value) <= 1e-12 * value);
                QVERIFY(std::abs(axis.shareOf(value) - share) < 1e-12);
            }
            QVERIFY(axis.shareOf(-1) < 0 && axis.shareOf(5000) > 1);
        }
    }

    void valuesAreReadBackFromTheirColours_data()
    {
        QTest::addColumn<bool>("logarithmic");
        QTest::newRow("linear") << false;
        QTest::newRow("logarithmic") << true;
    }
    /// From the painted bar: the row that has the colour, and its value by the nearest ticks' places and texts.
    void valuesAreReadBackFromTheirColours()
    {
        QFETCH(bool, logarithmic);
        const double least = 2, largest = 20000;
        const ColourMap& map = colourMaps()[0]; // of which no two places look alike
        const auto fonts = openFonts();
        QVERIFY(fonts.ok());
        AnnotationContent content = contentOver(
            least, largest, logarithmic ? logarithmicMap(map, least, largest) : linearMap(map, least, largest));
        content.fonts = *fonts;
        Picture picture{500, 400, std::vector<std::array<std::uint8_t, 4>>(200'000, {255, 255, 255, 255})};
        QVERIFY(paintAnnotations(pixelsOf(picture), content, 1).ok());
        const ColourBarLayout bar = layOutAnnotations(content, {500, 400}, textMeasure(**fonts)).colourBar.value();
        struct Tick {
            double position, place; ///< the value, or its logarithm
        };
        std::vector<Tick> ticks;
        for (const AxisMark& mark : bar.ticks)
            if (!mark.label.text.empty()) {
                const double value = numberOf(mark.label.text);
                ticks.push_back({mark.position, logarithmic ? std::log(value) : value});
            }
        QVERIFY(ticks.size() > 2);
        const double tickDistance = std::abs(ticks[1].place - ticks[0].place);
        const double slope =
            (ticks.back().place - ticks.front().place) / (ticks.back().position - ticks.front().position);
        std::mt19937 random(8);
        std::uniform_real_distribution<double> anyShare(0.02, 0.98);
        for (int round = 0; round < 300; ++round) {
            const double share = anyShare(random);
            const auto [red, green, blue] = colourOf(map, share);
            int nearest = 0;
            double smallest = std::numeric_limits<double>::infinity();
            for (int row = static_cast<int>(bar.bar.top) + 2; row < static_cast<int>(bar.bar.bottom()) - 1; ++row) {
                const auto& there = pixelsOf(picture).row(row)[static_cast<int>(bar.bar.left) + 5];
                const double apart = std::abs(there[0] / 255.0 - red) + std::abs(there[1] / 255.0 - green) +
                                     std::abs(there[2] / 255.0 - blue);
                if (apart < smallest) {
                    smallest = apart;
                    nearest = row;
                }
            }
            QVERIFY2(smallest < 0.06, qPrintable(QString::number(smallest)));
            const double read = ticks.front().place + slope * (nearest + 0.5 - ticks.front().position);
            const double value =
                logarithmic ? std::log(least) + share * std::log(largest / least) : least + share * (largest - least);
            QVERIFY2(std::abs(read - value) < 0.25 * tickDistance,
                     qPrintable(QString("%1 for %2").arg(read).arg(value)));
        }
    }
};

QTEST_GUILESS_MAIN(ColourBarTest)
#include "colour_bar_test.moc"
