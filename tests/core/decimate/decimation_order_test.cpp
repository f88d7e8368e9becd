// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_orders.h"
#include "core/decimate/decimated_mesh.h"
#include "core/decimate/vertex_star.h"

#include "tests/core/decimate/test_meshes.h"
#include "tests/core/refine/recorded_history.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <vector>

using namespace tetra;

namespace {

/// The tetrahedra that a mesh has now.
TestTetrahedra tetrahedraOf(const DecimatedMesh& mesh)
{
    TestTetrahedra tetrahedra;
    for (const CollapseLog::Coarsest& coarsest : mesh.coarsest())
        tetrahedra.push_back(coarsest.vertices);
    return tetrahedra;
}

/// The angle between two faces of a tetrahedron at their common edge from `at` to `along`.
double dihedralAngle(const Eigen::Vector3d& at, const Eigen::Vector3d& along, const Eigen::Vector3d& one,
                     const Eigen::Vector3d& other)
{
    const Eigen::Vector3d axis = (along - at).normalized();
    const auto across = [&](const Eigen::Vector3d& to) -> Eigen::Vector3d {
        return (to - at - axis * axis.dot(to - at)).normalized();
    };
    return std::acos(std::clamp(across(one).dot(across(other)), -1.0, 1.0));
}

/// 3.1.2 by other formulas: Cramer's rule, and the solid angle as the excess of a spherical triangle.
Eigen::Vector3d plainGradient(const TestMesh& mesh, const TestTetrahedra& tetrahedra, std::uint32_t vertex)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double angles = 0;
    for (auto t : tetrahedra) {
        const auto own = std::ranges::find(t, vertex);
        if (own == t.end())
            continue;
        std::iter_swap(t.begin(), own);
        const auto at = [&](std::size_t corner) { return mesh.positions[t[corner]]; };
        const Eigen::Vector3d a = at(1) - at(0), b = at(2) - at(0), c = at(3) - at(0);
        const auto step = [&](std::size_t corner) { return mesh.values[t[corner]] - mesh.values[vertex]; };
        const Eigen::Vector3d gradient =
            (step(1) * b.cross(c) + step(2) * c.cross(a) + step(3) * a.cross(b)) / a.dot(b.cross(c));
        const double angle = dihedralAngle(at(0), at(1), at(2), at(3)) + dihedralAngle(at(0), at(2), at(1), at(3)) +
                             dihedralAngle(at(0), at(3), at(1), at(2)) - std::numbers::pi;
        sum += angle * gradient;
        angles += angle;
    }
    return sum / angles;
}

/// The vertices of the mesh's boundary faces, by face.
std::vector<std::array<std::uint32_t, 3>> boundaryOf(const TestTetrahedra& tetrahedra)
{
    std::map<std::array<std::uint32_t, 3>, int> count;
    for (const auto& t : tetrahedra)
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<std::uint32_t, 3> face{t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]};
            std::ranges::sort(face);
            ++count[face];
        }
    std::vector<std::array<std::uint32_t, 3>> boundary;
    for (const auto& [face, tetrahedraAtIt] : count)
        if (tetrahedraAtIt == 1)
            boundary.push_back(face);
    return boundary;
}

/// The plane by a decomposition into singular values.
double plainDistance(const TestMesh& mesh, const std::vector<std::array<std::uint32_t, 3>>& boundary,
                     std::uint32_t vertex)
{
    const auto& positions = mesh.physical.empty() ? mesh.positions : mesh.physical;
    std::set<std::uint32_t> around;
    for (const auto& face : boundary)
        if (std::ranges::find(face, vertex) != face.end())
            around.insert(face.begin(), face.end());
    around.erase(vertex);
    if (around.empty())
        return 0;
    Eigen::MatrixX3d places(around.size(), 3);
    Eigen::Index row = 0;
    for (const std::uint32_t other : around)
        places.row(row++) = positions[other];
    const Eigen::RowVector3d middle = places.colwise().mean();
    const Eigen::JacobiSVD<Eigen::MatrixXd> axes(places.rowwise() - middle, Eigen::ComputeThinV);
    return std::abs(axes.matrixV().col(2).dot(positions[vertex].transpose() - middle));
}

/// Of a vertex of a mesh as it is now, with the gradients of the input.
CollapseEstimate plainEstimate(const TestMesh& input, const DecimatedMesh& mesh, const TestTetrahedra& tetrahedra,
                               const std::vector<std::array<std::uint32_t, 3>>& boundary,
                               const std::vector<Eigen::Vector3d>& gradients, std::uint32_t vertex)
{
    CollapseEstimate estimate;
    for (const auto& t : tetrahedra) {
        if (std::ranges::find(t, vertex) == t.end())
            continue;
        for (const std::uint32_t other : t) {
            const double difference = (gradients[vertex] - gradients[other]).norm();
            if (other != vertex && mesh.mayMove(vertex, other) &&
                std::tie(difference, other) < std::tie(estimate.gradientDifference, estimate.target))
                estimate = {other, difference, 0};
        }
    }
    if (estimate.target != DecimatedMesh::none && (!input.box || !input.physical.empty()))
        estimate.planeDistance = plainDistance(input, boundary, vertex);
    return estimate;
}

/// An irregular mesh, a lattice and a curvilinear grid.
std::vector<TestMesh> meshesToEstimate(std::uint32_t seed)
{
    std::vector<TestMesh> meshes{nonconvexMesh(seed, .15), latticeMesh({5, 4, 4}, LatticeCut::Six, seed)};
    TestMesh grid = meshes.back();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moved(-.1, .1);
    for (const Eigen::Vector3d& at : grid.positions)
        grid.physical.emplace_back((3 + at.y()) * std::sin(.25 * at.x()) + moved(random),
                                   (3 + at.y()) * std::cos(.25 * at.x()) + moved(random), 1.5 * at.z() + moved(random));
    meshes.push_back(std::move(grid));
    return meshes;
}

/// The paper's loop by the plainest way: all estimates anew before every step, no queue. The vertices in the order in
/// which they go.
std::vector<std::uint32_t> plainOrder(const TestMesh& input, const DecimationOptions& options)
{
    const DecimationMesh view = input.view();
    DecimatedMesh mesh(view, options);
    const bool warps = !input.box || !input.physical.empty();
    std::vector<Eigen::Vector3d> gradients;
    for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex)
        gradients.push_back(plainGradient(input, input.tetrahedra, vertex));
    std::vector<bool> tagged(mesh.vertexCount(), false), removed(mesh.vertexCount(), false);
    std::vector<std::uint32_t> order;
    float error = 0, warping = 0;
    for (;;) {
        const TestTetrahedra tetrahedra = tetrahedraOf(mesh);
        const auto boundary = boundaryOf(tetrahedra);
        const bool byWarping = warps && options.warpingWeight * double(warping) > double(error);
        std::optional<std::tuple<double, double, std::uint32_t, std::uint32_t>> first;
        for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
            if (tagged[vertex] || removed[vertex])
                continue;
            const CollapseEstimate found = plainEstimate(input, mesh, tetrahedra, boundary, gradients, vertex);
            const double one = byWarping ? found.planeDistance : found.gradientDifference;
            const double other = byWarping ? found.gradientDifference : found.planeDistance;
            const std::tuple entry(one, other, vertex, found.target);
            if (found.target != DecimatedMesh::none && (!first || entry < *first))
                first = entry;
        }
        if (!first)
            return order;
        const auto [one, other, vertex, target] = *first;
        tagged[vertex] = true;
        const DecimatedMesh::Candidate candidate = mesh.judge(vertex, target);
        if (!candidate.exists() || double(candidate.key) > options.stopKey || !mesh.collapse(vertex, candidate))
            continue;
        removed[vertex] = true;
        order.push_back(vertex);
        for (const std::uint32_t touched : mesh.touched())
            tagged[touched] = false;
        for (const CollapseLog::Coarsest& tetrahedron : mesh.coarsest()) {
            error = std::max(error, tetrahedron.error);
            warping = std::max(warping, tetrahedron.warping);
        }
    }
}

} // namespace

/// What exact order is made of, each against the plainest way to do the same.
class DecimationOrderTest : public QObject {
    Q_OBJECT

private slots:
    void theSmallestKeyComesFirst();
    void numbersAreToldApart();
    void theLargestKeyIsKnown();
    void theEstimatesAreThePapers();
    void theOrderIsThePapers();
};

/// Keys rise on the whole, as in a decimation, but smaller ones than the last come in, too; many are equal.
void DecimationOrderTest::theSmallestKeyComesFirst()
{
    using Entry = CollapseQueue::Entry;
    const auto earlier = [](const Entry& one, const Entry& other) {
        return std::tie(one.key, one.vertex) < std::tie(other.key, other.vertex);
    };
    std::mt19937 random(1);
    std::exponential_distribution<float> keys(.1F);
    CollapseQueue queue;
    std::vector<Entry> expected;
    float last = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const bool wantsMore = expected.empty() || random() % 5 < (i < 10000 ? 3U : 2U);
        if (wantsMore) {
            const float key = i % 3 == 0 ? float(random() % 4) / 2 : last * .9F + keys(random);
            const Entry entry{key, static_cast<std::uint32_t>(random()), i, i};
            queue.push(entry);
            expected.insert(std::ranges::upper_bound(expected, entry, earlier), entry);
        } else {
            QCOMPARE(queue.leastKey(), expected.front().key);
            const Entry first = queue.pop();
            QCOMPARE(first.key, expected.front().key);
            QCOMPARE(first.vertex, expected.front().vertex);
            QCOMPARE(first.version, expected.front().version);
            expected.erase(expected.begin());
            last = first.key;
        }
        QCOMPARE(queue.empty(), expected.empty());
    }
}

/// Also more different ones than registers hold.
void DecimationOrderTest::numbersAreToldApart()
{
    std::mt19937 random(2);
    DistinctNumbers finder;
    std::vector<std::uint32_t> distinct;
    for (std::uint32_t size = 0; size < 300; ++size) {
        std::vector<std::uint32_t> numbers(size), places(size), expected;
        const std::uint32_t range = 1 + static_cast<std::uint32_t>(random() % (size / 2 + 2));
        for (std::uint32_t& number : numbers) {
            number = static_cast<std::uint32_t>(random() % range) * 0x01000193U;
            if (std::ranges::find(expected, number) == expected.end())
                expected.push_back(number);
        }
        finder.find(numbers, distinct, places);
        QCOMPARE(distinct, expected);
        for (std::size_t i = 0; i < size; ++i)
            QCOMPARE(distinct[places[i]], numbers[i]);
    }
}

void DecimationOrderTest::theLargestKeyIsKnown()
{
    std::mt19937 random(3);
    for (const std::size_t count : {std::size_t(1), std::size_t(16), std::size_t(17), std::size_t(700)}) {
        KeyTournament tournament(count);
        std::vector<float> keys(count, 0);
        for (int i = 0; i < 3000; ++i) {
            const std::size_t index = random() % count;
            keys[index] = float(random() % 50);
            tournament.set(index, keys[index]);
            QCOMPARE(tournament.largest(), *std::ranges::max_element(keys));
        }
    }
}

/// R11, C8: gradients by solid angles, the most similar neighbour, the plane through the boundary's neighbours.
void DecimationOrderTest::theEstimatesAreThePapers()
{
    for (std::uint32_t seed = 0; seed < 8; ++seed)
        for (const TestMesh& input : meshesToEstimate(seed)) {
            const DecimationMesh view = input.view();
            const DecimationOptions options{.warpingWeight = 1};
            const DecimatedMesh mesh(view, options);
            const auto boundary = boundaryOf(input.tetrahedra);
            std::vector<Eigen::Vector3d> gradients;
            for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
                gradients.push_back(vertexGradient(mesh, vertex));
                const Eigen::Vector3d expected = plainGradient(input, input.tetrahedra, vertex);
                QVERIFY((gradients.back() - expected).norm() < 1e-9 * (1 + expected.norm()));
            }
            double farthest = 0;
            for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
                const CollapseEstimate found = estimateCollapse(mesh, gradients, vertex);
                const CollapseEstimate expected =
                    plainEstimate(input, mesh, input.tetrahedra, boundary, gradients, vertex);
                QCOMPARE(found.target, expected.target);
                QCOMPARE(found.gradientDifference, expected.gradientDifference);
                QVERIFY(std::abs(found.planeDistance - expected.planeDistance) < 1e-9);
                farthest = std::max(farthest, found.planeDistance);
            }
            QCOMPARE(farthest > 0, mesh.warps()); // also that of grids, whose boundary is kept in another space
        }
}

/// R11, C8: which vertex goes next follows from the estimates, from W / E and from the tags alone.
void DecimationOrderTest::theOrderIsThePapers()
{
    std::size_t collapses = 0;
    for (std::uint32_t seed = 0; seed < 3; ++seed)
        for (const TestMesh& input : meshesToEstimate(seed))
            for (const double stopKey : {std::numeric_limits<double>::infinity(), .6}) {
                const DecimationOptions options{.warpingWeight = .7, .stopKey = stopKey};
                const DecimationMesh view = input.view();
                DecimatedMesh mesh(view, options);
                QVERIFY(decimateByEstimates(mesh, options.warpingWeight, options.stopKey, {}));
                const std::vector<std::uint32_t> expected = plainOrder(input, options);
                collapses += expected.size();
                std::vector<std::uint32_t> numbers(mesh.vertexCount());
                std::iota(numbers.begin(), numbers.end(), 0);
                RecordedHistory history;
                QVERIFY(history.begin({.warpingWeight = 1, .delaunay = false}));
                QVERIFY(mesh.log().replay(numbers, mesh.coarsest(), 0, history, {}));
                std::vector<std::uint32_t> order(history.points.rbegin(),
                                                 history.points.rbegin() + mesh.log().collapseCount());
                QCOMPARE(order, expected);
            }
    QVERIFY(collapses > 800); // of one target each many are not legal
}

QTEST_APPLESS_MAIN(DecimationOrderTest)
#include "decimation_order_test.moc"
