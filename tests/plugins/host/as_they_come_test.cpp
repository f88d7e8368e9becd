// SPDX-License-Identifier: GPL-3.0-or-later
/// Data as they come (C10), in every reader: what is blanked out or no finite number becomes a hole, points without a
/// value are left out, and each file opens packed by gzip, too, with the other file that it needs.
#include "plugins/host/dataset_opening.h"
#include "plugins/host/packed_file.h"
#include "tests/plugins/host/gzipped.h"
#include "tests/plugins/readers/plot3d/plot3d_files.h"

#include <tan/build.h>
#include <tan/model.h>
#include <tan/verify.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <sys/resource.h>

using namespace tetra;

namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, QByteArray>;
using Order = QList<QByteArray>;

constexpr int side = 4, points = side * side * side;

/// Of a lattice of 4 x 4 x 4 points; the first one has none.
QByteArray floats()
{
    std::vector<float> values(points);
    for (int point = 0; point < points; ++point)
        values[static_cast<std::size_t>(point)] = point == 0 ? std::numeric_limits<float>::quiet_NaN() : float(point);
    return {reinterpret_cast<const char*>(values.data()), points * qsizetype(sizeof(float))};
}

QByteArray numbers(int count, const QByteArray& first)
{
    QByteArray text = first;
    for (int n = 1; n < count; ++n)
        text += " " + QByteArray::number(n);
    return text;
}

QByteArray places()
{
    QByteArray text;
    for (int point = 0; point < points; ++point)
        text += QByteArray::number(point % side + .1 * (point / side % side)) + " " +
                QByteArray::number(point / side % side) + " " + QByteArray::number(point / side / side) + "\n";
    return text;
}

QByteArray array(const QByteArray& attributes, const QByteArray& values)
{
    return "<DataArray " + attributes + " format=\"ascii\">" + values + "</DataArray>\n";
}

QByteArray vtk(const QByteArray& type, const QByteArray& attributes, const QByteArray& piece, const QByteArray& content)
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"LittleEndian\"><" +
           type + attributes + "><Piece " + piece + ">\n" + content + "</Piece></" + type + "></VTKFile>\n";
}

const QByteArray extent = "\"0 3 0 3 0 3\"";
const QByteArray values = R"(type="Float32" Name="value")";

QByteArray pointValues(const QByteArray& first)
{
    return "<PointData Scalars=\"value\">" + array(values, numbers(points, first));
}

QByteArray positions()
{
    return "<Points>" + array(R"(type="Float32" NumberOfComponents="3")", places()) + "</Points>\n";
}

/// Two tetrahedra, of which the second alone has point 4.
QByteArray twoTetrahedra(const QByteArray& ofPoints)
{
    return vtk("UnstructuredGrid", "", R"(NumberOfPoints="5" NumberOfCells="2")",
               "<PointData Scalars=\"value\">" + array(values, ofPoints) + "</PointData><Points>" +
                   array(R"(type="Float32" NumberOfComponents="3")", "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1") +
                   "</Points><Cells>" + array(R"(type="Int32" Name="connectivity")", "0 1 2 3 4 1 3 2") +
                   array(R"(type="Int32" Name="offsets")", "4 8") + array(R"(type="UInt8" Name="types")", "10 10") +
                   "</Cells>");
}

const QByteArray nrrd = "NRRD0004\ntype: float\ndimension: 3\nsizes: 4 4 4\nencoding: raw\nendian: little\n";

QByteArray detached(const QByteArray& encoding, const QByteArray& data)
{
    return QByteArray(nrrd).replace("raw", encoding) + "data file: " + data + "\n";
}

/// One point of a grid of PLOT3D, the first, is blanked out.
std::int32_t firstBlanked(int n)
{
    return n == 0 ? 0 : 1;
}

} // namespace

class AsTheyComeTest : public QObject {
    Q_OBJECT

private:
    fs::path path(const std::string& name) const { return fs::path(folder_->path().toStdString()) / name; }
    fs::path write(const std::string& name, const QByteArray& bytes) const
    {
        QFile file(QString::fromStdString(path(name).string()));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write a test file");
        return path(name);
    }

    std::unique_ptr<PluginHost> host_ = PluginHost::standard();
    std::unique_ptr<QTemporaryDir> folder_;

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void everyReaderOpensThem_data();
    void everyReaderOpensThem();
    void modelsOfThemAreVerifiedAgainstTheFile();
    void partsAreOfTheGrid();
    void whatCannotFitIsRefused();
    void aDamagedCompanionIsTold();
};

void AsTheyComeTest::everyReaderOpensThem_data()
{
    QTest::addColumn<Files>("files"); // the first by name is opened
    QTest::addColumn<ParameterValues>("parameters");
    QTest::addColumn<bool>("irregular");
    QTest::addColumn<int>("left");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* name, const Files& files, int left, const char* told,
                        const ParameterValues& parameters = {}, bool irregular = true) {
        QTest::newRow(name) << files << parameters << irregular << left << QString(told);
    };
    const char* const holes = "has become an irregular mesh with holes";
    row("NRRD", {{"a.nrrd", nrrd + "\n" + floats()}}, points - 1, holes);
    row("NRRD, detached", {{"a.nhdr", detached("raw", "b.raw")}, {"b.raw", floats()}}, points - 1, holes);
    row("NRRD, text", {{"a.nrrd", QByteArray(nrrd).replace("raw", "text") + "\n" + numbers(points, "-inf")}},
        points - 1, holes);
    row("raw", {{"a_4x4x4_float32.raw", floats()}}, points - 1, holes,
        {{"size", std::string("4x4x4")}, {"type", std::string("float")}});
    const Plot3dStyle binary{.iblank = true};
    row("PLOT3D, binary", {{"a.xyz", testFile(binary, false, firstBlanked)}, {"a.q", testFile(binary, true)}},
        3 * 4 * 5 - 1, holes);
    row("PLOT3D, text", {{"a.xyz", testText(binary, false, firstBlanked)}, {"a.q", testText(binary, true)}},
        3 * 4 * 5 - 1, holes);
    QByteArray solution = testFile({}, true);
    constexpr qsizetype firstDensity = 3 * 4 + 4 * 4; // behind the size and the state
    solution.replace(firstDensity, 4, "\xff\xff\xff\x7f");
    row("PLOT3D, NaN", {{"a.xyz", testFile({}, false)}, {"a.q", solution}}, 3 * 4 * 5 - 1, holes);
    row("VTK unstructured grid", {{"a.vtu", twoTetrahedra("1 2 3 4 nan")}}, 4, "became a hole");
    row("UCD",
        {{"a.inp", "5 2 1 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n1 1 tet 1 2 3 4\n2 1 tet 5 2 4 3\n"
                   "1 1\nvalue, K\n1 1\n2 2\n3 3\n4 4\n5 nan\n"}},
        4, "became a hole");
    row("table", {{"a.csv", "x,y,z,v\n0,0,0,1\n1,0,0,2\n0,1,0,3\n0,0,1,inf\n"}}, 3, "without a finite value", {},
        false);
    if (!fs::exists(fs::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-vtk"))
        return;
    row("VTK image",
        {{"a.vti", vtk("ImageData", " WholeExtent=" + extent + " Origin=\"0 0 0\" Spacing=\"1 1 1\"",
                       "Extent=" + extent, pointValues("nan") + "</PointData>")}},
        points - 1, holes);
    row("VTK image, cells",
        {{"a.vti", vtk("ImageData", " WholeExtent=" + extent + " Origin=\"0 0 0\" Spacing=\"1 1 1\"",
                       "Extent=" + extent, "<CellData>" + array(values, numbers(27, "nan")) + "</CellData>")}},
        points - 1, holes);
    row("VTK structured grid, blanked",
        {{"a.vts", vtk("StructuredGrid", " WholeExtent=" + extent, "Extent=" + extent,
                       pointValues("0") +
                           array(R"(type="UInt8" Name="vtkGhostType")", "2" + QByteArray(" 0").repeated(points - 1)) +
                           "</PointData>" + positions())}},
        points - 1, holes);
    QByteArray bigEndian = floats();
    for (qsizetype place = 0; place < bigEndian.size(); place += 4)
        std::reverse(bigEndian.begin() + place, bigEndian.begin() + place + 4);
    row("VTK legacy",
        {{"a.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 4 4\nORIGIN 0 0 0\n"
                   "SPACING 1 1 1\nPOINT_DATA 64\nSCALARS v float 1\nLOOKUP_TABLE default\n" +
                       bigEndian + "\n"}},
        points - 1, holes);
    row("VTK points",
        {{"a.vtp", vtk("PolyData", "", R"(NumberOfPoints="64" NumberOfVerts="0")",
                       pointValues("nan") + "</PointData>" + positions())}},
        points - 1, "without a finite value", {}, false);
}

/// Plain, packed, and where it needs another file with only that packed.
void AsTheyComeTest::everyReaderOpensThem()
{
    QFETCH(Files, files);
    QFETCH(ParameterValues, parameters);
    QFETCH(bool, irregular);
    QFETCH(int, left);
    QFETCH(QString, told);
    ImportOptions options;
    options.values = parameters;
    const std::string name = files.contains("a.xyz") ? "a.xyz" : files.begin()->first;
    for (const auto& [file, bytes] : files)
        write(file, bytes);
    const auto plain = openDataset(*host_, path(name), options);
    QVERIFY2(plain, plain ? "" : plain.error().text().c_str());
    QCOMPARE(plain->domain == DomainClass::Irregular, irregular);
    QCOMPARE(plain->pointCount(), std::uint64_t(left));
    QCOMPARE(plain->values.notFiniteCount(), std::uint64_t(0));
    QVERIFY(!hasHoles(*plain));
    QVERIFY(std::ranges::any_of(
        plain->remarks, [&](const Message& remark) { return QString::fromStdString(remark.text()).contains(told); }));

    for (const bool onlyOther : {false, true}) {
        if (onlyOther && files.size() == 1)
            continue;
        folder_ = std::make_unique<QTemporaryDir>();
        for (const auto& [file, bytes] : files)
            if (onlyOther && file == name)
                write(file, bytes);
            else
                write(file + ".gz", gzipped(bytes));
        const fs::path opened = path(onlyOther ? name : name + ".gz");
        const auto packed = openDataset(*host_, opened, options);
        QVERIFY2(packed, packed ? "" : packed.error().text().c_str());
        QCOMPARE(packed->source.hash, plain->source.hash);
        QCOMPARE(packed->source.name, plain->source.name);
        QCOMPARE(packed->source.path, opened);
        QVERIFY(probeDataset(*host_, opened, options));
        for (const auto& [file, bytes] : files)
            if (QFile::remove(QString::fromStdString(path(file + ".gz").string())) && file != name)
                write(file, bytes); // the other one need not be packed, too
        if (onlyOther)
            continue;
        write(name + ".gz", gzipped(files.at(name)));
        const auto mixed = openDataset(*host_, opened, options);
        QVERIFY2(mixed, mixed ? "" : mixed.error().text().c_str());
        QCOMPARE(mixed->source.hash, plain->source.hash);
    }
}

void AsTheyComeTest::modelsOfThemAreVerifiedAgainstTheFile()
{
    const fs::path file = write("a.nrrd.gz", gzipped(nrrd + "\n" + floats()));
    const auto dataset = openDataset(*host_, file);
    QVERIFY2(dataset, dataset ? "" : dataset.error().text().c_str());
    const auto report = buildModel(*dataset, path("a.tan"));
    QVERIFY2(report, report ? "" : report.error().text().c_str());
    const auto model = Model::open(path("a.tan"));
    const auto again = openDataset(*host_, file);
    QVERIFY(model && again);
    const auto checked = verify(**model, *again, {{.error = 0}});
    QVERIFY(checked && checked->ok());
}

/// Regions and strides are those of the grid, so that a large one can be made small enough.
void AsTheyComeTest::partsAreOfTheGrid()
{
    const fs::path file = write("a.nrrd", nrrd + "\n" + floats());
    ImportOptions options;
    options.part.region = Eigen::AlignedBox3d(Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(3, 3, 3));
    const auto whole = openDataset(*host_, file, options);
    QVERIFY2(whole, whole ? "" : whole.error().text().c_str());
    QCOMPARE(whole->domain, DomainClass::RegularLattice); // the hole lies outside
    options.part = {.region = {}, .stride = {3, 1, 1}};
    const auto coarse = openDataset(*host_, file, options);
    QVERIFY2(coarse, coarse ? "" : coarse.error().text().c_str());
    QCOMPARE(coarse->domain, DomainClass::Irregular);
    QCOMPARE(coarse->pointCount(), std::uint64_t(2 * 4 * 4 - 2)); // of the cell with the first row no more is left

    write("g.q", testFile({}, true));
    const fs::path grid = write("g.xyz", testFile({.iblank = true}, false, firstBlanked));
    options.part = {.region = {}, .stride = {2, 1, 1}};
    const auto blanked = openDataset(*host_, grid, options);
    QVERIFY2(blanked, blanked ? "" : blanked.error().text().c_str());
    QCOMPARE(blanked->pointCount(), std::uint64_t(2 * 4 * 5 - 2)); // the cell with both ends of the first row is a hole
    options.part = {.region = Eigen::AlignedBox3d(Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(2, 3, 4)),
                    .stride = {1, 1, 1}};
    const auto beside = openDataset(*host_, grid, options);
    QVERIFY2(beside, beside ? "" : beside.error().text().c_str());
    QCOMPARE(beside->domain, DomainClass::Curvilinear);
}

/// Told before the memory is taken.
void AsTheyComeTest::whatCannotFitIsRefused()
{
    constexpr std::uint32_t size = 64;
    Dataset grid{.lattice = {.size = {size, size, size}}, .values = {}, .source = {}};
    grid.values = ScalarField::of(std::vector<std::uint8_t>(grid.lattice.pointCount(), 1));
    QVERIFY(!hasHoles(grid));
    std::vector<GridCell> cells(grid.lattice.cellCount(), GridCell::Kept);
    cells[5] = GridCell::Blanked;
    grid.cells = std::make_shared<const std::vector<GridCell>>(std::move(cells));
    rlimit before{};
    QCOMPARE(::getrlimit(RLIMIT_AS, &before), 0);
    const rlimit little{200'000'000, before.rlim_max};
    ::setrlimit(RLIMIT_AS, &little);
    const auto refused = withHoles(grid);
    ::setrlimit(RLIMIT_AS, &before);
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
    QVERIFY2(refused.error().text().find("every n-th point") != std::string::npos, refused.error().text().c_str());
}

void AsTheyComeTest::aDamagedCompanionIsTold()
{
    write("a.xyz", testFile({}, false));
    write("a.q.gz", gzipped(testFile({}, true)).chopped(20));
    const auto read = openDataset(*host_, path("a.xyz"));
    QVERIFY(!read);
    QCOMPARE(read.error().kind, ErrorKind::BadInput);
    QVERIFY2(read.error().text().find("a.q.gz'") != std::string::npos &&
                 read.error().text().find("damaged or cut short") != std::string::npos,
             read.error().text().c_str());
}

QTEST_GUILESS_MAIN(AsTheyComeTest)
#include "as_they_come_test.moc"
