// SPDX-License-Identifier: GPL-3.0-or-later
// PLOT3D files in text are read as binary ones are (R1), with all that Fortran writes; what is damaged is refused with
// a text that names the place (S6, S20).
#include "plugins/readers/plot3d/plot3d_reader.h"
#include "plugins/readers/plot3d/plot3d_text.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/plot3d/plot3d_files.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <random>

using namespace tetra;

namespace {

Result<Plot3dText> numbersIn(const QByteArray& text, const Progress& progress = {})
{
    return readPlot3dText(std::as_bytes(std::span(text.constData(), static_cast<std::size_t>(text.size()))), progress);
}

QByteArray with(QByteArray text, const QByteArray& from, const QByteArray& to)
{
    const auto place = text.indexOf(from);
    if (place < 0)
        qFatal("'%s' is not in the text", from.constData());
    return text.replace(place, from.size(), to);
}

} // namespace

class Plot3dTextTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void everyKindIsRead_data()
    {
        QTest::addColumn<bool>("multi");
        QTest::addColumn<bool>("iblank");
        for (const bool multi : {false, true})
            for (const bool iblank : {false, true})
                QTest::addRow("%s%s", multi ? "multi" : "single", iblank ? " iblank" : "") << multi << iblank;
    }
    void everyKindIsRead()
    {
        QFETCH(bool, multi);
        QFETCH(bool, iblank);
        const Plot3dStyle style{.multiGrid = multi, .iblank = iblank, .grids = multi ? 2 : 1};
        write("g.q", testText(style, true));
        const auto path = write("g.xyz", testText(style, false));
        const ParameterValues last{{"grid", std::int64_t(multi ? 2 : 0)}};
        const auto dataset = read(path, last);
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->domain, DomainClass::Curvilinear);
        const std::int32_t grid = multi ? 1 : 0;
        QCOMPARE(dataset->lattice.size, (std::array<std::uint32_t, 3>{std::uint32_t(3 + grid), 4, 5}));
        QCOMPARE(dataset->values.type(), SampleType::Float32);
        for (int n = 0; n < (3 + grid) * 20; ++n) {
            const auto point = static_cast<std::uint64_t>(n);
            QCOMPARE(dataset->position(point), Eigen::Vector3d(testCoordinate(0, n, grid), testCoordinate(1, n, grid),
                                                               testCoordinate(2, n, grid)));
            QCOMPARE(dataset->values.at(point), testQuantity(0, n));
        }
        const auto bySolution = read(folder_->filePath("g.q").toStdString(), last);
        QVERIFY2(bySolution.ok(), bySolution.ok() ? "" : bySolution.error().text().c_str());
        QCOMPARE(bySolution->source.hash, dataset->source.hash);
        const auto contents = asLoaded<Plot3dReader>().probe(path, last, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->points, dataset->pointCount());
        QCOMPARE(contents->blocks.size(), std::size_t(multi ? 2 : 0));
        if (multi) {
            const auto joined = read(path);
            QVERIFY2(joined.ok() && joined->domain == DomainClass::Irregular,
                     joined.ok() ? "" : joined.error().text().c_str());
        }
    }

    /// A text and a binary file go together.
    void kindsMayDiffer()
    {
        write("g.q", testFile({.doubles = true}, true));
        const auto path = write("g.xyz", testText({}, false));
        const auto dataset = read(path, {{"array", std::string("pressure")}});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->values.type(), SampleType::Float64);
    }

    void blankedPointsAreHoles()
    {
        write("g.q", testText({}, true));
        const auto dataset =
            read(write("g.xyz", testText({.iblank = true}, false, [](int n) { return n % 3 == 2 ? 0 : 1; })));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->domain, DomainClass::Irregular);
        QCOMPARE(dataset->pointCount(), std::uint64_t(2 * 4 * 5));
    }

    void numbersOfFortranAreRead()
    {
        const auto found = numbersIn(" 3 4,5\r\n1.5D+03\t-2.5d-1 .5E2 +7 1.25-103 2.5+100 2*0.5, 1e-400 -0\n");
        QVERIFY2(found.ok(), found.ok() ? "" : found.error().text().c_str());
        QCOMPARE(found->numbers, (std::vector<double>{3, 4, 5, 1500, -.25, 50, 7, 1.25e-103, 2.5e100, .5, .5, 0, 0}));
        QVERIFY(!found->singlePrecision); // for 2.5e100
    }

    void digitsTellThePrecision()
    {
        QVERIFY(numbersIn("1 0.123456789 -1.23456789E-01 2*0.000000012345678\n")->singlePrecision);
        QVERIFY(!numbersIn("1 0.1234567891\n")->singlePrecision);
        write("g.q", with(testText({}, true), " 1.25", " 1.2500000000000002"));
        const auto dataset = read(write("g.xyz", testText({}, false)));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->values.type(), SampleType::Float64);
        QCOMPARE(dataset->values.at(1), 1.2500000000000002);
    }

    void repeatsTakeNoMoreThanAFileOfThatSizeMay()
    {
        const auto few = numbersIn("3000*1.5 2\n");
        QVERIFY2(few.ok(), few.ok() ? "" : few.error().text().c_str());
        QCOMPARE(few->numbers.size(), std::size_t(3001));
        for (const char* bomb : {"1000000000*1.0 2\n", "18446744073709551615*1.0 2\n", "9900*1.0 9900*1.0\n"}) {
            const auto many = numbersIn(bomb);
            QVERIFY(!many.ok());
            QVERIFY2(many.error().text().find("repeats numbers more often") != std::string::npos,
                     many.error().text().c_str());
        }
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("grid");
        QTest::addColumn<QByteArray>("solution");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QByteArray& grid, const QByteArray& solution, const char* says) {
            QTest::newRow(name) << grid << solution << QString(says);
        };
        const QByteArray grid = testText({}, false), solution = testText({}, true);
        const QByteArray lines = grid.left(grid.indexOf('\n', grid.size() / 2) + 1);
        row("cut after a line", lines, solution, "grid of 3 x 4 x 5 points, which takes 183 numbers or more, and has");
        row("cut after a line, what to do", lines, solution, "it is cut short. Copy the file again.");
        row("cut within a number", grid.left(grid.lastIndexOf('.')), solution, "directly after its last number");
        row("cut solution", grid, solution.left(solution.indexOf('\n', 400) + 1), "takes 307 numbers");
        row("a number too many", grid + "1\n", solution, "fits no kind of PLOT3D file");
        row("a word", with(grid, " 0.125", " 0.1Z5"), solution, "'0.1Z5' in line 3 is not a number");
        row("two numbers in one", with(grid, " 0.125", " 0.12-5.5"), solution, "'0.12-5.5'");
        row("too large a number", with(grid, " 0.125", " 1e999"), solution, "'1e999'");
        row("no count", with(grid, " 0.125", " 0*0.125"), solution, "'0*0.125'");
        row("a null", with(grid, " 0.125", " 1*"), solution, "'1*'");
        row("no position", with(grid, " 0.125", " nan"), solution, "has an invalid or extremely large position");
        row("another's solution", grid, testText({.multiGrid = true, .grids = 2}, true), "another grid");
        row("two-dimensional", "3 2\n1 2 3 1 2 3 1 1 1 2 2 2\n", solution, "two-dimensional");
        row("sizes that are none", "3.5 4 5\n" + QByteArray("1 ").repeated(180) + "\n", solution, "not a PLOT3D file");
        row("a huge size", "3000000000 4 5\n1 2 3\n", solution, "not a PLOT3D file");
        row("sizes without an end", "1000000 1000 1000\n1 2 3\n", solution, "not a PLOT3D file");
        row("one number", "7\n", solution, "not a PLOT3D file");
        row("more grids than sizes", "9999 3 4 5\n", solution, "only the beginning of a grid");
    }
    void refuses()
    {
        QFETCH(QByteArray, grid);
        QFETCH(QByteArray, solution);
        QFETCH(QString, says);
        write("g.q", solution);
        const auto dataset = read(write("g.xyz", grid));
        QVERIFY(!dataset.ok());
        QCOMPARE(dataset.error().kind, ErrorKind::BadInput);
        const QString text = QString::fromStdString(dataset.error().text());
        QVERIFY2(text.contains(says) && text.contains(folder_->path()), qPrintable(text));
    }

    /// A file of which nobody can tell whether its last number is whole.
    void theEndMustBeClear()
    {
        QVERIFY(numbersIn("1.0000000E+00 -2.0000000E+00").ok()); // as a format of Fortran writes them
        QVERIFY(!numbersIn("1.0000000E+00 -2.0000000E+0").ok());
        QVERIFY(!numbersIn("1.5 2.5").ok());
        QVERIFY(numbersIn("1.5 2.5 ").ok());
    }

    void cutFilesAreReadOrRefused()
    {
        write("g.q", testText({}, true));
        const QByteArray grid = testText({.iblank = true}, false);
        const auto whole = read(write("g.xyz", grid));
        QVERIFY(whole.ok());
        int same = 0;
        for (qsizetype length = grid.size() - 1; length >= 0; length -= length > grid.size() - 100 ? 1 : 37) {
            const auto part = read(write("g.xyz", grid.left(length)));
            if (!part)
                continue;
            QCOMPARE(part->source.hash, whole->source.hash);
            ++same;
        }
        QVERIFY2(same <= 4, qPrintable(QString::number(same))); // ends of lines alone
    }

    void mutationsAreReadOrRefused()
    {
        std::mt19937 random(20240301);
        int wereRead = 0;
        for (int round = 0; round < 1000; ++round) {
            const Plot3dStyle style{.multiGrid = (round & 1) != 0, .iblank = (round & 2) != 0};
            QByteArray files[] = {testText(style, false), testText(style, true)};
            QByteArray& file = files[random() % 2];
            constexpr std::string_view characters = "0123456789.-+eD* \n";
            for (unsigned change = 0; change <= random() % 2; ++change) {
                const auto place = static_cast<qsizetype>(random() % static_cast<unsigned>(file.size()));
                if (random() % 3 == 0)
                    file.remove(place, static_cast<qsizetype>(random() % 5));
                else
                    file[place] = characters[random() % characters.size()];
            }
            write("g.q", files[1]);
            const auto dataset = read(write("g.xyz", files[0]));
            if (!dataset) {
                QVERIFY(dataset.error().text().size() > 10);
                continue;
            }
            ++wereRead;
            QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(0));
            for (const Eigen::Vector3d& position : *dataset->positions)
                QVERIFY(position.allFinite());
        }
        QVERIFY(wereRead > 50);
    }

    void scores()
    {
        const auto score = [&](const char* name, const QByteArray& content) {
            return asLoaded<Plot3dReader>().score(
                write(name, content),
                std::as_bytes(std::span(content.constData(), static_cast<std::size_t>(content.size()))));
        };
        for (const char* name : {"a.xyz", "a.x", "a.g", "a.p3d", "a.q"}) {
            QVERIFY2(score(name, "3 4 5\n0.1 0.2\n") > 0.8, name);
            QVERIFY2(score(name, "2\n3 4 5\n3 4 5\n2*0.1 1.5D+03\n") > 0.8, name);
        }
        QCOMPARE(score("a.txt", "3 4 5\n0.1 0.2\n"), 0.);
        QCOMPARE(score("a.xyz", "3\nwater\nO 0 0 0\n"), 0.);
        QCOMPARE(score("a.xyz", "1 2 3 4\n5 6 7 8\n"), 0.);
        QVERIFY(score("a.g", "PLOT3D?") > 0 && score("a.g", "PLOT3D?") < 0.5);
    }

    void cancels()
    {
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(numbersIn("1 2 3\n", Progress(stop.get_token(), {})).error().kind, ErrorKind::Cancelled);
        write("g.q", testText({}, true));
        const auto path = write("g.xyz", testText({}, false));
        const auto dataset = asLoaded<Plot3dReader>().read(path, {}, Progress(stop.get_token(), {}));
        QVERIFY(!dataset.ok());
        QCOMPARE(dataset.error().kind, ErrorKind::Cancelled);
    }

private:
    std::filesystem::path write(const std::string& name, const QByteArray& content) const
    {
        const std::filesystem::path path = folder_->path().toStdString() + "/" + name;
        std::ofstream(path, std::ios::binary | std::ios::trunc).write(content.data(), content.size());
        return path;
    }
    static Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values = {})
    {
        return complete(asLoaded<Plot3dReader>().read(path, values, {}));
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(Plot3dTextTest)
#include "plot3d_text_test.moc"
