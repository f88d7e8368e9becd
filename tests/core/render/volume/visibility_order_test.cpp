// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the cells by adjacency (S14): every face right, gaps, cycles.
#include "core/geometry/orientation.h"
#include "core/mesh/topology.h"
#include "core/render/order/topological_sort.h"
#include "core/render/order/visibility_order.h"
#include "core/render/volume/volume_mesh.h"
#include "core/render/volume/volume_renderer.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/volume/exact_order.h"
#include "tests/core/render/volume/volume_meshes.h"

#include <tan/mesh.h>
#include <tan/render.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

VolumeMesh volumeOf(const TetrahedralMesh& mesh)
{
    return makeVolumeMesh(std::make_shared<const TetrahedralMesh>(mesh)).value();
}

/// Of each cell, and behind the cells of each piece of one, its place; of those that are not there the order's size.
std::vector<std::uint32_t> ranksOf(const VisibilityOrder& order)
{
    const auto count = static_cast<std::uint32_t>(order.cells.size());
    const std::uint32_t last = order.cells.empty() ? 0 : std::ranges::max(order.cells);
    std::vector<std::uint32_t> ranks(last + 1, count);
    for (std::uint32_t i = 0; i < count; ++i)
        ranks[order.cells[i]] = i;
    return ranks;
}

/// The height of the eye over a face, seen from outside, as a part of the face's size; by the sine of the angle.
double heightOfEye(const TetrahedralMesh& mesh, std::size_t cell, std::size_t face, const Camera& camera)
{
    const auto at = [&](std::size_t i) -> Vector3d {
        return mesh.positions[mesh.tetrahedra[cell][cornersOfFace[face][i]]].cast<double>();
    };
    const Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    const Vector3d back = viewMatrix(camera).block<1, 3>(2, 0).transpose();
    return camera.perspective ? normal.dot((eyePosition(camera) - at(0)).normalized()) : normal.dot(back);
}

/// Three blades around an axis, each before the next.
TetrahedralMesh pinwheel()
{
    TetrahedralMesh mesh;
    for (int blade = 0; blade < 3; ++blade) {
        const Eigen::AngleAxisd turn(blade * 2.0943951, Eigen::Vector3d::UnitY());
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Eigen::Vector3d& corner :
             {Eigen::Vector3d(-1, -0.3f, 0.4f), {1.2f, 0.3f, 0.4f}, {1.2f, 0.35f, 0.6f}, {1.2f, 0.5f, 0.4f}})
            mesh.positions.push_back(turn * corner);
        mesh.tetrahedra.push_back({base, base + 1, base + 2, base + 3});
    }
    for (auto& cell : mesh.tetrahedra) {
        const auto edge = [&](std::size_t i) -> Eigen::Vector3d {
            return mesh.positions[cell[i]] - mesh.positions[cell[0]];
        };
        if (edge(1).dot(edge(2).cross(edge(3))) < 0)
            std::swap(cell[2], cell[3]);
    }
    mesh.values.assign(mesh.positions.size(), 0.5f);
    return mesh;
}

} // namespace

class VisibilityOrderTest : public QObject {
    Q_OBJECT

private slots:
    void facesAreMatched();
    void surplusFacesAreBoundary();
    void everyFaceIsRight();
    void everyFaceIsExactlyRight();
    void nearlyInPlanesOfFaces_data();
    void nearlyInPlanesOfFaces();
    void besideAVertexAtTheOrigin();
    void tellsConvexDomains();
    void cyclesAreCut_data();
    void cyclesAreCut();
    void onlyWhatCyclesHoldBackIsSearched();
    void overlapsAreCounted();
    void driftIsTheAngleOfTheEye();
};

void VisibilityOrderTest::facesAreMatched()
{
    std::mt19937 random(2);
    std::vector<NamedMesh> meshes = volumeMeshes();
    QVERIFY(!meshes.empty());
    meshes.push_back({"several blocks", latticeMesh(23, 1, Split::Six, [](const Vector3d&) { return 0; })});
    for (const NamedMesh& named : meshes) {
        TetrahedralMesh mesh = named.mesh;
        std::ranges::shuffle(mesh.tetrahedra, random);
        const FaceAdjacency adjacency = matchFaces(mesh.tetrahedra);
        std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> faces;
        for (std::uint32_t cell = 0; cell < mesh.tetrahedra.size(); ++cell)
            for (std::uint32_t face = 0; face < 4; ++face) {
                std::array<std::uint32_t, 3> corners{};
                for (std::size_t i = 0; i < 3; ++i)
                    corners[i] = mesh.tetrahedra[cell][(face + 1 + i) % 4];
                std::ranges::sort(corners);
                faces[corners].push_back(cell * 4 + face);
            }
        for (const auto& [corners, names] : faces)
            for (std::size_t i = 0; i < names.size(); ++i) {
                const std::uint32_t expected = names.size() == 2 ? names[1 - i] : FaceAdjacency::none;
                QCOMPARE(adjacency.neighbours[names[i] / 4][names[i] % 4], expected);
            }
    }
}

void VisibilityOrderTest::surplusFacesAreBoundary()
{
    const std::vector<std::array<std::uint32_t, 4>> cells = {{0, 1, 2, 3}, {0, 1, 2, 4}, {2, 1, 0, 5}, {6, 7, 8, 9}};
    const FaceAdjacency adjacency = matchFaces(cells);
    QCOMPARE(adjacency.neighbours[0][3], 1u * 4 + 3);
    QCOMPARE(adjacency.neighbours[1][3], 0u * 4 + 3);
    QCOMPARE(adjacency.neighbours[2][3], FaceAdjacency::none);
    QCOMPARE(matchFaces({}).neighbours.size(), std::size_t(0));
}

void VisibilityOrderTest::everyFaceIsRight()
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> angle(-90, 90), share(0.05, 3);
    const std::vector<NamedMesh> meshes = volumeMeshes();
    QVERIFY(!meshes.empty());
    for (const NamedMesh& named : meshes) {
        const VolumeMesh volume = volumeOf(named.mesh);
        for (int round = 0; round < 12; ++round) {
            Camera camera = fitted({}, volume.bounds);
            camera.perspective = round % 2 == 0;
            camera = zoomed(turned(camera, 2 * angle(random), angle(random)), share(random));
            const VisibilityOrder order = orderForCamera(volume, camera, {64, 64}).value();
            QCOMPARE(order.brokenCycles, std::size_t(0));
            const auto ranks = ranksOf(order);
            QVERIFY(std::ranges::none_of(ranks, [&](std::uint32_t rank) { return rank == ranks.size(); }));
            for (std::size_t cell = 0; cell < ranks.size(); ++cell)
                for (std::size_t face = 0; face < 4; ++face) {
                    const std::uint32_t neighbour = volume.adjacency.neighbours[cell][face];
                    const double height = heightOfEye(named.mesh, cell, face, camera);
                    if (neighbour != FaceAdjacency::none && std::abs(height) > 1e-4)
                        QCOMPARE(ranks[neighbour / 4]<ranks[cell], height> 0);
                }
        }
    }
}

/// Without a tolerance: from anywhere outside and inside, in planes of the lattice and hardly beside them.
void VisibilityOrderTest::everyFaceIsExactlyRight()
{
    std::mt19937 random(16);
    const std::vector<NamedMesh> meshes = delaunayMeshes();
    QVERIFY(!meshes.empty());
    for (const NamedMesh& named : meshes)
        for (const bool spatial : {false, true}) {
            const VolumeMesh volume = volumeOf(spatial ? inSpatialOrder(named.mesh).value() : named.mesh);
            for (const EyePoint& eye : eyesAround(volume.bounds, 40, random)) {
                const VisibilityOrder order = orderByAdjacency(*volume.mesh, volume.adjacency, eye);
                QCOMPARE(order.brokenCycles, std::size_t(0));
                const FacesInOrder faces = checkFaces(*volume.mesh, volume.adjacency, eye, ranksOf(order));
                QVERIFY(faces.compared > order.cells.size());
                QCOMPARE(faces.wrong, std::size_t(0));
            }
        }
}

void VisibilityOrderTest::nearlyInPlanesOfFaces_data()
{
    QTest::addColumn<TetrahedralMesh>("mesh");
    QTest::addRow("lattice cut in five") << boxLattice(6, Split::Five);
    QTest::addRow("lattice cut in six") << boxLattice(6, Split::Six);
    for (const double most : {0.0, 0.01, 0.12})
        QTest::addRow("lattice shaken by %g", most) << shakenLattice(static_cast<float>(most));
    for (const NamedMesh& named : delaunayMeshes())
        QTest::addRow("Delaunay, %s", named.name.c_str()) << named.mesh;
}

/// The first of these eyes lies beside a plane of diagonal faces by what rounding left of it, less than 1e-15.
void VisibilityOrderTest::nearlyInPlanesOfFaces()
{
    QFETCH(TetrahedralMesh, mesh);
    const VolumeMesh volume = volumeOf(mesh);
    std::mt19937 random(17);
    std::vector<EyePoint> eyes = eyesAtFaces(mesh, 300, random);
    QVERIFY(!eyes.empty());
    eyes.push_back({{-9, 5 + 1e-9, 1e-9}, true});
    for (const double tilt : {1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16}) {
        eyes.push_back({Vector3d(1, 0, 0) + tilt * Vector3d(1, 0.7, -0.4), false});
        eyes.push_back({Vector3d(1, 1, 0) / std::sqrt(2) + tilt * Vector3d(0.3, 0.7, -0.4), false});
        eyes.push_back({volume.bounds.center() + 1000 * (Vector3d(0, 1, 0) + tilt * Vector3d(1, 0.7, -0.4)), true});
    }
    for (const EyePoint& eye : eyes) {
        const VisibilityOrder order = orderByAdjacency(mesh, volume.adjacency, eye);
        QCOMPARE(order.brokenCycles, std::size_t(0));
        const FacesInOrder faces = checkFaces(mesh, volume.adjacency, eye, ranksOf(order));
        QVERIFY(faces.compared > 0);
        QVERIFY2(faces.wrong == 0, qPrintable(QString("%1 of %2 faces are wrong, %3 from (%4, %5, %6)")
                                                  .arg(faces.wrong)
                                                  .arg(faces.compared)
                                                  .arg(eye.perspective ? "seen" : "parallel")
                                                  .arg(eye.place.x(), 0, 'g', 17)
                                                  .arg(eye.place.y(), 0, 'g', 17)
                                                  .arg(eye.place.z(), 0, 'g', 17)));
    }
}

/// Where the way to a corner is shorter than what rounding does to the volume of a thin cell.
void VisibilityOrderTest::besideAVertexAtTheOrigin()
{
    std::mt19937 random(18);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    for (int round = 0; round < 200; ++round) {
        TetrahedralMesh mesh = oneCell();
        mesh.positions = {{0, 0, 0}};
        for (int corner = 0; corner < 3; ++corner) {
            const float x = coordinate(random), y = coordinate(random);
            mesh.positions.emplace_back(x, y, (x + y) / 3); // but for rounding in one plane
        }
        const std::array<double, 3> eye{1e-25 * coordinate(random), 1e-25 * coordinate(random), 1e-25};
        const unsigned facing = classifyFaces(mesh, {{eye[0], eye[1], eye[2]}, true})[0];
        for (std::size_t face = 0; face < 4; ++face) {
            const auto at = [&](std::size_t i) {
                const Eigen::Vector3d& p = mesh.positions[cornersOfFace[face][i]];
                return std::array<double, 3>{p.x(), p.y(), p.z()};
            };
            const int side = orientationSign(at(0), at(1), at(2), eye);
            QCOMPARE(facing >> face & 0x11u, side > 0 ? 1u : side < 0 ? 16u : 0u);
        }
    }
}

void VisibilityOrderTest::tellsConvexDomains()
{
    const auto isConvex = [](const TetrahedralMesh& mesh) { return volumeOf(mesh).convex; };
    QVERIFY(isConvex(oneCell()));
    QVERIFY(isConvex(refinedLattice()));
    QVERIFY(isConvex(randomLattice(1)));
    QVERIFY(!isConvex(irregularWithHole()));
    QVERIFY(!isConvex({}));

    TetrahedralMesh two = oneCell();
    for (std::size_t i = 0; i < 4; ++i) {
        two.positions.push_back(two.positions[i] + Eigen::Vector3d(5, 0, 0));
        two.values.push_back(0);
    }
    two.tetrahedra.push_back({4, 5, 6, 7});
    QVERIFY(!isConvex(two));

    TetrahedralMesh dented = latticeMesh(2, 1, Split::Six, [](const Vector3d&) { return 0; });
    QVERIFY(isConvex(dented));
    dented.positions[4].z() += 0.01f; // in the middle of the lower side, inwards
    QVERIFY(!isConvex(dented));
}

/// Whether what comes first hides what comes later, in no sample the other way around: of the tetrahedra `cells` in
/// this order.
bool isOrdered(const std::vector<std::array<Vector3d, 4>>& cells, const EyePoint& eye, std::mt19937& random)
{
    // Where a ray enters and leaves, along it; nothing where it does not meet the cell.
    const auto passed = [](const std::array<Vector3d, 4>& cell, const Vector3d& start, const Vector3d& direction) {
        double enter = -1e300, leave = 1e300;
        for (std::size_t face = 0; face < 4; ++face) {
            const Vector3d a = cell[cornersOfFace[face][0]], b = cell[cornersOfFace[face][1]],
                           c = cell[cornersOfFace[face][2]];
            Vector3d inwards = (b - a).cross(c - a);
            if (inwards.dot(cell[face] - a) < 0)
                inwards = -inwards;
            const double rise = inwards.dot(direction), height = inwards.dot(start - a);
            if (rise > 0)
                enter = std::max(enter, -height / rise);
            else if (rise < 0)
                leave = std::min(leave, -height / rise);
            else if (height < 0)
                return std::pair(1.0, 0.0);
        }
        return std::pair(enter, leave);
    };
    std::uniform_real_distribution<double> across(-1.5, 1.5);
    for (int ray = 0; ray < 2000; ++ray) {
        const Vector3d through(across(random), across(random), 0);
        const Vector3d start = eye.perspective ? eye.place : through;
        const Vector3d direction = eye.perspective ? (through - eye.place).eval() : (-eye.place).eval();
        double last = -1e300;
        for (const auto& cell : cells) {
            const auto [enter, leave] = passed(cell, start, direction);
            if (!(leave > enter + 1e-6))
                continue;
            if (enter < last - 1e-6)
                return false;
            last = std::max(last, leave);
        }
    }
    return true;
}

void VisibilityOrderTest::cyclesAreCut_data()
{
    QTest::addColumn<bool>("perspective");
    QTest::addColumn<bool>("fromBehind");
    QTest::newRow("perspective") << true << false;
    QTest::newRow("orthographic") << false << false;
    QTest::newRow("perspective, from behind") << true << true;
    QTest::newRow("orthographic, from behind") << false << true;
}

/// C13, S14: what hides itself in a circle is cut until there is an order. The blades lie so that each is before the
/// next, as a geometric fact; no whole blade comes first.
void VisibilityOrderTest::cyclesAreCut()
{
    QFETCH(bool, perspective);
    QFETCH(bool, fromBehind);
    std::mt19937 random(23);
    TetrahedralMesh mesh = pinwheel();
    const auto field = [](const Eigen::Vector3d& at) { return 0.5f + at.dot(Eigen::Vector3d(0.3f, -0.2f, 0.1f)); };
    std::ranges::transform(mesh.positions, mesh.values.begin(), field);
    const VolumeMesh volume = volumeOf(mesh);
    const EyePoint eye{{0, 0, (perspective ? 5.0 : 1.0) * (fromBehind ? 1 : -1)}, perspective};
    std::vector<CellRelation> circle = {{0, 1}, {1, 2}, {2, 0}};
    if (fromBehind)
        for (CellRelation& relation : circle)
            std::swap(relation.front, relation.back);
    const VisibilityOrder order = orderByAdjacency(mesh, volume.adjacency, eye, circle);
    QCOMPARE(order.cycles, std::size_t(1));
    QCOMPARE(order.brokenCycles, std::size_t(0));
    QVERIFY(order.pieces.cutCells >= 1 && order.pieces.cutCells <= 3);
    std::vector<std::array<Vector3d, 4>> drawn;
    std::array<double, 3> volumes{};
    for (const std::uint32_t number : order.cells) {
        const bool isPiece = number >= mesh.tetrahedra.size();
        const std::size_t piece = number - mesh.tetrahedra.size();
        const auto& corners = isPiece ? order.pieces.tetrahedra.at(piece) : mesh.tetrahedra[number];
        std::array<Vector3d, 4> cell;
        for (std::size_t i = 0; i < 4; ++i) {
            const bool isNew = corners[i] >= mesh.positions.size();
            cell[i] =
                (isNew ? order.pieces.positions.at(corners[i] - mesh.positions.size()) : mesh.positions[corners[i]])
                    .cast<double>();
        }
        const double size = std::abs((cell[1] - cell[0]).dot((cell[2] - cell[0]).cross(cell[3] - cell[0])));
        volumes.at(isPiece ? order.pieces.cells.at(piece) : number) += size;
        drawn.push_back(cell);
    }
    QVERIFY(isOrdered(drawn, eye, random));
    QVERIFY(!order.pieces.positions.empty()); // which have the cells' values
    for (std::size_t i = 0; i < order.pieces.positions.size(); ++i)
        QVERIFY(std::abs(order.pieces.values.at(i) - field(order.pieces.positions[i])) < 1e-5f);
    for (std::size_t cell = 0; cell < 3; ++cell) { // nothing is lost, nothing comes twice
        const auto at = [&](std::size_t i) -> Vector3d {
            return mesh.positions[mesh.tetrahedra[cell][i]].cast<double>();
        };
        const double whole = std::abs((at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))));
        QVERIFY2(std::abs(volumes[cell] - whole) < 1e-5 * whole, qPrintable(QString::number(volumes[cell] / whole)));
    }
}

/// However many cells lie in order before a cycle or behind it.
void VisibilityOrderTest::onlyWhatCyclesHoldBackIsSearched()
{
    constexpr std::uint32_t more = 1000;
    for (const bool behind : {true, false}) {
        TetrahedralMesh mesh = pinwheel();
        std::vector<CellRelation> relations = {{0, 1}, {1, 2}, {2, 0}};
        for (std::uint32_t cell = 3; cell < 3 + more; ++cell) {
            const auto base = static_cast<std::uint32_t>(mesh.positions.size());
            const float z = (behind ? 2.0f : -2.0f) + 0.001f * static_cast<float>(behind ? cell : more - cell);
            for (const Eigen::Vector3d& corner : {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 0.0005f}})
                mesh.positions.emplace_back(corner + Eigen::Vector3d(0, 0, z));
            mesh.values.insert(mesh.values.end(), 4, 0.5f);
            mesh.tetrahedra.push_back({base, base + 1, base + 2, base + 3});
            const std::uint32_t last = cell == 3 ? 0 : cell - 1;
            relations.push_back(behind ? CellRelation{last, cell} : CellRelation{cell, last});
        }
        const VolumeMesh volume = volumeOf(mesh);
        const EyePoint eye{{0, 0, -5}, true};
        const Buffer<std::uint8_t> facing = classifyFaces(mesh, eye);
        const OcclusionGraph graph{volume.adjacency, facing, relations};
        TopologicalSort front(graph, OrderEnd::Front), back(graph, OrderEnd::Back);
        front.take(graph.cellCount() - graph.cellCount() / 2); // as orderByAdjacency() does it
        back.take(graph.cellCount() / 2);
        front.leave(back.taken());
        front.take(graph.cellCount());
        std::vector<std::uint32_t> held = heldByCycles(graph.cellCount(), front, back);
        std::ranges::sort(held);
        QCOMPARE(held, (std::vector<std::uint32_t>{0, 1, 2}));
        const VisibilityOrder order = orderByAdjacency(mesh, volume.adjacency, eye, relations);
        QCOMPARE(order.cycles, std::size_t(1));
        const auto ranks = ranksOf(order);
        for (std::uint32_t cell = 4; cell < 3 + more; ++cell)
            QCOMPARE(ranks[cell - 1] < ranks[cell], behind);
    }
}

/// Two cells in one place: no cut tells which is before the other.
void VisibilityOrderTest::overlapsAreCounted()
{
    TetrahedralMesh mesh = oneCell();
    mesh.tetrahedra.push_back(mesh.tetrahedra[0]);
    const VolumeMesh volume = volumeOf(mesh);
    const std::vector<CellRelation> circle = {{0, 1}, {1, 0}};
    const VisibilityOrder order = orderByAdjacency(mesh, volume.adjacency, {{0, 0, -5}, true}, circle);
    QCOMPARE(order.brokenCycles, std::size_t(1));
    QCOMPARE(order.pieces.cutCells, std::size_t(0));
    QVERIFY(order.cells.size() == 2 && order.cells[0] != order.cells[1]);

    // Of what both have the nearer one's comes first.
    for (const float nearer : {-0.01f, 0.01f})
        for (const bool perspective : {true, false}) {
            TetrahedralMesh two = oneCell();
            for (std::size_t i = 0; i < 4; ++i) {
                two.positions.push_back(two.positions[i] + Eigen::Vector3d(0, 0, nearer));
                two.values.push_back(two.values[i]);
            }
            two.tetrahedra.push_back({4, 5, 6, 7});
            const EyePoint before{{0, 0, perspective ? -5.0 : -1.0}, perspective};
            const VisibilityOrder found = orderByAdjacency(two, volumeOf(two).adjacency, before, circle);
            QCOMPARE(found.brokenCycles, std::size_t(1));
            std::array<std::pair<double, std::size_t>, 2> largest{}; // piece of each cell, and its rank
            for (std::size_t rank = 0; rank < found.cells.size(); ++rank) {
                const bool isPiece = found.cells[rank] >= 2;
                const auto& corners =
                    isPiece ? found.pieces.tetrahedra.at(found.cells[rank] - 2) : two.tetrahedra[found.cells[rank]];
                const auto at = [&](std::size_t i) {
                    return corners[i] < 8 ? two.positions[corners[i]] : found.pieces.positions.at(corners[i] - 8);
                };
                const double size = std::abs(double((at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0)))));
                auto& kept = largest.at(isPiece ? found.pieces.cells.at(found.cells[rank] - 2) : found.cells[rank]);
                kept = std::max(kept, std::pair(size, rank));
            }
            QCOMPARE(largest[1].second < largest[0].second, nearer < 0);
        }
}

void VisibilityOrderTest::driftIsTheAngleOfTheEye()
{
    const Eigen::AlignedBox3d bounds(Vector3d(0, 0, 0), Vector3d(1, 1, 1));
    Camera camera = fitted({}, bounds);
    Camera wider = camera;
    wider.fieldOfView = 50;
    QCOMPARE(orderDrift(bounds, camera, wider), 0.0);
    camera.elevation = 0;
    const double turn = orderDrift(bounds, camera, turned(camera, 2, 0));
    QVERIFY(turn >= 2 - 1e-9 && turn < 3);
    QVERIFY(orderDrift(bounds, camera, zoomed(camera, 0.9)) > 0.1);
    QCOMPARE(orderDrift(bounds, camera, zoomed(camera, 0.01)), 180.0);
    Camera parallel = camera;
    parallel.perspective = false;
    QCOMPARE(orderDrift(bounds, camera, parallel), 180.0);
    QCOMPARE(orderDrift(bounds, parallel, panned(zoomed(parallel, 0.5), 0.1, 0.2)), 0.0);
    QVERIFY(std::abs(orderDrift(bounds, parallel, turned(parallel, 2, 0)) - 2) < 1e-9);
}

QTEST_GUILESS_MAIN(VisibilityOrderTest)
#include "visibility_order_test.moc"
