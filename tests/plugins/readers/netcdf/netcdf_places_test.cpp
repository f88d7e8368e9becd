// SPDX-License-Identifier: GPL-3.0-or-later
// Points of NetCDF grids lie where their coordinates say, whatever their order, direction and kind (D1, S6): each value
// is a function of its place in the world.
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/netcdf/netcdf_test_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

using Coordinates = std::array<std::vector<double>, 3>; ///< of x, y, z

const Coordinates equalSteps{steps<double>(5, -1, 0.5), steps<double>(4, 3, 0.25), steps<double>(3, 10, 2)};

/// A file with the function of the world along three axes that lie in the file in this order, the slowest first.
template <class T> void writeAxes(const fs::path& path, const Coordinates& world, const std::array<int, 3>& order)
{
    NetCdfTestFile file(path);
    std::array<int, 3> dimensions{};
    const char* const names[] = {"x", "y", "z"};
    for (const int axis : order)
        dimensions[std::size_t(axis)] = file.dimension(names[axis], world[std::size_t(axis)].size());
    for (std::size_t axis = 0; axis < 3; ++axis)
        file.add(names[axis], {dimensions[axis]}, std::vector<T>(world[axis].begin(), world[axis].end()), "m");
    std::vector<int> ordered;
    for (const int axis : order)
        ordered.push_back(dimensions[std::size_t(axis)]);
    std::vector<double> values;
    std::array<std::size_t, 3> at{};
    const auto length = [&](int place) { return world[std::size_t(order[std::size_t(place)])].size(); };
    for (std::size_t slow = 0; slow < length(0); ++slow)
        for (std::size_t middle = 0; middle < length(1); ++middle)
            for (std::size_t fast = 0; fast < length(2); ++fast) {
                at[std::size_t(order[0])] = slow;
                at[std::size_t(order[1])] = middle;
                at[std::size_t(order[2])] = fast;
                values.push_back(worldFunction({world[0][at[0]], world[1][at[1]], world[2][at[2]]}, 1));
            }
    file.add("q", ordered, values);
}

} // namespace

class NetCdfPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void equalStepsAreALatticeInAnyOrder()
    {
        std::array<int, 3> order{0, 1, 2};
        int orders = 0;
        do {
            for (const bool backwards : {false, true}) {
                Coordinates world = equalSteps;
                if (backwards)
                    std::ranges::reverse(world[1]);
                writeAxes<double>(folder_.path("axes.nc"), world, order);
                const auto dataset = builtNetCdfReader().read(folder_.path("axes.nc"), {}, {});
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(dataset->domain == DomainClass::RegularLattice);
                QCOMPARE(dataset->pointCount(), std::uint64_t(60));
                QCOMPARE(distanceFromWorld(*dataset, 1), 0.);
                QCOMPARE(dataset->lengthUnit, std::string("m"));
                QCOMPARE(takenOf(dataset->source.taken, TakenPart::Places), std::string("x, y, z"));
                const auto contents = builtNetCdfReader().probe(folder_.path("axes.nc"), {}, {});
                QVERIFY(contents.ok());
                QCOMPARE(contents->lattice.directions, dataset->lattice.directions);
                QCOMPARE(contents->lattice.origin, dataset->lattice.origin);
                QCOMPARE(contents->taken, dataset->source.taken);
            }
            ++orders;
        } while (std::ranges::next_permutation(order).found);
        QCOMPARE(orders, 6);
    }

    /// Tenths are not exact in single precision.
    void roundedStepsAreALattice()
    {
        const Coordinates tenths{steps<double>(5, 0, 0.1), steps<double>(4, 3, 0.1), steps<double>(3, 10, 0.7)};
        writeAxes<float>(folder_.path("rounded.nc"), tenths, {2, 1, 0});
        const auto dataset = builtNetCdfReader().read(folder_.path("rounded.nc"), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::RegularLattice);
        QVERIFY(distanceFromWorld(*dataset, 1) < 1e-5);
    }

    void unequalStepsAreAGrid()
    {
        Coordinates world = equalSteps;
        world[2] = {1000, 850, 500}; // pressures fall
        for (const auto& order : {std::array{2, 1, 0}, std::array{0, 1, 2}}) {
            writeAxes<double>(folder_.path("levels.nc"), world, order);
            const auto dataset = builtNetCdfReader().read(folder_.path("levels.nc"), {}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(dataset->domain == DomainClass::Curvilinear);
            QCOMPARE(distanceFromWorld(*dataset, 1), 0.);
        }
    }

    /// Attributes say which axis a coordinate belongs to, where names do not.
    void attributesSayTheAxis()
    {
        {
            NetCdfTestFile file(folder_.path("axis.nc"));
            const int a = file.dimension("a", 2), b = file.dimension("b", 3), c = file.dimension("c", 4);
            const int first = file.add("a", {a}, steps<double>(2, 5, 1));
            const int second = file.add("b", {b}, steps<double>(3, 1, 2), "degrees_north");
            const int third = file.add("c", {c}, steps<double>(4, 0, -3));
            file.text(first, "axis", "X");
            file.text(third, "positive", "down");
            static_cast<void>(second);
            std::vector<double> values;
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 3; ++j)
                    for (int k = 0; k < 4; ++k)
                        values.push_back(worldFunction({5. + i, 1. + 2 * j, -3. * k}, 1));
            file.add("q", {a, b, c}, values);
        }
        const auto dataset = builtNetCdfReader().read(folder_.path("axis.nc"), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(distanceFromWorld(*dataset, 1), 0.);
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Places), std::string("a, b, c"));
        QCOMPARE(dataset->source.leftOut.size(), std::size_t(1));
        QVERIFY(dataset->source.leftOut[0].text().find("counts downwards") != std::string::npos);
        QVERIFY(dataset->lengthUnit.empty()); // degrees and others
    }

    void withoutCoordinatesThePlaceIsTheUsers()
    {
        {
            NetCdfTestFile file(folder_.path("bare.nc"));
            file.add("q", {file.dimension("x", 2), file.dimension("y", 3), file.dimension("z", 4)},
                     steps<float>(24, 0, 1));
        }
        const auto assumed = builtNetCdfReader().read(folder_.path("bare.nc"), {}, {});
        QVERIFY2(assumed.ok(), assumed.ok() ? "" : assumed.error().text().c_str());
        QVERIFY(assumed->lattice.isAlongAxes());
        QCOMPARE(assumed->lattice.size, (std::array<std::uint32_t, 3>{4, 3, 2}));
        QCOMPARE(assumed->position(23), Eigen::Vector3d(3, 2, 1));
        QCOMPARE(assumed->remarks.size(), std::size_t(1));
        const ParameterValues place{{"spacing", std::string("0.5x1x2")}, {"origin", std::string("1,2,3")}};
        const auto stated = builtNetCdfReader().read(folder_.path("bare.nc"), place, {});
        QVERIFY(stated.ok() && stated->remarks.empty());
        QCOMPARE(stated->position(23), Eigen::Vector3d(2.5, 4, 5));
        writeAxes<double>(folder_.path("told.nc"), equalSteps, {2, 1, 0});
        QVERIFY(!builtNetCdfReader().read(folder_.path("told.nc"), place, {}).ok());
    }

    /// Longitude and latitude of each column, heights of each point; and a time step of all of them.
    void curvedCoordinates()
    {
        const auto place = [](int i, int j, int k, bool heights) {
            return Eigen::Vector3d(10 + i + 0.125 * j, 40 + j - 0.25 * i, heights ? 100. * k + i + j : 0.5 * k * k);
        };
        for (const bool heights : {false, true}) {
            {
                NetCdfTestFile file(folder_.path("curved.nc"));
                const int t = file.dimension("time", 0), k = file.dimension("lev", 3), j = file.dimension("j", 4),
                          i = file.dimension("i", 5);
                std::vector<float> lon, lat, values, height;
                for (int step = 0; step < 2; ++step) // those of the first step lie elsewhere
                    for (int row = 0; row < 4; ++row)
                        for (int column = 0; column < 5; ++column) {
                            lon.push_back(float(place(column, row, 0, heights)[0] + (step == 0 ? 99 : 0)));
                            lat.push_back(float(place(column, row, 0, heights)[1]));
                        }
                for (int step = 0; step < 2; ++step)
                    for (int level = 0; level < 3; ++level)
                        for (int row = 0; row < 4; ++row)
                            for (int column = 0; column < 5; ++column) {
                                const Eigen::Vector3d at = place(column, row, level, heights);
                                values.push_back(step == 0 ? 0.5F * float(column) : float(worldFunction(at, 10)));
                                height.push_back(float(at[2]));
                            }
                file.add("lon", {t, j, i}, lon, "degrees_east");
                file.add("lat", {t, j, i}, lat, "degrees_north");
                file.add("lev", {k}, std::vector<double>{0, 0.5, 2}, "m");
                if (heights)
                    file.text(file.add("zeta", {t, k, j, i}, height, "m"), "standard_name", "height");
                const int q = file.define("q", NC_FLOAT, {t, k, j, i});
                file.text(q, "coordinates", heights ? "lon lat zeta" : "lat lon");
                file.put(q, values);
            }
            const auto dataset = builtNetCdfReader().read(folder_.path("curved.nc"), {{"time", std::int64_t(2)}}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(dataset->domain == DomainClass::Curvilinear);
            QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Places),
                     std::string(heights ? "lon, lat, zeta" : "lon, lat, lev"));
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::TimeStep), std::string("2 of 2"));
        }
    }

    void longitudesGoOnPastTheirEnd()
    {
        {
            NetCdfTestFile file(folder_.path("round.nc"));
            const int z = file.dimension("z", 2), y = file.dimension("lat", 2), x = file.dimension("lon", 4);
            file.add("lon", {x}, std::vector<double>{340, 350, 0, 10}, "degrees_east");
            file.add("lat", {y}, std::vector<double>{0, 10}, "degrees_north");
            file.add("q", {z, y, x}, steps<float>(16, 0, 1));
        }
        const auto dataset = builtNetCdfReader().read(folder_.path("round.nc"), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::RegularLattice);
        QCOMPARE(dataset->position(3), Eigen::Vector3d(370, 0, 0));
        QVERIFY(!dataset->remarks.empty());
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Places), std::string("lon, lat, numbers of 'z' ?"));
    }

    /// Heights of WRF are those of the geopotential, between the faces at which it is given.
    void wrfHeights()
    {
        for (const bool atFaces : {false, true}) {
            {
                NetCdfTestFile file(folder_.path("wrfout_d01"));
                const int t = file.dimension("Time", 0), y = file.dimension("south_north", 3),
                          x = file.dimension("west_east", 2), z = file.dimension("bottom_top", 4),
                          zFaces = file.dimension("bottom_top_stag", 5);
                std::vector<float> lon, lat, base, perturbation(5 * 3 * 2, 9.81F), values;
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i < 2; ++i) {
                        lon.push_back(float(5 + i + 0.25 * j));
                        lat.push_back(float(40 + j));
                    }
                for (int k = 0; k < 5; ++k)
                    for (int n = 0; n < 6; ++n)
                        base.push_back(9.81F * float(100 * k * k));
                for (int k = 0; k < (atFaces ? 5 : 4); ++k)
                    for (int n = 0; n < 6; ++n) {
                        const double height = 1 + (atFaces ? 100. * k * k : 50. * (k * k + (k + 1) * (k + 1)));
                        values.push_back(float(worldFunction({lon[std::size_t(n)], lat[std::size_t(n)], height}, 100)));
                    }
                file.add("XLONG", {t, y, x}, lon);
                file.add("XLAT", {t, y, x}, lat);
                file.add("PH", {t, zFaces, y, x}, perturbation, "m2 s-2");
                file.add("PHB", {t, zFaces, y, x}, base, "m2 s-2");
                file.add(atFaces ? "W" : "T", {t, atFaces ? zFaces : z, y, x}, values, "K");
            }
            const auto dataset =
                builtNetCdfReader().read(folder_.path("wrfout_d01"), {{"array", std::string(atFaces ? "W" : "T")}}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY2(distanceFromWorld(*dataset, 100) < 1e-3, formatNumber(distanceFromWorld(*dataset, 100)).c_str());
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Places),
                     std::string("XLONG, XLAT, height (PH + PHB) / 9.81 in m ?"));
        }
    }

    void sharedWrfCase()
    {
        const fs::path path = sharedCases() / "netcdf" / "wrf.nc";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = builtNetCdfReader().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->lattice.size, (std::array<std::uint32_t, 3>{7, 8, 6}));
        QVERIFY((dataset->position(0) - Eigen::Vector3d(5, 40, 0)).norm() < 1e-5);
        QVERIFY((dataset->position(7 * 8 + 7 + 1) - Eigen::Vector3d(5.11, 40.09, 1)).norm() < 1e-5);
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Places),
                 std::string("XLONG, XLAT, numbers of 'bottom_top' ?"));
    }

    void sharedEra5Case()
    {
        const fs::path path = sharedCases() / "netcdf" / "era5_packed.nc";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = builtNetCdfReader().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY((dataset->lattice.bounds().min() - Eigen::Vector3d(10, 50, 100)).norm() < 1e-9);
        QVERIFY((dataset->lattice.bounds().max() - Eigen::Vector3d(22, 60, 1300)).norm() < 1e-9);
        QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(9));
        QVERIFY(std::abs(dataset->values.range().minimum - 274.436) < 1e-6);
        QVERIFY(std::abs(dataset->values.range().maximum - 287.394) < 1e-6);
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Unit), std::string("K"));
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Fill), std::string("-32767"));
        QVERIFY(takenOf(dataset->source.taken, TakenPart::TimeStep)
                    .starts_with("1 of 2, 1900-02-11 16:00 (1000 hours since 1900"));
        const auto whole = complete(dataset);
        QVERIFY2(whole.ok(), whole.ok() ? "" : whole.error().text().c_str());
    }

private:
    NetCdfFolder folder_;
};

QTEST_GUILESS_MAIN(NetCdfPlacesTest)
#include "netcdf_places_test.moc"
