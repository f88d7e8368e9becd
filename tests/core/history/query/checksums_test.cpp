// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is asked of a model whose file is damaged, the answer is that of the undamaged one or a refusal, never a
// third: with checksums of chunks, which are checked as they are read, and with those of whole sections, as older files
// have them, which are checked in the background.
#include "core/base/checksum.h"
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/lattice_models.h"
#include "tests/core/history/query/questions.h"
#include "tests/core/history/query/some_models.h"
#include "tests/soak.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <random>
#include <thread>
#include <vector>

using namespace tetra;
using format::SectionId;

namespace {

/// How the files of a campaign guard themselves.
enum class Guard { SmallChunks, Chunks, WholeSections };

constexpr std::uint64_t smallChunk = 64; // what is read shows to a few bytes

std::vector<std::byte> guardedBy(Guard guard, std::vector<std::byte> bytes)
{
    FileParts parts(std::move(bytes));
    if (guard == Guard::SmallChunks)
        parts.setChunkBytes(smallChunk);
    if (guard == Guard::WholeSections)
        parts.removeChunkSums();
    return std::move(parts.content);
}

/// Changes a part of a section for certain: a bit, some zeros, or two parts exchanged.
bool damageSection(std::span<std::byte> bytes, std::mt19937& random)
{
    const std::vector<std::byte> before(bytes.begin(), bytes.end());
    const std::size_t at = random() % bytes.size();
    const std::size_t count = std::min<std::size_t>(1 + random() % 40, bytes.size() - at);
    switch (random() % 4) {
    case 0: std::ranges::fill(bytes.subspan(at, count), std::byte{}); break;
    case 1:
        std::swap_ranges(bytes.begin(), bytes.begin() + std::ptrdiff_t(std::min(count, bytes.size() / 2)),
                         bytes.end() - std::ptrdiff_t(std::min(count, bytes.size() / 2)));
        break;
    default: bytes[at] ^= std::byte(1u << random() % 8);
    }
    return !std::ranges::equal(before, bytes);
}

} // namespace

class ChecksumsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();

    void sumsAreThoseOfTheFormat_data();
    void sumsAreThoseOfTheFormat();
    void sumsThatCannotBeAreRefused_data();
    void sumsThatCannotBeAreRefused();
    void damageGivesTheRightAnswerOrNone_data();
    void damageGivesTheRightAnswerOrNone();
    void damageThatIsNotReadDoesNotMatter();
    void manyThreadsMayAskAtOnce();
    void verificationNamesTheChunks();
    void anOldFileIsReadInTheBackground();
    void aQuickThreadDoesNotDecideWhatOpens();

private:
    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    QTemporaryDir folder_;
    std::vector<SomeModel> models_;
};

void ChecksumsTest::initTestCase()
{
    models_ = someModels(folder());
    models_.push_back({"blocks", modelOf(randomLattice(LatticeKind::Smooth, {9, 8, 9}, 3), 4, folder())});
    models_.push_back({"whole", modelOf(randomLattice(LatticeKind::Real, {9, 8, 7}, 4), 0, folder())});
    const Dataset irregular = randomIrregular(4);
    models_.push_back({"irregular", modelOf(folder() / "irregular.tan", irregular, decimated(irregular))});
    const Dataset grid = bentBumps(SampleType::Float32, {5, 4, 5});
    models_.push_back({"decimated grid", modelOf(folder() / "grid.tan", grid, decimatedGrid(grid))});
}

void ChecksumsTest::sumsAreThoseOfTheFormat_data()
{
    QTest::addColumn<quint32>("blocks");
    QTest::newRow("written one after the other") << quint32(0);
    QTest::newRow("written all at once") << quint32(10);
}

/// FORMAT.md, with sections of several chunks.
void ChecksumsTest::sumsAreThoseOfTheFormat()
{
    QFETCH(quint32, blocks);
    const ModelPointer model = modelOf(randomLattice(LatticeKind::Noise, {21, 21, 21}, 5), blocks, folder());
    FileParts parts(readBytes(model->path()));
    QCOMPARE(parts.header().minorVersion, std::uint16_t(3));
    const format::Section& own = parts.section(SectionId::ChunkSums);
    QCOMPARE(own.flags, 0u);
    QCOMPARE(own.elementBytes, 8u);
    const auto stored = parts.elements<std::uint64_t>(SectionId::ChunkSums);
    QCOMPARE(stored[0], std::uint64_t(256 * 1024));
    std::size_t next = 1;
    for (const format::Section& section : parts.sections()) {
        if (&section == &own)
            continue;
        const auto bytes = std::as_bytes(std::span(parts.content)).subspan(section.offset, section.bytes);
        for (std::size_t at = 0; at < bytes.size(); at += 256 * 1024, ++next) {
            QVERIFY(next < stored.size());
            QCOMPARE(stored[next], checksum(bytes.subspan(at, std::min<std::size_t>(256 * 1024, bytes.size() - at))));
        }
    }
    QCOMPARE(next, stored.size());
    QVERIFY(parts.section(SectionId::OtherSites).bytes > 4 * 256 * 1024);
}

void ChecksumsTest::sumsThatCannotBeAreRefused_data()
{
    QTest::addColumn<quint64>("chunkBytes");
    QTest::addColumn<quint64>("elements"); // of the section; all that there are if more
    QTest::addColumn<QString>("says");
    constexpr quint64 all = ~quint64(0);
    QTest::newRow("no power of two") << quint64(1000) << all << "chunks of 1000 bytes are impossible";
    QTest::newRow("small") << quint64(32) << all << "chunks of 32 bytes are impossible";
    QTest::newRow("large") << quint64(1ull << 31) << all << "chunks of 2147483648 bytes are impossible";
    QTest::newRow("smaller") << quint64(128 << 10) << all << "section 'chunk checksums' has";
    QTest::newRow("larger") << quint64(1 << 30) << all << "section 'chunk checksums' has";
    QTest::newRow("fewer") << quint64(256 << 10) << quint64(9) << "has 72 bytes instead of";
    QTest::newRow("none") << quint64(256 << 10) << quint64(0) << "chunks of 0 bytes are impossible";
}

void ChecksumsTest::sumsThatCannotBeAreRefused()
{
    QFETCH(quint64, chunkBytes);
    QFETCH(quint64, elements);
    QFETCH(QString, says);
    const ModelPointer model = modelOf(randomLattice(LatticeKind::Noise, {15, 14, 13}, 8), 0, folder());
    FileParts parts(readBytes(model->path()));
    parts.elements<std::uint64_t>(SectionId::ChunkSums)[0] = chunkBytes;
    format::Section& section = parts.section(SectionId::ChunkSums);
    section.bytes = 8 * std::min<std::uint64_t>(elements, section.bytes / 8);
    parts.header().fileBytes = section.offset + section.bytes;
    parts.content.resize(parts.header().fileBytes);
    parts.repairChecksums();
    const std::filesystem::path path = folder() / "impossible.tan";
    writeBytes(path, parts.content);
    const auto opened = Model::open(path);
    QVERIFY(!opened.ok());
    QCOMPARE(opened.error().kind, ErrorKind::BadInput);
    QVERIFY2(QString::fromStdString(opened.error().text()).contains(says), opened.error().text().c_str());
}

void ChecksumsTest::damageGivesTheRightAnswerOrNone_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("guard");
    const std::array guards = {"small chunks", "chunks", "whole sections"};
    for (std::size_t number = 0; number < models_.size(); ++number)
        for (std::size_t guard = 0; guard < guards.size(); ++guard)
            QTest::addRow("%s, %s", models_[number].name.c_str(), guards[guard]) << int(number) << int(guard);
}

void ChecksumsTest::damageGivesTheRightAnswerOrNone()
{
    QFETCH(int, number);
    QFETCH(int, guard);
    const std::vector<std::byte> whole = guardedBy(Guard(guard), readBytes(models_[std::size_t(number)].model->path()));
    const std::filesystem::path path = folder() / "damaged.tan";
    const std::string blame = std::string("'").append(path.string()).append("' is damaged: ");
    writeBytes(path, whole);
    const ModelDescription& description = models_[std::size_t(number)].model->description();
    const auto questions = questionsAbout(description);
    std::map<std::string, std::string> answers;
    for (const auto& [name, question] : questions) {
        const auto model = Model::open(path);
        QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
        if (const auto answer = question(*model)) {
            QVERIFY((*model)->confirm().ok());
            answers[name] = *answer;
        }
    }
    QVERIFY(answers.size() >= 12); // what is built by others allows no insertion

    const int rounds = timesOf(8, 24);
    std::mt19937 random(seedOf(static_cast<unsigned>(100 * number + guard + 1)));
    const std::size_t sections = FileParts(whole).sections().size();
    int right = 0;
    for (std::size_t section = 0; section < sections; ++section) {
        const std::uint32_t id = FileParts(whole).sections()[section].id;
        const std::string name(format::sectionName(id));
        if (FileParts(whole).sections()[section].bytes == 0)
            continue; // no faults
        int refused = 0;
        for (int round = 0; round < rounds; ++round) {
            FileParts parts(whole);
            const format::Section& hit = parts.sections()[section];
            if (!damageSection(std::span(parts.content).subspan(hit.offset, hit.bytes), random))
                continue;
            writeBytes(path, parts.content);
            for (const auto& [asked, expected] : answers) {
                // Anew for each: damage that was found stays known.
                const auto model = Model::open(path);
                auto answer = model ? questions.at(asked)(*model) : Result<std::string>(model.error());
                // Of an old file damage may be found later than what comes of it.
                if (model)
                    if (const Status sound = (*model)->confirm(); !sound)
                        answer = sound.error();
                if (answer) {
                    QVERIFY2(*answer == expected, (asked + ", damaged " + name).c_str());
                    ++right;
                } else {
                    QCOMPARE(answer.error().kind, ErrorKind::BadInput);
                    QVERIFY2(answer.error().text().starts_with(blame), answer.error().text().c_str());
                    ++refused;
                }
            }
        }
        const bool isForInsertion =
            name.starts_with("sample") || (name == "site points" && description.domain != DomainClass::RegularLattice);
        // What follows from other sections is asked for by none of the questions.
        const bool isDerived = id == std::uint32_t(SectionId::LevelIndex) || id >= std::uint32_t(SectionId::BatchEnds);
        QVERIFY2(refused > 0 || isDerived || (isForInsertion && !answers.contains("insertion")), name.c_str());
    }
    QVERIFY(right > 0 || Guard(guard) == Guard::WholeSections);
}

/// What is asked of the coarse sites does not wait for the others.
void ChecksumsTest::damageThatIsNotReadDoesNotMatter()
{
    const ModelPointer model = modelOf(randomLattice(LatticeKind::Noise, {21, 21, 21}, 6), 0, folder());
    FileParts parts(readBytes(model->path()));
    parts.content[parts.section(SectionId::OtherSites).offset + parts.section(SectionId::OtherSites).bytes - 1] ^=
        std::byte(1);
    const std::filesystem::path path = folder() / "tail.tan";
    writeBytes(path, parts.content);
    const auto damaged = Model::open(path);
    QVERIFY(damaged.ok());
    std::uint32_t some = model->siteCount() / 3;
    while (!endsBatch(*model, some))
        --some;
    QVERIFY(some > 100);
    const auto coarse = extractPrefix(**damaged, some);
    QVERIFY(coarse.ok());
    QVERIFY(meshContent(*coarse) == meshContent(*extractPrefix(*model, some)));
    QVERIFY((*damaged)->confirm().ok());
    const auto fine = extractPrefix(**damaged, model->siteCount());
    QVERIFY(!fine.ok());
    QVERIFY2(fine.error().text().ends_with(
                 "is damaged: the checksum of section 'other sites' is wrong. Copy the file again, or build it again."),
             fine.error().text().c_str());
    QVERIFY(!(*damaged)->foundDamage().ok());
    QVERIFY2(!extractPrefix(**damaged, some).ok(), "damage that was found stays known");
}

void ChecksumsTest::manyThreadsMayAskAtOnce()
{
    const ModelPointer original = modelOf(randomLattice(LatticeKind::Noise, {15, 14, 13}, 7), 0, folder());
    const auto questions = questionsAbout(original->description());
    std::map<std::string, std::string> answers;
    for (const auto& [name, question] : questions)
        answers[name] = *question(original);
    for (const bool damaged : {false, true}) {
        FileParts parts(guardedBy(Guard::SmallChunks, readBytes(original->path())));
        if (damaged)
            parts.elements<std::byte>(SectionId::Destroyers)[parts.section(SectionId::Destroyers).bytes / 2] ^=
                std::byte(4);
        const std::filesystem::path path = folder() / "threads.tan";
        writeBytes(path, parts.content);
        const ModelPointer model = *Model::open(path);
        std::atomic<int> wrong = 0, refused = 0;
        std::vector<std::jthread> threads;
        for (int thread = 0; thread < 4; ++thread)
            threads.emplace_back([&, thread] {
                std::size_t turn = 0;
                for (auto question = questions.begin(); question != questions.end(); ++question, ++turn) {
                    auto one = questions.begin(); // each thread begins with another
                    std::advance(one, (turn + static_cast<std::size_t>(thread) * 3) % questions.size());
                    const auto answer = one->second(model);
                    refused += answer ? 0 : 1;
                    wrong += answer && *answer != answers[one->first] ? 1 : 0;
                }
            });
        threads.clear();
        QCOMPARE(wrong, 0);
        QCOMPARE(refused > 0, damaged);
    }
}

void ChecksumsTest::verificationNamesTheChunks()
{
    const Dataset dataset = bumps(SampleType::UInt8, {5, 6, 4});
    const std::filesystem::path path = folder() / "verified.tan";
    writeModel(path, dataset);
    const std::vector<std::byte> whole = guardedBy(Guard::SmallChunks, readBytes(path));
    writeBytes(path, whole);
    QVERIFY(verify(**Model::open(path), dataset, {{0}})->ok());
    FileParts parts(whole);
    const format::Section own = parts.section(SectionId::ChunkSums);
    parts.content[parts.section(SectionId::OwnErrors).offset + 100] ^= std::byte(2);
    // As if the sums of sections had been made anew over the damage, and those of chunks had not.
    const std::vector<std::byte> sums(parts.content.begin() + std::ptrdiff_t(own.offset), parts.content.end());
    parts.repairChecksums();
    std::ranges::copy(sums, parts.content.begin() + std::ptrdiff_t(own.offset));
    parts.section(SectionId::ChunkSums).checksum = checksum(sums);
    parts.repairHeader();
    writeBytes(path, parts.content);
    const auto verdict = verify(**Model::open(path), dataset, {{0}});
    QVERIFY(verdict.ok() && !verdict->ok());
    const QString failures = QString::fromStdString(verdict->failures.front());
    QVERIFY2(failures.contains("Section 'own errors'") && failures.contains("has 1 of "), qPrintable(failures));
}

/// Opening, asking, giving up and closing wait for nothing, however large the file is; confirming does.
void ChecksumsTest::anOldFileIsReadInTheBackground()
{
    using Clock = std::chrono::steady_clock;
    const std::filesystem::path path = folder() / "large.tan";
    writeModel(path, bumps(SampleType::UInt8, {5, 6, 4}));
    FileParts parts(guardedBy(Guard::WholeSections, readBytes(path)));
    const std::vector<std::byte> small = parts.content;
    parts.addSection(1000, 0);
    parts.repairChecksums();
    constexpr std::uint64_t sparse = 1ull << 38; // reading it would take minutes
    parts.sections().back().bytes = sparse;
    parts.header().fileBytes += sparse;
    parts.repairHeader();
    writeBytes(path, parts.content);
    std::filesystem::resize_file(path, parts.header().fileBytes);

    const auto start = Clock::now();
    {
        const ModelPointer model = *Model::open(path);
        QVERIFY(extractPrefix(*model, model->siteCount()).ok());
        QVERIFY(model->checkIntact().ok());
        std::stop_source stop;
        stop.request_stop();
        const Status given = model->confirm(Progress(stop.get_token(), {}));
        QVERIFY(!given.ok());
        QCOMPARE(given.error().kind, ErrorKind::Cancelled);
    }
    QVERIFY(Clock::now() - start < std::chrono::seconds(60));
    std::filesystem::remove(path);

    parts = FileParts(small);
    parts.elements<std::byte>(SectionId::SiteValues)[0] ^= std::byte(1); // a number that could be: only the sum tells
    writeBytes(path, parts.content);
    const ModelPointer damaged = *Model::open(path);
    QTRY_VERIFY(!damaged->foundDamage().ok());
    const Status sound = damaged->confirm();
    QVERIFY(!sound.ok());
    QCOMPARE(sound.error().kind, ErrorKind::BadInput);
    QVERIFY2(sound.error().text().find("the checksum of section 'site values' is wrong") != std::string::npos,
             sound.error().text().c_str());
    QVERIFY(!extractPrefix(*damaged, damaged->siteCount()).ok());
}

/// An old file opens whether or not its thread has found the damage by then: there is a model that can be asked about
/// it.
void ChecksumsTest::aQuickThreadDoesNotDecideWhatOpens()
{
    const std::filesystem::path path = folder() / "tiny.tan";
    writeModel(path, bumps(SampleType::UInt8, {2, 2, 2}));
    FileParts parts(guardedBy(Guard::WholeSections, readBytes(path)));
    parts.elements<std::byte>(SectionId::SiteValues)[3] ^= std::byte(64);
    writeBytes(path, parts.content);
    std::atomic<int> refused = 0;
    std::atomic<int> believed = 0;
    std::vector<std::jthread> threads; // more than processors: some are interrupted while opening
    for (int i = 0; i < 16; ++i)
        threads.emplace_back([&] {
            for (int j = 0; j < 500; ++j)
                if (const auto model = Model::open(path); !model)
                    ++refused;
                else if ((*model)->confirm())
                    ++believed;
        });
    threads.clear();
    QCOMPARE(refused.load(), 0);
    QCOMPARE(believed.load(), 0);
}

QTEST_GUILESS_MAIN(ChecksumsTest)
#include "checksums_test.moc"
