// SPDX-License-Identifier: GPL-3.0-or-later
// The beginning of a model as a model of its own (C16, FORMAT.md): the same meshes, proved against the data, with no
// more read than was announced, and nothing taken on trust.
#include "core/history/prefix_copy.h"
#include "tests/core/history/irregular/irregular_models.h"

#include <tan/build.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <random>

using namespace tetra;
using format::SectionId;

namespace {

Dataset folded()
{
    Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 5});
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(*dataset.positions);
    (*positions)[dataset.lattice.index(2, 1, 2)] += Eigen::Vector3d(0, 0, -4);
    dataset.positions = positions;
    dataset.source.hash = contentHash(dataset.values, dataset.positions);
    return dataset;
}

Dataset scattered()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 10);
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    auto values = std::make_shared<std::vector<float>>();
    for (int point = 0; point < 200; ++point) {
        const Eigen::Vector3d& p = positions->emplace_back(place(random), place(random), place(random));
        values->push_back(static_cast<float>(std::sin(p.x()) + p.y() * p.z()));
    }
    Dataset dataset;
    dataset.domain = DomainClass::Scattered;
    dataset.lattice.size = {200, 1, 1};
    dataset.positions = positions;
    dataset.values =
        ScalarField(SampleType::Float32, values->size(), {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.source.hash = contentHash(dataset.values, dataset.positions);
    return dataset;
}

struct Kind {
    const char* name;
    Dataset dataset;
    std::uint32_t block = 0;
    bool twoSided = false;
};

const std::vector<Kind>& kinds()
{
    static const std::vector<Kind> all = {
        {"lattice", bumps(SampleType::UInt8, {7, 6, 8})},
        {"lattice in blocks", bumps(SampleType::Float32, {10, 5, 9}), 4},
        {"grid", bentBumps(SampleType::Float32, {7, 5, 6})},
        {"grid in blocks", bentBumps(SampleType::Int16, {9, 5, 6}, true, true), 3},
        {"grid with faults", folded()},
        {"scattered", scattered()},
        {"irregular", withFaultyCells(randomIrregular(3))},
        {"irregular, two-sided", randomIrregular(4), 0, true},
    };
    return all;
}

/// A file that tells what was asked of it, and refuses what was not announced.
struct Watched {
    std::vector<std::byte> bytes;
    std::vector<ByteRange> announced{};
    std::uint64_t announcedBytes = 0;
    int fetches = 0;
    bool strayed = false;

    ByteSource source()
    {
        announced = {{0, 16384}};
        return {bytes.size(),
                [this](std::uint64_t offset, std::span<std::byte> to, const Progress&) -> Status {
                    strayed |= std::ranges::none_of(announced, [&](const ByteRange& range) {
                        return offset >= range.offset && offset + to.size() <= range.offset + range.size;
                    });
                    std::ranges::copy(std::span(bytes).subspan(offset, to.size()), to.begin());
                    return {};
                },
                [this](std::span<const ByteRange> ranges, const Progress&) -> Status {
                    ++fetches;
                    announced.insert(announced.end(), ranges.begin(), ranges.end());
                    for (const ByteRange& range : ranges)
                        announcedBytes += range.size;
                    return {};
                }};
    }
};

bool sameMesh(const Model& one, const Model& other, std::uint32_t sites)
{
    const auto first = extractPrefix(one, sites), second = extractPrefix(other, sites);
    return first && second && first->tetrahedra == second->tetrahedra && first->positions == second->positions &&
           first->values == second->values;
}

} // namespace

class PrefixCopyTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(!kinds().empty());
        for (const Kind& kind : kinds()) {
            if (kind.dataset.domain == DomainClass::Irregular) {
                modelOf(path(kind.name), kind.dataset, decimated(kind.dataset, {}, kind.twoSided),
                        {{"distance", kind.twoSided ? "two-sided" : ""}});
                continue;
            }
            const auto report = buildModel(kind.dataset, path(kind.name), Refinement{.block = kind.block});
            QVERIFY2(report.ok(), report.ok() ? "" : report.error().text().c_str());
        }
    }

    void prefixesAreModels_data()
    {
        QTest::addColumn<int>("kind");
        for (std::size_t kind = 0; kind < kinds().size(); ++kind)
            QTest::newRow(kinds()[kind].name) << int(kind);
    }
    void prefixesAreModels()
    {
        QFETCH(int, kind);
        const auto& [name, dataset, block, twoSided] = kinds()[std::size_t(kind)];
        // Chunks of 64 bytes show what is read.
        FileParts parts(readBytes(path(name)));
        parts.setChunkBytes(64);
        writeBytes(path(name), parts.content);
        const auto model = Model::open(path(name));
        QVERIFY(model.ok());
        Watched watched{parts.content};
        const ByteSource source = watched.source();
        const auto front = readFront(source, name);
        QVERIFY2(front.ok(), front.ok() ? "" : front.error().text().c_str());
        QVERIFY(!watched.strayed && front->levels.size() > 3);
        QCOMPARE(front->description.sourceHash, dataset.source.hash);
        for (const format::LevelEntry& level : front->levels) {
            const PrefixEnd end{level.sites, level.created, level.key};
            QVERIFY2(copyPrefix(source, name, *front, end, path("prefix")).ok(), name);
            QVERIFY(!watched.strayed);
            if (level.sites == (*model)->siteCount()) {
                QVERIFY(readBytes(path("prefix")) == parts.content);
                continue;
            }
            const auto prefix = Model::open(path("prefix"));
            QVERIFY2(prefix.ok(), prefix.ok() ? "" : prefix.error().text().c_str());
            QCOMPARE((*prefix)->siteCount(), level.sites);
            QCOMPARE((*prefix)->tetrahedronCount(), level.created);
            for (const format::LevelEntry& coarser : front->levels)
                if (coarser.sites <= level.sites)
                    QVERIFY(sameMesh(**model, **prefix, coarser.sites));
            const auto size = meshSizeAt(**model, {50, 50}), ofPrefix = meshSizeAt(**prefix, {50, 50});
            QCOMPARE(ofPrefix.sites, std::min(size.sites, level.sites));
            // Far fewer bytes at first, and its levels are those of the original up to there.
            const auto again = readFront(*fileSource(path("prefix")), "prefix");
            QVERIFY(again.ok());
            const auto last = std::ranges::find(front->levels, level.sites, &format::LevelEntry::sites);
            QCOMPARE(std::ptrdiff_t(again->levels.size()), last - front->levels.begin() + 1);
            for (std::size_t number = 0; number < again->levels.size(); ++number) {
                QCOMPARE(again->levels[number].sites, front->levels[number].sites);
                QCOMPARE(again->levels[number].error, front->levels[number].error);
                QCOMPARE(again->levels[number].warping, front->levels[number].warping);
            }
            const auto verdict = verify(**prefix, dataset, {{.error = 40, .warping = 40}, {.error = 0, .warping = 0}});
            QVERIFY(verdict.ok());
            for (const std::string& failure : verdict->failures)
                QFAIL(failure.c_str());
            for (const LevelReport& report : verdict->levels)
                for (const std::string& failure : report.failures)
                    QFAIL(failure.c_str());
        }
    }

    /// Of a model built to an accuracy asked for; a file on this disk is cut to a batch.
    void accuracyAskedForIsKept()
    {
        const char* const name = "grid";
        const auto model = Model::open(path(name));
        const auto front = readFront(*fileSource(path(name)), name);
        QVERIFY(model.ok() && front.ok());
        for (const double percent : {90.0, 30.0, 10.0, 3.0, 0.0}) {
            const Accuracy asked{percent, 2 * percent};
            const PrefixEnd byIndex = prefixFor(*front, asked), exact = prefixFor(**model, asked);
            QCOMPARE(exact.sites, meshSizeAt(**model, asked).sites);
            QVERIFY(byIndex.sites >= exact.sites);
            QVERIFY(copyPrefix(*fileSource(path(name)), name, *front, exact, path("cut")).ok());
            const auto cut = Model::open(path("cut"));
            QVERIFY(cut.ok());
            QCOMPARE(meshSizeAt(**cut, asked).sites, exact.sites);
            QVERIFY(sameMesh(**model, **cut, exact.sites));
        }
    }

    /// R28: so many bytes as a level takes are announced at once, and nothing is read besides.
    void readsWhatIsAnnounced()
    {
        const char* const name = "lattice";
        FileParts parts(readBytes(path(name)));
        parts.setChunkBytes(format::chunkBytes);
        // Sections far apart, as in a large file.
        Watched watched{parts.content};
        const ByteSource source = watched.source();
        const auto front = readFront(source, name);
        QVERIFY(front.ok());
        for (const std::uint64_t limit : {std::uint64_t(1), std::uint64_t(20'000), std::uint64_t(1) << 40}) {
            const PrefixEnd end = prefixWithin(*front, limit);
            std::uint64_t expected = 0;
            for (const ByteRange& range : prefixRanges(*front, end))
                expected += range.size;
            QVERIFY(expected <= limit || end.sites == front->levels.front().sites);
            watched.announcedBytes = 0;
            watched.fetches = 0;
            QVERIFY(copyPrefix(source, name, *front, end, path("prefix")).ok());
            QCOMPARE(watched.fetches, 1);
            QCOMPARE(watched.announcedBytes, expected);
            QVERIFY(!watched.strayed);
        }
    }

    /// A file without checksums of chunks is read in whole arrays.
    void olderFiles()
    {
        const char* const name = "lattice";
        FileParts parts(readBytes(path(name)));
        parts.removeChunkSums();
        Watched watched{parts.content};
        const ByteSource source = watched.source();
        const auto front = readFront(source, name);
        QVERIFY(front.ok());
        const format::LevelEntry& level = front->levels[front->levels.size() / 2];
        const PrefixEnd end{level.sites, level.created, level.key};
        QVERIFY(copyPrefix(source, name, *front, end, path("prefix")).ok());
        const auto model = Model::open(path(name)), prefix = Model::open(path("prefix"));
        QVERIFY(sameMesh(**model, **prefix, level.sites));
        parts.elements<std::uint32_t>(SectionId::MeshSizes).back() ^= 1; // behind the prefix, and summed up with it
        watched.bytes = parts.content;
        QVERIFY(!copyPrefix(source, name, *front, end, path("damaged")).ok());
    }

    /// Whatever a file says with the right checksums gives a model or an error, and no file with the error.
    void nothingIsTrusted()
    {
        std::mt19937 random(3);
        int refused = 0;
        for (const char* const name : {"lattice in blocks", "grid with faults", "irregular"}) {
            const std::vector<std::byte> bytes = readBytes(path(name));
            for (int round = 0; round < 400; ++round) {
                FileParts parts(bytes);
                const auto sections = parts.sections();
                const format::Section section = sections[random() % sections.size()];
                if (section.bytes < 4 || section.id == std::uint32_t(SectionId::ChunkSums))
                    continue;
                constexpr std::uint32_t evil[] = {0, 1, 7, 0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff, 0x7fc00000};
                const std::uint32_t number = evil[random() % std::size(evil)];
                std::memcpy(parts.content.data() + section.offset + random() % (section.bytes / 4) * 4, &number, 4);
                const bool isSummed = random() % 4 != 0;
                if (isSummed)
                    parts.repairChecksums();
                Watched watched{parts.content};
                const ByteSource source = watched.source();
                std::filesystem::remove(path("evil"));
                const auto front = readFront(source, name);
                if (!front) {
                    ++refused;
                    continue;
                }
                const format::LevelEntry& level = front->levels[random() % front->levels.size()];
                if (!copyPrefix(source, name, *front, {level.sites, level.created, level.key}, path("evil"))) {
                    ++refused;
                    QVERIFY(!std::filesystem::exists(path("evil")));
                    continue;
                }
                const auto model = Model::open(path("evil"));
                if (!model && level.sites == front->layout.header.siteCount)
                    continue; // the same file as it is
                QVERIFY2(model.ok(), model ? "" : model.error().text().c_str());
                (void)extractPrefix(**model, (*model)->siteCount());
            }
        }
        QVERIFY(refused > 200);
    }

private:
    std::filesystem::path path(const std::string& name) const
    {
        return folder_.filePath(QString::fromStdString(name + ".tan")).toStdString();
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(PrefixCopyTest)
#include "prefix_copy_test.moc"
