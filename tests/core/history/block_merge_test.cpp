// SPDX-License-Identifier: GPL-3.0-or-later
// Groups too large to be held as a whole are merged in slices (B6): the model is the same. A block that fails ends all.
#include "core/base/checksum.h"
#include "core/history/blocks/block_runs.h"
#include "core/history/blocks/merged_model.h"
#include "core/refine/lattice/packed_lattice.h"

#include <QTemporaryDir>
#include <QTest>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <random>
#include <span>
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
        QVERIFY(runs.openOwn(false).ok());
        const Status made = makeRuns(dataset, division, runs);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().text().c_str());
        const std::vector<char> whole = merged(dataset, runs, usualSliceTetrahedra);
        QVERIFY(!whole.empty());
        QCOMPARE(slicesOf(runs, usualSliceTetrahedra), 0);
        for (const std::uint64_t limit : {1, 7, 40, 400}) {
            QVERIFY2(slicesOf(runs, limit) >= 2, QByteArray::number(quint64(limit)));
            QVERIFY2(merged(dataset, runs, limit) == whole, QByteArray::number(quint64(limit)));
        }
    }

    void theFirstFailureStopsAllBlocks_data()
    {
        QTest::addColumn<bool>("throws");
        QTest::addColumn<QString>("says");
        QTest::newRow("an error") << false << "it changed";
        QTest::newRow("no memory") << true << "Not enough memory";
    }
    /// One block is done at once, and then something is wrong; the other one, begun before, would take seconds.
    void theFirstFailureStopsAllBlocks()
    {
        QFETCH(bool, throws);
        QFETCH(QString, says);
        constexpr std::uint32_t cells = 64;
        const std::array<std::uint32_t, 3> size = {2 * cells + 1, cells + 1, cells + 1};
        std::mt19937 random(5);
        std::vector<std::uint16_t> values(std::size_t(size[0]) * size[1] * size[2]);
        for (std::size_t point = 0; point < values.size(); ++point)
            values[point] = point % size[0] > cells ? static_cast<std::uint16_t>(random()) : std::uint16_t(0);
        LatticeRunsOptions options;
        options.division = BlockDivision(size, cells);
        QCOMPARE(options.division.count(), 2u);
        options.box.latticeSize = size;
        options.box.metric = latticeMetric(options.division.box(0).size, {1, 1, 1}).value();
        options.box.valueExtent = 65535;
        std::atomic<int> finished = 0;
        options.samplesIntact = [&]() -> Status {
            ++finished;
            if (throws)
                throw std::bad_alloc();
            return Error{ErrorKind::BadInput, "it changed"};
        };
        RunFiles runs(folder(), 1, 2);
        QVERIFY(runs.openOwn(false).ok());
        const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 2);
        tbb::task_arena arena(2);
        const Status made = arena.execute(
            [&] { return makeLatticeRuns(options, LatticeSamples(std::span<const std::uint16_t>(values)), runs, {}); });
        QVERIFY(!made.ok());
        QVERIFY2(QString::fromStdString(made.error().text()).contains(says), made.error().text().c_str());
        QCOMPARE(finished, 1);
    }

    /// Mesh sizes are numbers of 32 bits in the file.
    void meshesOfTooManyTetrahedraAreRefused()
    {
        const Dataset dataset = fewValues(1);
        const BlockDivision division(dataset.lattice.size, cellsOfBlock);
        {
            RunFiles runs(folder(), 1, division.count());
            QVERIFY(runs.openOwn(false).ok());
            QVERIFY(makeRuns(dataset, division, runs).ok());
            QVERIFY(!merged(dataset, runs, usualSliceTetrahedra).empty());
        }
        const std::filesystem::path path = folder() / "blocks.runs";
        const std::vector<char> right = contentOf(path);
        // What the first groups of two blocks made, and then what all of three blocks came to.
        constexpr std::size_t firstGroupsTetrahedra = sizeof(BlockRunHeader) + 3 * sizeof(std::uint32_t);
        std::vector<char> wrongBytes = right;
        forRunsOf(wrongBytes, 2,
                  [](std::span<char> run) { put(run, firstGroupsTetrahedra, std::uint32_t(3'000'000'000)); });
        write(path, wrongBytes);
        RunFiles wrong(folder(), 1, division.count());
        QVERIFY(wrong.openOwn(true).ok());
        QVERIFY(wrong.checkComplete().ok());
        ChunkMaker maker(wrong);
        auto chunk = maker.next();
        while (chunk && !chunk->points.empty())
            chunk = maker.next();
        QVERIFY(!chunk.ok());
        QCOMPARE(chunk.error().kind, ErrorKind::OutOfResource);

        wrongBytes = right;
        forRunsOf(wrongBytes, 3, [](std::span<char> run) {
            put(run, offsetof(BlockRunHeader, livingCount), std::uint64_t(1'500'000'000));
        });
        write(path, wrongBytes);
        const ModelFileOpener open = [](const FixedCounts&) -> Result<std::unique_ptr<ModelFileWriter>> {
            return Error{ErrorKind::CannotWrite, "The model was begun."};
        };
        RunFiles many(folder(), 1, division.count());
        QVERIFY(many.openOwn(true).ok());
        const auto refused = mergeRuns(many, folder(), open, {});
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
        QVERIFY2(refused.error().text().find("a model holds meshes of at most 4294967295") != std::string::npos,
                 refused.error().text().c_str());
    }

    void howManyTetrahedraAMeshMayHave_data()
    {
        QTest::addColumn<quint64>("soFar");
        QTest::addColumn<quint64>("expected");
        QTest::addColumn<bool>("fits");
        QTest::newRow("few") << quint64(1000) << quint64(1000) << true;
        QTest::newRow("as many as there may be") << quint64(0xffffffff) << quint64(0xffffffff) << true;
        QTest::newRow("one more") << quint64(0x100000000) << quint64(0x100000000) << false;
        QTest::newRow("perhaps") << quint64(1000) << quint64(4'800'000'000) << true;
        QTest::newRow("certainly") << quint64(1000) << quint64(6'400'000'000) << false;
    }
    void howManyTetrahedraAMeshMayHave()
    {
        QFETCH(quint64, soFar);
        QFETCH(quint64, expected);
        QTEST(checkMeshSize(soFar, expected).ok(), "fits");
    }

    /// Every block is in one part, and no part has two blocks more than another.
    void sharesCoverAllBlocksOnce()
    {
        std::mt19937 random(4);
        for (int round = 0; round < 200; ++round) {
            const std::uint32_t blocks = random() % (round % 2 == 0 ? 40 : 4'000'000'000u);
            const std::uint32_t count = 1 + random() % 60;
            std::uint32_t end = 0, fewest = blocks, most = 0;
            for (std::uint32_t number = 1; number <= count; ++number) {
                const BlockShare share = shareOf({number, count}, blocks);
                QCOMPARE(share.first, end);
                end = share.end;
                fewest = std::min(fewest, share.end - share.first);
                most = std::max(most, share.end - share.first);
            }
            QCOMPARE(end, blocks);
            QVERIFY(most - fewest <= 1);
        }
    }

private:
    template <class Number> static void put(std::span<char> bytes, std::size_t offset, const Number& number)
    {
        std::memcpy(bytes.data() + offset, &number, sizeof number);
    }

    /// Calls change() with the first runs of a file, whose sums are right afterwards.
    template <class Change> static void forRunsOf(std::vector<char>& file, int runs, const Change& change)
    {
        constexpr std::size_t fileHeader = 16;
        std::size_t offset = fileHeader;
        for (int number = 0; number < runs; ++number) {
            BlockRunHeader header;
            std::memcpy(&header, file.data() + offset, sizeof header);
            const std::span<char> run(file.data() + offset, runBytes(header));
            change(run);
            std::memcpy(&header, run.data(), sizeof header);
            const std::array<std::span<const std::byte>, 1> content{std::as_bytes(run.subspan(sizeof header))};
            header.checksum = runChecksum(header, content);
            put(run, 0, header);
            offset += run.size();
        }
    }

    static void write(const std::filesystem::path& path, const std::vector<char>& bytes)
    {
        std::ofstream stream(path, std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }

    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    static Status makeRuns(const Dataset& dataset, const BlockDivision& division, RunFiles& runs)
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
        const ModelFileOpener open = [&](const FixedCounts& counts) {
            return ModelFileWriter::create(path, dataset, {}, counts, folder());
        };
        const auto counts = mergeRuns(runs, folder(), open, {}, sliceTetrahedra);
        if (!counts)
            qWarning("%s", counts.error().text().c_str());
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
