// SPDX-License-Identifier: GPL-3.0-or-later
// The scale that a budget allows, for sizes that fall as those of meshes do, in steps, or not always.
#include "core/history/query/mesh_extractor.h"

#include <tan/query.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace tetra;

class BudgetSearchTest : public QObject {
    Q_OBJECT

private slots:
    void findsASizeCloseToTheBudget()
    {
        std::mt19937 random(1);
        for (int round = 0; round < 500; ++round) {
            const double full = std::uniform_real_distribution(1e3, 1e7)(random);
            const double power = std::uniform_real_distribution(0.3, 4.0)(random);
            const double jitter = round % 3 == 0 ? 0.1 : 0;
            const double budget = full * std::uniform_real_distribution(0.01, 1.5)(random);
            int meshes = 0;
            double last = 0;
            const auto sizeAt = [&](double scale) -> Result<std::uint64_t> {
                ++meshes;
                last = scale;
                const double wobble = 1 + jitter * std::sin(1000 * scale);
                return static_cast<std::uint64_t>(100 + full * std::pow(scale, -power) * wobble);
            };
            const auto scale = scaleWithin(static_cast<std::uint64_t>(budget) + 200, 1 + round % 7, 1e6, sizeAt);
            QVERIFY(scale.ok() && *scale >= 1 && *scale == last);
            QVERIFY(meshes <= 25);
            const std::uint64_t size = sizeAt(*scale).value();
            QVERIFY(size <= static_cast<std::uint64_t>(budget) + 200);
            QVERIFY(*scale == 1 || static_cast<double>(size) >= (jitter > 0 ? 0.6 : 0.85) * budget);
        }
    }

    /// Meshes of few different sizes: the next finer one is too large.
    void stepsEndAtTheStep()
    {
        const auto sizeAt = [](double scale) -> Result<std::uint64_t> { return scale >= 7 ? 10 : 1000; };
        const auto scale = scaleWithin(500, 1, 1e6, sizeAt);
        QVERIFY(scale.ok() && *scale >= 7 && *scale < 7.2);
    }

    void whatIsNeverSmallEnoughIsAnError()
    {
        const auto scale = scaleWithin(500, 1, 1e3, [](double) -> Result<std::uint64_t> { return 501; });
        QVERIFY(!scale.ok());
        QCOMPARE(scale.error().kind, ErrorKind::WrongUsage);
    }

    void errorsAreHandedOn()
    {
        const auto scale =
            scaleWithin(500, 1, 1e3, [](double) -> Result<std::uint64_t> { return cancelledError("Looking"); });
        QVERIFY(!scale.ok());
        QCOMPARE(scale.error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(BudgetSearchTest)
#include "budget_search_test.moc"
