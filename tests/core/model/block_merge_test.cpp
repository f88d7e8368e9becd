// SPDX-License-Identifier: GPL-3.0-or-later
// Groups too large to be held as a whole are merged in slices (B6): the model is the same.
#include "core/base/checksum.h"
#include "core/mesh/lattice_metric.h"
#include "core/model/blocks/lattice_runs.h"
#include "core/model/blocks/merged_model.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <fstream>
#include <memory>
#include <random>
#include <vector>

using namespace tetra;

namespace {

constexpr std::uint32_t pointsOnEdge = 15;
constexpr std::uint32_t cellsOfBlock = 5;

/// Few values, so that many points are equally wrong and share a batch.
Dataset fewValues(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const Lattice lattice{{pointsOnEdge, pointsOnEdge, pointsOnEdge}, {1, 1, 1}, {0, 0, 0}};
    const auto values = std::make_shared<std::vector<std::uint8_t>>(lattice.pointCount());
    for (std::uint8_t& value : *values)
        value = static_cast<std::uint8_t>(random() % 3);
    const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
    const ScalarField field(SampleType::UInt8, lattice.pointCount(), bytes);
    return {.lattice = lattice, .values = field, .source = {"few values", {}, checksum(field.bytes())}};
}

std::vector<char> contentOf(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

class BlockMergeTest : public QObject {
    Q_OBJECT

private slots:
    void slicesChangeNothing_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 3; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void slicesChangeNothing()
    {
        QFETCH(quint32, seed);
        const Dataset dataset = fewValues(seed);
        const BlockDivision division(dataset.lattice.size, cellsOfBlock);
        RunFiles runs(folder(), seed, division.count());
        const Status made = makeRuns(dataset, division, runs);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().text.c_str());
        const std::vector<char> whole = merged(dataset, runs, usualSliceTetrahedra);
        QVERIFY(!whole.empty());
        QCOMPARE(slicesOf(runs, usualSliceTetrahedra), 0);
        for (const std::uint64_t limit : {1, 7, 40, 400}) {
            QVERIFY2(slicesOf(runs, limit) >= 2, QByteArray::number(quint64(limit)));
            QVERIFY2(merged(dataset, runs, limit) == whole, QByteArray::number(quint64(limit)));
        }
    }

private:
    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    static Status makeRuns(const Dataset& dataset, const BlockDivision& division, const RunFiles& runs)
    {
        LatticeRunsOptions options;
        options.division = division;
        options.box.latticeSize = dataset.lattice.size;
        const auto metric = latticeMetric(division.box(0).size, dataset.lattice.spacing);
        if (!metric)
            return metric.error();
        options.box.metric = *metric;
        options.box.valueExtent = dataset.values.range().extent();
        return makeLatticeRuns(options, LatticeSamples(dataset.values.as<std::uint8_t>(), {}), runs, {});
    }

    /// The bytes of the model; none if it failed.
    std::vector<char> merged(const Dataset& dataset, RunFiles& runs, std::uint64_t sliceTetrahedra) const
    {
        const std::filesystem::path path = folder() / "model.tan";
        const PlannedModelOpener open = [&](const PlannedCounts& counts) {
            return PlannedModelWriter::create(path, dataset, {}, counts, folder());
        };
        const auto counts = mergeRuns(runs, folder(), open, {}, sliceTetrahedra);
        if (!counts)
            qWarning("%s", counts.error().text.c_str());
        return counts ? contentOf(path) : std::vector<char>();
    }

    static int slicesOf(const RunFiles& runs, std::uint64_t sliceTetrahedra)
    {
        ChunkMaker maker(runs, sliceTetrahedra);
        int slices = 0;
        for (auto chunk = maker.next(); chunk && !chunk->points.empty(); chunk = maker.next())
            slices += chunk->slice ? 1 : 0;
        return slices;
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(BlockMergeTest)
#include "block_merge_test.moc"
