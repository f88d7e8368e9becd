// SPDX-License-Identifier: GPL-3.0-or-later
// Which tetrahedra a surface crosses, and the edges that its corners lie on (R19), against a look at each one.
#include "core/mesh/topology.h"
#include "core/render/isosurface/crossed_tetrahedra.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace tetra;

namespace {

/// More than a surface has: corners are anywhere, also at the last vertex.
std::vector<Tetrahedron> randomTetrahedra(std::size_t count, std::uint32_t vertexCount, std::mt19937& random)
{
    std::vector<Tetrahedron> tetrahedra(count);
    for (Tetrahedron& corners : tetrahedra)
        for (std::uint32_t& corner : corners)
            corner = static_cast<std::uint32_t>(random() % vertexCount);
    return tetrahedra;
}

std::vector<CrossedTetrahedron> foundIn(std::span<const Tetrahedron> tetrahedra, std::size_t first,
                                        const VertexSigns& sides)
{
    std::vector<CrossedTetrahedron> found(tetrahedra.size() + crossedTetrahedronRoom);
    found.resize(static_cast<std::size_t>(findCrossed(tetrahedra, first, sides, found.data()) - found.data()));
    return found;
}

} // namespace

class CrossedTetrahedraTest : public QObject {
    Q_OBJECT

private slots:
    void sidesFollowTheTieRule()
    {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const std::vector<float> values{-infinity, 0.1f, std::nextafter(0.1f, 1.0f), std::nanf(""), infinity};
        for (const double isovalue : {0.1, double(0.1f), 0.0, -double(infinity), double(infinity)}) {
            const VertexSigns sides(values, isovalue);
            QCOMPARE(sides.size(), values.size());
            for (std::size_t v = 0; v < values.size(); ++v)
                QCOMPARE(sides.bytes()[v] != 0, double(values[v]) >= isovalue);
        }
    }

    /// Any number of them, so that whatever is done several at a time has a rest.
    void findsThemInOrder()
    {
        std::mt19937 random(5);
        for (std::size_t count = 0; count < 70; ++count) {
            const std::uint32_t vertexCount = 1 + random() % 40;
            const auto tetrahedra = randomTetrahedra(count, vertexCount, random);
            std::vector<float> values(vertexCount);
            for (float& value : values)
                value = static_cast<float>(random() % 2);
            const VertexSigns sides(values, 0.5);
            const std::size_t first = random() % 16000;
            std::vector<CrossedTetrahedron> expected;
            for (std::size_t i = 0; i < count; ++i) {
                unsigned inside = 0;
                for (std::size_t corner = 0; corner < 4; ++corner)
                    inside |= values[tetrahedra[i][corner]] > 0.5f ? 1u << corner : 0u;
                if (inside != 0 && inside != 15)
                    expected.push_back(static_cast<CrossedTetrahedron>((first + i) * 16 + inside));
            }
            QCOMPARE(foundIn(tetrahedra, first, sides), expected);
        }
    }

    void edgesAreThoseOfTheMarchingCases()
    {
        std::mt19937 random(6);
        const auto tetrahedra = randomTetrahedra(200, 0xffffffff, random);
        std::vector<CrossedTetrahedron> crossed;
        std::vector<EdgeKey> expected;
        for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
            const auto inside = static_cast<unsigned>(1 + random() % 14);
            crossed.push_back(static_cast<CrossedTetrahedron>(i * 16 + inside));
            const MarchingCase& marching = marchingCases[inside];
            for (std::size_t corner = 0; corner < std::size_t(marching.corners); ++corner) {
                const auto [from, to] = marching.edges[corner];
                const auto [a, b] = std::minmax(tetrahedra[i][from], tetrahedra[i][to]);
                expected.push_back(EdgeKey(a) << 32 | b);
                QCOMPARE(endsOf(expected.back()), (std::array{a, b}));
            }
        }
        std::vector<EdgeKey> edges(4 * crossed.size());
        edges.resize(static_cast<std::size_t>(writeCrossedEdges(tetrahedra, crossed, edges.data()) - edges.data()));
        QCOMPARE(edges, expected);
    }
};

QTEST_GUILESS_MAIN(CrossedTetrahedraTest)
#include "crossed_tetrahedra_test.moc"
