// SPDX-License-Identifier: GPL-3.0-or-later
// Bad files are refused with a text, in little memory and time (S20).
#include "plugins/readers/cells/cells_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/cells/vtu_text.h"

#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace tetra;

namespace {

const std::string ucd =
    "4 1 1 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 1 tet 1 2 3 4\n1 1\nheat,\n1 1\n2 2\n3 3\n4 4\n";

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t place = text.find(what);
    return place == std::string::npos ? std::string("not there") : text.replace(place, what.size(), by);
}

} // namespace

class CellsBadFilesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    Result<Dataset> read(const char* name, const std::string& text)
    {
        return asLoaded<CellsReader>().read(
            writtenFile(std::filesystem::path(folder_.path().toStdString()) / name, text), {}, {});
    }

private slots:
    void grids_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("by");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* what, const char* by, const char* says) {
            QTest::newRow(name) << what << by << says;
        };
        row("no XML", "<VTKFile", "<File", "not a VTK XML file");
        row("another kind", "UnstructuredGrid\" v", "ImageData\" v", "ImageData");
        row("type of garbage", "UnstructuredGrid\" v", "Unstruct\1\33[2J\" v", "Unstruct\\x01\\x1b[2J");
        row("array of garbage", "\"heat\" format=\"ascii\"", "\"h\7\" format=\"hex\"", "'h\\x07'");
        row("format of garbage", "\"heat\" format=\"ascii\"", "\"heat\" format=\"\33[m\"", "format '\\x1b[m'");
        row("components of garbage", "NumberOfComponents=\"3\"", "NumberOfComponents=\"\33[m\"", "\\x1b[m components");
        row("another packer", "byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order",
            "compressed with vtkLZ4DataCompressor, and only zlib is supported. Save it with zlib");
        row("no piece", "<Piece NumberOfPoints", "<Part NumberOfPoints", "no piece");
        row("no counts", "NumberOfCells=\"2\"", "", "how many points");
        row("negative count", "NumberOfPoints=\"6\"", "NumberOfPoints=\"-6\"", "how many points");
        row("huge points", "NumberOfPoints=\"6\"", "NumberOfPoints=\"9000000000000000000\"", "more points");
        row("many points", "NumberOfPoints=\"6\"", "NumberOfPoints=\"9000000000000\"", "too short");
        row("many cells", "NumberOfCells=\"2\"", "NumberOfCells=\"18446744073709551615\"", "too short");
        row("fewer points", "NumberOfPoints=\"6\"", "NumberOfPoints=\"5\"", "more than");
        row("more values", "1 2 3 4 5 6", "1 2 3 4 5 6 7", "more than 6 numbers");
        row("no number", "1 2 3 4 5 6", "1 2 3 4 five 6", "'five'");
        row("no types", "Name=\"types\"", "Name=\"kinds\"", "no array 'types'");
        row("falling offsets", ">5 9<", ">9 5<", "do not rise");
        row("huge offset", ">5 9<", ">5 900000000000<", "too short");
        row("negative corner", "0 1 2 3 4 1 5 2 4", "0 1 2 3 4 1 5 2 -4", "'-4'");
        row("corner beyond", "0 1 2 3 4 1 5 2 4", "0 1 2 3 4 1 6 2 4", "corner 6 of 6");
        row("corner counts", ">14 10<", ">12 10<", "the number of corners");
        row("polyhedron", ">14 10<", ">14 42<", "polyhedra");
        row("another shape", ">14 10<", ">14 78<", "a shape that TAn does not support: Bezier tetrahedra");
        row("no shape", ">14 10<", ">14 250<", "a shape that TAn does not support: number 250");
        row("time steps", "<UnstructuredGrid", "<UnstructuredGrid TimeValues=\"0 0.5\"", "several time steps");
        row("cut behind a piece", "</Piece>\n</UnstructuredGrid>\n</VTKFile>", "</Piece>", "damaged or cut short");
        row("cut behind appended data", "</VTKFile>", "<AppendedData encoding=\"raw\">_123",
            "within its appended data");
        row("components", "NumberOfComponents=\"3\"", "NumberOfComponents=\"3000000000\"", "3000000000 components");
        row("flat places", "NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"", "three coordinates");
        row("string values", "Float32\" Name=\"heat", "String\" Name=\"heat", "no values");
        row("unknown format", "\"heat\" format=\"ascii\"", "\"heat\" format=\"hex\"", "unknown format");
        row("no base64", "\"heat\" format=\"ascii\"", "\"heat\" format=\"binary\"", "short");
        row("not appended", "\"heat\" format=\"ascii\">1", "\"heat\" format=\"appended\" offset=\"0\">1", "short");
        row("unclosed", "</Cells>", "</Cells", "damaged or cut short");
        row("cut", "</PointData>", "<", "damaged or cut short");
        row("places not numbers", "0 0 0 1 0 0", "nan 0 0 1 0 0", "not finite");
    }
    void grids()
    {
        QFETCH(const QString, what);
        QFETCH(const QString, by);
        QFETCH(const QString, says);
        const auto dataset = read("bad.vtu", replaced(VtuText().text(), what.toStdString(), by.toStdString()));
        QVERIFY(!dataset.ok());
        const QString error = QString::fromStdString(dataset.error().text());
        QVERIFY2(error.contains("bad.vtu") && error.contains(says), qPrintable(error));
    }

    void tables_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("by");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* what, const char* by, const char* says) {
            QTest::newRow(name) << what << by << says;
        };
        row("empty", ucd.c_str(), "", "line 0");
        row("binary", "4 1", "\7 4 1", "binary UCD");
        row("four counts", "4 1 1 0 0", "4 1 1 0", "line 1: the first line");
        row("huge counts", "4 1 1 0 0", "99999999999999 1 1 0 0", "too short");
        row("too large counts", "4 1 1 0 0", "99999999999999999999999 1 1 0 0", "line 1");
        row("more points", "4 1 1 0 0", "5 1 1 0 0", "line 6");
        row("point twice", "2 1 0 0", "1 1 0 0", "appears twice");
        row("short point", "2 1 0 0", "2 1 0", "three coordinates");
        row("no number", "3 0 1 0", "3 0 x 0", "line 4");
        row("unknown shape", "tet", "cone", "shape");
        row("unknown corner", "tet 1 2 3 4", "tet 1 2 3 9", "corner");
        row("missing corner", "tet 1 2 3 4", "tet 1 2 3", "corner");
        row("surplus corner", "tet 1 2 3 4", "tet 1 2 3 4 1", "more corners");
        row("wrong sum", "\n1 1\nheat", "\n1 2\nheat", "line 7");
        row("many arrays", "\n1 1\nheat", "\n100000000000 1\nheat", "line 7");
        row("no name", "1 1\nheat,\n1 1\n2 2\n3 3\n4 4\n", "1 1\n", "name");
        row("few values", "4 4\n", "", "after 3 of 4 values");
        row("value of nobody", "4 4\n", "5 4\n", "no point or cell has");
        row("missing value", "3 3\n", "3\n", "missing");
        row("no values", "4 1 1 0 0", "4 1 0 0 0", "no values");
    }
    void tables()
    {
        QFETCH(const QString, what);
        QFETCH(const QString, by);
        QFETCH(const QString, says);
        const auto dataset = read("bad.inp", replaced(ucd, what.toStdString(), by.toStdString()));
        QVERIFY(!dataset.ok());
        const QString error = QString::fromStdString(dataset.error().text());
        QVERIFY2(error.contains("bad.inp") && error.contains(says), qPrintable(error));
    }

    /// Random changes of bytes, cuts and repetitions: an answer each time.
    void mutations()
    {
        std::mt19937 random(3);
        int good = 0;
        for (int trial = 0; trial < 4000; ++trial) {
            std::string text = trial % 2 == 0 ? VtuText().text() : ucd;
            for (std::uint32_t change = 0; change < 1 + random() % 4; ++change) {
                const std::size_t place = random() % text.size();
                switch (random() % 4) {
                case 0: text[place] = static_cast<char>(random() % 256); break;
                case 1: text[place] = static_cast<char>('0' + random() % 10); break;
                case 2: text.insert(place, text.substr(random() % text.size(), random() % 30)); break;
                default: text.erase(place, random() % 20); break;
                }
                if (text.empty())
                    text.assign(1, ' ');
            }
            const auto dataset = read(trial % 2 == 0 ? "m.vtu" : "m.inp", text);
            good += dataset.ok();
            QVERIFY(dataset.ok() || !dataset.error().text().empty());
        }
        QVERIFY(good > 100);
    }
};

QTEST_GUILESS_MAIN(CellsBadFilesTest)
#include "cells_bad_files_test.moc"
