// SPDX-License-Identifier: GPL-3.0-or-later
// Models stored by parts (C16, R16): of every builder and domain the same bytes again, and every prefix a model that is
// proved. Bytes that are no packed model harm nobody.
#include "core/packed/packed_file.h"
#include "core/packed/parts.h"
#include "core/packed/parts_history.h"
#include "core/packed/range_coder.h"
#include "core/packed/site_replay.h"
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/packed/packed_checksums.h"

#include <tan/build.h>
#include <tan/packed.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <random>

#include <sys/stat.h>

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
    bool bySites = false; ///< whether the history follows from the sites
};

const std::vector<Kind>& kinds()
{
    static const auto lattice = [](SampleType type, std::array<std::uint32_t, 3> size) {
        return [=] { return bumps(type, size); };
    };
    static const std::vector<Kind> all = {
        {"lattice", lattice(SampleType::UInt8, {17, 15, 16}), Refinement{.block = 0}, true},
        {"lattice of floats", lattice(SampleType::Float32, {12, 9, 11}), Refinement{.error = 2, .block = 0}, true},
        {"lattice of integers, few sites", lattice(SampleType::Int16, {20, 17, 18}), Refinement{.error = 3, .block = 0},
         true},
        {"lattice with weights", lattice(SampleType::UInt8, {9, 9, 9}),
         Refinement{.block = 0, .weighting = *parseWeighting("value:120,15")}},
        {"lattice in blocks", lattice(SampleType::Int16, {13, 9, 12}), Refinement{.block = 4}},
        {"lattice of doubles by collapses", lattice(SampleType::Float64, {9, 8, 7}), Decimation{}},
        {"lattice in rounds", lattice(SampleType::UInt8, {12, 12, 12}),
         Decimation{.finest = 1, .order = DecimationOrder::IndependentRounds}},
        {"lattice by collapses that stop early", lattice(SampleType::UInt16, {10, 10, 10}), Decimation{.error = 1}},
        {"grid",
         [] {
             return bentBumps(SampleType::Float32, {11, 9, 10});
         },
         Refinement{.block = 0}, true},
        {"grid, few sites",
         [] {
             return bentBumps(SampleType::Float64, {12, 9, 10});
         },
         Refinement{.error = 2, .warping = 3, .block = 0}, true},
        {"grid by the paper's selection",
         [] {
             return bentBumps(SampleType::Int16, {7, 6, 8});
         },
         Refinement{.block = 0, .paperSelection = true}},
        {"grid in blocks",
         [] {
             return bentBumps(SampleType::Int16, {9, 5, 6}, true, true);
         },
         Refinement{.block = 3}},
        {"grid with faults", faultyGrid, Refinement{.block = 0}, true},
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

/// Whether the file holds the sites alone, and the history follows (PARTS.md).
bool holdsSitesAlone(const PackedModel& packed)
{
    constexpr std::uint32_t sites = 5;
    PackedChunkReader chunks(packed.file(), packed.file().chunks().size);
    for (;;) {
        const Result<bool> more = chunks.next({});
        if (!more.ok() || !*more)
            return false;
        if (chunks.kind() == sites)
            return true;
    }
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

/// Whether a model's own bounds are those of a longer one, or hold where those do.
template <class Bounds> bool bounds(const Bounds& whole, const Bounds& part)
{
    return part.size() <= whole.size() &&
           std::ranges::equal(part, whole.first(part.size()),
                              [](std::uint16_t one, std::uint16_t other) { return one >= other; });
}

/// Whether the first sites of a model are these, with what they do to each other.
bool isPrefix(const Model& part, const Model& whole, bool bySites)
{
    const std::uint32_t sites = part.siteCount();
    for (std::uint64_t t = 0; t < part.tetrahedronCount(); ++t)
        if (part.destroyers()[t] != (whole.destroyers()[t] < sites ? whole.destroyers()[t] : Model::never))
            return false;
    return begins(whole.points(), part.points()) && begins(whole.values(), part.values()) &&
           begins(whole.runningKeys(), part.runningKeys()) && begins(whole.starOffsets(), part.starOffsets()) &&
           begins(whole.meshSizes(), part.meshSizes()) && begins(whole.groupGoesOn(), part.groupGoesOn()) &&
           begins(whole.otherSites(), part.otherSites()) &&
           (bySites ? bounds(whole.ownErrors(), part.ownErrors()) && bounds(whole.ownWarpings(), part.ownWarpings())
                    : begins(whole.ownErrors(), part.ownErrors()) && begins(whole.ownWarpings(), part.ownWarpings())) &&
           begins(whole.floatPositions(), part.floatPositions()) &&
           begins(whole.doublePositions(), part.doublePositions());
}

/// Where the table of levels begins in a packed file.
std::size_t levelsIn(std::span<const std::byte> file)
{
    format::Header header;
    std::memcpy(static_cast<void*>(&header), file.data(), sizeof header);
    format::Section section;
    for (std::size_t number = 0; number < header.sectionCount; ++number) {
        std::memcpy(static_cast<void*>(&section), file.data() + sizeof header + number * sizeof section,
                    sizeof section);
        if (section.id == static_cast<std::uint32_t>(format::SectionId::PackedLevels))
            break;
    }
    return section.offset;
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
        const bool bySites = holdsSitesAlone(**packed);
        QCOMPARE(bySites, made.bySites);
        for (std::size_t level = 0; level < (*packed)->levels().size(); ++level) {
            const PackedLevel& claimed = (*packed)->levels()[level];
            const Status cut = unpackPrefix(**packed, level, path("prefix"));
            QVERIFY2(cut.ok(), cut.ok() ? "" : cut.error().text().c_str());
            const auto part = Model::open(path("prefix"));
            QVERIFY2(part.ok(), part.ok() ? "" : part.error().text().c_str());
            QCOMPARE((*part)->siteCount(), claimed.sites);
            QVERIFY(isPrefix(**part, **whole, bySites));
            if (level > 1 && level + 1 < (*packed)->levels().size())
                continue;
            isProved(**part, dataset, {Accuracy{claimed.error, claimed.warping}, Accuracy{}});
            if (QTest::currentTestFailed())
                return;
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

    /// What other samples have told of the own bounds cannot be had where the builder has changed: bounds that hold
    /// stand for them, and the report says so. Here the builder of old is one of whose model the packed file has other
    /// sums.
    void boundsAreNamedAsDerived() // C16
    {
        const Dataset dataset = bumps(SampleType::Float32, {16, 15, 17});
        QVERIFY(buildModel(dataset, path("model"), Refinement{.error = 3, .block = 0}).ok());
        const auto model = Model::open(path("model"));
        comesBack(path("model"));
        const auto packed = PackedModel::open(path("packed"));
        QVERIFY(holdsSitesAlone(**packed));
        const auto changeSum = [](std::vector<std::byte>& file, auto sum, std::uint64_t decltype(sum)::*checksum) {
            const auto bytes = std::as_bytes(std::span(&sum, 1));
            const auto found = std::ranges::search(file, bytes).begin();
            QVERIFY(found != file.end());
            sum.*checksum ^= 1;
            std::ranges::copy(bytes, found);
        };
        for (const SectionId id : {SectionId::OwnErrors, SectionId::OtherSites}) {
            std::vector<std::byte> changed = readBytes(path("packed"));
            const auto sums = (*packed)->file().sums();
            const auto sum = std::ranges::find(sums, static_cast<std::uint32_t>(id), &format::PackedSum::id);
            QVERIFY(sum != sums.end());
            changeSum(changed, *sum, &format::PackedSum::checksum);
            changeSum(changed, (*packed)->file().facts(), &format::PackedFacts::headerChecksum);
            repairPackedChecksums(changed);
            writeBytes(path("changed"), changed);
            const auto opened = PackedModel::open(path("changed"));
            QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().text().c_str());
            std::filesystem::remove(path("back"));
            const auto unpacked = unpackModel(**opened, path("back"));
            QVERIFY2(unpacked.ok(), unpacked.ok() ? "" : unpacked.error().text().c_str());
            QVERIFY(std::ranges::count(unpacked->derived, format::sectionName(static_cast<std::uint32_t>(id))) == 1);
            const auto back = Model::open(path("back"));
            QVERIFY(isPrefix(**back, **model, true));
            QVERIFY(!std::ranges::equal((*back)->ownErrors(), (*model)->ownErrors()));
            isProved(**back, dataset, {Accuracy{10}, Accuracy{}});
        }
    }

    /// Which points the sites are, three coordinates and a value: some bytes. Own bounds cost next to nothing where no
    /// other points tell of them but the few that no mesh has ever been off at, and else less than all arrays took.
    void sitesTakeFewBytes() // C16
    {
        const Dataset grid = bentBumps(SampleType::Float32, {17, 14, 15});
        for (const double error : {0.0, 2.0}) {
            QVERIFY(buildModel(grid, path("model"), Refinement{.error = error, .block = 0}).ok());
            const auto model = Model::open(path("model"));
            const auto report = packByParts(**model, path("packed"));
            QVERIFY2(report.ok(), report.ok() ? "" : report.error().text().c_str());
            HistoryEncoder arrays(**model, factsOf(**model));
            QVERIFY(arrays.encode((*model)->siteCount()).ok());
            const std::uint64_t sites = (*model)->siteCount(), own = report->ownErrors;
            const std::string figures = std::to_string(report->positions) + ", " + std::to_string(report->values) +
                                        ", " + std::to_string(own) + " (" + std::to_string(arrays.cost().ownErrors) +
                                        ") bytes of " + std::to_string(sites) + " sites";
            QVERIFY2(report->positions + report->values < 8 * sites, figures.c_str());
            QVERIFY2(error == 0 ? own < sites / 8 : 2 * own < arrays.cost().ownErrors, figures.c_str());
        }
    }

    /// Sites out of damaged bytes are refused, or make a history of their own.
    void damagedSitesAreRefused() // C16
    {
        for (const bool warps : {false, true}) {
            const Dataset dataset =
                warps ? bentBumps(SampleType::Float32, {8, 7, 9}) : bumps(SampleType::Int16, {9, 8, 7});
            QVERIFY(buildModel(dataset, path("model"), Refinement{.error = 1, .block = 0}).ok());
            const auto model = Model::open(path("model"));
            SiteFacts facts;
            facts.history = factsOf(**model);
            facts.grid.handedness = (*model)->description().leftHanded ? -1 : 1;
            const auto encoder = SiteEncoder::make(**model, facts, {});
            QVERIFY(encoder.ok());
            const auto bytes = (*encoder)->encode((*model)->siteCount(), {});
            QVERIFY(bytes.ok());
            std::mt19937 random(9);
            for (int round = 0; round < 30; ++round) {
                std::vector<std::byte> damaged = *bytes;
                if (round % 4 == 3)
                    damaged.resize(random() % damaged.size());
                else if (round > 0)
                    damaged[random() % damaged.size()] ^= std::byte(1 << random() % 8);
                const auto decoder = SiteDecoder::make(facts, {});
                QVERIFY(decoder.ok());
                const auto decoded = (*decoder)->decode(damaged, facts.history.siteCount, {});
                QVERIFY(decoded.ok());
                QVERIFY(*decoded || round > 0);
                if (!*decoded)
                    continue;
                auto history = (*decoder)->takeSites().history({});
                if (!history)
                    continue;
                QVERIFY(history->points.size() <= facts.history.siteCount);
                QVERIFY(round > 0 || sameButForBounds(*history, **model));
                std::vector<std::byte> noise(random() % 64);
                for (std::byte& byte : noise)
                    byte = std::byte(random());
                (void)decodeOwnBounds(facts, noise, *history);
            }
        }
    }

    /// Bytes that end early are not read on for as many sites as the header promises.
    void bytesThatEndEarlyAreSoonRefused() // C16
    {
        HistoryFacts facts;
        facts.lattice.size = {256, 256, 256};
        facts.siteCount = 1 << 24;
        facts.tetrahedronCount = std::uint64_t(1) << 26;
        facts.extent = facts.diagonal = 1;
        HistoryDecoder decoder(facts);
        QVERIFY(!decoder.decode(std::vector<std::byte>(16), facts.siteCount));
        QVERIFY(decoder.arrays().points.size() < 100'000);
    }

    /// The table cannot promise a level of fewer sites than a tetrahedron has.
    void levelsOfNoMeshAreRefused() // C16
    {
        QVERIFY(buildModel(bumps(SampleType::Float32, {10, 10, 10}), path("model"), Decimation{}).ok());
        QVERIFY(packModel(**Model::open(path("model")), path("packed")).ok());
        const std::vector<std::byte> whole = readBytes(path("packed"));
        QVERIFY((*PackedModel::open(path("packed")))->levels().size() > 1);
        for (const std::uint32_t sites : {0u, 1u, 7u}) {
            std::vector<std::byte> bytes = whole;
            std::memcpy(bytes.data() + levelsIn(bytes) + offsetof(format::PackedLevelEntry, sites), &sites,
                        sizeof sites);
            repairPackedChecksums(bytes);
            writeBytes(path("damaged"), bytes);
            const auto opened = PackedModel::open(path("damaged"));
            QVERIFY(!opened.ok());
            QCOMPARE(opened.error().kind, ErrorKind::BadInput);
        }
    }

    /// Nor is memory taken for as many faults of cells.
    void faultsThatDoNotComeTakeNoMemory() // C16
    {
        QVERIFY(buildModel(bentBumps(SampleType::UInt8, {5, 5, 5}), path("model"), Refinement{.block = 0}).ok());
        const auto model = Model::open(path("model"));
        RangeEncoder coder;
        NumberModel numbers;
        for (const std::uint64_t number : {std::uint64_t(4), std::uint64_t(0), std::uint64_t(0), std::uint64_t(0),
                                           std::uint64_t(0), std::uint64_t(1) << 33})
            numbers.code(coder, number);
        constexpr std::uint32_t factsOfParts = 2;
        const auto file = PackedFileWriter::create(path("packed"), **model, PackMethod::StoredByParts);
        QVERIFY(file.ok());
        QVERIFY((*file)->addChunk(factsOfParts, coder.finish()).ok());
        (*file)->endLevel(0, 0, (*model)->siteCount());
        QVERIFY((*file)->finish().ok());
        std::vector<std::byte> bytes = readBytes(path("packed"));
        constexpr std::array<std::uint32_t, 3> huge{2048, 2048, 1024};
        std::memcpy(bytes.data() + offsetof(format::Header, latticeSize), huge.data(), sizeof huge);
        repairPackedChecksums(bytes);
        writeBytes(path("damaged"), bytes);
        const auto opened = PackedModel::open(path("damaged"));
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().text().c_str());
        const auto unpacked = unpackModel(**opened, path("back"));
        QVERIFY(!unpacked.ok());
        QCOMPARE(unpacked.error().kind, ErrorKind::BadInput);
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

    /// Whatever somebody wrote into a model's arrays, with right checksums: it is refused, or comes back byte for byte.
    /// Never does packing follow a number to where there is nothing.
    void inconsistentModelsAreRefusedOrComeBack_data()
    {
        QTest::addColumn<int>("kind");
        for (const char* name : {"lattice", "lattice of doubles by collapses", "grid with faults", "scattered points",
                                 "irregular, two parts"})
            QTest::newRow(name) << static_cast<int>(std::ranges::find(kinds(), std::string_view(name), &Kind::name) -
                                                    kinds().begin());
    }
    void inconsistentModelsAreRefusedOrComeBack() // C16, R16
    {
        QFETCH(int, kind);
        const Kind& made = kinds()[static_cast<std::size_t>(kind)];
        QVERIFY(buildModel(made.dataset(), path("whole"), made.method).ok());
        const std::vector<std::byte> whole = readBytes(path("whole"));
        std::mt19937 random(11);
        int refused = 0, back = 0;
        for (int round = 0; round < 12; ++round) {
            FileParts parts(whole);
            for (int change = 0; change <= round % 3; ++change)
                contradict(parts, random);
            parts.repairChecksums();
            writeBytes(path("model"), parts.content);
            const auto model = Model::open(path("model"));
            const auto report = model ? packByParts(**model, path("packed")) : model.error();
            if (!report) {
                QCOMPARE(report.error().kind, ErrorKind::BadInput);
                ++refused;
                continue;
            }
            comesBack(path("model"));
            if (QTest::currentTestFailed())
                return;
            ++back;
        }
        QVERIFY2(refused > 0 && back > 0, qPrintable(QString("%1 %2").arg(refused).arg(back)));
    }

    /// A tetrahedron whose destroyer is not later than its creator: no mesh has it, and no walk comes to it.
    void destroyersThatComeFirstAreRefused() // C16
    {
        QVERIFY(buildModel(bumps(SampleType::Float32, {8, 7, 6}), path("whole"), Decimation{}).ok());
        for (const std::uint32_t destroyer : {0u, 5u, 100u}) {
            FileParts parts(readBytes(path("whole")));
            const auto offsets = parts.elements<std::uint64_t>(SectionId::StarOffsets);
            for (std::uint64_t t = offsets[100]; t < offsets[101]; ++t)
                parts.elements<std::uint32_t>(SectionId::Destroyers)[t] = destroyer;
            parts.repairChecksums();
            writeBytes(path("model"), parts.content);
            const auto report = packByParts(**Model::open(path("model")), path("packed"));
            QVERIFY(!report.ok());
            QCOMPARE(report.error().kind, ErrorKind::BadInput);
        }
    }

    /// All samples, where they are not those of the sites.
    void samplesThatAreNotTheSitesComeBack() // C16
    {
        QVERIFY(buildModel(bumps(SampleType::UInt8, {9, 8, 7}), path("model"), Decimation{}).ok());
        FileParts parts(readBytes(path("model")));
        const auto samples = parts.elements<std::uint8_t>(SectionId::Samples);
        QVERIFY(samples.size() == 9 * 8 * 7);
        std::ranges::reverse(samples);
        parts.repairChecksums();
        writeBytes(path("model"), parts.content);
        comesBack(path("model"));
    }

    /// One step between faults of cells has no code: to the number before, from the last folded cell to the first
    /// without volume.
    void faultsOfAnyNumbersComeBack() // C16
    {
        QVERIFY(buildModel(faultyGrid(), path("model"), Refinement{.block = 0}).ok());
        FileParts parts(readBytes(path("model")));
        const auto faults = parts.elements<format::Fault>(SectionId::Faults);
        const auto flat =
            std::ranges::find(faults, std::uint32_t(format::FaultKind::CellWithoutVolume), &format::Fault::kind);
        QVERIFY(flat != faults.end() && flat != faults.begin());
        flat->number = std::prev(flat)->number - 1;
        parts.repairChecksums();
        writeBytes(path("model"), parts.content);
        comesBack(path("model"));
    }

    /// What lies between sections comes back as zeros, so there has to be nothing else; and the table tells the truth.
    void whatWouldNotComeBackIsRefused() // C16
    {
        QVERIFY(buildModel(bumps(SampleType::UInt8, {9, 8, 7}), path("model"), Decimation{}).ok());
        const std::vector<std::byte> whole = readBytes(path("model"));
        FileParts parts(whole);
        const std::size_t gap = parts.section(SectionId::Text).offset + parts.section(SectionId::Text).bytes;
        QVERIFY(whole[gap] == std::byte(0));
        parts.content[gap] = std::byte(1);
        writeBytes(path("changed"), parts.content);
        QVERIFY(!packByParts(**Model::open(path("changed")), path("packed")).ok());
        FileParts other(whole);
        other.section(SectionId::Destroyers).checksum ^= 1;
        other.repairHeader();
        writeBytes(path("changed"), other.content);
        QVERIFY(!packByParts(**Model::open(path("changed")), path("packed")).ok());
    }

    /// As every file: a read-only one stays, permissions are kept, and what is not a file is left alone.
    void theOutputIsReplacedAsEveryFileIs() // C16, N8
    {
        QVERIFY(buildModel(bumps(SampleType::UInt8, {9, 8, 7}), path("model"), Decimation{}).ok());
        comesBack(path("model"));
        const auto packed = PackedModel::open(path("packed"));
        const auto modeOf = [](const std::filesystem::path& file) {
            struct stat status {};
            return ::lstat(file.c_str(), &status) == 0 ? status.st_mode : 0;
        };
        QCOMPARE(::chmod(path("back").c_str(), 0600), 0);
        QVERIFY(unpackModel(**packed, path("back")).ok());
        QCOMPARE(modeOf(path("back")) & 0777, mode_t(0600));
        QCOMPARE(::chmod(path("back").c_str(), 0444), 0);
        const auto before = std::filesystem::last_write_time(path("back"));
        const auto refused = unpackModel(**packed, path("back"));
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().kind, ErrorKind::CannotWrite);
        QVERIFY(std::filesystem::last_write_time(path("back")) == before);
        QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
        QCOMPARE(unpackModel(**packed, path("pipe")).error().kind, ErrorKind::CannotWrite);
        QVERIFY(S_ISFIFO(modeOf(path("pipe"))));
        std::filesystem::create_symlink(path("behind"), path("link"));
        QVERIFY(unpackModel(**packed, path("link")).ok());
        QVERIFY(S_ISLNK(modeOf(path("link"))) && S_ISREG(modeOf(path("behind"))));
        QVERIFY(readBytes(path("behind")) == readBytes(path("model")));
    }

private:
    /// Changes one number of a history, so that arrays contradict each other.
    static void contradict(FileParts& parts, std::mt19937& random)
    {
        constexpr std::array arrays = {SectionId::SitePoints, SectionId::SiteGroups, SectionId::StarOffsets,
                                       SectionId::OtherSites, SectionId::Destroyers, SectionId::MeshSizes};
        const SectionId id = arrays[random() % arrays.size()];
        const auto changed = [&](auto elements) {
            auto& one = elements[random() % elements.size()];
            const auto& another = elements[random() % elements.size()];
            switch (random() % 4) {
            case 0: one = another; break;
            case 1: ++one; break;
            case 2: --one; break;
            default: one = 0;
            }
        };
        if (id == SectionId::SiteGroups)
            parts.elements<std::uint8_t>(id)[random() % parts.elements<std::uint8_t>(id).size()] ^= 1;
        else if (id == SectionId::StarOffsets)
            changed(parts.elements<std::uint64_t>(id));
        else
            changed(parts.elements<std::uint32_t>(id));
    }

    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / (std::string(name) + ".tan");
    }

    static void isProved(const Model& model, const Dataset& dataset, const std::vector<Accuracy>& levels)
    {
        const auto proof = verify(model, dataset, levels);
        QVERIFY(proof.ok());
        std::string failures;
        for (const std::string& failure : proof->failures)
            failures += failure + "\n";
        for (const LevelReport& report : proof->levels)
            for (const std::string& failure : report.failures)
                failures += failure + "\n";
        QVERIFY2(proof->ok(), failures.c_str());
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
