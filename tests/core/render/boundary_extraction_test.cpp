// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a mesh as a surface: against faces counted one by one, volumes and shapes whose normals are known.
#include "tests/core/render/holed_mesh.h"

#include <tan/render.h>

#include <QTest>

#include <map>
#include <numbers>
#include <stop_token>

using namespace tetra;
using namespace tetra::testing;

namespace {

using Place = std::array<double, 3>;

Place placeOf(const Eigen::Vector3d& position)
{
    return {position.x(), position.y(), position.z()};
}

Eigen::Vector3d cornerOf(const TriangleMesh& surface, const std::array<std::uint32_t, 3>& triangle, std::size_t corner)
{
    return surface.positions[triangle[corner]].cast<double>();
}

Eigen::Vector3d normalOf(const TriangleMesh& surface, const std::array<std::uint32_t, 3>& triangle)
{
    const Eigen::Vector3d first = cornerOf(surface, triangle, 0);
    return (cornerOf(surface, triangle, 1) - first).cross(cornerOf(surface, triangle, 2) - first).normalized();
}

/// The faces that one cell alone has, each as the places of its corners in order.
std::map<std::array<Place, 3>, int> facesOfOneCell(const TetrahedralMesh& mesh)
{
    std::map<std::array<Place, 3>, int> faces;
    for (const auto& t : mesh.tetrahedra)
        for (std::size_t left = 0; left < 4; ++left) {
            std::array<Place, 3> face;
            for (std::size_t corner = 0; corner < 3; ++corner)
                face[corner] = placeOf(mesh.positions[t[(left + 1 + corner) % 4]]);
            std::ranges::sort(face);
            ++faces[face];
        }
    std::erase_if(faces, [](const auto& face) { return face.second != 1; });
    return faces;
}

double volumeOf(const TetrahedralMesh& mesh)
{
    double volume = 0;
    for (const auto& t : mesh.tetrahedra) {
        const auto at = [&](std::size_t corner) { return mesh.positions[t[corner]].cast<double>().eval(); };
        volume += (at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))) / 6;
    }
    return volume;
}

/// A prism of `sides` faces around the axis z, of tetrahedra.
TetrahedralMesh prism(std::uint32_t sides)
{
    TetrahedralMesh mesh;
    for (const float z : {0.0f, 1.0f}) {
        mesh.positions.emplace_back(0.0f, 0.0f, z);
        for (std::uint32_t side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides;
            mesh.positions.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), z);
        }
    }
    mesh.values.assign(mesh.positions.size(), 0);
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t top = sides + 1, a = 1 + side, b = 1 + (side + 1) % sides;
        // The smaller number decides on the diagonal, so that neighbours agree.
        const std::uint32_t low = std::min(a, b), high = std::max(a, b);
        mesh.tetrahedra.push_back({0, a, b, top});
        mesh.tetrahedra.push_back({a, b, top, top + high});
        mesh.tetrahedra.push_back({low, top, top + a, top + b});
    }
    for (auto& t : mesh.tetrahedra) {
        const auto edge = [&](std::size_t corner) -> Eigen::Vector3d {
            return mesh.positions[t[corner]] - mesh.positions[t[0]];
        };
        if (edge(1).dot(edge(2).cross(edge(3))) < 0)
            std::swap(t[2], t[3]);
    }
    return mesh;
}

} // namespace

class BoundaryExtractionTest : public QObject {
    Q_OBJECT

private slots:
    void eachFaceOnceAndOutwards_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 0; seed < 12; ++seed)
            QTest::addRow("%u", seed) << seed;
    }
    void eachFaceOnceAndOutwards()
    {
        QFETCH(unsigned, seed);
        const TetrahedralMesh mesh = holedMesh(seed);
        const auto surface = extractBoundary(mesh);
        QVERIFY(surface.ok());
        auto faces = facesOfOneCell(mesh);
        QCOMPARE(surface->triangles.size(), faces.size());
        std::map<std::pair<Place, Place>, int> edges; // how often one way, less the other way
        double volume = 0;
        for (const auto& triangle : surface->triangles) {
            std::array<Place, 3> face;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                face[corner] = placeOf(surface->positions[triangle[corner]]);
                const Place next = placeOf(surface->positions[triangle[(corner + 1) % 3]]);
                ++edges[{face[corner], next}];
                --edges[{next, face[corner]}];
            }
            std::ranges::sort(face);
            QCOMPARE(faces.erase(face), std::size_t(1));
            volume += cornerOf(*surface, triangle, 0)
                          .dot(cornerOf(*surface, triangle, 1).cross(cornerOf(*surface, triangle, 2))) /
                      6;
        }
        QVERIFY(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; }));
        QVERIFY(std::abs(volume - volumeOf(mesh)) < 1e-6);
    }

    void valuesAndNormalsAreThoseOfTheVertices()
    {
        const TetrahedralMesh mesh = holedMesh(3);
        std::map<Place, float> values;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            values[placeOf(mesh.positions[v])] = mesh.values[v];
        const auto surface = extractBoundary(mesh);
        QVERIFY(surface.ok());
        QCOMPARE(surface->values.size(), surface->positions.size());
        QCOMPARE(surface->normals.size(), surface->positions.size());
        QVERIFY(surface->colours.empty());
        for (std::size_t v = 0; v < surface->positions.size(); ++v) {
            QCOMPARE(surface->values[v], values.at(placeOf(surface->positions[v])));
            QVERIFY(std::abs(surface->normals[v].norm() - 1) < 1e-5f);
        }
    }

    /// No triangle is shaded as if it looked elsewhere by more than the edges let it.
    void normalsAreSmoothOnlyWhereTheBoundaryIs()
    {
        const auto box = extractBoundary(latticeMesh(4, 1, Split::Six, [](const Eigen::Vector3d&) { return 0; }));
        QVERIFY(box.ok());
        QCOMPARE(box->positions.size(), std::size_t(6 * 5 * 5)); // once for each side
        for (const auto& triangle : box->triangles)
            for (const std::uint32_t vertex : triangle)
                QVERIFY((box->normals[vertex].cast<double>() - normalOf(*box, triangle)).norm() < 1e-6);

        const auto isRadial = [](const TriangleMesh& surface) {
            std::size_t radial = 0;
            for (std::size_t v = 0; v < surface.positions.size(); ++v) {
                const Eigen::Vector2f across = surface.positions[v].head<2>().cast<float>();
                radial += across.norm() > 0.5f && (surface.normals[v].head<2>() - across).norm() < 1e-3f ? 1 : 0;
            }
            return radial;
        };
        const auto round = extractBoundary(prism(24));
        const auto faceted = extractBoundary(prism(8));
        QVERIFY(round.ok() && faceted.ok());
        QCOMPARE(round->positions.size(), std::size_t(2 * 25 + 2 * 24)); // two lids and the wall
        QCOMPARE(isRadial(*round), std::size_t(2 * 24));
        QCOMPARE(faceted->positions.size(), std::size_t(2 * 9 + 8 * 4));
        QCOMPARE(isRadial(*faceted), std::size_t(0));
        const auto rounder = extractBoundary(prism(8), 50);
        QCOMPARE(isRadial(*rounder), std::size_t(2 * 8));
        const auto flat = extractBoundary(prism(24), 0);
        QCOMPARE(flat->positions.size(), 3 * flat->triangles.size());
    }

    void nothingAndNoAreaAreFine()
    {
        const auto none = extractBoundary(TetrahedralMesh());
        QVERIFY(none.ok() && none->triangles.empty() && none->positions.empty());
        TetrahedralMesh flat = latticeMesh(1, 1, Split::Six, [](const Eigen::Vector3d&) { return 0; });
        for (auto& position : flat.positions)
            position.z() = 0;
        for (auto& position : flat.positions)
            position.y() = 0;
        const auto line = extractBoundary(flat);
        QVERIFY(line.ok() && !line->triangles.empty());
        for (const Eigen::Vector3f& normal : line->normals)
            QVERIFY(std::abs(normal.norm() - 1) < 1e-5f);
    }

    void cancels()
    {
        std::stop_source source;
        source.request_stop();
        const auto surface = extractBoundary(holedMesh(1), usualFeatureAngle, Progress(source.get_token(), {}));
        QVERIFY(!surface && surface.error().kind == ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(BoundaryExtractionTest)
#include "boundary_extraction_test.moc"
