// SPDX-License-Identifier: GPL-3.0-or-later
// The `.tan` file of irregular data and of decimated lattices: what it holds, and what of a wrong one opening finds.
#include "core/history/model_writer.h"
#include "tests/core/history/irregular/irregular_models.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <numeric>

using namespace tetra;
using format::SectionId;

namespace {

using Damage = std::function<void(FileParts&)>;

std::string refusalOf(const std::filesystem::path& path)
{
    const auto model = Model::open(path);
    return model ? std::string() : model.error().text();
}

/// Gives a section another name, under which nobody knows it.
void rename(FileParts& parts, SectionId id, std::uint32_t name, std::uint32_t flags)
{
    format::Section& section = parts.section(id);
    section.id = name;
    section.flags = flags;
}

} // namespace

class IrregularModelTest : public QObject {
    Q_OBJECT

private slots:
    void holdsWhatIrregularDataAre()
    {
        for (const std::uint32_t seed : {3U, 4U, 5U}) { // floats hold the positions of the first alone
            const Dataset dataset = randomIrregular(seed);
            const RecordedSteps history = decimated(dataset);
            const auto model = modelOf(path(), dataset, history);
            const ModelDescription& about = model->description();
            QCOMPARE(about.domain, DomainClass::Irregular);
            QVERIFY(!about.delaunay);
            QCOMPARE(about.warpingWeight, history.traits.warpingWeight);
            QCOMPARE(about.sourceHash, contentHash(dataset.values, dataset.positions, dataset.tetrahedra));
            QVERIFY(about.sourceHash != contentHash(dataset.values, dataset.positions));
            QCOMPARE(about.lattice.size[0], std::uint32_t(dataset.pointCount()));
            QVERIFY(about.lattice.size[1] == 1 && about.lattice.size[2] == 1);
            QVERIFY(model->samples().empty() && model->floatSamplePositions().empty());
            QCOMPARE(model->ownWarpings().size(), model->tetrahedronCount());
            QCOMPARE(std::uint64_t(model->siteCount()), dataset.pointCount());
            QCOMPARE(std::size_t(model->meshSizes().back()), dataset.tetrahedra->size());
            QCOMPARE(model->floatPositions().empty(), seed != 3);
            for (std::uint32_t site = 0; site < model->siteCount(); ++site)
                QVERIFY(model->position(site) == dataset.position(model->points()[site]));
            QVERIFY(byPoints(extractPrefix(*model, model->siteCount())->tetrahedra, model->points()) ==
                    byPoints(*dataset.tetrahedra, allPoints(dataset)));
        }
    }

    void decimatedLatticesSayThatTheyAreNotDelaunay()
    {
        const Dataset lattice = bumps(SampleType::UInt8, {4, 5, 4});
        QVERIFY(!modelOf(path(), lattice, decimatedGrid(lattice))->description().delaunay);
        FileParts parts(readBytes(path()));
        QCOMPARE(parts.section(SectionId::HistoryKind).flags, format::required);
        QCOMPARE(parts.elements<std::uint32_t>(SectionId::HistoryKind)[0], 1U);
        writeModel(path(), lattice);
        QVERIFY(Model::open(path()).value()->description().delaunay);
    }

    void wrongFilesAreRefused_data()
    {
        QTest::addColumn<Damage>("damage");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const Damage& damage, const char* says) {
            QTest::newRow(name) << damage << QString(says);
        };
        row(
            "no kind", [](FileParts& p) { rename(p, SectionId::HistoryKind, 900, 0); },
            "section 'history kind' is missing");
        row(
            "a kind that is not known", [](FileParts& p) { rename(p, SectionId::HistoryKind, 900, format::required); },
            "needs section 900, which this version does not know");
        row(
            "another kind", [](FileParts& p) { p.elements<std::uint32_t>(SectionId::HistoryKind)[0] = 2; },
            "has a history of kind 2, which this version cannot read");
        row(
            "kinds of another size", [](FileParts& p) { p.section(SectionId::HistoryKind).elementBytes = 2; },
            "section 'history kind' has 4 bytes in elements of 2 instead of 1 elements of 4");
        row(
            "no warpings", [](FileParts& p) { rename(p, SectionId::OwnWarpings, 900, 0); },
            "section 'own warpings' is missing");
        row(
            "no positions", [](FileParts& p) { rename(p, SectionId::SitePositions, 900, 0); },
            "section 'site positions' is missing");
        row(
            "no weight", [](FileParts& p) { p.header().warpingWeight = 0; }, "warping weight");
        row(
            "left-handed", [](FileParts& p) { p.header().leftHanded = 1; }, "handedness");
        row(
            "a lattice", [](FileParts& p) { p.header().latticeSize[1] = 2; }, "points is impossible");
        row(
            "three sites", [](FileParts& p) { p.header().siteCount = 3; }, "cannot have 3 sites");
        row(
            "more sites than points", [](FileParts& p) { p.header().latticeSize[0] = p.header().siteCount - 1; },
            "points cannot have");
        row(
            "unknown domain", [](FileParts& p) { p.header().domainClass = 4; }, "is a model of domain class 4");
    }
    void wrongFilesAreRefused()
    {
        QFETCH(Damage, damage);
        QFETCH(QString, says);
        const Dataset dataset = randomIrregular(4);
        modelOf(path(), dataset, decimated(dataset));
        FileParts parts(readBytes(path()));
        damage(parts);
        parts.repairChecksums();
        writeBytes(path(), parts.content);
        const QString refusal = QString::fromStdString(refusalOf(path()));
        QVERIFY2(refusal.contains(says), qPrintable(refusal));
    }

    /// The kind is so short that opening sums it up.
    void aBitOfTheKindIsMissed()
    {
        const Dataset dataset = randomIrregular(4);
        modelOf(path(), dataset, decimated(dataset));
        FileParts parts(readBytes(path()));
        parts.elements<std::uint32_t>(SectionId::HistoryKind)[0] = 3;
        writeBytes(path(), parts.content);
        QVERIFY(refusalOf(path()).find("the checksum of its history kind is wrong") != std::string::npos);
    }

    /// Builders are written by others.
    void wrongHistoriesAreRefused()
    {
        const Dataset dataset = randomIrregular(4);
        const RecordedSteps history = decimated(dataset);
        const auto refusal = [&](const HistoryTraits& traits, bool begins) {
            auto writer = ModelWriter::create(path(), dataset, {});
            if (begins)
                if (const Status begun = (*writer)->begin(traits); !begun)
                    return begun.error().text();
            const auto& first = history.steps.front();
            const Status added = (*writer)->add({first.point, first.keyBefore, first.star, first.destroyed});
            return added ? std::string() : added.error().text();
        };
        QVERIFY(refusal({1, true}, true).find("not Delaunay") != std::string::npos);
        QVERIFY(refusal({0, false}, true).find("warping weight") != std::string::npos);
        QVERIFY(refusal({}, false).find("irregular data need a warping weight") != std::string::npos);
        QCOMPARE(refusal({1, false}, true), std::string());
    }

private:
    static std::vector<std::uint32_t> allPoints(const Dataset& dataset)
    {
        std::vector<std::uint32_t> points(dataset.pointCount());
        std::iota(points.begin(), points.end(), 0U);
        return points;
    }
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(IrregularModelTest)
#include "irregular_model_test.moc"
