// SPDX-License-Identifier: GPL-3.0-or-later
// What is no volume is refused with a text that names the file and helps (S6, S20).
#include "plugins/readers/plot3d/plot3d_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/plot3d/plot3d_files.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace tetra;

class Plot3dRefusalsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }
    void refuses_data();
    void refuses();
    void whatIsNoGridIsNotCalledOne();

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

void Plot3dRefusalsTest::refuses_data()
{
    QTest::addColumn<QByteArray>("grid");
    QTest::addColumn<QByteArray>("solution");
    QTest::addColumn<QString>("says");
    const Plot3dStyle marked{.marks = true};
    const QByteArray grid = testFile(marked, false);
    const QByteArray solution = testFile(marked, true);
    const auto row = [&](const char* name, const QByteArray& gridFile, const QByteArray& solutionFile,
                         const char* says) { QTest::newRow(name) << gridFile << solutionFile << QString(says); };
    row("empty", {}, solution, "is empty");
    row("a sentence", "This is a grid.", solution, "not a PLOT3D file");
    row("cut short", grid.chopped(1), solution, "cut short");
    row("cut solution", grid, solution.chopped(1), "cut short");
    row("another's solution", grid, testFile({.marks = true, .multiGrid = true, .grids = 2}, true), "another grid");
    QByteArray wrongMark = grid;
    wrongMark[wrongMark.size() - 4] = 1;
    row("wrong mark", wrongMark, solution, "Fortran records");

    Plot3dBytes flat(marked);
    flat.integer(5);
    flat.integer(4);
    flat.endRecord();
    for (int n = 0; n < 40; ++n)
        flat.real(n);
    flat.endRecord();
    row("two-dimensional", flat.bytes(), solution, "two-dimensional");

    Plot3dBytes layer(marked);
    for (const int number : {5, 4, 1})
        layer.integer(number);
    layer.endRecord();
    for (int n = 0; n < 60; ++n)
        layer.real(n);
    layer.endRecord();
    row("one layer", layer.bytes(), solution, "5 x 4 x 1");

    const auto filled = [&](int components, bool isSolution, double value, bool everywhere) {
        Plot3dBytes file(marked);
        for (const std::int32_t number : testSize(0))
            file.integer(number);
        file.endRecord();
        if (isSolution) {
            for (int i = 0; i < 4; ++i)
                file.real(1);
            file.endRecord();
        }
        for (int n = 0; n < 60 * components; ++n)
            file.real(everywhere || n == 33 ? value : n * n % 17);
        file.endRecord();
        return file.bytes();
    };
    row("no number", filled(3, false, NAN, false), solution, "point (0, 3, 2) has an invalid");
    row("infinite", filled(3, false, INFINITY, false), solution, "point (0, 3, 2) has an invalid");
    row("one place", filled(3, false, 2, true), solution, "no cell has a volume");
    const auto sized = [](std::initializer_list<std::int32_t> numbers) {
        Plot3dBytes file(Plot3dStyle{});
        for (const std::int32_t number : numbers)
            file.integer(number);
        file.endRecord();
        return file.bytes() + QByteArray(720, '\1');
    };
    row("negative size", sized({-3, 4, 5}), solution, "not a PLOT3D file");
    row("no points", sized({3, 0, 5}), solution, "not a PLOT3D file");
    row("overflow of the product", sized({0x7fffffff, 0x7fffffff, 0x7fffffff}), solution, "PLOT3D");
    row("more bytes than 64 bits count", sized({0x10000, 0x10000, 0x7fffffff}), solution, "PLOT3D");
    row("gigabytes that are not there", sized({1000, 1000, 1000}), solution, "cut short");
    row("thousands of millions of grids", sized({0x7fffffff, 3, 4, 5}), solution, "PLOT3D");
    row("a negative number of grids", sized({-1, 3, 4, 5}), solution, "not a PLOT3D file");
    row("one byte", "x", solution, "not a PLOT3D file");
    row("nothing but zeros", QByteArray(400, '\0'), solution, "not a PLOT3D file");
    row("nothing varies", grid, filled(5, true, 0, true), "nothing to see");
}

void Plot3dRefusalsTest::refuses()
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

/// Without a solution beside it, too. A surface of MOVIE.BYU begins with whole numbers, like a text of PLOT3D: parts,
/// points, polygons and edges, the polygons of each part, the points, their numbers in the polygons.
void Plot3dRefusalsTest::whatIsNoGridIsNotCalledOne()
{
    QByteArray surface = "     1   400   380  1500\n     1   380\n";
    for (int point = 0; point < 400; ++point)
        surface += QByteArray::number(point % 20 * 0.5, 'f', 5) + " " + QByteArray::number(point / 20 * 0.5, 'f', 5) +
                   " 0.00000\n";
    for (int polygon = 0; polygon < 375; ++polygon)
        surface += "     1     2     3    -4\n";
    const auto saysOf = [&](const char* name, const QByteArray& content) {
        const auto path = write(name, content);
        const auto dataset = read(path);
        const auto contents = asLoaded<Plot3dReader>().probe(path, {}, {});
        if (dataset || contents)
            return QString("it is read");
        return dataset.error().text() == contents.error().text() ? QString::fromStdString(dataset.error().text())
                                                                 : QString("probing says something else");
    };
    const QString text = saysOf("cow.g", surface);
    QVERIFY2(text.contains("another format") && text.contains("MOVIE.BYU") && !text.contains("without values"),
             qPrintable(text));
    const QByteArray grid = testFile({.marks = true}, false);
    QVERIFY(saysOf("whole.xyz", grid).contains("a grid without values"));
    const QString cut = saysOf("cut.xyz", grid.chopped(1));
    QVERIFY2(cut.contains("cut short"), qPrintable(cut));
}

QTEST_GUILESS_MAIN(Plot3dRefusalsTest)
#include "plot3d_refusals_test.moc"
