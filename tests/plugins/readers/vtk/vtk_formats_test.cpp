// SPDX-License-Identifier: GPL-3.0-or-later
// Which files are VTK's, and what is said where VTK is missing (S6). Needs no VTK.
#include "plugins/readers/cells/cells_reader.h"
#include "plugins/readers/vtk/vtk_format.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

#include <map>
#include <set>
#include <span>

using namespace tetra;

namespace {

VtkGuess guess(const QByteArray& name, const QByteArray& start)
{
    return guessVtkFormat(name.toStdString(), std::as_bytes(std::span(start.constData(), std::size_t(start.size()))));
}

} // namespace

class VtkFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void formatsAreKnownByNameAndSignature()
    {
        QVERIFY(guess("a.bin", vtiText()).format == VtkFormat::Xml);
        QVERIFY(guess("a.dat", legacyText()).format == VtkFormat::Legacy);
        QVERIFY(guess("a.ex2", "CDF\1").format == VtkFormat::None); // of another reader
        for (const char* start :
             {"TITLE = \"a\"\nVARIABLES = \"X\"", "# by hand\n\nVariables=X, Y\nZONE", "TITLE=\"\"\r\nvariables = X"})
            QVERIFY2(guess("flow.dat", start).format == VtkFormat::Tecplot, start);
        for (const char* start :
             {"TITLE,VARIABLES\n1,2", "variables x y z\n", "TITLE = a poem\n", "\"TITLE = \" VARIABLES"})
            QVERIFY2(guess("flow.dat", start).format == VtkFormat::None, start);
        QVERIFY(guess("a.vti", "whatever").format == VtkFormat::Xml);
        QVERIFY(guess("a.pvtu", "<VTKFile type=\"PUnstructuredGrid\">").format == VtkFormat::Xml);
        QVERIFY(guess("a.vtu", "<VTKFile type=\"ImageData\">").format == VtkFormat::Xml);
        QVERIFY(guess("a.xml", "<VTKFile type='Collection' version='0.1'>").format == VtkFormat::Series);
        QVERIFY(guess("a.vtu.series", "\n{ \"file-series-version\" : \"1.0\"").format == VtkFormat::Series);
        QVERIFY(guess("a.vtk.series", "{}").format == VtkFormat::Series);
        QVERIFY(guess("a.json", "{\"x\": 1}").format == VtkFormat::None);
        const QByteArray hdf5("\x89HDF\r\n\x1a\n", 8);
        QVERIFY(guess("a.h5", hdf5 + "VTKHDF").format == VtkFormat::Hdf);
        QVERIFY(guess("a.h5", hdf5 + "fields").format == VtkFormat::None);
        for (const char* name : {"a.nrrd", "a.mha", "a.mhd", "a.nii", "a.nii.gz", "a.map"})
            QVERIFY2(guess(name, "NRRD0004").format == VtkFormat::None, name);
        QVERIFY(guess("a.csv", "x,y,z,v").format == VtkFormat::None);
        QVERIFY(guess("vtk", "x").format == VtkFormat::None);
    }

    /// Other readers' files are left to them.
    void scoresLeaveRoom()
    {
        QCOMPARE(guess("a.vti", vtiText()).score, 0.9);
        for (const QByteArray& text :
             {vtuText(), QByteArray("whatever"), QByteArray("<VTKFile type='UnstructuredGrid'")})
            QCOMPARE(guess("a.vtu", text).score, 0.);
        for (const char* compressor : {"vtkLZ4DataCompressor", "vtkLZMADataCompressor"}) { // only VTK unpacks these
            const QByteArray text =
                with(vtuText(), "<VTKFile", QByteArray("<VTKFile compressor=\"") + compressor + '"');
            const std::span first = std::as_bytes(std::span(text.constData(), std::size_t(text.size())));
            QVERIFY(guess("a.vtu", text).format == VtkFormat::Xml);
            QVERIFY(CellsReader().score("a.vtu", first) < guess("a.vtu", text).score / 2);
        }
        QCOMPARE(guess("a.g", "PLOT3D?").score, 0.);
        QCOMPARE(guess("a.xyz", "3 4 5\n0.1 0.2\n").score, 0.);
        QCOMPARE(guess("a.nrrd", "NRRD0004").score, 0.);
    }

    /// A name alone is no reason to take an empty file, but by OpenFOAM's convention: the program says that it is
    /// empty.
    void onlyOpenFoamIsCertainOfEmptyFiles()
    {
        const VtkFolder folder;
        const VtkReader withoutHelper(folder.path() / "tan-read-vtk");
        for (const Reader* reader : {static_cast<const Reader*>(&withoutHelper), &builtVtkReader()}) {
            QCOMPARE(reader->score("case.foam", {}), 1.);
            for (const char* name : {"a.vti", "a.vtk", "a.case", "a.tec", "a.pvd", "a.e", "empty"})
                QVERIFY2(reader->score(name, {}) < 1, name);
        }
    }

    void filtersNameTheFormats()
    {
        const std::map<QString, VtkFormat> expected{{"VTK XML", VtkFormat::Xml},
                                                    {"VTK legacy", VtkFormat::Legacy},
                                                    {"VTK HDF", VtkFormat::Hdf},
                                                    {"EnSight", VtkFormat::EnSight},
                                                    {"CGNS", VtkFormat::Cgns},
                                                    {"GAMBIT", VtkFormat::Gambit},
                                                    {"Fluent", VtkFormat::Fluent},
                                                    {"OpenFOAM", VtkFormat::OpenFoam},
                                                    {"Tecplot text", VtkFormat::Tecplot},
                                                    {"Lists of VTK files", VtkFormat::Series}};
        std::set<QString> found, patterns;
        for (const std::string& text : VtkReader().nameFilters()) {
            const QString filter = QString::fromStdString(text), name = filter.section(" (", 0, 0);
            QVERIFY2(filter.endsWith(')') && filter.count('(') == 1, text.c_str());
            QVERIFY2(expected.contains(name) && found.insert(name).second, text.c_str());
            // Each file that the dialog shows under this name is taken for that.
            for (QString pattern : filter.section('(', 1).chopped(1).split(' ')) {
                QVERIFY2(pattern.startsWith("*.") || pattern == "controlDict", text.c_str());
                QVERIFY2(patterns.insert(pattern).second, text.c_str()); // of one format only
                const VtkGuess byName = guess(pattern.replace('*', "Data.of.1").toUtf8(), "");
                QVERIFY2(byName.format == expected.at(name) && byName.score > 0, qPrintable(pattern));
            }
        }
        QCOMPARE(found.size(), expected.size());
        for (const char* pattern : {"*.vti", "*.vtk", "*.tec", "*.cgns", "*.case"})
            QVERIFY2(patterns.contains(pattern), pattern);
    }

    /// The program works without VTK, and says what to install.
    void withoutTheHelperItSaysWhatToInstall()
    {
        const VtkFolder folder;
        const VtkReader reader(folder.path() / "tan-read-vtk");
        const QByteArray text = vtiText();
        const double score =
            reader.score("a.vti", std::as_bytes(std::span(text.constData(), std::size_t(text.size()))));
        QVERIFY(score > 0 && score < 0.5); // a reader that reads the file comes first
        const auto dataset = reader.read(folder.write("a.vti", vtiText()), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("apt install ./tan-vtk-readers") != std::string::npos,
                 dataset.error().text().c_str());
        QVERIFY2(dataset.error().text().find("The VTK readers are not installed") != std::string::npos,
                 dataset.error().text().c_str());
    }

    /// Of a file that another reader reads, if the user chose this one.
    void filesOfOthersAreToldAsThat()
    {
        const VtkFolder folder;
        const auto dataset = builtVtkReader().read(folder.write("a.vtu", vtuText()), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("Let TAn choose the reader") != std::string::npos,
                 dataset.error().text().c_str());
    }

    void aWrongComponentIsAMistake()
    {
        for (const Parameter& parameter : VtkReader().parameters())
            if (parameter.id == "component") {
                QVERIFY(parameter.mistake("magnitude").empty());
                QVERIFY(parameter.mistake("2").empty());
                QVERIFY(!parameter.mistake("x").empty());
                return;
            }
        QFAIL("there is no parameter 'component'");
    }
};

QTEST_GUILESS_MAIN(VtkFormatsTest)
#include "vtk_formats_test.moc"
