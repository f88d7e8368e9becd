// SPDX-License-Identifier: GPL-3.0-or-later
// The cache folder of models that come over the network or are unpacked (R28, B5).
#include "core/remote/cache_folder.h"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;

namespace {

constexpr std::uint64_t kibibyte = 1024;

CacheFolder folderIn(const QTemporaryDir& home, std::uint64_t limit = CacheFolder::defaultLimit)
{
    return CacheFolder::open(std::filesystem::path(home.path().toStdString()) / "cache" / "tan", limit).value();
}

CacheFolder::Maker writing(std::size_t bytes, char content = 'c')
{
    return [=](const std::filesystem::path& path, const Progress&) -> Status {
        std::ofstream(path) << std::string(bytes, content);
        return {};
    };
}

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Status neverCalled(const std::filesystem::path&, const Progress&)
{
    return Error{ErrorKind::WrongUsage, "made again"};
}

/// A time of use before all others, each later than the one before.
void makeOld(const CachedFile& file, int age)
{
    const timespec times[2] = {{1'000'000 + age, 0}, {0, UTIME_OMIT}};
    QCOMPARE(::futimens(file.descriptor(), times), 0);
}

std::size_t filesIn(const CacheFolder& folder)
{
    std::error_code problem;
    return pathsIn(folder.path(), problem).size();
}

} // namespace

class CacheFolderTest : public QObject {
    Q_OBJECT

private slots:
    void aFileIsMadeOnce()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home);
        std::atomic<int> made = 0, wrong = 0;
        const auto make = [&](const std::filesystem::path& path, const Progress& progress) {
            ++made;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            return writing(100'000)(path, progress);
        };
        {
            std::vector<std::jthread> programs;
            for (int program = 0; program < 8; ++program)
                programs.emplace_back([&] {
                    const auto file = folder.take("key", 100'000, make);
                    wrong += !file || contentOf(file->path()) != std::string(100'000, 'c');
                });
        }
        QCOMPARE(made.load(), 1);
        QCOMPARE(wrong.load(), 0);
        QCOMPARE(filesIn(folder), std::size_t(1));
        QVERIFY(!folder.find("another key"));
        struct stat status {};
        QCOMPARE(::stat(folder.path().c_str(), &status), 0);
        QCOMPARE(status.st_mode & 0777, 0700u);
    }

    /// Processes that ask at the same moment: each makes a file of its own or finds the other's, whole.
    void twoProcessesAtOnce()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home);
        const std::filesystem::path calls = std::filesystem::path(home.path().toStdString()) / "calls";
        std::vector<pid_t> processes;
        for (int process = 0; process < 4; ++process) {
            const pid_t child = ::fork();
            if (child == 0) {
                bool right = true;
                for (int key = 0; key < 20; ++key) {
                    const auto file = folder.take(
                        std::to_string(key), 50'000, [&](const std::filesystem::path& path, const Progress& progress) {
                            const int log = ::open(calls.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
                            right = ::write(log, "x", 1) == 1 && right;
                            ::close(log);
                            return writing(50'000)(path, progress);
                        });
                    right = file && contentOf(file->path()) == std::string(50'000, 'c') && right;
                }
                ::_exit(right ? 0 : 1);
            }
            processes.push_back(child);
        }
        for (const pid_t process : processes) {
            int status = 1;
            QCOMPARE(::waitpid(process, &status, 0), process);
            QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        }
        QCOMPARE(contentOf(calls), std::string(20, 'x'));
    }

    void whatWasUnusedForLongestGoesFirst()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        for (const char* key : {"a", "b", "c"}) {
            const auto file = folder.take(key, 32 * kibibyte, writing(32 * kibibyte));
            QVERIFY(file.ok());
            makeOld(*file, key[0]);
        }
        QVERIFY(folder.find("a")); // used now
        QVERIFY(folder.take("d", 32 * kibibyte, writing(32 * kibibyte)).ok());
        QVERIFY(folder.find("a") && !folder.find("b") && folder.find("c") && folder.find("d"));
        QVERIFY(folder.bytes() <= folder.limit());
    }

    /// Whoever asks for more than the folder may ever have does not empty it.
    void whatNeverFitsRemovesNothing()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        QVERIFY(folder.take("kept", 64 * kibibyte, writing(64 * kibibyte)).ok());
        QCOMPARE(folder.take("huge", 101 * kibibyte, neverCalled).error().kind, ErrorKind::CannotWrite);
        QCOMPARE(folder.take("endless", ~std::uint64_t(0), neverCalled).error().kind, ErrorKind::CannotWrite);
        QVERIFY(folder.find("kept"));
        // Nor whoever asks for more than the disk can hold.
        const CacheFolder unlimited = folderIn(home, ~std::uint64_t(0));
        QCOMPARE(unlimited.take("endless", ~std::uint64_t(0) >> 2, neverCalled).error().kind, ErrorKind::CannotWrite);
        QVERIFY(unlimited.find("kept"));
    }

    /// What a file claims of itself removes nothing; what it takes does.
    void aClaimRemovesNothing()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        QVERIFY(folder.take("kept", 64 * kibibyte, writing(64 * kibibyte)).ok());
        QVERIFY(folder.take("claims much", 99 * kibibyte, writing(12 * kibibyte)).ok());
        QVERIFY(folder.find("kept"));
        const auto failed = folder.take("claims and fails", 99 * kibibyte, [](const auto&, const Progress&) {
            return Status(Error{ErrorKind::BadInput, "no model"});
        });
        QVERIFY(!failed.ok());
        QVERIFY(folder.find("kept"));
        QVERIFY(folder.take("claims little", kibibyte, writing(80 * kibibyte)).ok());
        QVERIFY(!folder.find("kept"));
        QVERIFY(folder.bytes() <= folder.limit());
    }

    /// Nor does a file that turns out to be larger than the folder may be.
    void whatIsTooLargeIsRefusedInTheEnd()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        QVERIFY(folder.take("kept", 64 * kibibyte, writing(64 * kibibyte)).ok());
        const auto large = folder.take("claims little", kibibyte, writing(200 * kibibyte));
        QVERIFY(!large.ok());
        QCOMPARE(large.error().kind, ErrorKind::CannotWrite);
        QVERIFY(folder.find("kept"));
        QCOMPARE(filesIn(folder), std::size_t(1));
    }

    /// Of a file that is being made as much counts as is written.
    void whatIsBeingMadeCounts()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        const auto file = folder.take("first", 64 * kibibyte, [&](const auto& path, const Progress& progress) {
            const Status written = writing(48 * kibibyte)(path, progress);
            const bool hasRoom = folder.makeRoom(64 * kibibyte).ok();
            const std::uint64_t counted = folder.bytes();
            return hasRoom || counted != 48 * kibibyte ? Status(Error{ErrorKind::BadInput, "not counted"}) : written;
        });
        QVERIFY2(file.ok(), file ? "" : file.error().text().c_str());
        QCOMPARE(folder.bytes(), 48 * kibibyte);
    }

    /// What lies in the folder is taken for what this user put there.
    void aFolderThatOthersCanChangeIsNotUsed()
    {
        const QTemporaryDir home;
        const std::filesystem::path above = std::filesystem::path(home.path().toStdString()) / "cache";
        const std::filesystem::path path = above / "tan";
        const auto refused = [&](const char* why) {
            const auto opened = CacheFolder::open(path);
            return !opened && opened.error().kind == ErrorKind::CannotWrite &&
                   opened.error().text().find(why) != std::string::npos;
        };
        QVERIFY(CacheFolder::open(path).ok());
        for (const mode_t mode : {0770, 0702, 0777}) {
            QCOMPARE(::chmod(path.c_str(), mode), 0);
            QVERIFY(refused("others can write to it"));
        }
        QCOMPARE(::chmod(path.c_str(), 0755), 0);
        QVERIFY(CacheFolder::open(path).ok());
        // Whoever can write above it can put another one there, unless that is as /tmp is.
        QCOMPARE(::chmod(above.c_str(), 0777), 0);
        QVERIFY(refused("everybody can write to"));
        QCOMPARE(::chmod(above.c_str(), 01777), 0);
        QVERIFY(CacheFolder::open(path).ok());
        if (::geteuid() != 0)
            return; // giving files away takes a superuser
        constexpr uid_t another = 65533;
        QCOMPARE(::chown(path.c_str(), another, another), 0);
        QVERIFY(refused("it belongs to another user"));
        QCOMPARE(::chown(path.c_str(), 0, 0), 0);
        QCOMPARE(::chown(above.c_str(), another, another), 0);
        QVERIFY(refused("belongs to another user"));
        // Through a link, too.
        const std::filesystem::path link = std::filesystem::path(home.path().toStdString()) / "link";
        std::filesystem::create_directory_symlink(path, link);
        QVERIFY(!CacheFolder::open(link).ok());
    }

    void aFileOfAnotherUserIsNotFound()
    {
        if (::geteuid() != 0)
            QSKIP("giving files away takes a superuser");
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home);
        std::filesystem::path path;
        {
            const auto file = folder.take("key", 10, writing(10));
            QVERIFY(file.ok());
            path = file->path();
        }
        QVERIFY(folder.find("key"));
        QCOMPARE(::chown(path.c_str(), 65533, 65533), 0);
        QVERIFY(!folder.find("key"));
    }

    /// Nothing but a file of its own may bear the name of one: it is told, and not waited for.
    void aPipeUnderTheNameOfAFileIsTold()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home);
        std::filesystem::path path;
        {
            const auto file = folder.take("key", 10, writing(10));
            QVERIFY(file.ok());
            path = file->path();
        }
        QVERIFY(std::filesystem::remove(path));
        QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
        const auto file = folder.take("key", 10, writing(10));
        QVERIFY(!file.ok());
        QCOMPARE(file.error().kind, ErrorKind::CannotWrite);
    }

    void whatIsInUseStays()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        const auto used = folder.take("used", 64 * kibibyte, writing(64 * kibibyte));
        QVERIFY(used.ok());
        makeOld(*used, 0);
        const auto other = folder.take("other", 64 * kibibyte, writing(64 * kibibyte));
        QVERIFY(!other.ok());
        QCOMPARE(other.error().kind, ErrorKind::CannotWrite);
        QVERIFY2(other.error().text().find("TAN_CACHE_MB") != std::string::npos, other.error().text().c_str());
        folder.clear();
        QCOMPARE(contentOf(used->path()).size(), 64 * kibibyte);
        QVERIFY(!folder.take("too large", 101 * kibibyte, neverCalled).ok());
    }

    /// A MappedFile takes a new time of modification for damage.
    void useKeepsTheTimeOfModification()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home);
        const auto file = folder.take("key", 10, writing(10));
        const auto mapped = MappedFile::open(file->path());
        QVERIFY(mapped.ok());
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        QVERIFY(folder.take("key", 10, neverCalled).ok());
        QVERIFY(!(*mapped)->damaged());
    }

    void whatFailsOrIsKilledLeavesNothing()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 100 * kibibyte);
        const auto failed = folder.take("key", 10, [](const std::filesystem::path& path, const Progress& progress) {
            (void)writing(10)(path, progress);
            return Status(Error{ErrorKind::BadInput, "no model"});
        });
        QCOMPARE(failed.error().text(), std::string("no model"));
        QCOMPARE(filesIn(folder), std::size_t(0));

        const pid_t child = ::fork();
        if (child == 0) {
            (void)folder.take("key", 10, [](const std::filesystem::path& path, const Progress& progress) {
                (void)writing(90 * kibibyte)(path, progress);
                ::raise(SIGKILL);
                return Status();
            });
            ::_exit(0);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFSIGNALED(status));
        QCOMPARE(filesIn(folder), std::size_t(2));
        QVERIFY(folder.makeRoom(50 * kibibyte).ok());
        QCOMPARE(filesIn(folder), std::size_t(0));
        QVERIFY(folder.take("key", 10, writing(10)).ok());
    }

    void waitingIsCancelled()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home);
        std::atomic<bool> begun = false, end = false;
        std::jthread maker([&] {
            (void)folder.take("key", 10, [&](const std::filesystem::path& path, const Progress& progress) {
                begun = true;
                while (!end)
                    std::this_thread::yield();
                return writing(10)(path, progress);
            });
        });
        while (!begun)
            std::this_thread::yield();
        std::stop_source stop;
        stop.request_stop();
        const auto file = folder.take("key", 10, neverCalled, Progress(stop.get_token(), {}));
        end = true;
        QCOMPARE(file.error().kind, ErrorKind::Cancelled);
    }

    void filesOfOthersStay()
    {
        const QTemporaryDir home;
        const CacheFolder folder = folderIn(home, 10 * kibibyte);
        std::ofstream(folder.path() / "letter.txt") << std::string(100'000, 'l');
        std::filesystem::create_symlink(folder.path() / "letter.txt", folder.path() / std::string(32, 'a'));
        folder.clear();
        QVERIFY(folder.makeRoom(kibibyte).ok());
        QCOMPARE(filesIn(folder), std::size_t(2));
    }

    void theFolderOfTheUser()
    {
        const QTemporaryDir home;
        const QByteArray cacheBefore = qgetenv("XDG_CACHE_HOME"), homeBefore = qgetenv("HOME");
        qputenv("XDG_CACHE_HOME", home.filePath("cache").toUtf8());
        const auto folder = CacheFolder::standard();
        qunsetenv("XDG_CACHE_HOME");
        qputenv("HOME", home.path().toUtf8());
        const auto below = CacheFolder::standard();
        qputenv("TAN_CACHE_MB", "12");
        const auto limited = CacheFolder::standard();
        qputenv("TAN_CACHE_MB", "much");
        const auto wrong = CacheFolder::standard();
        qunsetenv("TAN_CACHE_MB");
        qputenv("XDG_CACHE_HOME", "/proc/none");
        const auto none = CacheFolder::standard();
        cacheBefore.isNull() ? qunsetenv("XDG_CACHE_HOME") : qputenv("XDG_CACHE_HOME", cacheBefore);
        qputenv("HOME", homeBefore);
        QCOMPARE(folder->path(), std::filesystem::path(home.filePath("cache/tan").toStdString()));
        QCOMPARE(folder->limit(), CacheFolder::defaultLimit);
        QCOMPARE(below->path(), std::filesystem::path(home.filePath(".cache/tan").toStdString()));
        QCOMPARE(limited->limit(), std::uint64_t(12'000'000));
        QCOMPARE(wrong.error().kind, ErrorKind::WrongUsage);
        QCOMPARE(none.error().kind, ErrorKind::CannotWrite);
        QVERIFY2(none.error().text().find("XDG_CACHE_HOME") != std::string::npos, none.error().text().c_str());
    }
};

QTEST_APPLESS_MAIN(CacheFolderTest)
#include "cache_folder_test.moc"
