// SPDX-License-Identifier: GPL-3.0-or-later
// S7, S8: a mesh that is loaded, refined and taken back is Delaunay all the way and the same as before afterwards; what
// is no Delaunay mesh of its blocks is refused.
#include "core/mesh/topology.h"
#include "core/refine/insertion/local_delaunay.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace tetra;

namespace {

/// The start of every block, by numbers of vertices.
struct Start {
    std::vector<PackedPoint> vertices;
    Buffer<Tetrahedron> tetrahedra;
};

Start startOf(const BlockDivision& division)
{
    LatticeDelaunay mesh;
    if (!mesh.prepare(division.size(), {1, 1, 1}, 100000))
        std::abort();
    for (std::uint32_t block = 0; block < division.count(); ++block)
        mesh.addBox(division.box(block), !division.odd(block));
    Start start;
    std::map<PackedPoint, std::uint32_t> numbers;
    for (const DelaunayTetrahedron& tetrahedron : mesh.tetrahedra()) {
        Tetrahedron corners{};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [number, isNew] = numbers.try_emplace(tetrahedron.vertices[i], numbers.size());
            if (isNew)
                start.vertices.push_back(tetrahedron.vertices[i]);
            corners[i] = number->second;
        }
        start.tetrahedra.push_back(corners);
    }
    return start;
}

std::vector<PackedPoint> otherPoints(const PackedLattice& lattice, const Start& start, unsigned seed)
{
    const std::set<PackedPoint> taken(start.vertices.begin(), start.vertices.end());
    std::vector<PackedPoint> points;
    for (std::uint32_t z = 0; z < lattice.size()[2]; ++z)
        for (std::uint32_t y = 0; y < lattice.size()[1]; ++y)
            for (std::uint32_t x = 0; x < lattice.size()[0]; ++x)
                if (!taken.contains(lattice.pack(x, y, z)))
                    points.push_back(lattice.pack(x, y, z));
    std::ranges::shuffle(points, std::mt19937(seed));
    return points;
}

Buffer<Tetrahedron> tetrahedraOf(const LocalDelaunay& mesh)
{
    Buffer<Tetrahedron> tetrahedra;
    mesh.copyTetrahedra(tetrahedra);
    return tetrahedra;
}

/// Loads what `mesh` holds into another one, which looks at everything that must hold of it.
bool isDelaunay(const LocalDelaunay& mesh, const BlockDivision& division, std::vector<PackedPoint> vertices)
{
    vertices.insert(vertices.end(), mesh.added().begin(), mesh.added().end());
    LocalDelaunay other;
    return other.prepare(division, {1, 1, 1}).ok() && other.load(tetrahedraOf(mesh), vertices) == MeshLoading::Done;
}

} // namespace

class LocalDelaunayTest : public QObject {
    Q_OBJECT

private slots:
    void refinesAndGoesBack_data()
    {
        QTest::addColumn<quint32>("edge");
        for (const quint32 edge : {0u, 3u, 4u, 5u, 9u})
            QTest::addRow("blocks of %u", edge) << edge;
    }
    void refinesAndGoesBack()
    {
        QFETCH(quint32, edge);
        const BlockDivision division({11, 9, 10}, edge);
        LocalDelaunay mesh;
        QVERIFY(mesh.prepare(division, {1, 1, 1}).ok());
        Start start = startOf(division);
        QVERIFY(mesh.load(start.tetrahedra, start.vertices) == MeshLoading::Done);
        // From a mesh with some points, so that the first one is not as simple as the start.
        const std::vector<PackedPoint> points = otherPoints(mesh.lattice(), start, edge);
        QVERIFY(mesh.add(std::span(points).first(60)));
        start.vertices.insert(start.vertices.end(), mesh.added().begin(), mesh.added().end());
        start.tetrahedra = tetrahedraOf(mesh);
        QVERIFY(mesh.load(start.tetrahedra, start.vertices) == MeshLoading::Done);

        Buffer<Tetrahedron> first;
        for (int round = 0; round < 3; ++round) {
            const auto waiting = std::span(points).subspan(60);
            for (std::size_t i = 0; i < waiting.size(); i += 97) {
                QVERIFY(mesh.add(waiting.subspan(i, std::min<std::size_t>(97, waiting.size() - i))));
                QVERIFY(isDelaunay(mesh, division, start.vertices));
                if (i % 2 == 0)
                    mesh.acceptChanges();
            }
            QVERIFY(std::ranges::all_of(points, [&](PackedPoint point) { return mesh.isVertex(point); }));
            QVERIFY(std::ranges::equal(mesh.added(), waiting));
            if (round == 0)
                first = tetrahedraOf(mesh);
            QVERIFY(first == tetrahedraOf(mesh)); // slots are given in the same order
            mesh.restore();
            QVERIFY(start.tetrahedra == tetrahedraOf(mesh));
            QVERIFY(mesh.added().empty() && mesh.changed().empty());
            QVERIFY(!mesh.isVertex(waiting.front()));
        }
    }

    void tellsWhatChanged()
    {
        const BlockDivision division({9, 9, 9}, 4);
        LocalDelaunay mesh;
        QVERIFY(mesh.prepare(division, {1, 1, 1}).ok());
        const Start start = startOf(division);
        QVERIFY(mesh.load(start.tetrahedra, start.vertices) == MeshLoading::Done);
        for (const PackedPoint point : otherPoints(mesh.lattice(), start, 1)) {
            const std::vector<DelaunayTetrahedron> before(mesh.mesh().tetrahedra().begin(),
                                                          mesh.mesh().tetrahedra().end());
            QVERIFY(mesh.add({&point, 1}));
            std::set<std::uint32_t> changed;
            for (std::uint32_t slot = 0; slot < mesh.mesh().slotCount(); ++slot)
                if (slot >= before.size() || before[slot].vertices != mesh.mesh()[slot].vertices ||
                    before[slot].determinant() != mesh.mesh()[slot].determinant())
                    changed.insert(slot);
            const auto told = mesh.changed();
            QCOMPARE(std::set<std::uint32_t>(told.begin(), told.end()), changed);
            QCOMPARE(told.size(), changed.size());
            mesh.acceptChanges();
        }
    }

    void whatIsNoDelaunayMeshIsRefused_data()
    {
        QTest::addColumn<int>("fault");
        for (const int fault : {0, 1, 2, 3, 4, 5})
            QTest::addRow("%d", fault) << fault;
    }
    void whatIsNoDelaunayMeshIsRefused()
    {
        QFETCH(int, fault);
        const BlockDivision division({9, 9, 9}, fault == 5 ? 4 : 0);
        LocalDelaunay mesh;
        QVERIFY(mesh.prepare(division, {1, 1, 1}).ok());
        Start start = startOf(BlockDivision({9, 9, 9}, 0));
        if (fault == 0)
            std::swap(start.tetrahedra[2][0], start.tetrahedra[2][1]); // inverted
        if (fault == 1)
            start.tetrahedra.pop_back(); // a hole
        if (fault == 2)
            start.tetrahedra.push_back(start.tetrahedra[0]); // twice
        if (fault == 3)
            start.tetrahedra[1][2] = start.tetrahedra[1][3]; // flat
        if (fault == 4) {
            // A vertex in the middle of a tetrahedron cuts it in four: a mesh, but with vertices inside spheres.
            const Tetrahedron whole = start.tetrahedra.back();
            start.tetrahedra.pop_back();
            start.vertices.push_back(mesh.lattice().pack(4, 4, 4));
            const auto middle = static_cast<std::uint32_t>(start.vertices.size() - 1);
            for (std::size_t i = 0; i < 4; ++i) {
                Tetrahedron part = whole;
                part[i] = middle;
                start.tetrahedra.push_back(part);
            }
        }
        // 5: one block's mesh is none of eight.
        QVERIFY(mesh.load(start.tetrahedra, start.vertices) ==
                (fault == 4 ? MeshLoading::NotDelaunay : MeshLoading::NoMesh));
        const Start right = startOf(division);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(mesh.load(right.tetrahedra, right.vertices, {stop.get_token(), {}}) == MeshLoading::Cancelled);
        QVERIFY(mesh.load(right.tetrahedra, right.vertices) == MeshLoading::Done);
        QVERIFY(mesh.add(otherPoints(mesh.lattice(), right, 3)));
    }
};

QTEST_APPLESS_MAIN(LocalDelaunayTest)
#include "local_delaunay_test.moc"
