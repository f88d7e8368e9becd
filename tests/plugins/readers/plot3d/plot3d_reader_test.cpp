// SPDX-License-Identifier: GPL-3.0-or-later
// PLOT3D files of every binary kind are read (R1), what is no volume is refused with a text that helps (S6, S20), and
// damaged files are read or refused, never anything else.
#include "plugins/host/file_saving.h"
#include "plugins/readers/plot3d/plot3d_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/plugins_of_this_build.h"
#include "tests/plugins/readers/plot3d/plot3d_files.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <random>

using namespace tetra;

namespace {

double expectedArray(const std::string& name, int n)
{
    const double density = testQuantity(0, n);
    double square = 0;
    for (int axis = 1; axis <= 3; ++axis)
        square += testQuantity(axis, n) * testQuantity(axis, n);
    const double pressure = 0.4 * (testQuantity(4, n) - square / density / 2);
    if (name == "density")
        return density;
    if (name == "energy")
        return testQuantity(4, n);
    if (name == "momentum_y")
        return testQuantity(2, n);
    if (name == "velocity_magnitude")
        return std::sqrt(square) / density;
    if (name == "pressure")
        return pressure;
    if (name == "temperature")
        return pressure / density;
    return std::sqrt(square) / density / std::sqrt(1.4 * pressure / density); // mach
}

} // namespace

class Plot3dReaderTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }
    void everyKindIsRead_data();
    void everyKindIsRead();
    void arraysFollowFromTheSolution_data();
    void arraysFollowFromTheSolution();
    void theSolutionIsFoundByItsName_data();
    void theSolutionIsFoundByItsName();
    void aGridOfSeveralIsChosen();
    void severalGridsAreJoined();
    void gridsThatOverlapAreRefused();
    void probesWithoutTheData();
    void constantArraysAreNotTaken();
    void arraysWithoutANumberAreToldAsThat();
    void aCutGridIsToldAsThat_data();
    void aCutGridIsToldAsThat();
    void zerosBehindTheDataAreBorne();
    void blankedPointsAreHoles();
    void mutationsAreReadOrRefused();
    void otherFilesAreLeftToOthers();
    void whatIsWrittenComesBack();
    void cancels();

private:
    std::filesystem::path write(const std::string& name, const QByteArray& content) const
    {
        const std::filesystem::path path = folder_->path().toStdString() + "/" + name;
        std::ofstream(path, std::ios::binary | std::ios::trunc).write(content.data(), content.size());
        return path;
    }
    std::filesystem::path writePair(const Plot3dStyle& style) const
    {
        write("g.q", testFile(style, true));
        return write("g.xyz", testFile(style, false));
    }
    static Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values = {})
    {
        return complete(asLoaded<Plot3dReader>().read(path, values, {}));
    }
    static double scoreOf(const std::filesystem::path& path, const QByteArray& content)
    {
        const QByteArray first = content.left(4096);
        return asLoaded<Plot3dReader>().score(
            path, std::as_bytes(std::span(first.data(), static_cast<std::size_t>(first.size()))));
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

void Plot3dReaderTest::everyKindIsRead_data()
{
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind < 32; ++kind)
        QTest::addRow("%s%s%s%s%s", kind & 1 ? "big " : "little ", kind & 2 ? "marks " : "", kind & 4 ? "multi " : "",
                      kind & 8 ? "double " : "single ", kind & 16 ? "iblank" : "")
            << kind;
}

void Plot3dReaderTest::everyKindIsRead()
{
    QFETCH(int, kind);
    const Plot3dStyle style{.order = kind & 1 ? std::endian::big : std::endian::little,
                            .marks = (kind & 2) != 0,
                            .multiGrid = (kind & 4) != 0,
                            .doubles = (kind & 8) != 0,
                            .iblank = (kind & 16) != 0};
    const auto path = writePair(style);
    QVERIFY(scoreOf(path, testFile(style, false)) > 0.5);
    const auto dataset = read(path);
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QCOMPARE(dataset->domain, DomainClass::Curvilinear);
    QCOMPARE(dataset->lattice.size, (std::array<std::uint32_t, 3>{3, 4, 5}));
    QCOMPARE(dataset->values.type(), style.doubles ? SampleType::Float64 : SampleType::Float32);
    QCOMPARE(dataset->source.hash, contentHash(dataset->values, dataset->positions));
    QCOMPARE(QString::fromStdString(dataset->source.name), QString("g.xyz, density"));
    QCOMPARE(dataset->source.leftOut.size(), std::size_t(1));
    QCOMPARE(
        dataset->source.leftOut[0].text(),
        std::string(
            "The solution states: Mach number 0, angle of attack 1, Reynolds number 2, time 3. They are not used."));
    for (int n = 0; n < 60; ++n) {
        const auto point = static_cast<std::uint64_t>(n);
        QCOMPARE(dataset->position(point),
                 Eigen::Vector3d(testCoordinate(0, n, 0), testCoordinate(1, n, 0), testCoordinate(2, n, 0)));
        QCOMPARE(dataset->values.at(point), testQuantity(0, n));
    }
}

void Plot3dReaderTest::arraysFollowFromTheSolution_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name :
         {"density", "energy", "momentum_y", "velocity_magnitude", "pressure", "temperature", "mach"})
        QTest::newRow(name) << name;
}

void Plot3dReaderTest::arraysFollowFromTheSolution()
{
    QFETCH(QString, name);
    const auto dataset = read(writePair({.doubles = true}), {{"array", name.toStdString()}});
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    for (int n = 0; n < 60; ++n)
        QVERIFY(std::abs(dataset->values.at(static_cast<std::uint64_t>(n)) - expectedArray(name.toStdString(), n)) <
                1e-12);
}

void Plot3dReaderTest::theSolutionIsFoundByItsName_data()
{
    QTest::addColumn<QString>("grid");
    QTest::addColumn<QString>("solution");
    QTest::newRow("xyz.bin") << "finxyz.bin"
                             << "finq.bin";
    QTest::newRow(".xyz") << "fin.xyz"
                          << "fin.q";
    QTest::newRow(".x") << "fin.x"
                        << "fin.q";
    QTest::newRow(".p3d") << "fin.p3d"
                          << "fin.q";
    QTest::newRow("capitals") << "FIN.XYZ"
                              << "FIN.Q";
}

void Plot3dReaderTest::theSolutionIsFoundByItsName()
{
    QFETCH(QString, grid);
    QFETCH(QString, solution);
    const auto gridPath = write(grid.toStdString(), testFile({}, false));
    const auto alone = read(gridPath);
    QVERIFY(!alone.ok());
    QVERIFY2(QString::fromStdString(alone.error().text()).contains(solution), alone.error().text().c_str());
    QCOMPARE(alone.error().kind, ErrorKind::WrongUsage); // so that the window asks
    const auto solutionPath = write(solution.toStdString(), testFile({}, true));
    QVERIFY(read(gridPath).ok());
    const auto bySolution = read(solutionPath);
    QVERIFY2(bySolution.ok(), bySolution.ok() ? "" : bySolution.error().text().c_str());
    QCOMPARE(bySolution->source.hash, read(gridPath)->source.hash);

    std::filesystem::rename(solutionPath, solutionPath.parent_path() / "other.data");
    QVERIFY(!read(gridPath).ok());
    QVERIFY(read(gridPath, {{"solution", std::string("other.data")}}).ok());
    QVERIFY(!read(gridPath, {{"solution", std::string("missing.data")}}).ok());
}

void Plot3dReaderTest::aGridOfSeveralIsChosen()
{
    const auto path = writePair({.order = std::endian::big, .marks = true, .multiGrid = true, .grids = 3});
    const auto all = read(path);
    QVERIFY2(all.ok(), all.ok() ? "" : all.error().text().c_str());
    QCOMPARE(all->domain, DomainClass::Irregular);
    QCOMPARE(all->pointCount(), std::uint64_t(60 + 80 + 100));
    QVERIFY(all->remarks.front().text().starts_with("Its 3 zones were put into one mesh"));
    const Taken whole{TakenPart::Block, Message::say("all %1 grids", 3)};
    QVERIFY(std::ranges::find(all->source.taken, whole) != all->source.taken.end());
    QCOMPARE(all->source.leftOut.size(), std::size_t(1)); // what the solution says of the flow
    const auto third = read(path, {{"grid", std::int64_t(3)}});
    QVERIFY2(third.ok(), third.ok() ? "" : third.error().text().c_str());
    QCOMPARE(third->lattice.size, (std::array<std::uint32_t, 3>{5, 4, 5}));
    QCOMPARE(third->position(17)[2], testCoordinate(2, 17, 2));
    QCOMPARE(third->values.at(17), testQuantity(0, 17));
    const Taken one{TakenPart::Block, Message::say("grid %1 of %2", 3, 3)};
    QVERIFY(std::ranges::find(third->source.taken, one) != third->source.taken.end());
    QCOMPARE(third->source.leftOut.size(), std::size_t(2));
    const auto fourth = read(path, {{"grid", std::int64_t(4)}});
    QVERIFY(!fourth.ok());
    QCOMPARE(fourth.error().kind, ErrorKind::WrongUsage);
}

namespace {

/// Boxes of points that lie one apart, each from `low` on, with a density that is linear in the place.
struct PointBox {
    Eigen::Vector3d low;
    std::array<int, 3> size;
};

double densityAt(const Eigen::Vector3d& place)
{
    return 64 + place.dot(Eigen::Vector3d(1, 2, 4));
}

QByteArray boxesFile(const std::vector<PointBox>& boxes, bool solution)
{
    Plot3dBytes file({.multiGrid = true});
    file.integer(std::int32_t(boxes.size()));
    for (const PointBox& box : boxes)
        for (const int count : box.size)
            file.integer(count);
    for (const PointBox& box : boxes) {
        for (int i = 0; solution && i < 4; ++i)
            file.real(1);
        for (int component = 0; component < (solution ? 5 : 3); ++component)
            for (int k = 0; k < box.size[2]; ++k)
                for (int j = 0; j < box.size[1]; ++j)
                    for (int i = 0; i < box.size[0]; ++i) {
                        const Eigen::Vector3d place = box.low + Eigen::Vector3d(i, j, k);
                        file.real(!solution ? place[component] : component == 0 ? densityAt(place) : 1);
                    }
    }
    file.endRecord();
    return file.bytes();
}

} // namespace

/// Two that share a side of 3 x 2 cells, and a third one that touches the second along an edge.
void Plot3dReaderTest::severalGridsAreJoined()
{
    const std::vector<PointBox> boxes = {{{0, 0, 0}, {3, 4, 3}}, {{2, 0, 0}, {4, 4, 3}}, {{5, 3, 0}, {2, 2, 3}}};
    write("g.q", boxesFile(boxes, true));
    const auto path = write("g.xyz", boxesFile(boxes, false));
    const auto mesh = read(path);
    QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
    QCOMPARE(mesh->domain, DomainClass::Irregular);
    QCOMPARE(mesh->pointCount(), std::uint64_t(36 + 48 + 12 - 12 - 3));
    double volume = 0;
    for (const auto& [a, b, c, d] : *mesh->tetrahedra) {
        const auto& at = *mesh->positions;
        volume += (at[b] - at[a]).dot((at[c] - at[a]).cross(at[d] - at[a])) / 6;
    }
    QCOMPARE(volume, 12.0 + 18 + 2);
    for (std::uint64_t point = 0; point < mesh->pointCount(); ++point)
        QCOMPARE(mesh->values.at(point), densityAt(mesh->position(point)));
    QCOMPARE(mesh->values.type(), SampleType::Float32);
    QCOMPARE(QString::fromStdString(mesh->source.name), QString("g.xyz, density"));
    QCOMPARE(QString::fromStdString(mesh->remarks.front().text()),
             QString("Its 3 zones were joined into one mesh, in which they share 6 faces."));
    const std::vector<Taken> taken = {{TakenPart::Array, "density", true},
                                      {TakenPart::Block, Message::say("all %1 grids", 3)}};
    QVERIFY(mesh->source.taken == taken);

    const auto contents = asLoaded<Plot3dReader>().probe(path, {{"array", std::string("density")}}, {});
    QVERIFY(contents.ok());
    QCOMPARE(contents->taken.size(), std::size_t(2));
    QCOMPARE(contents->blocks.size(), std::size_t(3));
    // Alone, one has an array that varies, too.
    QVERIFY(read(path, {{"grid", std::int64_t(2)}}).ok());
}

void Plot3dReaderTest::gridsThatOverlapAreRefused()
{
    const std::vector<PointBox> boxes = {{{0, 0, 0}, {4, 4, 4}}, {{1.5, 0.5, 0.5}, {4, 4, 4}}};
    write("g.q", boxesFile(boxes, true));
    const auto path = write("g.xyz", boxesFile(boxes, false));
    const auto mesh = read(path);
    QVERIFY(!mesh.ok());
    const QString text = QString::fromStdString(mesh.error().text());
    QVERIFY2(text.contains("its 2 grids do not make a mesh together") && text.contains("overlaps others") &&
                 text.contains("'grid' from 1 to 2"),
             qPrintable(text));
    // One of them alone is taken, and only what lies in a region is judged.
    QVERIFY(read(path, {{"grid", std::int64_t(2)}}).ok());
    const Eigen::AlignedBox3d beyond(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 4, 4));
    const auto part = asLoaded<Plot3dReader>().readAround(beyond, path, {}, {});
    QVERIFY2(part.ok(), part.ok() ? "" : part.error().text().c_str());
}

void Plot3dReaderTest::probesWithoutTheData()
{
    const auto one = asLoaded<Plot3dReader>().probe(writePair({.doubles = true}), {}, {});
    QVERIFY2(one, one ? "" : one.error().text().c_str());
    QCOMPARE(one->lattice.size, (std::array<std::uint32_t, 3>{3, 4, 5}));
    QCOMPARE(one->type, std::optional(SampleType::Float64));
    QVERIFY(one->blocks.empty());
    for (const FileArray& array : one->arrays) // each can be asked for
        QVERIFY2(read(folder_->path().toStdString() + "/g.xyz", {{"array", array.name}}), array.name.c_str());
    const auto path = writePair({.multiGrid = true, .grids = 3});
    const auto several = asLoaded<Plot3dReader>().probe(path, {}, {});
    QVERIFY(several);
    QCOMPARE(several->blocks, (std::vector<std::string>{"1: 3 x 4 x 5", "2: 4 x 4 x 5", "3: 5 x 4 x 5"}));
    QCOMPARE(several->points, std::uint64_t(0));
    QCOMPARE(asLoaded<Plot3dReader>().probe(path, {{"grid", std::int64_t(2)}}, {})->points, std::uint64_t(80));
    QVERIFY(!asLoaded<Plot3dReader>().probe(path, {{"grid", std::int64_t(4)}}, {}));
    const auto alone = write("alone.xyz", testFile({}, false));
    QCOMPARE(asLoaded<Plot3dReader>().probe(alone, {}, {}).error().text(), read(alone).error().text());
}

void Plot3dReaderTest::constantArraysAreNotTaken()
{
    Plot3dBytes solution({});
    for (const std::int32_t number : testSize(0))
        solution.integer(number);
    for (int i = 0; i < 4; ++i)
        solution.real(1);
    for (int component = 0; component < 5; ++component)
        for (int n = 0; n < 60; ++n)
            solution.real(component == 0 ? 1 : testQuantity(component, n));
    solution.endRecord();
    write("g.q", solution.bytes());
    const auto path = write("g.xyz", testFile({}, false));
    const auto automatic = read(path);
    QVERIFY(automatic.ok());
    QCOMPARE(QString::fromStdString(automatic->source.name), QString("g.xyz, pressure"));
    const auto density = read(path, {{"array", std::string("density")}});
    QVERIFY(!density.ok());
    const QString text = QString::fromStdString(density.error().text());
    QVERIFY2(text.contains("the same value everywhere") && text.contains("pressure, energy"), qPrintable(text));
}

/// Without energy the pressure is below 0, and there is no speed of sound.
void Plot3dReaderTest::arraysWithoutANumberAreToldAsThat()
{
    Plot3dBytes solution({});
    for (const std::int32_t number : testSize(0))
        solution.integer(number);
    for (int i = 0; i < 4; ++i)
        solution.real(1);
    for (int component = 0; component < 5; ++component)
        for (int n = 0; n < 60; ++n)
            solution.real(component == 4 ? 0 : testQuantity(component, n));
    solution.endRecord();
    write("g.q", solution.bytes());
    const auto mach = read(write("g.xyz", testFile({}, false)), {{"array", std::string("mach")}});
    QVERIFY(!mach.ok());
    const QString text = QString::fromStdString(mach.error().text());
    QVERIFY2(text.contains("'mach' is not a number anywhere") && !text.contains("same value"), qPrintable(text));
}

void Plot3dReaderTest::aCutGridIsToldAsThat_data()
{
    QTest::addColumn<bool>("multiGrid");
    QTest::addColumn<bool>("isBig");
    for (const bool multiGrid : {false, true})
        for (const bool isBig : {false, true})
            QTest::addRow("%s%s", isBig ? "big" : "little", multiGrid ? ", multi" : "") << multiGrid << isBig;
}

/// Of one whose records have their lengths it is known what it is: not a file of an unknown format.
void Plot3dReaderTest::aCutGridIsToldAsThat()
{
    QFETCH(bool, multiGrid);
    QFETCH(bool, isBig);
    const Plot3dStyle style{
        .order = isBig ? std::endian::big : std::endian::little, .marks = true, .multiGrid = multiGrid};
    QByteArray grid = testFile(style, false);
    grid.chop(1);
    write("g.q", testFile(style, true));
    const auto path = write("g.xyz", grid);
    const double score = scoreOf(path, grid);
    QVERIFY2(score > 0 && score < 0.5, QByteArray::number(score));
    const auto cut = read(path);
    QVERIFY(!cut.ok());
    QVERIFY2(cut.error().text().find("cut short") != std::string::npos, cut.error().text().c_str());
}

void Plot3dReaderTest::zerosBehindTheDataAreBorne()
{
    write("g.xyz", testFile({}, false) + QByteArray(100, '\0'));
    write("g.q", testFile({}, true) + QByteArray(484, '\0'));
    QVERIFY(read(folder_->path().toStdString() + "/g.xyz").ok());
    write("g.q", testFile({}, true) + QByteArray(483, '\0') + "x");
    QVERIFY(!read(folder_->path().toStdString() + "/g.xyz").ok());
    write("g.q", testFile({}, true) + QByteArray(5000, '\0'));
    QVERIFY(!read(folder_->path().toStdString() + "/g.xyz").ok());
}

/// C10: the last of each row of four points is no part of the domain, whatever the solution says there.
void Plot3dReaderTest::blankedPointsAreHoles()
{
    const auto iblankOf = [](int n) { return n % 4 == 3 ? 0 : n % 4 == 2 ? -1 : 1; };
    const Plot3dStyle style{.multiGrid = true, .iblank = true, .grids = 2};
    QByteArray solution = testFile(style, true);
    constexpr int numberBytes = 4, front = 4 + 2 * 12, first = (4 + 5 * 60) * 4;
    solution.replace(front + first + (4 + 3) * numberBytes, numberBytes, "\xff\xff\xff\x7f"); // NaN
    write("g.q", solution);
    const auto path = write("g.xyz", testFile(style, false, iblankOf));
    const ParameterValues second{{"grid", std::int64_t(2)}};
    const auto dataset = read(path, second);
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QCOMPARE(dataset->domain, DomainClass::Irregular);
    QCOMPARE(dataset->pointCount(), std::uint64_t(3 * 4 * 5));
    QVERIFY(dataset->tetrahedra->size() >= std::size_t(5 * 2 * 3 * 4));
    QCOMPARE(dataset->values.type(), SampleType::Float32);
    QCOMPARE(QString::fromStdString(dataset->source.name), QString("g.xyz, density"));
    QVERIFY(dataset->remarks.front().text().starts_with("The grid has become an irregular mesh with holes"));
    QVERIFY(dataset->remarks.front().text().find("20 of its 80 points") != std::string::npos);
    for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
        bool isThere = false;
        for (int n = 0; n < 80; ++n)
            isThere = isThere ||
                      (n % 4 != 3 && dataset->values.at(point) == testQuantity(0, n) &&
                       dataset->position(point) ==
                           Eigen::Vector3d(testCoordinate(0, n, 1), testCoordinate(1, n, 1), testCoordinate(2, n, 1)));
        QVERIFY(isThere);
    }
    const auto contents = asLoaded<Plot3dReader>().probe(path, second, {});
    QVERIFY(contents.ok());
    QCOMPARE(contents->domain, std::optional(DomainClass::Curvilinear)); // parts are taken of the grid
    QCOMPARE(contents->points, std::uint64_t(80));

    const auto none = read(write("g.xyz", testFile(style, false, [](int) { return 0; })), second);
    QVERIFY(!none.ok());
    QVERIFY2(none.error().text().find("nothing to see") != std::string::npos, none.error().text().c_str());
}

void Plot3dReaderTest::mutationsAreReadOrRefused()
{
    std::mt19937 random(20240229);
    int wereRead = 0;
    for (int round = 0; round < 1500; ++round) {
        const Plot3dStyle style{.order = round & 1 ? std::endian::big : std::endian::little,
                                .marks = (round & 2) != 0,
                                .multiGrid = (round & 4) != 0,
                                .iblank = (round & 8) != 0};
        QByteArray files[] = {testFile(style, false), testFile(style, true)};
        QByteArray& file = files[random() % 2];
        const auto place = [&](qsizetype below) {
            return below == 0 ? 0 : static_cast<qsizetype>(random() % static_cast<unsigned>(below));
        };
        for (unsigned change = 0; change <= random() % 3; ++change)
            switch (random() % 4) {
            case 0: file.truncate(place(file.size())); break;
            case 1: file.insert(place(file.size() + 1), QByteArray(1 + place(9), static_cast<char>(random()))); break;
            case 2: file += "xx"; break;
            default:
                if (!file.isEmpty()) // the front matters most
                    file[place(random() % 2 ? std::min<qsizetype>(32, file.size()) : file.size())] =
                        static_cast<char>(random());
            }
        write("g.q", files[1]);
        const auto dataset = read(write("g.xyz", files[0]));
        if (!dataset) {
            QVERIFY(dataset.error().text().size() > 10);
            continue;
        }
        ++wereRead;
        if (dataset->domain == DomainClass::Curvilinear)
            QCOMPARE(dataset->values.count(), dataset->lattice.pointCount());
        QCOMPARE(dataset->positions->size(), std::size_t(dataset->values.count()));
        QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(0));
        for (const Eigen::Vector3d& position : *dataset->positions)
            QVERIFY(position.allFinite());
    }
    QVERIFY(wereRead > 100);
}

void Plot3dReaderTest::otherFilesAreLeftToOthers()
{
    for (const QByteArray& content : {QByteArray("x,y,z,value\n1,2,3,4\n"), QByteArray("NRRD0004\n"),
                                      QByteArray(32768, '\x10'), QByteArray(32768, '\0')})
        QCOMPARE(scoreOf(write("file.xyz", content), content), 0.);
}

void Plot3dReaderTest::whatIsWrittenComesBack()
{
    for (const bool doubles : {false, true}) {
        const auto dataset = read(writePair({.order = std::endian::big, .doubles = doubles}));
        QVERIFY(dataset.ok());
        const std::filesystem::path path = folder_->filePath("copy.xyz").toStdString();
        const auto written = saveDataset(pluginsOfThisBuild(), *dataset, path);
        QVERIFY2(written.ok(), written.ok() ? "" : written.error().text().c_str());
        const auto copy = read(path);
        QVERIFY2(copy.ok(), copy.ok() ? "" : copy.error().text().c_str());
        QCOMPARE(copy->source.hash, dataset->source.hash);
        QCOMPARE(copy->lattice.size, dataset->lattice.size);
        QCOMPARE(copy->values.type(), dataset->values.type());
    }
    // Whole numbers that single precision does not hold.
    for (const bool isSigned : {false, true}) {
        Dataset whole = *read(writePair({}));
        std::vector<std::uint32_t> numbers(whole.pointCount());
        for (std::uint32_t i = 0; i < numbers.size(); ++i)
            numbers[i] = (1U << 24U) + 1 + 2 * i;
        whole.values = isSigned ? ScalarField::of(std::vector<std::int32_t>(numbers.begin(), numbers.end()))
                                : ScalarField::of(numbers);
        const std::filesystem::path path = folder_->filePath("whole.xyz").toStdString();
        QVERIFY(saveDataset(pluginsOfThisBuild(), whole, path).ok());
        const auto copy = read(path);
        QVERIFY2(copy.ok(), copy.ok() ? "" : copy.error().text().c_str());
        QCOMPARE(copy->pointCount(), whole.pointCount());
        for (std::uint32_t i = 0; i < numbers.size(); ++i)
            QCOMPARE(copy->values.at(i), double(numbers[i]));
    }
    Dataset scattered = *read(writePair({}));
    scattered.domain = DomainClass::Scattered;
    QVERIFY(!saveDataset(pluginsOfThisBuild(), scattered, folder_->filePath("points.xyz").toStdString()).ok());
    QVERIFY(!std::filesystem::exists(folder_->filePath("points.xyz").toStdString()));
}

void Plot3dReaderTest::cancels()
{
    const auto path = writePair({});
    std::stop_source stop;
    stop.request_stop();
    const auto dataset = asLoaded<Plot3dReader>().read(path, {}, Progress(stop.get_token(), {}));
    QVERIFY(!dataset.ok());
    QCOMPARE(dataset.error().kind, ErrorKind::Cancelled);
}

QTEST_GUILESS_MAIN(Plot3dReaderTest)
#include "plot3d_reader_test.moc"
