// SPDX-License-Identifier: GPL-3.0-or-later
// A file appears whole or not at all, and every failure says what, why and what to do.
#include "core/base/file_writer.h"

#include "core/base/finished_file.h"

#include "tests/core/base/small_disk.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <fstream>
#include <iterator>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;

namespace {

std::vector<std::byte> someBytes(std::size_t count)
{
    std::vector<std::byte> bytes(count);
    std::uint32_t state = 1;
    for (std::byte& byte : bytes)
        byte = static_cast<std::byte>((state = state * 1664525u + 1013904223u) >> 24);
    return bytes;
}

std::vector<std::byte> contentOf(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::vector<char> chars{std::istreambuf_iterator<char>(stream), {}};
    const auto bytes = std::as_bytes(std::span(chars));
    return {bytes.begin(), bytes.end()};
}

std::ptrdiff_t entries(const std::filesystem::path& folder)
{
    return std::distance(std::filesystem::directory_iterator(folder), {});
}

/// Another process, which does `work` and ends by its result; a killed one leaves what it has not tidied up.
template <class Work> pid_t inChildProcess(Work&& work)
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(work() ? 0 : 1);
    return child;
}

bool endedWell(pid_t child)
{
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Writes `bytes` and commits; the first error, if any.
Status writeWhole(const std::filesystem::path& target, std::span<const std::byte> bytes)
{
    Result<FileWriter> writer = FileWriter::create(target);
    if (!writer)
        return writer.error();
    if (const Status written = writer->write(bytes); !written)
        return written;
    return writer->commit();
}

} // namespace

class FileWriterTest : public QObject {
    Q_OBJECT

private slots:
    /// What another program made, or a writer that has to look at it first, is put in place as what is written here.
    void aFinishedFileReplacesAsAWriterDoes()
    {
        const QTemporaryDir place;
        const std::filesystem::path folder = place.path().toStdString();
        const std::filesystem::path made = folder / "made", target = folder / "target";
        const auto make = [&] { return writeWholeFile(made, someBytes(100)).ok(); };
        const auto modeOf = [](const std::filesystem::path& path) {
            struct stat status {};
            return ::lstat(path.c_str(), &status) == 0 ? status.st_mode : 0;
        };
        QVERIFY(make());
        QVERIFY(replaceFile(made, target).ok());
        QCOMPARE(contentOf(target), someBytes(100));
        QVERIFY(!std::filesystem::exists(made));
        QCOMPARE(::chmod(target.c_str(), 0640), 0);
        QVERIFY(make() && replaceFile(made, target).ok());
        QCOMPARE(modeOf(target) & 0777, mode_t(0640));
        QCOMPARE(::chmod(target.c_str(), 0444), 0);
        QVERIFY(make());
        for (const auto& refused : {replaceFile(made, target), replaceFile(made, folder),
                                    replaceFile(made, "/dev/null"), replaceFile(made, folder / "none" / "target")})
            QVERIFY(!refused.ok() && refused.error().kind == ErrorKind::CannotWrite);
        QVERIFY(!checkTarget(target).ok() && !checkTarget("/dev/null").ok() && checkTarget(folder / "new").ok());
        QVERIFY(S_ISCHR(modeOf("/dev/null")));
        QCOMPARE(contentOf(made), someBytes(100));
        // A link stays, and leads to the file.
        const std::filesystem::path link = folder / "link", behind = folder / "behind";
        std::filesystem::create_symlink("behind", link);
        QVERIFY(replaceFile(made, link).ok());
        QVERIFY(S_ISLNK(modeOf(link)) && S_ISREG(modeOf(behind)));
    }

    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void writesWhatItIsGiven_data()
    {
        QTest::addColumn<int>("buffer");
        QTest::addColumn<int>("piece");
        QTest::newRow("small pieces") << 1000 << 7;
        QTest::newRow("pieces of the buffer's size") << 1000 << 1000;
        QTest::newRow("pieces larger than the buffer") << 1000 << 4321;
        QTest::newRow("one byte of buffer") << 1 << 100;
    }
    void writesWhatItIsGiven()
    {
        QFETCH(int, buffer);
        QFETCH(int, piece);
        const std::vector<std::byte> bytes = someBytes(100'000);
        Result<FileWriter> writer = FileWriter::create(target(), static_cast<std::size_t>(buffer));
        QVERIFY(writer.ok());
        for (std::size_t at = 0; at < bytes.size(); at += static_cast<std::size_t>(piece))
            QVERIFY(writer->write(std::span(bytes).subspan(at, std::min(bytes.size() - at, std::size_t(piece)))).ok());
        QCOMPARE(writer->size(), bytes.size());
        QVERIFY(!std::filesystem::exists(target()));
        QVERIFY(writer->commit().ok());
        QVERIFY(contentOf(target()) == bytes);
        QCOMPARE(entries(target().parent_path()), 1);
    }

    void overwritesWithinWhatWasWritten()
    {
        std::vector<std::byte> bytes = someBytes(5000);
        Result<FileWriter> writer = FileWriter::create(target(), 4096);
        QVERIFY(writer->write(bytes).ok());
        const std::vector<std::byte> header(64, std::byte{7});
        QVERIFY(writer->overwrite(100, header).ok());
        QVERIFY(writer->write(header).ok());
        QVERIFY(writer->commit().ok());
        std::copy(header.begin(), header.end(), bytes.begin() + 100);
        bytes.insert(bytes.end(), header.begin(), header.end());
        QVERIFY(contentOf(target()) == bytes);
    }

    void leavesTheOldFileUntilCommitted()
    {
        QVERIFY(writeWhole(target(), someBytes(10)).ok());
        {
            Result<FileWriter> writer = FileWriter::create(target());
            QVERIFY(writer->write(someBytes(99)).ok());
            FileWriter moved = std::move(*writer);
            QVERIFY(moved.write(someBytes(99)).ok());
        }
        QVERIFY(contentOf(target()) == someBytes(10));
        QCOMPARE(entries(target().parent_path()), 1);
        QVERIFY(writeWhole(target(), someBytes(20)).ok());
        QVERIFY(contentOf(target()) == someBytes(20));
    }

    void keepsPermissions()
    {
        const mode_t before = ::umask(027);
        QVERIFY(writeWhole(target(), someBytes(1)).ok());
        ::umask(before);
        struct stat status {};
        QCOMPARE(::stat(target().c_str(), &status), 0);
        QCOMPARE(status.st_mode & 07777, mode_t(0640));
        QCOMPARE(::chmod(target().c_str(), 0604), 0);
        QVERIFY(writeWhole(target(), someBytes(2)).ok());
        QCOMPARE(::stat(target().c_str(), &status), 0);
        QCOMPARE(status.st_mode & 07777, mode_t(0604));
    }

    void followsASymbolicLink()
    {
        QVERIFY(writeWhole(target(), someBytes(1)).ok());
        const std::filesystem::path link = target().parent_path() / "link";
        std::filesystem::create_symlink(target(), link);
        QVERIFY(writeWhole(link, someBytes(5)).ok());
        QVERIFY(std::filesystem::is_symlink(link));
        QVERIFY(contentOf(target()) == someBytes(5));
    }

    void followsALinkToAFileThatIsYetToBeMade()
    {
        const std::filesystem::path folder = target().parent_path();
        std::filesystem::create_directory(folder / "later");
        std::filesystem::create_symlink("second", folder / "first");
        std::filesystem::create_symlink("later/file", folder / "second");
        QVERIFY(writeWhole(folder / "first", someBytes(5)).ok());
        QVERIFY(std::filesystem::is_symlink(folder / "first") && std::filesystem::is_symlink(folder / "second"));
        QVERIFY(contentOf(folder / "later" / "file") == someBytes(5));
        QCOMPARE(entries(folder), 3);
        QCOMPARE(entries(folder / "later"), 1);
    }

    void refusesLinksThatLeadNowhere()
    {
        const std::filesystem::path folder = target().parent_path();
        std::filesystem::create_symlink("back", folder / "forth");
        std::filesystem::create_symlink("forth", folder / "back");
        std::filesystem::create_symlink("missing/file", folder / "lost");
        for (const auto& [name, says] : {std::pair("forth", "symbolic links"), {"lost", "missing' does not exist"}}) {
            const Status written = writeWhole(folder / name, someBytes(5));
            QVERIFY(!written.ok());
            QVERIFY2(QString::fromStdString(written.error().text()).contains(says), written.error().text().c_str());
            QVERIFY(std::filesystem::is_symlink(folder / name));
        }
        QCOMPARE(entries(folder), 3);
    }

    void removesWhatAKilledProcessLeft()
    {
        const pid_t killed = inChildProcess([&] {
            Result<FileWriter> writer = FileWriter::create(target(), 1);
            return writer && writer->write(someBytes(1000)) && ::raise(SIGKILL) == 0;
        });
        QVERIFY(!endedWell(killed));
        QCOMPARE(entries(target().parent_path()), 1); // or there is nothing to remove
        QVERIFY(writeWhole(target().parent_path() / "other", someBytes(5)).ok());
        QCOMPARE(entries(target().parent_path()), 1);
    }

    void leavesWhatAnotherProcessIsWriting()
    {
        std::array<int, 2> written{}, goOn{};
        QCOMPARE(::pipe(written.data()), 0);
        QCOMPARE(::pipe(goOn.data()), 0);
        char byte = 0;
        const pid_t other = inChildProcess([&] {
            Result<FileWriter> writer = FileWriter::create(target(), 1);
            return writer && writer->write(someBytes(1000)) && ::write(written[1], &byte, 1) == 1 &&
                   ::read(goOn[0], &byte, 1) == 1 && writer->commit();
        });
        QCOMPARE(::read(written[0], &byte, 1), ssize_t(1));
        const Status beside = writeWhole(target(), someBytes(5));
        const std::ptrdiff_t files = entries(target().parent_path());
        QCOMPARE(::write(goOn[1], &byte, 1), ssize_t(1));
        QVERIFY(endedWell(other));
        for (const int descriptor : {written[0], written[1], goOn[0], goOn[1]})
            ::close(descriptor);
        QVERIFY(beside.ok());
        QCOMPARE(files, 2);
        QVERIFY(contentOf(target()) == someBytes(1000));
        QCOMPARE(entries(target().parent_path()), 1);
    }

    /// Each finds the files of the others again and again, just made, just about to be renamed.
    void manyProcessesInOneFolderDoNotDisturbEachOther()
    {
        std::vector<pid_t> processes;
        for (int number = 0; number < 4; ++number)
            processes.push_back(inChildProcess([&] {
                bool all = true;
                for (int round = 0; round < 300 && all; ++round) {
                    Result<FileWriter> writer = FileWriter::create(target());
                    all = writer && writer->write(someBytes(10)) && writer->commit(FileWriter::Durability::Process);
                }
                return all;
            }));
        for (const pid_t process : processes)
            QVERIFY(endedWell(process));
        QCOMPARE(entries(target().parent_path()), 1);
    }

    void leavesWhatIsOfOthers()
    {
        const std::filesystem::path folder = target().parent_path();
        const std::array names = {"a.12345678.partial", ".a.1234567.partial",   ".a.1234567g.partial",
                                  ".12345678.partial",  ".a.12345678.partials", ".a-12345678.partial"};
        for (const char* name : names)
            std::ofstream(folder / name) << "mine";
        std::filesystem::create_symlink(names[0], folder / ".link.12345678.partial");
        std::filesystem::create_directory(folder / ".folder.12345678.partial");
        QVERIFY(writeWhole(target(), someBytes(5)).ok());
        QCOMPARE(entries(folder), std::ptrdiff_t(names.size()) + 3);
    }

    void refusesATargetThatCannotBe_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("says");
        QTest::newRow("missing folder") << "no/such/file"
                                        << "does not exist: create it";
        QTest::newRow("file as folder") << "read-only/file"
                                        << "is not a folder";
        QTest::newRow("folder") << "folder"
                                << "Name a file in it";
        QTest::newRow("folder with slash") << "folder/"
                                           << "Name a file";
        QTest::newRow("read-only file") << "read-only"
                                        << "is read-only. Choose another name, or make it writable";
        QTest::newRow("device") << "device"
                                << "not a regular file";
        QTest::newRow("long name") << QString(300, 'x') << "shorter name";
    }
    void refusesATargetThatCannotBe()
    {
        QFETCH(QString, name);
        QFETCH(QString, says);
        const std::filesystem::path folder = target().parent_path();
        std::filesystem::create_directory(folder / "folder");
        std::ofstream(folder / "read-only") << "kept";
        QCOMPARE(::chmod((folder / "read-only").c_str(), 0444), 0);
        std::filesystem::create_symlink("/dev/full", folder / "device");
        const std::filesystem::path path = folder.string() + "/" + name.toStdString();
        const Status written = writeWhole(path, someBytes(10));
        QVERIFY(!written.ok());
        QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
        const QString text = QString::fromStdString(written.error().text());
        QVERIFY2(text.startsWith("Cannot write '"), qPrintable(text));
        QVERIFY2(text.contains(says), qPrintable(text));
        QCOMPARE(contentOf(folder / "read-only").size(), 4u);
        QCOMPARE(entries(folder), 3);
    }

    void refusesAReadOnlyFolder()
    {
        const std::filesystem::path folder = target().parent_path();
        const uid_t user = ::geteuid();
        QCOMPARE(::chmod(folder.c_str(), 0555), 0);
        if (user == 0)
            QCOMPARE(::seteuid(65534), 0); // the superuser may write everywhere
        const Status written = writeWhole(target(), someBytes(10));
        if (user == 0)
            QCOMPARE(::seteuid(user), 0);
        QCOMPARE(::chmod(folder.c_str(), 0755), 0);
        QVERIFY(!written.ok());
        QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
        QVERIFY(QString::fromStdString(written.error().text()).contains("Permission denied. Choose another folder"));
    }

    void reportsAFullDisk()
    {
        const SmallDisk disk(std::size_t{256} * 1024);
        if (!disk.ok())
            QSKIP("skipped: a small disk needs the right to mount");
        QVERIFY(writeWhole(disk.folder() / "small", someBytes(1000)).ok());
        const Status written = writeWhole(disk.folder() / "large", someBytes(1'000'000));
        QVERIFY(!written.ok());
        QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
        QVERIFY(QString::fromStdString(written.error().text()).contains("No space left on device. Free some space"));
        QCOMPARE(entries(disk.folder()), 1);
        QVERIFY(writeWhole(disk.folder() / "small", someBytes(100'000)).ok());
    }

    void reportsALimitOfTheFileSize()
    {
        const auto previous = ::signal(SIGXFSZ, SIG_IGN);
        rlimit limit{};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &limit), 0);
        const rlimit small{50'000, limit.rlim_max};
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        Result<FileWriter> writer = FileWriter::create(target(), 1000);
        const Status written = writer->write(someBytes(60'000));
        const Status again = writer->write(someBytes(1));
        const Status committed = writer->commit();
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &limit), 0);
        ::signal(SIGXFSZ, previous);
        QVERIFY(!written.ok() && !again.ok() && !committed.ok());
        QVERIFY(QString::fromStdString(written.error().text()).contains("ulimit -f"));
        QCOMPARE(committed.error().text(), written.error().text());
        QCOMPARE(entries(target().parent_path()), 0);
    }

private:
    std::filesystem::path target() const { return folder_->filePath("target.bin").toStdString(); }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(FileWriterTest)
#include "file_writer_test.moc"
