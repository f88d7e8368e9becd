// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/orientation.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include "tests/core/refine/plot3d_data.h"
#include "tests/core/refine/recorded_history.h"
#include "tests/lacks.h"

#include <QTest>

#include <algorithm>

using namespace tetra;

namespace {

struct Level {
    double percent;
    double papersSites;
};
constexpr Level bluntFinLevels[] = {{4, 3612},   {3, 5296},   {2, 8263},   {1, 14162},
                                    {.5, 19620}, {.2, 27351}, {.1, 32945}, {0, 40960}};
constexpr Level postLevels[] = {{4, 8282},   {3, 13177},  {2, 20773},  {1, 33681},
                                {.5, 48418}, {.2, 69568}, {.1, 87085}, {0, 109744}};

double extentOf(const std::vector<float>& values)
{
    const auto [least, greatest] = std::ranges::minmax(values);
    return double(greatest) - double(least);
}

double diagonalOf(const std::vector<Eigen::Vector3d>& positions)
{
    Eigen::Vector3d least = positions[0], greatest = positions[0];
    for (const Eigen::Vector3d& position : positions) {
        least = least.cwiseMin(position);
        greatest = greatest.cwiseMax(position);
    }
    return (greatest - least).norm();
}

Result<CurvilinearRefinementResult> refine(const Plot3dData& data, CurvilinearSelection selection, HistorySink& sink)
{
    CurvilinearRefinementOptions options;
    options.valueExtent = extentOf(data.values);
    options.positionExtent = diagonalOf(data.positions);
    options.warpingWeight = options.valueExtent / options.positionExtent;
    options.selection = selection;
    return refineCurvilinear(data.size, data.positions, LatticeSamples(std::span<const float>(data.values)), options,
                             sink);
}

struct Counts {
    std::size_t tetrahedra = 0;
    std::size_t inverted = 0;
};

/// Both grids are right-handed.
Counts countAt(const Plot3dData& data, const RecordedHistory& history, std::size_t sites)
{
    Counts counts;
    for (const RecordedHistory::Tetrahedron& tetrahedron : history.tetrahedra) {
        if (!history.alive(tetrahedron, sites))
            continue;
        ++counts.tetrahedra;
        const auto position = [&](std::size_t i) {
            const Eigen::Vector3d& at = data.positions[history.points[tetrahedron.sites[i]]];
            return std::array<double, 3>{at.x(), at.y(), at.z()};
        };
        counts.inverted += orientationSign(position(0), position(1), position(2), position(3)) < 0;
    }
    return counts;
}

/// Tetrahedra that some query gives: those that do not live and die within one running key.
std::size_t storedCount(const RecordedHistory& history)
{
    return static_cast<std::size_t>(std::ranges::count_if(history.tetrahedra, [&](const auto& tetrahedron) {
        return tetrahedron.destroyer >= history.points.size() ||
               history.runningKeys[tetrahedron.sites[0]] > history.runningKeys[tetrahedron.destroyer];
    }));
}

} // namespace

/// R30 and acceptance: the paper's Table 1 on the paper's own grids.
class CurvilinearFiguresTest : public QObject {
    Q_OBJECT
private slots:
    void normalisedKeyNeedsFewerSitesThanThePaper_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("BluntFin") << "bluntfin";
        QTest::newRow("Post") << "post";
    }
    void normalisedKeyNeedsFewerSitesThanThePaper()
    {
        QFETCH(QString, name);
        const auto data = readPlot3d(name);
        if (!data)
            QSKIP_WITHOUT("data");
        RecordedHistory history;
        const auto result = refine(*data, CurvilinearSelection::Normalised, history);
        QVERIFY(result.ok());
        const bool bluntFin = name == "bluntfin";
        for (const Level& level : bluntFin ? bluntFinLevels : postLevels) {
            const std::size_t sites = history.sitesAt(level.percent / 100 * extentOf(data->values));
            const double most = level.percent == 1                ? 0.5 * level.papersSites
                                : level.percent == 4 && !bluntFin ? 1.1 * level.papersSites
                                                                  : level.papersSites;
            QVERIFY2(double(sites) <= most, qPrintable(QString("%1 sites at %2 %").arg(sites).arg(level.percent)));
            const Counts counts = countAt(*data, history, sites);
            const std::size_t incurable = bluntFin && level.percent == 0 ? 2 : 0; // bent cells have their share
            QVERIFY2(counts.inverted <= incurable,
                     qPrintable(QString("%1 inverted at %2 %").arg(counts.inverted).arg(level.percent)));
        }
        const Counts finest = countAt(*data, history, history.points.size());
        QCOMPARE(finest.inverted, std::size_t(result->inverted));
        const double papers = bluntFin ? 222528 : 609245;
        QVERIFY2(std::abs(double(finest.tetrahedra) / papers - 1) < 0.002,
                 qPrintable(QString::number(finest.tetrahedra)));
        const std::size_t stored = storedCount(history);
        QVERIFY2(stored <= (bluntFin ? 600000u : 1650000u), qPrintable(QString::number(stored)));
        QCOMPARE(result->degenerate > 0, bluntFin);
    }

    /// S4: compared in raw units, warping and error choose about as many points as the paper's program. That seems not
    /// to have looked at flipped tetrahedra; without their cures the figures of Post are the paper's to 1 %.
    void papersSelectionNeedsThePapersSites_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("least"); // over the paper's
        QTest::addColumn<double>("most");
        QTest::newRow("BluntFin") << "bluntfin" << 0.85 << 1.0;
        QTest::newRow("Post") << "post" << 1.0 << 1.17;
    }
    void papersSelectionNeedsThePapersSites()
    {
        QFETCH(QString, name);
        QFETCH(double, least);
        QFETCH(double, most);
        const auto data = readPlot3d(name);
        if (!data)
            QSKIP_WITHOUT("data");
        RecordedHistory history;
        QVERIFY(refine(*data, CurvilinearSelection::Paper, history).ok());
        for (const Level& level : name == "post" ? postLevels : bluntFinLevels) {
            const std::size_t sites = history.sitesAt(level.percent / 100 * extentOf(data->values));
            if (level.percent <= 1)
                QVERIFY2(double(sites) >= least * level.papersSites && double(sites) <= most * level.papersSites,
                         qPrintable(QString("%1 sites at %2 %").arg(sites).arg(level.percent)));
            QCOMPARE(countAt(*data, history, sites).inverted, std::size_t(0));
        }
    }
};

QTEST_APPLESS_MAIN(CurvilinearFiguresTest)
#include "curvilinear_figures_test.moc"
