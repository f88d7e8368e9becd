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

using Simplex = std::vector<std::uint32_t>; // sorted

/// Dey and others' link condition by its definition, in the mesh and the cone of its boundary with a dummy vertex; and
/// what collapses on a boundary need besides.
class ClosedComplex {
public:
    explicit ClosedComplex(const TestTetrahedra& tetrahedra) : boundary_(boundaryOf(tetrahedra))
    {
        for (const auto& tetrahedron : tetrahedra)
            add({tetrahedron.begin(), tetrahedron.end()});
        for (const auto& [a, b, c] : boundary_)
            add({a, b, c, dummy});
        tetrahedra_ = tetrahedra;
        for (const Simplex& simplex : simplices_)
            for (const std::uint32_t vertex : simplex) {
                Simplex others = simplex;
                std::erase(others, vertex);
                links_[vertex].push_back(std::move(others));
            }
    }

    bool allows(std::uint32_t vertex, std::uint32_t target) const
    {
        const auto both = std::ranges::count_if(
            boundary_, [&](const auto& triangle) { return has(triangle, vertex) && has(triangle, target); });
        if (both != 2)
            return false;
        // A tetrahedron that vanishes has its face opposite to the target inside.
        for (const auto& tetrahedron : tetrahedra_)
            if (has(tetrahedron, vertex) && has(tetrahedron, target)) {
                std::array<std::uint32_t, 3> face{};
                std::ranges::remove_copy(tetrahedron, face.begin(), target);
                std::ranges::sort(face);
                if (std::ranges::find(boundary_, face) != boundary_.end())
                    return false;
            }
        return violation(vertex, target).empty();
    }
    /// A simplex of both links that the edge's does not have.
    Simplex violation(std::uint32_t vertex, std::uint32_t target) const
    {
        for (const Simplex& one : links_.at(vertex))
            if (!one.empty() && !has(one, target) && simplices_.contains(with(one, {target})) &&
                !simplices_.contains(with(one, {vertex, target})))
                return one;
        return {};
    }
    bool isOnBoundary(std::uint32_t vertex) const
    {
        return std::ranges::any_of(boundary_, [&](const auto& triangle) { return has(triangle, vertex); });
    }

private:
    static constexpr std::uint32_t dummy = 0xffffffff;

    static bool has(const auto& simplex, std::uint32_t vertex)
    {
        return std::ranges::find(simplex, vertex) != simplex.end();
    }
    static Simplex with(Simplex simplex, std::initializer_list<std::uint32_t> more)
    {
        simplex.insert(simplex.end(), more);
        std::ranges::sort(simplex);
        return simplex;
    }
    void add(Simplex simplex)
    {
        std::ranges::sort(simplex);
        for (unsigned mask = 1; mask < 16; ++mask) {
            Simplex part;
            for (unsigned corner = 0; corner < 4; ++corner)
                if ((mask >> corner & 1) != 0)
                    part.push_back(simplex[corner]);
            simplices_.insert(part);
        }
    }

    std::vector<std::array<std::uint32_t, 3>> boundary_;
    TestTetrahedra tetrahedra_;
    std::set<Simplex> simplices_;
    std::map<std::uint32_t, std::vector<Simplex>> links_;
};

/// A vertex and a target on the boundary whose links share an edge that belongs to no tetrahedron with both of them,
/// and else nothing but what they may: two tetrahedra around the edge from 0 to 1, what closes the fan behind them, and
/// one on each side of what the ends of the fan have with either of the two.
TestMesh sharedEdgeMesh()
{
    TestMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 0, -1}, {2, -1, 0}, {2, 1, 0}, {1, 0, 0}, {3, 0, 3}, {3, 0, -3}};
    mesh.values.assign(mesh.positions.size(), 0);
    mesh.tetrahedra = {{0, 1, 2, 4}, {0, 1, 4, 3}, {0, 2, 3, 4}, {1, 2, 4, 3}, {0, 2, 3, 5}, {1, 2, 3, 6}};
    return mesh;
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
    void ofEqualKeysTheSimplestTargetIsTaken();
    void theLinkConditionIsThatOfTheClosedComplex();
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

/// Where nothing tells targets apart by keys, as in a constant field: the one that leaves the fewest tetrahedra, then
/// the nearest, then the first.
void DecimationOrderTest::ofEqualKeysTheSimplestTargetIsTaken()
{
    std::size_t compared = 0;
    for (const LatticeCut cut : {LatticeCut::Five, LatticeCut::Six}) {
        TestMesh input = latticeMesh({5, 4, 4}, cut, 1);
        std::ranges::fill(input.values, 3.0);
        const DecimationMesh view = input.view();
        DecimatedMesh mesh(view, {});
        std::mt19937 random(5);
        for (int step = 0; step < 40; ++step) {
            const TestTetrahedra tetrahedra = tetrahedraOf(mesh);
            std::vector<DecimatedMesh::Candidate> chosen(mesh.vertexCount());
            for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
                std::map<std::uint32_t, std::int64_t> shared; // tetrahedra that a collapse onto each takes away
                for (const auto& tetrahedron : tetrahedra)
                    if (std::ranges::find(tetrahedron, vertex) != tetrahedron.end())
                        for (const std::uint32_t other : tetrahedron)
                            shared[other] += other == vertex ? 0 : 1;
                std::optional<std::tuple<std::int64_t, double, std::uint32_t>> first;
                for (const auto& [target, count] : shared) {
                    if (target == vertex || !mesh.judge(vertex, target).exists())
                        continue;
                    const double distance = (input.positions[target] - input.positions[vertex]).squaredNorm();
                    const std::tuple rank(-count, distance, target);
                    first = first ? std::min(*first, rank) : rank;
                    ++compared;
                }
                chosen[vertex] = mesh.best(vertex);
                QCOMPARE(chosen[vertex].target, first ? std::get<2>(*first) : DecimatedMesh::none);
            }
            std::vector<std::uint32_t> movable;
            for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex)
                if (chosen[vertex].exists())
                    movable.push_back(vertex);
            if (movable.empty())
                break;
            const std::uint32_t vertex = movable[random() % movable.size()];
            QVERIFY(mesh.collapse(vertex, mesh.best(vertex)));
        }
    }
    QVERIFY(compared > 1000);
}

/// On boundaries of any shape, and those that collapses leave, wherever their vertices lie.
void DecimationOrderTest::theLinkConditionIsThatOfTheClosedComplex()
{
    std::vector<TestMesh> meshes{sharedEdgeMesh()};
    for (std::uint32_t seed = 0; seed < 6; ++seed)
        meshes.push_back(nonconvexMesh(seed, .15));
    std::map<std::size_t, int> violations; // by the simplex's vertices
    int allowed = 0;
    for (const TestMesh& input : meshes) {
        std::vector<PlacedValue> points(input.positions.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i].place = {input.positions[i].x(), input.positions[i].y(), input.positions[i].z()};
        CollapsibleMesh mesh(static_cast<std::uint32_t>(points.size()), input.tetrahedra, true);
        std::mt19937 random(6);
        for (int step = 0; step < 12; ++step) {
            TestTetrahedra tetrahedra;
            for (std::uint32_t slot = 0; slot < mesh.slotCount(); ++slot)
                if (mesh.alive(slot))
                    tetrahedra.push_back(mesh.vertices(slot));
            const ClosedComplex complex(tetrahedra);
            std::vector<std::pair<std::uint32_t, std::uint32_t>> legal;
            VertexStar star(points, false);
            LinkCondition condition;
            std::vector<std::uint32_t> asked; // some vertices: the definition takes its time
            for (std::uint32_t vertex = 0; vertex < points.size(); ++vertex)
                if (complex.isOnBoundary(vertex) && (points.size() < 20 || random() % 8 == 0))
                    asked.push_back(vertex);
            for (const std::uint32_t vertex : asked) {
                star.set(mesh, vertex, true);
                if (!star.rimIsOneCycle())
                    continue;
                condition.set(star);
                for (std::uint32_t place = 0; place < star.link().size(); ++place) {
                    const std::uint32_t target = star.link()[place];
                    const bool expected = complex.allows(vertex, target);
                    QCOMPARE(condition.allows(mesh, star, place), expected);
                    if (expected)
                        legal.emplace_back(vertex, target);
                    else
                        ++violations[complex.violation(vertex, target).size()];
                }
            }
            allowed += int(legal.size());
            for (int attempt = 0; attempt < 6 && !legal.empty(); ++attempt) {
                const auto [vertex, target] = legal[random() % legal.size()];
                star.forget();
                star.set(mesh, vertex, true);
                if (star.tetrahedra().empty() || !star.rimIsOneCycle())
                    continue;
                const auto place = std::ranges::find(star.link(), target) - star.link().begin();
                condition.set(star);
                if (std::size_t(place) < star.link().size() &&
                    condition.allows(mesh, star, static_cast<std::uint32_t>(place)))
                    mesh.collapse(vertex, target);
            }
        }
    }
    QVERIFY(allowed > 100 && violations[1] > 20 && violations[2] > 20);
    // The edge alone forbids it.
    const ClosedComplex complex(sharedEdgeMesh().tetrahedra);
    QCOMPARE(complex.violation(0, 1), (Simplex{2, 3}));
    QVERIFY(!complex.allows(0, 1));
}

QTEST_APPLESS_MAIN(DecimationOrderTest)
#include "decimation_order_test.moc"
