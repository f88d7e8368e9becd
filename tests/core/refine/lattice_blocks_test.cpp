// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/lattice_refinement.h"

#include "tests/core/refine/recorded_history.h"

#include <QTest>

#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace tetra;

namespace {

using Size = std::array<std::uint32_t, 3>;

struct Block {
    LatticeBox box;
    RecordedHistory history;
};

struct BlockedLattice {
    Size size{};
    Eigen::Vector3d spacing{1, 1, 1};
    std::uint32_t blockCells = 2;
    double stopError = 0;
};

/// Refines all blocks with one object; the last ones of each axis are smaller.
template <class T> std::vector<Block> refineBlocks(const BlockedLattice& lattice, const std::vector<T>& values,
                                                   const std::vector<float>& weights)
{
    LatticeBoxOptions options;
    options.latticeSize = lattice.size;
    options.metric = latticeMetric({9, 9, 9}, lattice.spacing).value();
    options.valueExtent = 120;
    options.stopError = lattice.stopError;
    Size counts{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        counts[axis] = (lattice.size[axis] - 2) / lattice.blockCells + 1;
    LatticeRefiner refiner;
    std::vector<Block> blocks;
    for (std::uint32_t z = 0; z < counts[2]; ++z)
        for (std::uint32_t y = 0; y < counts[1]; ++y)
            for (std::uint32_t x = 0; x < counts[0]; ++x) {
                const Size place{x, y, z};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    options.box.origin[axis] = place[axis] * lattice.blockCells;
                    options.box.size[axis] =
                        std::min(lattice.blockCells + 1, lattice.size[axis] - options.box.origin[axis]);
                }
                options.centreAtOrigin = ((x + y + z) & 1) == 0;
                Block& block = blocks.emplace_back();
                block.box = options.box;
                const LatticeSamples samples(std::span<const T>(values), weights);
                if (!refiner.refine(options, samples, block.history).ok())
                    return {};
            }
    return blocks;
}

/// The triangles, as points of the lattice, that the blocks' meshes at a running error have on the faces between
/// blocks, with how many blocks have each.
std::map<std::array<std::uint64_t, 3>, int> faceTriangles(const std::vector<Block>& blocks, const Size& size,
                                                          double error)
{
    std::map<std::array<std::uint64_t, 3>, int> triangles;
    for (const Block& block : blocks) {
        const std::size_t sites = block.history.sitesAt(error);
        for (const auto& tetrahedron : block.history.tetrahedra) {
            if (tetrahedron.sites[0] >= sites || tetrahedron.destroyer < sites)
                continue;
            for (std::size_t left = 0; left < 4; ++left) {
                std::array<std::uint64_t, 3> triangle{};
                for (std::size_t i = 0, to = 0; i < 4; ++i)
                    if (i != left)
                        triangle[to++] = block.history.points[tetrahedron.sites[i]];
                std::ranges::sort(triangle);
                std::uint64_t stride = 1;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const auto coordinate = [&](std::uint64_t point) { return point / stride % size[axis]; };
                    const std::uint64_t plane = coordinate(triangle[0]);
                    const std::uint64_t first = block.box.origin[axis];
                    const std::uint64_t last = first + block.box.size[axis] - 1;
                    const bool between = (plane == first && first > 0) || (plane == last && last + 1 < size[axis]);
                    if (between && coordinate(triangle[1]) == plane && coordinate(triangle[2]) == plane)
                        ++triangles[triangle];
                    stride *= size[axis];
                }
            }
        }
    }
    return triangles;
}

/// Empty, or what does not conform.
QString conformityFault(const std::vector<Block>& blocks, const Size& size)
{
    std::map<std::uint64_t, float> keys;
    std::map<std::uint64_t, int> holders;
    std::set<float> levels;
    for (const Block& block : blocks)
        for (std::size_t site = 0; site < block.history.points.size(); ++site) {
            const std::uint64_t point = block.history.points[site];
            const float key = block.history.runningKeys[site];
            const auto [entry, isNew] = keys.try_emplace(point, key);
            if (entry->second != key)
                return QString("point %1 has the keys %2 and %3").arg(point).arg(key).arg(entry->second);
            if (std::isfinite(key))
                levels.insert(key);
            ++holders[point];
        }
    for (const auto& [point, count] : holders) {
        int expected = 0;
        for (const Block& block : blocks) {
            bool inside = true;
            std::uint64_t rest = point;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint64_t coordinate = rest % size[axis];
                rest /= size[axis];
                inside = inside && coordinate >= block.box.origin[axis] &&
                         coordinate < block.box.origin[axis] + block.box.size[axis];
            }
            expected += inside;
        }
        if (expected != count)
            return QString("point %1 is a site of %2 blocks of %3").arg(point).arg(count).arg(expected);
    }
    const std::size_t step = std::max<std::size_t>(levels.size() / 25, 1);
    std::size_t number = 0;
    for (const float level : levels)
        if (number++ % step == 0)
            for (const auto& [triangle, count] : faceTriangles(blocks, size, level))
                if (count != 2)
                    return QString("a triangle at %1 is in %2 blocks").arg(level).arg(count);
    return {};
}

template <class T> std::vector<T> values(const Size& size, unsigned seed, bool smooth)
{
    std::mt19937 random(seed);
    std::vector<T> result;
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const double value = smooth ? 60 + 50 * std::sin(0.7 * x) * std::cos(0.5 * y + 0.2 * z)
                                            : static_cast<double>(random() % 120);
                result.push_back(static_cast<T>(std::is_floating_point_v<T> ? value / 7 : value));
            }
    return result;
}

template <class T> QString faultOf(BlockedLattice lattice, unsigned seed, bool weighted)
{
    std::mt19937 random(seed);
    const std::vector<T> samples = values<T>(lattice.size, seed, seed % 3 != 0);
    std::vector<float> weights(weighted ? samples.size() : 0);
    for (float& weight : weights)
        weight = static_cast<float>(random() % 1000) / 300;
    for (const double stop : {0.0, 0.3, 4.0}) {
        lattice.stopError = stop;
        const std::vector<Block> blocks = refineBlocks(lattice, samples, weights);
        if (blocks.empty())
            return "no block could be refined";
        if (const QString fault = conformityFault(blocks, lattice.size); !fault.isEmpty())
            return QString("stopped at %1: ").arg(stop) + fault;
    }
    return {};
}

} // namespace

class LatticeBlocksTest : public QObject {
    Q_OBJECT
private slots:
    /// R10, S3: on shared faces the same triangles at every running error, shared sites with one key.
    void blocksConform_data()
    {
        QTest::addColumn<int>("blockCells");
        QTest::addColumn<QString>("type");
        QTest::addColumn<bool>("weighted");
        for (int cells = 2; cells <= 8; ++cells)
            for (const char* type : {"uint8", "int16", "float", "double"})
                for (const bool weighted : {false, true})
                    QTest::addRow("%d cells, %s%s", cells, type, weighted ? ", weighted" : "")
                        << cells << type << weighted;
    }
    void blocksConform()
    {
        QFETCH(int, blockCells);
        QFETCH(QString, type);
        QFETCH(bool, weighted);
        std::mt19937 random(static_cast<unsigned>(blockCells));
        for (unsigned trial = 0; trial < 3; ++trial) {
            BlockedLattice lattice;
            lattice.blockCells = static_cast<std::uint32_t>(blockCells);
            for (std::uint32_t& count : lattice.size)
                count = 2 + static_cast<std::uint32_t>(random()) % (2 * lattice.blockCells + 3);
            lattice.size[trial] = 2 * lattice.blockCells + 1;
            if (trial == 2)
                lattice.spacing = {1, 1.5, 0.7};
            const unsigned seed = 3 * static_cast<unsigned>(blockCells) + trial;
            const QString fault = type == "uint8"   ? faultOf<std::uint8_t>(lattice, seed, weighted)
                                  : type == "int16" ? faultOf<std::int16_t>(lattice, seed, weighted)
                                  : type == "float" ? faultOf<float>(lattice, seed, weighted)
                                                    : faultOf<double>(lattice, seed, weighted);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
    }

    /// One object used again gives what a new one gives, whatever it refined before.
    void memoryIsUsedAgain()
    {
        const Size size{20, 17, 14};
        const auto samples = values<std::uint8_t>(size, 4, false);
        LatticeRefiner refiner;
        for (const LatticeBox& box : {LatticeBox{{0, 0, 0}, {5, 4, 3}}, LatticeBox{{3, 2, 1}, {16, 15, 13}},
                                      LatticeBox{{0, 0, 0}, {9, 9, 9}}, LatticeBox{{11, 8, 5}, {9, 9, 9}}}) {
            LatticeBoxOptions options;
            options.latticeSize = size;
            options.box = box;
            options.valueExtent = 120;
            options.stopError = 3;
            RecordedHistory again, fresh, failed;
            failed.failAfter = 20;
            QVERIFY(!refiner.refine(options, LatticeSamples(std::span(samples)), failed).ok());
            QVERIFY(refiner.refine(options, LatticeSamples(std::span(samples)), again).ok());
            QVERIFY(LatticeRefiner().refine(options, LatticeSamples(std::span(samples)), fresh).ok());
            QCOMPARE(again.points, fresh.points);
            QCOMPARE(again.runningKeys, fresh.runningKeys);
            QCOMPARE(again.tetrahedra.size(), fresh.tetrahedra.size());
        }
    }

    /// R6: a weight multiplies the error of its point, and nothing else.
    void weightsScaleErrors()
    {
        const Size size{9, 9, 9};
        const auto samples = values<float>(size, 4, true);
        LatticeBoxOptions options;
        options.latticeSize = size;
        options.box.size = size;
        RecordedHistory plain, doubled;
        const std::vector<float> two(samples.size(), 2);
        QVERIFY(LatticeRefiner().refine(options, LatticeSamples(std::span(samples)), plain).ok());
        QVERIFY(LatticeRefiner().refine(options, LatticeSamples(std::span(samples), two), doubled).ok());
        QCOMPARE(doubled.points, plain.points);
        for (std::size_t site = 8; site < plain.points.size(); ++site)
            QCOMPARE(doubled.runningKeys[site], 2 * plain.runningKeys[site]);

        // Where the weight is 0 nothing is refined for its own sake.
        std::vector<float> half(samples.size(), 1);
        for (std::size_t point = 0; point < half.size(); ++point)
            half[point] = point % 9 < 5 ? 0.0f : 1.0f;
        RecordedHistory onOneSide;
        QVERIFY(LatticeRefiner().refine(options, LatticeSamples(std::span(samples), half), onOneSide).ok());
        QCOMPARE(std::ranges::count_if(onOneSide.points, [](std::uint64_t point) { return point % 9 < 5; }), 4);
    }

    void wrongBoxesAreRefused()
    {
        const std::vector<std::uint8_t> samples(1000);
        LatticeBoxOptions options;
        options.latticeSize = {10, 10, 10};
        for (const LatticeBox& box : {LatticeBox{{0, 0, 0}, {1, 5, 5}}, LatticeBox{{6, 0, 0}, {5, 5, 5}},
                                      LatticeBox{{0, 0xffffffff, 0}, {5, 5, 5}}}) {
            options.box = box;
            RecordedHistory history;
            const auto result = LatticeRefiner().refine(options, LatticeSamples(std::span(samples)), history);
            QVERIFY(!result.ok());
            QCOMPARE(result.error().kind, ErrorKind::WrongUsage);
        }
    }
};

QTEST_APPLESS_MAIN(LatticeBlocksTest)
#include "lattice_blocks_test.moc"
