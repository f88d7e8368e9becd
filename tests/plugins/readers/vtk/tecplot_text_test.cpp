// SPDX-License-Identifier: GPL-3.0-or-later
// Tecplot's text format: zones by points and by blocks, of values of nodes and elements, shared and repeated ones.
#include "plugins/readers/vtk/tecplot_text.h"

#include <QTest>

using namespace tetra;

namespace {

const std::string cubeHead = "TITLE = \"cube\"\nVARIABLES = \"X\" \"Y\" \"Z\" \"P\" \"T\"\n";
const std::string cubeBlocks = "0 1 0 1 0 1 0 1\n0 0 1 1 0 0 1 1\n0 0 0 0 1 1 1 1\n";

std::string errorOf(const std::string& text)
{
    const auto file = readTecplot(text);
    return file ? "" : file.error().text();
}

std::vector<double> valuesOf(const TecplotZone& zone, std::size_t variable)
{
    std::vector<double> values;
    for (std::size_t i = 0; zone.values[variable] && i < zone.values[variable]->size(); ++i)
        values.push_back(zone.values[variable]->at(i));
    return values;
}

} // namespace

class TecplotTextTest : public QObject {
    Q_OBJECT

private slots:
    void pointsAndBlocksAreTheSame()
    {
        const auto blocks =
            readTecplot(cubeHead + "ZONE I=2, J=2, K=2, DATAPACKING=BLOCK\n" + cubeBlocks + "1 2 3 4 5 6 7 8\n8*0.5\n");
        QVERIFY2(blocks.ok(), blocks.ok() ? "" : blocks.error().text().c_str());
        std::string rows;
        for (int n = 0; n < 8; ++n)
            rows += std::to_string(n % 2) + "," + std::to_string(n / 2 % 2) + "," + std::to_string(n / 4) + ", " +
                    std::to_string(n + 1) + " .5  # a comment\n\n";
        for (const char* header :
             {"ZONE T=\"a\", I=2, J=2, K=2, F=POINT\n", "zone i=2 j=2 k=2\n",
              "ZONE\nSTRANDID=1, SOLUTIONTIME=0.5\n I=2,J=2,K=2, ZONETYPE=Ordered\nDATAPACKING=POINT\n"
              "DT=(SINGLE SINGLE SINGLE SINGLE SINGLE)\n"}) {
            const auto points = readTecplot(cubeHead + header + rows);
            QVERIFY2(points.ok(), points.ok() ? "" : points.error().text().c_str());
            QCOMPARE(points->zones.size(), std::size_t(1));
            QCOMPARE(points->zones[0].size, (std::array<std::uint32_t, 3>{2, 2, 2}));
            for (std::size_t variable = 0; variable < 5; ++variable)
                QCOMPARE(valuesOf(points->zones[0], variable), valuesOf(blocks->zones[0], variable));
        }
        QCOMPARE(valuesOf(blocks->zones[0], 4), std::vector<double>(8, 0.5));
    }

    void elementsHaveNodesAndValues()
    {
        const auto file = readTecplot(
            cubeHead +
            "ZONE NODES=8, ELEMENTS=1, ZONETYPE=FEBRICK, DATAPACKING=BLOCK, VARLOCATION=([5]=CELLCENTERED)\n" +
            cubeBlocks + "1 2 3 4 5 6 7 8\n9.5\n1 2 4 3 5 6 8 7\n");
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        const TecplotZone& zone = file->zones[0];
        QVERIFY(zone.element == TecplotElement::Brick);
        QCOMPARE(*zone.connectivity, (std::vector<std::int64_t>{0, 1, 3, 2, 4, 5, 7, 6}));
        QCOMPARE(zone.perElement, (std::vector<bool>{false, false, false, false, true}));
        QCOMPARE(valuesOf(zone, 4), std::vector<double>{9.5});
        for (const char* header :
             {"ZONE N=4, E=1, F=FEPOINT, ET=TETRAHEDRON", "ZONE N=4,E=1,ZONETYPE=FETETRAHEDRON,DATAPACKING=POINT",
              "ZONE N=4, E=1, F=FEPOINT, ET=QUADRILATERAL", "ZONE N=4, E=1, ET=TETRAHEDRON, DATAPACKING=FEPOINT"}) {
            const auto tetrahedron =
                readTecplot(cubeHead + header + "\n0 0 0 1 5\n1 0 0 2 5\n0 1 0 3 5\n0 0 1 4 5\n1 2 3 4\n");
            QVERIFY2(tetrahedron.ok(), tetrahedron.ok() ? "" : tetrahedron.error().text().c_str());
            QCOMPARE(tetrahedron->zones[0].connectivity->size(), std::size_t(4));
        }
    }

    void blanksInListsDoNotMatter_data()
    {
        QTest::addColumn<QByteArray>("list");
        for (const char* list : {"VARLOCATION = ([5] = CELLCENTERED)", "VARLOCATION=([1-4] =NODAL,[5]= CELLCENTERED )",
                                 "VARLOCATION = ( [1,2,3,4]\n=\nNODAL , 5 = cellcentered)",
                                 "VARLOCATION=(NODAL, NODAL NODAL,NODAL ,CELLCENTERED)"})
            QTest::newRow(list) << QByteArray(list);
    }
    void blanksInListsDoNotMatter()
    {
        QFETCH(QByteArray, list);
        const auto file =
            readTecplot(cubeHead + "ZONE NODES = 8, ELEMENTS = 1, ZONETYPE = FEBRICK, DATAPACKING = BLOCK, " +
                        list.toStdString() + "\n" + cubeBlocks + "1 2 3 4 5 6 7 8\n9.5\n1 2 4 3 5 6 8 7\n");
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        QCOMPARE(file->zones[0].perElement, (std::vector<bool>{false, false, false, false, true}));
        QCOMPARE(valuesOf(file->zones[0], 4), std::vector<double>{9.5});
    }

    /// Zones of a strand are steps; those of none are there at every time.
    void strandsAreTimes()
    {
        const std::string values = cubeBlocks + "1 2 3 4 5 6 7 8\n8*0.5\n";
        const auto zone = [&](const std::string& words) {
            return "ZONE I=2, J=2, K=2, F=BLOCK" + words + "\n" + values;
        };
        const auto file = readTecplot(
            cubeHead + zone(", STRANDID=1, SOLUTIONTIME=2.5D+00") + zone(", SOLUTIONTIME = -1, STRANDID = 1") +
            zone(", STRANDID=2, SOLUTIONTIME=2.5") + zone(", STRANDID=0, SOLUTIONTIME=7") + zone(""));
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        QCOMPARE(tecplotTimes(*file), (std::vector<double>{-1, 2.5}));
        std::vector<bool> first, second;
        for (const TecplotZone& one : file->zones) {
            first.push_back(isThereAt(one, -1));
            second.push_back(isThereAt(one, 2.5));
        }
        QCOMPARE(first, (std::vector<bool>{false, true, false, true, true}));
        QCOMPARE(second, (std::vector<bool>{true, false, true, true, true}));
        QVERIFY(tecplotTimes(*readTecplot(cubeHead + zone(", SOLUTIONTIME=1") + zone(", SOLUTIONTIME=2"))).empty());
    }

    void zonesShareVariables()
    {
        const auto file = readTecplot(
            cubeHead + "ZONE T=\"first\" NODES=4, ELEMENTS=1, ZONETYPE=FETETRAHEDRON, DATAPACKING=BLOCK\n"
                       "0 1 0 0 0 0 1 0 0 0 0 1 1 2 3 4 5 6 7 8\n1 2 3 4\n"
                       "ZONE T=\"second\" NODES=4, ELEMENTS=1, ZONETYPE=FETETRAHEDRON, DATAPACKING=BLOCK,\n"
                       "VARSHARELIST=([1-3]=1), PASSIVEVARLIST=[5], CONNECTIVITYSHAREZONE=1\n11 12 13 14\n");
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        QCOMPARE(file->zones.size(), std::size_t(2));
        const TecplotZone& second = file->zones[1];
        QCOMPARE(QString::fromStdString(second.name), QString("second"));
        QCOMPARE(valuesOf(second, 0), (std::vector<double>{0, 1, 0, 0}));
        QCOMPARE(valuesOf(second, 3), (std::vector<double>{11, 12, 13, 14}));
        QVERIFY(second.values[4] == nullptr);
        QVERIFY(second.connectivity == file->zones[0].connectivity);
    }

    /// One for each cell of the lattice, of which a plane has one layer; also where another zone shares them.
    void latticesHaveValuesOfElements()
    {
        const auto file = readTecplot(
            cubeHead + "ZONE I=3, J=2, K=1, F=BLOCK, VARLOCATION=([4-5]=CELLCENTERED)\n"
                       "0 1 2 0 1 2\n0 0 0 1 1 1\n6*0\n1 2\n3 4\n"
                       "ZONE I=3, J=2, K=1, F=BLOCK, VARLOCATION=([5]=CELLCENTERED), VARSHARELIST=([1-4]=1)\n"
                       "5 6\n");
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        QCOMPARE(file->zones.size(), std::size_t(2));
        QCOMPARE(file->zones[0].elements, std::uint64_t(2));
        QCOMPARE(valuesOf(file->zones[0], 4), (std::vector<double>{3, 4}));
        QCOMPARE(file->zones[1].perElement, (std::vector<bool>{false, false, false, true, true}));
        QCOMPARE(valuesOf(file->zones[1], 3), (std::vector<double>{1, 2}));
        QCOMPARE(valuesOf(file->zones[1], 4), (std::vector<double>{5, 6}));
    }

    void numbersKeepTheirPrecision()
    {
        const std::string text =
            "VARIABLES = X (m), Y (m), Z (m), V\nZONE I=2, J=1, K=1, DT=(DOUBLE DOUBLE DOUBLE SINGLE)\n"
            "0.1 1.5D+02 -2.5e-310 NaN\n+1 2.5d-1 3 1e39\n";
        // Names with blanks must be in quotes.
        QVERIFY(!readTecplot(text).ok());
        std::string quoted = text;
        quoted.replace(0, quoted.find('\n'), "VARIABLES = \"X (m)\", \"Y (m)\", \"Z [m]\", \"V\"");
        const auto file = readTecplot(quoted);
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        QCOMPARE(file->axes, (std::array<std::size_t, 3>{0, 1, 2}));
        QCOMPARE(valuesOf(file->zones[0], 0), (std::vector<double>{0.1, 1}));
        QCOMPARE(valuesOf(file->zones[0], 1), (std::vector<double>{150, 0.25}));
        QVERIFY(std::isnan(file->zones[0].values[3]->at(0)));
        QVERIFY(std::isinf(file->zones[0].values[3]->at(1)));
        QCOMPARE(file->zones[0].values[3]->doubles.size(), std::size_t(0));
    }

    void whatIsWrongIsTold_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* what, const std::string& text, const char* told) {
            QTest::newRow(what) << QByteArray::fromStdString(text) << QByteArray(told);
        };
        const std::string zone = "ZONE I=2, J=2, K=2, F=BLOCK\n";
        const std::string full = cubeBlocks + "1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7 8\n";
        row("cut in a header", cubeHead + "ZONE T=\"one\", I=2, J=", "('one') ends within its header");
        row("a value too few", cubeHead + zone + cubeBlocks + "1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7\n",
            "ends before the last of its 8 values of 'T'");
        row("a value too many", cubeHead + zone + full + "9\n", "more numbers than its 1 zones require");
        row("a word among the values", cubeHead + zone + cubeBlocks + "1 2 three 4",
            "something other than a number among its 8 values of 'P'");
        row("no end of line", cubeHead + zone + full.substr(0, full.size() - 1), "add an end of line");
        row("repeated too often", cubeHead + zone + cubeBlocks + "8*1 9*2\n", "more numbers than it should");
        row("no variables", "TITLE = \"x\"\n" + zone + full, "before its VARIABLES");
        row("no place", "VARIABLES = \"A\" \"Y\" \"Z\"\n" + zone + full, "is called X");
        row("no zone", cubeHead, "no zone");
        std::string zones = "VARIABLES = X, Y, Z, V\n";
        for (int i = 0; i < 50'001; ++i)
            zones += "ZONE I=1\n0 0 0 1\n";
        row("zones without end", zones, "more than 50000 zones");
        row("no size", cubeHead + "ZONE F=BLOCK\n" + full, "does not state how many points");
        row("a size of nothing", cubeHead + "ZONE I=0, J=2, K=2, F=BLOCK\n" + full, "'I = 0'");
        row("a huge size", cubeHead + "ZONE I=2000000000, J=2000000000, K=2000000000, F=BLOCK\n" + full,
            "does not state how many points");
        row("a size that is not there", cubeHead + "ZONE I=1000000, J=1000, K=1000, F=BLOCK\n" + full,
            "ends before the last");
        row("an unknown packing", cubeHead + "ZONE I=2, J=2, K=2, F=PILE\n" + full, "the unknown packing 'PILE'");
        row("a strand without a number", cubeHead + "ZONE I=2, J=2, K=2, F=BLOCK, STRANDID=first\n" + full,
            "'STRANDID = FIRST'");
        row("a time without a number", cubeHead + "ZONE I=2, J=2, K=2, F=BLOCK, SOLUTIONTIME=noon\n" + full,
            "'SOLUTIONTIME = NOON'");
        row("a location that is none", cubeHead + "ZONE I=2, J=2, K=2, F=BLOCK, VARLOCATION=([4]=EDGES)\n" + full,
            "VARLOCATION '[4]=EDGES'");
        row("polyhedra", cubeHead + "ZONE NODES=8, ELEMENTS=1, FACES=6, ZONETYPE=FEPOLYHEDRON\n" + full,
            "'FEPOLYHEDRON'");
        row("values of elements by points",
            cubeHead + "ZONE I=2, J=2, K=2, F=POINT, VARLOCATION=([5]=CELLCENTERED)\n" + full, "packed by blocks");
        row("shared with a zone that is not there",
            cubeHead + "ZONE I=2, J=2, K=2, F=BLOCK, VARSHARELIST=([1-3]=1)\n" + full, "zone '1'");
        row("an element at no node",
            cubeHead +
                "ZONE N=4, E=1, F=FEPOINT, ET=TETRAHEDRON\n0 0 0 1 5\n1 0 0 2 5\n0 1 0 3 5\n0 0 1 4 5\n1 2 3 9\n",
            "node '9'");
        row("a grid alone", "FILETYPE = GRID\n" + cubeHead + zone + full, "'GRID'");
        row("no Tecplot at all", "Dear Sir, 12 13", "'Dear'");
    }
    void whatIsWrongIsTold()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, told);
        const std::string error = errorOf(text.toStdString());
        QVERIFY2(error.find(told.toStdString()) != std::string::npos, error.c_str());
    }

    void recordsBesideTheDataArePassedOver()
    {
        const auto file = readTecplot(
            "# made by hand\n" + cubeHead +
            "DATASETAUXDATA author=\"me\"\nTEXT X=1, Y=2, T=\"a text\"\nGEOMETRY T=LINE, F=POINT\n1\n2\n0 0\n1 1\n"
            "ZONE I=2, J=2, K=2, F=BLOCK, AUXDATA a=\"b\"\n" +
            cubeBlocks + "1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7 8\nTEXT X=1, T=\"the end\"\n");
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
        QCOMPARE(file->zones.size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(TecplotTextTest)
#include "tecplot_text_test.moc"
