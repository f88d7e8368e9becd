// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps: whole, even in lightness, and put on a function without a change of its opacities.
#include <tan/transfer.h>

#include <QTest>

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
    void lightnessRises_data();
    void lightnessRises();
    void opacitiesStay();
    void aRangeThatIsNoneChangesNothing();
};

void ColourMapTest::mapsAreWhole()
{
    QCOMPARE(colourMaps().size(), std::size_t(5));
    for (const ColourMap& map : colourMaps()) {
        QCOMPARE(map.nodes.front().share, 0.0);
        QCOMPARE(map.nodes.back().share, 1.0);
        for (std::size_t node = 1; node < map.nodes.size(); ++node)
            QVERIFY(map.nodes[node - 1].share < map.nodes[node].share);
        for (const ColourMapNode& node : map.nodes)
            QCOMPARE(colourAt(map, node.share), node.colour);
    }
}

void ColourMapTest::lightnessRises_data()
{
    QTest::addColumn<QString>("id");
    for (const char* id : {"viridis", "cividis", "inferno", "grey"})
        QTest::newRow(id) << id;
}

void ColourMapTest::lightnessRises()
{
    QFETCH(QString, id);
    const auto map = std::ranges::find(colourMaps(), id.toStdString(), &ColourMap::id);
    QVERIFY(map != colourMaps().end());
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
