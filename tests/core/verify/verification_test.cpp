// SPDX-License-Identifier: GPL-3.0-or-later
// The checker (R2, R3, B3) proves right models right, and finds what is wrong with every kind of wrong one.

#include "core/base/checksum.h"
#include "tests/core/history/model_fixture.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace tetra;
using format::SectionId;

namespace {

using Others = std::array<std::uint32_t, 3>;

QString textOf(const VerificationReport& verdict)
{
    QStringList texts;
    for (const std::string& text : verdict.failures)
        texts << QString::fromStdString(text);
    for (const LevelReport& level : verdict.levels)
        for (const std::string& text : level.failures)
            texts << QString::number(level.asked.error) + " %: " + QString::fromStdString(text);
    return texts.join('\n');
}

/// A tetrahedron that is alive at the end.
std::size_t livingTetrahedron(FileParts& parts)
{
    const auto destroyers = parts.elements<std::uint32_t>(SectionId::Destroyers);
    return std::size_t(std::ranges::find(destroyers, Model::never) - destroyers.begin());
}

/// A site after the initial ones whose group goes on and which made a tetrahedron.
std::size_t firstGroup(FileParts& parts)
{
    const auto goesOn = parts.elements<std::uint8_t>(SectionId::SiteGroups);
    const auto offsets = parts.elements<std::uint64_t>(SectionId::StarOffsets);
    std::size_t site = 8;
    while (goesOn[site] == 0 || offsets[site] == offsets[site + 1])
        ++site;
    return site;
}

} // namespace

class VerificationTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        writeModel(path(), dataset_);
        bytes_ = readBytes(path());
    }

    void aRightModelIsRight_data()
    {
        QTest::addColumn<SampleType>("type");
        for (int type = 0; type < 8; ++type)
            QTest::newRow(sampleTypeName(SampleType(type)).data()) << SampleType(type);
    }
    void aRightModelIsRight()
    {
        QFETCH(SampleType, type);
        const Dataset dataset = bumps(type, {5, 4, 6});
        const std::filesystem::path other = folder_.filePath("right.tan").toStdString();
        writeModel(other, dataset);
        const auto model = Model::open(other);
        const std::vector<Accuracy> levels = {{50}, {10}, {5}, {2}, {1}, {0.5}, {0}};
        const auto verdict = verify(**model, dataset, levels);
        QVERIFY(verdict.ok());
        QVERIFY2(verdict->ok(), qPrintable(textOf(*verdict)));
        QCOMPARE(verdict->levels.size(), levels.size());
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const LevelReport& level = verdict->levels[i];
            const MeshSize size = meshSizeAt(**model, levels[i]);
            QCOMPARE(level.sites, size.sites);
            QCOMPARE(level.tetrahedra, size.tetrahedra);
            QVERIFY(level.conforming && level.covers && level.inverted == 0);
            QVERIFY(level.measured.error.largest <= size.error + 1e-9);
            QVERIFY(i == 0 || level.measured.error.largest <= verdict->levels[i - 1].measured.error.largest + 1e-9);
        }
        QVERIFY(verdict->levels[0].measured.error.largest > 5);
    }

    /// Whatever bit of the file changes, the model is not opened or not found right.
    void anyChangedBitIsFound()
    {
        std::vector<std::byte> bytes = bytes_;
        std::size_t refused = 0;
        for (std::size_t at = 0; at < bytes.size(); at += at < 1200 ? 1 : 29) {
            const auto bit = std::byte(1u << (at * 7 % 8));
            bytes[at] ^= bit;
            writeBytes(path("changed.tan"), bytes);
            bytes[at] ^= bit;
            const auto model = Model::open(path("changed.tan"));
            if (!model.ok()) {
                QVERIFY(!model.error().text().empty());
                ++refused;
                continue;
            }
            const auto verdict = verify(**model, dataset_, {});
            QVERIFY(verdict.ok());
            QVERIFY2(!verdict->ok(), qPrintable(QString::number(at)));
        }
        QVERIFY(refused >= 800 && refused < 1200); // header, table and text; the rest is opened
    }

    void findsWhatIsWrong_data();
    void findsWhatIsWrong();

    void anotherDatasetIsNamed()
    {
        const auto model = Model::open(path());
        const auto otherType = verify(**model, bumps(SampleType::Int16, {5, 4, 6}), {{0}});
        QVERIFY2(textOf(*otherType).contains("was built from another dataset: 5 x 4 x 6 samples of type uint8"),
                 qPrintable(textOf(*otherType)));
        QVERIFY(textOf(*otherType).contains("0 %: Not checked"));
        const auto otherSize = verify(**model, bumps(SampleType::UInt8, {5, 4, 7}), {{0}});
        QVERIFY(textOf(*otherSize).contains("has 5 x 4 x 7 samples of type uint8"));

        auto samples = std::make_shared<std::vector<std::uint8_t>>();
        std::ranges::copy(dataset_.values.as<std::uint8_t>(), std::back_inserter(*samples));
        (*samples)[50] ^= 1;
        Dataset changed = dataset_;
        changed.values = ScalarField(SampleType::UInt8, samples->size(),
                                     {samples, reinterpret_cast<const std::byte*>(samples->data())});
        const auto oneSample = verify(**model, changed, {{0}});
        QVERIFY2(textOf(*oneSample).contains("was built from other samples"), qPrintable(textOf(*oneSample)));
    }

    void canBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto model = Model::open(path());
        const auto verdict = verify(**model, dataset_, {{0}}, Progress(stop.get_token(), {}));
        QVERIFY(!verdict.ok());
        QCOMPARE(verdict.error().kind, ErrorKind::Cancelled);
    }

    void progressOnlyGrows()
    {
        const auto model = Model::open(path());
        double last = 0;
        bool grows = true;
        const Progress progress({}, [&](double fraction, const Message&) {
            grows = grows && fraction >= last && fraction <= 1.0000001;
            last = fraction;
        });
        QVERIFY(verify(**model, dataset_, {{1}, {0}}, progress).ok());
        QVERIFY(grows);
        QVERIFY(last > 0.99);
    }

    void aFileCutWhileMappedIsAnError()
    {
        writeBytes(path("cut.tan"), bytes_);
        const auto model = Model::open(path("cut.tan"));
        std::filesystem::resize_file(path("cut.tan"), 2000);
        const auto verdict = verify(**model, dataset_, {{0}});
        QVERIFY(!verdict.ok());
        QVERIFY(verdict.error().text().find("was cut short or changed") != std::string::npos);
    }

private:
    std::filesystem::path path(const char* name = "model.tan") const { return folder_.filePath(name).toStdString(); }

    QTemporaryDir folder_;
    const Dataset dataset_ = bumps(SampleType::UInt8, {5, 4, 6});
    std::vector<std::byte> bytes_;
};

using Damage = void (*)(FileParts&);

void VerificationTest::findsWhatIsWrong_data()
{
    QTest::addColumn<Damage>("damage");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, Damage damage, const char* says) {
        QTest::newRow(name) << damage << QString(says);
    };
    row(
        "moved value", [](FileParts& f) { f.elements<std::uint8_t>(SectionId::SiteValues)[20] += 1; },
        "The value of site 20 is ");
    row(
        "other sample", [](FileParts& f) { f.elements<std::uint8_t>(SectionId::Samples)[71] ^= 4; },
        "of row y = 2, z = 3 are not those of the original");
    row(
        "lost tetrahedron",
        [](FileParts& f) {
            f.elements<std::uint32_t>(SectionId::Destroyers)[livingTetrahedron(f)] = f.header().siteCount - 1;
        },
        "sixths of a cell and fills");
    row(
        "lost tetrahedron in the mesh",
        [](FileParts& f) {
            f.elements<std::uint32_t>(SectionId::Destroyers)[livingTetrahedron(f)] = f.header().siteCount - 1;
            --f.elements<std::uint32_t>(SectionId::MeshSizes).back();
        },
        "0 %: The cells fill ");
    row(
        "tetrahedron too many in the mesh",
        [](FileParts& f) {
            const auto destroyers = f.elements<std::uint32_t>(SectionId::Destroyers);
            *std::ranges::find_if(destroyers, [](std::uint32_t site) { return site != Model::never; }) = Model::never;
            ++f.elements<std::uint32_t>(SectionId::MeshSizes).back();
        },
        "0 %: The cells fill ");
    row(
        "hole",
        [](FileParts& f) {
            f.elements<std::uint32_t>(SectionId::Destroyers)[livingTetrahedron(f)] = f.header().siteCount - 1;
        },
        "belongs to one cell only");
    row(
        "destroyer too early", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers)[0] = 3; },
        "is destroyed by site 3");
    row(
        "destroyer unknown", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers)[0] = 1000; },
        "is destroyed by site 1000");
    row(
        "destroyer later",
        [](FileParts& f) {
            auto& destroyer = f.elements<std::uint32_t>(SectionId::Destroyers)[0];
            destroyer = destroyer == 8 ? 9 : 8;
        },
        "tetrahedra, and the file says");
    row(
        "swapped sites",
        [](FileParts& f) {
            auto& others = f.elements<Others>(SectionId::OtherSites)[livingTetrahedron(f)];
            std::swap(others[0], others[1]);
        },
        "is inverted");
    row(
        "inverted cell",
        [](FileParts& f) {
            auto& others = f.elements<Others>(SectionId::OtherSites)[livingTetrahedron(f)];
            std::swap(others[0], others[1]);
        },
        "0 %: Inverted cell with corners");
    row(
        "flat",
        [](FileParts& f) {
            auto& others = f.elements<Others>(SectionId::OtherSites)[livingTetrahedron(f)];
            others[0] = others[1];
        },
        "is flat");
    row(
        "wrong site", [](FileParts& f) { f.elements<Others>(SectionId::OtherSites).back()[0] = 0; }, "0 %: ");
    row(
        "late site", [](FileParts& f) { f.elements<Others>(SectionId::OtherSites)[0][0] = 90; },
        "is not earlier than its creator");
    row(
        "wrong position",
        [](FileParts& f) {
            auto points = f.elements<std::uint32_t>(SectionId::SitePoints);
            points[20] = points[20] == 60 ? 61 : 60;
        },
        "The value of site 20");
    row(
        "two sites on one point",
        [](FileParts& f) {
            auto points = f.elements<std::uint32_t>(SectionId::SitePoints);
            points[20] = points[19];
        },
        "Site 20 at (");
    row(
        "no point", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::SitePoints)[20] = 120; },
        "Site 20 is point 120, and the lattice has 120");
    row(
        "swapped corners",
        [](FileParts& f) {
            auto points = f.elements<std::uint32_t>(SectionId::SitePoints);
            std::swap(points[2], points[20]);
        },
        "initial sites hold 7 corners of the domain instead");
    row(
        "small running error",
        [](FileParts& f) {
            for (float& error : f.elements<float>(SectionId::SiteRunningKeys).subspan(12))
                error = 0;
        },
        "more than the claimed 0 %");
    row(
        "rising running error", [](FileParts& f) { f.elements<float>(SectionId::SiteRunningKeys)[30] = 1000; },
        "must not increase");
    row(
        "not a number", [](FileParts& f) { f.elements<float>(SectionId::SiteRunningKeys)[30] = NAN; },
        "The running error of site 30 is");
    row(
        "finite start", [](FileParts& f) { f.elements<float>(SectionId::SiteRunningKeys)[3] = 1000; },
        "of site 4 is inf, after 1000");
    row(
        "small final error",
        [](FileParts& f) {
            auto destroyers = f.elements<std::uint32_t>(SectionId::Destroyers);
            std::ranges::fill(destroyers, Model::never);
        },
        "and the file says");
    row(
        "small own error",
        [](FileParts& f) { std::ranges::fill(f.elements<std::uint16_t>(SectionId::OwnErrors), std::uint16_t(0)); },
        "10 %: The error at sample");
    row(
        "own error no number", [](FileParts& f) { f.elements<std::uint16_t>(SectionId::OwnErrors)[5] = 0x7e00; },
        "Tetrahedron 5 has an own error that is not a number");
    row(
        "mesh size", [](FileParts& f) { ++f.elements<std::uint32_t>(SectionId::MeshSizes)[30]; },
        "tetrahedra, and the file says");
    row(
        "group without end", [](FileParts& f) { f.elements<std::uint8_t>(SectionId::SiteGroups).back() = 1; },
        "goes on with a site of another running error");
    row(
        "group flag", [](FileParts& f) { f.elements<std::uint8_t>(SectionId::SiteGroups)[0] = 2; },
        "goes on with a site of another running error");
    row(
        "group cut in two", [](FileParts& f) { f.elements<std::uint8_t>(SectionId::SiteGroups)[firstGroup(f)] = 0; },
        "empties");
    row(
        "corners apart", [](FileParts& f) { f.elements<std::uint8_t>(SectionId::SiteGroups)[6] = 0; },
        "The initial sites are not one group");
    row(
        "groups joined",
        [](FileParts& f) {
            const auto errors = f.elements<float>(SectionId::SiteRunningKeys);
            const auto goesOn = f.elements<std::uint8_t>(SectionId::SiteGroups);
            std::size_t site = 8;
            while (errors[site] != errors[site + 1] || goesOn[site] != 0)
                ++site;
            std::swap(f.elements<std::uint32_t>(SectionId::SitePoints)[site],
                      f.elements<std::uint32_t>(SectionId::SitePoints)[site + 1]);
        },
        "are not in the order of their points");
    row(
        "empty life",
        [](FileParts& f) {
            const std::size_t first = firstGroup(f);
            const auto star = f.elements<std::uint64_t>(SectionId::StarOffsets)[first];
            f.elements<std::uint32_t>(SectionId::Destroyers)[star] = std::uint32_t(first + 1);
        },
        "is made and destroyed at the same running error");
    row(
        "star offset", [](FileParts& f) { ++f.elements<std::uint64_t>(SectionId::StarOffsets)[30]; },
        "sixths of a cell and fills");
    row(
        "star offset far", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[30] = ~0ull; },
        "The star of site 29 goes from");
    row(
        "first star offset", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[0] = 1; },
        "The star offsets go from 1 to");
    row(
        "padding",
        [](FileParts& f) {
            const format::Section& text = f.section(SectionId::Text);
            f.content[text.offset + text.bytes] = std::byte{1};
        },
        "between two sections, are not zero");
    row(
        "reserved", [](FileParts& f) { f.header().reserved[3] = 1; }, "Reserved fields of the header");
    row(
        "flags", [](FileParts& f) { f.section(SectionId::Text).flags |= 2; }, "has reserved fields that are not zero");
    row(
        "bounding box",
        [](FileParts& f) {
            for (double* place : {&f.header().origin[0], &f.header().boundingBox[0], &f.header().boundingBox[3]})
                *place += 1;
        },
        "The bounding box");
    row(
        "range", [](FileParts& f) { f.header().valueRange[1] += 1; }, "The value range is ");
    row(
        "huge range",
        [](FileParts& f) {
            f.header().valueRange = {-1e300, 1e300};
        },
        "The value range is -1e+300 to");
    row(
        "hash", [](FileParts& f) { f.header().sourceHash += 1; }, "was built from other samples");
    row(
        "spacing",
        [](FileParts& f) {
            format::Header& header = f.header();
            header.spacing[0] *= 2;
            header.boundingBox[3] += header.boundingBox[3] - header.boundingBox[0];
        },
        "The spacing or the origin");
}

void VerificationTest::findsWhatIsWrong()
{
    QFETCH(Damage, damage);
    QFETCH(QString, says);
    FileParts parts(bytes_);
    damage(parts);
    parts.repairChecksums();
    writeBytes(path("wrong.tan"), parts.content);
    const auto model = Model::open(path("wrong.tan"));
    QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
    const auto verdict = verify(**model, dataset_, {{10}, {0}});
    QVERIFY(verdict.ok());
    QVERIFY(!verdict->ok());
    QVERIFY2(textOf(*verdict).contains(says), qPrintable(textOf(*verdict)));
}

QTEST_GUILESS_MAIN(VerificationTest)
#include "verification_test.moc"
