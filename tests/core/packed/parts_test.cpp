// SPDX-License-Identifier: GPL-3.0-or-later
// Models stored by parts (C16, R16): of every builder and domain the same bytes again, and every prefix a model that is
// proved. Bytes that are no packed model harm nobody.
#include "core/packed/packed_file.h"
#include "core/packed/parts.h"
#include "core/packed/parts_history.h"
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/core/history/model_fixture.h"

#include <tan/build.h>
#include <tan/packed.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <random>

using namespace tetra;
using format::SectionId;

namespace {

/// Points of which some lie on one sphere and in one plane.
Dataset scattered()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0, 1);
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    for (int i = 0; i < 260; ++i) {
        Eigen::Vector3d place(any(random), any(random), any(random));
        if (i % 3 == 0)
            place = (4 * place).array().round().matrix() / 4;
        if (std::ranges::find(positions, place) != positions.end())
            continue;
        positions.push_back(place);
        values.push_back(std::sin(3 * place[0]) + place[1] * place[2] + 0.1 * any(random));
    }
    return *scatteredDataset(std::move(positions), std::move(values), "scattered");
}

struct Kind {
    const char* name;
    std::function<Dataset()> dataset;
    BuildMethod method;
};

const std::vector<Kind>& kinds()
{
    static const auto lattice = [](SampleType type, std::array<std::uint32_t, 3> size) {
        return [=] { return bumps(type, size); };
    };
    static const std::vector<Kind> all = {
        {"lattice", lattice(SampleType::UInt8, {17, 15, 16}), Refinement{.block = 0}},
        {"lattice of floats", lattice(SampleType::Float32, {12, 9, 11}), Refinement{.error = 2, .block = 0}},
        {"lattice in blocks", lattice(SampleType::Int16, {13, 9, 12}), Refinement{.block = 4}},
        {"lattice of doubles by collapses", lattice(SampleType::Float64, {9, 8, 7}), Decimation{}},
        {"lattice in rounds", lattice(SampleType::UInt8, {12, 12, 12}),
         Decimation{.finest = 1, .order = DecimationOrder::IndependentRounds}},
        {"lattice by collapses that stop early", lattice(SampleType::UInt16, {10, 10, 10}), Decimation{.error = 1}},
        {"grid",
         [] {
             return bentBumps(SampleType::Float32, {11, 9, 10});
         },
         Refinement{.block = 0}},
        {"grid in blocks",
         [] {
             return bentBumps(SampleType::Int16, {9, 5, 6}, true, true);
         },
         Refinement{.block = 3}},
        {"grid with faults", faultyGrid, Refinement{.block = 0}},
        {"grid by collapses",
         [] {
             return bentBumps(SampleType::Float32, {7, 6, 6}, true);
         },
         Decimation{}},
        {"scattered points", scattered, Refinement{}},
        {"irregular", [] { return withFaultyCells(randomIrregular(1)); }, Decimation{}},
        {"irregular, two parts", [] { return randomIrregular(6); },
         Decimation{.order = DecimationOrder::PaperEstimates}},
        {"irregular, both sides", [] { return randomIrregular(4); }, Decimation{.twoSided = true}},
        {"irregular, jittered", [] { return randomIrregular(5); },
         Decimation{.order = DecimationOrder::IndependentRounds}},
    };
    return all;
}

/// Packs by parts even what could be replayed.
Result<PackReport> packByParts(const Model& model, const std::filesystem::path& output)
{
    const auto file = PackedFileWriter::create(output, model, PackMethod::StoredByParts);
    if (!file)
        return file.error();
    auto report = packParts(model, **file, {});
    if (!report)
        return report;
    if (const Status written = (*file)->finish(); !written)
        return written.error();
    return report;
}

HistoryFacts factsOf(const Model& model)
{
    const ModelDescription& about = model.description();
    HistoryFacts facts;
    facts.domain = about.domain;
    facts.sampleType = about.sampleType;
    facts.lattice = about.lattice;
    facts.coordinateBytes = !model.floatPositions().empty() ? 4 : !model.doublePositions().empty() ? 8 : 0;
    facts.decimals = facts.coordinateBytes > 0 && hasDecimals(model);
    facts.delaunay = about.delaunay;
    facts.extent = about.range.extent();
    facts.diagonal = model.diagonal();
    facts.warpingWeight = about.warpingWeight;
    facts.siteCount = model.siteCount();
    facts.tetrahedronCount = model.tetrahedronCount();
    return facts;
}

template <class Element> bool begins(std::span<const Element> whole, std::span<const Element> part)
{
    return part.size_bytes() <= whole.size_bytes() &&
           (part.empty() || std::memcmp(whole.data(), part.data(), part.size_bytes()) == 0);
}

/// Whether the first sites of a model are these, with what they do to each other.
bool isPrefix(const Model& part, const Model& whole)
{
    const std::uint32_t sites = part.siteCount();
    for (std::uint64_t t = 0; t < part.tetrahedronCount(); ++t)
        if (part.destroyers()[t] != (whole.destroyers()[t] < sites ? whole.destroyers()[t] : Model::never))
            return false;
    return begins(whole.points(), part.points()) && begins(whole.values(), part.values()) &&
           begins(whole.runningKeys(), part.runningKeys()) && begins(whole.starOffsets(), part.starOffsets()) &&
           begins(whole.meshSizes(), part.meshSizes()) && begins(whole.groupGoesOn(), part.groupGoesOn()) &&
           begins(whole.otherSites(), part.otherSites()) && begins(whole.ownErrors(), part.ownErrors()) &&
           begins(whole.ownWarpings(), part.ownWarpings()) && begins(whole.floatPositions(), part.floatPositions()) &&
           begins(whole.doublePositions(), part.doublePositions());
}

} // namespace

class PackedPartsTest : public QObject {
    Q_OBJECT

private slots:
    void everyModelComesBack_data()
    {
        QTest::addColumn<int>("kind");
        for (std::size_t i = 0; i < kinds().size(); ++i)
            QTest::newRow(kinds()[i].name) << static_cast<int>(i);
    }
    void everyModelComesBack() // C16, R16
    {
        QFETCH(int, kind);
        const Kind& made = kinds()[static_cast<std::size_t>(kind)];
        const Dataset dataset = made.dataset();
        const auto built = buildModel(dataset, path("model"), made.method);
        QVERIFY2(built.ok(), built.ok() ? "" : built.error().text().c_str());
        comesBack(path("model"));
        if (QTest::currentTestFailed())
            return;
        const auto whole = Model::open(path("model"));
        const auto packed = PackedModel::open(path("packed"));
        QVERIFY((*packed)->method() == PackMethod::StoredByParts);
        QVERIFY((*packed)->fileSize() < (*whole)->fileSize() / 3);
        for (std::size_t level = 0; level < (*packed)->levels().size(); ++level) {
            const PackedLevel& claimed = (*packed)->levels()[level];
            const Status cut = unpackPrefix(**packed, level, path("prefix"));
            QVERIFY2(cut.ok(), cut.ok() ? "" : cut.error().text().c_str());
            const auto part = Model::open(path("prefix"));
            QVERIFY2(part.ok(), part.ok() ? "" : part.error().text().c_str());
            QCOMPARE((*part)->siteCount(), claimed.sites);
            QVERIFY(isPrefix(**part, **whole));
            if (level > 1 && level + 1 < (*packed)->levels().size())
                continue;
            const auto proof = verify(**part, dataset, {Accuracy{claimed.error, claimed.warping}, Accuracy{}});
            QVERIFY(proof.ok());
            std::string failures;
            for (const std::string& failure : proof->failures)
                failures += failure + "\n";
            for (const LevelReport& report : proof->levels)
                for (const std::string& failure : report.failures)
                    failures += failure + "\n";
            QVERIFY2(proof->ok(), failures.c_str());
        }
    }

    /// Sections that are missing, or made in another way, come back as they were.
    void olderFilesComeBack_data()
    {
        QTest::addColumn<QString>("file");
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(TAN_SOURCE_DIR "/tests/core/history/old_files"))
            if (entry.path().extension() == ".tan")
                QTest::newRow((entry.path().parent_path().filename() / entry.path().stem()).c_str())
                    << QString::fromStdString(entry.path().string());
    }
    void olderFilesComeBack() // C16
    {
        QFETCH(QString, file);
        comesBack(file.toStdString());
    }

    /// With sums that are right: only what they hold is wrong.
    void damageIsRefused_data() { everyModelComesBack_data(); }
    void damageIsRefused() // C16
    {
        QFETCH(int, kind);
        const Kind& made = kinds()[static_cast<std::size_t>(kind)];
        const auto built = buildModel(made.dataset(), path("model"), made.method);
        QVERIFY(built.ok());
        const auto model = Model::open(path("model"));
        const HistoryFacts facts = factsOf(**model);
        HistoryEncoder encoder(**model, facts);
        const auto bytes = encoder.encode((*model)->siteCount());
        QVERIFY(bytes.ok());
        std::mt19937 random(5);
        for (int round = 0; round < 40; ++round) {
            std::vector<std::byte> damaged = *bytes;
            if (round % 4 == 3)
                damaged.resize(random() % damaged.size());
            else
                for (int i = 0; i <= round % 4; ++i)
                    damaged[random() % damaged.size()] ^= std::byte(1 << random() % 8);
            HistoryDecoder decoder(facts);
            if (!decoder.decode(damaged, facts.siteCount))
                continue;
            const HistoryArrays& arrays = decoder.arrays();
            QCOMPARE(arrays.points.size(), std::size_t(facts.siteCount));
            for (std::size_t site = 0; site < facts.siteCount; ++site)
                for (std::uint64_t t = arrays.starOffsets[site]; t < arrays.starOffsets[site + 1]; ++t)
                    for (const std::uint32_t other : arrays.otherSites[t])
                        QVERIFY(other < site);
        }
    }

    /// A chunk that is not what was written is refused before anything is made of it.
    void changedBytesAreRefused() // C16
    {
        QVERIFY(buildModel(kinds()[0].dataset(), path("model"), kinds()[0].method).ok());
        comesBack(path("model"));
        const std::vector<std::byte> packed = readBytes(path("packed"));
        std::mt19937 random(7);
        for (int round = 0; round < 40; ++round) {
            std::vector<std::byte> damaged = packed;
            if (round % 2 == 0)
                damaged[random() % damaged.size()] ^= std::byte(1 << random() % 8);
            else
                damaged.resize(random() % damaged.size());
            writeBytes(path("damaged"), damaged);
            const auto opened = PackedModel::open(path("damaged"));
            if (!opened)
                continue;
            std::filesystem::remove(path("back"));
            if (unpackModel(**opened, path("back")))
                QCOMPARE(readBytes(path("back")), readBytes(path("model"))); // a byte between sections
        }
    }

private:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / (std::string(name) + ".tan");
    }

    void comesBack(const std::filesystem::path& file)
    {
        const auto model = Model::open(file);
        QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
        const auto report = packByParts(**model, path("packed"));
        QVERIFY2(report.ok(), report.ok() ? "" : report.error().text().c_str());
        const auto packed = PackedModel::open(path("packed"));
        QVERIFY2(packed.ok(), packed.ok() ? "" : packed.error().text().c_str());
        std::filesystem::remove(path("back"));
        const auto unpacked = unpackModel(**packed, path("back"));
        QVERIFY2(unpacked.ok(), unpacked.ok() ? "" : unpacked.error().text().c_str());
        QVERIFY(unpacked->derived.empty());
        QVERIFY(readBytes(path("back")) == readBytes(file));
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(PackedPartsTest)
#include "parts_test.moc"
