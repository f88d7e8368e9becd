// SPDX-License-Identifier: GPL-3.0-or-later
// Impossible numbers are refused where they are read, however right the checksums are: no mesh has a vertex without
// a place or a value, and no bound is negative or not a number.
#include "core/history/number_limits.h"
#include "tests/core/history/model_fixture.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace tetra;
using format::SectionId;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Case {
    const char* name;
    SectionId section;
    std::function<void(FileParts&)> change;
};

template <class T> std::function<void(FileParts&)> setLast(SectionId id, double number)
{
    return [=](FileParts& parts) { parts.elements<T>(id).back() = static_cast<T>(number); };
}

const std::vector<Case>& cases()
{
    static const std::vector<Case> all = {
        {"a value that is not a number", SectionId::SiteValues, setLast<float>(SectionId::SiteValues, notANumber)},
        {"an infinite value", SectionId::SiteValues, setLast<float>(SectionId::SiteValues, infinity)},
        {"a value out of the range", SectionId::SiteValues, setLast<float>(SectionId::SiteValues, 1e6)},
        {"a place that is not a number", SectionId::SitePositions,
         setLast<float>(SectionId::SitePositions, notANumber)},
        {"a place out of the box", SectionId::SitePositions, setLast<float>(SectionId::SitePositions, -1e6)},
        {"a key that is not a number", SectionId::SiteRunningKeys,
         setLast<float>(SectionId::SiteRunningKeys, notANumber)},
        {"a negative key", SectionId::SiteRunningKeys, setLast<float>(SectionId::SiteRunningKeys, -1)},
        {"a group of no kind", SectionId::SiteGroups, setLast<std::uint8_t>(SectionId::SiteGroups, 2)},
        {"an own error that is not a number", SectionId::OwnErrors,
         setLast<std::uint16_t>(SectionId::OwnErrors, 0x7e00)},
        {"a negative own warping", SectionId::OwnWarpings, setLast<std::uint16_t>(SectionId::OwnWarpings, 0x8400)},
    };
    return all;
}

format::Section sectionOf(SectionId id, std::uint32_t elementBytes)
{
    return {.id = static_cast<std::uint32_t>(id), .elementBytes = elementBytes};
}

} // namespace

class NumberLimitsTest : public QObject {
    Q_OBJECT

private slots:
    void impossibleNumbersAreRefusedWhenTheyAreRead_data()
    {
        QTest::addColumn<int>("number");
        for (std::size_t i = 0; i < cases().size(); ++i)
            QTest::newRow(cases()[i].name) << static_cast<int>(i);
    }
    void impossibleNumbersAreRefusedWhenTheyAreRead()
    {
        QFETCH(int, number);
        const Case& one = cases()[static_cast<std::size_t>(number)];
        const std::filesystem::path path = folder_.filePath("model.tan").toStdString();
        writeModel(path, bentBumps(SampleType::Float32, {4, 5, 4}));
        for (const bool withChunks : {true, false}) { // files before 1.3 have no checksums of chunks
            FileParts parts(readBytes(path));
            one.change(parts);
            if (!withChunks)
                parts.removeChunkSums();
            parts.repairChecksums();
            writeBytes(path, parts.content);
            const auto model = Model::open(path);
            QVERIFY2(model.ok(), model ? "" : model.error().text().c_str());
            const auto mesh = extractPrefix(**model, (*model)->siteCount());
            (void)(*model)->checkPrefix((*model)->siteCount(), Model::Batches | Model::Stars | Model::OwnBounds);
            const Status told = (*model)->confirm();
            QVERIFY(!told.ok());
            QCOMPARE(told.error().kind, ErrorKind::BadInput);
            const std::string name(format::sectionName(static_cast<std::uint32_t>(one.section)));
            QVERIFY2(told.error().text().find("section '" + name + "' holds impossible numbers") != std::string::npos,
                     told.error().text().c_str());
            const bool isOfMesh = one.section == SectionId::SiteValues || one.section == SectionId::SitePositions;
            QVERIFY(!withChunks || !isOfMesh || !mesh.ok());
            writeModel(path, bentBumps(SampleType::Float32, {4, 5, 4}));
        }
    }

    /// Who asks for an accuracy has made no mistake.
    void levelsWithoutMeshesOfTheirOwnAreDamage()
    {
        const std::filesystem::path path = folder_.filePath("levels.tan").toStdString();
        writeModel(path, bentBumps(SampleType::Float32, {5, 6, 5}));
        const std::uint32_t all = Model::open(path).value()->siteCount();
        FileParts parts(readBytes(path));
        for (std::uint32_t site = 8; site + 1 < all; site += 2)
            parts.elements<std::uint8_t>(SectionId::SiteGroups)[site] = 1;
        parts.repairChecksums();
        writeBytes(path, parts.content);
        const auto model = Model::open(path);
        QVERIFY(model.ok());
        int damaged = 0;
        for (double error = 0; error < 30; error += 0.5) {
            MeshQuery query;
            query.error = error;
            const auto mesh = MeshExtractor(*model).extract(query);
            damaged += !mesh.ok() ? 1 : 0;
            QVERIFY(mesh.ok() || mesh.error().kind == ErrorKind::BadInput);
        }
        QVERIFY(damaged > 0);
    }

    /// Each coordinate by its own axis, wherever a part begins.
    void placesAreHeldAgainstTheirAxis()
    {
        format::Header header;
        header.boundingBox = {0, 10, 20, 1, 11, 21};
        const NumberLimits limits(sectionOf(SectionId::SitePositions, 12), header);
        std::vector<float> places;
        for (int site = 0; site < 100; ++site)
            places.insert(places.end(), {0.5F, 10.5F, 20.5F});
        const auto bytes = std::as_writable_bytes(std::span(places));
        for (std::size_t first = 0; first < 7; ++first)
            QVERIFY(limits.hold(first * sizeof(float), bytes.subspan(first * sizeof(float))));
        QVERIFY(!limits.hold(sizeof(float), bytes));
        for (std::size_t at = 0; at < places.size(); ++at)
            for (const float wrong : {1.5F, 9.5F, 10.5F, 11.5F, 20.5F, 22.F, float(notANumber)}) {
                const float right = places[at];
                places[at] = wrong;
                QCOMPARE(limits.hold(0, bytes), wrong == right);
                places[at] = right;
            }
    }

    void samplesLieInTheRange_data()
    {
        QTest::addColumn<int>("type");
        for (int type = 0; type < 8; ++type)
            QTest::newRow(sampleTypeName(static_cast<SampleType>(type)).data()) << type;
    }
    void samplesLieInTheRange()
    {
        QFETCH(int, type);
        format::Header header;
        header.sampleType = static_cast<std::uint32_t>(type);
        header.valueRange = {3, 90};
        const NumberLimits limits(
            sectionOf(SectionId::SiteValues, static_cast<std::uint32_t>(sampleSize(static_cast<SampleType>(type)))),
            header);
        visitSampleType(static_cast<SampleType>(type), [&]<class T>() {
            std::vector<T> values(70, T(3));
            values[1] = T(90);
            const auto holds = [&] { return limits.hold(0, std::as_bytes(std::span(values))); };
            QVERIFY(holds());
            for (const std::size_t at : {0u, 31u, 64u, 69u})
                for (const double wrong : {2.0, 91.0, 127.0, -1.0, notANumber}) {
                    if (!std::is_floating_point_v<T> && (std::isnan(wrong) || (wrong < 0 && std::is_unsigned_v<T>)))
                        continue;
                    const T before = std::exchange(values[at], static_cast<T>(wrong));
                    QVERIFY(!holds());
                    values[at] = before;
                }
        });
        // A range that the type does not have has no values.
        header.valueRange = {1e300, 1e301};
        const NumberLimits none(sectionOf(SectionId::SiteValues, 1), header);
        const std::vector<std::byte> zeros(64);
        QVERIFY(type == int(SampleType::Float64) || !none.hold(0, zeros));
    }

    void initialSitesHaveInfiniteKeys()
    {
        const NumberLimits keys(sectionOf(SectionId::SiteRunningKeys, 4), {});
        const std::vector<float> infinite(5, float(infinity));
        QVERIFY(keys.hold(0, std::as_bytes(std::span(infinite))));
        const NumberLimits any(sectionOf(SectionId::Text, 1), {});
        const std::vector<std::byte> noise(100, std::byte(0xff));
        QVERIFY(any.hold(0, noise));
    }

private:
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(NumberLimitsTest)
#include "number_limits_test.moc"
