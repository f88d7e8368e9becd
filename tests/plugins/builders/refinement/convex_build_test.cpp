// SPDX-License-Identifier: GPL-3.0-or-later
/// C6, R1: the paper's class convex. Rectilinear grids and meshes of convex domain are refined as their points, without
/// warping; scattered points are decimated as their Delaunay mesh; what is not convex is refused. The checker proves
/// the models against the data as they came.
#include "plugins/builders/refinement/refinement_builder.h"
#include "plugins/readers/points/point_reader.h"
#include "tests/lacks.h"
#include "tests/verdict_text.h"

#include <tan/build.h>
#include <tan/verify.h>

#include <Eigen/Geometry>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <random>
#include <utility>

using namespace tetra;

using testing::textOf;

namespace {

const std::vector<Accuracy> levels = {{4, 4}, {3, 3}, {2, 2}, {1, 1}, {0.5, 0.5}, {0.2, 0.2}, {0.1, 0.1}, {0, 0}};

using Place = std::function<Eigen::Vector3d(int i, int j, int k)>;

constexpr std::array<std::uint32_t, 3> gridSize{8, 7, 6};

std::vector<Eigen::Vector3d> placesOf(const Place& place)
{
    std::vector<Eigen::Vector3d> places;
    for (std::uint32_t k = 0; k < gridSize[2]; ++k)
        for (std::uint32_t j = 0; j < gridSize[1]; ++j)
            for (std::uint32_t i = 0; i < gridSize[0]; ++i)
                places.push_back(place(int(i), int(j), int(k)));
    return places;
}

template <class Number> std::vector<Number> fieldAt(const std::vector<Eigen::Vector3d>& places)
{
    std::vector<Number> values;
    for (const Eigen::Vector3d& at : places)
        values.push_back(static_cast<Number>(std::sin(2 * at.x()) * at.y() + std::cos(at.z())));
    return values;
}

Dataset gridOf(const Place& place)
{
    const auto places = placesOf(place);
    return curvilinearDataset(gridSize, places, ScalarField::of(fieldAt<float>(places)), "grid").value();
}

/// The cells of a grid but for those that `isHole` names, cut into tetrahedra.
Dataset meshOf(
    const Place& place, const std::function<bool(int i, int j, int k)>& isHole = [](int, int, int) { return false; })
{
    const Lattice lattice{.size = gridSize};
    CellComplex complex;
    complex.positions = placesOf(place);
    complex.offsets.push_back(0);
    for (std::uint32_t k = 0; k + 1 < gridSize[2]; ++k)
        for (std::uint32_t j = 0; j + 1 < gridSize[1]; ++j)
            for (std::uint32_t i = 0; i + 1 < gridSize[0]; ++i) {
                if (isHole(int(i), int(j), int(k)))
                    continue;
                for (const std::uint32_t top : {0u, 1u}) // around the bottom, then around the top
                    for (const auto& [x, y] : {std::pair(0u, 0u), {1u, 0u}, {1u, 1u}, {0u, 1u}})
                        complex.corners.push_back(lattice.index(i + x, j + y, k + top));
                complex.shapes.push_back(CellShape::Hexahedron);
                complex.offsets.push_back(complex.corners.size());
            }
    return irregularDataset(complex, {fieldAt<double>(complex.positions), false}, {.name = "mesh", .path = {}}).value();
}

Eigen::Vector3d inBox(int i, int j, int k)
{
    return {0.3 * i, 0.25 * j, 0.2 * k};
}

/// Moved where it is inside.
Eigen::Vector3d inBoxAtRandom(int i, int j, int k)
{
    std::mt19937 random(static_cast<unsigned>(i + 10 * j + 100 * k));
    std::uniform_real_distribution<double> moved(-0.05, 0.05);
    const auto isInside = [](int index, std::uint32_t size) { return index > 0 && index + 1 < int(size); };
    Eigen::Vector3d place = inBox(i, j, k);
    place.x() += isInside(i, gridSize[0]) ? moved(random) : 0;
    place.y() += isInside(j, gridSize[1]) ? moved(random) : 0;
    place.z() += isInside(k, gridSize[2]) ? moved(random) : 0;
    return place;
}

/// Rounded, so that no side of the box is quite plane.
Eigen::Vector3d inTiltedBox(int i, int j, int k)
{
    const Eigen::AngleAxisd turn(0.4, Eigen::Vector3d(1, 2, 3).normalized());
    return (turn * inBoxAtRandom(i, j, k)).cast<float>().cast<double>();
}

/// Its sides swell, so that one diagonal of each of their squares lies inside the other.
Eigen::Vector3d inSwollenBox(int i, int j, int k)
{
    const Eigen::Vector3d at((2 * i - 7) / 7.0, (2 * j - 6) / 6.0, (2 * k - 5) / 5.0);
    return at * (1.2 - 0.1 * at.squaredNorm());
}

Eigen::Vector3d stretched(int i, int j, int k)
{
    return {0.1 * i * (1 + 0.2 * i), std::exp(0.1 * j), 0.1 * k * k * k + k};
}

} // namespace

class ConvexBuildTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }

    std::shared_ptr<const Model> built(const Dataset& dataset, const BuildMethod& method)
    {
        const auto report = buildModel(dataset, path(), method);
        if (!report)
            qWarning("%s", report.error().text().c_str());
        return report ? Model::open(path()).value() : nullptr;
    }

private slots:
    void convexDataAreRefined_data()
    {
        QTest::addColumn<Dataset>("dataset");
        QTest::addColumn<QString>("weights");
        QTest::newRow("cells of a lattice") << meshOf(inBox) << "";
        QTest::newRow("a box") << meshOf(inBoxAtRandom) << "";
        QTest::newRow("a box, weighted") << meshOf(inBoxAtRandom) << "point:0.5,0.5,0.5,0.4,0.05";
        QTest::newRow("a box whose coordinates are rounded") << meshOf(inTiltedBox) << "";
        QTest::newRow("rectilinear") << gridOf(stretched) << "";
        QTest::newRow("rectilinear, mirrored and turned") << gridOf([](int i, int j, int k) {
            const Eigen::Vector3d at = stretched(i, j, k);
            return Eigen::Vector3d(-at.z(), at.x(), -at.y());
        }) << "";
    }
    void convexDataAreRefined()
    {
        QFETCH(Dataset, dataset);
        QFETCH(QString, weights);
        QVERIFY(dataset.convex);
        QVERIFY(checkRefinement(dataset).ok());
        const auto model = built(dataset, Refinement{.weighting = parseWeighting(weights.toStdString()).value()});
        QVERIFY(model != nullptr);
        QCOMPARE(model->description().domain, DomainClass::Scattered);
        QCOMPARE(model->description().sourceHash, dataset.source.hash);
        QCOMPARE(model->description().warpingWeight, 0.0);
        const auto verdict = verify(*model, dataset, levels);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        QVERIFY(verdict->levels[0].sites < verdict->levels.back().sites);
        QVERIFY(verdict->levels.back().measured.error.largest < 1e-9);
    }

    /// One row for each thing that makes a domain not convex.
    void whatIsNotConvexIsRefused_data()
    {
        QTest::addColumn<Dataset>("dataset");
        QTest::newRow("a cavity") << meshOf(inBoxAtRandom,
                                            [](int i, int j, int k) { return i == 3 && j == 3 && k == 2; });
        QTest::newRow("two parts") << meshOf(inBox, [](int i, int, int) { return i == 3; });
        QTest::newRow("a hole through it") << meshOf(inBox, [](int i, int j, int) { return i == 3 && j == 3; });
        QTest::newRow("a notch") << meshOf(inBox, [](int i, int j, int k) { return i == 0 && j == 0 && k == 0; });
        QTest::newRow("diagonals bent inwards") << meshOf(inSwollenBox);
        QTest::newRow("a dent") << meshOf([](int i, int j, int k) -> Eigen::Vector3d {
            const Eigen::Vector3d at = inBox(i, j, k);
            return i == 0 && j == 3 && k == 3 ? Eigen::Vector3d(at.x() + 1e-4, at.y(), at.z()) : at;
        });
        // Each bend is small enough to be rounding.
        QTest::newRow("a hollow of many small bends") << meshOf([](int i, int j, int k) -> Eigen::Vector3d {
            const Eigen::Vector3d at = inBox(i, j, k);
            return k == 5 ? Eigen::Vector3d(at.x(), at.y(), at.z() + 1e-5 * (at.x() - 1) * (at.x() - 1)) : at;
        });
    }
    void whatIsNotConvexIsRefused()
    {
        QFETCH(Dataset, dataset);
        QVERIFY(!dataset.convex);
        const auto report = buildModel(dataset, path(), Refinement());
        QVERIFY(!report);
        QVERIFY2(report.error().text().find("not convex") != std::string::npos, report.error().text().c_str());
        // The checker finds it, too, in a model that is made all the same.
        const Dataset points = asPoints(dataset);
        const auto forged = writeModel(points, path(), "forged", [&](HistorySink& history) -> Status {
            BuildTarget target{.history = history};
            const auto built = buildInto(points, Refinement(), target, {});
            return built ? Status() : built.error();
        });
        QVERIFY(forged.ok());
        const auto verdict = verify(*Model::open(path()).value(), dataset, {{1}});
        QVERIFY2(!verdict->ok() && textOf(verdict).contains("takes the mesh as its points"),
                 qPrintable(textOf(verdict)));
    }

    void gridsThatBendAreCurvilinear()
    {
        const Dataset bent = gridOf([](int i, int j, int k) -> Eigen::Vector3d {
            return stretched(i, j, k) + Eigen::Vector3d(0, i == 3 && j == 3 && k == 3 ? 1e-9 : 0, 0);
        });
        QVERIFY(!bent.convex);
        QVERIFY(!gridOf([](int i, int j, int k) { return Eigen::Vector3d(i + 0.1 * j, j, k); }).convex);
        QVERIFY(!gridOf([](int i, int j, int k) { return Eigen::Vector3d(i == 4 ? 3 : i, j, k); }).convex);
        const auto model = built(bent, Refinement());
        QVERIFY(model != nullptr);
        QCOMPARE(model->description().domain, DomainClass::Curvilinear);
        const auto report = buildModel(bent, path(), Refinement{.computational = true});
        QVERIFY(!report && report.error().kind == ErrorKind::WrongUsage);
        // A model of its points would leave open what lies between them.
        const Dataset points = asPoints(bent);
        QVERIFY(buildModel(points, path(), Refinement()).ok());
        const auto verdict = verify(*Model::open(path()).value(), bent, {{1}});
        QVERIFY2(!verdict->ok() && textOf(verdict).contains("not rectilinear"), qPrintable(textOf(verdict)));
    }

    /// As all were once: with a warping, and of the same dataset.
    void rectilinearGridsMayBeCurvilinear()
    {
        const Dataset dataset = gridOf(stretched);
        const auto model = built(dataset, Refinement{.error = 1, .computational = true});
        QVERIFY(model != nullptr);
        QCOMPARE(model->description().domain, DomainClass::Curvilinear);
        QVERIFY(model->description().warpingWeight > 0);
        const auto verdict = verify(*model, dataset, {{4, 4}, {1, 1}});
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        for (const Refinement& refinement :
             {Refinement{.warping = 1}, Refinement{.block = 4}, Refinement{.paperSelection = true}}) {
            const auto refused = buildModel(dataset, path(), refinement);
            QVERIFY(!refused && refused.error().kind == ErrorKind::WrongUsage);
        }
    }

    /// C7: what a builder cannot do it refuses, whoever asks.
    void whatIsOfNoUseIsRefused()
    {
        const auto places = placesOf(inBox);
        const Dataset lattice =
            latticeDataset({.size = gridSize}, ScalarField::of(fieldAt<float>(places)), "l").value();
        const Dataset points = scatteredDataset(places, fieldAt<double>(places), "points").value();
        const Dataset mesh = meshOf(inBox);
        const auto isRefused = [this](const Dataset& dataset, const BuildMethod& method) {
            const auto report = buildModel(dataset, path(), method);
            return !report && report.error().kind == ErrorKind::WrongUsage;
        };
        for (const Dataset& dataset : {lattice, points, mesh})
            for (const Refinement& refinement :
                 {Refinement{.warping = 1}, Refinement{.paperSelection = true}, Refinement{.computational = true},
                  Refinement{.orderedBy = OrderedBy::Error}})
                QVERIFY(isRefused(dataset, refinement));
        for (const Dataset& dataset : {points, mesh})
            QVERIFY(isRefused(dataset, Refinement{.block = 4}));
        QVERIFY(isRefused(lattice, Decimation{.warping = 1}));
        QVERIFY(isRefused(lattice, Decimation{.orderedBy = OrderedBy::Warping}));
    }

    void pointsAreDecimated_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("at random") << "";
        QTest::newRow("of a lattice") << "lattice";
        for (const char* file : {"forge_probes.csv", "fiji_quakes.csv", "disk_out_ref_points.csv"})
            QTest::newRow(file) << file;
    }
    void pointsAreDecimated()
    {
        QFETCH(QString, file);
        const bool isReal = file.endsWith(".csv");
        const QString table = TAN_SOURCE_DIR "/../shared/data/scattered/" + file;
        if (isReal && !QFile::exists(table))
            QSKIP_WITHOUT("data");
        auto places = placesOf(file.isEmpty() ? Place(inBoxAtRandom) : Place(inBox));
        const auto values = fieldAt<double>(places);
        const auto dataset = isReal ? PointReader().read(table.toStdString(), {}, {})
                                    : scatteredDataset(std::move(places), values, "points");
        QVERIFY(dataset.ok());
        const auto model = built(*dataset, Decimation());
        QVERIFY(model != nullptr);
        QCOMPARE(model->description().domain, DomainClass::Irregular);
        QCOMPARE(model->description().sourceHash, dataset->source.hash);
        const auto verdict = verify(*model, *dataset, levels);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        QCOMPARE(std::uint64_t(model->siteCount()), dataset->pointCount());
        QVERIFY(verdict->levels.back().measured.error.largest < 1e-9);
        const auto refined = verify(*built(*dataset, Refinement()), *dataset, {{1}});
        qInfo("%llu points at 1 %%: %u decimated, %u refined", static_cast<unsigned long long>(dataset->pointCount()),
              verdict->levels[3].sites, refined->levels[0].sites);
    }

    /// The mesh is that of the points alone, and Delaunay: no point lies inside a tetrahedron's sphere.
    void theMeshOfPointsIsTheirs()
    {
        const auto places = placesOf(inBoxAtRandom);
        const auto dataset = scatteredDataset(places, fieldAt<double>(places), "points");
        const auto mesh = tetrahedrized(*dataset);
        QVERIFY(mesh.ok() && mesh->convex && hasConvexDomain(*mesh));
        double volume = 0;
        for (const auto& t : *mesh->tetrahedra) {
            const auto at = [&](std::size_t corner) { return (*mesh->positions)[t[corner]]; };
            const Eigen::Vector3d a = at(1) - at(0), b = at(2) - at(0), c = at(3) - at(0);
            const double six = a.dot(b.cross(c));
            QVERIFY(six > 0);
            volume += six / 6;
            if (six < 1e-9)
                continue; // a sphere that doubles do not tell
            const Eigen::Vector3d centre =
                at(0) + (a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)) /
                            (2 * six);
            const double radius = (at(0) - centre).norm();
            for (const Eigen::Vector3d& place : *mesh->positions)
                QVERIFY((place - centre).norm() > radius * (1 - 1e-6));
        }
        QVERIFY(std::abs(volume - 2.1 * 1.5 * 1.0) < 1e-9);
        auto flat = placesOf([](int i, int j, int) { return Eigen::Vector3d(i, j, 0.5 * i); });
        const auto none = scatteredDataset(std::move(flat), fieldAt<double>(places), "flat");
        QVERIFY(!tetrahedrized(*none) && !buildModel(*none, path(), Decimation()));
    }
};

QTEST_GUILESS_MAIN(ConvexBuildTest)
#include "convex_build_test.moc"
