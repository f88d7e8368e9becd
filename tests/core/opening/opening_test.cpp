// SPDX-License-Identifier: GPL-3.0-or-later
// Opening packed models through the cache (R28, B5): what is kept there answers for one state of one file, and for
// nothing else; and a cache that cannot be used keeps nothing from being opened.
#include "core/opening/file_state.h"
#include "tests/core/base/small_disk.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/packed/packed_checksums.h"

#include <tan/build.h>
#include <tan/open.h>
#include <tan/packed.h>
#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <filesystem>

#include <sys/stat.h>

using namespace tetra;

namespace {

using Path = std::filesystem::path;

/// A packed lattice, of many levels.
const std::vector<std::byte>& packedBytes()
{
    static const std::vector<std::byte> bytes = [] {
        const QTemporaryDir folder;
        const Path model = folder.filePath("model.tan").toStdString();
        const Path packed = folder.filePath("packed.tan").toStdString();
        const Dataset dataset = bumps(SampleType::Float32, {15, 14, 16});
        const bool isMade =
            buildModel(dataset, model, Refinement{.block = 0}).ok() && packModel(**Model::open(model), packed).ok();
        return isMade ? readBytes(packed) : std::vector<std::byte>();
    }();
    return bytes;
}

format::Section chunksOf(std::span<const std::byte> file)
{
    format::Header header;
    std::memcpy(static_cast<void*>(&header), file.data(), sizeof header);
    format::Section section;
    std::memcpy(static_cast<void*>(&section), file.data() + sizeof header + (header.sectionCount - 1) * sizeof section,
                sizeof section);
    return section;
}

/// The same header and table before other chunks, whose own checksums are right.
std::vector<std::byte> forged(std::vector<std::byte> file)
{
    const format::Section section = chunksOf(file);
    const std::span<std::byte> chunk = std::span(file).subspan(section.offset, section.bytes);
    format::PackedChunkHead head;
    std::memcpy(static_cast<void*>(&head), chunk.data(), sizeof head);
    std::uint32_t positionBytes = 0; // of the first stream; behind it lie the values
    std::memcpy(&positionBytes, chunk.data() + sizeof head + 12, sizeof positionBytes);
    chunk[sizeof head + 16 + positionBytes + 3] ^= std::byte(8);
    head.checksum = checksum(chunk.subspan(sizeof head.checksum, sizeof head + head.bytes - sizeof head.checksum));
    std::memcpy(chunk.data(), &head, sizeof head);
    return file;
}

std::vector<float> valuesAt(const Model& model, double error)
{
    const auto mesh = extractPrefix(model, meshSizeAt(model, {.error = error, .warping = anyWarping}).sites);
    return mesh ? std::vector<float>(mesh->values.begin(), mesh->values.end()) : std::vector<float>();
}

std::size_t filesIn(const Path& folder)
{
    std::error_code problem;
    return pathsIn(folder, problem).size();
}

constexpr double coarse = 20;

} // namespace

class OpeningTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(!packedBytes().empty());
        writeBytes(place("model.tan"), packedBytes());
    }

    /// What somebody wrote is no model that a copy may replace.
    void aCopyReplacesNothingButModels()
    {
        const std::vector<std::byte> notes(3, std::byte('n'));
        const Path output = place("notes.txt");
        writeBytes(output, notes);
        const auto refused = copyModel(place("model.tan"), {}, output);
        QVERIFY(!refused && refused.error().kind == ErrorKind::WrongUsage);
        QVERIFY(readBytes(output) == notes);
        std::filesystem::remove(output);
        for ([[maybe_unused]] const char* over : {"nothing", "a model"})
            QVERIFY(copyModel(place("model.tan"), {}, output).ok());
    }

    void aLevelIsMadeOnceForAFile()
    {
        std::vector<float> first;
        for (int time = 0; time < 2; ++time) {
            const auto found = open("model.tan", coarse);
            QVERIFY2(found.ok(), found ? "" : found.error().text().c_str());
            QVERIFY(!found->isWhole);
            if (time == 0)
                first = valuesAt(*found->model, coarse);
            QVERIFY(!first.empty() && valuesAt(*found->model, coarse) == first);
            QCOMPARE(filesIn(cache()), std::size_t(1));
        }
        // Another file with the same content is another file.
        std::filesystem::copy_file(place("model.tan"), place("copy.tan"));
        QVERIFY(open("copy.tan", coarse).ok());
        QCOMPARE(filesIn(cache()), std::size_t(2));
    }

    /// What rots after it was opened is not hidden by what was unpacked before, whether the size or the time that can
    /// be set tells or not.
    void aDamagedFileIsRefusedWhateverTheCacheHas()
    {
        QVERIFY(open("model.tan", coarse).ok());
        QVERIFY(open("model.tan", 0).ok());
        const auto before = std::filesystem::last_write_time(place("model.tan"));
        std::vector<std::byte> bytes = packedBytes();
        const format::Section chunks = chunksOf(bytes);
        std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(chunks.offset + chunks.bytes / 2), bytes.end(),
                  std::byte(0));
        writeBytes(place("model.tan"), bytes);
        std::filesystem::last_write_time(place("model.tan"), before);
        for (const double error : {coarse, 0.0})
            for (const bool afresh : {false, true}) {
                const auto found = open("model.tan", error, afresh);
                QVERIFY2(!found.ok(), qPrintable(QString("%1 %2").arg(error).arg(afresh)));
                QCOMPARE(found.error().kind, ErrorKind::BadInput);
            }
    }

    /// The table's checksum covers the chunks, whose own ones whoever changes them can make right.
    void aForgedFileIsRefusedAndLeavesTheGenuineOneAlone()
    {
        const std::vector<float> genuine = [&] {
            const auto found = open("model.tan", coarse);
            return found ? valuesAt(*found->model, coarse) : std::vector<float>();
        }();
        std::filesystem::remove_all(cache());
        writeBytes(place("forged.tan"), forged(packedBytes()));
        const auto refused = open("forged.tan", coarse);
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().find("packed chunks") != std::string::npos, refused.error().text().c_str());
        // Nor does the library give a level of it, or the whole.
        const auto packed = PackedModel::open(place("forged.tan"));
        QVERIFY(packed.ok());
        QVERIFY(!unpackPrefix(**packed, 0, place("level.tan")).ok());
        QVERIFY(!unpackModel(**packed, place("whole.tan")).ok());
        QVERIFY(!std::filesystem::exists(place("level.tan")) && !std::filesystem::exists(place("whole.tan")));
        const auto found = open("model.tan", coarse);
        QVERIFY(found.ok());
        QVERIFY(!genuine.empty() && valuesAt(*found->model, coarse) == genuine);
    }

    /// A file that is put in the place of another one, of the same length and with its time.
    void aFileThatIsReplacedIsAnotherOne()
    {
        QVERIFY(open("model.tan", coarse).ok());
        const auto before = std::filesystem::last_write_time(place("model.tan"));
        writeBytes(place("new.tan"), forged(packedBytes()));
        std::filesystem::last_write_time(place("new.tan"), before);
        std::filesystem::rename(place("new.tan"), place("model.tan"));
        QVERIFY(!open("model.tan", coarse).ok());
    }

    void whoReadsAfreshTakesNothingFromTheCacheAndLeavesNothing()
    {
        const auto whole = open("model.tan", 0, true);
        QVERIFY2(whole.ok(), whole ? "" : whole.error().text().c_str());
        QCOMPARE(filesIn(cache()), std::size_t(0));
        const std::vector<float> values = valuesAt(*whole->model, 0);
        // What somebody put into the cache for this file is not looked at.
        QVERIFY(open("model.tan", 0).ok());
        QCOMPARE(filesIn(cache()), std::size_t(1));
        std::error_code problem;
        for (const Path& kept : pathsIn(cache(), problem))
            writeBytes(kept, std::vector<std::byte>(100, std::byte(7)));
        const auto again = open("model.tan", 0, true);
        QVERIFY(again.ok());
        QVERIFY(!values.empty() && valuesAt(*again->model, 0) == values);
        QCOMPARE(filesIn(cache()), std::size_t(1));
    }

    /// A small file that claims to be a large one does not empty the cache.
    void aClaimEmptiesNothing()
    {
        QVERIFY(open("model.tan", 0).ok());
        const Path kept = keptFirst();
        const std::uint64_t limit = 40'000'000, claim = limit - 1000;
        std::vector<std::byte> bytes = packedBytes();
        format::Section facts;
        std::memcpy(static_cast<void*>(&facts), bytes.data() + sizeof(format::Header), sizeof facts);
        QCOMPARE(facts.id, std::uint32_t(format::SectionId::PackedFacts));
        std::memcpy(bytes.data() + facts.offset + offsetof(format::PackedFacts, fileBytes), &claim, sizeof claim);
        repairPackedChecksums(bytes);
        writeBytes(place("claims.tan"), bytes);
        QCOMPARE(modelFacts(place("claims.tan").string())->unpackedBytes, claim);
        (void)openModel(place("claims.tan").string(), {.cacheFolder = cache(), .cacheBytes = limit});
        QVERIFY(std::filesystem::exists(kept));
    }

    /// Then the model lies among the temporary files for as long as it is open, and is found by nobody.
    void aCacheThatCannotBeUsedIsNoReasonNotToOpen_data()
    {
        QTest::addColumn<QString>("cacheFolder");
        QTest::newRow("none can be made") << "/proc/none/cache";
        QTest::newRow("it is a file") << "model.tan";
        QTest::newRow("others can write to it") << "open to all";
    }
    void aCacheThatCannotBeUsedIsNoReasonNotToOpen()
    {
        QFETCH(QString, cacheFolder);
        const Path open = place("open to all");
        std::filesystem::create_directory(open);
        QCOMPARE(::chmod(open.c_str(), 0777), 0);
        const Path temporary = place("temporary");
        std::filesystem::create_directory(temporary);
        const QByteArray before = qgetenv("TMPDIR");
        qputenv("TMPDIR", QByteArray::fromStdString(temporary.string()));
        const auto found =
            openModel(place("model.tan").string(), {.accuracy = Accuracy{.error = coarse, .warping = anyWarping},
                                                    .cacheFolder = place(cacheFolder.toStdString())});
        before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
        QVERIFY2(found.ok(), found ? "" : found.error().text().c_str());
        QVERIFY(!valuesAt(*found->model, coarse).empty());
        QCOMPARE(filesIn(open), std::size_t(0));
        QCOMPARE(filesIn(temporary), std::size_t(0));
    }

    /// Likewise one whose disk is too small; where nothing else helps, what is wrong there is told.
    void aFullDiskOfTheCacheIsNoReasonNotToOpen()
    {
        const SmallDisk disk(64 << 10);
        if (!disk.ok())
            QSKIP("mounting a small disk takes a superuser");
        const OpenOptions options{.cacheFolder = disk.folder() / "cache"};
        const QByteArray before = qgetenv("TMPDIR");
        qputenv("TMPDIR", QByteArray::fromStdString(disk.folder().string()));
        const auto told = openModel(place("model.tan").string(), options);
        before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
        QVERIFY(!told.ok());
        QCOMPARE(told.error().kind, ErrorKind::CannotWrite);
        QVERIFY2(told.error().text().find(disk.folder().string()) != std::string::npos, told.error().text().c_str());
        const auto found = openModel(place("model.tan").string(), options);
        QVERIFY2(found.ok(), found ? "" : found.error().text().c_str());
    }

    void aStateIsThatOfOneFile()
    {
        const auto state = stateOf(place("model.tan"));
        QVERIFY(state && state == stateOf(place("model.tan")));
        QVERIFY(waitUntilSettled(*state, {}).ok());
        std::filesystem::copy_file(place("model.tan"), place("copy.tan"));
        QVERIFY(state != stateOf(place("copy.tan")));
        // Changed without another size, and with the time of before.
        const auto before = std::filesystem::last_write_time(place("model.tan"));
        writeBytes(place("model.tan"), packedBytes());
        std::filesystem::last_write_time(place("model.tan"), before);
        QVERIFY(state != stateOf(place("model.tan")));
        QVERIFY(!stateOf(place("missing.tan")));
        QVERIFY(!stateOf(folder_->path().toStdString()));
    }

private:
    Path place(const std::string& name) const
    {
        return name.front() == '/' ? Path(name) : Path(folder_->path().toStdString()) / name;
    }
    Path cache() const { return place("cache"); }
    Path keptFirst() const
    {
        std::error_code problem;
        std::vector<Path> kept = pathsIn(cache(), problem);
        std::ranges::sort(kept);
        return kept.empty() ? Path() : kept.front();
    }
    Result<FoundModel> open(const std::string& name, double error, bool afresh = false) const
    {
        return openModel(
            place(name).string(),
            {.accuracy = Accuracy{.error = error, .warping = anyWarping}, .cacheFolder = cache(), .afresh = afresh});
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(OpeningTest)
#include "opening_test.moc"
