// SPDX-License-Identifier: GPL-3.0-or-later
// What lies between two transfer functions, or two lists of isosurfaces.
#include "core/view/blending.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace tetra;

namespace {

constexpr int rounds = 200;

TransferFunction randomFunction(std::mt19937& random, std::size_t points)
{
    std::uniform_real_distribution<double> value(-5, 5), distance(0.1, 4);
    std::uniform_real_distribution<float> channel(0, 1);
    TransferFunction function;
    function.unitDistance = distance(random);
    for (std::size_t i = 0; i < points; ++i) {
        function.colours.push_back({value(random), {channel(random), channel(random), channel(random)}});
        function.opacities.push_back({value(random), 0.99F * channel(random)});
    }
    std::ranges::sort(function.colours, {}, &ColourPoint::value);
    std::ranges::sort(function.opacities, {}, &OpacityPoint::value);
    for (std::size_t i = 2; i + 1 < points; i += 3) { // steps
        function.colours[i].value = function.colours[i - 1].value;
        function.opacities[i].value = function.opacities[i - 1].value;
    }
    return function;
}

std::vector<Isovalue> randomIsovalues(std::mt19937& random)
{
    std::uniform_real_distribution<double> value(-5, 5);
    std::uniform_real_distribution<float> channel(0.01F, 1);
    std::vector<Isovalue> isovalues;
    for (unsigned count = random() % 5; count > 0; --count)
        isovalues.push_back(
            {value(random), channel(random), channel(random), channel(random), channel(random), random() % 4 != 0});
    return isovalues;
}

double difference(const TransferSample& first, const TransferSample& second)
{
    double largest = std::abs(first.extinction - second.extinction);
    for (std::size_t i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(first.colour[i] - second.colour[i]));
    return largest;
}

/// Opacity of the surface if it is seen.
double seen(const Isovalue& isovalue)
{
    return isovalue.visible ? isovalue.opacity : 0;
}

} // namespace

class BlendingTest : public QObject {
    Q_OBJECT
private slots:
    void endsAreExact();
    void everyFunctionBetweenIsGood();
    void aFunctionBetweenIsTheMeanOfBoth();
    void functionsChangeContinuously();
    void isovaluesChangeContinuously();
    void hiddenSurfacesFadeIn();
};

void BlendingTest::endsAreExact()
{
    std::mt19937 random(1);
    for (int round = 0; round < rounds; ++round) {
        const auto first = randomFunction(random, 2 + random() % 6);
        const auto second = randomFunction(random, 2 + random() % 6);
        QVERIFY(blended(first, second, 0) == first && blended(first, second, 1) == second);
        QVERIFY(blended(first, first, 0.3) == first);
        const auto one = randomIsovalues(random);
        const auto other = randomIsovalues(random);
        QVERIFY(blended(one, other, 0) == one && blended(one, other, 1) == other && blended(one, one, 0.7) == one);
    }
}

void BlendingTest::everyFunctionBetweenIsGood()
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < rounds; ++round) {
        const auto first = randomFunction(random, 2 + random() % 7);
        const auto second = randomFunction(random, 2 + random() % 7);
        const Status good = checkTransferFunction(blended(first, second, unit(random)));
        QVERIFY2(good, good ? "" : good.error().text().c_str());
    }
}

void BlendingTest::aFunctionBetweenIsTheMeanOfBoth()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1), value(-6, 6);
    for (int round = 0; round < rounds; ++round) {
        const auto first = randomFunction(random, 3);
        const auto second = randomFunction(random, 6);
        const double part = unit(random);
        const auto mean = blended(first, second, part);
        const double place = value(random);
        const TransferSample one = evaluate(first, place), other = evaluate(second, place);
        TransferSample expected;
        expected.extinction = std::lerp(one.extinction, other.extinction, part);
        for (std::size_t i = 0; i < 3; ++i)
            expected.colour[i] = std::lerp(one.colour[i], other.colour[i], part);
        const double scale = 1 + one.extinction + other.extinction;
        QVERIFY(difference(evaluate(mean, place), expected) < 1e-3 * scale);
    }
}

void BlendingTest::functionsChangeContinuously()
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < rounds; ++round) {
        const auto first = randomFunction(random, 4);
        const auto second = randomFunction(random, 4);
        const double part = unit(random);
        const auto before = blended(first, second, part);
        const auto after = blended(first, second, std::min(part + 1e-7, 1.0));
        QVERIFY(std::abs(before.unitDistance - after.unitDistance) < 1e-4);
        for (std::size_t i = 0; i < before.opacities.size(); ++i) {
            QVERIFY(std::abs(before.colours[i].value - after.colours[i].value) < 1e-4);
            QVERIFY(std::abs(before.opacities[i].value - after.opacities[i].value) < 1e-4);
            QVERIFY(std::abs(before.opacities[i].opacity - after.opacities[i].opacity) < 1e-4);
        }
    }
}

void BlendingTest::isovaluesChangeContinuously()
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.001, 0.999);
    for (int round = 0; round < rounds; ++round) {
        const auto first = randomIsovalues(random);
        const auto second = randomIsovalues(random);
        for (const double part : {1e-9, unit(random), 1 - 1e-9}) {
            const auto before = blended(first, second, part);
            const auto after = blended(first, second, part + 1e-9);
            for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
                QVERIFY(std::abs(seen(before[i]) - seen(after[i])) < 3e-3);
                QVERIFY(seen(before[i]) < 3e-3 || std::abs(before[i].value - after[i].value) < 1e-4);
            }
            for (std::size_t i = after.size(); i < before.size(); ++i)
                QVERIFY(seen(before[i]) < 3e-3);
        }
    }
}

void BlendingTest::hiddenSurfacesFadeIn()
{
    const std::vector<Isovalue> first{{.value = 1, .opacity = 0.8F, .visible = false}};
    const std::vector<Isovalue> second{{.value = 3, .opacity = 0.8F}, {.value = 5, .opacity = 0.4F}};
    const auto middle = blended(first, second, 0.5);
    QCOMPARE(middle.size(), std::size_t(2));
    QCOMPARE(middle[0].value, 3.0);
    QCOMPARE(middle[0].opacity, 0.4F);
    QCOMPARE(middle[1].value, 5.0);
    QCOMPARE(middle[1].opacity, 0.2F);
    QVERIFY(middle[0].visible && middle[1].visible);
}

QTEST_GUILESS_MAIN(BlendingTest)
#include "blending_test.moc"
