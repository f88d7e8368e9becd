// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include "tests/core/refine/bent_grids.h"
#include "tests/core/refine/curvilinear_check.h"
#include "tests/core/refine/recorded_history.h"

#include <QTest>

#include <set>

using namespace tetra;

namespace {

BentGrid gridNamed(const QString& name)
{
    if (name == "duct")
        return bentDuct();
    if (name == "wrapped")
        return wrappedGrid();
    if (name == "collapsed")
        return collapsedGrid();
    if (name == "two points")
        return shakenGrid({2, 2, 2}, 0.2, 1);
    if (name == "flat")
        return shakenGrid({9, 7, 2}, 0.2, 2);
    if (name == "shaken")
        return shakenGrid({6, 7, 5}, 0.2, 3);
    if (name == "folded")
        return shakenGrid({6, 6, 6}, 0.9, 4);
    BentGrid mirrored = bentDuct();
    for (Eigen::Vector3d& position : mirrored.positions)
        position.x() = -position.x();
    return mirrored;
}

QString described(const MeshFindings& findings)
{
    return QString(
               "%1 tetrahedra, covers %2, conforming %3, Delaunay %4, bounded %5, inverted %6, error %7, warping %8")
        .arg(findings.tetrahedra)
        .arg(findings.covers)
        .arg(findings.conforming)
        .arg(findings.delaunay)
        .arg(findings.bounded)
        .arg(findings.inverted)
        .arg(findings.error)
        .arg(findings.warping);
}

} // namespace

class CurvilinearRefinementTest : public QObject {
    Q_OBJECT
private slots:
    /// Before the positions, which are not there, are looked at.
    void refusesMorePointsThanCanBeNumbered()
    {
        RecordedHistory history;
        const auto refused =
            refineCurvilinear({2048, 2048, 1024}, {}, LatticeSamples(std::span<const float>(), {}), {}, history);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
    }

    /// R4, R5, R8, R9, S1, S4, S5, S6: at every level the mesh fills computational space, conforms, keeps error and
    /// warping, and has no flipped tetrahedron that a point could cure; all found by brute force.
    void keepsItsAccuracyAtEveryLevel_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"duct", "wrapped", "collapsed", "two points", "flat", "shaken", "folded", "mirrored"})
            QTest::addRow("%s", name) << name;
    }
    void keepsItsAccuracyAtEveryLevel()
    {
        QFETCH(QString, name);
        const BentGrid grid = gridNamed(name);
        const CurvilinearRefinementOptions options = grid.options();
        RecordedHistory history;
        const auto result = grid.refine(options, history);
        QVERIFY(result.ok());
        QCOMPARE(result->sites, std::uint32_t(history.points.size()));
        QCOMPARE(result->tetrahedra, std::uint64_t(history.tetrahedra.size()));
        QCOMPARE(history.traits.warpingWeight, options.warpingWeight);
        QCOMPARE(history.finalKey, 0.0f);
        QCOMPARE(std::set<std::uint64_t>(history.points.begin(), history.points.end()).size(), history.points.size());
        const MeshCheck check(grid, history);
        for (const double percent : {100.0, 20.0, 5.0, 1.0, 0.0}) {
            const double level = percent / 100 * grid.valueExtent();
            const MeshFindings findings = check.look(history.sitesAt(level), true);
            QVERIFY2(findings.covers && findings.conforming && findings.delaunay && findings.bounded,
                     qPrintable(described(findings)));
            QVERIFY2(findings.error <= level + 1e-12 && findings.warping * options.warpingWeight <= level + 1e-12,
                     qPrintable(described(findings)));
            QVERIFY2(findings.inverted <= result->inverted, qPrintable(described(findings)));
        }
        const MeshFindings finest = check.look(history.points.size(), false);
        QCOMPARE(finest.inverted, result->inverted);
        QCOMPARE(finest.degenerate, result->degenerate);
        QCOMPARE(result->inverted > 0, name == "folded");
        QCOMPARE(result->degenerate > 0, name == "collapsed");
    }

    /// S5: without the cure there would be flipped tetrahedra: the grids above have some on the way.
    void flipsAreMetAndCured()
    {
        RecordedHistory history;
        const BentGrid grid = wrappedGrid();
        QVERIFY(grid.refine(grid.options(), history).ok());
        const MeshCheck check(grid, history);
        std::size_t inconsistent = 0;
        for (std::size_t sites = 8; sites < history.points.size(); ++sites)
            inconsistent += check.look(sites, false).inverted > 0;
        QVERIFY(inconsistent > 3);
        for (std::size_t sites = 8; sites < history.points.size(); ++sites)
            if (history.runningKeys[sites] < history.runningKeys[sites - 1])
                QCOMPARE(check.look(sites, false).inverted, std::size_t(0));
    }

    /// A left-handed grid is the same grid in a mirror.
    void handednessComesFromTheData()
    {
        RecordedHistory right, left;
        const BentGrid duct = bentDuct(), mirrored = gridNamed("mirrored");
        QVERIFY(duct.refine(duct.options(), right).ok());
        QVERIFY(mirrored.refine(duct.options(), left).ok());
        QCOMPARE(left.points, right.points);
        QCOMPARE(left.runningKeys, right.runningKeys);
    }

    /// R12: stopping at a key gives the beginning of the full history.
    void stoppingGivesAPrefix()
    {
        const BentGrid grid = bentDuct();
        RecordedHistory all, part;
        QVERIFY(grid.refine(grid.options(), all).ok());
        CurvilinearRefinementOptions options = grid.options();
        options.stopKey = 0.05 * grid.valueExtent();
        QVERIFY(grid.refine(options, part).ok());
        QVERIFY(part.finalKey <= options.stopKey);
        QCOMPARE(part.points.size(), all.sitesAt(options.stopKey));
        QVERIFY(std::equal(part.points.begin(), part.points.end(), all.points.begin()));
    }

    /// Rounding is no warping: cells of equal size need no points but the corners, whatever their size.
    void evenCellsNeedOnlyTheCorners()
    {
        BentGrid grid = bentGrid({9, 8, 7}, [](double x, double y, double z) { return Eigen::Vector3d(x, y, z); });
        for (std::size_t point = 0; point < grid.positions.size(); ++point) {
            grid.positions[point] = grid.positions[point].cwiseProduct(Eigen::Vector3d(0.1, 0.3, 0.7));
            grid.positions[point] += Eigen::Vector3d(0.77, -3, 5);
            grid.values[point] = 0.1 * grid.positions[point].x() + 7;
        }
        RecordedHistory history;
        const auto result = grid.refine(grid.options(), history);
        QVERIFY(result.ok());
        QCOMPARE(result->sites, 8u);
    }

    /// R6: the levels hold for weighted accuracies, and where the weight is 0 no point is needed.
    void weightsMultiplyErrorAndWarping()
    {
        const BentGrid grid = shakenGrid({8, 5, 5}, 0.2, 5);
        std::vector<float> weights;
        for (std::uint64_t point = 0; point < grid.values.size(); ++point)
            weights.push_back(grid.place(point)[0] < 4 ? 1.0f : grid.place(point)[0] == 4 ? 0.5f : 0.0f);
        RecordedHistory plain, weighted;
        QVERIFY(grid.refine(grid.options(), plain).ok());
        QVERIFY(grid.refine(grid.options(), weighted, {}, weights).ok());
        const double level = 0.02 * grid.valueExtent();
        QVERIFY(weighted.sitesAt(level) < plain.sitesAt(level));
        const MeshFindings findings = MeshCheck(grid, weighted, weights).look(weighted.sitesAt(level), true);
        QVERIFY2(findings.covers && findings.conforming && findings.delaunay && findings.bounded,
                 qPrintable(described(findings)));
        QVERIFY(findings.error <= level && findings.warping * grid.options().warpingWeight <= level);
    }

    /// The paper's choice of points: the levels hold all the same, and nothing is flipped.
    void papersSelectionKeepsTheAccuracy()
    {
        const BentGrid grid = wrappedGrid();
        CurvilinearRefinementOptions options = grid.options();
        options.selection = CurvilinearSelection::Paper;
        RecordedHistory history;
        QVERIFY(grid.refine(options, history).ok());
        for (const double percent : {20.0, 5.0, 0.0}) {
            const double level = percent / 100 * grid.valueExtent();
            const MeshFindings findings = MeshCheck(grid, history).look(history.sitesAt(level), true);
            QVERIFY2(findings.covers && findings.conforming && findings.bounded && findings.inverted == 0,
                     qPrintable(described(findings)));
            QVERIFY(findings.error <= level + 1e-12 && findings.warping * options.warpingWeight <= level + 1e-12);
        }
    }

    void errorOfTheSinkEndsTheBuild()
    {
        const BentGrid grid = bentDuct();
        RecordedHistory history;
        history.failAfter = 20;
        const auto result = grid.refine(grid.options(), history);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().kind, ErrorKind::CannotWrite);
    }

    void cancelsAndReportsProgress()
    {
        const BentGrid grid = shakenGrid({40, 40, 20}, 0.2, 6);
        RecordedHistory whole, part;
        double last = 0;
        bool rising = true;
        const Progress watch({}, [&](double fraction, const Message&) {
            rising = rising && fraction >= last - 1e-12 && fraction <= 1;
            last = fraction;
        });
        QVERIFY(grid.refine(grid.options(), whole, watch).ok());
        QVERIFY(rising && last > 0.5);
        std::stop_source stop;
        const Progress cancelling(stop.get_token(), [&](double fraction, const Message&) {
            if (fraction > 0.2)
                stop.request_stop();
        });
        const auto result = grid.refine(grid.options(), part, cancelling);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().kind, ErrorKind::Cancelled);
        QVERIFY(part.points.size() < whole.points.size());
    }
};

QTEST_APPLESS_MAIN(CurvilinearRefinementTest)
#include "curvilinear_refinement_test.moc"
