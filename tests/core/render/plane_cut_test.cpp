// SPDX-License-Identifier: GPL-3.0-or-later
// A plane cut through a mesh, against what is known of the cut of a filled cube.
#include "tests/core/render/lattice_mesh.h"

#include <tan/render.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <stop_token>

using namespace tetra;
using Eigen::Vector3d;
using testing::latticeMesh;
using testing::Split;

namespace {

constexpr double extent = 5;
constexpr std::uint32_t cells = 4;

double linear(const Vector3d& place)
{
    return 0.25 + place.dot(Vector3d(1, -0.5, 2));
}

HalfSpace unitOf(const HalfSpace& plane)
{
    return {plane.normal.normalized(), plane.offset / plane.normal.norm()};
}

/// The area of the polygon in which a plane meets the cube: its corners lie on the cube's edges, around their middle.
double areaInCube(const HalfSpace& plane)
{
    std::vector<Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 4; ++side) {
            Vector3d begin = Vector3d::Zero();
            begin[(axis + 1) % 3] = side % 2 == 0 ? 0 : extent;
            begin[(axis + 2) % 3] = side < 2 ? 0 : extent;
            const double slope = plane.normal[axis], along = (plane.offset - plane.normal.dot(begin)) / slope;
            if (slope != 0 && along > -1e-9 && along < extent + 1e-9)
                corners.push_back(begin + along * Vector3d::Unit(axis));
        }
    if (corners.size() < 3)
        return 0;
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : corners)
        middle += corner / double(corners.size());
    const Vector3d right = plane.normal.unitOrthogonal(), up = plane.normal.cross(right);
    std::ranges::sort(corners, {}, [&](const Vector3d& corner) {
        return std::atan2((corner - middle).dot(up), (corner - middle).dot(right));
    });
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += (corners[i] - middle).cross(corners[(i + 1) % corners.size()] - middle).norm() / 2;
    return area;
}

MeshCut cutOf(const TetrahedralMesh& mesh, const HalfSpace& plane)
{
    auto cut = cutByPlane(mesh, plane);
    if (!cut)
        qFatal("%s", cut.error().text().c_str());
    return *std::move(cut);
}

/// Along the plane's normal: where a triangle is turned round it counts against the others.
double areaAlong(const Vector3d& normal, const TriangleMesh& surface)
{
    double area = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const Vector3d corner = surface.positions[a].cast<double>();
        const Vector3d one = surface.positions[b].cast<double>() - corner;
        const Vector3d other = surface.positions[c].cast<double>() - corner;
        area += one.cross(other).dot(normal) / 2;
    }
    return area;
}

} // namespace

class PlaneCutTest : public QObject {
    Q_OBJECT

private slots:
    void cutOfACube_data()
    {
        QTest::addColumn<Split>("split");
        QTest::addColumn<HalfSpace>("plane");
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(-1, 1), place(0.1 * extent, 0.9 * extent);
        for (const auto& [name, split] : {std::pair{"5", Split::Five}, std::pair{"6", Split::Six}}) {
            const auto row = [&, split = split, name = name](const char* what, int which, const HalfSpace& plane) {
                QTest::addRow("%s tetrahedra, %s %d", name, what, which) << split << plane;
            };
            for (int i = 0; i < 25; ++i) {
                const Vector3d normal(number(random), number(random), number(random));
                row("any", i, {normal, normal.dot(Vector3d(place(random), place(random), place(random)))});
            }
            for (int axis = 0; axis < 3; ++axis) {
                row("between the planes of the lattice", axis, {Vector3d::Unit(axis), 0.3 * extent});
                row("along faces", axis, {-2 * Vector3d::Unit(axis), -extent}); // half way: a plane of the lattice
            }
            row("through edges and vertices", 0, {{1, 1, 0}, extent});
            row("through edges and vertices", 1, {{1, 1, 1}, 1.5 * extent});
            row("of another length", 0, {{1e-20, 2e-20, 0}, 1e-20 * extent});
        }
    }
    /// Where the plane passes through vertices the cut still has no gap and nothing twice.
    void cutOfACube()
    {
        QFETCH(Split, split);
        QFETCH(HalfSpace, plane);
        const TetrahedralMesh mesh = latticeMesh(cells, extent, split, linear);
        const MeshCut cut = cutOf(mesh, plane);
        const TriangleMesh& surface = cut.surface;
        const HalfSpace unit = unitOf(plane);
        const std::size_t count = surface.positions.size();
        QVERIFY(count > 2 && surface.normals.size() == count && surface.values.size() == count);
        QCOMPARE(cut.points.size(), count);
        constexpr double rounding = 1e-6 * extent; // of floats
        for (std::size_t v = 0; v < count; ++v) {
            const Vector3d place = surface.positions[v].cast<double>();
            QVERIFY(std::abs(unit.normal.dot(place) - unit.offset) < rounding);
            QVERIFY(std::abs(static_cast<double>(surface.values[v]) - linear(place)) < 5 * rounding);
            QVERIFY((surface.normals[v].cast<double>() - unit.normal).norm() < 1e-6);
            const auto& [from, to, share] = cut.points[v];
            const Vector3d begin = mesh.positions[from].cast<double>(), end = mesh.positions[to].cast<double>();
            QVERIFY(share >= 0 && share <= 1 && (begin + share * (end - begin) - place).norm() < rounding);
        }
        const double area = areaInCube(unit);
        QVERIFY2(area > 0.1 && std::abs(areaAlong(unit.normal, surface) - area) < 1e-5 * area,
                 QByteArray::number(areaAlong(unit.normal, surface) / area, 'g', 10));
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        std::set<std::uint32_t> corners;
        for (const auto& triangle : surface.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                edges.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
                corners.insert(triangle[i]);
            }
        const auto size = [](const auto& set) { return static_cast<int>(set.size()); };
        QCOMPARE(size(corners) - size(edges) + size(surface.triangles), 1); // a disc, whose triangles share vertices
    }

    /// Faces belong to the tetrahedra outside of the half-space.
    void atTheDomainsSides()
    {
        const TetrahedralMesh mesh = latticeMesh(cells, extent, Split::Six, linear);
        const Vector3d up = Vector3d::UnitZ();
        QVERIFY(std::abs(areaAlong(up, cutOf(mesh, {up, 0}).surface) - extent * extent) < 1e-5);
        for (const double height : {extent, extent + 1, -1.0}) {
            const MeshCut none = cutOf(mesh, {up, height});
            QVERIFY(none.surface.triangles.empty());
        }
        QVERIFY(cutOf({}, {up, 0}).surface.positions.empty());
    }

    void wrongUseIsRefused()
    {
        TetrahedralMesh mesh = latticeMesh(2, extent, Split::Five, linear);
        const auto refused = [&](const HalfSpace& plane) {
            const auto cut = cutByPlane(mesh, plane);
            return !cut && cut.error().kind == ErrorKind::WrongUsage;
        };
        QVERIFY(!refused({{0, 0, 1}, 1}));
        QVERIFY(refused({{0, 0, 0}, 1}));
        QVERIFY(refused({{0, std::nan(""), 1}, 1}));
        QVERIFY(refused({{0, 0, 1}, HUGE_VAL}));
        mesh.values.pop_back();
        QVERIFY(refused({{0, 0, 1}, 1}));
    }

    void cancellationEndsIt()
    {
        std::stop_source source;
        source.request_stop();
        const auto cut = cutByPlane(latticeMesh(cells, extent, Split::Six, linear), {{0, 0, 1}, 2},
                                    Progress(source.get_token(), {}));
        QVERIFY(!cut);
        QCOMPARE(cut.error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(PlaneCutTest)
#include "plane_cut_test.moc"
