// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan extract -o -` and `tan isosurface -o -`: the file on standard output and nothing else there, all else on
/// standard error; and readers that go away.
#include "tests/app/program.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <pty.h>
#include <unistd.h>

using namespace tetra;

class StandardOutputTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words, const std::function<void()>& prepare = {}) const
    {
        return runTan(words, folder_.path(), {}, prepare);
    }
    QByteArray content(const QString& name) const
    {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Standard error as one object and nothing else.
    static QJsonObject told(const Run& run) { return QJsonDocument::fromJson(run.messages).object(); }

    const QStringList surface_ = {"isosurface", "c60.tan", "--value", "100"};
    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QCOMPARE(tan({"sample", "c60", "--size", "16", "-o", "c60.nrrd"}).exitCode, 0);
        QCOMPARE(tan({"build", "c60.nrrd", "-o", "c60.tan"}).exitCode, 0);
    }

    /// Byte for byte what a file of that ending has.
    void theBytesAreThoseOfTheFile_data()
    {
        QTest::addColumn<bool>("isMesh");
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"vtu", "vtk", "vtp", "ply", "stl", "obj", "glb"})
            for (const bool isMesh : {true, false})
                QTest::addRow("%s %s", isMesh ? "extract" : "isosurface", ending) << isMesh << QString(ending);
    }
    void theBytesAreThoseOfTheFile()
    {
        QFETCH(bool, isMesh);
        QFETCH(QString, ending);
        const QStringList words = isMesh ? QStringList{"extract", "c60.tan", "--error", "2"} : surface_;
        const QString name = "a." + ending;
        const Run file = tan(words + QStringList{"-o", name, "--json"});
        QCOMPARE(file.exitCode, 0);
        const Run stream = tan(words + QStringList{"-o", "-", "--format", ending, "--json"});
        QVERIFY2(stream.exitCode == 0, stream.messages);
        QVERIFY(!content(name).isEmpty());
        QVERIFY(stream.output == content(name));
        QJsonObject figures = told(stream), expected = file.json();
        QCOMPARE(figures.take("file").toString(), QString("-"));
        expected.remove("file");
        for (QJsonObject* object : {&figures, &expected})
            QVERIFY(object->take("seconds").isDouble());
        QCOMPARE(figures, expected);
        QVERIFY(!QFile::exists(folder_.filePath("-")));
    }

    void whatIsToldGoesToStandardError()
    {
        const Run run = tan(surface_ + QStringList{"--output=-", "--format", ".STL"});
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(run.output.startsWith("binary STL"));
        QVERIFY2(run.messages.contains("standard output: ") && run.messages.contains(" triangles from "), run.messages);
    }

    void errorsAreObjectsThereToo()
    {
        const auto isError = [this](const QStringList& words, int code, const char* text) {
            const Run run = tan(words + QStringList{"-o", "-", "--json"});
            const QJsonObject object = told(run);
            return run.exitCode == code && run.output.isEmpty() && object["exit_code"].toInt() == code &&
                   object["error"].toString().contains(text);
        };
        QVERIFY(isError(surface_, 2, "'-o -' needs to know the format"));
        QVERIFY(isError(surface_ + QStringList{"--format", "off"}, 2, "Choose one of these endings"));
        QVERIFY(isError({"extract", "none.tan", "--format", "vtu"}, 3, "none.tan"));
        QVERIFY(isError({"extract", "c60.tan", "--format", "vtu", "--eror", "2"}, 2, "'--error'"));
        const Run plain = tan({"extract", "none.tan", "-o", "-", "--format", "vtu"});
        QVERIFY(plain.exitCode == 3 && plain.output.isEmpty() && plain.messages.startsWith("tan: "));
    }

    /// Of a name, the ending says it; for other subcommands '-' is no output.
    void theFormatIsForStandardOutputAlone()
    {
        const Run named = tan(surface_ + QStringList{"-o", "a.stl", "--format", "stl"});
        QCOMPARE(named.exitCode, 2);
        QVERIFY2(named.messages.contains("'--format' can only be used with '-o -'"), named.messages);
        const Run picture = tan({"render", "c60.tan", "-o", "-", "--json"});
        QCOMPARE(picture.exitCode, 2);
        QVERIFY(picture.json().contains("error"));
    }

    void aReaderWhoLeavesIsTold()
    {
        for (const QStringList& words :
             {QStringList{"extract", "c60.tan", "--error", "0", "-o", "-", "--format", "vtu"},
              surface_ + QStringList{"--error", "0", "-o", "-", "--format", "obj"}}) {
            const Run run = tan(words, [] {
                std::array<int, 2> ends{};
                if (::pipe(ends.data()) == 0) {
                    ::dup2(ends[1], STDOUT_FILENO);
                    ::close(ends[0]);
                    ::close(ends[1]);
                }
            });
            QCOMPARE(run.exitCode, 4);
            QVERIFY2(run.messages.contains("the program that reads it has ended"), run.messages);
        }
    }

    void aFullDiskIsTold()
    {
        const Run run = tan({"extract", "c60.tan", "--error", "0", "-o", "-", "--format", "vtu"}, [] {
            const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
            ::dup2(full, STDOUT_FILENO);
        });
        QCOMPARE(run.exitCode, 4);
        QVERIFY2(run.messages.contains("No space left on device"), run.messages);
    }

    void terminalsAreSpared()
    {
        int master = -1, slave = -1;
        QCOMPARE(::openpty(&master, &slave, nullptr, nullptr, nullptr), 0);
        const Run run =
            tan(surface_ + QStringList{"-o", "-", "--format", "stl"}, [slave] { ::dup2(slave, STDOUT_FILENO); });
        ::close(slave);
        ::close(master);
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.messages.contains("Standard output is a terminal"), run.messages);
    }
};

QTEST_GUILESS_MAIN(StandardOutputTest)
#include "standard_output_test.moc"
