// SPDX-License-Identifier: GPL-3.0-or-later
// Marching tetrahedra (R19) with the symbolic tie rule (S16).
#include "core/render/isosurface/isosurface.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/same_surface.h"

#include <tan/render.h>

#include <Eigen/LU>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <numbers>
#include <random>

using namespace tetra;
using Eigen::Vector3d;
using testing::latticeMesh;
using testing::Split;

namespace {

TriangleMesh extracted(const TetrahedralMesh& mesh, double isovalue)
{
    const auto gradients = vertexGradients(mesh);
    auto surface = extractIsosurface(mesh, gradients, isovalue);
    if (!surface)
        qFatal("%s", surface.error().text().c_str());
    return std::move(surface).value();
}

Vector3d cornerOf(const TriangleMesh& surface, std::size_t triangle, std::size_t corner)
{
    return surface.positions[surface.triangles[triangle][corner]].cast<double>();
}

/// Twice the area, along the normal.
Vector3d areaVector(const TriangleMesh& surface, std::size_t triangle)
{
    const Vector3d a = cornerOf(surface, triangle, 0);
    return (cornerOf(surface, triangle, 1) - a).cross(cornerOf(surface, triangle, 2) - a);
}

double areaOf(const TriangleMesh& surface)
{
    double area = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        area += areaVector(surface, t).norm() / 2;
    return area;
}

/// What the surface encloses, positive if the fronts look outwards.
double volumeOf(const TriangleMesh& surface)
{
    double volume = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        volume += areaVector(surface, t).dot(cornerOf(surface, t, 0)) / 6;
    return volume;
}

struct EdgeUse {
    int forwards = 0;
    int backwards = 0;
};

std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edgesOf(const TriangleMesh& surface)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges;
    for (const auto& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = t[i];
            const auto b = t[(i + 1) % 3];
            EdgeUse& use = edges[std::minmax(a, b)];
            ++(a < b ? use.forwards : use.backwards);
        }
    return edges;
}

bool onSameSideOfBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b, float extent)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == extent))
            return true;
    return false;
}

bool isLatticePoint(const Eigen::Vector3d& point)
{
    return point == Eigen::Vector3d(point.array().round());
}

/// A field on the unit lattice with `levels` different integer values: with few, most vertices lie on an integer
/// isovalue.
auto randomField(unsigned seed, int levels)
{
    return [random = std::mt19937(seed), levels](const Vector3d&) mutable {
        return static_cast<double>(random() % static_cast<unsigned>(levels));
    };
}

} // namespace

class IsosurfaceTest : public QObject {
    Q_OBJECT

private slots:
    void closedOnRandomData_data()
    {
        QTest::addColumn<Split>("split");
        QTest::addColumn<int>("levels");
        QTest::addColumn<double>("isovalue");
        for (const auto& [name, split] : {std::pair{"5", Split::Five}, std::pair{"6", Split::Six}})
            for (const auto& [levels, isovalue] :
                 {std::pair{2, 1.0}, {2, 0.5}, {3, 1.0}, {3, 2.0}, {5, 2.0}, {5, 1.5}, {50, 25.0}, {1000, 500.0}})
                QTest::addRow("%s tetrahedra, %d levels, isovalue %g", name, levels, isovalue)
                    << split << levels << isovalue;
    }
    /// As a chain of oriented triangles the surface has no boundary inside the domain, and but for places where the
    /// inside touches itself along an edge of the mesh, each edge has exactly two triangles.
    void closedOnRandomData()
    {
        QFETCH(Split, split);
        QFETCH(int, levels);
        QFETCH(double, isovalue);
        constexpr std::uint32_t cells = 9;
        for (unsigned seed = 0; seed < 5; ++seed) {
            const auto mesh = latticeMesh(cells, cells, split, randomField(seed, levels));
            const TriangleMesh surface = extracted(mesh, isovalue);
            QVERIFY(!surface.triangles.empty());
            for (const auto& [edge, use] : edgesOf(surface)) {
                const auto& a = surface.positions[edge.first];
                const auto& b = surface.positions[edge.second];
                if (onSameSideOfBox(a, b, cells))
                    continue;
                QCOMPARE(use.forwards, use.backwards);
                if (!(isLatticePoint(a) && isLatticePoint(b)))
                    QCOMPARE(use.forwards, 1);
            }
        }
    }

    void noTriangleWithoutArea()
    {
        const auto mesh = latticeMesh(9, 9, Split::Six, randomField(7, 3));
        const TriangleMesh surface = extracted(mesh, 1);
        QVERIFY(!surface.triangles.empty());
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            QVERIFY(areaVector(surface, t).norm() > 0);
    }

    /// The tie rule itself: a vertex on the isovalue is inside, so a lone one has a surface around it, of no size, and
    /// a lone hole is cut out.
    void tieIsInside()
    {
        const auto peak = [](double inside, double rest) {
            return latticeMesh(2, 2, Split::Five,
                               [=](const Vector3d& p) { return p == Vector3d(1, 1, 1) ? inside : rest; });
        };
        QVERIFY(extracted(peak(5, 0), 5).triangles.empty());
        QVERIFY(!extracted(peak(5, 0), 4.5).triangles.empty());
        const TriangleMesh hole = extracted(peak(0, 5), 5);
        QVERIFY(!hole.triangles.empty());
        for (const auto& position : hole.positions)
            QVERIFY(isLatticePoint(position));
    }

    /// A fraction of an edge that rounds to its end is a tie, too: here the positions leave no room for the difference.
    void closedWhenPositionsRound()
    {
        constexpr std::uint32_t cells = 6;
        std::mt19937 random(3);
        auto mesh = latticeMesh(cells, cells, Split::Five, [&](const Vector3d&) {
            const double sign = random() % 2 == 0 ? 1 : -1;
            return sign * std::pow(10.0, -static_cast<double>(random() % 12));
        });
        for (auto& position : mesh.positions)
            position.array() += 1e6f;
        const TriangleMesh surface = extracted(mesh, 0);
        QVERIFY(!surface.triangles.empty());
        for (const auto& [edge, use] : edgesOf(surface)) {
            const Eigen::Vector3d a = surface.positions[edge.first].array() - 1e6f;
            const Eigen::Vector3d b = surface.positions[edge.second].array() - 1e6f;
            if (!onSameSideOfBox(a, b, cells))
                QCOMPARE(use.forwards, use.backwards);
        }
    }

    /// In double precision the field at each vertex of the surface, interpolated on its edge, is the isovalue.
    void verticesLieOnTheIsovalue()
    {
        const auto field = [](const Vector3d& p) { return 3 * p.x() - 2 * p.y() + p.z() + 0.5; }; // linear everywhere
        const auto mesh = latticeMesh(8, 8, Split::Six, field);
        for (const double isovalue : {0.5, 3.3, 7.25}) {
            const TriangleMesh surface = extracted(mesh, isovalue);
            QVERIFY(!surface.positions.empty());
            for (const auto& position : surface.positions)
                QVERIFY(std::abs(field(position.cast<double>()) - isovalue) < 1e-5);
        }
    }

    void planeHasItsExactArea()
    {
        const auto sum = [](const Vector3d& p) { return p.sum(); };
        for (const Split split : {Split::Five, Split::Six}) {
            const auto mesh = latticeMesh(6, 1, split, sum);
            const TriangleMesh hexagon = extracted(mesh, 1.5);
            QVERIFY(std::abs(areaOf(hexagon) - 3 * std::sqrt(3.0) / 4) < 1e-5);
            for (const auto& normal : hexagon.normals) // towards smaller values
                QVERIFY((normal + Eigen::Vector3f::Constant(std::sqrt(1 / 3.0f))).norm() < 1e-5f);
            for (std::size_t t = 0; t < hexagon.triangles.size(); ++t)
                QVERIFY(areaVector(hexagon, t).dot(Vector3d(-1, -1, -1)) > 0);
        }
    }

    /// Area and volume of a sphere come nearer with the square of the edge's length.
    void sphereConverges()
    {
        constexpr double radius = 0.37;
        const Vector3d centre(0.5, 0.48, 0.51);
        const auto field = [&](const Vector3d& p) { return radius - (p - centre).norm(); };
        double areaError = 0;
        double volumeError = 0;
        for (const std::uint32_t cells : {8u, 16u, 32u}) {
            const TriangleMesh surface = extracted(latticeMesh(cells, 1, Split::Five, field), 0);
            for (const auto& [edge, use] : edgesOf(surface)) {
                QCOMPARE(use.forwards, 1);
                QCOMPARE(use.backwards, 1);
            }
            for (std::size_t v = 0; v < surface.positions.size(); ++v) {
                const Vector3d outwards = (surface.positions[v].cast<double>() - centre).normalized();
                QVERIFY(surface.normals[v].cast<double>().dot(outwards) > (cells == 8 ? 0.97 : 0.99));
                QVERIFY(std::abs(surface.normals[v].norm() - 1) < 1e-5f);
            }
            const double lastArea = areaError;
            const double lastVolume = volumeError;
            areaError = std::abs(areaOf(surface) - 4 * std::numbers::pi * radius * radius);
            volumeError = std::abs(volumeOf(surface) - 4 * std::numbers::pi / 3 * std::pow(radius, 3));
            QVERIFY(volumeOf(surface) > 0);
            if (cells > 8) {
                QVERIFY(areaError < lastArea / 3);
                QVERIFY(volumeError < lastVolume / 3);
            }
        }
        QVERIFY(areaError < 0.006);
        QVERIFY(volumeError < 0.001);
    }

    void gradientsAreExactOnLinearFields()
    {
        const auto mesh =
            latticeMesh(5, 2, Split::Five, [](const Vector3d& p) { return 2 * p.x() - 7 * p.y() + p.z(); });
        const auto gradients = vertexGradients(mesh);
        QCOMPARE(gradients.size(), mesh.positions.size());
        for (const auto& gradient : gradients)
            QVERIFY((gradient - Eigen::Vector3f(2, -7, 1)).norm() < 1e-4f);
    }

    /// Tetrahedra with a corner that has no number leave the others' gradients alone.
    void gradientsBesideWhatIsNoNumber()
    {
        const double nowhere = std::numeric_limits<double>::quiet_NaN();
        for (const double missing : {nowhere, std::numeric_limits<double>::infinity()}) {
            const auto mesh = latticeMesh(5, 2, Split::Five, [&](const Vector3d& p) {
                return p == Vector3d(0, 0, 0) ? missing : 2 * p.x() - 7 * p.y() + p.z();
            });
            const auto gradients = vertexGradients(mesh);
            std::size_t exact = 0;
            for (const auto& gradient : gradients) {
                QVERIFY(gradient.allFinite());
                exact += (gradient - Eigen::Vector3f(2, -7, 1)).norm() < 1e-4f ? 1 : 0;
            }
            QVERIFY(exact >= gradients.size() - 1); // all but the corner itself
        }
    }

    /// A sheet of the isovalue between equal values: the gradients cancel at it, so the triangles give the normals.
    void normalsWhereTheGradientVanishes()
    {
        const auto ridge = [](const Vector3d& p) { return p.x() == 1 ? 1.0 : 0.0; };
        for (const double isovalue : {0.5, 1.0, 1e-30}) {
            const TriangleMesh surface = extracted(latticeMesh(2, 2, Split::Six, ridge), isovalue);
            for (const auto& normal : surface.normals)
                QVERIFY(std::abs(normal.norm() - 1) < 1e-5f);
        }
        const auto infinite = [](const Vector3d& p) {
            return p.x() < 1 ? -std::numeric_limits<double>::infinity() : p.y() < 1 ? 1e38 : std::nan("");
        };
        const TriangleMesh surface = extracted(latticeMesh(3, 3, Split::Six, infinite), 0);
        QVERIFY(!surface.triangles.empty());
        for (std::size_t v = 0; v < surface.positions.size(); ++v)
            QVERIFY(surface.positions[v].allFinite() && std::abs(surface.normals[v].norm() - 1) < 1e-5f);
    }

    /// In spatial order and by an index it is the same surface, whatever is passed over: fields with and without ties
    /// and NaN, in several runs.
    /// Each triangle lies in its tetrahedron, and the surface is the one that is made without them (R17, C2), also
    /// where triangles are left out because corners of the mesh have the isovalue.
    void trianglesKnowTheirCells()
    {
        for (const Split split : {Split::Five, Split::Six}) {
            const auto mesh = latticeMesh(9, 9, split, randomField(5, 4));
            const auto gradients = vertexGradients(mesh);
            for (const double isovalue : {1.0, 2.0, 1.3}) {
                Buffer<std::uint32_t> cells;
                const auto surface = extractIsosurface(mesh, gradients, isovalue, {}, &cells);
                QVERIFY(surface.ok() && !surface->triangles.empty());
                QVERIFY(surface->triangles == extracted(mesh, isovalue).triangles);
                QCOMPARE(cells.size(), surface->triangles.size());
                QVERIFY(std::ranges::is_sorted(cells));
                for (std::size_t t = 0; t < cells.size(); ++t) {
                    const auto& cell = mesh.tetrahedra[cells[t]];
                    Eigen::Matrix4d corners;
                    for (int i = 0; i < 4; ++i)
                        corners.col(i) << mesh.positions[cell[static_cast<std::size_t>(i)]].cast<double>(), 1;
                    for (std::size_t corner = 0; corner < 3; ++corner) {
                        Eigen::Vector4d place;
                        place << cornerOf(*surface, t, corner), 1;
                        QVERIFY((corners.inverse() * place).minCoeff() > -1e-4);
                    }
                }
            }
        }
    }

    void sameByIndex()
    {
        std::mt19937 random(21);
        for (const int levels : {2, 3, 20, 100000})
            for (const bool smooth : {false, true}) {
                auto mesh = latticeMesh(24, 1, Split::Six, [&](const Vector3d& p) {
                    const double noise = static_cast<double>(random() % static_cast<unsigned>(levels));
                    return smooth ? std::floor(levels * (p - Vector3d(0.4, 0.5, 0.6)).norm()) : noise;
                });
                if (levels == 20)
                    for (float& value : mesh.values)
                        value = random() % 40 == 0 ? std::nanf("") : value;
                QVERIFY(mesh.tetrahedra.size() > surfaceChunkSize);
                const auto ordered = inSpatialOrder(mesh).value();
                const auto index = makeIsosurfaceIndex(ordered);
                const auto gradients = vertexGradients(ordered);
                for (const double isovalue : {levels * 0.45, 1.0, -1.0}) {
                    const TriangleMesh plain = extracted(mesh, isovalue);
                    const auto indexed = extractIsosurface(ordered, index, gradients, isovalue);
                    QVERIFY(testing::sameSurface(plain, indexed.value()));
                    if (isovalue != 1)
                        continue;
                    const auto unordered =
                        extractIsosurface(mesh, makeIsosurfaceIndex(mesh), vertexGradients(mesh), isovalue);
                    QVERIFY(testing::sameSurface(plain, unordered.value()));
                }
            }
    }

    void sameWithAnyNumberOfThreads()
    {
        const auto mesh = latticeMesh(30, 1, Split::Six, randomField(11, 40));
        const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 5);
        const auto run = [&](int threads) {
            tbb::task_arena arena(threads);
            return arena.execute([&] { return std::pair(vertexGradients(mesh), extracted(mesh, 20)); });
        };
        const auto runByIndex = [&](int threads) {
            tbb::task_arena arena(threads);
            return arena.execute(
                [&] { return extractIsosurface(mesh, makeIsosurfaceIndex(mesh), vertexGradients(mesh), 20).value(); });
        };
        const TriangleMesh indexed = runByIndex(1);
        const auto one = run(1);
        for (const int threads : {2, 5, 64}) {
            const auto many = run(threads);
            QVERIFY(many.first == one.first);
            QVERIFY(many.second.triangles == one.second.triangles);
            QVERIFY(many.second.positions == one.second.positions);
            QVERIFY(many.second.normals == one.second.normals);
            const TriangleMesh manyIndexed = runByIndex(threads);
            QVERIFY(manyIndexed.triangles == indexed.triangles);
            QVERIFY(manyIndexed.positions == indexed.positions);
            QVERIFY(manyIndexed.normals == indexed.normals);
        }
    }

    /// Told by the processor's time, which other programs do not change: threads share the tetrahedra out among them.
    /// So many tetrahedra that starting the threads does not count.
    void gradientsOfManyThreadsAreNoMoreWork()
    {
        const auto mesh = latticeMesh(112, 1, Split::Six, randomField(3, 40));
        const auto processorSeconds = [&](int threads) {
            tbb::task_arena arena(threads);
            double least = std::numeric_limits<double>::infinity();
            for (int round = 0; round < 3; ++round) {
                timespec before{}, after{};
                ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
                arena.execute([&] { return vertexGradients(mesh).size(); });
                ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
                least = std::min(least, static_cast<double>(after.tv_sec - before.tv_sec) +
                                            1e-9 * static_cast<double>(after.tv_nsec - before.tv_nsec));
            }
            return least;
        };
        const double one = processorSeconds(1), many = processorSeconds(64);
        QVERIFY2(many < 6 * one, qPrintable(QString("%1 s in place of %2 s").arg(many).arg(one)));
    }

    void emptyAndWrong()
    {
        QVERIFY(extracted({}, 1).triangles.empty());
        const auto mesh = latticeMesh(2, 2, Split::Six, [](const Vector3d& p) { return p.x(); });
        QVERIFY(extracted(mesh, 100).triangles.empty());
        QVERIFY(extracted(mesh, -100).triangles.empty());
        QCOMPARE(extractIsosurface(mesh, {}, 1).error().kind, ErrorKind::WrongUsage);
        const auto gradients = vertexGradients(mesh);
        QCOMPARE(extractIsosurface(mesh, gradients, std::nan("")).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(extractIsosurface(mesh, IsosurfaceIndex(), gradients, 1).error().kind, ErrorKind::WrongUsage);
    }

    void cancels()
    {
        const auto mesh = latticeMesh(4, 1, Split::Six, [](const Vector3d& p) { return p.x(); });
        const auto gradients = vertexGradients(mesh);
        std::stop_source stop;
        double last = -1;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            QVERIFY(fraction >= last && fraction <= 1);
            last = fraction;
        });
        QVERIFY(extractIsosurface(mesh, gradients, 0.5, progress).ok());
        QCOMPARE(last, 1.0);
        stop.request_stop();
        last = -1;
        QCOMPARE(extractIsosurface(mesh, gradients, 0.5, progress).error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(IsosurfaceTest)
#include "isosurface_test.moc"
