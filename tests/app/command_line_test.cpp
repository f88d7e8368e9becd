// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan` as a program, from sample to picture: JSON keys, exit codes, what goes to which stream.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/lacks.h"
#include "tests/plugins/writers/vtk_reader.h"

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace tetra;

class CommandLineTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words, const QMap<QString, QString>& environment = {}) const
    {
        return runTan(words, folder_.path(), environment);
    }
    QString path(const char* name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        const Run sample = tan({"sample", "c60", "--size", "12", "-o", "c60.nrrd", "--json"});
        QVERIFY2(sample.exitCode == 0, sample.messages);
        const QJsonObject made = sample.json();
        QCOMPARE(made["file"].toString(), QString("c60.nrrd"));
        QCOMPARE(made["kind"].toString(), QString("regular"));
        QCOMPARE(made["points"].toInt(), 12 * 12 * 12);
        QCOMPARE(made["cells"].toInt(), 11 * 11 * 11);

        const Run build = tan({"build", "c60.nrrd", "-o", "c60.tan", "--json"});
        QVERIFY2(build.exitCode == 0, build.messages);
        const QJsonObject built = build.json();
        QCOMPARE(built["model"].toString(), QString("c60.tan"));
        QCOMPARE(built["builder"].toString(), QString("refinement"));
        QVERIFY(built["sites"].toInt() > 8 && built["sites"].toInt() <= 12 * 12 * 12);
        QVERIFY(built["tetrahedra"].toInt() > 5);
        QVERIFY(built["seconds"].toDouble(-1) >= 0);
        QVERIFY(built["peak_bytes"].toDouble() > 1e6);
        QCOMPARE(built["inverted"].toInt(-1), 0);
        QCOMPARE(built["degenerate"].toInt(-1), 0);
    }

    void whatIsOfNoUseIsRefused_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const QStringList& words, const char* message) {
            QTest::newRow(name) << words << QByteArray(message);
        };
        const char* const warping = "'--warping' is for models of curvilinear or irregular data only";
        row("levels of a dataset", {"info", "c60.nrrd", "--lod", "1"}, "'--lod' is of the levels of a model");
        row("warping of a dataset", {"info", "c60.nrrd", "--warping", "1"}, "'--warping' is of the levels");
        row("info, warping", {"info", "c60.tan", "--warping", "1"}, warping);
        row("verify, warping", {"verify", "c60.tan", "--against", "c60.nrrd", "--warping", "1"}, warping);
        row("extract, warping", {"extract", "c60.tan", "--warping", "1", "-o", "refused.vtu"}, warping);
        row("isosurface, warping", {"isosurface", "c60.tan", "--warping", "1", "--value", "99", "-o", "refused.ply"},
            warping);
        row("render, warping", {"render", "c60.tan", "--warping", "1", "-o", "refused.png"}, warping);
        row("sample without chance", {"sample", "c60", "--seed", "2", "-o", "refused.nrrd"},
            "'--seed' is for samples with random values");
    }
    void whatIsOfNoUseIsRefused()
    {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, message);
        const Run run = tan(words);
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.messages.contains(message), run.messages);
        QVERIFY(QDir(path("")).entryList({"refused.*"}).isEmpty());
        QCOMPARE(tan({"sample", "noise", "--size", "8", "--seed", "2", "-o", "seeded.nrrd"}).exitCode, 0);
    }

    void infoTellsTheLevels()
    {
        const Run run = tan({"info", "c60.tan", "--lod", "4,.5,0", "--json"});
        QCOMPARE(run.exitCode, 0);
        const QJsonObject info = run.json();
        QCOMPARE(info["kind"].toString(), QString("regular"));
        QCOMPARE(info["points"].toInt(), 12 * 12 * 12);
        QCOMPARE(info["cells"].toInt(), 11 * 11 * 11);
        QCOMPARE(info["range"].toArray().size(), 2);
        QCOMPARE(info["bytes"].toInteger(), QFileInfo(path("c60.tan")).size());
        const QJsonArray levels = info["levels"].toArray();
        QCOMPARE(levels.size(), 3);
        QCOMPARE(levels[1].toObject()["error"].toDouble(), 0.5);
        QCOMPARE(levels[1].toObject()["warping"].toDouble(-1), 0.0);
        QVERIFY(levels[0].toObject()["sites"].toInt() < levels[1].toObject()["sites"].toInt());
        QCOMPARE(levels[2].toObject()["sites"].toInt(), info["sites"].toInt());
        QVERIFY(levels[2].toObject()["tetrahedra"].toInt() < info["tetrahedra"].toInt());
    }

    void infoWritesStatistics()
    {
        const QJsonArray levels = tan({"info", "c60.tan", "--lod", "4,.5", "--json"}).json()["levels"].toArray();
        QVERIFY(tan({"info", "c60.tan", "--lod", "4,.5", "-o", "levels.csv"}).exitCode == 0);
        QVERIFY(tan({"info", "c60.tan", "--lod", "4,.5", "-o", "levels.json"}).exitCode == 0);
        QFile json(path("levels.json")), csv(path("levels.csv"));
        QVERIFY(json.open(QIODevice::ReadOnly) && csv.open(QIODevice::ReadOnly));
        const QJsonObject told = QJsonDocument::fromJson(json.readAll()).object();
        QCOMPARE(told["levels"].toArray(), levels);
        QCOMPARE(told["model"].toString(), QString("c60.tan"));
        const QList<QByteArray> lines = csv.readAll().split('\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0], QByteArray("error_percent,warping_percent,sites,tetrahedra,reached_error_percent,"
                                      "reached_warping_percent"));
        const QList<QByteArray> cells = lines[2].split(',');
        QCOMPARE(cells[0], QByteArray("0.5"));
        QCOMPARE(cells[2].toLongLong(), levels[1].toObject()["sites"].toInteger());
        QCOMPARE(cells[3].toLongLong(), levels[1].toObject()["tetrahedra"].toInteger());
        QCOMPARE(cells[4].toDouble(), levels[1].toObject()["reached"].toDouble());
        QCOMPARE(lines[3], QByteArray());
        for (const char* wrong : {"levels.txt", "levels", "c60.tan"}) {
            const Run run = tan({"info", "c60.tan", "-o", wrong});
            QVERIFY2(run.exitCode == 2, run.messages);
        }
        const Run dataset = tan({"info", "c60.nrrd", "-o", "dataset.csv"});
        QVERIFY2(dataset.exitCode == 2 && dataset.messages.contains("model"), dataset.messages);
        QVERIFY(!QFile::exists(path("dataset.csv")));
    }

    void infoTellsADataset()
    {
        const QJsonObject info = tan({"info", "c60.nrrd", "--json"}).json();
        QCOMPARE(info["kind"].toString(), QString("regular"));
        QCOMPARE(info["points"].toInt(), 12 * 12 * 12);
        QVERIFY(!info.contains("sites"));
    }

    /// D3: what was taken of a file, what it offers and what is not used, by the dataset and by its model; a guess is
    /// called one.
    void whatWasTakenIsTold()
    {
        QFile table(path("two.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("x,y,z,heat,load\n0,0,0,1,7\n1,0,0,2,5\n0,1,0,3,9\n0,0,1,4,6\n1,1,1,4,1\n");
        table.close();
        const QJsonObject info = tan({"info", "two.csv", "--json"}).json();
        QCOMPARE(info["taken"]["array"].toString(), QString("heat"));
        QVERIFY(info["guesses"].toArray().contains("array"));
        QCOMPARE(info["arrays"].toArray().size(), 2);
        QCOMPARE(info["arrays"][1]["name"].toString(), QString("load"));
        QCOMPARE(info["arrays"][1]["on"].toString(), QString("points"));
        for (const QString list : {"steps", "blocks", "series", "channels", "unused"})
            QVERIFY2(info[list].isArray() && info[list].toArray().isEmpty(), qPrintable(list));
        const Run text = tan({"info", "two.csv"});
        QVERIFY2(text.output.contains("array: heat (a guess)") && text.output.contains("  load\n"), text.output);

        QFile units(path("units.csv"));
        QVERIFY(units.open(QIODevice::WriteOnly));
        units.write("x,y,z,heat (K),load [Pa]\n0,0,0,1,7\n1,0,0,2,5\n0,1,0,3,9\n0,0,1,4,6\n1,1,1,4,1\n");
        units.close();
        const Run withUnits = tan({"info", "units.csv"});
        QVERIFY2(withUnits.output.contains("  heat, in K\n") && withUnits.output.contains("  load, in Pa\n"),
                 withUnits.output);

        const QJsonObject build = tan({"build", "two.csv", "--array", "load", "-o", "two.tan", "--json"}).json();
        QCOMPARE(build["taken"]["array"].toString(), QString("load"));
        for (const QStringList& words :
             {QStringList{"info", "two.tan", "--json"}, {"info", "two.packed.tan", "--json"}}) {
            if (words[1] == "two.packed.tan")
                QCOMPARE(tan({"pack", "two.tan", "-o", words[1]}).exitCode, 0);
            const QJsonObject model = tan(words).json();
            QCOMPARE(model["taken"]["array"].toString(), QString("load"));
            QVERIFY(!model["guesses"].toArray().contains("array"));
        }
        QCOMPARE(tan({"info", "two.tan", "--ranges"}).exitCode, 2);
        QCOMPARE(tan({"info", "two.tan", "--error", "1"}).exitCode, 2);
    }

    /// Files that take a while are told by their headers, unless their values are asked for.
    void aLargeFileIsToldByItsHeader()
    {
        QFile header(path("large.nhdr"));
        QVERIFY(header.open(QIODevice::WriteOnly));
        header.write("NRRD0004\ndimension: 3\nsizes: 512 512 300\ntype: uint8\nencoding: raw\ndata file: large.raw\n");
        header.close();
        QFile samples(path("large.raw"));
        QVERIFY(samples.open(QIODevice::WriteOnly) && samples.resize(512 * 512 * 300));
        const QJsonObject read = tan({"info", "large.nhdr", "--json"}).json(); // the header itself is small
        QVERIFY(read.contains("range"));
        const QStringList words = {"info", "large.raw", "--size", "512x512x300", "--json"};
        const QJsonObject info = tan(words).json();
        QVERIFY(!info.contains("range"));
        QCOMPARE(info["points"].toInt(), 512 * 512 * 300);
        QCOMPARE(info["type"].toString(), QString("uint8"));
        QVERIFY(!info["estimates"].toArray().isEmpty());
        QVERIFY(tan(words + QStringList{"--ranges"}).json().contains("range"));
        QFile::remove(path("large.raw"));
    }

    /// What a coarser model takes is less.
    void theEstimateIsForAnError()
    {
        const auto bytes = [this](const QString& error) {
            for (const QJsonValue& one :
                 tan({"info", "c60.nrrd", "--error", error, "--json"}).json()["estimates"].toArray())
                if (one["builder"].toString() == "refinement")
                    return one["disk_bytes"].toDouble();
            return 0.;
        };
        QVERIFY(bytes("10") > 0);
        QVERIFY(bytes("10") < bytes("0"));
    }

    void verifyProves()
    {
        const Run run = tan({"verify", "c60.tan", "--against", "c60.nrrd", "--lod", "2,0", "--json"});
        QVERIFY2(run.exitCode == 0, run.output + run.messages);
        const QJsonObject verdict = run.json();
        QVERIFY(verdict["ok"].toBool());
        QCOMPARE(verdict["levels"].toArray().size(), 2);
        for (const QJsonValue entry : verdict["levels"].toArray()) {
            const QJsonObject level = entry.toObject();
            QVERIFY(level["ok"].toBool() && level["conforming"].toBool() && level["covers"].toBool());
            QCOMPARE(level["inverted"].toInt(-1), 0);
            QVERIFY(level["largest_error"].toDouble(100) <= level["error"].toDouble());
            QCOMPARE(level["largest_warping"].toDouble(-1), 0.0);
            QCOMPARE(level["failures"].toArray().size(), 0);
        }
    }

    /// R6: given one by one, kept in the model, told by info and understood by verify.
    void weightsAreKeptAndProved()
    {
        const Run build = tan({"build", "c60.nrrd", "-o", "weighted.tan", "--weight", "point:3,3,3,4", "--weight",
                               "value:120,30,0.2", "--json"});
        QVERIFY2(build.exitCode == 0, build.messages);
        QCOMPARE(tan({"info", "weighted.tan", "--json"}).json()["parameters"].toObject()["weights"].toString(),
                 QString("point:3,3,3,4;value:120,30,0.2"));
        QVERIFY(tan({"info", "weighted.tan"}).output.contains("weights point:3,3,3,4;value:120,30,0.2"));
        const Run verify = tan({"verify", "weighted.tan", "--against", "c60.nrrd"});
        QVERIFY2(verify.exitCode == 0, verify.output);
        const Run refused = tan({"build", "c60.nrrd", "-o", "weighted.tan", "--weight", "point:3,3,3"});
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("it has 3 numbers, and the form is point:x,y,z,reach"), refused.messages);
    }

    /// R1: from scattered points to the proof; what reading changed is told.
    void scatteredPointsAreBuiltAndProved()
    {
        const Run sample = tan({"sample", "scattered", "--size", "8", "-o", "ball.csv", "--json"});
        QVERIFY2(sample.exitCode == 0, sample.messages);
        QCOMPARE(sample.json()["kind"].toString(), QString("scattered"));
        QCOMPARE(sample.json()["points"].toInt(), 512);
        const Run build = tan({"build", "ball.csv", "-o", "ball.tan", "--weight", "point:0,0,0,0.5", "--json"});
        QVERIFY2(build.exitCode == 0, build.messages);
        QVERIFY(build.json()["remarks"].toArray().isEmpty());
        QCOMPARE(tan({"info", "ball.tan", "--json"}).json()["kind"].toString(), QString("scattered"));
        const Run verify = tan({"verify", "ball.tan", "--against", "ball.csv", "--json"});
        QVERIFY2(verify.exitCode == 0, verify.output);

        QFile table(path("twice.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("x,y,z,v\n0,0,0,1\n1,0,0,2\n0,1,0,3\n0,0,1,4\n0,0,0,3\n");
        table.close();
        const QJsonArray remarks = tan({"info", "twice.csv", "--json"}).json()["remarks"].toArray();
        QCOMPARE(remarks.size(), 1);
        QVERIFY(remarks[0].toString().startsWith("1 point at the same place as another was merged"));
        QVERIFY(tan({"build", "twice.csv", "-o", "twice.tan"}).output.contains(remarks[0].toString().toUtf8()));
    }

    /// C10, C11: cells that overlap are listed alike by info, build and verify; the distance is limited from both
    /// sides.
    void faultyCellsAreListedAndBothSidesKept()
    {
        // 4 x 4 x 4 cubes in six tetrahedra each, and two tetrahedra among them, less than a thousandth of the volume.
        constexpr int side = 5, cubes = side - 1;
        QByteArray points, cells, values;
        int pointCount = 0, cellCount = 0;
        const auto addPoint = [&](double x, double y, double z) {
            points += QByteArray::number(++pointCount) + ' ' + QByteArray::number(x) + ' ' + QByteArray::number(y) +
                      ' ' + QByteArray::number(z) + '\n';
            values += QByteArray::number(pointCount) + ' ' + QByteArray::number(x * x - y + 0.5 * z) + '\n';
        };
        const auto addCell = [&](int a, int b, int c, int d) {
            cells += QByteArray::number(++cellCount) + " 1 tet";
            for (const int corner : {a, b, c, d})
                cells += ' ' + QByteArray::number(corner + 1);
            cells += '\n';
        };
        for (int point = 0; point < side * side * side; ++point)
            addPoint(point % side, point / side % side, point / side / side);
        for (int cube = 0; cube < cubes * cubes * cubes; ++cube) {
            const int first = cube % cubes + side * (cube / cubes % cubes) + side * side * (cube / cubes / cubes);
            std::array<int, 3> steps{1, side, side * side};
            std::ranges::sort(steps);
            do
                addCell(first, first + steps[0], first + steps[0] + steps[1], first + 1 + side + side * side);
            while (std::ranges::next_permutation(steps).found);
        }
        const int sound = cellCount;
        for (const double at : {1.2, 2.3}) {
            const int first = pointCount;
            addPoint(at, at, at);
            addPoint(at + 0.5, at, at);
            addPoint(at, at + 0.5, at);
            addPoint(at, at, at + 0.5);
            addCell(first, first + 1, first + 2, first + 3);
        }
        const QByteArray head = QByteArray::number(pointCount) + ' ' + QByteArray::number(cellCount) + " 1 0 0\n";
        QVERIFY(writeFile(path("faulty.inp"), head + points + cells + "1 1\nvalue, none\n" + values));

        const Run info = tan({"info", "faulty.inp", "--json"});
        QVERIFY2(info.exitCode == 0, info.messages);
        const QJsonArray faulty = info.json()["faulty_cells"].toArray();
        QCOMPARE(faulty, (QJsonArray{QJsonObject{{"cell", sound}, {"fault", "overlap"}},
                                     QJsonObject{{"cell", sound + 1}, {"fault", "overlap"}}}));
        QCOMPARE(info.json()["faulty_cell_count"].toInt(), 2);
        const Run build = tan({"build", "faulty.inp", "--builder", "decimation", "--distance", "two-sided", "-o",
                               "faulty.tan", "--json"});
        QVERIFY2(build.exitCode == 0, build.messages);
        QCOMPARE(build.json()["faulty_cells"].toArray(), faulty);
        QVERIFY(QJsonDocument(build.json()["remarks"].toArray()).toJson().contains("2 cells were left out: they over"));
        const Run verify = tan({"verify", "faulty.tan", "--against", "faulty.inp", "--lod", "10,1,0", "--json"});
        QVERIFY2(verify.exitCode == 0, verify.messages);
        QCOMPARE(verify.json()["faulty_cells"].toArray(), faulty);
        for (const QJsonValue& level : verify.json()["levels"].toArray())
            QVERIFY(level["two_sided_warping"].toDouble(100) <= level["warping"].toDouble() + 1e-9);
        const Run refused =
            tan({"build", "c60.nrrd", "--builder", "decimation", "--distance", "two-sided", "-o", "no.tan"});
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("--distance"), refused.messages);
        const Run ofModel = tan({"info", "faulty.tan", "--json"});
        QCOMPARE(ofModel.json()["faulty_cells"].toArray(), faulty);
        faultyCellsAreOutlined("cpu");
        if (!QTest::currentTestFailed() && tan({"render", "c60.tan", "--backend", "gl", "-o", "gl.png"}).exitCode == 0)
            faultyCellsAreOutlined("gl");
        QCOMPARE(tan({"pack", "faulty.tan", "-o", "faulty-packed.tan"}).exitCode, 0); // whose beginning lists none
        const Run packed =
            tan({"render", "faulty-packed.tan", "--error", "10", "--faulty-cells", "-o", "packed.png", "--json"});
        QVERIFY2(packed.exitCode == 0, packed.messages);
        QCOMPARE(packed.json()["faulty_cells_outlined"].toInt(), 2);
    }

private:
    /// Those of faulty.tan, tetrahedra of the edge 0.5 with their corners at 1.2 and 2.3, seen along y: the picture
    /// differs along their edges, all of them, and nowhere else.
    void faultyCellsAreOutlined(const QString& backend)
    {
        QVERIFY(writeFile(path("along-y.json"), R"({"azimuth": 0, "elevation": 0, "perspective": false,
                                                    "target": [2, 2, 2], "distance": 10, "fieldOfView": 30})"));
        const auto picture = [&](const QStringList& options) {
            const Run run = tan(QStringList{"render", "faulty.tan", "--camera", "along-y.json", "--size", "300x300",
                                            "--backend", backend, "-o", "cells.png", "--json"} +
                                options);
            return std::pair(run.exitCode == 0 ? QImage(path("cells.png")) : QImage(),
                             run.json()["faulty_cells_outlined"].toInt(-1));
        };
        const auto [plain, none] = picture({});
        const auto [outlined, two] = picture({"--faulty-cells"});
        QCOMPARE(none, -1);
        QCOMPARE(two, 2);
        QCOMPARE(outlined.size(), QSize(300, 300));
        const double scale = 150 / (10 * std::tan(15 * 3.14159265358979 / 180));
        const auto place = [&](double x, double z) { return QPointF(150 + scale * (x - 2), 150 - scale * (z - 2)); };
        std::vector<QPointF> along;
        for (const double at : {1.2, 2.3})
            for (int step = 0; step <= 50; ++step) {
                const double share = 0.01 * step; // of the edges' length
                along.insert(along.end(),
                             {place(at + share, at), place(at, at + share), place(at + share, at + 0.5 - share)});
            }
        constexpr double rim = 4.5; // half its width, around corners, and what a pixel adds
        int differing = 0;
        for (int y = 0; y < outlined.height(); ++y)
            for (int x = 0; x < outlined.width(); ++x) {
                if (outlined.pixel(x, y) == plain.pixel(x, y))
                    continue;
                ++differing;
                const bool isNear = std::ranges::any_of(along, [&](const QPointF& point) {
                    return std::hypot(x + 0.5 - point.x(), y + 0.5 - point.y()) < rim;
                });
                QVERIFY2(isNear, qPrintable(QString("%1: pixel %2, %3").arg(backend).arg(x).arg(y)));
            }
        QVERIFY(differing > 500);
        for (const QPointF& point : along) {
            const QColor core = outlined.pixelColor(int(point.x()), int(point.y()));
            QVERIFY2(core.red() > 150 && core.red() > core.blue() + 80,
                     qPrintable(QString("%1: %2 at %3, %4").arg(backend, core.name()).arg(point.x()).arg(point.y())));
        }
        const Run refused = tan({"render", "c60.tan", "--faulty-cells", "-o", "no.png"});
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("lists no faulty cells"), refused.messages);
    }

private slots:

    void verifySaysNo()
    {
        QVERIFY(tan({"sample", "noise", "--size", "12", "-o", "noise.nrrd"}).exitCode == 0);
        const Run run = tan({"verify", "c60.tan", "--against", "noise.nrrd", "--json"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY(!run.json()["ok"].toBool(true));
        const Run text = tan({"verify", "c60.tan", "--against", "noise.nrrd"});
        QCOMPARE(text.exitCode, 1);
        QVERIFY2(text.output.contains("NOT what it claims"), text.output);
        QVERIFY(tan({"sample", "noise", "--size", "13", "-o", "other.nrrd"}).exitCode == 0);
        const Run other = tan({"verify", "c60.tan", "--against", "other.nrrd"});
        QCOMPARE(other.exitCode, 1);
        QVERIFY2(other.output.contains("another dataset") && !other.output.contains("conforming"), other.output);
    }

    void verifyFindsOneChangedByte()
    {
        QFile model(path("c60.tan"));
        QVERIFY(model.open(QIODevice::ReadOnly));
        QByteArray content = model.readAll();
        content[content.size() / 2] = static_cast<char>(content[content.size() / 2] ^ 4);
        QVERIFY(writeFile(path("changed.tan"), content));
        const Run run = tan({"verify", "changed.tan", "--against", "c60.nrrd"});
        QVERIFY2(run.exitCode == 1, run.output + run.messages);
    }

    void isosurfaceWritesPly()
    {
        const Run run = tan({"isosurface", "c60.tan", "--error", "2", "--value", "100,150", "-o", "c60.ply", "--json"});
        QVERIFY2(run.exitCode == 0, run.messages);
        const QJsonObject figures = run.json();
        const qint64 vertices = figures["vertices"].toInteger();
        const qint64 triangles = figures["triangles"].toInteger();
        QVERIFY(vertices > 0 && triangles > 0);
        QVERIFY(figures["seconds"].toDouble(-1) >= 0);
        QFile file(path("c60.ply"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray content = file.readAll();
        const qsizetype header = content.indexOf("end_header\n") + 11;
        QVERIFY(content.startsWith("ply\nformat binary_little_endian 1.0\n"));
        QVERIFY(content.contains("element vertex " + QByteArray::number(vertices) + "\n"));
        const qsizetype vertexBytes = content.contains("property double x") ? 40 : 28;
        QCOMPARE(content.size(), header + vertices * vertexBytes + triangles * 13);
        float record[7]; // with the normal and the value at its end
        std::memcpy(record, content.constData() + header + vertexBytes - 28, sizeof record);
        QCOMPARE(record[6], 100.0f);
        QVERIFY(std::abs(record[3] * record[3] + record[4] * record[4] + record[5] * record[5] - 1) < 1e-3f);
    }

    void isosurfaceWritesEveryFormat_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"c60.vtp", "c60.vtk", "c60.vtu", "c60.stl", "c60.obj", "c60.glb"})
            QTest::newRow(name) << name;
    }
    void isosurfaceWritesEveryFormat()
    {
        QFETCH(QString, name);
        const Run run = tan({"isosurface", "c60.tan", "--error", "2", "--value", "100,150", "-o", name, "--json"});
        QVERIFY2(run.exitCode == 0, run.messages);
        const VtkReader reader(path(qPrintable(name)));
        if (reader.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(reader.ok(), reader.messages());
        const QJsonObject figures = run.json();
        QCOMPARE(reader.told()["cells"].toInteger(), figures["triangles"].toInteger());
        if (!name.endsWith("stl"))
            QCOMPARE(reader.told()["points"].toInteger(), figures["vertices"].toInteger());
        if (!name.contains(".vt"))
            return;
        const std::vector<float> values = reader.array<float>("point.isovalue");
        QCOMPARE(static_cast<qint64>(values.size()), figures["vertices"].toInteger());
        QCOMPARE(values.front(), 100.0F);
        QCOMPARE(values.back(), 150.0F);
        QVERIFY(readFile(path(qPrintable(name))).left(500).contains("model: c60.tan"));
    }

    /// With --json a failure is an object, too, beside the sentence for people.
    void errorsAreJson()
    {
        const auto row = [this](const QStringList& words, const char* kind, int code) {
            const Run run = tan(words + QStringList{"--json"});
            QCOMPARE(run.exitCode, code);
            QCOMPARE(run.json()["kind"].toString(), QString(kind));
            QCOMPARE(run.json()["exit_code"].toInt(), code);
            QVERIFY(!run.json()["error"].toString().isEmpty());
            QVERIFY2(QString::fromUtf8(run.messages).contains(run.json()["error"].toString()), run.messages);
        };
        row({"info", "nothing.tan"}, "bad-input", 3);
        row({"inof", "c60.tan"}, "wrong-usage", 2);
        row({"extract", "c60.tan", "--error", "x", "-o", "x.vtu"}, "wrong-usage", 2);
        row({"extract", "c60.tan", "--eror", "1", "-o", "x.vtu"}, "wrong-usage", 2);
        row({"extract", "c60.tan", "-o", "no-folder/x.vtu"}, "cannot-write", 4);
        QVERIFY(tan({"info", "nothing.tan"}).output.isEmpty());
    }

    void renderDraws_data()
    {
        QTest::addColumn<QString>("backend");
        QTest::newRow("cpu") << "cpu";
        QTest::newRow("gl") << "gl";
    }
    void renderDraws()
    {
        QFETCH(QString, backend);
        const Run run =
            tan({"render", "c60.tan", "--error", "1", "--isovalue", "120:#ff0000", "--camera", "front", "--size",
                 "60x40", "--background", "#0000ff", "--backend", backend, "-o", "c60.png", "--json"});
        if (backend != "cpu" && run.exitCode == 4)
            QSKIP_WITHOUT("OpenGL");
        QVERIFY2(run.exitCode == 0, run.messages);
        const QJsonObject figures = run.json();
        QCOMPARE(figures["width"].toInt(), 60);
        QCOMPARE(figures["height"].toInt(), 40);
        QVERIFY(figures["tetrahedra"].toInt() > 0 && figures["triangles"].toInt() > 0);
        QVERIFY(figures["seconds"].toDouble(-1) >= 0);
        const QImage image(path("c60.png"));
        QCOMPARE(image.size(), QSize(60, 40));
        QCOMPARE(image.pixelColor(0, 0), QColor(0, 0, 255));
        int red = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                red += image.pixelColor(x, y).red() > 2 * image.pixelColor(x, y).blue() ? 1 : 0;
        QVERIFY2(red > 100, QByteArray::number(red));
    }

    void renderTakesACameraFile()
    {
        const QStringList words = {"render", "c60.tan", "--size", "30x30", "-o", "camera.png", "--camera"};
        QVERIFY(writeFile(path("top.json"), R"({"azimuth": 0, "elevation": 90})"));
        QVERIFY(writeFile(path("wrong.json"), R"({"azimut": 0})"));
        QVERIFY(writeFile(path("broken.json"), "{"));
        QCOMPARE(tan(words + QStringList{"top"}).exitCode, 0);
        const QImage named(path("camera.png"));
        QCOMPARE(tan(words + QStringList{"top.json"}).exitCode, 0);
        QCOMPARE(QImage(path("camera.png")), named);
        QCOMPARE(tan(words + QStringList{"front"}).exitCode, 0);
        QVERIFY(QImage(path("camera.png")) != named);
        const Run wrong = tan(words + QStringList{"wrong.json"});
        QCOMPARE(wrong.exitCode, 3);
        QVERIFY2(wrong.messages.contains("\"azimut\""), wrong.messages);
        QCOMPARE(tan(words + QStringList{"broken.json"}).exitCode, 3);
        QCOMPARE(tan(words + QStringList{"frnt"}).exitCode, 2);
    }

    void pluginsAreListed()
    {
        const QJsonArray plugins = tan({"plugins", "--json"}).json()["plugins"].toArray();
        QVERIFY(plugins.size() >= 4);
        for (const QJsonValue entry : plugins) {
            const QJsonObject plugin = entry.toObject();
            QVERIFY(!plugin["id"].toString().isEmpty() && !plugin["kind"].toString().isEmpty());
            QVERIFY(!plugin["version"].toString().isEmpty());
            QCOMPARE(plugin["state"].toString(), QString("loaded"));
            QCOMPARE(plugin["error"].toString("?"), QString());
        }
    }

    void badPluginsDoNotKeepTheProgramFromWorking()
    {
        const QMap<QString, QString> environment = {{"TAN_PLUGIN_PATH", TAN_FIXTURES},
                                                    {"TAN_PLUGIN_DISABLE", "isosurface"}};
        const Run list = tan({"plugins", "--json"}, environment);
        QCOMPARE(list.exitCode, 0);
        QHash<QString, QString> states;
        for (const QJsonValue entry : list.json()["plugins"].toArray())
            states[entry.toObject()["id"].toString()] = entry.toObject()["state"].toString();
        QCOMPARE(states["wrong-api"], QString("refused"));
        QCOMPARE(states["missing-library"], QString("refused"));
        QCOMPARE(states["isosurface"], QString("disabled"));
        QCOMPARE(states["refinement"], QString("loaded"));
        QCOMPARE(tan({"info", "c60.nrrd"}, environment).exitCode, 0);
        const Run render = tan({"render", "c60.tan", "-o", "x.png"}, environment);
        QCOMPARE(render.exitCode, 2);
        QVERIFY2(render.messages.contains("TAN_PLUGIN_DISABLE"), render.messages);
    }

    /// The object on standard error has it for itself.
    void badPluginsAreToldInTheObject()
    {
        const QMap<QString, QString> environment = {{"TAN_PLUGIN_PATH", TAN_FIXTURES}};
        const QStringList words = {"--error", "2", "--against", "c60.nrrd", "-o", "-", "--format", "vtu", "--json"};
        const auto told = [&](const char* model, int exitCode) {
            const Run run = tan(QStringList{"extract", model} + words, environment);
            return run.exitCode == exitCode ? QJsonDocument::fromJson(run.messages).object() : QJsonObject();
        };
        QStringList remarks;
        for (const QJsonValue remark : told("c60.tan", 0)["remarks"].toArray())
            remarks += remark.toString();
        QVERIFY2(remarks.join('\n').contains("The plugin \"missing-library\" cannot be used."),
                 qPrintable(remarks.join('\n')));
        QVERIFY(told("none.tan", 3).contains("error"));
    }

    void everySubcommandHasHelpAndWritesItToStandardOutput()
    {
        const Run all = tan({"--help"});
        QCOMPARE(all.exitCode, 0);
        QVERIFY(all.messages.isEmpty());
        for (const char* name : {"sample", "build", "info", "verify", "extract", "isosurface", "render", "cut", "pack",
                                 "unpack", "plugins"}) {
            QVERIFY2(all.output.contains(QByteArray("  ") + name + " "), name);
            const Run one = tan({name, "--help"});
            QCOMPARE(one.exitCode, 0);
            QVERIFY2(one.output.contains("Examples:") && one.output.contains("Exit codes:"), name);
            QVERIFY(one.messages.isEmpty());
        }
        QVERIFY(tan({"--version"}).output.startsWith("tan "));
    }

    void helpIsAskedForInTwoWays()
    {
        const Run option = tan({"build", "--help"}), word = tan({"help", "build"});
        QCOMPARE(word.exitCode, 0);
        QVERIFY(word.output.startsWith("tan build: "));
        QCOMPARE(word.output, option.output);
        const Run wrong = tan({"help", "buidl"});
        QCOMPARE(wrong.exitCode, 2);
        QVERIFY2(wrong.messages.contains("'build'"), wrong.messages);
        QCOMPARE(tan({"help"}).output, tan({"--help"}).output);
    }

    /// Only those that can occur.
    void exitCodesAreTheCommands()
    {
        constexpr const char *notProved = "verification failed", *badInput = "bad input";
        QVERIFY(tan({"help", "verify"}).output.contains(notProved));
        QVERIFY(tan({"help", "info"}).output.contains(notProved));
        QVERIFY(!tan({"help", "build"}).output.contains(notProved));
        QVERIFY(tan({"help", "build"}).output.contains(badInput));
        QVERIFY(!tan({"help", "plugins"}).output.contains(badInput));
    }

    /// In the log of every batch.
    void nothingIsSaidOfFoldersThatAreNotThere()
    {
        const QMap<QString, QString> none = {{"XDG_RUNTIME_DIR", ""}};
        for (const QStringList& words : {QStringList{"reproduce", "--help"},
                                         QStringList{"render", "c60.tan", "--error", "8", "--colour-bar", "--axes",
                                                     "--title", "C60", "--size", "99x99", "-o", "none.png"}}) {
            const Run run = tan(words, none);
            QVERIFY2(run.exitCode == 0, run.messages);
            QCOMPARE(run.messages, QByteArray());
        }
    }

    /// Among the files of a series that is usual.
    void aValueThatIsNotThereGivesAnEmptySurface()
    {
        const Run surface = tan({"isosurface", "c60.tan", "--value", "100,900", "-o", "some.ply", "--json"});
        QVERIFY2(surface.exitCode == 0, surface.messages);
        QVERIFY(surface.json()["triangles"].toInt() > 0);
        QCOMPARE(surface.json()["remarks"].toArray().size(), 1);
        QVERIFY(
            surface.json()["remarks"][0].toString().startsWith("The surface of 900 is empty: the data lie between "));
        for (const char* file : {"none.ply", "none.vtp", "none.vtu", "none.vtk", "none.stl", "none.obj", "none.glb"}) {
            const Run none = tan({"isosurface", "c60.tan", "--value", "900", "-o", file});
            QVERIFY2(none.exitCode == 0, none.messages);
            QVERIFY2(none.output.contains("The surface of 900 is empty"), none.output);
            QVERIFY(QFile::exists(path(file)));
        }
        const Run picture =
            tan({"render", "c60.tan", "--isovalue", "900", "--size", "99x99", "-o", "none.png", "--json"});
        QVERIFY2(picture.exitCode == 0, picture.messages);
        QCOMPARE(picture.json()["triangles"].toInt(-1), 0);
        QCOMPARE(picture.json()["remarks"].toArray().size(), 1);
    }

    /// A ramp with a spike: a mesh of a large error has the values of the corners alone, so it has the surface of 47
    /// and not that of 105.
    void aSurfaceThatTheMeshLostIsTold()
    {
        QByteArray samples;
        for (int point = 0; point < 9 * 9 * 9; ++point)
            samples += static_cast<char>(point == 3 + 9 * (4 + 9 * 5) ? 110 : 100 * (point % 9) / 8);
        QVERIFY(writeFile(path("spike.nrrd"), nrrd("uint8", "9 9 9", samples)));
        QCOMPARE(tan({"build", "spike.nrrd", "-o", "spike.tan"}).exitCode, 0);
        const auto surfaces = [this](const QString& values) {
            const Run run = tan({"isosurface", "spike.tan", "--error", "90", "--value", values, "--deviation", "-o",
                                 "spike.stl", "--json"});
            return run.json();
        };
        const auto remarks = [](const QJsonObject& figures) {
            QStringList all;
            for (const QJsonValue remark : figures["remarks"].toArray())
                if (remark.toString().contains("surface of"))
                    all += remark.toString();
            return all;
        };
        QCOMPARE(remarks(surfaces("47")), QStringList());
        QVERIFY(readFile(path("spike.stl")).startsWith("binary STL, deviation "));
        const QJsonObject both = surfaces("47,105");
        const QStringList told = remarks(both);
        QCOMPARE(told.size(), 2);
        QVERIFY2(told[0].startsWith("The surface of 105 is empty in this mesh, whose values lie between 0 "),
                 qPrintable(told[0]));
        QVERIFY2(told[1].startsWith("The finest mesh has the surface of 105 and this mesh does not"),
                 qPrintable(told[1]));
        QVERIFY(both["surfaces"][0].toObject().contains("deviation"));
        QVERIFY(!both["surfaces"][1].toObject().contains("deviation"));
        QVERIFY(readFile(path("spike.stl")).startsWith("binary STL, isosurfaces"));
    }

    void extractTellsWhatIsReached()
    {
        const Run run = tan({"extract", "c60.tan", "--error", "8", "-o", "reached.vtu", "--json"});
        QVERIFY2(run.exitCode == 0, run.messages);
        const QJsonObject figures = run.json();
        QCOMPARE(figures["error"].toDouble(), 8.0);
        QVERIFY(figures["reached_error"].toDouble() > 0 && figures["reached_error"].toDouble() <= 8);
        const QJsonObject level = tan({"info", "c60.tan", "--lod", "8", "--json"}).json()["levels"][0].toObject();
        QCOMPARE(figures["reached_error"].toDouble(), level["reached"].toDouble());
        QVERIFY(tan({"extract", "c60.tan", "--error", "8", "-o", "reached.vtu"})
                    .output.contains(", with errors of up to "));
        // Of a mesh of several errors as well, unless points were inserted: of these nobody knows.
        const QStringList focus = {"--error", "8", "--focus", "sphere:5,5,5,2", "--focus-error", "1", "--json"};
        const QStringList set = {"--method", "closed-set"}, insertion = {"--method", "insertion"};
        for (const QStringList& words : {QStringList{"extract", "c60.tan", "-o", "reached.vtu"},
                                         QStringList{"isosurface", "c60.tan", "--value", "100", "-o", "reached.ply"}}) {
            const QJsonObject finer = tan(words + focus + set).json();
            QVERIFY(finer["reached_error"].toDouble() > 0 && finer["reached_error"].toDouble() <= 8);
            QCOMPARE(finer["reached_warping"].toDouble(-1), 0.0);
            const QJsonObject inserted = tan(words + focus + insertion).json();
            QVERIFY(inserted["error"].toDouble() == 8 && !inserted.contains("reached_error"));
        }
        QVERIFY(tan({"isosurface", "c60.tan", "--error", "8", "--value", "100", "-o", "reached.ply"})
                    .output.contains(", with errors of up to "));
    }

    void numbersDoNotFollowTheLocale()
    {
        const QMap<QString, QString> german = {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}};
        if (!QFileInfo::exists(TAN_BINARY_DIR "/tests/locales/de_DE.UTF-8/LC_NUMERIC"))
            QSKIP_WITHOUT("locale de_DE.UTF-8");
        const QStringList info = {"info", "c60.tan", "--lod", "2.5,.5"};
        QCOMPARE(tan(info, german).output, tan(info, {{"LC_ALL", "C.UTF-8"}}).output);
        QCOMPARE(tan({"info", "c60.tan", "--lod", "2.5", "--json"}, german)
                     .json()["levels"][0]
                     .toObject()["error"]
                     .toDouble(),
                 2.5);
        QCOMPARE(
            tan({"render", "c60.tan", "--isovalue", "120.5:red:0.5", "--size", "9x9", "-o", "d.png"}, german).exitCode,
            0);
        QVERIFY(tan({"build", "c60.nrrd", "-o", "d.tan", "--error", "0.5"}, german).exitCode == 0);
        QCOMPARE(tan({"info", "d.tan", "--json"}, german).json()["parameters"].toObject()["error"].toString(),
                 QString("0.5"));
    }

    void rawFilesNeedADescription()
    {
        QVERIFY(writeFile(path("v.raw"), bytes(4 * 5 * 6)));
        const Run run = tan({"info", "v.raw", "--size", "4x5x6", "--json"});
        QVERIFY2(run.exitCode == 0, run.messages);
        QCOMPARE(run.json()["points"].toInt(), 120);
    }

    void withoutASubcommandTheWindowStarts_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("a model") << QStringList{"c60.tan"};
    }
    void withoutASubcommandTheWindowStarts()
    {
        QFETCH(QStringList, words);
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), words);
        QVERIFY(process.waitForStarted());
        const QString program = QString("/proc/%1/exe").arg(process.processId());
        QTRY_VERIFY(QFile::symLinkTarget(program).endsWith("/bin/tan-desktop"));
        process.kill();
        QVERIFY(process.waitForFinished());
    }

    void figuresAndMessagesGoTheirOwnWays()
    {
        const Run good = tan({"info", "c60.tan", "--json"});
        QVERIFY(good.messages.isEmpty());
        const Run bad = tan({"info", "nothing.tan"});
        QVERIFY(bad.output.isEmpty());
        QVERIFY(bad.messages.startsWith("tan: "));
    }
};

QTEST_GUILESS_MAIN(CommandLineTest)
#include "command_line_test.moc"
