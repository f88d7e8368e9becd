// SPDX-License-Identifier: GPL-3.0-or-later
// Several points moved at once: what neighbours do, and that it can be taken back.
#include "plugins/widgets/curves/moving.h"
#include "tests/plugins/widgets/curves/random_functions.h"

#include <QTest>

using namespace tetra;

namespace {

constexpr SelectionMove inValue(double by)
{
    return {by, 0, OpacityAxis::Linear};
}

std::vector<double> valuesOf(const JoinedFunction& function, const TransferSelection& selection, bool selected)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (std::ranges::binary_search(selection, i) == selected)
            values.push_back(function.points[i].value);
    return values;
}

/// With both sides of each step.
TransferSelection withBothSides(const JoinedFunction& function, const TransferSelection& selection)
{
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        for (const std::size_t other : selection)
            if (function.points[i].value == function.points[other].value)
                points.push_back(i);
    return selectionOf(function, std::move(points));
}

} // namespace

class MovingTest : public QObject {
    Q_OBJECT

private slots:
    void allMoveByTheSame_data();
    void allMoveByTheSame();
    void neighboursStop();
    void neighboursArePushed();
    void neighboursThatAreCloserStayAsClose();
    void neighboursArePassed();
    void stepsStayTogether();
    void backIsWhereItBegan();
    void theAxisOfOpacities();
};

void MovingTest::allMoveByTheSame_data()
{
    QTest::addColumn<int>("rule");
    QTest::newRow("stop") << int(NeighbourRule::Stop);
    QTest::newRow("push") << int(NeighbourRule::Push);
    QTest::newRow("pass") << int(NeighbourRule::Pass);
}

void MovingTest::allMoveByTheSame()
{
    QFETCH(int, rule);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> shift(-8, 8);
    for (int round = 0; round < 3000; ++round) {
        const JoinedFunction function = randomFunction(random);
        const TransferSelection selection = withBothSides(function, randomSelection(random, function));
        const double by = shift(random);
        const auto [moved, after] =
            moveSelected(function, selection, inValue(by), static_cast<NeighbourRule>(rule), randomLimits);
        const auto from = valuesOf(function, selection, true), to = valuesOf(moved, after, true);
        QCOMPARE(to.size(), from.size());
        // What would lie on another point lies beside it.
        const double beside = rule == int(NeighbourRule::Pass) ? 0.01 : 1e-9;
        for (std::size_t i = 0; i < to.size(); ++i) {
            QVERIFY(std::abs((to[i] - from[i]) - (to[0] - from[0])) < beside);
            QVERIFY(std::abs(to[i] - from[i]) <= std::abs(by) + beside && (to[i] - from[i]) * by >= -beside);
            QVERIFY(to[i] >= randomLimits.least && to[i] <= randomLimits.largest);
        }
        for (const double value : valuesOf(moved, after, false))
            QVERIFY(value >= randomLimits.least && value <= randomLimits.largest);
        if (rule != int(NeighbourRule::Push))
            QCOMPARE(valuesOf(moved, after, false), valuesOf(function, selection, false));
        if (rule != int(NeighbourRule::Pass))
            QCOMPARE(after, selection);
    }
}

void MovingTest::neighboursStop()
{
    const JoinedFunction function{{{0, {}, 0}, {2, {}, 0.5F}, {3, {}, 0.25F}, {8, {}, 1}}, 1};
    const JoinedFunction up = moveSelected(function, {1, 2}, inValue(100), NeighbourRule::Stop, randomLimits).function;
    QVERIFY(up.points[2].value < 8 && up.points[2].value > 7.99);
    QVERIFY(std::abs(up.points[1].value - (up.points[2].value - 1)) < 1e-12);
    const JoinedFunction down =
        moveSelected(function, {0, 2}, inValue(-100), NeighbourRule::Stop, randomLimits).function;
    QVERIFY(down.points[2].value > 2 && down.points[2].value < 2.01);
    const JoinedFunction out = moveSelected(function, {3}, inValue(100), NeighbourRule::Stop, randomLimits).function;
    QCOMPARE(out.points[3].value, randomLimits.largest);
}

void MovingTest::neighboursArePushed()
{
    const JoinedFunction function{{{0, {}, 0}, {2, {}, 0.5F}, {3, {}, 0.25F}, {8, {}, 1}}, 1};
    const JoinedFunction near = moveSelected(function, {1}, inValue(2), NeighbourRule::Push, randomLimits).function;
    QCOMPARE(near.points[1].value, 4.0);
    QVERIFY(near.points[2].value > 4 && near.points[2].value < 4.01);
    QCOMPARE(near.points[3].value, 8.0);
    const JoinedFunction far = moveSelected(function, {1}, inValue(50), NeighbourRule::Push, randomLimits).function;
    QCOMPARE(far.points[3].value, randomLimits.largest);
    QVERIFY(far.points[1].value > 9.99 && far.points[1].value < far.points[2].value);
    QVERIFY(far.points[2].value < far.points[3].value);
    const JoinedFunction down = moveSelected(function, {3}, inValue(-9), NeighbourRule::Push, randomLimits).function;
    QCOMPARE(down.points[3].value, -1.0);
    QVERIFY(down.points[0].value > -1.01 && down.points[0].value < down.points[1].value);
}

/// Points that are nearer to each other than new ones may come keep their distances, and the end of the axis is
/// reached.
void MovingTest::neighboursThatAreCloserStayAsClose()
{
    const double least = leastDistanceIn(randomLimits), end = randomLimits.largest, start = randomLimits.least;
    const JoinedFunction up{{{1, {}, 0}, {2, {}, 0.5F}, {2 + least / 4, {}, 0.25F}, {2 + least / 2, {}, 1}}, 1};
    const JoinedFunction pushed = moveSelected(up, {1}, inValue(100), NeighbourRule::Push, randomLimits).function;
    QCOMPARE(pushed.points[3].value, end);
    QVERIFY(std::abs(pushed.points[2].value - (end - least / 4)) < least / 1000);
    QVERIFY(std::abs(pushed.points[1].value - (end - least / 2)) < least / 1000);
    const JoinedFunction down{{{1, {}, 0}, {1 + least / 8, {}, 0.5F}, {4, {}, 0.25F}}, 1};
    const JoinedFunction back = moveSelected(down, {1}, inValue(-100), NeighbourRule::Push, randomLimits).function;
    QCOMPARE(back.points[0].value, start);
    QVERIFY(std::abs(back.points[1].value - (start + least / 8)) < least / 1000);
}

void MovingTest::neighboursArePassed()
{
    const JoinedFunction function{{{0, {}, 0}, {2, {}, 0.5F}, {3, {}, 0.25F}, {8, {}, 1}}, 1};
    const EditedSelection passed = moveSelected(function, {0, 1}, inValue(4), NeighbourRule::Pass, randomLimits);
    QCOMPARE(passed.selection, (TransferSelection{1, 2}));
    QCOMPARE(passed.function.points[0].opacity, 0.25F);
    QCOMPARE(passed.function.points[2].value, 6.0);
    const EditedSelection onto = moveSelected(function, {0}, inValue(3), NeighbourRule::Pass, randomLimits);
    QCOMPARE(onto.selection, (TransferSelection{2}));
    QVERIFY(onto.function.points[2].value > 3 && onto.function.points[2].value < 3.01);
}

void MovingTest::stepsStayTogether()
{
    const JoinedFunction function{{{0, {}, 0}, {4, {}, 0.5F}, {4, {}, 0.25F}, {8, {}, 1}}, 1};
    const EditedSelection moved =
        moveSelected(function, {2}, {1, 0.125, OpacityAxis::Linear}, NeighbourRule::Stop, randomLimits);
    QCOMPARE(moved.function.points[1].value, 5.0);
    QCOMPARE(moved.function.points[1].opacity, 0.5F);
    QCOMPARE(moved.function.points[2].opacity, 0.375F);
    QCOMPARE(withValue(moved.function, {1}, 4, NeighbourRule::Push, randomLimits).function.points[2].value, 4.0);
}

/// A move that nothing cut short is undone by the opposite one.
void MovingTest::backIsWhereItBegan()
{
    std::mt19937 random(5);
    int undone = 0;
    for (int round = 0; round < 3000; ++round) {
        const JoinedFunction function = randomFunction(random);
        const TransferSelection selection = withBothSides(function, randomSelection(random, function));
        const double by = 0.5 * double(int(random() % 33) - 16);
        const auto rule = static_cast<NeighbourRule>(random() % 3);
        const auto [there, after] = moveSelected(function, selection, inValue(by), rule, randomLimits);
        const auto values = valuesOf(there, after, true), before = valuesOf(function, selection, true);
        bool whole = !values.empty() && valuesOf(there, after, false) == valuesOf(function, selection, false);
        for (std::size_t point = 0; point < values.size(); ++point)
            whole = whole && values[point] - before[point] == by;
        if (!whole)
            continue;
        ++undone;
        const EditedSelection back = moveSelected(there, after, inValue(-by), rule, randomLimits);
        QCOMPARE(back.function, function);
        QCOMPARE(back.selection, selection);
    }
    QVERIFY(undone > 500);
}

void MovingTest::theAxisOfOpacities()
{
    for (const OpacityAxis axis : {OpacityAxis::Linear, OpacityAxis::SquareRoot, OpacityAxis::Logarithmic}) {
        double before = -1;
        for (int step = 0; step <= 1000; ++step) {
            const double height = step / 1000.0, opacity = opacityAtHeight(height, axis);
            QVERIFY(opacity > before);
            QVERIFY(std::abs(heightOf(opacity, axis) - height) < 1e-12);
            before = opacity;
        }
        QCOMPARE(opacityAtHeight(0, axis), 0.0);
        QCOMPARE(opacityAtHeight(1, axis), 1.0);
        QCOMPARE(heightOf(std::nan(""), axis), 0.0);
        QCOMPARE(opacityTicks(axis).front(), 0.0);
        QCOMPARE(opacityTicks(axis).back(), 1.0);
    }
    QVERIFY(heightOf(0.01, OpacityAxis::Logarithmic) > 0.3);
    const JoinedFunction function{{{0, {}, 0.001F}, {4, {}, 0.999F}}, 1};
    const JoinedFunction higher =
        moveSelected(function, {0, 1}, {0, 0.1, OpacityAxis::Logarithmic}, NeighbourRule::Stop, randomLimits).function;
    QVERIFY(higher.points[0].opacity > 0.0015F && higher.points[0].opacity < 0.01F);
    QCOMPARE(higher.points[1].opacity, 1.0F);
}

QTEST_APPLESS_MAIN(MovingTest)
#include "moving_test.moc"
