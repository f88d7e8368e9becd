// SPDX-License-Identifier: GPL-3.0-or-later
/// What files and servers that are not to be trusted may do with `tan`: not command the terminal, not make it wait, not
/// fill its memory.
#include "core/base/checksum.h"
#include "tests/app/program.h"
#include "tests/core/remote/http_server.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <span>

#include <sys/resource.h>
#include <sys/stat.h>

using namespace tetra;

using Request = FaultyHttpServer::Request;
using Reply = FaultyHttpServer::Reply;

class UntrustedTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words, const QMap<QString, QString>& environment = {}) const
    {
        return runTan(words, folder_.path(), environment);
    }
    QString path(const QString& name) const { return folder_.filePath(name); }
    void write(const QString& name, const QByteArray& content) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    }
    /// Whether a terminal shows it as it stands.
    static bool isHarmless(const QByteArray& text)
    {
        const QByteArray marks[] = {"\xe2\x80\xae", "\xc2\x9b", "\xe2\x80\xa8"}; // U+202E, CSI of one character, U+2028
        return std::ranges::all_of(text, [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= ' '; }) &&
               std::ranges::none_of(marks, [&](const QByteArray& mark) { return text.contains(mark); });
    }
    static std::string address(const FaultyHttpServer& server) { return server.address("/x.tan"); }
    Run extracted(const FaultyHttpServer& server) const
    {
        return tan({"extract", QString::fromStdString(address(server)), "--at-server", "--error", "8", "-o", "x.vtu"});
    }

    QTemporaryDir folder_;
    const QString evil_ = QString::fromUtf8("a\x1b[31m\x1b]52;c;ZXZpbA==\a\u009b\u202e\u2028 b\nother.tan: proved");

private slots:
    void initTestCase()
    {
        QCOMPARE(tan({"sample", "c60", "--size", "8", "-o", "c60.nrrd"}).exitCode, 0);
        QVERIFY(QFile::copy(path("c60.nrrd"), path(evil_ + ".nrrd")));
        QVERIFY2(tan({"build", evil_ + ".nrrd", "-o", "m.tan"}).exitCode == 0, "a name is a name");
        QCOMPARE(::mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
        for (const char* name :
             {"pipe.tan", "pipe.nrrd", "pipe.vtu", "pipe.tansession", "pipe.png", "pipe.raw", "pipe.csv.gz"})
            QVERIFY(QFile::link("pipe", path(name)));
        write("of-pipe.vtm", "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\">"
                             "<vtkMultiBlockDataSet><DataSet index=\"0\" file=\"pipe.vtu\"/>"
                             "</vtkMultiBlockDataSet></VTKFile>\n");
        write("of-pipe.pvtu", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\">"
                              "<PUnstructuredGrid><Piece Source=\"pipe.vtu\"/></PUnstructuredGrid></VTKFile>\n");
        const QJsonObject session{{"format", "tan-session"},
                                  {"version", 1},
                                  {"model", QJsonObject{{"path", "m.tan"}}},
                                  {"look", QJsonObject{{"mode", evil_}}}};
        write("evil.tansession", QJsonDocument(session).toJson());
        write("of-pipe.nhdr",
              "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\ndata file: pipe.raw\n");
        write("of-pipe.mhd", "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = pipe.raw\n");
    }

    void textsAreShownAndNotObeyed_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("what a model says") << QStringList{"info", "m.tan"};
        QTest::newRow("a dataset's name") << QStringList{"info", evil_ + ".nrrd"};
        QTest::newRow("a proof") << QStringList{"verify", "m.tan", "--against", evil_ + ".nrrd", "--lod", "8"};
        QTest::newRow("a name that is not there") << QStringList{"info", evil_};
        QTest::newRow("a word") << QStringList{evil_ + "x", "y"};
        QTest::newRow("an option") << QStringList{"info", "m.tan", "--" + evil_};
        QTest::newRow("an output") << QStringList{"extract", "m.tan", "-o", evil_ + ".vtu"};
        QTest::newRow("an output of a build") << QStringList{"build", "c60.nrrd", "-o", evil_ + ".tan"};
        QTest::newRow("a surface") << QStringList{"isosurface", "m.tan", "--value", "100", "-o", evil_ + ".ply"};
        QTest::newRow("what a session says") << QStringList{"render", "evil.tansession", "-o", "x.png"};
        QTest::newRow("what a session says, strictly")
            << QStringList{"render", "evil.tansession", "--strict", "-o", "x.png"};
        QTest::newRow("for programs") << QStringList{"info", "m.tan", "--json"};
    }
    void textsAreShownAndNotObeyed()
    {
        QFETCH(QStringList, words);
        const Run run = tan(words);
        QVERIFY2(isHarmless(run.output), run.output);
        QVERIFY2(isHarmless(run.messages), run.messages);
        for (const QByteArray& line : (run.output + run.messages).split('\n'))
            QVERIFY2(!line.startsWith("other.tan: proved"), line);
    }

    /// For programs nothing is lost.
    void jsonIsExact() { QCOMPARE(tan({"info", "m.tan", "--json"}).json()["source"].toString(), evil_ + ".nrrd"); }

    void pipesAreNotWaitedFor_data()
    {
        QTest::addColumn<QStringList>("words");
        const auto row = [](const QStringList& words) { QTest::newRow(qPrintable(words.join(' '))) << words; };
        row({"info", "pipe.tan"});
        row({"extract", "pipe.tan", "-o", "x.vtu"});
        row({"isosurface", "pipe.tan", "--value", "9", "-o", "x.ply"});
        row({"render", "pipe.tan", "-o", "x.png"});
        row({"render", "pipe.tansession", "-o", "x.png"});
        row({"render", "pipe.png", "-o", "x.png"});
        row({"verify", "pipe.tan", "--against", "c60.nrrd"});
        row({"verify", "m.tan", "--against", "pipe.nrrd"});
        row({"pack", "pipe.tan", "-o", "x.tan"});
        row({"unpack", "pipe.tan", "-o", "x.tan"});
        row({"cut", "pipe.tan", "--error", "8", "-o", "x.tan"});
        row({"build", "pipe.nrrd", "-o", "x.tan"});
        row({"build", "pipe.csv.gz", "-o", "x.tan"});
        row({"build", "of-pipe.nhdr", "-o", "x.tan"});
        row({"build", "of-pipe.mhd", "-o", "x.tan"});
        row({"build", "of-pipe.vtm", "-o", "x.tan"});
        row({"build", "of-pipe.pvtu", "-o", "x.tan"});
        row({"render", "m.tan", "--camera", "pipe", "-o", "x.png"});
        row({"render", "m.tan", "--mode", "volume", "--transfer", "pipe", "-o", "x.png"});
        row({"serve", ".", "--token-file", "pipe"});
    }
    void pipesAreNotWaitedFor()
    {
        QFETCH(QStringList, words);
        const Run run = tan(words);
        QVERIFY2(run.exitCode == 2 || run.exitCode == 3, run.messages);
        QVERIFY2(run.messages.startsWith("tan: "), run.messages);
    }

    void whatAServerSaysIsShown()
    {
        const FaultyHttpServer server("", [](const Request&, std::size_t, Reply& reply) {
            reply.become(400,
                         "{\"error\": \"\\u001b[31mEVIL\\u001b]52;c;ZWNobyBoaQ==\\u0007\\u009b\\u202e\\n\\nx.vtu: 195 "
                         "vertices, 1104 tetrahedra\"}",
                         "application/json");
        });
        const Run run = extracted(server);
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(isHarmless(run.messages) && run.messages.count('\n') == 1, run.messages);
        QVERIFY2(run.messages.contains("\\x1b[31mEVIL"), run.messages);
    }

    /// Two megabytes that claim to be a mesh of 2^30 tetrahedra. It would be refused by a machine of any size.
    void aMeshThatCannotBeIsNotUnpacked()
    {
        QByteArray bytes("\x89TANM\r\n\x1a", 8);
        const auto add = [&bytes](auto number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
        constexpr qsizetype coded = 2 << 20;
        add(std::uint32_t(1)), add(std::uint32_t(0));
        add(std::uint64_t(1) << 29), add(std::uint64_t(1) << 30);
        add(std::uint32_t(2)), add(std::uint32_t(0)), add(std::uint64_t(coded));
        bytes += "{}" + QByteArray(coded, '\0');
        add(checksum(std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size())))));
        const FaultyHttpServer server("", [&](const Request&, std::size_t, Reply& reply) {
            reply.become(200, bytes.toStdString(), "application/vnd.tan.mesh");
        });
        constexpr rlim_t mostMemory = rlim_t(1) << 31;
        const Run run =
            runTan({"extract", QString::fromStdString(address(server)), "--at-server", "--error", "8", "-o", "x.vtu"},
                   folder_.path(), {}, [] {
                       const rlimit limit{mostMemory, mostMemory};
                       ::setrlimit(RLIMIT_AS, &limit);
                   });
        QVERIFY2(run.exitCode == 3 || run.exitCode == 4, run.messages);
        QVERIFY2(run.messages.contains("too many for the memory") || run.messages.contains("is not a packed mesh"),
                 run.messages);
    }

    /// At its limit: the same exit code however the server is asked, after it was asked again.
    void aServerAtItsLimit()
    {
        const FaultyHttpServer server("", [](const Request&, std::size_t, Reply& reply) {
            reply.become(503, "{\"error\": \"The server is busy.\"}", "application/json");
            reply.set("Retry-After", "0");
        });
        QCOMPARE(extracted(server).exitCode, 4);
        QVERIFY(server.requests().size() > 1);
        const auto before = server.requests().size();
        QCOMPARE(tan({"extract", QString::fromStdString(address(server)), "--error", "8", "-o", "x.vtu"}).exitCode, 4);
        QVERIFY(server.requests().size() > before + 1);
    }

    void passwordsAreNotTold()
    {
        for (const char* address : {"http://user:se/cret@127.0.0.1:1/x.tan", "http://user:secret@127.0.0.1:1/x.tan"}) {
            for (const QStringList& words :
                 {QStringList{"info", address}, QStringList{"extract", address, "--at-server", "-o", "x.vtu"}}) {
                const Run run = tan(words);
                QVERIFY(run.exitCode == 2 || run.exitCode == 3);
                QVERIFY2(!run.messages.contains("cret"), run.messages);
            }
        }
    }

    /// A folder that somebody else made the current one is no place for a user's plugins.
    void relativeFoldersAreIgnored()
    {
        const Run run = tan({"plugins"}, {{"XDG_DATA_HOME", "."}, {"HOME", folder_.path()}});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.output.contains("  " + path(".local/share/tan/plugins").toUtf8() + "\n"), run.output);
        QVERIFY2(!run.output.contains("  " + path("tan/plugins").toUtf8() + "\n"), run.output);
        const Run homeless = tan({"plugins"}, {{"HOME", ""}, {"XDG_DATA_HOME", ""}});
        QVERIFY2(!homeless.output.contains(".local/share"), homeless.output);
    }
};

QTEST_GUILESS_MAIN(UntrustedTest)
#include "untrusted_test.moc"
