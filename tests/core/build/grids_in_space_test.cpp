// SPDX-License-Identifier: GPL-3.0-or-later
// What is built of curvilinear grids unless something else is asked for keeps its error where the points lie (C12),
// judged tetrahedron by tetrahedron by arithmetic of this file's own.
#include "tests/core/history/folded_grids.h"
#include "tests/soak.h"
#include "tests/verdict_text.h"

#include <tan/build.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>

using namespace tetra;

namespace {

using Vector = Eigen::Vector3d;

/// The place of a triangle that is nearest to `to`, by the weights of its corners: in its plane, on a side, a corner.
Vector nearestWeightsOf(const std::array<Vector, 3>& corners, const Vector& to)
{
    const Vector u = corners[1] - corners[0], v = corners[2] - corners[0], normal = u.cross(v);
    std::vector<Vector> candidates{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int side = 0; side < 3; ++side) {
        const Vector& from = corners[static_cast<std::size_t>(side)];
        const Vector along = corners[static_cast<std::size_t>((side + 1) % 3)] - from;
        const double share = along.dot(to - from) / along.squaredNorm();
        if (!(share > 0 && share < 1))
            continue;
        Vector weights = Vector::Zero();
        weights[side] = 1 - share;
        weights[(side + 1) % 3] = share;
        candidates.push_back(weights);
    }
    const double b = (to - corners[0]).cross(v).dot(normal) / normal.squaredNorm();
    const double c = u.cross(to - corners[0]).dot(normal) / normal.squaredNorm();
    if (b > 0 && c > 0 && b + c < 1)
        candidates.emplace_back(1 - b - c, b, c);
    return *std::ranges::min_element(candidates, {}, [&](const Vector& w) {
        return (w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] - to).squaredNorm();
    });
}

/// A mesh among the points of a grid.
class Judge {
public:
    Judge(const TetrahedralMesh& mesh, const BentGrid& grid) : mesh_(mesh), grid_(grid)
    {
        std::map<std::array<std::uint32_t, 3>, std::pair<int, std::array<std::uint32_t, 3>>> faces;
        for (const auto& corners : mesh.tetrahedra)
            for (std::size_t left = 0; left < 4; ++left) {
                std::array<std::uint32_t, 3> face{};
                for (std::size_t i = 0, to = 0; i < 4; ++i)
                    if (i != left)
                        face[to++] = corners[i];
                auto key = face;
                std::ranges::sort(key);
                auto& [count, as] = faces[key];
                ++count;
                as = face;
            }
        for (const auto& [key, face] : faces)
            if (face.first == 1)
                boundary_.push_back(face.second);
    }

    /// In percent of the range: the closest of what the tetrahedra say that have the point; outside of all the closest
    /// of what the boundary says there where it is nearest, or within `warping`.
    double error(std::size_t point, double warping) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& corners : mesh_.tetrahedra)
            least = std::min(least, errorIn(corners, point));
        if (std::isinf(least))
            least = errorOutside(point, warping);
        return 100 * least / grid_.valueExtent();
    }

private:
    /// Infinite if the point is elsewhere.
    double errorIn(const std::array<std::uint32_t, 4>& corners, std::size_t point) const
    {
        constexpr double infinite = std::numeric_limits<double>::infinity(), rounding = 1e-9;
        const Vector& first = mesh_.positions[corners[0]];
        const Vector to = grid_.positions[point] - first;
        Eigen::Matrix3d edges;
        for (int i = 0; i < 3; ++i)
            edges.col(i) = mesh_.positions[corners[static_cast<std::size_t>(i + 1)]] - first;
        if ((to - edges.rowwise().maxCoeff().cwiseMax(0)).maxCoeff() > rounding ||
            (edges.rowwise().minCoeff().cwiseMin(0) - to).maxCoeff() > rounding || edges.determinant() == 0)
            return infinite;
        const Vector weights = edges.inverse() * to;
        if (std::min(weights.minCoeff(), 1 - weights.sum()) < -rounding)
            return infinite;
        double value = (1 - weights.sum()) * static_cast<double>(mesh_.values[corners[0]]);
        for (int i = 0; i < 3; ++i)
            value += weights[i] * static_cast<double>(mesh_.values[corners[static_cast<std::size_t>(i + 1)]]);
        return std::abs(value - grid_.values[point]);
    }

    double errorOutside(std::size_t point, double warping) const
    {
        double nearest = std::numeric_limits<double>::infinity(), error = 0;
        double within = std::numeric_limits<double>::infinity();
        for (const auto& face : boundary_) {
            std::array<Vector, 3> corners;
            Vector values;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = mesh_.positions[face[i]];
                values[static_cast<int>(i)] = static_cast<double>(mesh_.values[face[i]]);
            }
            const Vector weights = nearestWeightsOf(corners, grid_.positions[point]);
            const Vector place = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
            const double distance = (place - grid_.positions[point]).norm();
            const double here = std::abs(weights.dot(values) - grid_.values[point]);
            if (distance < nearest)
                std::tie(nearest, error) = std::tuple(distance, here);
            if (distance <= warping)
                within = std::min(within, here);
        }
        return std::min(error, within);
    }

    const TetrahedralMesh& mesh_;
    const BentGrid& grid_;
    std::vector<std::array<std::uint32_t, 3>> boundary_;
};

constexpr std::array<double, 8> levels{30, 20, 10, 4, 2, 1, 0.2, 0};

} // namespace

class GridsInSpaceTest : public QObject {
    Q_OBJECT

private slots:
    /// Even, folded, wrapped, collapsed.
    void theDefaultIsTrueInSpace()
    {
        std::mt19937 random(seedOf(7));
        int meshes = 0, others = 0;
        for (int number = 0; number < timesOf(24, 100); ++number) {
            const BentGrid grid = randomGrid(random);
            const Dataset dataset = datasetOfGrid(grid);
            if (!(grid.valueExtent() > 0) || cellsHaveNoVolume(dataset))
                continue;
            const auto built = buildModel(dataset, path());
            QVERIFY2(built.ok(), built ? "" : built.error().text().c_str());
            const auto model = Model::open(path());
            QVERIFY(model.ok());
            ((*model)->description().domain == DomainClass::Irregular ? meshes : others) += 1;
            judge(**model, dataset, grid, number);
            if (QTest::currentTestFailed())
                return;
        }
        QVERIFY2(meshes > 5 && others > 2, qPrintable(QString("%1 and %2").arg(meshes).arg(others)));
    }

    /// As a mesh a grid has all its samples, once on each place, and those alone.
    void aMeshOfAGridHasEverySample_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<std::size_t>("places");
        QTest::newRow("bent") << "bent" << std::size_t(9 * 8 * 7);
        QTest::newRow("left-handed") << "mirrored" << std::size_t(9 * 8 * 7);
        QTest::newRow("closed on itself") << "o-grid" << std::size_t(6 * 12 * 5);
    }
    void aMeshOfAGridHasEverySample()
    {
        QFETCH(QString, name);
        QFETCH(std::size_t, places);
        const BentGrid grid = name == "o-grid" ? oGrid({6, 13, 5}, 1.3, 1) : pulled({}, name == "mirrored");
        const Dataset dataset = datasetOfGrid(grid);
        QVERIFY(checkAsMesh(dataset).ok());
        const auto mesh = asMesh(dataset);
        QVERIFY2(mesh.ok(), mesh ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->domain, DomainClass::Irregular);
        QCOMPARE(mesh->source.hash, dataset.source.hash);
        QCOMPARE(mesh->positions->size(), places);
        for (std::size_t point = 0; point < grid.positions.size(); ++point) {
            const auto there = std::ranges::find(*mesh->positions, grid.positions[point]);
            QVERIFY(there != mesh->positions->end());
            QCOMPARE(mesh->values.at(static_cast<std::uint64_t>(there - mesh->positions->begin())), grid.values[point]);
        }
    }

    void whatIsNoMeshIsRefused()
    {
        for (const char* name : {"inside", "on the boundary", "a plane", "left-handed", "wrapped"}) {
            const Dataset folded = datasetOfGrid(foldedGridNamed(name));
            const Status quick = checkAsMesh(folded);
            QVERIFY2(!quick && !asMesh(folded), name);
            QVERIFY2(quick.error().text().find("folded") != std::string::npos, quick.error().text().c_str());
        }
        // A square that was made round and twisted: at its edges two sides of a cell lie in line, and no tetrahedra
        // fill it.
        const Dataset round = datasetOfGrid(bentGrid({25, 25, 4}, [](double x, double y, double z) {
            const double a = std::tanh(2.2 * (x / 12 - 1)) / std::tanh(2.2),
                         b = std::tanh(2.2 * (y / 12 - 1)) / std::tanh(2.2);
            const double inX = 1000 * a * std::sqrt(1 - b * b / 2), inY = 1000 * b * std::sqrt(1 - a * a / 2);
            const double turn = 0.015 * z;
            return Eigen::Vector3d(inX * std::cos(turn) - inY * std::sin(turn),
                                   inX * std::sin(turn) + inY * std::cos(turn), 130 * z);
        }));
        QVERIFY(!asMesh(round));
        QVERIFY(!checkAsMesh(round));
        QVERIFY(std::holds_alternative<Refinement>(suitableMethod(round)));
        QVERIFY(buildModel(round, path()).ok());
        BentGrid jump = oGrid({6, 13, 5}, 1.3, 1); // two values on one place
        jump.values[12 * 6] += 1;
        const Dataset torn = datasetOfGrid(jump);
        QVERIFY(!checkAsMesh(torn));
        const auto refused = asMesh(torn);
        QVERIFY(!refused);
        QVERIFY2(refused.error().text().find("another value") != std::string::npos, refused.error().text().c_str());
        QVERIFY(std::holds_alternative<Refinement>(suitableMethod(torn)));
    }

private:
    static bool cellsHaveNoVolume(const Dataset& dataset)
    {
        return !curvilinearDataset(dataset.lattice.size, *dataset.positions, dataset.values, "grid");
    }

    void judge(const Model& model, const Dataset& dataset, const BentGrid& grid, int number) const
    {
        std::vector<Accuracy> asked;
        for (const double level : levels)
            asked.push_back({level, level});
        const auto verdict = verify(model, dataset, asked);
        QVERIFY2(verdict.ok() && verdict->ok(),
                 qPrintable(QString("grid %1: %2").arg(number).arg(testing::textOf(verdict))));
        for (const Accuracy& accuracy : asked) {
            const MeshSize size = meshSizeAt(model, accuracy);
            const auto mesh = extractPrefix(model, size.sites);
            QVERIFY(mesh.ok());
            const Judge of(*mesh, grid);
            for (std::size_t point = 0; point < grid.positions.size(); ++point) {
                const double error = of.error(point, accuracy.warping / 100 * grid.diagonal() + 1e-9);
                QVERIFY2(error <= accuracy.error + 1e-4, qPrintable(QString("grid %1, point %2: %3 % instead of %4 %")
                                                                        .arg(number)
                                                                        .arg(point)
                                                                        .arg(error)
                                                                        .arg(accuracy.error)));
            }
        }
    }

    std::filesystem::path path() const { return folder_.filePath("grid.tan").toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(GridsInSpaceTest)
#include "grids_in_space_test.moc"
