// SPDX-License-Identifier: GPL-3.0-or-later
/// Parts of datasets, and files that need a description, by `tan`: a model knows how its dataset was opened.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class ImportOptionsTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path(), {}); }
    QString path(const char* name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        const Run sample = tan({"sample", "c60", "--size", "12", "-o", "c60.nrrd"});
        QVERIFY2(sample.exitCode == 0, sample.messages);
    }

    void aPartIsBuiltAndVerified()
    {
        const QStringList part = {"--region", "1,0,2,10,11,9", "--stride", "3,1,1"};
        const Run info = tan(QStringList{"info", "c60.nrrd", "--json"} + part);
        QVERIFY2(info.exitCode == 0, info.messages);
        QCOMPARE(info.json()["size"].toArray(), (QJsonArray{4, 12, 8}));
        QCOMPARE(info.json()["spacing"].toArray()[0].toDouble(),
                 3 * tan({"info", "c60.nrrd", "--json"}).json()["spacing"].toArray()[0].toDouble());
        const Run build = tan(QStringList{"build", "c60.nrrd", "-o", "part.tan", "--json"} + part);
        QVERIFY2(build.exitCode == 0, build.messages);
        QCOMPARE(tan({"verify", "part.tan", "--against", "c60.nrrd", "--lod", "1,0"}).exitCode, 0);
        QCOMPARE(tan({"verify", "part.tan", "--against", "c60.nrrd", "--lod", "1", "--stride", "2,1,1"}).exitCode, 1);
        QCOMPARE(tan({"info", "part.tan", "--json"}).json()["parameters"].toObject()["import.stride"].toString(),
                 QString("3,1,1"));
        for (const char* wrong : {"0,0,0,12,11,11", "0,0,0,11,11", "0,0,5,11,11,5"})
            QCOMPARE(tan({"build", "c60.nrrd", "--region", wrong, "-o", "no.tan"}).exitCode, 2);
        QCOMPARE(tan({"info", "part.tan", "--stride", "2"}).exitCode, 2);
        QVERIFY(!QFileInfo::exists(path("no.tan")));
    }

    /// The model knows its number, whatever it was called.
    void aTimeStepIsNamedByPlaceOrTime()
    {
        QFile file(path("steps.nrrd"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("NRRD0004\ntype: uint8\ndimension: 4\nsizes: 2 2 2 3\nkinds: domain domain domain time\n"
                   "spacings: 1 1 1 0.25\naxis mins: 0 0 0 1.5\nencoding: text\n\n"
                   "0 0 0 0 0 0 0 1\n1 1 1 1 1 1 1 2\n2 2 2 2 2 2 2 3\n");
        file.close();
        for (const char* const time : {"last", "t=2", "3"}) {
            const Run build = tan({"build", "steps.nrrd", "--time", time, "-o", "step.tan"});
            QVERIFY2(build.exitCode == 0, build.messages);
            const QJsonObject info = tan({"info", "step.tan", "--json"}).json();
            QCOMPARE(info["range"].toArray(), (QJsonArray{2, 3}));
            QCOMPARE(info["parameters"].toObject()["import.value.time"].toString(), QString("3"));
        }
        const Run none = tan({"info", "steps.nrrd", "--time", "t=1.9"});
        QCOMPARE(none.exitCode, 2);
        QVERIFY2(none.messages.contains("The nearest one is number 3, at 2."), none.messages);
        QVERIFY(tan({"info", "--help"}).output.contains("first|last|t=TIME"));
    }

    /// Where it lies in the world, of the data and of their model (D1).
    void aFrameIsTold()
    {
        QFile file(path("turned.nrrd"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 4 5\nencoding: raw\nspace: LPS\n"
                   "space directions: (0,2,0) (0,0,-3) (-4,0,0)\nspace origin: (10,20,30)\nspace units: \"mm\" \"mm\" "
                   "\"mm\"\n\n");
        for (int n = 0; n < 3 * 4 * 5; ++n)
            file.putChar(static_cast<char>(n * n % 251));
        file.close();
        const Run build = tan({"build", "turned.nrrd", "-o", "turned.tan"});
        QVERIFY2(build.exitCode == 0, build.messages);
        const QJsonArray directions{QJsonArray{0, 1, 0}, QJsonArray{0, 0, -1}, QJsonArray{-1, 0, 0}};
        for (const char* input : {"turned.nrrd", "turned.tan"}) {
            const Run info = tan({"info", input, "--json"});
            QVERIFY2(info.exitCode == 0, info.messages);
            QCOMPARE(info.json()["spacing"].toArray(), (QJsonArray{2, 3, 4}));
            QCOMPARE(info.json()["origin"].toArray(), (QJsonArray{10, 20, 30}));
            QCOMPARE(info.json()["directions"].toArray(), directions);
            QCOMPARE(info.json()["space"].toString(), QString("left-posterior-superior"));
            QCOMPARE(info.json()["unit"].toString(), QString("mm"));
            QCOMPARE(info.json()["bounds"].toArray(), (QJsonArray{QJsonArray{-6, 20, 21}, QJsonArray{10, 24, 30}}));
            const QByteArray text = tan({"info", input}).output;
            QVERIFY2(
                text.contains(
                    "spacing 2 x 3 x 4 mm, first point (10, 20, 30), axes along (0, 1, 0), (0, 0, -1), (-1, 0, 0)"),
                text);
            QVERIFY2(text.contains("coordinates left-posterior-superior"), text);
        }
        QCOMPARE(tan({"verify", "turned.tan", "--against", "turned.nrrd", "--lod", "1,0"}).exitCode, 0);
        const Run part = tan({"info", "turned.nrrd", "--json", "--region", "1,1,1,2,3,4"});
        QCOMPARE(part.json()["origin"].toArray(), (QJsonArray{6, 22, 27}));
        QCOMPARE(part.json()["directions"].toArray(), directions);
        // Files for other programs name the unit, where they can.
        QCOMPARE(tan({"extract", "turned.tan", "--error", "0", "-o", "turned.vtu"}).exitCode, 0);
        QVERIFY(readFile(path("turned.vtu")).left(600).contains("<!-- unit: mm -->"));
        for (const char* surface : {"turned.ply", "turned.stl"})
            QCOMPARE(tan({"isosurface", "turned.tan", "--value", "99.5", "-o", surface}).exitCode, 0);
        QVERIFY(readFile(path("turned.ply")).left(600).contains("\ncomment unit: mm\n"));
        QCOMPARE(readFile(path("turned.stl")).left(80).trimmed(), QByteArray("binary STL, in mm, isosurfaces by TAn"));
        const Run plain = tan({"info", "c60.nrrd", "--json"});
        QVERIFY(!plain.json().contains("directions") && !plain.json().contains("space"));
    }

    /// Hours since 1900 have seven digits.
    void timesAreToldApart()
    {
        QVERIFY(
            writeFile(path("steps.mha"),
                      "ObjectType = Image\nNDims = 4\nBinaryData = True\nDimSize = 2 2 2 3\nElementType = MET_UCHAR\n"
                      "ElementSpacing = 1 1 1 6\nOffset = 0 0 0 1073352\nElementDataFile = LOCAL\n" +
                          QByteArray("abcdefghijklmnopqrstuvwx")));
        const Run info = tan({"info", "steps.mha"});
        QVERIFY2(info.output.contains("time steps: 1 (time 1073352), 2 (time 1073358), 3 (time 1073364)\n"),
                 info.output + info.messages);
    }

    void aModelOfARawFileKnowsItsLayout()
    {
        QFile raw(path("samples.dat"));
        QVERIFY(raw.open(QIODevice::WriteOnly));
        for (int n = 0; n < 4 * 5 * 6; ++n)
            raw.putChar(static_cast<char>(n * 7));
        raw.close();
        const Run build = tan({"build", "samples.dat", "--reader", "lattice", "--size", "4x5x6", "-o", "raw.tan"});
        QVERIFY2(build.exitCode == 0, build.messages);
        const Run verified = tan({"verify", "raw.tan", "--against", "samples.dat"});
        QVERIFY2(verified.exitCode == 0, verified.messages);
        QCOMPARE(tan({"verify", "raw.tan", "--against", "samples.dat", "--size", "6x5x4"}).exitCode, 1);
        QCOMPARE(tan({"info", "samples.dat", "--reader", "magic"}).exitCode, 2);
    }
};

QTEST_GUILESS_MAIN(ImportOptionsTest)
#include "import_options_test.moc"
