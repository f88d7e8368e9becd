// SPDX-License-Identifier: GPL-3.0-or-later
/// Bad input and bad usage: each with a clear message and its exit code, none a crash, nothing left behind (S20).
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/core/base/small_disk.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <cstddef>

#include <unistd.h>

using namespace tetra;

namespace {

/// Where the major version stands in a .tan file (core/history/FORMAT.md).
constexpr qsizetype majorVersionOffset = 8;

} // namespace

class BadInputTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QVERIFY(writeFile(path("good.nrrd"), nrrd("uint8", "6 6 6", bytes(216))));
        const Run build = tan({"build", "good.nrrd", "-o", "good.tan"});
        QVERIFY2(build.exitCode == 0, build.messages);
        const QByteArray model = readFile(path("good.tan"));
        QVERIFY(writeFile(path("half.tan"), model.first(model.size() / 2)));
        QVERIFY(writeFile(path("header.tan"), model.first(100)));
        QVERIFY(writeFile(path("empty.tan"), {}));
        QVERIFY(writeFile(path("text.tan"), "This is no model."));
        QByteArray later = model;
        later[majorVersionOffset] = static_cast<char>(later[majorVersionOffset] + 1);
        QVERIFY(writeFile(path("later.tan"), later));

        QVERIFY(tan({"sample", "part", "--size", "6", "-o", "part.vtu"}).exitCode == 0);
        const Run part = tan({"build", "part.vtu", "-o", "part.tan"});
        QVERIFY2(part.exitCode == 0, part.messages);

        QVERIFY(writeFile(path("empty.nrrd"), {}));
        QVERIFY(writeFile(path("truncated.nrrd"), nrrd("uint8", "6 6 6", bytes(100))));
        QVERIFY(writeFile(path("cut_in_header.nrrd"), nrrd("uint8", "6 6 6", {}).first(30)));
        QVERIFY(writeFile(path("nan.nrrd"), nrrd("float", "3 3 3", floatsWithNaN(27))));
        QVERIFY(writeFile(path("flat.nrrd"), nrrd("uint8", "1 5 5", bytes(25))));
        QVERIFY(writeFile(path("unknown_type.nrrd"), nrrd("quaternion", "3 3 3", bytes(27))));
        QVERIFY(writeFile(path("huge.nrrd"), nrrd("uint8", "100000 100000 100000", bytes(27))));
        QVERIFY(writeFile(path("wrong_size.raw"), bytes(100)));
        QVERIFY(writeFile(path("letter.txt"), "Dear reader"));
        QVERIFY(
            writeFile(path("detached.nhdr"),
                      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 3 3\nencoding: raw\ndata file: nowhere.raw\n"));
    }

    void isRefusedWithAText_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QString>("part"); // of the message
        const auto build = [](const char* input) { return QStringList{"build", input, "-o", "out.tan"}; };
        QTest::newRow("missing") << build("nothing.nrrd") << 3 << "does not exist";
        QTest::newRow("on a server") << build("http://127.0.0.1:9/a.nrrd") << 3 << "read from this computer only";
        QTest::newRow("empty") << build("empty.nrrd") << 3 << "empty";
        QTest::newRow("truncated") << build("truncated.nrrd") << 3 << "100";
        QTest::newRow("cut in the header") << build("cut_in_header.nrrd") << 3 << "cut_in_header.nrrd";
        QTest::newRow("wrong size for the description")
            << QStringList{"build", "wrong_size.raw", "--size", "4x4x4", "-o", "out.tan"} << 3 << "100";
        QTest::newRow("raw without a description") << build("wrong_size.raw") << 2 << "size";
        QTest::newRow("NaN in each cell") << build("nan.nrrd") << 3 << "finite value";
        QTest::newRow("1xNxM lattice") << build("flat.nrrd") << 3 << "1 x 5 x 5";
        QTest::newRow("unknown NRRD type") << build("unknown_type.nrrd") << 3 << "quaternion";
        QTest::newRow("larger than any memory") << build("huge.nrrd") << 3 << "huge.nrrd";
        QTest::newRow("an unknown format") << build("letter.txt") << 3 << "unknown format";
        QTest::newRow("samples missing") << build("detached.nhdr") << 3 << "nowhere.raw";
        QTest::newRow("a folder") << build(".") << 3 << "folder";
        QTest::newRow("a model instead of a dataset") << build("good.tan") << 3 << "is a TAn model";

        QTest::newRow("model missing") << QStringList{"info", "nothing.tan"} << 3 << "nothing.tan";
        QTest::newRow("model empty") << QStringList{"info", "empty.tan"} << 3 << "empty.tan";
        QTest::newRow("model truncated") << QStringList{"info", "half.tan"} << 3 << "half.tan";
        QTest::newRow("model cut in its header")
            << QStringList{"render", "header.tan", "-o", "x.png"} << 3 << "header.tan";
        QTest::newRow("model of a later version") << QStringList{"info", "later.tan"} << 3 << "version";
        QTest::newRow("a text called a model") << QStringList{"info", "text.tan"} << 3 << "not a TAn model";
        QTest::newRow("a dataset instead of a model")
            << QStringList{"isosurface", "good.nrrd", "--value", "5", "-o", "x.ply"} << 3 << "not a TAn model";
        QTest::newRow("verify against a missing file")
            << QStringList{"verify", "good.tan", "--against", "nothing.nrrd"} << 3 << "does not exist";

        QTest::newRow("unknown subcommand") << QStringList{"buil"} << 2 << "'build'";
        QTest::newRow("unknown option") << QStringList{"build", "good.nrrd", "-o", "out.tan", "--eror", "1"} << 2
                                        << "'--error'";
        QTest::newRow("decimal comma") << QStringList{"build", "good.nrrd", "-o", "out.tan", "--error", "1,5"} << 2
                                       << "1,5";
        QTest::newRow("error not a number")
            << QStringList{"build", "good.nrrd", "-o", "out.tan", "--error", "nan"} << 2 << "nan";
        QTest::newRow("negative error") << QStringList{"render", "good.tan", "-o", "x.png", "--error", "-1"} << 2
                                        << "-1";
        QTest::newRow("no threads") << QStringList{"build", "good.nrrd", "-o", "out.tan", "--threads", "0"} << 2
                                    << "threads";
        QTest::newRow("unknown builder") << QStringList{"build", "good.nrrd", "-o", "out.tan", "--builder", "magic"}
                                         << 2 << "refinement";
        QTest::newRow("unknown mode") << QStringList{"render", "good.tan", "-o", "x.png", "--mode", "magic"} << 2
                                      << "isosurface";
        QTest::newRow("unknown sample") << QStringList{"sample", "c61", "-o", "x.nrrd"} << 2 << "c60";
        QTest::newRow("sample without a file") << QStringList{"sample", "c60"} << 2 << "-o";
        QTest::newRow("sample too large")
            << QStringList{"sample", "c60", "--size", "99999", "-o", "x.nrrd"} << 2 << "2048";
        QTest::newRow("sample in an unknown format") << QStringList{"sample", "c60", "-o", "x.bmp"} << 2 << ".nrrd";
        QTest::newRow("picture in another format") << QStringList{"render", "good.tan", "-o", "x.bmp"} << 2 << ".png";
        QTest::newRow("picture of no size")
            << QStringList{"render", "good.tan", "--size", "0x9", "-o", "x.png"} << 2 << "--size";
        QTest::newRow("unknown backend") << QStringList{"render", "good.tan", "--backend", "ray", "-o", "x.png"} << 2
                                         << "cpu";
        QTest::newRow("unknown colour") << QStringList{"render", "good.tan", "--isovalue", "9:mauve", "-o", "x.png"}
                                        << 2 << "mauve";
        QTest::newRow("opacity above one")
            << QStringList{"render", "good.tan", "--isovalue", "9:red:2", "-o", "x.png"} << 2 << "opacity";
        QTest::newRow("surface in another format")
            << QStringList{"isosurface", "good.tan", "--value", "9", "-o", "x.off"} << 2 << ".ply";
        QTest::newRow("output is the input")
            << QStringList{"build", "good.nrrd", "-o", "./good.nrrd"} << 2 << "is the input";
        QTest::newRow("output is no model")
            << QStringList{"build", "good.nrrd", "-o", "letter.txt"} << 2 << "not a TAn model";
        QTest::newRow("output is only called a model")
            << QStringList{"build", "good.nrrd", "-o", "text.tan"} << 2 << "not a TAn model";
        QTest::newRow("output whose work folder has too long a name")
            << QStringList{"build", "good.nrrd", "-o", QString(249, 'm') + ".tan"} << 4 << "shorter name";
        QTest::newRow("mesh called like the dataset")
            << QStringList{"extract", "part.tan", "-o", "part.vtu"} << 2 << "same name as the dataset";
        QTest::newRow("surface called like the dataset")
            << QStringList{"isosurface", "part.tan", "--value", "0.5", "-o", "part.vtu"} << 2
            << "same name as the dataset";
        QTest::newRow("output in a missing folder")
            << QStringList{"build", "good.nrrd", "-o", "no/where.tan"} << 4 << "no";
        QTest::newRow("output is a folder")
            << QStringList{"render", "good.tan", "-o", "folder.png"} << 4 << "folder.png";
    }
    void isRefusedWithAText()
    {
        QFETCH(QStringList, words);
        QFETCH(int, exitCode);
        QFETCH(QString, part);
        QDir(folder_.path()).mkdir("folder.png");
        const QStringList before = QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden);
        const QByteArray letter = readFile(path("letter.txt")) + readFile(path("text.tan"));
        const Run run = tan(words);
        QVERIFY2(run.exitCode == exitCode, QByteArray::number(run.exitCode) + ": " + run.messages);
        QVERIFY2(run.output.isEmpty(), run.output);
        QVERIFY2(run.messages.startsWith("tan: ") && QString::fromUtf8(run.messages).contains(part), run.messages);
        QCOMPARE(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
        QCOMPARE(readFile(path("letter.txt")) + readFile(path("text.tan")), letter);
    }

    void aReadOnlyTargetIsSpared()
    {
        QVERIFY(QFile::copy(path("good.tan"), path("locked.tan")));
        QFile locked(path("locked.tan"));
        QVERIFY(locked.setPermissions(QFile::ReadOwner));
        const QByteArray before = readFile(path("locked.tan"));
        const Run run = tan({"build", "good.nrrd", "-o", "locked.tan"});
        QVERIFY2(run.exitCode == 4, run.messages);
        QVERIFY2(run.messages.contains("locked.tan"), run.messages);
        QCOMPARE(readFile(path("locked.tan")), before);
    }

    void anUnreadableInputIsNamed()
    {
        if (geteuid() == 0)
            QSKIP("skipped: root may read everything");
        QVERIFY(QFile::copy(path("good.nrrd"), path("secret.nrrd")));
        QVERIFY(QFile(path("secret.nrrd")).setPermissions(QFileDevice::Permissions()));
        QCOMPARE(tan({"info", "secret.nrrd"}).exitCode, 3);
    }

    void aFullDiskLeavesNothing_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("build") << QStringList{"build", "good.nrrd", "-o"};
        QTest::newRow("sample") << QStringList{"sample", "noise", "--size", "64", "-o"};
        QTest::newRow("extract") << QStringList{"extract", "good.tan", "--error", "0", "-o"};
        QTest::newRow("isosurface") << QStringList{"isosurface", "good.tan", "--value", "128", "--error", "0", "-o"};
        QTest::newRow("render") << QStringList{"render", "good.tan", "--size", "400x400", "-o"};
    }
    void aFullDiskLeavesNothing()
    {
        QFETCH(QStringList, words);
        const SmallDisk disk(4096);
        if (!disk.ok())
            QSKIP("skipped: no right to mount a small disk");
        const QHash<QString, QString> endings = {{"build", "x.tan"},
                                                 {"sample", "x.nrrd"},
                                                 {"extract", "x.vtu"},
                                                 {"isosurface", "x.ply"},
                                                 {"render", "x.png"}};
        const QString folder = QString::fromStdString(disk.folder().string());
        const Run run = tan(words + QStringList{folder + "/" + endings[words[0]]});
        QVERIFY2(run.exitCode == 4, run.messages);
        QVERIFY2(run.messages.contains("space") || run.messages.contains("full"), run.messages);
        QVERIFY(QDir(folder).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

    void aFullStandardOutputIsAnError()
    {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.setStandardOutputFile("/dev/full");
        process.start(tanProgram(), {"info", "good.tan"});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 4);
    }

    void errorsAreEnglishInEveryCountry_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("of our own") << QStringList{"info", "missing.tan"} << QByteArray("No such file or directory");
        QTest::newRow("of Qt") << QStringList{"render", "good.tan", "-o",         "x.png",
                                              "--mode", "volume",   "--transfer", "good.tan/x.json"}
                               << QByteArray("Not a directory");
    }
    void errorsAreEnglishInEveryCountry()
    {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, reason);
        if (!QFile::exists(TAN_BINARY_DIR "/tests/locales/de_DE.UTF-8/LC_NUMERIC") ||
            !QFile::exists("/usr/share/locale/de/LC_MESSAGES/libc.mo"))
            QSKIP("skipped: no German on this machine (packages locales, libc-l10n)");
        const Run run = runTan(words, folder_.path(), {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}});
        QVERIFY(run.exitCode == 2 || run.exitCode == 3);
        QVERIFY2(run.messages.contains(reason), run.messages);
    }
};

QTEST_GUILESS_MAIN(BadInputTest)
#include "bad_input_test.moc"
