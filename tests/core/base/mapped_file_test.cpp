// SPDX-License-Identifier: GPL-3.0-or-later
// A mapped file may be cut, rewritten or fail while it is read: the program lives on and knows.
#include <tan/base.h>

#include "core/base/memory.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;

namespace {

std::uint64_t sumOf(std::span<const std::byte> bytes)
{
    std::uint64_t sum = 0;
    for (const std::byte byte : bytes)
        sum += static_cast<std::uint64_t>(byte);
    return sum;
}

constexpr int exitCodeOfPreviousHandler = 42;

/// How a child process that runs `function` ends: its exit code, or minus the signal that killed it.
template <class Function> int exitCodeOfChild(Function&& function)
{
    const pid_t child = ::fork();
    if (child == 0) {
        function();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

char readForeignMappingOfCutFile(const std::filesystem::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDWR);
    const void* const foreign = ::mmap(nullptr, pageSize(), PROT_READ, MAP_SHARED, descriptor, 0);
    if (::ftruncate(descriptor, 0) != 0)
        return 0;
    return *static_cast<const volatile char*>(foreign);
}

} // namespace

class MappedFileTest : public QObject {
    Q_OBJECT

private slots:
    /// The handler that is there before the first file is opened.
    void initTestCase()
    {
        struct sigaction action {};
        action.sa_handler = [](int) { ::_exit(exitCodeOfPreviousHandler); };
        QCOMPARE(::sigaction(SIGBUS, &action, nullptr), 0);
    }
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void givesTheContent()
    {
        const auto path = fileOf(10'000);
        const auto file = MappedFile::open(path);
        QVERIFY(file.ok());
        QCOMPARE(file.value()->bytes().size(), std::size_t(10'000));
        QCOMPARE(sumOf(file.value()->bytes()), std::uint64_t(10'000));
        QVERIFY(!file.value()->damaged());
        QVERIFY(file.value()->path() == path);
    }

    void anEmptyFileIsEmpty()
    {
        const auto file = MappedFile::open(fileOf(0));
        QVERIFY(file.ok());
        QVERIFY(file.value()->bytes().empty());
        QVERIFY(!file.value()->damaged());
    }

    void refusesWhatIsNoFile_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("says");
        QTest::newRow("missing") << "/no/such/file"
                                 << "No such file or directory. Check its name";
        QTest::newRow("folder") << QDir::tempPath() << "it is a folder";
        QTest::newRow("device") << "/dev/null"
                                << "not a regular file";
        QTest::newRow("pipe") << "pipe"
                              << "not a regular file";
    }
    void refusesWhatIsNoFile()
    {
        QFETCH(QString, path);
        QFETCH(QString, says);
        if (path == "pipe") {
            path = folderPath("pipe");
            QCOMPARE(::mkfifo(path.toStdString().c_str(), 0600), 0);
        }
        const auto file = MappedFile::open(path.toStdString());
        QVERIFY(!file.ok());
        QCOMPARE(file.error().kind, ErrorKind::BadInput);
        QVERIFY2(QString::fromStdString(file.error().text()).contains(says), file.error().text().c_str());
    }

    void readsZerosOfAFileThatWasCut_data()
    {
        QTest::addColumn<qint64>("left");
        QTest::newRow("nothing") << qint64(0);
        QTest::newRow("some pages") << qint64(5 * pageSize());
        QTest::newRow("half a page more") << qint64(5 * pageSize() + 100);
        QTest::newRow("less than a page cut") << qint64(100 * pageSize() - 100);
    }
    void readsZerosOfAFileThatWasCut()
    {
        QFETCH(qint64, left);
        const auto path = fileOf(100 * pageSize());
        const auto file = MappedFile::open(path);
        const auto untouched = MappedFile::open(fileOf(pageSize(), "other"));
        std::filesystem::resize_file(path, static_cast<std::uintmax_t>(left));
        QCOMPARE(sumOf(file.value()->bytes()), std::uint64_t(left));
        QVERIFY(file.value()->damaged());
        QVERIFY(!untouched.value()->damaged());
    }

    void survivesManyReadersWhileItIsCut()
    {
        for (int round = 0; round < 20; ++round) {
            const auto path = fileOf(400 * pageSize());
            const auto file = MappedFile::open(path);
            std::atomic<bool> cut = false;
            std::atomic<bool> right = true;
            std::vector<std::jthread> readers;
            for (int reader = 0; reader < 4; ++reader)
                readers.emplace_back([&] {
                    while (!cut)
                        sumOf(file.value()->bytes());
                    right = right && sumOf(file.value()->bytes()) == std::uint64_t(round) * pageSize();
                });
            std::filesystem::resize_file(path, static_cast<std::uintmax_t>(round) * pageSize());
            cut = true;
            readers.clear();
            QVERIFY(right);
            QVERIFY(file.value()->damaged());
        }
    }

    void noticesThatItWasRewritten()
    {
        const auto path = fileOf(1000);
        const auto file = MappedFile::open(path);
        std::ofstream(path, std::ios::in | std::ios::out) << "changed";
        std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(1));
        QVERIFY(file.value()->damaged());
    }

    void placesInTheTableAreUsedAgain()
    {
        const auto path = fileOf(100);
        for (int i = 0; i < 3000; ++i)
            QVERIFY(MappedFile::open(path).ok());
        std::vector<std::shared_ptr<const MappedFile>> files;
        while (files.size() < 2000) {
            const auto file = MappedFile::open(path);
            if (!file.ok()) {
                QCOMPARE(file.error().kind, files.size() < 1000 ? ErrorKind::BadInput : ErrorKind::OutOfResource);
                break; // by the table's size, or earlier by the system's limit of open files
            }
            files.push_back(file.value());
        }
        QVERIFY(files.size() < 2000);
        files.pop_back();
        QVERIFY(MappedFile::open(path).ok());
    }

    /// Bus errors of others are not ours to swallow: the handler that was there before gets them.
    void passesOtherBusErrorsOn()
    {
        const auto path = fileOf(2 * pageSize());
        const auto ours = MappedFile::open(path);
        QCOMPARE(exitCodeOfChild([&] { readForeignMappingOfCutFile(path); }), exitCodeOfPreviousHandler);
        QCOMPARE(exitCodeOfChild([] { ::raise(SIGBUS); }), exitCodeOfPreviousHandler);
        QCOMPARE(exitCodeOfChild([] {}), 0);
    }

private:
    QString folderPath(const QString& name) const { return folder_->filePath(name); }

    /// A file of `size` ones.
    std::filesystem::path fileOf(std::size_t size, const QString& name = "file") const
    {
        const std::filesystem::path path = folderPath(name).toStdString();
        std::ofstream(path, std::ios::binary) << std::string(size, '\1');
        return path;
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(MappedFileTest)
#include "mapped_file_test.moc"
