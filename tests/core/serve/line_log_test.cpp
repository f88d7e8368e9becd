// SPDX-License-Identifier: GPL-3.0-or-later
// Who writes a log does not wait for who reads it, and what was left out is counted.
#include "core/serve/line_log.h"
#include "tests/waiting.h"

#include <QtTest>

#include <array>
#include <optional>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace {

class Pipe {
public:
    /// A small one takes a line, and the next one when that is read.
    explicit Pipe(int size = 4096)
    {
        isThere_ = ::pipe2(ends_.data(), O_CLOEXEC) == 0 && ::fcntl(ends_[1], F_SETPIPE_SZ, size) > 0;
    }
    ~Pipe()
    {
        ::close(ends_[0]);
        ::close(ends_[1]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    bool isThere() const { return isThere_; }
    int end() const { return ends_[1]; }
    /// What has come until now.
    QByteArray read() const
    {
        QByteArray all;
        std::array<char, 4096> piece{};
        for (pollfd place{.fd = ends_[0], .events = POLLIN, .revents = 0}; ::poll(&place, 1, 0) > 0;)
            all.append(piece.data(), qsizetype(::read(ends_[0], piece.data(), piece.size())));
        return all;
    }

private:
    std::array<int, 2> ends_{};
    bool isThere_ = false;
};

std::string lineOf(int number)
{
    return std::to_string(number) + " " + std::string(90, '.');
}

} // namespace

class LineLogTest : public QObject {
    Q_OBJECT

private slots:
    void linesComeInOrder()
    {
        const Pipe pipe(65536);
        QVERIFY(pipe.isThere());
        QByteArray expected;
        {
            tetra::LineLog log(pipe.end());
            for (int i = 0; i < 20; ++i) {
                log.add(lineOf(i));
                expected += QByteArray::fromStdString(lineOf(i) + "\n");
            }
        }
        QCOMPARE(pipe.read(), expected);
    }

    /// With nobody reading, lines are added and the log ends; the test would hang otherwise.
    void nobodyNeedsToRead()
    {
        const Pipe pipe;
        QVERIFY(pipe.isThere());
        {
            tetra::LineLog log(pipe.end(), 100);
            for (int i = 0; i < 5000; ++i)
                log.add(lineOf(i));
        }
        QVERIFY(!tetra::takesText(pipe.end()));
        QVERIFY(pipe.read().startsWith(QByteArray::fromStdString(lineOf(0) + "\n")));
        QVERIFY(tetra::takesText(pipe.end()));
    }

    void whatWasLeftOutIsCounted()
    {
        const Pipe pipe;
        QVERIFY(pipe.isThere());
        constexpr int lines = 1000;
        tetra::LineLog log(pipe.end(), 10);
        for (int i = 0; i < lines; ++i)
            log.add(lineOf(i));
        // Ends are added until one finds room; those before it are among the lines that are missing.
        QByteArray all;
        static const QRegularExpression end("^end (\\d+)\n", QRegularExpression::MultilineOption);
        QVERIFY(tetra::waitFor([&, i = 0]() mutable {
            log.add("end " + std::to_string(i++));
            all += pipe.read();
            return end.match(QString::fromLatin1(all)).hasMatch();
        }));
        int read = 0, missing = 0;
        for (const QByteArray& line : all.left(all.indexOf("end ")).split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (line.contains("missing"))
                missing += words[0].toInt();
            else if (!line.isEmpty())
                ++read;
        }
        QVERIFY(read >= 10 && missing > 0);
        QCOMPARE(read + missing, lines + end.match(QString::fromLatin1(all)).captured(1).toInt());
    }

    void longLinesAreCut()
    {
        const Pipe pipe;
        QVERIFY(pipe.isThere());
        {
            tetra::LineLog log(pipe.end());
            log.add(std::string(10'000, 'x'));
        }
        const QByteArray line = pipe.read();
        QVERIFY(line.size() == 4096 && line.endsWith("x\n"));
    }
};

QTEST_GUILESS_MAIN(LineLogTest)
#include "line_log_test.moc"
