// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan reproduce` (R30, C14) on a folder of data of the test's own: what it prints, writes, skips and refuses.
#include "app/reproduction/paper_pictures.h"
#include "app/reproduction/surface_comparison.h"
#include "tests/app/program.h"
#include "tests/app/sample_files.h"

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QPolygonF>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>

using namespace tetra;

namespace {

constexpr const char* table2 =
    "dataset,dim_i,dim_j,dim_k,dataset_sites,model_total_tetrahedra,construction_peak_ram_kb,"
    "construction_time_cpu_seconds,max_error_epsilon_percent_of_value_range,lod_tetrahedra,lod_sites,"
    "lod_sites_percent_as_printed\n"
    "SOD,32,32,32,32768,177588,45134,1491,4.0,11485,2094,6\n"
    "BuckyBall,32,32,32,32768,472130,25868,1318,4.0,42468,7125,21\n"
    "BuckyBall,32,32,32,32768,472130,25868,1318,0.0,176687,32768,100\n";

constexpr const char* table1 =
    "dataset,dim_i,dim_j,dim_k,dataset_sites,model_total_tetrahedra,construction_peak_ram_kb,"
    "construction_time_cpu_seconds,max_warping_delta_percent_of_bbox_diagonal,"
    "max_error_epsilon_percent_of_value_range,lod_tetrahedra,lod_sites,lod_sites_percent_as_printed\n"
    "BluntFin,40,32,32,40960,590831,35300,1704,1.0,1.0,80883,14162,34\n";
const QString table4 = "dataset,isosurface_threshold,max_warping_delta_percent_of_bbox_diagonal,"
                       "max_error_epsilon_percent_of_value_range,vertices,tetrahedra,isosurface_triangles,"
                       "direct_volume_rendering_seconds\n"
                       "BluntFin,";

/// A line or a group of dots in an SVG file: `points` is "x,y" with anything that is no number in between.
QPolygonF pointsOf(const QString& points)
{
    static const QRegularExpression place("(-?[\\d.]+),(-?[\\d.]+)");
    QPolygonF places;
    for (auto found = place.globalMatch(points); found.hasNext();) {
        const auto one = found.next();
        places << QPointF(one.captured(1).toDouble(), one.captured(2).toDouble());
    }
    return places;
}

/// What a chart shows of its first colour.
struct FirstSeries {
    QPolygonF curve; ///< from left to right
    QPolygonF rings;
};

FirstSeries firstSeriesOf(const QString& svg)
{
    static const QRegularExpression line("<polyline class=\"s0\"[^>]* points=\"([^\"]*)\"");
    static const QRegularExpression ring("<path class=\"s0\"[^>]* stroke-width=\"9.0\"[^>]* d=\"([^\"]*)\"");
    FirstSeries series;
    for (auto found = line.globalMatch(svg); found.hasNext();)
        if (const QPolygonF points = pointsOf(found.next().captured(1)); points.size() > series.curve.size())
            series.curve = points; // the others are in the legend
    for (auto found = ring.globalMatch(svg); found.hasNext();)
        series.rings += pointsOf(found.next().captured(1));
    return series;
}

} // namespace

class ReproductionTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }

private slots:
    void init()
    {
        QDir(folder_.path()).removeRecursively();
        QVERIFY(QDir().mkpath(path("data/paper")));
        QVERIFY(QDir().mkpath(path("data/buckyball")));
        QVERIFY(writeFile(path("data/paper/table2.csv"), table2));
        QVERIFY(writeFile(path("data/buckyball/bucky_32x32x32_uint8.nhdr"), nrrd("uint8", "6 5 4", bytes(120))));
    }

    void printsOursBesideThePapers()
    {
        const Run run = runTan({"reproduce", "--tables", "2", "--data", "data", "-o", "out", "--json"}, folder_.path());
        QCOMPARE(run.exitCode, 0);
        const QJsonArray tables = run.json()["tables"].toArray();
        QCOMPARE(tables.size(), 1);
        QCOMPARE(tables[0]["table"].toInt(), 2);
        const QJsonArray rows = tables[0]["rows"].toArray();
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[1]["dataset"].toString(), "BuckyBall");
        QCOMPARE(rows[1]["error"].toDouble(), 0.0);
        QCOMPARE(rows[1]["paper"]["sites"].toInt(), 32768);
        QCOMPARE(rows[1]["paper"]["tetrahedra"].toInt(), 176687);

        // Ours is what the model that was left says of itself.
        const Run info =
            runTan({"info", "out/models/table2-BuckyBall-32x32x32.tan", "--lod", "0", "--json"}, folder_.path());
        QCOMPARE(info.exitCode, 0);
        const QJsonValue level = info.json()["levels"].toArray()[0];
        QCOMPARE(rows[1]["ours"]["sites"].toInt(), level["sites"].toInt());
        QCOMPARE(rows[1]["ours"]["tetrahedra"].toInt(), level["tetrahedra"].toInt());
        QVERIFY(level["sites"].toInt() > 8);

        // C14: the columns % and RAM, and the history beside the finest mesh.
        QCOMPARE(rows[0]["paper"]["sites_percent"].toDouble(), 21.0);
        QCOMPARE(rows[1]["ours"]["sites_percent"].toDouble(), 100 * level["sites"].toDouble() / 120);
        const QJsonValue model = tables[0]["models"].toArray()[1];
        QCOMPARE(model["paper"]["bytes"].toDouble(), 25868 * 1024.0);
        QVERIFY(model["ours"]["bytes"].toDouble() >= 0);
        QCOMPARE(model["paper"]["of_finest_mesh"].toDouble(), 472130 / 176687.0);
        QCOMPARE(model["ours"]["of_finest_mesh"].toDouble(),
                 model["ours"]["tetrahedra"].toDouble() / level["tetrahedra"].toDouble());
    }

    /// C14: pictures are compared where they show something, and a pixel is off if a colour is by a tenth.
    void degradationIsThatOfThePixels()
    {
        Picture white{2, 2, {}};
        white.pixels.assign(4, {255, 255, 255, 255});
        Picture one = white;
        one.pixels[0] = {0, 255, 255, 255};
        Picture other = one;
        QCOMPARE(degradationOf(one, other).rootMeanSquare, 0.0);
        other.pixels[0] = {51, 255, 255, 255};
        other.pixels[1] = {235, 255, 255, 255};
        const Degradation degradation = degradationOf(one, other);
        QCOMPARE(degradation.visiblePercent, 50.0);
        QCOMPARE(degradation.rootMeanSquare, 100 * std::sqrt((51.0 * 51 + 20 * 20) / 6) / 255);
        QCOMPARE(degradationOf(white, white).visiblePercent, 0.0);
    }

    /// C14: two spheres, one in the other, and coarse ones of as many triangles.
    void surfacesAreComparedByDistanceAndCrossings()
    {
        const auto sphere = [](int rings, float radius) {
            TriangleMesh mesh;
            std::vector<Eigen::Vector3d> positions{{0, 0, radius}, {0, 0, -radius}};
            std::vector<std::array<std::uint32_t, 3>> triangles;
            const auto at = [&](int ring, int place) {
                return static_cast<std::uint32_t>(2 + (ring - 1) * 2 * rings + place % (2 * rings));
            };
            for (int ring = 1; ring < rings; ++ring)
                for (int place = 0; place < 2 * rings; ++place) {
                    const double down = M_PI * ring / rings, around = M_PI * place / rings;
                    positions.emplace_back(radius * std::sin(down) * std::cos(around),
                                           radius * std::sin(down) * std::sin(around), radius * std::cos(down));
                    if (ring == 1)
                        triangles.push_back({0, at(1, place), at(1, place + 1)});
                    if (ring + 1 < rings) {
                        triangles.push_back({at(ring, place), at(ring + 1, place), at(ring + 1, place + 1)});
                        triangles.push_back({at(ring, place), at(ring + 1, place + 1), at(ring, place + 1)});
                    } else {
                        triangles.push_back({at(ring, place + 1), at(ring, place), 1});
                    }
                }
            mesh.positions.assign(positions.begin(), positions.end());
            mesh.triangles.assign(triangles.begin(), triangles.end());
            return mesh;
        };
        const std::array finest{sphere(40, 1), sphere(40, 0.98f)};
        const SurfaceComparison same = compareSurfaces(finest, finest);
        QVERIFY(same.fromData.largest < 1e-4);
        QCOMPARE(same.fromData.crossings, std::size_t(0));
        QCOMPARE(same.simplified.triangles, finest[0].triangles.size());

        // A flat triangle of a coarse sphere is farther inside than the other sphere is: they cross.
        const std::array coarse{sphere(6, 1), sphere(7, 0.98f)};
        const SurfaceComparison few = compareSurfaces(coarse, finest);
        QCOMPARE(few.fromData.triangles, coarse[0].triangles.size());
        QVERIFY(few.fromData.crossings > 0);
        QVERIFY(few.fromData.largest > 1 && few.fromData.largest < 5);
        QVERIFY(few.simplified.triangles <= coarse[0].triangles.size() + 4);
        QVERIFY(few.simplified.triangles > coarse[0].triangles.size() / 2);
        QVERIFY(few.simplified.rootMeanSquare > 0 && few.simplified.largest < 5);
    }

    /// Table 4 on a small grid: triangles as 'tan isosurface' finds them, and times.
    void drawsTheModelsOfTable4()
    {
        QVERIFY(QDir().mkpath(path("data/bluntfin")));
        QCOMPARE(runTan({"sample", "bent-duct", "--size", "8", "-o", "duct.xyz"}, folder_.path()).exitCode, 0);
        QVERIFY(QFile::rename(path("duct.xyz"), path("data/bluntfin/bluntfinxyz.bin")));
        QVERIFY(QFile::rename(path("duct.q"), path("data/bluntfin/bluntfinq.bin")));
        const Run info = runTan({"info", "data/bluntfin/bluntfinxyz.bin", "--json"}, folder_.path());
        const QJsonArray range = info.json()["range"].toArray();
        const QString isovalue = QString::number((range[0].toDouble() + range[1].toDouble()) / 2);
        QVERIFY(writeFile(path("data/paper/table1.csv"), table1));
        QVERIFY(
            writeFile(path("data/paper/table4.csv"), (table4 + isovalue + ",4.0,4.0,3612,20324,3442,3.9\nBluntFin," +
                                                      isovalue + ",0.0,0.0,40960,222528,19499,44.1\n")
                                                         .toUtf8()));

        const Run run = runTan({"reproduce", "--tables", "4", "--data", "data", "-o", "out", "--json"}, folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        const QJsonArray rows = run.json()["tables"][0]["rows"].toArray();
        QCOMPARE(rows.size(), 4);
        for (const QJsonValue row : rows) {
            const bool isFinest = row["error"].toDouble() == 0;
            QCOMPARE(row["paper"]["volume_seconds"].toDouble(), isFinest ? 44.1 : 3.9);
            QCOMPARE(row["paper"]["triangles"].toInt(), isFinest ? 19499 : 3442);
            // C14: how far pictures and surfaces are off those of the finest mesh.
            for (const char* picture : {"surface_degradation", "volume_degradation"}) {
                const QJsonValue degradation = row["ours"][picture];
                QCOMPARE(degradation["root_mean_square"].toDouble() == 0, isFinest);
                QVERIFY(degradation["root_mean_square"].toDouble() < 50);
            }
            QCOMPARE(row["ours"]["surface"].isObject(), !isFinest);
            if (!isFinest) {
                QCOMPARE(row["ours"]["surface"]["triangles"].toInt(), row["ours"]["triangles"].toInt());
                QCOMPARE(row["ours"]["surface"]["crossings"].toInt(), 0);
                QVERIFY(row["ours"]["surface"]["distance"].toDouble() > 0);
                QVERIFY(row["ours"]["surface"]["largest_distance"].toDouble() >=
                        row["ours"]["surface"]["distance"].toDouble());
                QVERIFY(row["ours"]["simplified"]["triangles"].toInt() > 0);
            }
            for (const char* key : {"extraction_seconds", "surface_seconds", "volume_seconds", "hybrid_seconds"})
                QVERIFY2(row["ours"][key].toDouble() > 0, key);
            const QString model = row["variant"].toString().replace(' ', '-');
            const Run surface =
                runTan({"isosurface", "out/models/table1-BluntFin-40x32x32-" + model + ".tan", "--error",
                        QString::number(row["error"].toDouble()), "--value", isovalue, "-o", "surface.ply", "--json"},
                       folder_.path());
            QVERIFY2(surface.exitCode == 0, surface.messages);
            QCOMPARE(row["ours"]["triangles"].toInt(), surface.json()["triangles"].toInt());
            QVERIFY(row["ours"]["triangles"].toInt() > 0);
        }
        for (const char* picture : {"isosurface-0", "isosurface-4", "volume-0", "volume-4"})
            QCOMPARE(QImage(path(QString("out/figure14-%1.png").arg(picture))).size(), QSize(512, 512));
    }

    void skipsWhatHasNoData()
    {
        const Run run = runTan({"reproduce", "--tables", "2", "--data", "data", "-o", "out"}, folder_.path());
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.output.contains("Skipped: there is no 'sod/sod_sub_32x32x32_uint8.nhdr'"), run.output);
    }

    void writesReports()
    {
        const Run run = runTan({"reproduce", "--tables", "2", "--data", "data", "-o", "out", "--json"}, folder_.path());
        QCOMPARE(run.exitCode, 0);
        const QJsonValue tables = run.json()["tables"];
        QVERIFY(tables == QJsonDocument::fromJson(readFile(path("out/tables.json")))["tables"]);
        for (const char* name : {"out/tables.txt", "out/tables.md"}) {
            const QByteArray text = readFile(path(name));
            for (const QJsonValue row : tables[0]["rows"].toArray())
                for (const char* whose : {"ours", "paper"})
                    for (const char* figure : {"sites", "tetrahedra"})
                        QVERIFY2(text.contains(QByteArray::number(row[whose][figure].toInt())), name);
        }
    }

    /// The curve of the model and the paper's number, where the axes have them, in both files.
    void drawsTheFigureOfTheSites()
    {
        QCOMPARE(runTan({"reproduce", "--tables", "2", "--data", "data", "-o", "out"}, folder_.path()).exitCode, 0);
        const QString svg = readFile(path("out/figure10.svg"));
        QVERIFY(svg.contains(">BuckyBall 32</text>"));
        const auto [curve, rings] = firstSeriesOf(svg);
        QVERIFY(curve.size() >= 60); // twenty for each power of ten, from 0.01 % to 10 %
        QCOMPARE(rings.size(), 1);   // an error of 0 has no place on a logarithmic axis
        const auto sitesAt = [&](const char* percent) {
            return double(
                runTan({"info", "out/models/table2-BuckyBall-32x32x32.tan", "--lod", percent, "--json"}, folder_.path())
                    .json()["levels"][0]["sites"]
                    .toInt());
        };
        const double coarse = sitesAt("10"), fine = sitesAt("0.01");
        QVERIFY(coarse >= 8 && coarse < fine);
        const QPointF atTen = curve.last(), atOne = curve[curve.size() - 21];
        for (qsizetype i = 1; i < curve.size(); ++i)
            QVERIFY(curve[i].x() > curve[i - 1].x() && curve[i].y() >= curve[i - 1].y());
        QVERIFY(std::abs(rings[0].x() - std::lerp(atOne.x(), atTen.x(), std::log10(4.0))) < 0.2);
        const double share = std::log(7125 / coarse) / std::log(fine / coarse);
        const double expected = std::lerp(atTen.y(), curve.first().y(), share);
        QVERIFY2(std::abs(rings[0].y() - expected) < 0.1 + 0.1 * share, qPrintable(QString::number(expected)));

        const QImage figure(path("out/figure10.png"));
        QCOMPARE(figure.size(), QSize(2000, 1280));
        const auto colourAt = [&](const QPointF& place) { return figure.pixelColor((2 * place).toPoint()); };
        QCOMPARE(colourAt(rings[0]), QColor(Qt::white));
        for (const QPointF& aside : {QPointF(3.5, 0), QPointF(-3.5, 0), QPointF(0, 3.5), QPointF(0, -3.5)})
            QCOMPARE(colourAt(rings[0] + aside), QColor(0x00, 0x72, 0xb2));
    }

    /// R31, C8: all builders on the same data, also by the paper's own decimation and on irregular data; a reason where
    /// one of them or the data cannot be had.
    void comparesBuilders()
    {
        QVERIFY(QDir().mkpath(path("data/bluntfin")));
        QVERIFY(QDir().mkpath(path("data/irregular")));
        QCOMPARE(runTan({"sample", "bent-duct", "--size", "6", "-o", "duct.xyz"}, folder_.path()).exitCode, 0);
        QVERIFY(QFile::rename(path("duct.xyz"), path("data/bluntfin/bluntfinxyz.bin")));
        QVERIFY(QFile::rename(path("duct.q"), path("data/bluntfin/bluntfinq.bin")));
        QVERIFY(writeFile(path("data/irregular/spx.vtu"), "no reader's file"));
        QCOMPARE(
            runTan({"sample", "part", "--size", "8", "-o", "data/irregular/bracket_57k.vtu"}, folder_.path()).exitCode,
            0);
        const Run run =
            runTan({"reproduce", "--compare-builders", "--data", "data", "-o", "out", "--json"}, folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(run.json()["tables"].toArray().isEmpty());
        std::map<QString, QJsonObject> datasets;
        for (const QJsonValue dataset : run.json()["comparison"].toArray())
            datasets[dataset["dataset"].toString()] = dataset.toObject();
        for (const char* name : {"BuckyBall 32", "BluntFin"}) {
            const QJsonObject& dataset = datasets[name];
            QCOMPARE(dataset["skipped"].toString(), QString());
            const QJsonArray levels = dataset["levels"].toArray();
            QCOMPARE(levels.size(), 8);
            for (const char* builder : {"refinement", "decimation", "decimation-paper"}) {
                const QString model = QString("out/models/%1-%2.tan").arg(QString(name).replace(' ', '-'), builder);
                const Run info = runTan({"info", model, "--lod", "1", "--json"}, folder_.path()); // and a warping of 1
                const int sites = info.json()["levels"].toArray().at(0).toObject().value("sites").toInt();
                QVERIFY(sites > 0);
                QCOMPARE(levels[3].toObject().value(builder).toObject().value("sites").toInt(), sites);
            }
            for (const QJsonValue build : dataset["builds"].toArray()) {
                QVERIFY(build["seconds"].toDouble() > 0);
                const QJsonValue measured = build["measured"];
                QVERIFY(measured["sites"].toInt() >= 8 && measured["mean"].toDouble() >= 0);
                QVERIFY(measured["mean"].toDouble() <= measured["percentile99"].toDouble());
                QVERIFY(measured["percentile99"].toDouble() <= measured["largest"].toDouble());
            }
        }
        const QJsonObject& irregular = datasets["bracket"];
        QCOMPARE(irregular["skipped"].toString(), QString());
        QVERIFY(irregular["builds"][0]["refused"].toString().contains("convex"));
        for (const QJsonValue level : irregular["levels"].toArray()) {
            QVERIFY(!level.toObject().contains("refinement"));
            // The exact order is the first that is there; in the paper's, the same number of sites does worse or as
            // well.
            QVERIFY(level["decimation"]["as_many_sites"].toDouble() <= level["error"].toDouble() + 1e-9);
            QVERIFY(level["decimation-paper"]["sites"].toInt() >= 4);
            QVERIFY(level["decimation-paper"]["as_many_sites"].toDouble() >=
                    level["decimation"]["as_many_sites"].toDouble());
        }
        QVERIFY(datasets["SOD 32"]["skipped"].toString().contains("no 'sod/sod_sub_32x32x32_uint8.nhdr'"));
        QVERIFY(datasets["SPX"]["skipped"].toString().contains("spx.vtu"));
        QVERIFY(run.json()["comparison"] == QJsonDocument::fromJson(readFile(path("out/builders.json")))["comparison"]);
        for (const char* name : {"out/builders.txt", "out/builders.md"}) {
            const QByteArray text = readFile(path(name));
            QVERIFY(text.contains("in the paper's order"));
            for (const char* builder : {"refinement", "decimation", "decimation-paper"})
                for (const char* dataset : {"BuckyBall 32", "BluntFin"})
                    for (const QJsonValue level : datasets[dataset]["levels"].toArray())
                        QVERIFY2(text.contains(QByteArray::number(level[builder]["sites"].toInt())), name);
        }
        for (const auto& [name, dataset] :
             {std::pair("regular", "BuckyBall 32"), std::pair("curvilinear", "BluntFin")}) {
            const QString file = path(QString("out/builders-%1").arg(name));
            const QString svg = readFile(file + ".svg");
            QVERIFY(svg.contains(QString(">%1</text>").arg(dataset)));
            const auto [decimated, refined] = firstSeriesOf(svg);
            QVERIFY(decimated.size() >= 60);
            QCOMPARE(refined.size(), decimated.size());
            QCOMPARE(QImage(file + ".png").size(), QSize(2000, 1280));
        }
        QVERIFY(!QFileInfo::exists(path("out/tables.txt")));
    }

    void refusesBrokenFigures_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("message");
        const QByteArray whole = table2;
        QTest::newRow("a word") << QByteArray(whole).replace("7125", "many") << QByteArray("line 3");
        QTest::newRow("a column") << QByteArray(whole).replace("lod_sites,", "sites,") << QByteArray("'lod_sites'");
        QTest::newRow("a short line") << whole + "BuckyBall,32,32\n" << QByteArray("line 5");
        QTest::newRow("nothing") << QByteArray() << QByteArray("Cannot read");
    }
    void refusesBrokenFigures()
    {
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, message);
        QVERIFY(writeFile(path("data/paper/table2.csv"), content));
        const Run run = runTan({"reproduce", "--tables", "2", "--data", "data", "-o", "out"}, folder_.path());
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.messages.contains(message), run.messages);
    }

    void refusesTablesThatThePaperDoesNotHave()
    {
        for (const char* tables : {"5", "0", "1.5", "two"})
            QCOMPARE(runTan({"reproduce", "--tables", tables, "--data", "data", "-o", "out"}, folder_.path()).exitCode,
                     2);
    }
};

QTEST_GUILESS_MAIN(ReproductionTest)
#include "reproduction_test.moc"
