// SPDX-License-Identifier: GPL-3.0-or-later
// What is written comes back (R13, R15); FORMAT.md tells the truth; what is no model, cut short, or of a later version
// is refused with a text that helps.
#include "core/history/model_writer.h"

#include "core/base/rounding.h"
#include "tests/core/base/small_disk.h"
#include "tests/core/history/model_fixture.h"

#include <tan/model.h>

#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <limits>
#include <map>

using namespace tetra;
using format::SectionId;

namespace {

template <class T> T valueAt(const std::vector<std::byte>& bytes, std::size_t offset)
{
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

} // namespace

class ModelFileTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void whatIsWrittenComesBack_data()
    {
        QTest::addColumn<SampleType>("type");
        for (int type = 0; type < 8; ++type)
            QTest::newRow(sampleTypeName(SampleType(type)).data()) << SampleType(type);
    }
    void whatIsWrittenComesBack()
    {
        QFETCH(SampleType, type);
        Dataset dataset = bumps(type, {4, 3, 5});
        dataset.source.valueName = isInteger(type) ? "" : "p = rho\n\\ R T";
        dataset.source.taken = {{TakenPart::Array, std::string("a = b\n"), true},
                                {TakenPart::Fill, std::string("-32767")}};
        dataset.source.leftOut = {Message::say("It holds %1 volumes.", 20), Message("The others\nare not read.")};
        const RecordedSteps& history = historyOf(dataset);
        writeModel(path(), dataset);
        const auto opened = Model::open(path());
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().text().c_str());
        const Model& model = **opened;

        const ModelDescription& description = model.description();
        QCOMPARE(description.lattice.size, dataset.lattice.size);
        QCOMPARE(description.lattice.spacing, dataset.lattice.spacing);
        QCOMPARE(description.lattice.origin, dataset.lattice.origin);
        QCOMPARE(description.sampleType, type);
        QCOMPARE(description.range.minimum, dataset.values.range().minimum);
        QCOMPARE(description.range.maximum, dataset.values.range().maximum);
        QCOMPARE(description.sourceName, dataset.source.name);
        QCOMPARE(description.sourceHash, dataset.source.hash);
        QCOMPARE(description.valueName, dataset.source.valueName);
        QVERIFY(description.taken == dataset.source.taken);
        QVERIFY(description.leftOut == dataset.source.leftOut);
        QCOMPARE(description.builder, std::string("slow"));
        QCOMPARE(description.parameters.size(), std::size_t(2));
        QCOMPARE(description.parameters[0], std::pair(std::string("stop=error"), std::string("0")));
        QCOMPARE(description.parameters[1], std::pair(std::string("note"), std::string("two\nlines \\n")));
        QCOMPARE(model.fileSize(), std::filesystem::file_size(path()));
        QCOMPARE(model.finalKey(), history.finalKey);
        QVERIFY(model.checkIntact().ok());
        compareSites(model, history, dataset);
        compareTetrahedra(model, history);
        QVERIFY(std::ranges::equal(model.samples(), dataset.values.bytes()));
    }

    /// The offsets of FORMAT.md, read by hand.
    void theFormatIsAsDocumented()
    {
        const Dataset dataset = bumps(SampleType::UInt8, {4, 3, 5});
        const RecordedSteps& history = historyOf(dataset);
        writeModel(path(), dataset);
        const std::vector<std::byte> bytes = readBytes(path());
        QCOMPARE(std::memcmp(bytes.data(), "\x89TAN\r\n\x1a\n", 8), 0);
        QCOMPARE(valueAt<std::uint16_t>(bytes, 8), std::uint16_t(1));
        QCOMPARE(valueAt<std::uint32_t>(bytes, 12), 0x01020304u);
        QCOMPARE(valueAt<std::uint32_t>(bytes, 16), 256u);
        QCOMPARE(valueAt<std::uint64_t>(bytes, 24), bytes.size());
        QCOMPARE(valueAt<std::uint32_t>(bytes, 40), 4u);
        QCOMPARE(valueAt<std::uint32_t>(bytes, 48), 5u);
        QCOMPARE(valueAt<std::uint32_t>(bytes, 52), std::uint32_t(history.steps.size()));
        QCOMPARE(valueAt<double>(bytes, 64), 0.5);
        QCOMPARE(valueAt<double>(bytes, 96), 10.0);
        QCOMPARE(valueAt<double>(bytes, 128 + 24), -3 + 3 * 0.5);
        QCOMPARE(valueAt<std::uint64_t>(bytes, 176), dataset.source.hash);
        QCOMPARE(valueAt<float>(bytes, 184), history.finalKey);
        const auto sectionCount = valueAt<std::uint32_t>(bytes, 20);
        QCOMPARE(sectionCount, 14u);
        QCOMPARE(valueAt<std::uint16_t>(bytes, 10), std::uint16_t(3));
        std::uint64_t end = 256 + 64 * sectionCount;
        for (std::uint32_t number = 0; number < sectionCount; ++number) {
            const auto offset = valueAt<std::uint64_t>(bytes, 256 + 64 * number + 16);
            QCOMPARE(offset % 64, std::uint64_t(0));
            QVERIFY(offset >= end);
            QVERIFY(std::all_of(bytes.begin() + std::ptrdiff_t(end), bytes.begin() + std::ptrdiff_t(offset),
                                [](std::byte byte) { return byte == std::byte{}; }));
            end = offset + valueAt<std::uint64_t>(bytes, 256 + 64 * number + 24);
        }
        QCOMPARE(end, bytes.size());
    }

    void aFileCutAnywhereIsRefused()
    {
        writeModel(path(), bumps(SampleType::UInt8, {4, 3, 5}));
        const std::vector<std::byte> bytes = readBytes(path());
        QVERIFY(!bytes.empty());
        for (std::size_t size = 0; size < bytes.size(); size += size < 1000 ? 1 : 37) {
            writeBytes(path(), std::span(bytes).first(size));
            const auto model = Model::open(path());
            QVERIFY(!model.ok());
            QCOMPARE(model.error().kind, ErrorKind::BadInput);
            const QString text = QString::fromStdString(model.error().text());
            if (size >= 8) {
                QVERIFY2(text.contains("is cut short: it has " + QString::number(size) + " bytes and should have"),
                         qPrintable(text));
                if (size >= 256)
                    QVERIFY(text.contains("should have " + QString::number(bytes.size()) + "."));
            }
        }
    }

    void whatCannotBeReadIsRefused_data();
    void whatCannotBeReadIsRefused();

    void optionalSectionsAreSkipped()
    {
        FileParts parts = parts_();
        parts.addSection(1000, 0);
        parts.repairChecksums();
        writeBytes(path(), parts.content);
        const auto model = Model::open(path());
        QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
        QCOMPARE(model.value()->points()[7], 59u);
    }

    void aWrongHistoryIsNotWritten_data();
    void aWrongHistoryIsNotWritten();

    void anUnfinishedModelLeavesNothing()
    {
        const Dataset dataset = bumps(SampleType::UInt8, {4, 3, 5});
        {
            auto writer = ModelWriter::create(path(), dataset, {});
            QVERIFY(writer.ok());
            for (std::uint32_t site = 0; site < 9; ++site) {
                const RecordedSteps::Step& step = historyOf(dataset).steps[site];
                QVERIFY(writer.value()->add({step.point, step.keyBefore, step.star, step.destroyed}).ok());
            }
            QCOMPARE(writer.value()->siteCount(), 9u);
            QVERIFY(writer.value()->tetrahedronCount() >= 6);
        }
        QVERIFY(std::filesystem::is_empty(path().parent_path()));
    }

    void aFullDiskIsReported()
    {
        const SmallDisk disk(4096 * 4);
        if (!disk.ok())
            QSKIP("skipped: a small disk needs the right to mount");
        const Dataset dataset = bumps(SampleType::UInt8, {7, 6, 8});
        auto writer = ModelWriter::create(disk.folder() / "model.tan", dataset, {});
        const Status written = replay(historyOf(dataset), **writer);
        QVERIFY(!written.ok());
        QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
        QVERIFY(QString::fromStdString(written.error().text()).contains("No space left on device"));
        QVERIFY(std::filesystem::is_empty(disk.folder()));
    }

private:
    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }

    FileParts parts_() const
    {
        writeModel(path(), bumps(SampleType::UInt8, {4, 3, 5}));
        return FileParts(readBytes(path()));
    }

    static void compareSites(const Model& model, const RecordedSteps& history, const Dataset& dataset);
    static void compareTetrahedra(const Model& model, const RecordedSteps& history);

    std::unique_ptr<QTemporaryDir> folder_;
};

/// Batch by batch: within one, sites are in the order of the file format and not in that of the history.
void ModelFileTest::compareSites(const Model& model, const RecordedSteps& history, const Dataset& dataset)
{
    QCOMPARE(std::size_t(model.siteCount()), history.steps.size());
    QCOMPARE(model.starOffsets().size(), history.steps.size() + 1);
    QCOMPARE(model.starOffsets().front(), std::uint64_t(0));
    QCOMPARE(model.starOffsets().back(), model.tetrahedronCount());
    const std::vector<std::uint32_t> historyPoints = history.points();
    float running = std::numeric_limits<float>::infinity();
    const ScalarField values(dataset.values.type(), model.siteCount(),
                             std::shared_ptr<const std::byte>(std::shared_ptr<void>(), model.values().data()));
    for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
        running = std::min(running, history.steps[site].keyBefore);
        QCOMPARE(model.runningKeys()[site], running);
        QCOMPARE(values.at(site), dataset.values.at(model.points()[site]));
        if (!endsBatch(model, site + 1))
            continue;
        QCOMPARE(model.groupGoesOn()[site], std::uint8_t(0));
        QCOMPARE(std::size_t(model.meshSizes()[site]), history.meshOf(site + 1).size());
        QVERIFY(std::is_permutation(historyPoints.begin(), historyPoints.begin() + site + 1, model.points().begin()));
    }
}

void ModelFileTest::compareTetrahedra(const Model& model, const RecordedSteps& history)
{
    const std::vector<std::uint32_t> historyPoints = history.points();
    std::map<std::array<std::uint64_t, 4>, float> ownErrors;
    for (std::uint32_t site = 0; site < history.steps.size(); ++site)
        for (const HistoryTetrahedron& made : history.steps[site].star) {
            const std::array<std::uint32_t, 4> sites = {site, made.sites[0], made.sites[1], made.sites[2]};
            ownErrors[byPoints({&sites, 1}, historyPoints)[0]] = made.error;
        }
    const double extent = model.description().range.extent();
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        for (std::uint64_t t = model.starOffsets()[site]; t < model.starOffsets()[site + 1]; ++t) {
            const auto& others = model.otherSites()[t];
            const std::array<std::uint32_t, 4> sites = {site, others[0], others[1], others[2]};
            const auto made = ownErrors.find(byPoints({&sites, 1}, model.points())[0]);
            QVERIFY(made != ownErrors.end());
            const double bound = model.ownError(t);
            QCOMPARE(bound, extent * static_cast<double>(halfToFloat(model.ownErrors()[t])));
            QCOMPARE(model.ownWarping(t), 0.0);
            QVERIFY(bound >= made->second && bound <= made->second * 1.002 + extent * 1e-7);
        }
    QVERIFY(model.tetrahedronCount() <= ownErrors.size());
    for (std::uint32_t sites = 8; sites <= model.siteCount(); ++sites) {
        if (!endsBatch(model, sites))
            continue;
        std::vector<std::array<std::uint32_t, 4>> alive;
        for (std::uint32_t site = 0; site < sites; ++site)
            for (std::uint64_t t = model.starOffsets()[site]; t < model.starOffsets()[site + 1]; ++t)
                if (const auto& others = model.otherSites()[t]; model.destroyers()[t] >= sites)
                    alive.push_back({site, others[0], others[1], others[2]});
        QVERIFY(byPoints(alive, model.points()) == byPoints(history.meshOf(sites), historyPoints));
    }
}

using Damage = void (*)(FileParts&);

void ModelFileTest::whatCannotBeReadIsRefused_data()
{
    QTest::addColumn<Damage>("damage");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, Damage damage, const char* says) {
        QTest::newRow(name) << damage << QString(says);
    };
    row(
        "magic", [](FileParts& f) { f.header().magic[4] = '\n'; }, "is not a TAn model");
    row(
        "later", [](FileParts& f) { f.header().majorVersion = 2; }, "version 2.3; this program reads up to version 1");
    row(
        "remedy", [](FileParts& f) { f.header().majorVersion = 300; }, "Install a later version of TAn");
    row(
        "byte order", [](FileParts& f) { f.header().byteOrderMark = 0x04030201; }, "the other byte order");
    row(
        "domain", [](FileParts& f) { f.header().domainClass = 2; }, "a lattice of 4 x 3 x 5 points is impossible");
    row(
        "far domain", [](FileParts& f) { f.header().domainClass = 77; }, "domain class 77, which this version cannot");
    row(
        "sample type", [](FileParts& f) { f.header().sampleType = 8; }, "samples of type 8, which this version cannot");
    row(
        "lattice",
        [](FileParts& f) {
            f.header().latticeSize = {1, 4, 4};
        },
        "1 x 4 x 4 points is impossible");
    row(
        "overflow", [](FileParts& f) { f.header().latticeSize.fill(0xffffffff); }, "points is impossible");
    row(
        "spacing", [](FileParts& f) { f.header().spacing[1] = -1; }, "the spacing or the origin");
    row(
        "origin", [](FileParts& f) { f.header().origin[1] = NAN; }, "the spacing or the origin");
    row(
        "box of another origin", [](FileParts& f) { f.header().origin[0] -= 1; }, "its bounding box is invalid");
    row(
        "box of another spacing", [](FileParts& f) { f.header().spacing[2] *= 2; }, "its bounding box is invalid");
    row(
        "box of other points", [](FileParts& f) { f.header().boundingBox[4] += 1; }, "its bounding box is invalid");
    row(
        "range",
        [](FileParts& f) {
            f.header().valueRange = {2, 1};
        },
        "its value range");
    row(
        "final error", [](FileParts& f) { f.header().finalKey = NAN; }, "its final error");
    row(
        "no sites", [](FileParts& f) { f.header().siteCount = 0; }, "cannot have 0 sites");
    row(
        "many sites", [](FileParts& f) { f.header().siteCount = 61; }, "cannot have 61 sites");
    row(
        "fewer sites", [](FileParts& f) { --f.header().siteCount; }, "section 'site points' has");
    row(
        "tetrahedra", [](FileParts& f) { ++f.header().tetrahedronCount; }, "section 'other sites' has");
    row(
        "many", [](FileParts& f) { f.header().tetrahedronCount = 0x1555555555555557; }, "section 'other sites' has");
    row(
        "longer", [](FileParts& f) { f.content.push_back({}); }, "bytes and should have");
    row(
        "sections", [](FileParts& f) { f.header().sectionCount = 5000; }, "its header is invalid");
    row(
        "frame", [](FileParts& f) { f.addSection(9, format::required); }, "section 'frame'");
    row(
        "metric", [](FileParts& f) { f.addSection(10, format::required); }, "section 'metric'");
    row(
        "required", [](FileParts& f) { f.addSection(1000, format::required); }, "needs section 1000, which this");
    row(
        "twice", [](FileParts& f) { f.addSection(32, 0); }, "section 'other sites' appears twice");
    row(
        "missing", [](FileParts& f) { f.section(SectionId::Destroyers).id = 999, f.section(SectionId(999)).flags = 0; },
        "section 'destroyers' is missing");
    row(
        "codec", [](FileParts& f) { f.section(SectionId::OwnErrors).codec = 3; },
        "packs its section 'own errors' with codec 3");
    row(
        "misaligned", [](FileParts& f) { f.section(SectionId::OwnErrors).offset += 4; }, "cannot begin at byte");
    row(
        "overlap", [](FileParts& f) { f.section(SectionId::Destroyers).offset -= 64; }, "cannot begin at byte");
    row(
        "far", [](FileParts& f) { f.section(SectionId::ChunkSums).offset += 64; }, "reaches beyond the end");
    row(
        "wraps", [](FileParts& f) { f.section(SectionId::OwnErrors).bytes = ~0ull - 63; }, "reaches beyond the end");
    row(
        "short last", [](FileParts& f) { f.section(SectionId::ChunkSums).bytes -= 8; }, "its last section ends");
    row(
        "samples", [](FileParts& f) { f.section(SectionId::Samples).elementBytes = 2; }, "section 'samples' has");
    row(
        "element", [](FileParts& f) { f.section(SectionId::MeshSizes).elementBytes = 2; }, "'mesh sizes' has");
}

void ModelFileTest::whatCannotBeReadIsRefused()
{
    QFETCH(Damage, damage);
    QFETCH(QString, says);
    FileParts parts = parts_();
    damage(parts);
    if (parts.header().sectionCount < 100)
        parts.repairChecksums();
    writeBytes(path(), parts.content);
    const auto model = Model::open(path());
    QVERIFY(!model.ok());
    QCOMPARE(model.error().kind, ErrorKind::BadInput);
    const QString text = QString::fromStdString(model.error().text());
    QVERIFY2(text.contains(says) && text.startsWith("'"), qPrintable(text));
}

using Mistake = void (*)(RecordedSteps&);

void ModelFileTest::aWrongHistoryIsNotWritten_data()
{
    QTest::addColumn<Mistake>("mistake");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, Mistake mistake, const char* says) {
        QTest::newRow(name) << mistake << QString(says);
    };
    row(
        "point", [](RecordedSteps& h) { h.steps[9].point = 60; }, "wrong at site 9: point 60 is not in the dataset");
    row(
        "order", [](RecordedSteps& h) { h.steps[9].star[0].sites[1] = 9; }, "a site that comes after it");
    row(
        "own error", [](RecordedSteps& h) { h.steps[9].star[0].error = NAN; },
        "an error or a warping that is not a number");
    row(
        "error", [](RecordedSteps& h) { h.steps[9].keyBefore = -1; }, "the error before it is not a number");
    row(
        "unborn", [](RecordedSteps& h) { h.steps[8].destroyed[0] = 99; }, "tetrahedron 99, which is not in the mesh");
    row(
        "dead", [](RecordedSteps& h) { h.steps[9].destroyed = h.steps[8].destroyed; }, "which is not in the mesh");
    row(
        "dead now", [](RecordedSteps& h) { h.steps[8].destroyed.push_back(h.steps[8].destroyed[0]); },
        "wrong at site 8: it destroys tetrahedron");
    row(
        "site twice", [](RecordedSteps& h) { h.steps[9].star[0].sites[1] = h.steps[9].star[0].sites[0]; },
        "wrong at site 9: a tetrahedron of its star has a site twice");
    row(
        "few", [](RecordedSteps& h) { h.steps.resize(7); }, "needs at least the sites of its first mesh");
    row(
        "final", [](RecordedSteps& h) { h.finalKey = INFINITY; }, "the final error is not a number");
    row(
        "blocks",
        [](RecordedSteps& h) {
            h.traits.blockCells = {4, 0, 4};
        },
        "wrong at site 0: its blocks have 4 x 0 x 4 cells");
}

void ModelFileTest::aWrongHistoryIsNotWritten()
{
    QFETCH(Mistake, mistake);
    QFETCH(QString, says);
    const Dataset dataset = bumps(SampleType::UInt8, {4, 3, 5});
    RecordedSteps history = historyOf(dataset);
    mistake(history);
    ModelDescription description;
    description.builder = "careless";
    const std::filesystem::path target = folder_->filePath("wrong.tan").toStdString();
    auto writer = ModelWriter::create(target, dataset, description);
    const Status written = replay(history, **writer);
    const QString text = QString::fromStdString(written ? "written" : written.error().text());
    QVERIFY2(text.startsWith("The builder 'careless'") && text.contains(says), qPrintable(text));
    QVERIFY(!std::filesystem::exists(target));
}

QTEST_GUILESS_MAIN(ModelFileTest)
#include "model_file_test.moc"
