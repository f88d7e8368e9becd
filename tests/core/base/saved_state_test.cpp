// SPDX-License-Identifier: GPL-3.0-or-later
// What a long build leaves for going on: all of it comes back, or it is refused.
#include "core/base/saved_state.h"
#include "tests/core/base/small_disk.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

using namespace tetra;

namespace {

using Path = std::filesystem::path;
constexpr std::uint64_t fingerprint = 4711;

struct Work {
    std::uint32_t step = 0;
    std::vector<bool> flags;
    std::map<int, double> table;
    std::vector<std::vector<std::uint16_t>> lists;
    std::vector<std::uint32_t> some, others; ///< which only grow

    void archive(StateArchive& archive)
    {
        archive(step, flags, table, lists);
        archive.grown(some);
        archive.grown(others);
    }
    void goOn()
    {
        ++step;
        flags.push_back(step % 3 == 0);
        table[int(step)] = 0.5 * step;
        lists.emplace_back(step, std::uint16_t(step));
        for (std::uint32_t i = 0; i < 10; ++i) {
            some.push_back(100 * step + i);
            others.push_back(~some.back());
        }
    }
    bool operator==(const Work&) const = default;
};

std::string contentOf(const Path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const Path& path, const std::string& content)
{
    std::ofstream(path, std::ios::binary) << content;
}

std::span<const std::byte> bytesOf(const std::string& text)
{
    return std::as_bytes(std::span(text));
}

/// Saves it three times, and once more goes on and is killed; what it was when it was saved last.
Work interruptedIn(const Path& folder, std::string& noted)
{
    const auto state = SavedState::open(folder, fingerprint);
    Work work, saved;
    for (int time = 0; state.ok() && time < 4; ++time) {
        work.goOn();
        const std::string note = "note " + std::to_string(time) + "\n";
        (*state)->note(bytesOf(note));
        if (time == 3)
            break;
        (*state)->pause(work, true);
        noted += note;
        saved = work;
    }
    return saved;
}

} // namespace

class SavedStateTest : public QObject {
    Q_OBJECT

private slots:
    void allOfItComesBack()
    {
        const QTemporaryDir folder;
        const Path path = folder.path().toStdString();
        {
            const auto first = SavedState::open(path, fingerprint);
            QVERIFY(first.ok() && !(*first)->found());
        }
        std::string noted, read;
        const Work saved = interruptedIn(path, noted);
        QCOMPARE(saved.step, 3U);
        const auto state = SavedState::open(path, fingerprint);
        QVERIFY2(state.ok(), state.ok() ? "" : state.error().text().c_str());
        QVERIFY((*state)->found());
        Work work;
        QVERIFY((*state)->load(work).ok());
        QVERIFY(work == saved);
        QVERIFY((*state)
                    ->readNotes([&](std::span<const std::byte> piece) {
                        read.append(reinterpret_cast<const char*>(piece.data()), piece.size());
                        return Status();
                    })
                    .ok());
        QCOMPARE(read, noted);
    }

    /// Each byte counts, of the state and of what belongs to it of the journal.
    void damageIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("state") << "state";
        QTest::newRow("journal") << "journal";
    }
    void damageIsRefused()
    {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        const Path path = folder.path().toStdString(), file = path / name.toStdString();
        std::string noted;
        (void)interruptedIn(path, noted);
        const std::string whole = contentOf(file);
        QVERIFY(whole.size() > 100);
        const auto isRefused = [&](const std::string& content) {
            write(file, content);
            const auto state = SavedState::open(path, fingerprint);
            return !state.ok() && state.error().kind == ErrorKind::BadInput;
        };
        for (std::size_t place = 0; place < whole.size(); ++place) {
            std::string damaged = whole;
            damaged[place] = static_cast<char>(damaged[place] ^ 1 << place % 8);
            QVERIFY2(isRefused(damaged), std::to_string(place).c_str());
        }
        for (const std::size_t size : {std::size_t(1), whole.size() / 2, whole.size() - 1})
            QVERIFY(isRefused(whole.substr(0, size)));
        // What was appended to the journal behind it is not missed, and not looked at.
        QCOMPARE(isRefused(whole + "x"), name == "state");
    }

    void thatOfAnotherBuildIsRefused()
    {
        const QTemporaryDir folder;
        const Path path = folder.path().toStdString();
        std::string noted;
        (void)interruptedIn(path, noted);
        const auto other = SavedState::open(path, fingerprint + 1);
        QVERIFY(!other.ok());
        QCOMPARE(other.error().kind, ErrorKind::WrongUsage);
        QVERIFY(SavedState::open(path, fingerprint).ok()); // it is still there
    }

    /// The state before stays until the next one is whole, and the model needs room as well: a state that takes more
    /// than half of what is free is not written.
    void aDiskWithoutRoomDoesNoHarm()
    {
        constexpr std::size_t disk = 1 << 20;
        const SmallDisk small(disk);
        if (!small.ok())
            QSKIP("skipped: a small disk needs the right to mount");
        const auto state = SavedState::open(small.folder(), fingerprint);
        QVERIFY(state.ok());
        Work work;
        work.goOn();
        work.lists.emplace_back(disk * 2 / 3 / sizeof(std::uint16_t));
        (*state)->pause(work, true);
        QVERIFY(!std::filesystem::exists(small.folder() / "state"));
        work.lists.back().resize(disk / 8);
        (*state)->pause(work, true);
        QVERIFY(std::filesystem::exists(small.folder() / "state"));
    }
};

QTEST_GUILESS_MAIN(SavedStateTest)
#include "saved_state_test.moc"
