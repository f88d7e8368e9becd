// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_grid.h"

#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/point_location.h"

#include <QTest>

#include <random>
#include <vector>

using namespace tetra;

namespace {

/// The determinant times how deep the point lies inside the sphere; negative outside.
double depth(const PackedLattice& lattice, const DelaunayTetrahedron& tetrahedron, PackedPoint point)
{
    const PackedPoint apex = tetrahedron.vertices[0];
    const double q[3] = {double(lattice.x(point) - lattice.x(apex)), double(lattice.y(point) - lattice.y(apex)),
                         double(lattice.z(point) - lattice.z(apex))};
    const auto& sphere = tetrahedron.sphere;
    return sphere[0] * q[0] + sphere[1] * q[1] + sphere[2] * q[2] -
           sphere[3] * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
}

} // namespace

class CircumsphereTest : public QObject {
    Q_OBJECT
private slots:
    /// S5: while a mesh grows by random points, the cure of every tetrahedron is what trying every point finds, and no
    /// vertex of the mesh.
    void deepestPointIsThatOfAnExhaustiveSearch()
    {
        const std::array<std::uint32_t, 3> size{7, 6, 8};
        const LatticeBox box{{0, 0, 0}, size};
        LatticeDelaunay delaunay;
        QVERIFY(delaunay.start(size, {1, 1, 1}).ok());
        const PackedLattice& lattice = delaunay.lattice();
        std::vector<PackedPoint> all;
        for (std::uint32_t z = 0; z < size[2]; ++z)
            for (std::uint32_t y = 0; y < size[1]; ++y)
                for (std::uint32_t x = 0; x < size[0]; ++x)
                    all.push_back(lattice.pack(x, y, z));
        std::vector<PackedPoint> order;
        for (const PackedPoint point : all) {
            const bool corner = lattice.x(point) % 6 == 0 && lattice.y(point) % 5 == 0 && lattice.z(point) % 7 == 0;
            if (!corner)
                order.push_back(point);
        }
        std::mt19937 random(3);
        std::ranges::shuffle(order, random);
        std::uint32_t hint = 0;
        int cured = 0, incurable = 0;
        for (const PackedPoint point : order) {
            const std::uint32_t containing = placeIn(delaunay, point, hint).slot;
            QVERIFY(delaunay.insert(point, containing));
            hint = delaunay.created()[0];
            for (const std::uint32_t slot : delaunay.created()) {
                const DelaunayTetrahedron& tetrahedron = delaunay[slot];
                double deepest = 0;
                for (const PackedPoint candidate : all)
                    deepest = std::max(deepest, depth(lattice, tetrahedron, candidate));
                const auto found = deepestPointInSphere(lattice, tetrahedron, box);
                QCOMPARE(found.has_value(), deepest > 0);
                ++(found ? cured : incurable);
                if (found)
                    QCOMPARE(depth(lattice, tetrahedron, *found), deepest);
            }
        }
        QVERIFY(cured > 500 && incurable > 100);
    }
};

QTEST_APPLESS_MAIN(CircumsphereTest)
#include "circumsphere_test.moc"
