// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes in spatial order, and the ranges of values of their chunks.
#include "core/geometry/hilbert_order.h"
#include "core/mesh/spatial_order.h"
#include "tests/core/render/lattice_mesh.h"

#include <tan/mesh.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

using namespace tetra;
using testing::latticeMesh;
using testing::Split;

namespace {

/// Vertices and tetrahedra of a lattice in random order, with random values.
TetrahedralMesh shuffledMesh(std::uint32_t cells, unsigned seed)
{
    std::mt19937 random(seed);
    TetrahedralMesh lattice = latticeMesh(cells, 1, Split::Five, [&](const auto&) { return double(random() % 1000); });
    std::vector<std::uint32_t> numbers(lattice.positions.size());
    for (std::uint32_t v = 0; v < numbers.size(); ++v)
        numbers[v] = v;
    std::ranges::shuffle(numbers, random);
    TetrahedralMesh mesh = lattice;
    for (std::size_t v = 0; v < numbers.size(); ++v) {
        mesh.positions[numbers[v]] = lattice.positions[v];
        mesh.values[numbers[v]] = lattice.values[v];
    }
    for (auto& cell : mesh.tetrahedra)
        for (std::uint32_t& vertex : cell)
            vertex = numbers[vertex];
    std::ranges::shuffle(mesh.tetrahedra, random);
    return mesh;
}

using Vertex = std::tuple<float, float, float, float>;

Vertex vertexOf(const TetrahedralMesh& mesh, std::size_t v)
{
    const auto& position = mesh.positions[v];
    return {position.x(), position.y(), position.z(), mesh.values[v]};
}

std::vector<Vertex> sortedVertices(const TetrahedralMesh& mesh)
{
    std::vector<Vertex> vertices;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        vertices.push_back(vertexOf(mesh, v));
    std::ranges::sort(vertices);
    return vertices;
}

/// The tetrahedra by places and values of their corners.
std::vector<std::array<Vertex, 4>> sortedCells(const TetrahedralMesh& mesh)
{
    std::vector<std::array<Vertex, 4>> cells;
    for (const auto& cell : mesh.tetrahedra) {
        auto& corners = cells.emplace_back();
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = vertexOf(mesh, cell[i]);
    }
    std::ranges::sort(cells);
    return cells;
}

/// The mean volume of the boxes around the chunks' corners.
double meanChunkVolume(const TetrahedralMesh& mesh)
{
    double sum = 0;
    const std::size_t chunks = mesh.tetrahedra.size() / rangedChunkSize;
    for (std::size_t c = 0; c < chunks; ++c) {
        Eigen::Vector3d low(2, 2, 2), high(-1, -1, -1);
        for (std::size_t t = c * rangedChunkSize; t < (c + 1) * rangedChunkSize; ++t)
            for (const std::uint32_t vertex : mesh.tetrahedra[t]) {
                low = low.cwiseMin(mesh.positions[vertex]);
                high = high.cwiseMax(mesh.positions[vertex]);
            }
        sum += double((high - low).prod());
    }
    return sum / double(chunks);
}

} // namespace

class SpatialOrderTest : public QObject {
    Q_OBJECT

private slots:
    void isTheSameMesh()
    {
        for (const std::uint32_t cells : {1u, 2u, 5u, 13u}) {
            TetrahedralMesh mesh = shuffledMesh(cells, cells);
            mesh.positions.emplace_back(0.5f, 0.5f, 0.5f); // without a tetrahedron
            mesh.values.push_back(-1);
            const TetrahedralMesh ordered = inSpatialOrder(mesh).value();
            QVERIFY(sortedVertices(ordered) == sortedVertices(mesh));
            QVERIFY(sortedCells(ordered) == sortedCells(mesh));
            const auto smallest = [](const auto& cell) { return std::ranges::min(cell); };
            QVERIFY(std::ranges::is_sorted(ordered.tetrahedra, {}, smallest));
        }
    }

    /// Chunks of 512 of 40,960 tetrahedra: of the unit cube an eightieth would be the least. Their boxes are twice
    /// that.
    void whatIsNearIsTogether()
    {
        const TetrahedralMesh mesh = shuffledMesh(20, 3);
        QVERIFY(meanChunkVolume(mesh) > 0.9);
        QVERIFY(meanChunkVolume(inSpatialOrder(mesh).value()) < 0.05);
    }

    /// One cube after its neighbour, without a jump.
    void keysFollowACurve()
    {
        constexpr std::size_t side = 16;
        Buffer<Eigen::Vector3d> points;
        for (std::size_t i = 0; i < side * side * side; ++i)
            points.emplace_back(float(i % side), float(i / side % side), float(i / side / side));
        points.emplace_back(side, side, side); // the box ends at a side of a cube
        Buffer<KeyedIndex> keys = spatialKeys(points);
        keys.pop_back();
        std::ranges::sort(keys, {}, &KeyedIndex::key);
        QVERIFY(!keys.empty());
        for (std::size_t i = 1; i < keys.size(); ++i)
            QCOMPARE((points[keys[i].index] - points[keys[i - 1].index]).lpNorm<1>(), 1.0f);
    }

    void sameWithAnyNumberOfThreads()
    {
        const TetrahedralMesh mesh = shuffledMesh(40, 5);
        const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 5);
        const auto run = [&](int threads) {
            tbb::task_arena arena(threads);
            return arena.execute([&] { return inSpatialOrder(mesh).value(); });
        };
        const TetrahedralMesh one = run(1);
        const TetrahedralMesh many = run(5);
        QVERIFY(many.positions == one.positions);
        QVERIFY(many.values == one.values);
        QVERIFY(many.tetrahedra == one.tetrahedra);
    }

    void rangesHoldTheValues()
    {
        std::mt19937 random(9);
        TetrahedralMesh mesh = shuffledMesh(12, 4);
        for (float& value : mesh.values)
            if (random() % 50 == 0)
                value = std::nanf("");
        const Buffer<ChunkRange> ranges = chunkRanges(mesh);
        QCOMPARE(ranges.size(), (mesh.tetrahedra.size() + rangedChunkSize - 1) / rangedChunkSize);
        for (std::size_t c = 0; c < ranges.size(); ++c) {
            float smallest = std::numeric_limits<float>::infinity();
            float largest = -smallest;
            bool hasNan = false;
            for (std::size_t t = c * rangedChunkSize; t < std::min(mesh.tetrahedra.size(), (c + 1) * rangedChunkSize);
                 ++t)
                for (const std::uint32_t vertex : mesh.tetrahedra[t]) {
                    hasNan = hasNan || std::isnan(mesh.values[vertex]);
                    smallest = std::fmin(smallest, mesh.values[vertex]);
                    largest = std::fmax(largest, mesh.values[vertex]);
                }
            QCOMPARE(ranges[c].largest, largest);
            QCOMPARE(ranges[c].smallest, hasNan ? -std::numeric_limits<float>::infinity() : smallest);
            QVERIFY(ranges[c].crossedAt(double(largest)));
            QVERIFY(!ranges[c].crossedAt(double(largest) + 1e-3));
            QVERIFY(ranges[c].crossedAt(double(smallest)) == hasNan);
        }
        QVERIFY(chunkRanges({}).empty());
    }

    void strangePositions()
    {
        TetrahedralMesh mesh = shuffledMesh(3, 8);
        mesh.positions[5] = Eigen::Vector3d::Constant(std::nanf(""));
        mesh.positions[6] = Eigen::Vector3d::Constant(std::numeric_limits<float>::infinity());
        mesh.positions[7] = Eigen::Vector3d::Constant(-std::numeric_limits<float>::infinity());
        mesh.positions[8] = Eigen::Vector3d::Constant(3e38f);
        mesh.positions[9] = Eigen::Vector3d::Constant(-3e38f);
        QCOMPARE(inSpatialOrder(mesh).value().tetrahedra.size(), mesh.tetrahedra.size());
        for (auto& position : mesh.positions)
            position = {1, 2, 3};
        QVERIFY(inSpatialOrder(mesh).value().positions == mesh.positions);
    }

    void emptyWrongAndCancelled()
    {
        QVERIFY(inSpatialOrder({}).value().tetrahedra.empty());
        TetrahedralMesh mesh = shuffledMesh(3, 2);
        std::stop_source stop;
        double last = -1;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            QVERIFY(fraction >= last && fraction <= 1);
            last = fraction;
        });
        QVERIFY(inSpatialOrder(mesh, progress).ok());
        QCOMPARE(last, 1.0);
        stop.request_stop();
        last = -1;
        QCOMPARE(inSpatialOrder(mesh, progress).error().kind, ErrorKind::Cancelled);
        mesh.tetrahedra[7][2] = static_cast<std::uint32_t>(mesh.positions.size());
        QCOMPARE(inSpatialOrder(mesh).error().kind, ErrorKind::WrongUsage);
        mesh.values.pop_back();
        QCOMPARE(inSpatialOrder(mesh).error().kind, ErrorKind::WrongUsage);
    }
};

QTEST_GUILESS_MAIN(SpatialOrderTest)
#include "spatial_order_test.moc"
