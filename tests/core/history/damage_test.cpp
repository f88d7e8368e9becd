// SPDX-License-Identifier: GPL-3.0-or-later
// Models that were damaged at random, with checksums that say all is well: opening, extracting and verifying may give
// errors or failures, never a crash. Meant to be run with sanitizers, too.
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/soak.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <random>

using namespace tetra;

namespace {

/// Numbers that programs trip over, put where they hurt.
constexpr std::array<std::uint32_t, 8> evilNumbers = {0,          1,          7,          0x7fffffff,
                                                      0x80000000, 0xfffffffe, 0xffffffff, 0x7fc00000};

class Damager {
public:
    Damager(std::uint32_t seed, std::uint32_t sections) : random_(seed), sections_(sections) {}

    void damage(std::vector<std::byte>& bytes)
    {
        const std::size_t hits = 1 + random_() % 4;
        for (std::size_t hit = 0; hit < hits; ++hit)
            damageOnce(bytes);
    }

private:
    void damageOnce(std::vector<std::byte>& bytes)
    {
        // Half of the hits go into header and table, which are a small part of the file.
        const std::size_t front = sizeof(format::Header) + sections_ * sizeof(format::Section);
        const std::size_t at = 8 + random_() % ((random_() % 2 == 0 ? front : bytes.size()) - 16);
        switch (random_() % 3) {
        case 0: bytes[at] ^= std::byte(1u << random_() % 8); break;
        case 1: bytes[at] = std::byte(random_() % 256); break;
        default: {
            const std::uint32_t evil = evilNumbers[random_() % evilNumbers.size()];
            const auto number = std::as_bytes(std::span(&evil, 1));
            std::ranges::copy(number, bytes.begin() + static_cast<std::ptrdiff_t>(at / 4 * 4));
        }
        }
    }

    std::minstd_rand random_;
    std::uint32_t sections_;
};

struct Subject {
    Dataset dataset;
    int rounds = timesOf(700, 3000);
};

/// Writes the model of a dataset of a kind.
Subject write(const QString& kind, const std::filesystem::path& path)
{
    if (kind == "irregular") {
        const Dataset dataset = randomIrregular(4);
        modelOf(path, dataset, decimated(dataset));
        return {dataset, timesOf(350, 1500)};
    }
    const std::array types = {SampleType::UInt8, SampleType::Int32, SampleType::Float32};
    const auto type = *std::ranges::find(types, kind.toStdString(), sampleTypeName);
    const Dataset dataset = bumps(type, {4, 3, 5});
    if (kind == "float") // decimated, the others refined
        modelOf(path, dataset, decimatedGrid(dataset));
    else
        writeModel(path, dataset);
    return {dataset};
}

} // namespace

class DamageTest : public QObject {
    Q_OBJECT

private slots:
    void damagedModelsNeverCrash_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"uint8", "int32", "float", "irregular"})
            QTest::newRow(kind) << QString(kind);
    }
    void damagedModelsNeverCrash()
    {
        QFETCH(QString, kind);
        const std::filesystem::path path = folder_.filePath("model.tan").toStdString();
        const auto [dataset, rounds] = write(kind, path);
        const std::vector<std::byte> bytes = readBytes(path);
        const std::uint32_t sectionCount = FileParts(bytes).header().sectionCount;
        int opened = 0;
        int extracted = 0;
        int notRight = 0;
        for (int round = 0; round < rounds; ++round) {
            FileParts parts(bytes);
            Damager(seedOf(static_cast<std::uint32_t>(round) + 1), sectionCount).damage(parts.content);
            if (parts.header().sectionCount <=
                sectionCount) // else the table reaches into the sections, or beyond the file
                parts.repairChecksums();
            writeBytes(path, parts.content);
            const auto model = Model::open(path);
            if (!model.ok()) {
                QVERIFY(model.error().text().size() > 20);
                continue;
            }
            ++opened;
            const std::uint32_t sites = meshSizeAt(**model, {1}).sites;
            for (const std::uint32_t count : {sites, model.value()->siteCount()}) {
                const auto mesh = extractPrefix(**model, count);
                if (!mesh.ok())
                    continue;
                ++extracted;
                for (const auto& tetrahedron : mesh->tetrahedra)
                    QVERIFY(std::ranges::all_of(tetrahedron, [count](std::uint32_t site) { return site < count; }));
            }
            const auto verdict = verify(**model, dataset, {{5}, {0}});
            QVERIFY(verdict.ok());
            notRight += verdict->ok() ? 0 : 1;
        }
        // The rounds do reach every stage. What is still right had damage in text that nobody compares, or none.
        QVERIFY2(opened > rounds / 10 && extracted > rounds / 10,
                 qPrintable(QString("%1 %2").arg(opened).arg(extracted)));
        QVERIFY2(notRight > opened / 2, qPrintable(QString("%1 of %2").arg(notRight).arg(opened)));
    }

private:
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(DamageTest)
#include "damage_test.moc"
