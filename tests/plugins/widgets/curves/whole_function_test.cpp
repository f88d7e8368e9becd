// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of the whole function, and single points of a joined one: they look as promised, and give functions again.
#include "plugins/widgets/curves/whole_function.h"
#include "tests/plugins/widgets/curves/random_functions.h"

#include <QTest>

#include <limits>

using namespace tetra;

class WholeFunctionTest : public QObject {
    Q_OBJECT

private slots:
    void joiningChangesNothingThatIsSeen()
    {
        std::mt19937 random(1);
        for (int round = 0; round < 300; ++round) {
            const TransferFunction function = randomCurves(random);
            const JoinedFunction once = joined(function);
            QVERIFY(checkTransferFunction(separated(once)));
            QVERIFY(largestDifference(function, separated(once)) < 1e-6);
            QCOMPARE(joined(separated(once)), once);
            const JoinedFunction points = randomFunction(random);
            QCOMPARE(joined(separated(points)), points);
        }
    }

    void anyEditsGiveATransferFunction()
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> any(-15, 15);
        const auto number = [&] { return random() % 12 == 0 ? std::numeric_limits<double>::max() : any(random); };
        for (int round = 0; round < 300; ++round) {
            TransferFunction function = randomCurves(random);
            for (int edit = 0; edit < 40; ++edit) {
                switch (random() % 7) {
                case 0: function = shifted(function, number()); break;
                case 1: function = widened(function, number(), number()); break;
                case 2: function = spreadOver(function, {number(), number()}); break;
                case 3: function = mirrored(function, {number(), number()}); break;
                case 4: function = withScaledOpacity(function, number()); break;
                case 5: function = withUnitDistance(function, number()); break;
                default: function = withMask(function, {number(), number()});
                }
                const Status status = checkTransferFunction(function);
                QVERIFY2(status.ok(), status.ok() ? "" : status.error().text().c_str());
            }
        }
    }

    void theWholeIsShiftedAndWidened()
    {
        std::mt19937 random(11);
        for (int round = 0; round < 500; ++round) {
            const TransferFunction function = randomCurves(random);
            QCOMPARE(shifted(shifted(function, 3.5), -3.5), function);
            QCOMPARE(widened(widened(function, 1, 4), 1, 0.25), function);
            const TransferFunction higher = shifted(function, 2), wider = widened(function, 1, 2);
            for (double value = -12.97; value < 13; value += 0.04) {
                QVERIFY(std::abs(evaluate(higher, value + 2).extinction - evaluate(function, value).extinction) < 1e-6);
                QVERIFY(std::abs(evaluate(wider, 1 + 2 * (value - 1)).extinction -
                                 evaluate(function, value).extinction) < 1e-6);
            }
            QCOMPARE(shifted(function, std::nan("")).opacities.size(), function.opacities.size());
            QCOMPARE(widened(function, 0, 0), function);
        }
    }

    void mirroringTwiceIsNothing()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 100; ++round) {
            const TransferFunction function = randomCurves(random);
            const TransferFunction once = mirrored(function, randomLimits);
            QCOMPARE(mirrored(once, randomLimits), function);
            for (double value = -9.95; value < 10; value += 0.1) { // at no step
                QVERIFY(std::abs(evaluate(once, -value).extinction - evaluate(function, value).extinction) < 1e-9);
                const auto there = evaluateUnmasked(once, -value).colour,
                           here = evaluateUnmasked(function, value).colour;
                for (std::size_t channel = 0; channel < 3; ++channel)
                    QVERIFY(std::abs(there[channel] - here[channel]) < 1e-9);
            }
        }
        // A step in the middle stays there and changes its sides.
        const TransferFunction step{{}, {{0, 0.25F}, {0, 0.75F}}};
        QCOMPARE(mirrored(step, {-1, 1}).opacities, (std::vector<OpacityPoint>{{0, 0.75F}, {0, 0.25F}}));
    }

    void pointsThatRoundingBringsTogetherAreAStep()
    {
        TransferFunction function;
        for (const double value : {1e-17, 2e-17, 3e-17, 4e-17, 5.0})
            function.opacities.push_back({value, static_cast<float>(value > 3.5e-17 ? 0.5 : 0.25)});
        const TransferFunction mirror = mirrored(function, {0, 10});
        QVERIFY(checkTransferFunction(mirror).ok());
        QCOMPARE(mirror.opacities.size(), std::size_t(3));
        QCOMPARE(mirror.opacities[1].opacity, 0.5f);
        QCOMPARE(mirror.opacities[2].opacity, 0.25f);
        const TransferFunction spread = spreadOver(function, {1, 3});
        QVERIFY(checkTransferFunction(spread).ok());
        QCOMPARE(spread.opacities.size(), std::size_t(3));
    }

    void opacitiesAreScaled()
    {
        const TransferFunction function{{}, {{0, 0.25F}, {4, 0.75F}}};
        const TransferFunction twice = withScaledOpacity(function, 2);
        QCOMPARE(twice.opacities[0].opacity, 0.5F);
        QCOMPARE(twice.opacities[1].opacity, 1.0F);
        QCOMPARE(withScaledOpacity(function, -1), function);
    }

    /// Both curves by the same: one that is shorter than the other stays so.
    void pointsAreSpreadOverTheLimits()
    {
        const TransferFunction function{{{3, {1, 0, 0}}}, {{1, 0}, {2, 1}, {2, 0}, {5, 1}}};
        const TransferFunction spread = spreadOver(function, randomLimits);
        QCOMPARE(spread.opacities.front().value, -10.0);
        QCOMPARE(spread.opacities.back().value, 10.0);
        QCOMPARE(spread.opacities[1].value, -5.0);
        QCOMPARE(spread.opacities[2].value, -5.0);
        QCOMPARE(spread.colours.front().value, 0.0);
    }

    void anAddedPointChangesNothingThatIsSeen()
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> value(-12, 12);
        for (int round = 0; round < 200; ++round) {
            const JoinedFunction function = randomFunction(random);
            const auto added = withPoint(function, value(random));
            QVERIFY(added);
            QCOMPARE(added->function.points.size(), function.points.size() + 1);
            QVERIFY(largestDifference(function, added->function) < 1e-4);
        }
        QVERIFY(!withPoint({}, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!withPoint({{{1, {}, 0}, {1, {}, 1}}}, 1));
    }

    void stepsAndBack()
    {
        const JoinedFunction function{{{0, {}, 0}, {4, {}, 0.5F}, {8, {}, 1}}};
        const EditedPoint step = withStep(function, 1);
        QCOMPARE(step.point, std::size_t(1));
        QVERIFY(isOnStep(step.function, 1) && isOnStep(step.function, 2) && !isOnStep(step.function, 0));
        QCOMPARE(withoutStep(step.function, 2).function, function);
        QCOMPARE(withoutStep(step.function, 2).point, std::size_t(1));
        QCOMPARE(withStep(step.function, 2).function, step.function);
        QCOMPARE(withStep(function, 7).function, function);
        QVERIFY(!isOnStep(function, 7));
    }
};

QTEST_APPLESS_MAIN(WholeFunctionTest)
#include "whole_function_test.moc"
