// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/orientation.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include "tests/core/refine/bent_grids.h"
#include "tests/core/refine/plot3d_data.h"
#include "tests/core/refine/recorded_history.h"
#include "tests/lacks.h"

#include <QTest>

#include <map>
#include <random>
#include <set>

using namespace tetra;

namespace {

using Size = std::array<std::uint32_t, 3>;

struct Blocks {
    BlockDivision division{{2, 2, 2}, 0};
    std::vector<RecordedHistory> histories;
    std::size_t cures = 0;
    std::size_t rounds = 0;
    std::size_t runs = 0;
    std::uint64_t inverted = 0;
};

BentGrid gridOf(const Plot3dData& data)
{
    return {data.size, data.positions, {data.values.begin(), data.values.end()}};
}

/// Refines all blocks with one object, in rounds until no block needs a cure that the others do not know.
Blocks refineBlocks(const BentGrid& grid, std::uint32_t edge, double stopKey, std::span<const float> weights = {})
{
    Blocks blocks{BlockDivision(grid.size, edge), {}};
    const LatticeSamples samples(std::span<const double>(grid.values), weights);
    const auto wholeOptions = grid.options();
    CurvilinearBoxOptions options{.size = grid.size,
                                  .box = {},
                                  .facts = factsOf(grid.size, grid.positions, samples),
                                  .warpingWeight = wholeOptions.warpingWeight,
                                  .stopKey = stopKey,
                                  .valueExtent = wholeOptions.valueExtent,
                                  .positionExtent = wholeOptions.positionExtent};
    blocks.histories.resize(blocks.division.count());
    std::vector<std::uint64_t> inverted(blocks.division.count());
    FaceCures cures(blocks.division);
    std::vector<std::uint32_t> due(blocks.division.count());
    std::iota(due.begin(), due.end(), 0u);
    CurvilinearRefiner refiner;
    while (!due.empty()) {
        ++blocks.rounds;
        std::vector<FaceCure> found;
        for (const std::uint32_t block : due) {
            ++blocks.runs;
            options.box = blocks.division.box(block);
            options.centreAtOrigin = !blocks.division.odd(block);
            blocks.histories[block] = {};
            const auto result =
                refiner.refine(options, grid.positions, samples, cures.of(block), found, blocks.histories[block]);
            if (!result)
                return {};
            inverted[block] = result->inverted;
        }
        if (grid.values.size() > 10000)
            qInfo("round %zu: %zu blocks, %zu cures found", blocks.rounds, due.size(), found.size());
        due = cures.add(blocks.rounds < 16 ? found : cures.wholeFacesOf(found));
    }
    blocks.cures = cures.all().size();
    blocks.inverted = std::accumulate(inverted.begin(), inverted.end(), std::uint64_t(0));
    return blocks;
}

struct LevelCounts {
    std::size_t sites = 0;
    std::size_t unmatched = 0; ///< triangles on faces between blocks that only one has
    std::size_t inverted = 0;  ///< that the grid does not force
};

LevelCounts countAt(const BentGrid& grid, const Blocks& blocks, double key)
{
    LevelCounts counts;
    std::set<std::uint64_t> points;
    std::map<std::array<std::uint64_t, 3>, int> triangles;
    const CurvilinearGrid curvilinear(grid.size, grid.positions, LatticeSamples(std::span<const double>(grid.values)));
    const PackedLattice& lattice = curvilinear.lattice();
    for (std::uint32_t number = 0; number < blocks.division.count(); ++number) {
        const RecordedHistory& history = blocks.histories[number];
        const LatticeBox box = blocks.division.box(number);
        const std::size_t sites = history.sitesAt(key);
        points.insert(history.points.begin(), history.points.begin() + std::ptrdiff_t(sites));
        for (const auto& tetrahedron : history.tetrahedra) {
            if (!history.alive(tetrahedron, sites))
                continue;
            std::array<PackedPoint, 4> vertices{};
            for (std::size_t i = 0; i < 4; ++i)
                vertices[i] = lattice.pointAt(std::uint32_t(history.points[tetrahedron.sites[i]]));
            if (curvilinear.orientation(vertices) < 0 && !curvilinear.allowsInverted(vertices))
                ++counts.inverted;
            for (std::size_t left = 0; left < 4; ++left) {
                std::array<std::uint64_t, 3> triangle{};
                for (std::size_t i = 0, to = 0; i < 4; ++i)
                    if (i != left)
                        triangle[to++] = history.points[tetrahedron.sites[i]];
                std::ranges::sort(triangle);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::uint32_t plane = grid.place(triangle[0])[axis];
                    const bool between = (plane == box.origin[axis] && plane > 0) ||
                                         (plane == box.last(axis) && plane + 1 < grid.size[axis]);
                    if (between && grid.place(triangle[1])[axis] == plane && grid.place(triangle[2])[axis] == plane)
                        ++triangles[triangle];
                }
            }
        }
    }
    counts.sites = points.size();
    for (const auto& [triangle, count] : triangles)
        counts.unmatched += count != 2;
    return counts;
}

/// Whether every point of several blocks is a site of all or none, with one key.
bool sharedKeysAgree(const Blocks& blocks)
{
    std::map<std::uint64_t, std::pair<float, std::size_t>> sites;
    for (const RecordedHistory& history : blocks.histories)
        for (std::size_t site = 0; site < history.points.size(); ++site) {
            const auto [entry, isNew] =
                sites.try_emplace(history.points[site], std::pair(history.runningKeys[site], std::size_t(0)));
            if (entry->second.first != history.runningKeys[site])
                return false;
            ++entry->second.second;
        }
    const Size& size = blocks.division.size();
    std::vector<std::uint32_t> holders;
    return std::ranges::all_of(sites, [&](const auto& site) {
        const std::uint64_t row = site.first / size[0];
        blocks.division.blocksOf(
            {std::uint32_t(site.first % size[0]), std::uint32_t(row % size[1]), std::uint32_t(row / size[1])}, holders);
        return site.second.second == holders.size();
    });
}

} // namespace

class CurvilinearBlocksTest : public QObject {
    Q_OBJECT
private slots:
    /// C7, S4, S5: on shared faces the same triangles at every key, shared sites with one key, and nothing flipped that
    /// the grid does not force.
    void blocksConform()
    {
        std::mt19937 random(21);
        std::size_t cures = 0;
        for (int trial = 0; trial < 150; ++trial) {
            const BentGrid grid = randomGrid(random);
            const std::uint32_t edge = 1 + static_cast<std::uint32_t>(random() % 6);
            std::vector<float> weights(trial % 5 == 4 ? grid.values.size() : 0);
            for (float& weight : weights)
                weight = static_cast<float>(random() % 1000) / 300;
            const double stop = trial % 3 == 2 ? 0.03 * grid.valueExtent() : 0;
            const Blocks blocks = refineBlocks(grid, edge, stop, weights);
            QVERIFY(!blocks.histories.empty());
            cures += blocks.cures;
            const QString name = QString("grid %1, blocks of %2, %3 rounds").arg(trial).arg(edge).arg(blocks.rounds);
            QVERIFY2(sharedKeysAgree(blocks), qPrintable(name));
            std::set<float> levels;
            for (const RecordedHistory& history : blocks.histories)
                levels.insert(history.runningKeys.begin(), history.runningKeys.end());
            const std::size_t step = std::max<std::size_t>(levels.size() / 20, 1);
            std::size_t number = 0;
            for (const float level : levels)
                if (number++ % step == 0 && std::isfinite(level)) {
                    const LevelCounts counts = countAt(grid, blocks, level);
                    QVERIFY2(counts.unmatched == 0 && counts.inverted == 0,
                             qPrintable(QString("%1: %2 unmatched, %3 inverted at %4")
                                            .arg(name)
                                            .arg(counts.unmatched)
                                            .arg(counts.inverted)
                                            .arg(level)));
                }
        }
        QVERIFY(cures > 100);
    }

    /// C7 on the paper's own grids; the figures of docs/lab/performance.md.
    void papersGridsConform_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<quint32>("edge");
        for (const char* name : {"bluntfin", "post"})
            for (const quint32 edge : {8u, 16u, 32u})
                QTest::newRow(qPrintable(QString("%1, %2 cells").arg(name).arg(edge))) << QString(name) << edge;
    }
    void papersGridsConform()
    {
        QFETCH(QString, name);
        QFETCH(quint32, edge);
        const auto data = readPlot3d(name);
        if (!data)
            QSKIP_WITHOUT("data");
        const BentGrid grid = gridOf(*data);
        const Blocks blocks = refineBlocks(grid, edge, 0);
        QVERIFY(!blocks.histories.empty());
        qInfo("%u blocks, %zu rounds, %zu runs, %zu cures on faces", blocks.division.count(), blocks.rounds,
              blocks.runs, blocks.cures);
        for (const double percent : {4., 3., 2., 1., .5, .2, .1, 0.}) {
            const LevelCounts counts = countAt(grid, blocks, percent / 100 * grid.valueExtent());
            qInfo("%g %%: %zu sites", percent, counts.sites);
            QCOMPARE(counts.unmatched, std::size_t(0));
            QCOMPARE(counts.inverted, std::size_t(0));
        }
    }
};

QTEST_APPLESS_MAIN(CurvilinearBlocksTest)
#include "curvilinear_blocks_test.moc"
