// SPDX-License-Identifier: GPL-3.0-or-later
// The helper program has limits that fit the file, says which it met, can be cancelled at any time, and what is wrong
// with it or with the machine is told as that (issue 18, 8). Scripts stand for a helper that goes wrong.
#include "plugins/process/process_limits.h"
#include "plugins/process/reading_process.h"
#include "plugins/readers/vtk/vtk_findings.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"
#include "tests/soak.h"
#include "tests/waiting.h"

#include <QElapsedTimer>
#include <QTest>

#include <array>
#include <atomic>
#include <cerrno>
#include <future>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;
using namespace std::chrono_literals;

namespace {

constexpr std::uint64_t gibi = 1ULL << 30U;

/// Runs `work` in a process of its own: how it ended, and what it wrote to its standard error.
std::pair<int, std::string> inProcess(const std::function<void()>& work)
{
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0)
        qFatal("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDERR_FILENO);
        work();
        ::_exit(42);
    }
    ::close(ends[1]);
    std::string said;
    std::array<char, 256> part{};
    for (ssize_t count = 0; (count = ::read(ends[0], part.data(), part.size())) > 0;)
        said.append(part.data(), static_cast<std::size_t>(count));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), said};
}

void spin()
{
    for (std::atomic<std::uint64_t> i = 0;; ++i)
        ;
}

VtkRequest anyRequest()
{
    VtkRequest request;
    request.path = "/a.vti";
    return request;
}

Result<ReadAnswer> ask(const std::filesystem::path& helper, const VtkRequest& request, const Progress& progress,
                       std::chrono::milliseconds idle = std::chrono::minutes(10))
{
    return askReadingProgram(vtkReadingProgram(helper), requestText(request), request.path, progress, idle);
}

} // namespace

class VtkHelperTest : public QObject {
    Q_OBJECT

private slots:
    void limitsFitTheFile_data()
    {
        QTest::addColumn<quint64>("bytes");
        QTest::addColumn<quint64>("unpacked");
        QTest::addColumn<quint64>("machine");
        QTest::addColumn<quint64>("memory");
        QTest::addColumn<quint64>("seconds");
        QTest::newRow("small") << quint64(1000) << quint64(0) << quint64(64 * gibi) << quint64(2 * gibi) << quint64(60);
        QTest::newRow("30 times") << quint64(gibi / 2) << quint64(0) << quint64(64 * gibi) << quint64(15 * gibi)
                                  << quint64(60 + 1610);
        QTest::newRow("packed") << quint64(gibi / 10) << quint64(2 * gibi) << quint64(64 * gibi) << quint64(16 * gibi)
                                << quint64(60 + 6442);
        QTest::newRow("half of the machine")
            << quint64(10 * gibi) << quint64(0) << quint64(16 * gibi) << quint64(8 * gibi) << quint64(60 + 32212);
        QTest::newRow("a small machine") << quint64(1000) << quint64(0) << quint64(gibi) << quint64(gibi / 2)
                                         << quint64(60);
        QTest::newRow("nobody knows the machine")
            << quint64(1000) << quint64(0) << quint64(0) << quint64(2 * gibi) << quint64(60);
        QTest::newRow("no such file") << quint64(-1) << quint64(-1) << quint64(16 * gibi) << quint64(8 * gibi)
                                      << quint64(1'000'000);
    }
    void limitsFitTheFile()
    {
        QFETCH(quint64, bytes);
        QFETCH(quint64, unpacked);
        QFETCH(quint64, machine);
        const WorkLimits limits = limitsFor(bytes, unpacked, machine);
        QTEST(quint64(limits.memory), "memory");
        QTEST(quint64(limits.seconds), "seconds");
        QCOMPARE(limits.isHalfOfMachine, machine != 0 && limits.memory == machine / 2);
    }

    void timeIsLimited()
    {
        QElapsedTimer timer;
        timer.start();
        const auto [status, said] = inProcess([] {
            limitWork({.memory = 64 * gibi, .seconds = 1});
            spin();
        });
        QCOMPARE(status, EXIT_FAILURE);
        QVERIFY2(said.find(limitNote) == 0, said.c_str());
        QVERIFY(limitMessage(said.substr(limitNote.size()), "VTK").text().starts_with("VTK needs more than 1 seconds"));
    }

    void memoryIsLimited()
    {
        if (isInstrumented)
            QSKIP("skipped: sanitizers take more memory than any limit");
        const auto [status, said] = inProcess([] {
            limitWork({.memory = gibi, .seconds = 60});
            try {
                std::vector<char> much(2 * gibi, 1);
                ::_exit(much[0]);
            } catch (const std::bad_alloc&) {
                ::_exit(memoryLimitMet("VTK").kind == ErrorKind::OutOfResource ? 7 : 8);
            }
        });
        QCOMPARE(status, 7);
        QVERIFY2(said.find(limitNote) == 0, said.c_str());
        const std::string told = limitMessage(said.substr(limitNote.size()), "VTK").text();
        QVERIFY2(told.starts_with("VTK needs more than 1.1 GB of memory"), told.c_str());
        QVERIFY2(told.find("damaged") != std::string::npos, told.c_str());
    }

    /// Libraries that follow links of one file into another find no descriptor for it.
    void noSecondFileIsOpened()
    {
        const auto [status, said] = inProcess([] {
            allowOneFile();
            const int first = ::open("/dev/null", O_RDONLY), second = ::open("/dev/null", O_RDONLY);
            const bool isRefused = first >= 0 && second < 0 && errno == EMFILE;
            ::close(first);
            ::_exit(isRefused && ::open("/dev/null", O_RDONLY) >= 0 ? 7 : 8); // one after the other it may open many
        });
        QCOMPARE(status, 7);
    }

    /// What a file asks for is refused by the limit, not by the machine.
    void aFileThatAsksForMuchIsRefused()
    {
        if (!std::filesystem::exists(std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-vtk"))
            QSKIP("skipped: built without VTK");
        const auto read = builtVtkReader().read(
            folder_.write("huge.vtk", with(legacyText(), "DIMENSIONS 3 3 3", "DIMENSIONS 2000 2000 2000")), {}, {});
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find("GB of memory") != std::string::npos ||
                     read.error().text().find("damaged") != std::string::npos,
                 read.error().text().c_str());
    }

    void whatWentWrongIsTold_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* what, const QByteArray& script, ErrorKind kind, const char* told) {
            QTest::newRow(what) << script << int(kind) << QByteArray(told);
        };
        const QByteArray loader = "echo 'helper: error while loading shared libraries: libvtkIOXML-9.1.so.1: ";
        row("a library is missing", loader + "cannot open shared object file: No such file or directory' >&2; exit 127",
            ErrorKind::BadInput, "The VTK readers are not installed: libvtkIOXML-9.1.so.1");
        row("a library is broken", loader + "file too short' >&2; exit 127", ErrorKind::BadInput,
            "apt install libvtk9.1");
        row("no room for a library", loader + "failed to map segment from shared object' >&2; exit 127",
            ErrorKind::OutOfResource, "Close other programs");
        row("too many files for a library",
            loader + "cannot open shared object file: Too many open files' >&2; exit 127", ErrorKind::OutOfResource,
            "Close other programs");
        row("it broke down", "kill -SEGV $$", ErrorKind::BadInput,
            "a.vti': VTK's reader crashed, and TAn cannot tell why: the file may be damaged");
        row("the system ended it", "kill -KILL $$", ErrorKind::OutOfResource, "a.vti': the system ended VTK");
        row("it was ended by Ctrl-C", "kill -INT $$", ErrorKind::Cancelled, "Reading was cancelled.");
        row("nothing that makes sense", "head -c 100000 /dev/zero", ErrorKind::BadInput, "a.vti");
        row("a limit was met", "printf '\\ntan-read met a limit: memory 1073741824' >&2; exit 1",
            ErrorKind::OutOfResource, "a.vti': VTK needs more than 1.1 GB of memory");
    }
    void whatWentWrongIsTold()
    {
        QFETCH(QByteArray, script);
        QFETCH(int, kind);
        QFETCH(QByteArray, told);
        const auto read = VtkReader(scripted(script)).read(folder_.write("a.vti", vtiText()), {}, {});
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find(told.toStdString()) != std::string::npos, read.error().text().c_str());
        QCOMPARE(int(read.error().kind), kind);
    }

    void nothingIsLeftToStartIt()
    {
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_NOFILE, &before), 0);
        const auto helper = scripted("exit 1");
        const rlimit few{4, before.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &few);
        const auto answer = ask(helper, anyRequest(), {});
        ::setrlimit(RLIMIT_NOFILE, &before);
        QVERIFY(!answer.ok());
        QCOMPARE(int(answer.error().kind), int(ErrorKind::OutOfResource));
        QVERIFY2(answer.error().text().find("open files") != std::string::npos, answer.error().text().c_str());
    }

    void itCanBeCancelled_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::newRow("waiting") << QByteArray("exec sleep 1000");
        QTest::newRow("working") << QByteArray("while :; do :; done");
        QTest::newRow("talking") << QByteArray("exec yes p1234567"); // a progress, again and again
    }
    void itCanBeCancelled()
    {
        QFETCH(QByteArray, script);
        std::stop_source stop;
        const auto helper = scripted(script);
        auto answer =
            std::async(std::launch::async, [&] { return ask(helper, anyRequest(), Progress(stop.get_token(), {})); });
        QTest::qWait(200); // it has begun, mostly
        QElapsedTimer timer;
        timer.start();
        stop.request_stop();
        const auto given = answer.get();
        QVERIFY(!given.ok());
        QCOMPARE(int(given.error().kind), int(ErrorKind::Cancelled));
        QVERIFY2(timer.elapsed() < soon(1000), qPrintable(QString::number(timer.elapsed())));
    }

    /// As on a disk that does not answer. One that works is left to its own limits.
    void itIsEndedIfItDoesNothing()
    {
        const auto idle = ask(scripted("exec sleep 1000"), anyRequest(), {}, 300ms);
        QVERIFY(!idle.ok());
        QCOMPARE(int(idle.error().kind), int(ErrorKind::OutOfResource));
        QVERIFY2(idle.error().text().find("disk") != std::string::npos, idle.error().text().c_str());
        const auto busy =
            ask(scripted("i=0; while [ $i -lt 600000 ]; do i=$((i+1)); done; kill -SEGV $$"), anyRequest(), {}, 300ms);
        QVERIFY(!busy.ok());
        QVERIFY2(busy.error().text().find("crashed") != std::string::npos, busy.error().text().c_str());
    }

private:
    std::filesystem::path scripted(const QByteArray& text)
    {
        const auto path = folder_.write("helper" + QByteArray::number(++scripts_), "#!/bin/sh\n" + text + "\n");
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return path;
    }

    VtkFolder folder_;
    int scripts_ = 0;
};

QTEST_GUILESS_MAIN(VtkHelperTest)
#include "vtk_helper_test.moc"
