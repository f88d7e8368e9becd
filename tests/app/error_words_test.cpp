// SPDX-License-Identifier: GPL-3.0-or-later
// Wherever a number is an error, it says which one (C12): in the words of the table in docs/user/accuracy.md, for a
// lattice, a grid by each builder and with each of the two errors, an irregular mesh and points.
#include "tests/app/program.h"

#include <QFile>
#include <QJsonArray>
#include <QMap>
#include <QTemporaryDir>
#include <QtTest>

#include <array>

using namespace tetra;

namespace {

/// The columns of the table behind the place.
enum Meaning { Only, InGrid, InSpace };

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Of the rows whose place begins with code: what stands there for each meaning; nothing where there is a dash.
QMap<QString, std::array<QString, 3>> rowsOfTable()
{
    static const QRegularExpression code("`([^`]+)`");
    QMap<QString, std::array<QString, 3>> rows;
    const QString page = QString::fromUtf8(contentOf(TAN_SOURCE_DIR "/docs/user/accuracy.md"));
    for (const QString& line : page.section("## Where an error is shown", 1, 1).section("\n## ", 0, 0).split('\n')) {
        const QStringList cells = line.split('|');
        if (cells.size() < 5 || !cells[1].trimmed().startsWith('`'))
            continue;
        std::array<QString, 3>& words = rows[cells[1].trimmed()];
        for (int meaning = 0; meaning < 3; ++meaning)
            words[static_cast<std::size_t>(meaning)] = code.match(cells[2 + meaning]).captured(1);
    }
    return rows;
}

} // namespace

class ErrorWordsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(folder_.isValid());
        for (const QStringList& sample : {QStringList{"c60", "c60.nrrd"}, QStringList{"bent-duct", "grid.xyz"},
                                          QStringList{"part", "part.vtu"}, QStringList{"scattered", "points.csv"}}) {
            const Run made = tan({"sample", sample[0], "--size", "8", "-o", sample[1]});
            QVERIFY2(made.exitCode == 0, made.messages);
        }
        QVERIFY(rows_.size() >= 7);
    }

    void eachPlaceSaysWhichErrorItIs_data()
    {
        QTest::addColumn<QString>("data");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("meaning");
        QTest::addColumn<bool>("isMoving"); // the boundary
        const auto row = [](const char* name, const char* data, const QStringList& options, Meaning meaning,
                            bool isMoving = false) {
            QTest::newRow(name) << data << options << int(meaning) << isMoving;
        };
        row("lattice", "c60.nrrd", {}, Only);
        row("lattice, decimated", "c60.nrrd", {"--builder", "decimation"}, Only);
        row("grid", "grid.xyz", {}, Only, true); // decimated as a mesh
        row("grid, refined", "grid.xyz", {"--error-in", "grid"}, InGrid);
        row("grid, in space", "grid.xyz", {"--error-in", "space", "--error", "1", "--warping", "1"}, InSpace);
        row("grid, automatically in space", "grid.xyz", {"--builder", "refinement", "--error", "1", "--warping", "1"},
            InSpace);
        row("grid, decimated by its indices", "grid.xyz", {"--builder", "decimation", "--space", "computational"},
            InGrid);
        row("irregular", "part.vtu", {}, Only, true);
        row("points", "points.csv", {}, Only);
    }
    void eachPlaceSaysWhichErrorItIs()
    {
        QFETCH(QString, data);
        QFETCH(QStringList, options);
        QFETCH(int, meaning);
        QFETCH(bool, isMoving);
        const Run built = tan(QStringList{"build", data, "-o", "model.tan"} + options);
        QVERIFY2(built.exitCode == 0, built.messages);
        const QJsonObject info = tan({"info", "model.tan", "--json"}).json();
        const QJsonArray range = info["range"].toArray();
        const QString middle = QString::number((range[0].toDouble() + range[1].toDouble()) / 2);
        const QStringList extract{"extract", "model.tan", "--error", "4", "-o", "mesh.vtk"};

        check("`tan build`", meaning, built);
        check("`tan info`", meaning, tan({"info", "model.tan", "--lod", "4"}));
        const Run verified = tan({"verify", "model.tan", "--against", data, "--lod", "4"});
        check("`tan verify`", meaning, verified);
        check("`tan extract`", meaning, tan(extract));
        check("`tan isosurface`", meaning,
              tan({"isosurface", "model.tan", "--error", "4", "--value", middle, "-o", "surface.ply"}));

        const QString kind = std::array<QString, 3>{"samples", "grid", "space"}[static_cast<std::size_t>(meaning)];
        QCOMPARE(info["error_kind"].toString(), kind);
        const QJsonObject mesh = tan(extract + QStringList{"--json"}).json();
        QCOMPARE(mesh["error_kind"].toString(), kind);
        QCOMPARE(tan({"render", "model.tan", "--error", "4", "--size", "32x32", "-o", "picture.png", "--json"})
                     .json()["error_kind"]
                     .toString(),
                 kind);
        const QByteArray title = contentOf(folder_.filePath("mesh.vtk")).split('\n').value(1);
        QCOMPARE(title.contains("; error_kind: " + kind.toUtf8()), meaning != Only);
        QCOMPARE(title.contains("; error_in_space: "), mesh.contains("error_in_space"));
        QVERIFY(meaning == InGrid || !mesh.contains("error_in_space"));

        const QStringList against{"--against", data};
        for (const Run& measured :
             {verified, tan(QStringList{"info", "model.tan", "--lod", "4"} + against), tan(extract + against)}) {
            QVERIFY2(measured.exitCode == 0, measured.messages);
            QVERIFY2(measured.output.contains(measuredWord(Only)) == isMoving, measured.output);
            QVERIFY2(measured.output.contains(measuredWord(InGrid)) == (meaning != Only), measured.output);
            QVERIFY2(meaning == InGrid || !measured.output.contains("%, and a warping"),
                     measured.output); // two, no list
        }
        QVERIFY(tan({"info", "model.tan", "--lod", "4", "-o", "levels.csv"}).exitCode == 0);
        const QList<QByteArray> levels = contentOf(folder_.filePath("levels.csv")).split('\n');
        QCOMPARE(levels.value(0).endsWith(",error_kind"), meaning != Only);
        QCOMPARE(levels.value(1).endsWith("," + kind.toUtf8()), meaning != Only);
    }

    /// Of a model that does not have all, a deviation is one from a mesh with an error.
    void theFinestMeshSaysIt()
    {
        struct Case {
            Meaning meaning;
            QStringList build;
        };
        const QStringList grid{"build", "grid.xyz", "--error", "2", "--warping", "2"};
        for (const Case& each :
             {Case{Only, {"build", "c60.nrrd", "--error", "2"}}, Case{InGrid, grid + QStringList{"--error-in", "grid"}},
              Case{InSpace, grid + QStringList{"--error-in", "space"}}}) {
            QVERIFY(tan(each.build + QStringList{"-o", "coarse.tan"}).exitCode == 0);
            const QJsonArray range = tan({"info", "coarse.tan", "--json"}).json()["range"].toArray();
            const QString middle = QString::number((range[0].toDouble() + range[1].toDouble()) / 2);
            check("`tan isosurface --deviation`, of the finest mesh", each.meaning,
                  tan({"isosurface", "coarse.tan", "--error", "8", "--value", middle, "--deviation", "-o",
                       "surface.ply"}));
        }
    }

    /// What is measured in passing is what the checker measures of the same mesh.
    void theErrorInSpaceStandsBeside()
    {
        const Run built = tan({"build", "grid.xyz", "--error-in", "grid", "-o", "grid.tan"});
        QVERIFY2(built.exitCode == 0, built.messages);
        const QStringList extract{"extract", "grid.tan", "--error", "4", "-o", "mesh.vtu"};
        const QJsonValue inSpace = tan(extract + QStringList{"--json"}).json()["error_in_space"];
        const QJsonObject level =
            tan({"verify", "grid.tan", "--against", "grid.xyz", "--lod", "4", "--json"}).json()["levels"][0].toObject();
        QCOMPARE(inSpace, level["error_in_space"]);
        QVERIFY(inSpace["largest"].toDouble() > 0);
        const Run text = tan(extract);
        QVERIFY2(text.output.contains(", in space of up to "), text.output);
        QVERIFY2(!text.output.contains("'tan verify' measures"), text.output); // it is known
        // Of a part of a mesh it is not.
        const Run part = tan(extract + QStringList{"--values", "-1e9,1e9"});
        QVERIFY2(!part.output.contains(", in space of up to ") && part.output.contains("'tan verify' measures"),
                 part.output);
    }

    /// The error in space is kept in whole meshes; where accuracies differ from place to place, that in the grid.
    void inAFocusItIsTheErrorInTheGrid()
    {
        const Run built = tan(
            {"build", "grid.xyz", "--error-in", "space", "--error", "1", "--warping", "1", "-o", "seen.tan", "--json"});
        QVERIFY2(built.exitCode == 0, built.messages);
        QCOMPARE(built.json()["error_kind"].toString(), "space");
        const QStringList words{"extract", "seen.tan", "-o", "focus.vtu", "--json"};
        QCOMPARE(tan(words + QStringList{"--budget", "200"}).json()["error_kind"].toString(), "space");
        const QStringList focus{"--error", "8", "--focus", "sphere:0,0,0,1", "--focus-error", "2"};
        QCOMPARE(tan(words + focus).json()["error_kind"].toString(), "grid");
    }

    /// What the front of a packed model tells.
    void packedModelsSayIt()
    {
        QVERIFY(tan({"build", "grid.xyz", "--error-in", "grid", "-o", "grid.tan"}).exitCode == 0);
        const Run packed = tan({"pack", "grid.tan", "-o", "grid.packed.tan"});
        QVERIFY2(packed.exitCode == 0, packed.messages);
        check("`tan info` of a packed model, or of one on a server", InGrid, tan({"info", "grid.packed.tan"}));
        QCOMPARE(tan({"info", "grid.packed.tan", "--json"}).json()["error_kind"].toString(), "grid");
    }

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }

    /// In what was measured: only of data whose boundary moves, only of grids with two errors.
    QByteArray measuredWord(Meaning meaning) const
    {
        const auto row =
            rows_["`tan verify`, and with `--against` also `tan info` and `tan extract`: what was measured"];
        return row[static_cast<std::size_t>(meaning)].toUtf8();
    }

    /// The place has the words of its kind of error, and not those of another.
    void check(const QString& place, int meaning, const Run& run) const
    {
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY2(rows_.contains(place), qPrintable(place));
        const std::array<QString, 3> words = rows_[place];
        const auto has = [&](int which) {
            const QString& word = words[static_cast<std::size_t>(which)];
            return !word.isEmpty() && run.output.contains(word.toUtf8());
        };
        QVERIFY2(words[static_cast<std::size_t>(meaning)].isEmpty() || has(meaning), qPrintable(place + run.output));
        for (int other = 0; other < 3; ++other) // the error in the grid of one that keeps both may be told as well
            QVERIFY2(other == meaning || (meaning == InSpace && other == InGrid) || !has(other),
                     qPrintable(place + run.output));
    }

    QTemporaryDir folder_;
    QMap<QString, std::array<QString, 3>> rows_ = rowsOfTable();
};

QTEST_GUILESS_MAIN(ErrorWordsTest)
#include "error_words_test.moc"
