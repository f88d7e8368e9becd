// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/lattice_delaunay.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <set>

using namespace tetra;

namespace {

using BigInteger = __int128;

struct Point {
    std::int64_t x, y, z;
};

Point point(const PackedLattice& lattice, PackedPoint packed)
{
    return {lattice.x(packed), lattice.y(packed), lattice.z(packed)};
}

Point operator-(const Point& a, const Point& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

BigInteger determinant(const Point& a, const Point& b, const Point& c)
{
    return BigInteger(a.x) * (b.y * c.z - b.z * c.y) + BigInteger(a.y) * (b.z * c.x - b.x * c.z) +
           BigInteger(a.z) * (b.x * c.y - b.y * c.x);
}

/// Positive if e lies strictly inside the sphere of the positive tetrahedron (a, b, c, d), in the metric.
BigInteger inSphere(const std::array<Point, 4>& t, const Point& e, const LatticeMetric& metric)
{
    std::array<Point, 4> v{};
    std::array<BigInteger, 4> square{};
    for (std::size_t i = 0; i < 4; ++i) {
        v[i] = t[i] - e;
        square[i] = BigInteger(metric[0]) * v[i].x * v[i].x + BigInteger(metric[1]) * v[i].y * v[i].y +
                    BigInteger(metric[2]) * v[i].z * v[i].z;
    }
    return square[0] * determinant(v[1], v[2], v[3]) - square[1] * determinant(v[0], v[2], v[3]) +
           square[2] * determinant(v[0], v[1], v[3]) - square[3] * determinant(v[0], v[1], v[2]);
}

/// Everything that must hold of the mesh, by arithmetic of its own; an empty text if it does.
QString faultOf(const LatticeDelaunay& mesh, const std::vector<PackedPoint>& vertices, const LatticeMetric& metric)
{
    const PackedLattice& lattice = mesh.lattice();
    const auto& size = lattice.size();
    BigInteger volume = 0;
    std::set<PackedPoint> used;
    for (std::uint32_t slot = 0; slot < mesh.slotCount(); ++slot) {
        const DelaunayTetrahedron& tetrahedron = mesh[slot];
        if (tetrahedron.determinant() == 0)
            continue;
        std::array<Point, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
            corners[i] = point(lattice, tetrahedron.vertices[i]);
            used.insert(tetrahedron.vertices[i]);
        }
        const BigInteger sixVolumes =
            determinant(corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]);
        if (sixVolumes <= 0 || static_cast<double>(sixVolumes) != tetrahedron.determinant())
            return "a tetrahedron is flat, inverted or misjudges its volume";
        volume += sixVolumes;
        for (std::size_t face = 0; face < 4; ++face) {
            const std::uint32_t neighbour = tetrahedron.neighbours[face];
            if (neighbour == LatticeDelaunay::none) {
                std::array<std::set<std::int64_t>, 3> coordinates;
                for (std::size_t i = 0; i < 4; ++i)
                    if (i != face) {
                        coordinates[0].insert(corners[i].x);
                        coordinates[1].insert(corners[i].y);
                        coordinates[2].insert(corners[i].z);
                    }
                bool onHull = false;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    onHull = onHull || (coordinates[axis].size() == 1 &&
                                        (*coordinates[axis].begin() == 0 ||
                                         *coordinates[axis].begin() == std::int64_t(size[axis]) - 1));
                if (!onHull)
                    return "a face without a neighbour lies inside the domain";
                continue;
            }
            const DelaunayTetrahedron& other = mesh[neighbour];
            if (other.determinant() == 0)
                return "a dead neighbour";
            if (std::ranges::count(other.neighbours, slot) != 1)
                return "a neighbour does not know this one";
            for (std::size_t i = 0; i < 4; ++i)
                if (i != face && std::ranges::find(other.vertices, tetrahedron.vertices[i]) == other.vertices.end())
                    return "neighbours do not share their face";
        }
        for (const PackedPoint vertex : vertices)
            if (inSphere(corners, point(lattice, vertex), metric) > 0)
                return "a vertex lies strictly inside a circumsphere";
    }
    if (volume != BigInteger(6) * (size[0] - 1) * (size[1] - 1) * (size[2] - 1))
        return "the tetrahedra do not fill the box";
    if (used != std::set<PackedPoint>(vertices.begin(), vertices.end()))
        return "a vertex is missing from the mesh";
    return {};
}

/// The live tetrahedron that contains the point, by trying all.
std::uint32_t locate(const LatticeDelaunay& mesh, PackedPoint packed)
{
    const Point p = point(mesh.lattice(), packed);
    for (std::uint32_t slot = 0; slot < mesh.slotCount(); ++slot) {
        if (mesh[slot].determinant() == 0)
            continue;
        std::array<Point, 4> v{};
        for (std::size_t i = 0; i < 4; ++i)
            v[i] = point(mesh.lattice(), mesh[slot].vertices[i]) - p;
        if (determinant(v[1], v[2], v[3]) >= 0 && determinant(v[0], v[3], v[2]) >= 0 &&
            determinant(v[0], v[1], v[3]) >= 0 && determinant(v[0], v[2], v[1]) >= 0)
            return slot;
    }
    return LatticeDelaunay::none;
}

} // namespace

/// S7, S8: the kernel keeps a Delaunay mesh of the box through any order of insertions, with every kind of tie.
class LatticeDelaunayTest : public QObject {
    Q_OBJECT
private slots:
    void staysDelaunay_data()
    {
        QTest::addColumn<quint32>("nx");
        QTest::addColumn<quint32>("ny");
        QTest::addColumn<quint32>("nz");
        QTest::addColumn<quint32>("zWeight");
        QTest::addColumn<bool>("centreAtOrigin");
        QTest::newRow("cube") << 5u << 5u << 5u << 1u << true;
        QTest::newRow("cube, the other start") << 5u << 5u << 5u << 1u << false;
        QTest::newRow("flat") << 9u << 8u << 2u << 1u << true;
        QTest::newRow("rod") << 2u << 3u << 19u << 1u << true;
        QTest::newRow("stretched metric") << 5u << 4u << 6u << 7u << true;
        QTest::newRow("smallest") << 2u << 2u << 2u << 1u << true;
    }
    void staysDelaunay()
    {
        QFETCH(quint32, nx);
        QFETCH(quint32, ny);
        QFETCH(quint32, nz);
        QFETCH(quint32, zWeight);
        QFETCH(bool, centreAtOrigin);
        const LatticeMetric metric{1, 1, zWeight};
        for (unsigned seed = 0; seed < 4; ++seed) {
            LatticeDelaunay mesh;
            QVERIFY(mesh.start({nx, ny, nz}, metric, centreAtOrigin).ok());
            std::vector<PackedPoint> vertices;
            std::vector<PackedPoint> waiting;
            for (quint32 z = 0; z < nz; ++z)
                for (quint32 y = 0; y < ny; ++y)
                    for (quint32 x = 0; x < nx; ++x) {
                        const bool corner = (x % (nx - 1) == 0) && (y % (ny - 1) == 0) && (z % (nz - 1) == 0);
                        (corner ? vertices : waiting).push_back(mesh.lattice().pack(x, y, z));
                    }
            QCOMPARE(faultOf(mesh, vertices, metric), QString());
            std::ranges::shuffle(waiting, std::mt19937(seed));
            for (std::size_t i = 0; i < waiting.size(); ++i) {
                const std::uint32_t containing = locate(mesh, waiting[i]);
                QVERIFY(containing != LatticeDelaunay::none);
                QVERIFY(mesh.insert(waiting[i], containing));
                QCOMPARE(mesh.created().size(), mesh.star().faceCount());
                vertices.push_back(waiting[i]);
                if (i % 13 == 0 || i + 1 == waiting.size())
                    QCOMPARE(faultOf(mesh, vertices, metric), QString());
            }
        }
    }
};

QTEST_APPLESS_MAIN(LatticeDelaunayTest)
#include "lattice_delaunay_test.moc"
