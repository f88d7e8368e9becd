// SPDX-License-Identifier: GPL-3.0-or-later
// The default isovalue finds the surface of fields that have one, whatever their units, noise and mesh.
#include "tests/core/render/lattice_mesh.h"

#include <tan/render.h>

#include <QTest>

#include <cmath>
#include <random>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

constexpr std::uint32_t cells = 24;
constexpr double extent = 2;
constexpr double cellSide = extent / cells;

/// From `inside` to `outside` across a sphere, by a slope of this width.
struct BallField {
    double radius;
    double width;
    double inside;
    double outside;

    double at(double distance) const
    {
        return std::lerp(inside, outside, 0.5 + 0.5 * std::tanh((distance - radius) / width));
    }
    double operator()(const Vector3d& point) const { return at((point - Vector3d::Constant(extent / 2)).norm()); }
    /// From the middle to where the field has this value.
    double distanceOf(double value) const
    {
        return radius +
               width * std::atanh(std::clamp(2 * (value - inside) / (outside - inside) - 1, -0.999999, 0.999999));
    }
};

double foundIn(const TetrahedralMesh& mesh)
{
    const auto [least, largest] = std::ranges::minmax(mesh.values);
    const auto value = surfaceValue(mesh, least, largest);
    return value ? *value : std::nan("");
}

} // namespace

class SurfaceValueTest : public QObject {
    Q_OBJECT

private slots:
    void findsABall_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("inside");
        QTest::addColumn<double>("outside");
        QTest::addColumn<double>("noise");
        for (const double radius : {0.3, 0.8})
            for (const double width : {0.001, 0.1, 0.3})
                for (const double noise : {0.0, 0.005}) {
                    if (noise > 0 && width > radius / 2)
                        continue; // hardly steeper than the noise: no surface
                    QTest::addRow("%g %g bright %g", radius, width, noise) << radius << width << 1000.0 << 0.0 << noise;
                    QTest::addRow("%g %g dark %g", radius, width, noise) << radius << width << -2e-6 << 5e-6 << noise;
                }
    }
    /// The surface lies within a cell of the ball's, or where its gradient is hardly less than at its steepest.
    void findsABall()
    {
        QFETCH(double, radius);
        QFETCH(double, width);
        QFETCH(double, inside);
        QFETCH(double, outside);
        QFETCH(double, noise);
        const BallField ball{radius, width, inside, outside};
        for (const Split split : {Split::Five, Split::Six}) {
            std::mt19937 random(7);
            std::normal_distribution<double> spread(0, noise * std::abs(inside - outside));
            const double value = foundIn(latticeMesh(cells, extent, split, [&](const Vector3d& point) {
                return ball(point) + (noise > 0 ? spread(random) : 0);
            }));
            const double off = std::abs(ball.distanceOf(value) - radius);
            QVERIFY2(off <= std::max(cellSide, 0.6 * width), qPrintable(QString::number(value)));
        }
    }

    /// A few values far above all others, as of metal in a scan: half of the range has next to nothing in it.
    void isNotMisledByOutliers()
    {
        const BallField ball{0.7, 0.1, 1000, 0};
        for (const double outlier : {-1000.0, 4000.0}) {
            std::uint32_t count = 0;
            const double value = foundIn(latticeMesh(cells, extent, Split::Six, [&](const Vector3d& point) {
                return ++count % 5003 == 0 ? outlier : ball(point);
            }));
            QVERIFY2(std::abs(ball.distanceOf(value) - 0.7) <= cellSide, qPrintable(QString::number(value)));
        }
    }

    /// Air, tissue and bone: the surface is that of one of the two, not noise within the tissue.
    void separatesMaterials()
    {
        const BallField skin{0.85, 0.05, 1000, 0}, bone{0.6, 0.05, 900, 0};
        std::mt19937 random(5);
        std::normal_distribution<double> spread(0, 15);
        const double value = foundIn(latticeMesh(
            48, extent, Split::Six, [&](const Vector3d& point) { return skin(point) + bone(point) + spread(random); }));
        QVERIFY2((value > 200 && value < 800) || (value > 1200 && value < 1700), qPrintable(QString::number(value)));
    }

    void unitsDoNotMatter()
    {
        const BallField ball{0.5, 0.2, 1, 0};
        const double one = foundIn(latticeMesh(cells, extent, Split::Six, ball));
        const double other = foundIn(latticeMesh(cells, 1000 * extent, Split::Six,
                                                 [&](const Vector3d& point) { return 64 * ball(point / 1000); }));
        QVERIFY(std::abs(other - 64 * one) < 1);
    }

    /// Flat cells, as Delaunay meshes have them, have gradients across them that no data have.
    void flatCellsDoNotCount()
    {
        const BallField ball{0.6, 0.2, 1, 0};
        TetrahedralMesh mesh = latticeMesh(cells, extent, Split::Six, ball);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Eigen::Vector3d& place : {Eigen::Vector3d(0, 0, 0), {2, 0, 1e-4F}, {2, 2, 0}, {0, 2, 1e-4F}})
            mesh.positions.push_back(place);
        for (const float value : {0.97F, 0.99F, 0.97F, 0.99F})
            mesh.values.push_back(value);
        for (int turn = 0; turn < 50; ++turn)
            mesh.tetrahedra.push_back({first, first + 1, first + 2, first + 3});
        QVERIFY(std::abs(ball.distanceOf(foundIn(mesh)) - 0.6) <= 2 * cellSide);
    }

    void nothingToFind()
    {
        const TetrahedralMesh flat = latticeMesh(4, extent, Split::Six, [](const Vector3d&) { return 3.0; });
        QVERIFY(!surfaceValue(flat, 3, 3));
        QVERIFY(!surfaceValue(flat, 0, 10));
        QVERIFY(!surfaceValue({}, 0, 1));
        QVERIFY(!surfaceValue(flat, std::nan(""), 1));
    }

    void isTheSameEachTime()
    {
        const BallField ball{0.5, 0.2, 1, 0};
        const TetrahedralMesh mesh = latticeMesh(cells, extent, Split::Five, ball);
        const double value = foundIn(mesh);
        for (int turn = 0; turn < 3; ++turn)
            QCOMPARE(foundIn(mesh), value);
    }
};

QTEST_GUILESS_MAIN(SurfaceValueTest)
#include "surface_value_test.moc"
