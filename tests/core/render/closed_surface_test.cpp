// SPDX-License-Identifier: GPL-3.0-or-later
// Isosurfaces that are closed at the boundary of the mesh, and what is told of surfaces: openings, parts, volume.
#include "core/mesh/boundary.h"
#include "core/mesh/surface_shape.h"
#include "core/render/isosurface/closed_surface.h"
#include "tests/core/render/holed_mesh.h"
#include "tests/core/render/lattice_mesh.h"

#include <tan/render.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

using namespace tetra;
using Eigen::Vector3d;
using testing::holedMesh;
using testing::latticeMesh;
using testing::Split;

namespace {

TriangleMesh closedSurface(const TetrahedralMesh& mesh, double isovalue, SolidSide side)
{
    auto surface = closedIsosurface(mesh, isovalue, side);
    if (!surface)
        qFatal("%s", surface.error().text().c_str());
    return *std::move(surface);
}

TriangleMesh openSurface(const TetrahedralMesh& mesh, double isovalue)
{
    auto surface = extractIsosurface(mesh, vertexGradients(mesh), isovalue);
    if (!surface)
        qFatal("%s", surface.error().text().c_str());
    return *std::move(surface);
}

double volumeOf(const TetrahedralMesh& mesh)
{
    double volume = 0;
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        const auto edge = [&, from = a](std::uint32_t to) -> Vector3d {
            return mesh.positions[to] - mesh.positions[from];
        };
        volume += edge(b).dot(edge(c).cross(edge(d))) / 6;
    }
    return volume;
}

/// The surface of a box, whose fronts look outwards, or into it.
TriangleMesh box(const Vector3d& low, const Vector3d& high, bool inwards)
{
    TriangleMesh surface;
    for (int corner = 0; corner < 8; ++corner)
        surface.positions.push_back(
            {corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(), corner & 4 ? high.z() : low.z()});
    surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                         {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    if (inwards)
        for (auto& triangle : surface.triangles)
            std::swap(triangle[1], triangle[2]);
    return surface;
}

void append(TriangleMesh& surface, const TriangleMesh& more)
{
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    surface.positions.insert(surface.positions.end(), more.positions.begin(), more.positions.end());
    for (const auto& [a, b, c] : more.triangles)
        surface.triangles.push_back({a + first, b + first, c + first});
}

/// Each edge is run along as often in one direction as in the other.
bool isBalanced(const TriangleMesh& surface)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& triangle : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
            balance[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

/// How many edges this number of triangles have, or more if there is no other bound.
std::uint64_t slowEdges(const TriangleMesh& surface, int least, int most = std::numeric_limits<int>::max())
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    for (const auto& triangle : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++counts[std::minmax(triangle[i], triangle[(i + 1) % 3])];
    const auto isMeant = [&](const auto& edge) { return edge.second >= least && edge.second <= most; };
    return static_cast<std::uint64_t>(std::ranges::count_if(counts, isMeant));
}

/// Parts by going from triangle to triangle over common vertices.
std::uint32_t slowParts(const TriangleMesh& surface)
{
    std::multimap<std::uint32_t, std::size_t> around;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (const std::uint32_t corner : surface.triangles[t])
            around.emplace(corner, t);
    std::vector<bool> seen(surface.triangles.size(), false);
    std::uint32_t parts = 0;
    for (std::size_t first = 0; first < seen.size(); ++first) {
        if (seen[first])
            continue;
        ++parts;
        std::vector<std::size_t> waiting = {first};
        seen[first] = true;
        while (!waiting.empty()) {
            const std::size_t t = waiting.back();
            waiting.pop_back();
            for (const std::uint32_t corner : surface.triangles[t])
                for (auto [at, end] = around.equal_range(corner); at != end; ++at)
                    if (!seen[at->second]) {
                        seen[at->second] = true;
                        waiting.push_back(at->second);
                    }
        }
    }
    return parts;
}

} // namespace

class ClosedSurfaceTest : public QObject {
    Q_OBJECT

private slots:
    /// On any data, however often the isovalue is that of a vertex: no opening, fronts outwards, and what lies above
    /// and what lies below are the whole together.
    void anySolidIsClosed_data()
    {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<bool>("ties");
        for (unsigned seed = 0; seed < 12; ++seed)
            QTest::addRow("%u", seed) << seed << (seed % 3 != 0);
    }
    void anySolidIsClosed()
    {
        QFETCH(unsigned, seed);
        QFETCH(bool, ties);
        TetrahedralMesh mesh = holedMesh(seed, 4 + seed % 4);
        std::mt19937 random(seed);
        for (float& value : mesh.values)
            value = ties ? static_cast<float>(random() % 4) : static_cast<float>(random() % 1000) / 250;
        for (const Vector3d& shift : {Vector3d(0, 0, 0), Vector3d(408201.5, 4080928.25, 17), Vector3d(0.3, 0.7, 0.1)}) {
            for (Vector3d& position : mesh.positions)
                position += shift;
            for (const double isovalue : {1.0, 1.7, 2.0, 3.0}) {
                double volumes = 0;
                for (const SolidSide side : {SolidSide::Above, SolidSide::Below}) {
                    const TriangleMesh surface = closedSurface(mesh, isovalue, side);
                    const SurfaceShape shape = shapeOf(surface);
                    QVERIFY(isBalanced(surface));
                    QCOMPARE(shape.openEdges, std::uint64_t(0));
                    QCOMPARE(shape.openings, std::uint64_t(0));
                    QCOMPARE(shape.crowdedEdges, slowEdges(surface, 3));
                    QVERIFY(shape.volume >= -1e-9);
                    QCOMPARE(shape.parts, slowParts(surface));
                    volumes += shape.volume;
                }
                const TriangleMesh open = openSurface(mesh, isovalue);
                QCOMPARE(shapeOf(open).openEdges, slowEdges(open, 1, 1));
                QVERIFY2(std::abs(volumes / volumeOf(mesh) - 1) < 1e-7, qPrintable(QString::number(volumes)));
            }
        }
    }

    /// Next to a vertex of the mesh it is a matter of rounding whether the contour crosses in it, and which way an edge
    /// is walked decides that: here inwards it does on all three edges, outwards on none.
    void crossingsByAVertexAreThoseOfTheContour()
    {
        TetrahedralMesh mesh;
        const double far = std::ldexp(1.0, 22);
        const Vector3d corner(far, far, far);
        mesh.positions = {corner, corner + Vector3d(1, 0, 0), corner + Vector3d(0, 1, 0), corner + Vector3d(0, 0, 1)};
        const auto little = static_cast<float>(std::ldexp(1 + std::ldexp(1.0, -23), -31));
        mesh.values = {little, -1, -1, -1};
        mesh.tetrahedra = {{0, 1, 2, 3}};
        QCOMPARE(openSurface(mesh, 0).triangles.size(), std::size_t(0));
        for (const SolidSide side : {SolidSide::Above, SolidSide::Below}) {
            const TriangleMesh surface = closedSurface(mesh, 0, side);
            const SurfaceShape shape = shapeOf(surface);
            QVERIFY(isBalanced(surface));
            QCOMPARE(shape.openEdges, std::uint64_t(0));
            QVERIFY(std::abs(shape.volume - (side == SolidSide::Above ? 0.0 : 1.0 / 6)) < 1e-8);
        }
    }

    /// The boundary is found once for the surfaces of many values.
    void oneBasisServesAllValues()
    {
        TetrahedralMesh mesh = holedMesh(3, 5);
        std::mt19937 random(3);
        for (float& value : mesh.values)
            value = static_cast<float>(random() % 1000) / 250;
        const auto basis = closingBasis(mesh);
        QVERIFY(basis.ok());
        for (const double isovalue : {1.0, 1.7, 3.0})
            for (const SolidSide side : {SolidSide::Above, SolidSide::Below}) {
                const auto surface = closedIsosurface(mesh, *basis, isovalue, side);
                QVERIFY(surface.ok());
                const TriangleMesh alone = closedSurface(mesh, isovalue, side);
                QVERIFY(surface->positions == alone.positions && surface->triangles == alone.triangles);
            }
        mesh.positions.push_back(Vector3d(0, 0, 0));
        mesh.values.push_back(0);
        QVERIFY(!closedIsosurface(mesh, *basis, 1, SolidSide::Above).ok()); // it is that of another mesh
    }

    /// Where nothing meets the boundary it is the isosurface; where everything lies on one side, the boundary or
    /// nothing.
    void extremes()
    {
        const auto mesh =
            latticeMesh(8, 2, Split::Five, [](const Vector3d& p) { return -(p - Vector3d(1, 1, 1)).norm(); });
        const TriangleMesh open = openSurface(mesh, -0.7), closed = closedSurface(mesh, -0.7, SolidSide::Above);
        QCOMPARE(closed.triangles.size(), open.triangles.size());
        QVERIFY(shapeOf(open).isClosed());
        QCOMPARE(shapeOf(closed).volume, shapeOf(open).volume);
        QVERIFY(closed.normals.empty());
        const TriangleMesh hollow = closedSurface(mesh, -0.7, SolidSide::Below);
        QCOMPARE(shapeOf(hollow).parts, 2U);
        QVERIFY(std::abs(shapeOf(hollow).volume + shapeOf(open).volume - 8) < 1e-12);
        QCOMPARE(closedSurface(mesh, 1, SolidSide::Above).triangles.size(), std::size_t(0));
        const SurfaceShape all = shapeOf(closedSurface(mesh, -9, SolidSide::Above));
        QVERIFY(std::abs(all.volume - 8) < 1e-12 && std::abs(all.area - 24) < 1e-12);
        QVERIFY(!closedIsosurface(mesh, std::nan(""), SolidSide::Above).ok());
    }

    /// A ball that six sides of the cube cut: six openings without caps; and what encloses it has the area and volume
    /// of the formulas.
    void openingsAreCounted()
    {
        const auto mesh =
            latticeMesh(24, 2, Split::Six, [](const Vector3d& p) { return -(p - Vector3d(1, 1, 1)).norm(); });
        const double radius = 1.2;
        const SurfaceShape open = shapeOf(openSurface(mesh, -radius));
        QCOMPARE(open.parts, 1U);
        QCOMPARE(open.openings, std::uint64_t(6));
        QVERIFY(open.openEdges > 6 * 20 && !open.isClosed());
        const SurfaceShape closed = shapeOf(closedSurface(mesh, -radius, SolidSide::Above));
        const double cap = radius - 1; // cut off by each side
        const double capVolume = std::numbers::pi * cap * cap * (3 * radius - cap) / 3;
        const double volume = 4 * std::numbers::pi * std::pow(radius, 3) / 3 - 6 * capVolume;
        QVERIFY2(std::abs(closed.volume / volume - 1) < 0.005, qPrintable(QString::number(closed.volume / volume)));
        QVERIFY(closed.isClosed() && closed.parts == 1);
    }

    void theLargestPartIsKept()
    {
        const auto mesh = latticeMesh(16, 4, Split::Five, [](const Vector3d& p) {
            return std::max(1 - (p - Vector3d(1.5, 1.5, 1.5)).norm(), 0.4 - (p - Vector3d(3.4, 3.4, 3.4)).norm());
        });
        TriangleMesh both = openSurface(mesh, 0.05);
        const SurfaceShape before = shapeOf(both);
        QCOMPARE(before.parts, 2U);
        keepLargestPart(both);
        const SurfaceShape after = shapeOf(both);
        QCOMPARE(after.parts, 1U);
        QVERIFY(after.isClosed() && after.area < before.area);
        QVERIFY(std::abs(after.volume / (4 * std::numbers::pi / 3 * std::pow(0.95, 3)) - 1) < 0.1);
        QCOMPARE(both.normals.size(), both.positions.size());
        for (std::size_t v = 0; v < both.positions.size(); ++v)
            QVERIFY((both.positions[v] - Vector3d(1.5, 1.5, 1.5)).dot(both.normals[v].cast<double>()) > 0);
        TriangleMesh none;
        keepLargestPart(none);
        QCOMPARE(shapeOf(none).parts, 0U);
    }

    /// The wall of a hollow may be larger than the skin around it, but it is no solid.
    void ofASolidTheSkinIsKept()
    {
        const TriangleMesh skin = box(Vector3d(0, 0, 0), Vector3d(2, 2, 2), false);
        TriangleMesh solid = box(Vector3d(1, 1, 1), Vector3d(9, 9, 9), true); // wound inwards
        append(solid, skin);
        TriangleMesh any = solid;
        keepLargestPart(any);
        QCOMPARE(shapeOf(any).volume, -512.0);
        keepLargestPart(solid, SurfaceParts::Outer);
        QVERIFY(solid.positions == skin.positions && solid.triangles == skin.triangles);
        TriangleMesh inner = box(Vector3d(0, 0, 0), Vector3d(1, 1, 1), true);
        keepLargestPart(inner, SurfaceParts::Outer); // better than nothing
        QCOMPARE(inner.triangles.size(), std::size_t(12));
    }
};

QTEST_GUILESS_MAIN(ClosedSurfaceTest)
#include "closed_surface_test.moc"
