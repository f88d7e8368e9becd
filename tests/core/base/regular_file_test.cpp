// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that somebody names in place of a file makes the program wait.
#include "core/base/mapped_file.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace tetra;

class RegularFileTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void givesTheFrontAndTheWhole()
    {
        const auto path = written("text", std::string(200'000, 'x') + "end");
        const auto file = RegularFile::open(path);
        QVERIFY(file);
        QCOMPARE(file->size(), std::uint64_t(200'003));
        QCOMPARE(*file->front(3), std::string("xxx"));
        QCOMPARE(file->front(1'000'000)->size(), std::size_t(200'003));
        QVERIFY(file->front(1'000'000)->ends_with("xend"));
        QCOMPARE(wholeText(path, 200'003)->size(), std::size_t(200'003));
        QCOMPARE(wholeText(written("empty", ""), 10)->size(), std::size_t(0));
        const auto large = wholeText(path, 200'002);
        QVERIFY(!large && large.error().kind == ErrorKind::BadInput);
    }

    /// A header may name any file, which is missing then.
    void namesAreShownSafely()
    {
        const auto missing = RegularFile::open(folder_->filePath("a\x1b[31m\x1a.raw").toStdString());
        QVERIFY(!missing);
        const std::string text = missing.error().text();
        QVERIFY2(text.find('\x1b') == std::string::npos && text.find("\\x1a.raw") != std::string::npos, text.c_str());
    }

    void refusesWhatMayNeverEnd_data()
    {
        QTest::addColumn<QByteArray>("kind");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("a pipe") << QByteArray("pipe") << QByteArray("not a regular file");
        QTest::newRow("a link to a pipe") << QByteArray("link") << QByteArray("not a regular file");
        QTest::newRow("a device") << QByteArray("/dev/zero") << QByteArray("not a regular file");
        QTest::newRow("a socket") << QByteArray("socket") << QByteArray("not a regular file");
        QTest::newRow("a folder") << QByteArray("") << QByteArray("it is a folder");
        QTest::newRow("nothing") << QByteArray("nothing") << QByteArray("No such file");
    }

    void refusesWhatMayNeverEnd()
    {
        QFETCH(QByteArray, kind);
        QFETCH(QByteArray, says);
        const std::filesystem::path path = place(kind.toStdString());
        const std::filesystem::path pipe = place("pipe");
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        std::filesystem::create_symlink(pipe, place("link"));
        const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const std::string name = place("socket").string();
        QVERIFY(name.size() < sizeof address.sun_path);
        name.copy(address.sun_path, name.size());
        QCOMPARE(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
        const auto file = RegularFile::open(path);
        ::close(socket);
        QVERIFY(!file);
        QCOMPARE(file.error().kind, ErrorKind::BadInput);
        QVERIFY(file.error().text().find("'" + path.string() + "'") != std::string::npos);
        QCOMPARE(file.error().file, path);
        QVERIFY2(file.error().text().find(says) != std::string::npos, file.error().text().c_str());
        QVERIFY(!wholeText(path, 10));
    }

private:
    std::filesystem::path place(const std::string& name) const
    {
        return std::filesystem::path(folder_->path().toStdString()) / name;
    }
    std::filesystem::path written(const std::string& name, const std::string& content) const
    {
        std::ofstream(place(name), std::ios::binary) << content;
        return place(name);
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(RegularFileTest)
#include "regular_file_test.moc"
