// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM cases: an empty .foam, whole and decomposed ones, regions, patches and zones, polyhedra. The cells are unit
// cubes in a row along x, the value of each the x of its middle, at time 5 ten times as much; so the value of a point
// is its x, except at the two ends of the row.
#include "plugins/readers/vtk/foam_dimensions.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include <sys/stat.h>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

void writeText(const fs::path& path, const std::string& text)
{
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

std::string header(const std::string& kind, const std::string& object)
{
    return "FoamFile\n{\n version 2.0;\n format ascii;\n class " + kind + ";\n object " + object + ";\n}\n";
}

template <class One> std::string list(int count, const One& one)
{
    std::string text = std::to_string(count) + "\n(\n";
    for (int i = 0; i < count; ++i)
        text += one(i) + "\n";
    return text + ")\n";
}

std::string scalarField(int cells, int from, double factor)
{
    return header("volScalarField", "T") + "dimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar>\n" +
           list(cells, [&](int i) { return formatNumber(factor * (from + i + 0.5)); }) +
           ";\nboundaryField\n{\n walls\n {\n type zeroGradient;\n }\n}\n";
}

/// So many cubes beginning at x = from. The first face is between the cells, as OpenFOAM asks; a split cube has its
/// face at its end in two halves, so that it is no hexahedron.
void writeMesh(const fs::path& folder, int cells, int from, bool isSplit = false)
{
    const auto point = [](int x, int corner) { return 4 * x + corner; }; // corners of a square around the axis
    std::vector<std::vector<int>> faces;
    std::vector<int> owners, neighbours;
    for (int x = 1; x < cells; ++x) {
        faces.push_back({point(x, 0), point(x, 1), point(x, 2), point(x, 3)});
        owners.push_back(x - 1);
        neighbours.push_back(x);
    }
    const auto inner = faces.size();
    const auto outer = [&](std::vector<int> face, int owner) {
        faces.push_back(std::move(face));
        owners.push_back(owner);
    };
    outer({point(0, 3), point(0, 2), point(0, 1), point(0, 0)}, 0);
    if (isSplit) {
        outer({point(cells, 0), point(cells, 1), point(cells, 2)}, cells - 1);
        outer({point(cells, 0), point(cells, 2), point(cells, 3)}, cells - 1);
    } else {
        outer({point(cells, 0), point(cells, 1), point(cells, 2), point(cells, 3)}, cells - 1);
    }
    for (int x = 0; x < cells; ++x)
        for (int side = 0; side < 4; ++side)
            outer({point(x, side), point(x, (side + 1) % 4), point(x + 1, (side + 1) % 4), point(x + 1, side)}, x);
    const fs::path mesh = folder / "polyMesh";
    writeText(mesh / "points", header("vectorField", "points") + list(4 * (cells + 1), [&](int i) {
                                   const int corner = i % 4;
                                   return "(" + std::to_string(from + i / 4) +
                                          (corner == 1 || corner == 2 ? " 1" : " 0") + (corner >= 2 ? " 1)" : " 0)");
                               }));
    writeText(mesh / "faces", header("faceList", "faces") + list(int(faces.size()), [&](int i) {
                                  std::string text = std::to_string(faces[std::size_t(i)].size()) + "(";
                                  for (const int corner : faces[std::size_t(i)])
                                      text += std::to_string(corner) + " ";
                                  return text + ")";
                              }));
    const auto labels = [&](const char* name, const std::vector<int>& numbers) {
        writeText(mesh / name, header("labelList", name) + list(int(numbers.size()), [&](int i) {
                                   return std::to_string(numbers[std::size_t(i)]);
                               }));
    };
    labels("owner", owners);
    labels("neighbour", neighbours);
    writeText(mesh / "boundary", header("polyBoundaryMesh", "boundary") + "1\n(\nwalls\n{\n type wall;\n nFaces " +
                                     std::to_string(faces.size() - inner) + ";\n startFace " + std::to_string(inner) +
                                     ";\n}\n)\n");
}

void writeTimes(const fs::path& folder, int cells, int from, const std::vector<int>& times)
{
    for (const int time : times)
        writeText(folder / std::to_string(time) / "T", scalarField(cells, from, time == 0 ? 1 : 2. * time));
}

void writeControl(const fs::path& folder)
{
    writeText(folder / "system/controlDict",
              header("dictionary", "controlDict") +
                  "startTime 0;\nendTime 5;\ndeltaT 1;\nwriteControl timeStep;\nwriteInterval 1;\n");
}

/// Each point of the row from 0 to `end` has its x, times `factor`, and is there once; at the ends it is half a step
/// off.
void verifyRow(const Result<Dataset>& dataset, int end, double factor)
{
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QCOMPARE(dataset->pointCount(), std::uint64_t(4 * (end + 1)));
    for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
        const double x = dataset->position(point)[0];
        const double value = x == 0 ? 0.5 : x == end ? end - 0.5 : x;
        QCOMPARE(dataset->values.at(point), factor * value);
    }
}

} // namespace

class OpenFoamTest : public QObject {
    Q_OBJECT

private slots:
    /// By convention, case.foam is empty: its name alone says what it is.
    void emptyFilesAreRead()
    {
        const fs::path folder = newCase();
        writeControl(folder);
        writeMesh(folder / "constant", 3, 0);
        writeTimes(folder, 3, 0, {0, 5});
        writeText(folder / "constant/polyMesh/cellZones",
                  header("regIOobject", "cellZones") +
                      "1\n(\nrotor\n{\n type cellZone;\ncellLabels List<label>\n1\n(\n0\n)\n;\n}\n)\n");
        writeText(folder / "case.foam", "");
        QCOMPARE(builtVtkReader().score(folder / "case.foam", {}), 1.);
        verifyRow(builtVtkReader().read(folder / "case.foam", {}, {}), 3, 1);
        const auto later = builtVtkReader().read(folder / "case.foam", {{"time", std::int64_t(2)}}, {});
        verifyRow(later, 3, 10);
        QCOMPARE(takenOf(later->source.taken), QString("array: T; time step: 2 of 2, time 5; unit of the values: K"));
        QCOMPARE(
            leftOutOf(later->source.leftOut),
            QString(
                "The patches of its boundary are not read: walls. Its zones of cells are not distinguished: rotor."));
        const auto byControl = builtVtkReader().read(folder / "system/controlDict", {}, {});
        verifyRow(byControl, 3, 1);
        QCOMPARE(takenOf(byControl->source.taken),
                 QString("array: T; time step: 1 of 2, time 0 (a guess); unit of the values: K"));
        const auto contents = builtVtkReader().probe(folder / "case.foam", {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(takenOf(contents->taken), takenOf(byControl->source.taken));
        QCOMPARE(leftOutOf(contents->leftOut), leftOutOf(byControl->source.leftOut));
    }

    /// Powers of kg, m, s, K, mol, A and cd, of the field that is taken.
    void unitsAreThoseOfTheField()
    {
        const fs::path folder = newCase();
        writeControl(folder);
        writeMesh(folder / "constant", 3, 0);
        const QByteArray field = QByteArray::fromStdString(scalarField(3, 0, 1));
        const std::vector<std::pair<const char*, const char*>> fields = {{"[0 2 -2 0 0 0 0]", "m^2/s^2"},
                                                                         {"[1 -1 -2 0 0 0 0]", "kg/(m s^2)"},
                                                                         {"[0 0 -1 0 0]", "1/s"},
                                                                         {"[0 0.5 0 0 0 1 0]", "m^0.5 A"},
                                                                         {"[0 0 0 0 0 0 0]", ""},
                                                                         {"[m^2 s^-2]", "m^2 s^-2"},
                                                                         {"[0 2]", ""},
                                                                         {"", ""}};
        for (const auto& [dimensions, unit] : fields) {
            QByteArray text = field;
            text.replace("[0 0 0 1 0 0 0]", dimensions);
            QCOMPARE(foamUnit(text.toStdString()), std::string(unit));
        }
        writeText(folder / "0/T", scalarField(3, 0, 1));
        writeText(folder / "0/k", QByteArray(field)
                                      .replace("[0 0 0 1 0 0 0]", "[0 2 -2 0 0 0 0]")
                                      .replace("object T", "object k")
                                      .toStdString());
        writeText(folder / "case.foam", "");
        const auto energy = builtVtkReader().read(folder / "case.foam", {{"array", std::string("k")}}, {});
        verifyRow(energy, 3, 1);
        QCOMPARE(takenOf(energy->source.taken), QString("array: k; unit of the values: m^2/s^2"));
    }

    /// Points at which processors meet have the mean of all cells around, whoever they belong to.
    void decomposedCasesAreJoined()
    {
        const fs::path folder = newCase();
        writeControl(folder);
        for (const int processor : {0, 1}) {
            const fs::path part = folder / ("processor" + std::to_string(processor));
            writeMesh(part / "constant", 2, 2 * processor);
            writeTimes(part, 2, 2 * processor, {0, 5});
        }
        writeText(folder / "case.foam", "");
        const auto alone = builtVtkReader().read(folder / "case.foam", {{"time", std::int64_t(2)}}, {});
        verifyRow(alone, 4, 10);
        QCOMPARE(
            takenOf(alone->source.taken),
            QString("array: T; block: the folders of 2 processors; time step: 2 of 2, time 5; unit of the values: K"));

        // A mesh and a first time beside them, as where nothing was put together after the run.
        writeMesh(folder / "constant", 4, 0);
        writeTimes(folder, 4, 0, {0});
        const auto run = builtVtkReader().read(folder / "case.foam", {{"time", std::int64_t(2)}}, {});
        verifyRow(run, 4, 10);
        QVERIFY2(leftOutOf(run->source.leftOut).contains("Its case as a whole is not read"),
                 qPrintable(leftOutOf(run->source.leftOut)));
        writeTimes(folder, 4, 0, {5});
        const auto whole = builtVtkReader().read(folder / "case.foam", {{"time", std::int64_t(2)}}, {});
        verifyRow(whole, 4, 10);
        QVERIFY2(leftOutOf(whole->source.leftOut).contains("The folders of its 2 processors are not read"),
                 qPrintable(leftOutOf(whole->source.leftOut)));
    }

    /// VTK rounds them to single precision; they are those of the files all the same, of one folder or of processors,
    /// and where the mesh moves those of the time.
    void placesAreThoseOfTheFile()
    {
        const fs::path folder = newCase();
        writeControl(folder);
        const auto movePoints = [](const fs::path& mesh, int points, double from) {
            writeText(mesh / "polyMesh/points", header("vectorField", "points") + list(points, [&](int i) {
                                                    const int corner = i % 4;
                                                    return "(" + formatNumber(from + 0.1 * (i / 4)) +
                                                           (corner == 1 || corner == 2 ? " 0.7" : " 0.3") +
                                                           (corner >= 2 ? " 1.1)" : " 0.9)");
                                                }));
        };
        const auto verifyPlaces = [](const Result<Dataset>& dataset, double from) {
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->pointCount(), std::uint64_t(16));
            for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
                const Eigen::Vector3d place = dataset->position(point);
                const double x = from + 0.1 * std::round((place[0] - from) / 0.1);
                QVERIFY(std::abs(place[0] - x) < 1e-12 * from);
                QVERIFY(place[1] == 0.3 || place[1] == 0.7);
                QVERIFY(place[2] == 0.9 || place[2] == 1.1);
            }
            QVERIFY(!leftOutOf(dataset->source.leftOut).contains("single precision"));
        };
        writeMesh(folder / "constant", 3, 0);
        writeTimes(folder, 3, 0, {0, 5});
        movePoints(folder / "constant", 16, 1000.1);
        movePoints(folder / "5", 16, 1000.4);
        writeText(folder / "case.foam", "");
        verifyPlaces(builtVtkReader().read(folder / "case.foam", {}, {}), 1000.1);
        verifyPlaces(builtVtkReader().read(folder / "case.foam", {{"time", std::int64_t(2)}}, {}), 1000.4);

        const fs::path parts = newCase();
        writeControl(parts);
        for (const int processor : {0, 1}) {
            const fs::path part = parts / ("processor" + std::to_string(processor));
            writeMesh(part / "constant", 1 + processor, processor);
            movePoints(part / "constant", 8 + 4 * processor, 1000.1 + 0.1 * processor);
            writeTimes(part, 1 + processor, processor, {0});
        }
        writeText(parts / "case.foam", "");
        verifyPlaces(builtVtkReader().read(parts / "case.foam", {}, {}), 1000.1);
    }

    void regionsHaveNames()
    {
        const fs::path folder = newCase();
        writeControl(folder);
        int from = 0;
        for (const char* region : {"air", "solid"}) {
            writeMesh(folder / "constant" / region, 2, from);
            writeText(folder / "0" / region / "T", scalarField(2, from, 1));
            from += 2;
        }
        writeText(folder / "case.foam", "");
        verifyRow(builtVtkReader().read(folder / "case.foam", {}, {}), 4, 1);
        const auto one = builtVtkReader().read(folder / "case.foam", {{"part", std::string("air/internalMesh")}}, {});
        verifyRow(one, 2, 1);
        QCOMPARE(takenOf(one->source.taken), QString("array: T; block: air/internalMesh; unit of the values: K"));
        QVERIFY2(leftOutOf(one->source.leftOut).startsWith("1 other part is not read: solid/internalMesh."),
                 qPrintable(leftOutOf(one->source.leftOut)));
    }

    /// The faces of a polyhedron, each with the number of its points before it.
    void polyhedraKeepTheirFaces()
    {
        const fs::path folder = newCase();
        writeControl(folder);
        writeMesh(folder / "constant", 2, 0, true);
        writeTimes(folder, 2, 0, {0});
        writeText(folder / "case.foam", "");
        const auto answer = foundByHelper(VtkFormat::OpenFoam, folder / "case.foam");
        QVERIFY2(answer.ok(), answer.ok() ? "" : answer.error().text().c_str());
        const FileFindings& found = *answer;
        QVERIFY((found.shapes == std::vector{CellShape::Hexahedron, CellShape::Polyhedron}));
        std::vector<std::size_t> faces;
        for (auto at = found.offsets[1]; at < found.offsets[2]; at += found.corners[at] + 1) {
            faces.push_back(found.corners[at]);
            for (auto corner = at + 1; corner <= at + found.corners[at]; ++corner)
                QVERIFY(found.positions[found.corners[corner]][0] >= 1); // the second cell
        }
        std::ranges::sort(faces);
        QCOMPARE(faces, (std::vector<std::size_t>{3, 3, 4, 4, 4, 4, 4}));
    }

    void whatIsMissingIsTold()
    {
        const fs::path folder = newCase();
        writeText(folder / "case.foam", "");
        const auto nothing = builtVtkReader().read(folder / "case.foam", {}, {});
        QVERIFY(!nothing.ok());
        QVERIFY2(nothing.error().text().find("there is no 'constant/polyMesh'") != std::string::npos,
                 nothing.error().text().c_str());
        writeText(folder / "processors4/constant/polyMesh/points", "");
        const auto collated = builtVtkReader().read(folder / "case.foam", {}, {});
        QVERIFY(!collated.ok());
        QVERIFY2(collated.error().text().find("Run reconstructPar") != std::string::npos,
                 collated.error().text().c_str());
    }

    /// What waits, does not end or leads out of the case is refused before VTK opens it; what lies in the case is read.
    void onlyFilesOfTheCaseAreOpened_data()
    {
        QTest::addColumn<QString>("include");
        QTest::addColumn<QString>("told");
        QTest::newRow("none") << QString() << QString();
        QTest::newRow("of the case") << "#include \"../constant/more\"\n" << QString();
        QTest::newRow("of the case, by its variable") << "#include \"$FOAM_CASE/constant/more\"\n" << QString();
        QTest::newRow("in a comment") << "// #include \"/etc/passwd\"\n" << QString();
        QTest::newRow("above") << "#include \"../../more\"\n"
                               << "is not in its folder";
        QTest::newRow("above, if it is there") << "#includeIfPresent \"../../more\"\n"
                                               << "is not in its folder";
        QTest::newRow("behind a comment") << "#include /* \"no\" */ \"../../more\"\n"
                                          << "is not in its folder";
        QTest::newRow("in somebody's folder") << "#include \"$HOME/more\"\n"
                                              << "is not in its folder";
        QTest::newRow("a device") << "#include \"/dev/zero\"\n"
                                  << "is not in its folder";
        QTest::newRow("a pipe") << "pipe"
                                << "not a regular file";
    }
    void onlyFilesOfTheCaseAreOpened()
    {
        QFETCH(QString, include);
        QFETCH(QString, told);
        const fs::path folder = newCase();
        writeText(folder / "case.foam", "");
        writeText(folder / "constant/more", "more 1;\n");
        writeText(folder / "system/controlDict", "#include \"$FOAM_ETC/controls\"\n"); // which VTK does not open
        writeMesh(folder / "constant", 2, 0);
        const bool isPipe = include == "pipe";
        writeText(folder / "0/T", (isPipe ? std::string() : include.toStdString()) + scalarField(2, 0, 1));
        if (isPipe)
            QCOMPARE(::mkfifo((folder / "0/p").c_str(), 0600), 0);
        const auto dataset = builtVtkReader().read(folder / "case.foam", {}, {});
        if (!told.isEmpty()) {
            QVERIFY(!dataset.ok());
            QVERIFY2(QString::fromStdString(dataset.error().text()).contains(told), dataset.error().text().c_str());
        } else if (!dataset.ok()) { // what it includes, VTK may refuse; that lies in the case
            QVERIFY2(dataset.error().text().find("is not in its folder") == std::string::npos,
                     dataset.error().text().c_str());
        }
    }

private:
    fs::path newCase() { return folder_.path() / ("case" + std::to_string(++cases_)); }

    VtkFolder folder_;
    int cases_ = 0;
};

QTEST_GUILESS_MAIN(OpenFoamTest)
#include "openfoam_test.moc"
