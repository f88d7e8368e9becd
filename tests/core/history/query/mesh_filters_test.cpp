// SPDX-License-Identifier: GPL-3.0-or-later
// What remains of a mesh: by value, by window, cut at a window (R14, S17).
#include "core/history/query/window.h"

#include "core/mesh/topology.h"
#include "tests/core/history/query/nearest_points.h"
#include "tests/core/history/query/some_models.h"

#include <QTemporaryDir>
#include <QTest>

#include <map>
#include <random>

using namespace tetra;
using Eigen::Vector3d;

namespace {

std::array<Vector3d, 4> cornersOf(const TetrahedralMesh& mesh, const Tetrahedron& t)
{
    return {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
            mesh.positions[t[2]].cast<double>(), mesh.positions[t[3]].cast<double>()};
}

double volumeOf(const std::array<Vector3d, 4>& c)
{
    return (c[1] - c[0]).dot((c[2] - c[0]).cross(c[3] - c[0])) / 6;
}

double volumeOf(const TetrahedralMesh& mesh)
{
    double sum = 0;
    for (const Tetrahedron& t : mesh.tetrahedra)
        sum += volumeOf(cornersOf(mesh, t));
    return sum;
}

Box boundsOf(const TetrahedralMesh& mesh)
{
    Box box{Vector3d::Constant(1e30), Vector3d::Constant(-1e30)};
    for (const Eigen::Vector3d& position : mesh.positions) {
        box.least = box.least.cwiseMin(position.cast<double>());
        box.largest = box.largest.cwiseMax(position.cast<double>());
    }
    return box;
}

/// How often each face is there, those of one orientation less those of the other, which must differ by one at most.
std::map<Triangle, std::array<int, 2>> facesOf(const TetrahedralMesh& mesh)
{
    std::map<Triangle, std::array<int, 2>> faces;
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        for (Triangle face : {Triangle{a, b, c}, Triangle{a, c, d}, Triangle{a, d, b}, Triangle{b, d, c}}) {
            bool odd = false;
            for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}})
                if (face[i] > face[j]) {
                    std::swap(face[i], face[j]);
                    odd = !odd;
                }
            ++faces[face][odd ? 1 : 0];
        }
    return faces;
}

bool liesInPlane(const TetrahedralMesh& mesh, const Triangle& face, const Box& box)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const Vector3d& corner : {box.least, box.largest}) {
            if (std::ranges::all_of(face, [&](auto vertex) { return mesh.positions[vertex][axis] == corner[axis]; }))
                return true;
        }
    return false;
}

Box intersection(const Box& one, const Box& other)
{
    return {one.least.cwiseMax(other.least), one.largest.cwiseMin(other.largest)};
}

double volumeOf(const Box& box)
{
    return (box.largest - box.least).cwiseMax(0).prod();
}

} // namespace

class MeshFiltersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const auto models = someModels(folder_.path().toStdString());
        for (const auto& [name, model] : models)
            for (const double error : {40.0, 12.0, 3.0, 0.0}) {
                const MeshSize size = meshSizeAt(*model, {error});
                meshes_.push_back({name, name == "lattice" || name == "bytes", *extractPrefix(*model, size.sites)});
            }
        QVERIFY(!meshes_.empty());
    }

    void valuesAreKeptByTheirRanges()
    {
        std::mt19937 random(1);
        for (const SomeMesh& some : meshes_)
            for (int trial = 0; trial < 20; ++trial) {
                const TetrahedralMesh& mesh = some.mesh;
                std::vector<ValueRange> ranges(1 + random() % 3);
                for (ValueRange& range : ranges) {
                    range.minimum = mesh.values[random() % mesh.values.size()];
                    range.maximum = trial % 2 == 0 ? range.minimum : mesh.values[random() % mesh.values.size()];
                }
                TetrahedralMesh kept = mesh;
                QVERIFY(keepValues(kept, ranges).ok());
                std::vector<Tetrahedron> expected;
                for (const Tetrahedron& t : mesh.tetrahedra)
                    if (std::ranges::any_of(ranges, [&](const ValueRange& range) {
                            const bool below =
                                std::ranges::all_of(t, [&](auto v) { return mesh.values[v] < range.minimum; });
                            const bool above =
                                std::ranges::all_of(t, [&](auto v) { return mesh.values[v] > range.maximum; });
                            return !below && !above && range.minimum <= range.maximum;
                        }))
                        expected.push_back(t);
                QVERIFY2(std::ranges::equal(kept.tetrahedra, expected), some.name.c_str());
                QVERIFY(kept.positions == mesh.positions);
            }
        TetrahedralMesh all = meshes_[3].mesh;
        QVERIFY(keepValues(all, {}).ok());
        QVERIFY(all.tetrahedra == meshes_[3].mesh.tetrahedra);
    }

    void raggedBordersAreThoseOfTheDefinition()
    {
        std::mt19937 random(2);
        int undecided = 0;
        int meeting = 0;
        for (const auto& [name, isBox, mesh] : meshes_)
            for (int trial = 0; trial < 6; ++trial) {
                const Box box = randomWindow(mesh, random);
                TetrahedralMesh contained = mesh;
                TetrahedralMesh intersecting = mesh;
                QVERIFY(keepWindow(contained, {box, WindowBorder::Contained}).ok());
                QVERIFY(keepWindow(intersecting, {box, WindowBorder::Intersecting}).ok());
                auto nextContained = contained.tetrahedra.begin();
                auto nextIntersecting = intersecting.tetrahedra.begin();
                for (const Tetrahedron& t : mesh.tetrahedra) {
                    const auto corners = cornersOf(mesh, t);
                    const bool within = std::ranges::all_of(
                        corners, [&](const Vector3d& corner) { return distanceTo(box, corner) == 0; });
                    const bool isContained = nextContained != contained.tetrahedra.end() && *nextContained == t;
                    QCOMPARE(isContained, within);
                    nextContained += isContained ? 1 : 0;
                    const bool isMet = nextIntersecting != intersecting.tetrahedra.end() && *nextIntersecting == t;
                    nextIntersecting += isMet ? 1 : 0;
                    const auto meets = whetherTheyMeet(box, corners);
                    undecided += meets ? 0 : 1;
                    meeting += meets.value_or(false) ? 1 : 0;
                    if (meets && isMet != *meets)
                        QVERIFY2(touches(box, corners), name.c_str());
                }
                QVERIFY(nextContained == contained.tetrahedra.end());
                QVERIFY(nextIntersecting == intersecting.tetrahedra.end());
            }
        QVERIFY(undecided < meeting / 20 && meeting > 1000);
    }

    void touchingCounts()
    {
        TetrahedralMesh mesh;
        mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
        mesh.values = {1, 2, 3, 4};
        mesh.tetrahedra = {{0, 1, 2, 3}};
        const auto remain = [&](const Box& box) {
            TetrahedralMesh kept = mesh;
            return keepWindow(kept, {box, WindowBorder::Intersecting}).ok() ? int(kept.tetrahedra.size()) : -1;
        };
        QCOMPARE(remain({{1, 1, 1}, {9, 9, 9}}), 1);
        QCOMPARE(remain({{1, 1, 1 + 1e-12}, {9, 9, 9}}), 0);
        QCOMPARE(remain({{2, 1, -1}, {4, 4, 4}}), 1);
        QCOMPARE(remain({{2, 1 + 1e-12, -1}, {4, 4, 4}}), 0);
        QCOMPARE(remain({{-1, -1, -1}, {0, 0, 0}}), 1);
        QCOMPARE(remain({{1, 1, 0}, {1, 1, 0}}), 1); // a point in a face
        QCOMPARE(remain({{2, 2, 0}, {2, 2, 0}}), 0);
        QCOMPARE(remain({{2, 0, 0}, {1, 1, 1}}), 0); // empty windows
        mesh.positions[0] = {-8, -8, -8};
        QCOMPARE(remain({{-1, 0, 0}, {-2, 1, 1}}), 0);
    }

    /// Cutting fills exactly what of the domain lies in the window, without cracks, with positive tetrahedra.
    void cutMeshesConform()
    {
        std::mt19937 random(3);
        int cut = 0;
        for (const auto& [name, isBox, mesh] : meshes_)
            for (int trial = 0; trial < 12; ++trial) {
                const Box box = randomWindow(mesh, random);
                TetrahedralMesh kept = mesh;
                QVERIFY(keepWindow(kept, {box, WindowBorder::Clipped}).ok());
                QVERIFY(std::equal(mesh.positions.begin(), mesh.positions.end(), kept.positions.begin()));
                QCOMPARE(kept.values.size(), kept.positions.size());
                cut += kept.positions.size() > mesh.positions.size() ? 1 : 0;
                const double scale = volumeOf(boundsOf(mesh));
                for (const Tetrahedron& t : kept.tetrahedra) {
                    QVERIFY2(volumeOf(cornersOf(kept, t)) > -1e-6 * scale, name.c_str());
                    for (const std::uint32_t vertex : t)
                        for (int axis = 0; axis < 3; ++axis)
                            QVERIFY(kept.positions[vertex][axis] >= box.least[axis] &&
                                    kept.positions[vertex][axis] <= box.largest[axis]);
                }
                const Box domain = boundsOf(mesh);
                if (isBox) {
                    const double expected = volumeOf(intersection(domain, box));
                    QVERIFY2(std::abs(volumeOf(kept) - expected) < 1e-6 * scale, name.c_str());
                }
                for (const auto& [face, times] : facesOf(kept)) {
                    QVERIFY2(times[0] <= 1 && times[1] <= 1, name.c_str());
                    const bool onBorder = times[0] + times[1] == 1;
                    const bool allowed = liesInPlane(kept, face, box) || liesInPlane(kept, face, domain) || !isBox;
                    QVERIFY2(!onBorder || allowed, name.c_str());
                }
            }
        QVERIFY(cut > 100);
    }

    /// Windows that share faces divide the mesh: whatever the domain, nothing is lost and nothing is there twice.
    void theWindowsOfAGridFillTheDomain()
    {
        std::mt19937 random(4);
        for (const auto& [name, isBox, mesh] : meshes_) {
            const Box domain = boundsOf(mesh);
            const Box middle = randomWindow(mesh, random);
            std::array<std::array<double, 4>, 3> planes{};
            for (int axis = 0; axis < 3; ++axis)
                planes[axis] = {domain.least[axis] - 1, middle.least[axis], middle.largest[axis],
                                domain.largest[axis] + 1};
            double sum = 0;
            for (int cell = 0; cell < 27; ++cell) {
                const std::array<int, 3> at = {cell % 3, cell / 3 % 3, cell / 9};
                Box box;
                for (int axis = 0; axis < 3; ++axis) {
                    box.least[axis] = planes[axis][at[axis]];
                    box.largest[axis] = planes[axis][at[axis] + 1];
                }
                TetrahedralMesh kept = mesh;
                QVERIFY(keepWindow(kept, {box, WindowBorder::Clipped}).ok());
                sum += volumeOf(kept);
            }
            QVERIFY2(std::abs(sum - volumeOf(mesh)) < 1e-5 * volumeOf(mesh), name.c_str());
        }
    }

    /// However many pieces there are, what is told is how many of the tetrahedra are left: each by itself says whether.
    void cutTetrahedraCountOnce()
    {
        std::mt19937 random(8);
        for (const auto& [name, isBox, mesh] : meshes_) {
            if (mesh.tetrahedra.size() > 1000)
                continue;
            const Box box = randomWindow(mesh, random);
            for (const WindowBorder border :
                 {WindowBorder::Intersecting, WindowBorder::Contained, WindowBorder::Clipped}) {
                std::uint64_t expected = 0;
                for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
                    TetrahedralMesh alone = mesh;
                    alone.tetrahedra.assign(1, tetrahedron);
                    QVERIFY(keepWindow(alone, {box, border}).ok());
                    expected += alone.tetrahedra.empty() ? 0 : 1;
                }
                TetrahedralMesh kept = mesh;
                const auto count = keepWindow(kept, {box, border});
                QVERIFY(count.ok());
                QCOMPARE(*count, expected);
                QVERIFY(*count <= kept.tetrahedra.size() && *count <= mesh.tetrahedra.size());
            }
        }
    }

    /// What is linear in space stays that on the new vertices.
    void valuesAreInterpolated()
    {
        std::mt19937 random(5);
        for (const auto& [name, isBox, mesh] : meshes_) {
            TetrahedralMesh kept = mesh;
            const auto linear = [](const Eigen::Vector3d& p) { return 2 * p.x() - p.y() + 0.5f * p.z() + 3; };
            std::ranges::transform(kept.positions, kept.values.begin(), linear);
            QVERIFY(keepWindow(kept, {randomWindow(mesh, random), WindowBorder::Clipped}).ok());
            for (std::size_t vertex = 0; vertex < kept.positions.size(); ++vertex)
                QVERIFY(std::abs(kept.values[vertex] - linear(kept.positions[vertex])) < 1e-4);
        }
    }

    void windowsAroundOrOutside()
    {
        for (const auto& [name, isBox, mesh] : meshes_)
            for (const WindowBorder border :
                 {WindowBorder::Intersecting, WindowBorder::Contained, WindowBorder::Clipped}) {
                const Box domain = boundsOf(mesh);
                TetrahedralMesh all = mesh;
                QVERIFY(keepWindow(all, {domain, border}).ok());
                QVERIFY(all.tetrahedra == mesh.tetrahedra && all.positions == mesh.positions &&
                        all.values == mesh.values);
                const Vector3d away = domain.largest + Vector3d::Constant(1);
                TetrahedralMesh none = mesh;
                QVERIFY(keepWindow(none, {{away, away + Vector3d::Constant(9)}, border}).ok());
                QVERIFY(none.tetrahedra.empty() && none.positions == mesh.positions);
                const double wide = std::numeric_limits<double>::infinity();
                QVERIFY(keepWindow(all, {{Vector3d::Constant(-wide), Vector3d::Constant(wide)}, border}).ok());
                QVERIFY(all.tetrahedra == mesh.tetrahedra);
            }
    }

    void windowsWithoutVolume()
    {
        for (const auto& [name, isBox, mesh] : meshes_) {
            const Box domain = boundsOf(mesh);
            const Vector3d middle = (domain.least + domain.largest) / 2;
            Box plane = domain;
            plane.least.y() = plane.largest.y() = middle.y();
            for (const Box& box : {plane, Box{middle, middle}}) {
                TetrahedralMesh met = mesh;
                TetrahedralMesh cut = mesh;
                TetrahedralMesh contained = mesh;
                QVERIFY(keepWindow(met, {box, WindowBorder::Intersecting}).ok());
                QVERIFY(keepWindow(cut, {box, WindowBorder::Clipped}).ok());
                QVERIFY(keepWindow(contained, {box, WindowBorder::Contained}).ok());
                QVERIFY2(!met.tetrahedra.empty(), name.c_str());
                QVERIFY(cut.tetrahedra.empty() && contained.tetrahedra.empty());
            }
        }
    }

    void unusedVerticesGo()
    {
        std::mt19937 random(6);
        for (const auto& [name, isBox, mesh] : meshes_) {
            ExtractedMesh extracted;
            TetrahedralMesh& kept = extracted.mesh;
            Buffer<std::uint32_t>& sites = extracted.sites;
            kept = mesh;
            QVERIFY(keepWindow(kept, {randomWindow(mesh, random), WindowBorder::Clipped}).ok());
            const TetrahedralMesh before = kept;
            sites.resize(mesh.positions.size());
            for (std::uint32_t site = 0; site < sites.size(); ++site)
                sites[site] = 1000 + site;
            extracted.points = sites;
            dropUnusedVertices(extracted);
            QVERIFY(extracted.points == sites);
            QCOMPARE(extracted.keptSites,
                     std::uint32_t(std::ranges::count_if(sites, [](auto s) { return s != ExtractedMesh::noSite; })));
            QCOMPARE(kept.tetrahedra.size(), before.tetrahedra.size());
            QCOMPARE(sites.size(), kept.positions.size());
            std::vector<bool> used(kept.positions.size());
            std::map<std::uint32_t, std::uint32_t> numbers; // in order
            for (std::size_t t = 0; t < kept.tetrahedra.size(); ++t)
                for (int corner = 0; corner < 4; ++corner) {
                    const std::uint32_t now = kept.tetrahedra[t][corner];
                    const std::uint32_t then = before.tetrahedra[t][corner];
                    used.at(now) = true;
                    QCOMPARE(numbers.try_emplace(then, now).first->second, now);
                    QCOMPARE(kept.positions[now], before.positions[then]);
                    QCOMPARE(kept.values[now], before.values[then]);
                    QCOMPARE(sites[now], then < mesh.positions.size() ? 1000 + then : ExtractedMesh::noSite);
                }
            QVERIFY(std::ranges::all_of(used, std::identity()));
            QVERIFY(std::ranges::is_sorted(numbers, {}, [](const auto& pair) { return pair.second; }));
        }
    }

    void canBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        for (const WindowBorder border : {WindowBorder::Intersecting, WindowBorder::Contained, WindowBorder::Clipped}) {
            TetrahedralMesh mesh = meshes_[3].mesh;
            const Box box{{-2, 11, 1}, {-1, 14, 3}};
            const auto kept = keepWindow(mesh, {box, border}, Progress(stop.get_token(), {}));
            QVERIFY(!kept.ok());
            QCOMPARE(kept.error().kind, ErrorKind::Cancelled);
        }
    }

private:
    struct SomeMesh {
        std::string name;
        bool isBox; ///< whether its domain is one
        TetrahedralMesh mesh;
    };

    /// Through vertices, or not.
    static Box randomWindow(const TetrahedralMesh& mesh, std::mt19937& random)
    {
        const Box domain = boundsOf(mesh);
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            std::uniform_real_distribution<double> anywhere(domain.least[axis] - 0.2, domain.largest[axis] + 0.2);
            const auto coordinate = [&]() -> double {
                return random() % 2 == 0 ? anywhere(random) : mesh.positions[random() % mesh.positions.size()][axis];
            };
            const double one = coordinate();
            const double other = coordinate();
            box.least[axis] = std::min(one, other);
            box.largest[axis] = std::max(one, other);
        }
        return box;
    }

    /// All but: rounding decides.
    static bool touches(const Box& box, const std::array<Vector3d, 4>& corners)
    {
        const Vector3d little = Vector3d::Constant(1e-6);
        return whetherTheyMeet(Box{box.least - little, box.largest + little}, corners) !=
               whetherTheyMeet(Box{box.least + little, (box.largest - little).cwiseMax(box.least + little)}, corners);
    }

    QTemporaryDir folder_;
    std::vector<SomeMesh> meshes_;
};

QTEST_GUILESS_MAIN(MeshFiltersTest)
#include "mesh_filters_test.moc"
