// SPDX-License-Identifier: GPL-3.0-or-later
// Orders taken from one end and from both (S14): every edge of the graph kept, cycles counted alike.
#include "core/render/order/topological_sort.h"
#include "core/render/order/visibility_order.h"
#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/volume/exact_order.h"

#include <tan/render.h>

#include <tbb/task_arena.h>

#include <QTest>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>

using namespace tetra;
using namespace tetra::testing;

namespace {

VolumeMesh volumeOf(const TetrahedralMesh& mesh)
{
    return makeVolumeMesh(std::make_shared<const TetrahedralMesh>(mesh)).value();
}

VisibilityOrder orderOn(int threads, const VolumeMesh& volume, const EyePoint& eye,
                        std::span<const CellRelation> relations = {})
{
    tbb::task_arena arena(threads);
    return arena.execute([&] { return orderByAdjacency(*volume.mesh, volume.adjacency, eye, relations); });
}

/// The place of each of so many cells, or their number if it is none or two.
std::vector<std::size_t> ranksOf(std::span<const std::uint32_t> order, std::size_t cells)
{
    std::vector<std::size_t> ranks(cells, cells);
    for (std::size_t i = 0; i < order.size(); ++i)
        ranks.at(order[i]) = ranks[order[i]] == cells ? i : cells;
    return ranks;
}

bool hasEachOnce(std::span<const std::uint32_t> order, std::size_t cells)
{
    const auto ranks = ranksOf(order, cells);
    return order.size() == cells && std::ranges::find(ranks, cells) == ranks.end();
}

/// The cells, each that was cut where its first piece is.
std::vector<std::uint32_t> withoutPieces(const VisibilityOrder& order, std::size_t cells)
{
    std::vector<bool> seen(cells, false);
    std::vector<std::uint32_t> drawn;
    for (const std::uint32_t number : order.cells) {
        const std::uint32_t cell = number < cells ? number : order.pieces.cells.at(number - cells);
        if (number < cells || !seen[cell])
            drawn.push_back(cell);
        seen[cell] = true;
    }
    return drawn;
}

/// What must come before what: by faces, as the cell behind sees them, and by relations.
std::vector<CellRelation> edgesOf(const VolumeMesh& volume, const EyePoint& eye,
                                  std::span<const CellRelation> relations)
{
    std::vector<CellRelation> edges(relations.begin(), relations.end());
    const Buffer<std::uint8_t> facing = classifyFaces(*volume.mesh, eye);
    for (std::uint32_t cell = 0; cell < facing.size(); ++cell)
        for (std::size_t face = 0; face < 4; ++face)
            if (((facing[cell] & volume.adjacency.innerFaces[cell]) >> face & 1) != 0)
                edges.push_back({FaceAdjacency::cellOf(volume.adjacency.neighbours[cell][face]), cell});
    return edges;
}

/// For each cell whether it is in a cycle or between two: what stays when what nothing hides, and what hides nothing,
/// is taken away again and again.
std::vector<bool> amongCycles(std::size_t cells, const std::vector<CellRelation>& edges)
{
    std::vector<bool> left(cells, true);
    for (bool changed = true; changed;) {
        std::vector<bool> hidden(cells, false), hides(cells, false);
        for (const CellRelation& edge : edges)
            if (left[edge.front] && left[edge.back])
                hidden[edge.back] = hides[edge.front] = true;
        changed = false;
        for (std::size_t cell = 0; cell < cells; ++cell)
            if (left[cell] && !(hidden[cell] && hides[cell])) {
                left[cell] = false;
                changed = true;
            }
    }
    return left;
}

/// Cells at random in pairs, each as `order` has it; `against` of them the other way around.
std::vector<CellRelation> someRelations(const VisibilityOrder& order, std::size_t against, std::mt19937& random)
{
    std::uniform_int_distribution<std::size_t> place(0, order.cells.size() - 1);
    std::vector<CellRelation> relations;
    for (int i = 0; i < 60; ++i) {
        const auto [first, second] = std::minmax({place(random), place(random)});
        if (first == second)
            continue;
        const CellRelation relation{order.cells[first], order.cells[second]};
        relations.push_back(relations.size() < against ? CellRelation{relation.back, relation.front} : relation);
    }
    std::ranges::sort(relations);
    const auto doubles = std::ranges::unique(relations);
    relations.erase(doubles.begin(), doubles.end());
    return relations;
}

/// Every edge but those among cycles is kept, and the order is the same with any number of threads, each time.
void checkOrders(const VolumeMesh& volume, const EyePoint& eye, std::span<const CellRelation> relations)
{
    const std::size_t cells = volume.mesh->tetrahedra.size();
    const auto edges = edgesOf(volume, eye, relations);
    const auto doubtful = amongCycles(cells, edges);
    const VisibilityOrder order = orderOn(1, volume, eye, relations);
    const auto drawn = withoutPieces(order, cells);
    QVERIFY(hasEachOnce(drawn, cells));
    QCOMPARE(order.cycles > 0, std::ranges::find(doubtful, true) != doubtful.end());
    QVERIFY(std::ranges::all_of(order.pieces.cells, [&](std::uint32_t cell) { return doubtful[cell]; }));
    const auto ranks = ranksOf(drawn, cells);
    QVERIFY(std::ranges::all_of(edges, [&](const CellRelation& edge) {
        return ranks[edge.front] < ranks[edge.back] || (doubtful[edge.front] && doubtful[edge.back]);
    }));
    for (const int threads : {2, 2, 4}) {
        const VisibilityOrder again = orderOn(threads, volume, eye, relations);
        QVERIFY(again.cells == order.cells);
        QVERIFY(again.pieces.tetrahedra == order.pieces.tetrahedra);
        QCOMPARE(again.brokenCycles, order.brokenCycles);
    }
}

} // namespace

class TopologicalSortTest : public QObject {
    Q_OBJECT

private slots:
    void keepsEveryEdge_data();
    void keepsEveryEdge();
    void fewCells();
    void invertedCellsComeOnce();
    void takesAsManyAsAreWanted();
    void leavesWhatIsTakenFromTheOtherEnd();
};

void TopologicalSortTest::keepsEveryEdge_data()
{
    QTest::addColumn<TetrahedralMesh>("mesh");
    for (const NamedMesh& named : volumeMeshes())
        QTest::addRow("%s", named.name.c_str()) << named.mesh;
    for (const NamedMesh& named : delaunayMeshes())
        QTest::addRow("Delaunay, %s", named.name.c_str()) << named.mesh;
    QTest::addRow("lattice cut in five") << boxLattice(8, Split::Five);
    QTest::addRow("lattice cut in six") << boxLattice(7, Split::Six);
    QTest::addRow("shaken lattice") << shakenLattice(0.12f);
}

/// With faces alone, with relations that agree with them, and with a few that do not.
void TopologicalSortTest::keepsEveryEdge()
{
    QFETCH(TetrahedralMesh, mesh);
    const VolumeMesh volume = volumeOf(mesh);
    std::mt19937 random(21);
    for (const EyePoint& eye : eyesAround(volume.bounds, 8, random)) {
        checkOrders(volume, eye, {});
        const VisibilityOrder order = orderOn(1, volume, eye);
        for (const std::size_t against : {0, 1, 6})
            checkOrders(volume, eye, someRelations(order, against, random));
    }
}

void TopologicalSortTest::fewCells()
{
    TetrahedralMesh mesh;
    const auto check = [&](std::size_t cells) {
        const FaceAdjacency adjacency = matchFaces(mesh.tetrahedra);
        for (const int threads : {1, 2, 4}) {
            tbb::task_arena arena(threads);
            for (const double z : {-5.0, 5.0}) {
                const EyePoint eye{{0.2, 0.2, z}, true};
                const auto order = arena.execute([&] { return orderByAdjacency(mesh, adjacency, eye); });
                QVERIFY(hasEachOnce(order.cells, cells));
                QCOMPARE(order.brokenCycles, std::size_t(0));
                if (cells == 2)
                    QCOMPARE(order.cells[0], z > 0 ? 0u : 1u);
            }
        }
    };
    check(0);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    check(1);
    mesh.tetrahedra.push_back({0, 2, 1, 4});
    check(2);
}

/// The two cells of a face need not agree on it then.
void TopologicalSortTest::invertedCellsComeOnce()
{
    std::mt19937 random(22);
    for (const unsigned one : {50u, 5u, 2u}) { // of so many
        TetrahedralMesh mesh = boxLattice(6, Split::Five);
        for (auto& cell : mesh.tetrahedra)
            if (random() % one == 0)
                std::swap(cell[1], cell[2]);
        const VolumeMesh volume = volumeOf(mesh);
        for (const EyePoint& eye : eyesAround(volume.bounds, 10, random)) {
            const VisibilityOrder order = orderOn(1, volume, eye);
            QVERIFY(hasEachOnce(withoutPieces(order, mesh.tetrahedra.size()), mesh.tetrahedra.size()));
            QVERIFY(order.cells == orderOn(2, volume, eye).cells);
        }
    }
}

void TopologicalSortTest::takesAsManyAsAreWanted()
{
    const VolumeMesh volume = volumeOf(boxLattice(7, Split::Six));
    const EyePoint eye{volume.bounds.center() + Eigen::Vector3d(9, 40, 23), true};
    const Buffer<std::uint8_t> facing = classifyFaces(*volume.mesh, eye);
    const OcclusionGraph graph{volume.adjacency, facing, {}};
    for (const OrderEnd end : {OrderEnd::Front, OrderEnd::Back}) {
        TopologicalSort taking(graph, end);
        for (const std::size_t most : {0, 1, 63, 64, 65, 700, 1500, 100000}) {
            taking.take(most);
            const auto cells = taking.taken();
            QCOMPARE(cells.size(), std::min(most, facing.size()));
            const auto ranks = ranksOf(cells, facing.size());
            for (const CellRelation& edge : edgesOf(volume, eye, {})) {
                const auto [first, second] =
                    end == OrderEnd::Front ? std::pair(edge.front, edge.back) : std::pair(edge.back, edge.front);
                QVERIFY(ranks[first] < ranks[second] || ranks[second] == facing.size());
            }
        }
        QVERIFY(taking.isComplete());
    }
}

void TopologicalSortTest::leavesWhatIsTakenFromTheOtherEnd()
{
    const VolumeMesh volume = volumeOf(shakenLattice(0));
    const std::size_t cells = volume.mesh->tetrahedra.size();
    const EyePoint eye{volume.bounds.center() + Eigen::Vector3d(9, 40, 23), true};
    const Buffer<std::uint8_t> facing = classifyFaces(*volume.mesh, eye);
    const OcclusionGraph graph{volume.adjacency, facing, {}};
    const auto edges = edgesOf(volume, eye, {});
    for (const double fromFront : {0.0, 0.1, 0.5, 0.9, 1.0})
        for (const double fromBack : {0.0, 0.1, 0.5, 0.9, 1.0}) {
            TopologicalSort front(graph, OrderEnd::Front), back(graph, OrderEnd::Back);
            front.take(static_cast<std::size_t>(fromFront * double(cells)));
            back.take(static_cast<std::size_t>(fromBack * double(cells)));
            front.leave(back.taken());
            front.take(cells);
            QVERIFY(front.isComplete());
            const Buffer<std::uint32_t> order = std::move(front).order();
            QVERIFY(hasEachOnce(order, cells));
            const auto ranks = ranksOf(order, cells);
            for (const CellRelation& edge : edges)
                QVERIFY(ranks[edge.front] < ranks[edge.back]);
        }
}

QTEST_GUILESS_MAIN(TopologicalSortTest)
#include "topological_sort_test.moc"
