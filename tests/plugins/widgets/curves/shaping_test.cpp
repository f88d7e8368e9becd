// SPDX-License-Identifier: GPL-3.0-or-later
// Arranging, tents, simplification and copies: they do what they promise.
#include "plugins/widgets/curves/arranging.h"
#include "plugins/widgets/curves/copying.h"
#include "plugins/widgets/curves/reshaping.h"
#include "tests/plugins/widgets/curves/random_functions.h"

#include <tan/transfer.h>

#include <QTest>

using namespace tetra;

namespace {

const JoinedFunction four{{{0, {}, 0.1F}, {1, {}, 0.5F}, {4, {}, 0.25F}, {9, {}, 1}}, 1};

std::vector<float> opacitiesOf(const JoinedFunction& function)
{
    std::vector<float> opacities;
    for (const TransferPoint& point : function.points)
        opacities.push_back(point.opacity);
    return opacities;
}

} // namespace

class ShapingTest : public QObject {
    Q_OBJECT

private slots:
    void alignment();
    void distribution();
    void flippingAndInvertingTwiceIsNothing();
    void ramps();
    void peaks();
    void simplificationStaysWithinTheTolerance();
    void simplificationTakesTheFewest();
    void copiesComeBack();
    void copiesOfAnotherUnitDistanceAreAsDense();
};

void ShapingTest::alignment()
{
    const auto aligned = [](Alignment alignment) {
        return opacitiesOf(alignOpacities(four, {1, 2, 3}, alignment).function);
    };
    QCOMPARE(aligned(Alignment::First), (std::vector{0.1F, 0.5F, 0.5F, 0.5F}));
    QCOMPARE(aligned(Alignment::Least), (std::vector{0.1F, 0.25F, 0.25F, 0.25F}));
    QCOMPARE(aligned(Alignment::Largest), (std::vector{0.1F, 1.0F, 1.0F, 1.0F}));
    QCOMPARE(aligned(Alignment::Mean)[2], static_cast<float>(1.75 / 3));
    const JoinedFunction step = alignValues(four, {1, 2}, Alignment::Mean).function;
    QCOMPARE(step.points[1].value, 2.5);
    QVERIFY(isOnStep(step, 1));
    QCOMPARE(alignValues(four, {0, 1, 2}, Alignment::First).function, four);
    QCOMPARE(alignValues(step, {2, 3}, Alignment::First).function, step);
}

void ShapingTest::distribution()
{
    const EditedSelection even = distributeValues(four, {0, 1, 2, 3}, randomLimits);
    QCOMPARE(even.function.points[1].value, 3.0);
    QCOMPARE(even.function.points[2].value, 6.0);
    const EditedSelection past = distributeValues(four, {0, 1, 3}, randomLimits);
    QCOMPARE(past.function.points[2].value, 4.5);
    QCOMPARE(past.selection, (TransferSelection{0, 2, 3}));
}

void ShapingTest::flippingAndInvertingTwiceIsNothing()
{
    std::mt19937 random(6);
    int flippedClear = 0;
    for (int round = 0; round < 2000; ++round) {
        const JoinedFunction function = randomFunction(random);
        const TransferSelection selection = randomSelection(random, function);
        const JoinedFunction inverse = invertOpacities(function, selection).function;
        const JoinedFunction back = invertOpacities(inverse, selection).function;
        for (std::size_t i = 0; i < function.points.size(); ++i)
            QVERIFY(std::abs(back.points[i].opacity - function.points[i].opacity) < 1e-7F);
        const JoinedFunction all = flipValues(function, allPoints(function), randomLimits).function;
        QCOMPARE(flipValues(all, allPoints(all), randomLimits).function, function);
        const EditedSelection once = flipValues(function, selection, randomLimits);
        const bool clear = std::ranges::all_of(
            once.function.points, [](const TransferPoint& point) { return point.value == std::round(point.value); });
        if (!clear)
            continue;
        ++flippedClear;
        const EditedSelection twice = flipValues(once.function, once.selection, randomLimits);
        QCOMPARE(twice.function, function);
        QCOMPARE(twice.selection, selection);
    }
    QVERIFY(flippedClear > 500);
}

void ShapingTest::ramps()
{
    const JoinedFunction ramp = rampOpacities(four, {0, 1, 2, 3}).function;
    QCOMPARE(ramp.points[1].opacity, static_cast<float>(std::lerp(double(0.1F), 1.0, 1.0 / 9)));
    QCOMPARE(ramp.points[2].opacity, static_cast<float>(std::lerp(double(0.1F), 1.0, 4.0 / 9)));
    QCOMPARE(ramp.points[3].opacity, 1.0F);
    QCOMPARE(rampOpacities(four, {0, 3}).function, four);
    QCOMPARE(opacitiesOf(rampOpacities(four, {0, 2, 3}).function)[1], 0.5F);
}

void ShapingTest::peaks()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-10, 10), width(0.1, 9);
    for (int round = 0; round < 2000; ++round) {
        const JoinedFunction function = randomFunction(random);
        const OpacityPeak peak{place(random), width(random), 0.75};
        const auto [peaked, selection] = withPeak(function, peak, randomLimits);
        QCOMPARE(selection.size(), std::size_t(3));
        const TransferPoint &left = peaked.points[selection[0]], &top = peaked.points[selection[1]],
                            &right = peaked.points[selection[2]];
        QCOMPARE(top.value, peak.value);
        QCOMPARE(top.opacity, 0.75F);
        QVERIFY(std::abs(left.value - std::max(peak.value - peak.width / 2, -10.0)) < 1e-12);
        QVERIFY(std::abs(right.value - std::min(peak.value + peak.width / 2, 10.0)) < 1e-12);
        const TransferFunction before = separated(function), after = separated(peaked);
        for (double value = -12.97; value < 13; value += 0.04)
            if (value < left.value || value > right.value)
                QVERIFY(std::abs(evaluateUnmasked(after, value).extinction -
                                 evaluateUnmasked(before, value).extinction) < 1e-5 / function.unitDistance);
    }
    QCOMPARE(withPeak(four, {-10, 4, 0.5}, randomLimits).function.points.front().opacity, 0.5F);
    QCOMPARE(withPeak(four, {11, 4, 0.5}, randomLimits).function, four);
    QCOMPARE(withPeak(four, {1, 0, 0.5}, randomLimits).function, four);
}

void ShapingTest::simplificationStaysWithinTheTolerance()
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> place(-10, 10);
    std::size_t gone = 0;
    for (int round = 0; round < 1000; ++round) {
        JoinedFunction function = randomFunction(random);
        for (int more = 0; more < 10; ++more)
            if (const auto added = withPoint(function, place(random)))
                function = added->function;
        const LookTolerance tolerance{0.05 * double(random() % 8), 0.05 * double(random() % 8) + 1e-6};
        const TransferSelection selection = round % 2 == 0 ? allPoints(function) : randomSelection(random, function);
        const auto [simple, left] = simplified(function, selection, {tolerance.colour + 1e-6, tolerance.opacity});
        const TransferFunction curves = separated(function), simpler = separated(simple);
        gone += function.points.size() - simple.points.size();
        QCOMPARE(simple.points.size() - left.size(), function.points.size() - selection.size());
        for (double value = -12.97; value < 13; value += 0.02) {
            const TransferSample before = evaluateUnmasked(curves, value), after = evaluateUnmasked(simpler, value);
            QVERIFY(std::abs(opacityOf(curves, before) - opacityOf(simpler, after)) <= tolerance.opacity + 1e-9);
            for (std::size_t channel = 0; channel < 3; ++channel)
                QVERIFY(std::abs(before.colour[channel] - after.colour[channel]) <= tolerance.colour + 1e-5);
        }
    }
    QVERIFY(gone > 5000);
}

void ShapingTest::simplificationTakesTheFewest()
{
    std::mt19937 random(9);
    for (int round = 0; round < 100; ++round) {
        const JoinedFunction function = randomFunction(random);
        JoinedFunction dense = function;
        for (int more = 0; more < 100; ++more)
            if (const auto added = withPoint(dense, 0.01 + 0.2 * more - 10))
                dense = added->function;
        const JoinedFunction simple = simplified(dense, allPoints(dense), {1e-4, 1e-4}).function;
        QVERIFY(simple.points.size() <= std::max<std::size_t>(function.points.size(), 1));
        QVERIFY(largestDifference(simple, function, !function.points.empty()) < 1.1e-4);
    }
    QCOMPARE(simplified({{{0, {}, 0.5F}, {1, {}, 0.5F}, {2, {}, 0.5F}}, 1}, {0, 1, 2}, {}).function.points.size(),
             std::size_t(1));
}

void ShapingTest::copiesComeBack()
{
    std::mt19937 random(10);
    for (int round = 0; round < 500; ++round) {
        const JoinedFunction function = randomFunction(random);
        const TransferSelection selection = randomSelection(random, function);
        const std::string text = copyOfSelected(function, selection);
        const auto copy = pasted({{}, function.unitDistance}, text, std::nullopt, randomLimits);
        QVERIFY(copy);
        QCOMPARE(copy->selection, allPoints(copy->function));
        QCOMPARE(copy->function.points.size(), selection.size());
        for (std::size_t i = 0; i < selection.size(); ++i)
            QCOMPARE(copy->function.points[i], function.points[selection[i]]);
        const auto onto = pasted(function, text, std::nullopt, randomLimits);
        QVERIFY(onto);
        QCOMPARE(onto->function.points.size(), function.points.size() + selection.size());
        QCOMPARE(withoutSelected(onto->function, onto->selection).function, function);
        const EditedSelection twice = duplicated(function, selection, 0.25, randomLimits);
        QCOMPARE(withoutSelected(twice.function, twice.selection).function, function);
        if (!selection.empty())
            QCOMPARE(twice.function.points[twice.selection.front()].value,
                     function.points[selection.front()].value + 0.25);
    }
    QCOMPARE(pasted(four, copyOfSelected(four, {1, 2}), 6.5, randomLimits)->selection, (TransferSelection{3, 5}));
    const auto damaged = pasted(four, "{\n!", std::nullopt, randomLimits);
    QVERIFY(!damaged && damaged.error().text().find("line 2, column 1") != std::string::npos);
}

void ShapingTest::copiesOfAnotherUnitDistanceAreAsDense()
{
    const JoinedFunction other{{{3, {}, 0.5F}}, 4};
    const auto edited = pasted({{}, 1}, copyOfSelected(other, {0}), std::nullopt, randomLimits);
    QVERIFY(edited);
    QVERIFY(std::abs(evaluate(separated(edited->function), 3).extinction - evaluate(separated(other), 3).extinction) <
            1e-7);
}

QTEST_APPLESS_MAIN(ShapingTest)
#include "shaping_test.moc"
