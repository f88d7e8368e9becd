// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of arrays in HDF5 files lie: by dimension scales, the axes of NeXus, the frames of ITK and
// Imaris, or attributes; judged by a function of the place in the world (S20).
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/hdf5/hdf5_test_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

using Coordinates = std::vector<double>;

constexpr double scale = 10;

/// The function at all places of three axes: `order` says which of x, y, z the array's dimensions are, the slowest
/// first.
std::vector<double> worldAlong(const std::array<Coordinates, 3>& xyz, const std::array<Eigen::Index, 3>& order)
{
    std::vector<double> values;
    Eigen::Vector3d place;
    for (const double first : xyz[std::size_t(order[0])])
        for (const double second : xyz[std::size_t(order[1])])
            for (const double third : xyz[std::size_t(order[2])]) {
                place[order[0]] = first;
                place[order[1]] = second;
                place[order[2]] = third;
                values.push_back(worldFunction(place, scale));
            }
    return values;
}

const Coordinates evenX = steps<double>(5, 10, 4), evenY = steps<double>(4, 20, 3), evenZ = steps<double>(3, -30, 2),
                  unevenZ = {-30, -27, -10};

/// An array of a picture of Imaris, filled up to 4 x 4 x 8 with what is no voxel; at each place `more` than the
/// function.
void addImarisArray(Hdf5TestFile& file, const std::string& group, double more)
{
    const auto inside = worldAlong({evenX, evenY, evenZ}, {2, 1, 0});
    std::vector<float> filled(4 * 4 * 8, -1e6F);
    for (std::size_t z = 0; z < 3; ++z)
        for (std::size_t y = 0; y < 4; ++y)
            for (std::size_t x = 0; x < 5; ++x)
                filled[(z * 4 + y) * 8 + x] = static_cast<float>(inside[(z * 4 + y) * 5 + x] + more);
    file.add<float>(group + "/Data", {4, 4, 8}, filled, {.chunk = {2, 4, 4}});
    file.letters(group, "ImageSizeX", "5");
    file.letters(group, "ImageSizeY", "4");
    file.letters(group, "ImageSizeZ", "3");
}

/// Two times and two channels, of which one level alone holds the function, and a level that is none of it.
void writeImaris(const fs::path& path, std::uint64_t time, std::uint64_t channel)
{
    Hdf5TestFile file(path);
    const auto group = [](std::uint64_t level, std::uint64_t t, std::uint64_t c) {
        return "/DataSet/ResolutionLevel " + std::to_string(level) + "/TimePoint " + std::to_string(t) + "/Channel " +
               std::to_string(c);
    };
    for (std::uint64_t t = 0; t < 2; ++t)
        for (std::uint64_t c = 0; c < 2; ++c) {
            addImarisArray(file, group(0, t, c), t == time && c == channel ? 0 : 1000);
            addImarisArray(file, group(1, t, c), 2000);
        }
    for (const char* name : {"/DataSetInfo", "/DataSetInfo/Image", "/DataSetInfo/Channel 1", "/DataSetInfo/TimeInfo"})
        file.group(name);
    for (const auto& [name, text] : std::vector<std::pair<const char*, const char*>>{{"ExtMin0", "8"},
                                                                                     {"ExtMax0", "28"},
                                                                                     {"ExtMin1", "18.5"},
                                                                                     {"ExtMax1", "30.5"},
                                                                                     {"ExtMin2", "-31"},
                                                                                     {"ExtMax2", "-25"},
                                                                                     {"Unit", "um"}})
        file.letters("/DataSetInfo/Image", name, text);
    file.letters("/DataSetInfo/Channel 1", "Name", "Alexa 488");
    file.letters("/DataSetInfo/TimeInfo", "TimePoint2", "2020-01-02 03:04:05");
}

} // namespace

class Hdf5PlacesTest : public QObject {
    Q_OBJECT

private slots:
    void dimensionScales_data()
    {
        QTest::addColumn<bool>("isEven");
        QTest::addColumn<bool>("isExchanged");
        QTest::newRow("even") << true << false;
        QTest::newRow("uneven") << false << false;
        QTest::newRow("x is the slowest") << true << true;
        QTest::newRow("x is the slowest, uneven") << false << true;
    }
    void dimensionScales()
    {
        QFETCH(bool, isEven);
        QFETCH(bool, isExchanged);
        const Coordinates z = isEven ? evenZ : unevenZ;
        {
            Hdf5TestFile file(path());
            file.add<double>("/x", {5}, evenX);
            file.add<double>("/y", {4}, evenY);
            file.add<double>("/z", {3}, z);
            for (const char* name : {"/x", "/y", "/z"})
                file.texts(name, "units", {"mm"});
            const std::vector<hsize_t> size =
                isExchanged ? std::vector<hsize_t>{5, 4, 3} : std::vector<hsize_t>{3, 4, 5};
            file.add<double>("/q", size,
                             isExchanged ? worldAlong({evenX, evenY, z}, {0, 1, 2})
                                         : worldAlong({evenX, evenY, z}, {2, 1, 0}));
            file.attachScales("/q", isExchanged ? std::vector<std::string>{"/x", "/y", "/z"}
                                                : std::vector<std::string>{"/z", "/y", "/x"});
        }
        const Dataset dataset = readInItsPlace();
        QCOMPARE(dataset.domain, isEven ? DomainClass::RegularLattice : DomainClass::Curvilinear);
        QCOMPARE(dataset.lengthUnit, std::string("mm"));
        QCOMPARE(takenOf(dataset.source.taken, TakenPart::Places), std::string("x, y, z"));
        refuseSpacing();
    }

    void nexusAxes()
    {
        {
            Hdf5TestFile file(path());
            file.add<double>("/entry/data", {3, 4, 5}, worldAlong({evenX, evenY, unevenZ}, {2, 1, 0}));
            file.texts("/entry", "signal", {"data"});
            file.texts("/entry", "axes", {"qz", "y", "x"});
            file.add<double>("/entry/qz", {3}, unevenZ);
            file.add<double>("/entry/y", {4}, evenY);
            file.add<double>("/entry/x", {6}, steps<double>(6, 8, 4)); // edges of bins
        }
        const Dataset dataset = readInItsPlace();
        QCOMPARE(takenOf(dataset.source.taken, TakenPart::Places), std::string("x, y, qz ?"));
        QVERIFY(textOf(dataset.remarks).find("edges of bins") != std::string::npos);
    }

    void attributes_data()
    {
        QTest::addColumn<QString>("spacing");
        QTest::addColumn<QString>("origin");
        QTest::addColumn<QString>("object");
        QTest::addColumn<QString>("unit");
        QTest::newRow("element_size_um") << "element_size_um"
                                         << "origin"
                                         << "/g/q"
                                         << "um";
        QTest::newRow("spacing") << "spacing"
                                 << "origin"
                                 << "/g/q"
                                 << "";
        QTest::newRow("of the group") << "voxel_size"
                                      << "offset"
                                      << "/g"
                                      << "";
    }
    void attributes()
    {
        QFETCH(QString, spacing);
        QFETCH(QString, origin);
        QFETCH(QString, object);
        QFETCH(QString, unit);
        {
            Hdf5TestFile file(path());
            file.add<double>("/g/q", {3, 4, 5}, worldAlong({evenX, evenY, evenZ}, {2, 1, 0}));
            file.numbers<double>(object.toStdString(), spacing.toUtf8().constData(), {2, 3, 4});
            file.numbers<float>(object.toStdString(), origin.toUtf8().constData(), {-30, 20, 10});
            file.numbers<double>("/g/q", "resolution", {1, 2}); // says nothing of three axes
        }
        const Dataset dataset = readInItsPlace();
        QCOMPARE(dataset.lengthUnit, unit.toStdString());
        QVERIFY(takenOf(dataset.source.taken, TakenPart::Places).find(spacing.toStdString()) != std::string::npos);
        QVERIFY(textOf(dataset.source.leftOut).find("'resolution'") != std::string::npos);
        refuseSpacing();
    }

    void itk()
    {
        const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        const Eigen::Vector3d spacing(4, 3, 2), origin(10, 20, -30);
        {
            Hdf5TestFile file(path());
            const QByteArray samples = samplesOfWorld({5, 4, 3}, turned * spacing.asDiagonal(), origin, scale);
            const auto* values = reinterpret_cast<const float*>(samples.constData());
            file.add<float>("/ITKImage/0/VoxelData", {3, 4, 5}, {values, values + 60});
            file.add<double>("/ITKImage/0/Origin", {3}, {origin.data(), origin.data() + 3});
            file.add<double>("/ITKImage/0/Spacing", {3}, {spacing.data(), spacing.data() + 3});
            file.add<double>("/ITKImage/0/Directions", {3, 3}, {turned.data(), turned.data() + 9});
        }
        const Dataset dataset = readInItsPlace();
        QCOMPARE(dataset.space, std::string("LPS"));
        QVERIFY((dataset.lattice.spacing - spacing).norm() < 1e-12);
    }

    void imaris()
    {
        writeImaris(path(), 0, 0);
        const Dataset first = readInItsPlace();
        QCOMPARE(first.lattice.size, (std::array<std::uint32_t, 3>{5, 4, 3}));
        QCOMPARE(first.lengthUnit, std::string("um"));
        const std::vector<Taken>& taken = first.source.taken;
        QCOMPARE(takenOf(taken, TakenPart::Channel), std::string("1 of 2 ?"));
        QCOMPARE(takenOf(taken, TakenPart::TimeStep), std::string("1 of 2 ?"));
        QCOMPARE(takenOf(taken, TakenPart::Block), std::string("0 of 0 to 1"));
        QVERIFY(takenOf(taken, TakenPart::Places).find("Imaris") != std::string::npos);
        QVERIFY(textOf(first.source.leftOut).find("It has 2 levels of detail") != std::string::npos);
        QVERIFY(textOf(first.source.leftOut).find("other arrays") == std::string::npos);
        refuseSpacing();

        writeImaris(path(), 1, 1);
        const Dataset second = readInItsPlace({{"time", std::int64_t(2)}, {"channel", std::string("2")}});
        QCOMPARE(takenOf(second.source.taken, TakenPart::Channel), std::string("2 of 2, Alexa 488"));
        QCOMPARE(takenOf(second.source.taken, TakenPart::TimeStep), std::string("2 of 2, 2020-01-02 03:04:05"));
        const auto contents = builtHdf5Reader().probe(path(), {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->timeSteps, (std::vector<double>{0, 1}));
        QCOMPARE(contents->channels, (std::vector<std::string>{"1", "2"}));
        QCOMPARE(contents->lattice.size, first.lattice.size);
        QCOMPARE(contents->arrays.size(), std::size_t(8));
    }

    void imarisByItsArray()
    {
        writeImaris(path(), 0, 0);
        const std::string coarse = "/DataSet/ResolutionLevel 1/TimePoint 1/Channel 0/Data";
        const auto dataset = builtHdf5Reader().read(path(), {{"array", coarse}}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Block), std::string("1 of 0 to 1"));
        QVERIFY(dataset->values.range().minimum > 1000); // nothing that only fills up
        for (const ParameterValues& values :
             {ParameterValues{{"time", std::int64_t(3)}}, ParameterValues{{"channel", std::string("3")}}}) {
            const auto refused = builtHdf5Reader().read(path(), values, {});
            QVERIFY(!refused.ok());
            QCOMPARE(int(refused.error().kind), int(ErrorKind::WrongUsage));
        }
    }

    void givenByTheUser()
    {
        {
            Hdf5TestFile file(path());
            file.add<double>("/q", {3, 4, 5}, worldAlong({evenX, evenY, evenZ}, {2, 1, 0}));
        }
        readInItsPlace({{"spacing", std::string("4x3x2")}, {"origin", std::string("10,20,-30")}});
        const auto contents = builtHdf5Reader().probe(path(), {}, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->untold, (std::vector<std::string>{"spacing", "origin", "unit"}));
        const auto bare = builtHdf5Reader().read(path(), {}, {});
        QVERIFY(bare.ok());
        QCOMPARE(bare->lattice.spacing, Eigen::Vector3d(1, 1, 1));
        QVERIFY(textOf(bare->remarks).find("does not state its spacing") != std::string::npos);
    }

private:
    fs::path path() const { return folder_.path("file.h5"); }

    Dataset readInItsPlace(const ParameterValues& values = {}) const
    {
        const auto dataset = builtHdf5Reader().read(path(), values, {});
        if (!dataset)
            qFatal("%s", dataset.error().text().c_str());
        [&] { QVERIFY2(distanceFromWorld(*dataset, scale) < 1e-5, "samples lie elsewhere"); }();
        return *dataset;
    }

    void refuseSpacing() const
    {
        const auto dataset = builtHdf5Reader().read(path(), {{"spacing", std::string("1x1x1")}}, {});
        QVERIFY(!dataset.ok());
        QVERIFY(dataset.error().text().find("it states its spacing itself") != std::string::npos);
    }

    Hdf5Folder folder_;
};

QTEST_GUILESS_MAIN(Hdf5PlacesTest)
#include "hdf5_places_test.moc"
