// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps: whole, even in lightness, and put on a function without a change of its opacities.
#include <tan/transfer.h>

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace tetra;

namespace {

/// Of CIELAB, from sRGB.
double lightness(const std::array<float, 3>& colour)
{
    const auto linear = [](double channel) {
        return channel > 0.04045 ? std::pow((channel + 0.055) / 1.055, 2.4) : channel / 12.92;
    };
    return 116 * std::cbrt(0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2])) - 16;
}

const ColourMap& mapNamed(const std::string& id)
{
    return *std::ranges::find(colourMaps(), id, &ColourMap::id);
}

TransferFunction randomFunction(std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.unitDistance = 0.5 + double(unit(random));
    double value = -1;
    for (std::size_t point = random() % 8; point > 0; --point) {
        value += double(unit(random));
        for (auto sides = random() % 4 == 0 ? 2 : 1; sides > 0; --sides) {
            function.colours.push_back({value + 0.1, {unit(random), unit(random), unit(random)}});
            function.opacities.push_back({value, unit(random)});
        }
    }
    return function;
}

} // namespace

class ColourMapTest : public QObject {
    Q_OBJECT

private slots:
    void mapsAreWhole();
    void coloursAreThePublishedOnes_data();
    void coloursAreThePublishedOnes();
    void categoriesAreSteps();
    void lightnessRises_data();
    void lightnessRises();
    void opacitiesStay();
    void aRangeThatIsNoneChangesNothing();
};

void ColourMapTest::mapsAreWhole()
{
    QCOMPARE(colourMaps().size(), std::size_t(9));
    for (const ColourMap& map : colourMaps()) {
        QCOMPARE(map.nodes.front().share, 0.0);
        QCOMPARE(map.nodes.back().share, 1.0);
        for (std::size_t node = 1; node < map.nodes.size(); ++node)
            QVERIFY(map.nodes[node - 1].share <= map.nodes[node].share);
        for (std::size_t node = 0; node < map.nodes.size(); ++node) // of two of one share the second one counts
            if (node + 1 == map.nodes.size() || map.nodes[node].share < map.nodes[node + 1].share)
                QCOMPARE(colourAt(map, map.nodes[node].share), map.nodes[node].colour);
    }
}

void ColourMapTest::coloursAreThePublishedOnes_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("number");
    QTest::addColumn<std::array<float, 3>>("colour");
    const auto row = [](const char* id, int number, std::array<float, 3> colour) {
        QTest::addRow("%s %d", id, number) << id << number << colour;
    };
    // Of the 256 that the authors published, some that lie between the nodes.
    row("plasma", 8, {0.132381F, 0.022258F, 0.563250F});
    row("plasma", 120, {0.768090F, 0.244817F, 0.498465F});
    row("plasma", 201, {0.985301F, 0.635330F, 0.221265F});
    row("turbo", 20, {0.26074F, 0.29568F, 0.71162F});
    row("turbo", 100, {0.24797F, 0.96423F, 0.54303F});
    row("turbo", 221, {0.83926F, 0.20654F, 0.02305F});
}

void ColourMapTest::coloursAreThePublishedOnes()
{
    QFETCH(QString, id);
    QFETCH(int, number);
    using Colour = std::array<float, 3>;
    QFETCH(Colour, colour);
    const Colour is = colourAt(mapNamed(id.toStdString()), number / 255.0);
    for (std::size_t channel = 0; channel < 3; ++channel)
        QVERIFY2(std::abs(is[channel] - colour[channel]) < 0.012F, qPrintable(QString::number(double(is[channel]))));
}

/// Each of seven equal parts has one colour, up to its edge.
void ColourMapTest::categoriesAreSteps()
{
    const ColourMap& map = mapNamed("categories");
    for (int part = 0; part < 7; ++part) {
        const auto colour = colourAt(map, (part + 0.5) / 7);
        for (const double within : {0.001, 0.25, 0.999})
            QCOMPARE(colourAt(map, (part + within) / 7), colour);
        if (part > 0)
            QVERIFY(colourAt(map, (part - 0.5) / 7) != colour);
    }
    const TransferFunction function = withColourMap({}, map, {0, 7});
    QVERIFY(checkTransferFunction(function));
    QCOMPARE(function.colours.size(), std::size_t(14));
}

void ColourMapTest::lightnessRises_data()
{
    QTest::addColumn<QString>("id");
    for (const char* id : {"viridis", "cividis", "inferno", "plasma", "grey"})
        QTest::newRow(id) << id;
}

void ColourMapTest::lightnessRises()
{
    QFETCH(QString, id);
    const ColourMap* map = &mapNamed(id.toStdString());
    double before = -20;
    for (int step = 0; step <= 100; ++step) {
        const double now = lightness(colourAt(*map, step / 100.0));
        QVERIFY2(now > before, qPrintable(QString("at %1 %: %2 after %3").arg(step).arg(now).arg(before)));
        before = now;
    }
}

void ColourMapTest::opacitiesStay()
{
    std::mt19937 random(4);
    for (int round = 0; round < 200; ++round) {
        const TransferFunction function = randomFunction(random);
        const TransferLimits limits{-0.5, 0.5 + double(random() % 5)};
        for (const ColourMap& map : colourMaps()) {
            const TransferFunction coloured = withColourMap(function, map, limits);
            QVERIFY(checkTransferFunction(coloured));
            for (double value = -2; value < 7; value += 0.037) {
                const TransferSample before = evaluate(function, value), after = evaluate(coloured, value);
                const auto through = [&](double extinction) { return std::exp(-extinction * function.unitDistance); };
                QVERIFY(std::abs(through(before.extinction) - through(after.extinction)) <= 1e-6);
                const auto expected = colourAt(map, (value - limits.least) / (limits.largest - limits.least));
                for (std::size_t channel = 0; channel < 3; ++channel)
                    QVERIFY(std::abs(after.colour[channel] - double(expected[channel])) <= 1e-6);
            }
        }
    }
}

void ColourMapTest::aRangeThatIsNoneChangesNothing()
{
    std::mt19937 random(9);
    const TransferFunction function = randomFunction(random);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const TransferLimits& limits :
         {TransferLimits{1, 1}, TransferLimits{2, 1}, TransferLimits{0, infinity}, TransferLimits{std::nan(""), 1}})
        QCOMPARE(withColourMap(function, colourMaps().front(), limits), function);
}

QTEST_APPLESS_MAIN(ColourMapTest)
#include "colour_map_test.moc"
