// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of transfer functions: whatever is done to one, it stays one, and looks as promised.
#include <tan/transfer.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace tetra;

namespace {

constexpr TransferLimits limits{-10, 10};

TransferFunction randomFunction(std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.unitDistance = 0.1 + unit(random);
    const int count = static_cast<int>(random() % 8);
    for (int i = 0; i < count; ++i) {
        const double value = std::round(20 * unit(random)) - 10;
        if (std::ranges::count(function.points, value, &TransferPoint::value) < 2)
            function.points.push_back({value, {unit(random), unit(random), unit(random)}, 0.99F * unit(random)});
    }
    std::ranges::stable_sort(function.points, {}, &TransferPoint::value);
    return function;
}

double largestDifference(const TransferFunction& first, const TransferFunction& second)
{
    double largest = 0;
    for (double value = -12.05; value < 12; value += 0.1) {
        const TransferSample a = evaluate(first, value);
        const TransferSample b = evaluate(second, value);
        largest = std::max(largest, std::abs(a.extinction - b.extinction));
        if (!first.points.empty() && !second.points.empty())
            for (std::size_t channel = 0; channel < 3; ++channel)
                largest = std::max(largest, std::abs(a.colour[channel] - b.colour[channel]));
    }
    return largest;
}

/// One of all edits, with numbers that need not make sense.
TransferFunction randomEdit(const TransferFunction& function, std::mt19937& random)
{
    std::uniform_real_distribution<double> number(-15, 15);
    const std::size_t point = random() % (function.points.size() + 2);
    switch (random() % 9) {
    case 0: {
        const auto added = withPoint(function, std::round(number(random)));
        return added ? added->function : function;
    }
    case 1: return withoutPoint(function, point);
    case 2: return withMovedPoint(function, point, number(random), number(random) / 10, limits);
    case 3: return withColour(function, point, {0.5F, 0, 1});
    case 4: return withStep(function, point).function;
    case 5: return withoutStep(function, point).function;
    case 6: return withScaledOpacity(function, number(random));
    case 7: return mirrored(function, limits);
    default: return spreadOver(function, limits);
    }
}

} // namespace

class TransferEditingTest : public QObject {
    Q_OBJECT

private slots:
    void pointsThatRoundingBringsTogetherAreAStep()
    {
        TransferFunction function;
        for (const double value : {1e-17, 2e-17, 3e-17, 4e-17, 5.0})
            function.points.push_back({value, {1, 0, 0}, static_cast<float>(value > 3.5e-17 ? 0.5 : 0.25)});
        const TransferFunction mirror = mirrored(function, {0, 10});
        QVERIFY(checkTransferFunction(mirror).ok());
        QCOMPARE(mirror.points.size(), std::size_t(3));
        QCOMPARE(mirror.points[1].opacity, 0.5f);
        QCOMPARE(mirror.points[2].opacity, 0.25f);
        const TransferFunction spread = spreadOver(function, {1, 3});
        QVERIFY(checkTransferFunction(spread).ok());
        QCOMPARE(spread.points.size(), std::size_t(3));
    }

    void anyEditsGiveATransferFunction()
    {
        std::mt19937 random(1);
        for (int round = 0; round < 300; ++round) {
            TransferFunction function = randomFunction(random);
            for (int edit = 0; edit < 40; ++edit) {
                function = randomEdit(function, random);
                const Status status = checkTransferFunction(function);
                QVERIFY2(status.ok(), status.ok() ? "" : status.error().text().c_str());
            }
        }
    }

    void anAddedPointChangesNothingThatIsSeen()
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> value(-12, 12);
        for (int round = 0; round < 200; ++round) {
            const TransferFunction function = randomFunction(random);
            const auto added = withPoint(function, value(random));
            QVERIFY(added);
            QCOMPARE(added->function.points.size(), function.points.size() + 1);
            QVERIFY(largestDifference(function, added->function) < 1e-4);
        }
        QVERIFY(!withPoint({}, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!withPoint({{{1, {}, 0}, {1, {}, 1}}, 1}, 1));
    }

    void aPointStopsBeforeItsNeighbours()
    {
        const TransferFunction function{{{0, {}, 0}, {4, {}, 0.5F}, {8, {}, 1}}, 1};
        const TransferFunction far = withMovedPoint(function, 1, 100, 0.25, limits);
        QVERIFY(far.points[1].value < 8 && far.points[1].value > 7.99);
        QCOMPARE(far.points[1].opacity, 0.25F);
        const TransferFunction low = withMovedPoint(function, 0, -100, -3, limits);
        QCOMPARE(low.points[0].value, limits.least);
        QCOMPARE(low.points[0].opacity, 0.0F);
        QCOMPARE(withMovedPoint(function, 7, 1, 1, limits), function);
    }

    void bothSidesOfAStepMove()
    {
        const TransferFunction function{{{0, {}, 0}, {4, {}, 0.5F}, {8, {}, 1}}, 1};
        const EditedTransfer step = withStep(function, 1);
        QVERIFY(isOnStep(step.function, 1) && isOnStep(step.function, 2) && !isOnStep(step.function, 0));
        const TransferFunction moved = withMovedPoint(step.function, 2, 5, 0.75, limits);
        QCOMPARE(moved.points[1].value, 5.0);
        QCOMPARE(moved.points[2].value, 5.0);
        QCOMPARE(moved.points[1].opacity, 0.5F);
        QCOMPARE(moved.points[2].opacity, 0.75F);
        QCOMPARE(withoutStep(step.function, 2).function, function);
        QCOMPARE(withStep(step.function, 2).function, step.function);
    }

    void mirroringTwiceIsNothing()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 100; ++round) {
            const TransferFunction function = randomFunction(random);
            QCOMPARE(mirrored(mirrored(function, limits), limits), function);
            const TransferFunction once = mirrored(function, limits);
            for (double value = -9.95; value < 10; value += 0.1) // at no step
                QVERIFY(std::abs(evaluate(once, -value).extinction - evaluate(function, value).extinction) < 1e-9);
        }
    }

    void opacitiesAreScaled()
    {
        const TransferFunction function{{{0, {}, 0.25F}, {4, {}, 0.75F}}, 1};
        const TransferFunction twice = withScaledOpacity(function, 2);
        QCOMPARE(twice.points[0].opacity, 0.5F);
        QCOMPARE(twice.points[1].opacity, 1.0F);
        QCOMPARE(withScaledOpacity(function, -1), function);
    }

    void pointsAreSpreadOverTheLimits()
    {
        const TransferFunction function{{{1, {}, 0}, {2, {}, 1}, {2, {}, 0}, {5, {}, 1}}, 1};
        const TransferFunction spread = spreadOver(function, limits);
        QCOMPARE(spread.points.front().value, -10.0);
        QCOMPARE(spread.points.back().value, 10.0);
        QCOMPARE(spread.points[1].value, -5.0);
        QVERIFY(isOnStep(spread, 1));
    }
};

QTEST_APPLESS_MAIN(TransferEditingTest)
#include "transfer_editing_test.moc"
