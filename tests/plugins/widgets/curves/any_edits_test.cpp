// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of several points: whatever is done to a function, it stays one, and the selection follows its points.
#include "plugins/widgets/curves/arranging.h"
#include "plugins/widgets/curves/copying.h"
#include "plugins/widgets/curves/moving.h"
#include "plugins/widgets/curves/reshaping.h"
#include "tests/plugins/widgets/curves/random_functions.h"
#include "tests/soak.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace tetra;

namespace {

using Edit = std::function<EditedSelection(const JoinedFunction&, const TransferSelection&, std::mt19937&)>;

/// Mostly within the limits, sometimes beyond them or no number.
double wildNumber(std::mt19937& random)
{
    switch (random() % 20) {
    case 0: return std::numeric_limits<double>::quiet_NaN();
    case 1: return std::numeric_limits<double>::infinity();
    case 2: return -1e308;
    case 3: return 1e308;
    default: return std::round(std::uniform_real_distribution<double>(-25, 25)(random)) / 2;
    }
}

NeighbourRule anyRule(std::mt19937& random)
{
    return static_cast<NeighbourRule>(random() % 3);
}

SelectionMove anyMove(std::mt19937& random)
{
    return {wildNumber(random), wildNumber(random) / 10, static_cast<OpacityAxis>(random() % 2)};
}

/// Those that keep all points.
std::vector<std::pair<const char*, Edit>> arrangements()
{
    return {
        {"move", [](const auto& f, const auto& s,
                    auto& random) { return moveSelected(f, s, anyMove(random), anyRule(random), randomLimits); }},
        {"value", [](const auto& f, const auto& s,
                     auto& random) { return withValue(f, s, wildNumber(random), anyRule(random), randomLimits); }},
        {"align opacities", [](const auto& f, const auto& s,
                               auto& random) { return alignOpacities(f, s, static_cast<Alignment>(random() % 4)); }},
        {"align values", [](const auto& f, const auto& s,
                            auto& random) { return alignValues(f, s, static_cast<Alignment>(random() % 4)); }},
        {"distribute", [](const auto& f, const auto& s, auto&) { return distributeValues(f, s, randomLimits); }},
        {"flip", [](const auto& f, const auto& s, auto&) { return flipValues(f, s, randomLimits); }},
        {"invert", [](const auto& f, const auto& s, auto&) { return invertOpacities(f, s); }},
        {"ramp", [](const auto& f, const auto& s, auto&) { return rampOpacities(f, s); }},
        {"opacity", [](const auto& f, const auto& s, auto& random) { return withOpacity(f, s, wildNumber(random)); }},
    };
}

std::vector<std::pair<const char*, Edit>> others()
{
    return {
        {"delete", [](const auto& f, const auto& s, auto&) { return withoutSelected(f, s); }},
        {"colour",
         [](const auto& f, const auto& s, auto& random) {
             return withColour(f, s, {0.25f, static_cast<float>(wildNumber(random)), 1});
         }},
        {"group", [](const auto& f, const auto& s, auto& random) { return withGroup(f, s, int(random() % 14) - 2); }},
        {"peak",
         [](const auto& f, const auto&, auto& random) {
             return withPeak(f, {wildNumber(random), wildNumber(random), wildNumber(random) / 5}, randomLimits);
         }},
        {"simplify",
         [](const auto& f, const auto& s, auto& random) {
             return simplified(f, s, {0.1 * double(random() % 5), 0.1 * double(random() % 5)});
         }},
        {"paste",
         [](const auto& f, const auto& s, auto& random) {
             const JoinedFunction of = randomFunction(random);
             const auto at = random() % 2 == 0 ? std::optional(wildNumber(random)) : std::nullopt;
             const auto edited = pasted(f, copyOfSelected(of, allPoints(of)), at, randomLimits);
             return edited ? *edited : EditedSelection{f, s};
         }},
        {"duplicate",
         [](const auto& f, const auto& s, auto& random) { return duplicated(f, s, wildNumber(random), randomLimits); }},
        {"point",
         [](const auto& f, const auto& s, auto& random) {
             const auto added = withPoint(f, wildNumber(random));
             return added ? EditedSelection{added->function, {added->point}} : EditedSelection{f, s};
         }},
        {"step",
         [](const auto& f, const auto&, auto& random) {
             const EditedPoint edited = withStep(f, random() % 9);
             return EditedSelection{edited.function, {}};
         }},
        {"no step",
         [](const auto& f, const auto&, auto& random) {
             const EditedPoint edited = withoutStep(f, random() % 9);
             return EditedSelection{edited.function, {}};
         }},
    };
}

bool isSelection(const EditedSelection& edited)
{
    return selectionOf(edited.function, edited.selection) == edited.selection;
}

/// What does not change with value and opacity of the selected points, and of the others.
auto namesOf(const JoinedFunction& function, const TransferSelection& selection, bool selected)
{
    std::vector<std::pair<std::array<float, 3>, std::optional<int>>> names;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (std::ranges::binary_search(selection, i) == selected)
            names.emplace_back(function.points[i].colour, function.points[i].group);
    std::ranges::sort(names);
    return names;
}

} // namespace

class AnyEditsTest : public QObject {
    Q_OBJECT

private slots:
    void anyEditsGiveATransferFunction();
    void theSelectionFollowsItsPoints();
    void pointsThatDoNotExistArePassedOver();
    void selections();
};

void AnyEditsTest::anyEditsGiveATransferFunction()
{
    auto edits = arrangements();
    std::ranges::copy(others(), std::back_inserter(edits));
    std::mt19937 random(seedOf(1));
    for (int round = 0; round < 400; ++round) {
        EditedSelection edited{randomFunction(random), {}};
        for (int step = 0; step < 40; ++step) {
            const auto& [name, edit] = edits[random() % edits.size()];
            edited = edit(edited.function, randomSelection(random, edited.function), random);
            const Status status = checkTransferFunction(separated(edited.function));
            QVERIFY2(status.ok(), status.ok() ? "" : (name + (": " + status.error().text())).c_str());
            QVERIFY2(isSelection(edited), name);
        }
    }
}

void AnyEditsTest::theSelectionFollowsItsPoints()
{
    std::mt19937 random(seedOf(2));
    for (int round = 0; round < 2000; ++round) {
        const JoinedFunction function = randomFunction(random);
        const TransferSelection selection = randomSelection(random, function);
        for (const auto& [name, edit] : arrangements()) {
            const EditedSelection edited = edit(function, selection, random);
            for (const bool selected : {true, false})
                QVERIFY2(namesOf(function, selection, selected) == namesOf(edited.function, edited.selection, selected),
                         name);
            QCOMPARE(edited.function.unitDistance, function.unitDistance);
            QVERIFY2(edited.function.mask == function.mask, name);
        }
    }
}

void AnyEditsTest::pointsThatDoNotExistArePassedOver()
{
    std::mt19937 random(seedOf(3));
    for (int round = 0; round < 100; ++round) {
        const JoinedFunction function = randomFunction(random);
        for (const auto& [name, edit] : arrangements())
            QVERIFY2(edit(function, {1000, 1001}, random).function == function, name);
        QCOMPARE(withoutSelected(function, {1000}).function, function);
        QCOMPARE(withGroup(function, {1000}, 3).function, function);
        QCOMPARE(simplified(function, {1000}, {1, 1}).function, function);
    }
}

void AnyEditsTest::selections()
{
    const JoinedFunction function{{{0, {}, 0}, {4, {}, 0.5F, 2}, {4, {}, 1}, {8, {}, 0.25F, 2}}, 1};
    QCOMPARE(selectionOf(function, {3, 9, 1, 3}), (TransferSelection{1, 3}));
    QCOMPARE(allPoints(function), (TransferSelection{0, 1, 2, 3}));
    QCOMPARE(pointsWithin(function, {4, 8}, {0.25, 0.5}), (TransferSelection{1, 3}));
    QCOMPARE(pointsOfGroup(function, 2), (TransferSelection{1, 3}));
    QCOMPARE(toggled({1, 3}, 2), (TransferSelection{1, 2, 3}));
    QCOMPARE(toggled({1, 3}, 1), (TransferSelection{3}));
    const JoinedFunction grouped = withGroup(function, {0}, 9).function;
    QCOMPARE(pointsOfGroup(grouped, 9), (TransferSelection{0}));
    QCOMPARE(withGroup(grouped, {0}, std::nullopt).function, function);
    QCOMPARE(withoutSelected(function, {1, 3}).function.points.size(), std::size_t(2));
}

QTEST_APPLESS_MAIN(AnyEditsTest)
#include "any_edits_test.moc"
