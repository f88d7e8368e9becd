// SPDX-License-Identifier: GPL-3.0-or-later
// Curvilinear data from a sample to a picture, as a user would (R1, R4, R7, B3).
#include "tests/app/program.h"
#include "tests/lacks.h"

#include <QDataStream>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace tetra;

namespace {

/// The paper's way, with the error in the grid.
const QStringList refined = {"--builder", "refinement", "--error-in", "grid"};

} // namespace

class CurvilinearTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const Run sample = tan({"sample", "blunt-body", "--size", "12", "-o", "body.xyz", "--json"});
        QVERIFY2(sample.exitCode == 0, sample.messages);
        QCOMPARE(sample.json()["kind"].toString(), QString("curvilinear"));
        QVERIFY(QFileInfo::exists(folder_.filePath("body.q")));
        const Run build = tan(QStringList{"build", "body.xyz", "-o", "body.tan", "--json"} + refined);
        QVERIFY2(build.exitCode == 0, build.messages);
        QCOMPARE(build.json()["inverted"].toInt(-1), 0);
        QVERIFY(build.json()["degenerate"].toInt() > 0); // at the collapsed axis
    }

    void infoTellsOfGrids()
    {
        for (const QString& file : {QString("body.xyz"), QString("body.q"), QString("body.tan")}) {
            const QJsonObject info = tan({"info", file, "--json"}).json();
            QCOMPARE(info["kind"].toString(), QString("curvilinear"));
            QCOMPARE(info["points"].toInt(), 12 * 12 * 12);
            QCOMPARE(info["cells"].toInt(), 11 * 11 * 11);
            QCOMPARE(info["bounds"].toArray().size(), 2);
            QVERIFY(!info.contains("spacing"));
            QCOMPARE(info["source"].toString(), QString("body.xyz, density"));
        }
    }

    /// A number given alone holds for the error and the warping; --warping says another one.
    void levelsHaveTwoThresholds()
    {
        const auto levels = [this](const QStringList& more) {
            return tan(QStringList{"info", "body.tan", "--lod", "4,1", "--json"} + more).json()["levels"].toArray();
        };
        const QJsonArray both = levels({});
        const QJsonArray anyWarping = levels({"--warping", "100"});
        const QJsonArray noWarping = levels({"--warping", "0"});
        for (qsizetype level = 0; level < 2; ++level) {
            const QJsonObject pair = both[level].toObject();
            QCOMPARE(pair["warping"].toDouble(), pair["error"].toDouble());
            QVERIFY(pair["reached"].toDouble(100) <= pair["error"].toDouble());
            QVERIFY(pair["reached_warping"].toDouble(100) <= pair["warping"].toDouble());
            QVERIFY(anyWarping[level].toObject()["sites"].toInt() <= pair["sites"].toInt());
            QVERIFY(noWarping[level].toObject()["sites"].toInt() > pair["sites"].toInt());
        }
        QCOMPARE(tan({"info", "body.tan", "--warping", "101"}).exitCode, 2);
    }

    /// C1, R14: a pair is two limits, each by itself, in all commands that take one. A mesh for one of them alone needs
    /// little more than a build for that alone.
    void pairsAreTwoLimits()
    {
        const std::vector<std::pair<QString, QString>> pairs = {
            {"1", "5"}, {"5", "1"}, {"1", "1"}, {"1", "none"}, {"none", "1"}};
        QStringList list;
        for (const auto& [error, warping] : pairs)
            list << error + ":" + warping;
        const QJsonArray levels =
            tan({"info", "body.tan", "--lod", list.join(','), "--json"}).json()["levels"].toArray();
        const Run proof = tan({"verify", "body.tan", "--against", "body.xyz", "--lod", list.join(','), "--json"});
        QVERIFY2(proof.exitCode == 0, proof.output + proof.messages);
        const QJsonArray proved = proof.json()["levels"].toArray();
        QCOMPARE(levels.size(), qsizetype(pairs.size()));
        QCOMPARE(proved.size(), levels.size());
        std::vector<int> sites;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const auto& [error, warping] = pairs[i];
            const double mostError = error == "none" ? 100 : error.toDouble();
            const double mostWarping = warping == "none" ? 100 : warping.toDouble();
            const QJsonObject level = levels[static_cast<qsizetype>(i)].toObject();
            QCOMPARE(level["error"].toDouble(), mostError);
            QCOMPARE(level["warping"].toDouble(), mostWarping);
            QVERIFY(level["reached"].toDouble(200) <= mostError);
            QVERIFY(level["reached_warping"].toDouble(200) <= mostWarping);
            QCOMPARE(proved[static_cast<qsizetype>(i)].toObject()["sites"].toInt(), level["sites"].toInt());
            // The mesh itself, measured at every point of the data.
            const Run mesh =
                tan({"verify", "body.tan", "--against", "body.xyz", "--error", error, "--warping", warping, "--json"});
            QVERIFY2(mesh.exitCode == 0, mesh.output + mesh.messages);
            const QJsonObject measured = mesh.json()["levels"].toArray().first().toObject();
            QVERIFY(measured["largest_error"].toDouble(200) <= mostError + 1e-9);
            QVERIFY(measured["largest_warping"].toDouble(200) <= mostWarping + 1e-9);
            QVERIFY(measured["sites"].toInt() <= level["sites"].toInt());
            sites.push_back(measured["sites"].toInt());
        }
        const int of15 = sites[0], of51 = sites[1], of11 = sites[2], of1none = sites[3], ofnone1 = sites[4];
        QVERIFY(std::max({of15, of51, of1none, ofnone1}) <= of11);
        QVERIFY(std::min(of15, of51) < of11 && std::min(of1none, ofnone1) < of11);
        QCOMPARE(tan({"extract", "body.tan", "--error", "1", "--warping", "none", "-o", "one.vtu", "--json"})
                     .json()["sites"]
                     .toInt(),
                 of1none);
        QCOMPARE(tan({"info", "body.tan", "--lod", "1:none:2"}).exitCode, 2);
        QCOMPARE(tan({"info", "body.tan", "--warping", "non"}).exitCode, 2);
    }

    /// C1: of real data, each pair needs at most 1.2 times the sites of a build for that pair alone.
    void pairsOfRealDataNeedFewSites()
    {
        const QString data = TAN_SOURCE_DIR "/../shared/data/bluntfin/bluntfinxyz.bin";
        if (!QFileInfo::exists(data))
            QSKIP_WITHOUT("data");
        QCOMPARE(tan(QStringList{"build", data, "-o", "fin.tan"} + refined).exitCode, 0);
        struct Pair {
            QStringList limits;
            QStringList build;
        };
        const std::vector<Pair> pairs = {
            {{"--error", "1", "--warping", "5"}, {"--error", "1", "--warping", "5"}},
            {{"--error", "5", "--warping", "1"}, {"--error", "5", "--warping", "1"}},
            {{"--error", "1", "--warping", "none"}, {"--by", "error", "--error", "1"}},
            {{"--error", "none", "--warping", "1"}, {"--by", "warping", "--warping", "1"}},
        };
        for (const Pair& pair : pairs) {
            const Run build = tan(QStringList{"build", data, "-o", "alone.tan", "--json"} + refined + pair.build);
            const Run mesh = tan(QStringList{"verify", "fin.tan", "--against", data, "--json"} + pair.limits);
            QVERIFY2(build.exitCode == 0 && mesh.exitCode == 0, mesh.output + mesh.messages);
            const int sites = mesh.json()["levels"].toArray().first().toObject()["sites"].toInt();
            const int alone = build.json()["sites"].toInt();
            QVERIFY2(sites > 0 && sites <= 1.2 * alone, qPrintable(QString("%1 of %2").arg(sites).arg(alone)));
        }
    }

    /// C1: a build by one of the two alone; the model still says both.
    void buildsAreOrderedByOneAlone()
    {
        for (const QString& by : {QString("error"), QString("warping")}) {
            const QString other = by == "error" ? "warping" : "error";
            const Run build = tan(
                QStringList{"build", "body.xyz", "--by", by, "--" + by, "1", "-o", by + ".tan", "--json"} + refined);
            QVERIFY2(build.exitCode == 0, build.output + build.messages);
            const QString pair = by == "error" ? "1:none" : "none:1";
            const Run proof = tan({"verify", by + ".tan", "--against", "body.xyz", "--lod", pair, "--json"});
            QVERIFY2(proof.exitCode == 0, proof.output + proof.messages);
            const QJsonObject level = proof.json()["levels"].toArray().first().toObject();
            QVERIFY(level["largest_" + by].toDouble(200) <= 1);
            QCOMPARE(level["sites"].toInt(), build.json()["sites"].toInt());
            const QStringList limits = by == "error" ? QStringList{"--error", "1", "--warping", "none"}
                                                     : QStringList{"--error", "none", "--warping", "1"};
            const Run query = tan(QStringList{"verify", "body.tan", "--against", "body.xyz", "--json"} + limits);
            const int sites = query.json()["levels"].toArray().first().toObject()["sites"].toInt();
            QVERIFY2(sites <= 1.5 * level["sites"].toInt(),
                     qPrintable(QString("%1 of %2").arg(sites).arg(level["sites"].toInt())));
            // To the end: exact in what counts.
            const Run whole = tan(QStringList{"build", "body.xyz", "--by", by, "-o", by + ".tan", "--json"} + refined);
            QVERIFY2(whole.exitCode == 0, whole.output + whole.messages);
            const QString exact = by == "error" ? "0:none" : "none:0";
            const Run all = tan({"verify", by + ".tan", "--against", "body.xyz", "--lod", exact + ",5:5", "--json"});
            QVERIFY2(all.exitCode == 0, all.output + all.messages);
            QVERIFY(all.json()["levels"].toArray().first().toObject()["largest_" + by].toDouble(200) < 1e-9);
            // What would be ignored is refused.
            const Run refused =
                tan(QStringList{"build", "body.xyz", "--by", by, "--" + other, "1", "-o", "no.tan"} + refined);
            QCOMPARE(refused.exitCode, 2);
            QVERIFY2(refused.messages.contains(other.toUtf8()), refused.messages);
        }
        QCOMPARE(
            tan(QStringList{"build", "body.xyz", "--by", "error", "--selection", "paper", "-o", "no.tan"} + refined)
                .exitCode,
            2);
        QVERIFY(!QFileInfo::exists(folder_.filePath("no.tan")));
    }

    void verifyProves()
    {
        const Run run = tan({"verify", "body.tan", "--against", "body.xyz", "--lod", "4,1,0", "--json"});
        QVERIFY2(run.exitCode == 0, run.output + run.messages);
        for (const QJsonValue entry : run.json()["levels"].toArray()) {
            const QJsonObject level = entry.toObject();
            QVERIFY(level["ok"].toBool());
            QCOMPARE(level["warping"].toDouble(-1), level["error"].toDouble());
            QVERIFY(level["largest_error"].toDouble(100) <= level["error"].toDouble() + 1e-9);
            QVERIFY(level["largest_warping"].toDouble(100) <= level["warping"].toDouble() + 1e-9);
            QCOMPARE(level["inverted"].toInt(-1), 0);
        }
        QVERIFY(run.json()["levels"].toArray()[0].toObject()["largest_warping"].toDouble() > 0);
    }

    /// C12, C15: errors on the whole, in the grid and in space: the same figures from all that measure them.
    void errorsAreMeasuredOnTheWhole()
    {
        const QStringList keys = {"error_statistics", "error_in_space", "warping_statistics"};
        const Run verified = tan({"verify", "body.tan", "--against", "body.xyz", "--lod", "4,0", "--json"});
        const Run known = tan({"info", "body.tan", "--against", "body.xyz", "--lod", "4,0", "--json"});
        const Run made =
            tan({"extract", "body.tan", "--error", "4", "--against", "body.xyz", "-o", "four.vtu", "--json"});
        QVERIFY2(verified.exitCode == 0 && known.exitCode == 0 && made.exitCode == 0, made.messages);
        const QJsonArray levels = verified.json()["levels"].toArray();
        for (const QString& key : keys) {
            const QJsonObject four = levels[0].toObject()[key].toObject();
            for (const char* number : {"largest", "mean", "percentile_99", "root_mean_square"})
                QVERIFY2(four[number].toDouble() > 0, qPrintable(key));
            QVERIFY(four["mean"].toDouble() < four["root_mean_square"].toDouble());
            QVERIFY(four["percentile_99"].toDouble() <= four["largest"].toDouble());
            QCOMPARE(levels[1].toObject()[key].toObject()["largest"].toDouble(-1), 0.0);
            QCOMPARE(known.json()["levels"].toArray()[0].toObject()[key].toObject(), four);
            QCOMPARE(made.json()[key].toObject(), four);
        }
        const QJsonObject level = levels[0].toObject();
        QCOMPARE(level["error_statistics"].toObject()["largest"], level["largest_error"]);
        QVERIFY(level["error_in_space"].toObject()["outside"].toInt() > 0);
        QVERIFY(level["error_in_space"].toObject()["largest"].toDouble() > level["largest_error"].toDouble());
        const Run text = tan({"verify", "body.tan", "--against", "body.xyz", "--lod", "4"});
        QVERIFY(text.output.contains("error in the grid") && text.output.contains("error in space"));
        QCOMPARE(tan({"extract", "body.tan", "--against", "body.xyz", "--values", "0,1", "-o", "no.vtu"}).exitCode, 2);
        QCOMPARE(tan({"info", "body.xyz", "--against", "body.xyz"}).exitCode, 2);
    }

    /// C12: which error a model guarantees is chosen, said and proved.
    void theErrorInSpaceIsKept()
    {
        const Run built = tan({"build", "body.xyz", "--builder", "refinement", "--error-in", "space", "--error", "1",
                               "--warping", "1", "-o", "seen.tan", "--json"});
        QVERIFY2(built.exitCode == 0, built.messages);
        for (const char* command : {"info", "verify"}) {
            const QStringList last = {"--against", "body.xyz", "--lod", "4"};
            const Run seen = tan(QStringList{command, "seen.tan"} + last);
            QVERIFY2(seen.exitCode == 0 && seen.output.contains("are both guaranteed"), seen.output);
            const Run other = tan(QStringList{command, "body.tan"} + last);
            QVERIFY2(other.output.contains("The guarantee is for the error in the grid"), other.output);
        }
        const auto inSpace = [this](const char* model) {
            const Run run = tan({"verify", model, "--against", "body.xyz", "--lod", "4", "--json"});
            return run.json()["levels"].toArray()[0].toObject()["error_in_space"].toObject()["largest"].toDouble(-1);
        };
        QVERIFY(inSpace("seen.tan") < 4.4 && inSpace("body.tan") > 4.4);
        const Run refused = tan(
            {"build", "body.xyz", "--builder", "refinement", "--error-in", "space", "--block", "4", "-o", "no.tan"});
        QVERIFY2(refused.exitCode == 2 && refused.messages.contains("whole grids only"), refused.messages);
    }

    void surfacesAndPicturesAreMade()
    {
        const Run surface = tan(
            {"isosurface", "body.tan", "--error", "1", "--warping", "2", "--value", "0.3", "-o", "body.ply", "--json"});
        QVERIFY2(surface.exitCode == 0, surface.messages);
        QVERIFY(surface.json()["triangles"].toInt() > 10);
        const Run picture = tan({"render", "body.tan", "--isovalue", "0.3", "--warping", "2", "--size", "64x48", "-o",
                                 "body.png", "--json"});
        QVERIFY2(picture.exitCode == 0, picture.messages);
        QVERIFY(picture.json()["triangles"].toInt() > 10);
    }

    void bothThresholdsStopABuild()
    {
        const Run build = tan(
            QStringList{"build", "body.xyz", "--error", "2", "--warping", "2", "-o", "coarse.tan", "--json"} + refined);
        QVERIFY2(build.exitCode == 0, build.messages);
        QVERIFY(build.json()["sites"].toInt() < 12 * 12 * 12 / 2);
        const Run verdict = tan({"verify", "coarse.tan", "--against", "body.xyz", "--lod", "4,2", "--json"});
        QVERIFY2(verdict.exitCode == 0, verdict.output);
    }

    /// None of its cells is folded, but the arc goes around more than once and so through itself: it is no mesh, which
    /// turns out while it is built, and is refined all the same.
    void gridsThatCrossThemselvesAreBuilt()
    {
        writeGrid("crossing.xyz", "crossing.q", 1.2, 0);
        const Run build = tan({"build", "crossing.xyz", "-o", "crossing.tan", "--json"});
        QVERIFY2(build.exitCode == 0, build.messages);
        QCOMPARE(build.json()["builder"].toString(), QString("refinement"));
        QVERIFY(build.json()["remarks"].toArray()[0].toString().contains("cannot be used as a mesh"));
        const Run verdict = tan({"verify", "crossing.tan", "--against", "crossing.xyz"});
        QVERIFY2(verdict.exitCode == 0, verdict.output + verdict.messages);
        QCOMPARE(tan({"build", "crossing.xyz", "--builder", "decimation", "-o", "no.tan"}).exitCode, 3);
    }

    /// S5, C10: where the grid itself is folded inverted cells are counted by all that look, and fail nothing.
    void foldedGridsAreBuiltAndProved()
    {
        writeGrid("folded.xyz", "folded.q", 0.3, 1.6);
        const Run build = tan({"build", "folded.xyz", "-o", "folded.tan", "--json"});
        QVERIFY2(build.exitCode == 0, build.messages);
        const int finest = build.json()["inverted"].toInt();
        QVERIFY(finest > 0);
        const Run verdict = tan({"verify", "folded.tan", "--against", "folded.xyz", "--json"});
        QVERIFY2(verdict.exitCode == 0, verdict.output);
        QVERIFY(verdict.json()["folded_cells"].toInt() > 0);
        const QJsonArray proved = verdict.json()["levels"].toArray();
        const QJsonArray told = tan({"info", "folded.tan", "--json"}).json()["levels"].toArray();
        QCOMPARE(told.size(), proved.size());
        for (qsizetype i = 0; i < proved.size(); ++i) {
            const QJsonObject level = proved[i].toObject();
            QCOMPARE(level["inverted_in_data"].toInt(-1), level["inverted"].toInt());
            QCOMPARE(told[i].toObject()["inverted"].toInt(-1), level["inverted"].toInt());
        }
        QCOMPARE(proved.last().toObject()["inverted"].toInt(), finest);
        // In words, too.
        const QString inData = "the data's own cells are folded";
        QVERIFY(tan({"verify", "folded.tan", "--against", "folded.xyz"}).output.contains(inData.toUtf8()));
        QVERIFY(tan({"info", "folded.tan"}).output.contains(inData.toUtf8()));
        QVERIFY(tan({"build", "folded.xyz", "-o", "again.tan"}).output.contains(inData.toUtf8()));
        QVERIFY(!tan({"info", "body.tan"}).output.contains(inData.toUtf8()));
    }

    void gridsAreNotWrittenAsLattices()
    {
        const Run run = tan({"sample", "o-grid", "--size", "8", "-o", "o.nrrd"});
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.messages.contains(".xyz"), run.messages);
        QVERIFY(!QFileInfo::exists(folder_.filePath("o.nrrd")));
    }

private:
    /// PLOT3D: a part of a ring, and a point of it pulled through its neighbours.
    /// An arc of so many radians a step, one of whose points is pushed outwards.
    void writeGrid(const QString& gridName, const QString& solutionName, double step, double push) const
    {
        const std::array<int, 3> size = {8, 7, 6};
        QFile grid(folder_.filePath(gridName)), solution(folder_.filePath(solutionName));
        QVERIFY(grid.open(QIODevice::WriteOnly) && solution.open(QIODevice::WriteOnly));
        QDataStream positions(&grid), values(&solution);
        for (QDataStream* stream : {&positions, &values}) {
            stream->setFloatingPointPrecision(QDataStream::SinglePrecision);
            for (const int points : size)
                *stream << qint32(points);
        }
        for (int number = 0; number < 4; ++number)
            values << 1.0f; // of the flow as a whole
        for (int component = 0; component < 5; ++component)
            for (int k = 0; k < size[2]; ++k)
                for (int j = 0; j < size[1]; ++j)
                    for (int i = 0; i < size[0]; ++i) {
                        const double radius = 3 + i + (i == 3 && j == 3 && k == 2 ? push : 0), angle = step * j;
                        const std::array<double, 3> place = {radius * std::cos(angle), radius * std::sin(angle),
                                                             double(k)};
                        if (component < 3)
                            positions << float(place[std::size_t(component)]);
                        values << float(component == 0 ? 2 + std::sin(place[0]) : 1 + 0.1 * place[1]);
                    }
    }

    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(CurvilinearTest)
#include "curvilinear_test.moc"
