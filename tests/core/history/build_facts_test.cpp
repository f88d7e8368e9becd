// SPDX-License-Identifier: GPL-3.0-or-later
// What a built model says of its build: the texts of FORMAT.md stand in the file, and core reads from them what it was
// built with.
#include "core/history/build_facts.h"
#include "tests/core/history/model_fixture.h"

#include <tan/build.h>
#include <tan/model.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

using namespace tetra;

class BuildFactsTest : public QObject {
    Q_OBJECT

private slots:
    void aRefinementTells()
    {
        Refinement refinement{.error = 12.5, .block = 4};
        refinement.weighting = *parseWeighting("value:3,2");
        const auto about = built(bumps(SampleType::UInt8, {9, 9, 9}), refinement);
        QVERIFY(about);
        QCOMPARE(about->builder, std::string("refinement"));
        QCOMPARE(textOf(*about, "error"), std::string("12.5"));
        QCOMPARE(textOf(*about, "block"), std::string("4"));
        const BuildFacts facts = buildFacts(*about);
        QVERIFY(facts.isRefined);
        QCOMPARE(facts.error.value_or(-1), 12.5);
        QCOMPARE(facts.blockCells, 4u);
        QVERIFY(facts.isWeighted());
        QCOMPARE(facts.weights, textOf(*about, "weights"));
        QVERIFY(!facts.hasPaperSelection && !facts.claimsByKeysAlone());
    }

    void blocksInWordsAreNoNumber()
    {
        const auto about = built(bumps(SampleType::UInt8, {5, 5, 5}), Refinement{.error = 50, .block = 0});
        QVERIFY(about);
        QCOMPARE(textOf(*about, "block"), std::string("none"));
        QCOMPARE(buildFacts(*about).blockCells, 0u);
        QVERIFY(!buildFacts(*about).isWeighted());
    }

    void gridsTellTheirSelectionAndClaim()
    {
        const Dataset grid = bentBumps(SampleType::Float32, {5, 5, 5});
        const auto paper = built(grid, Refinement{.error = 20, .paperSelection = true});
        const auto space = built(grid, Refinement{.error = 20, .block = 0, .inSpace = true});
        QVERIFY(paper && space);
        QCOMPARE(textOf(*paper, "selection"), std::string("paper"));
        QVERIFY(buildFacts(*paper).hasPaperSelection && !buildFacts(*paper).claimsInSpace);
        QCOMPARE(textOf(*space, "selection"), std::string("normalised"));
        QCOMPARE(textOf(*space, "error-in"), std::string("space"));
        const BuildFacts facts = buildFacts(*space);
        QVERIFY(!facts.hasPaperSelection && facts.claimsInSpace && facts.claimsByKeysAlone() && !facts.claimsTwoSides);
    }

    void aDecimationIsNoRefinement()
    {
        const auto about = built(bumps(SampleType::UInt8, {4, 4, 4}), Decimation{.error = 5});
        QVERIFY(about);
        QVERIFY(!buildFacts(*about).isRefined);
        QCOMPARE(buildFacts(*about).error.value_or(-1), 5.0);
    }

    void claimsOfBothSidesAreRead()
    {
        ModelDescription about;
        about.parameters = {{"distance", "two-sided"}};
        QVERIFY(buildFacts(about).claimsTwoSides && buildFacts(about).claimsByKeysAlone());
        about.parameters = {{"distance", "one-sided"}};
        QVERIFY(!buildFacts(about).claimsByKeysAlone());
    }

    void whatIsNoNumberIsNotTakenForOne()
    {
        ModelDescription about;
        QVERIFY(!buildFacts(about).error);
        about.parameters = {{"error", "little"}};
        QVERIFY(std::isnan(buildFacts(about).error.value_or(0)));
    }

private:
    std::optional<ModelDescription> built(const Dataset& dataset, const BuildMethod& method)
    {
        const std::string path = folder_.filePath("model.tan").toStdString();
        if (const auto report = buildModel(dataset, path, method); !report) {
            qWarning("%s", report.error().text().c_str());
            return std::nullopt;
        }
        const auto model = Model::open(path);
        return model ? std::optional((*model)->description()) : std::nullopt;
    }

    static std::string textOf(const ModelDescription& about, const std::string& name)
    {
        const auto found = std::ranges::find(about.parameters, name, &std::pair<std::string, std::string>::first);
        return found == about.parameters.end() ? std::string() : found->second;
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(BuildFactsTest)
#include "build_facts_test.moc"
