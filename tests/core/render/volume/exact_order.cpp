// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/volume/exact_order.h"

#include "core/geometry/orientation.h"
#include "core/mesh/topology.h"
#include "core/refine/free/scattered_delaunay.h"

#include <QtGlobal>

#include <cmath>
#include <map>
#include <random>

namespace tetra::testing {
namespace {

using Eigen::Vector3d;

/// The Delaunay mesh of points, those on one sphere in an order of their own.
TetrahedralMesh delaunayMesh(const std::vector<Vector3d>& points)
{
    ScatteredDelaunay builder(points);
    if (const Status status = builder.start(); !status)
        qFatal("%s", status.error().text().c_str());
    std::map<std::uint32_t, std::array<std::uint32_t, 4>> cells;
    std::vector<bool> inserted(points.size(), false);
    std::uint32_t hint = 0;
    const auto follow = [&] {
        for (const std::uint32_t slot : builder.destroyed())
            cells.erase(slot);
        for (const ScatteredDelaunay::Cell& cell : builder.created()) {
            cells[cell.slot] = cell.points;
            hint = cell.slot;
            for (const std::uint32_t point : cell.points)
                inserted[point] = true;
        }
    };
    follow();
    for (std::uint32_t point = 0; point < points.size(); ++point)
        if (!inserted[point]) {
            builder.insert(point, builder.locate(point, hint));
            follow();
        }
    TetrahedralMesh mesh;
    for (const Vector3d& point : points)
        mesh.positions.push_back(point);
    mesh.values.assign(points.size(), 0.5f);
    for (const auto& [slot, cell] : cells)
        mesh.tetrahedra.push_back(cell);
    return mesh;
}

/// 1 if the eye sees a face of a cell from outside, -1 from inside, 0 if it lies in its plane.
int exactSide(const TetrahedralMesh& mesh, std::size_t cell, std::size_t face, const EyePoint& eye)
{
    const auto exact = [](const Vector3d& point) { return std::array{point.x(), point.y(), point.z()}; };
    std::array<Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = mesh.positions[mesh.tetrahedra[cell][cornersOfFace[face][i]]].cast<double>();
    if (eye.perspective)
        return orientationSign(exact(corners[0]), exact(corners[1]), exact(corners[2]), exact(eye.place));
    // Differences of floats of about the same size are exact.
    return orientationSign({0, 0, 0}, exact(corners[1] - corners[0]), exact(corners[2] - corners[0]), exact(eye.place));
}

} // namespace

std::vector<NamedMesh> delaunayMeshes()
{
    std::mt19937 random(12);
    std::vector<Vector3d> lattice, anywhere;
    for (int i = 0; i < 10 * 10 * 10; ++i)
        if (random() % 3 != 0)
            lattice.emplace_back(i % 10, i / 10 % 10, i / 100);
    std::uniform_real_distribution<float> coordinate(0, 1);
    for (int i = 0; i < 900; ++i) {
        const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
        anywhere.emplace_back(x, y, z * z * z);
    }
    return {{"lattice", delaunayMesh(lattice)}, {"anywhere", delaunayMesh(anywhere)}};
}

std::vector<EyePoint> eyesAround(const Eigen::AlignedBox3d& bounds, std::size_t count, std::mt19937& random)
{
    std::uniform_real_distribution<double> share(-1, 2);
    std::vector<EyePoint> eyes(count);
    for (std::size_t i = 0; i < count; ++i) {
        eyes[i].perspective = i % 2 == 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double place = bounds.min()[axis] + share(random) * bounds.sizes()[axis];
            eyes[i].place[axis] = random() % 3 != 0 ? place : std::round(place) + (random() % 2 == 0 ? 0 : 1e-9);
        }
    }
    return eyes;
}

TetrahedralMesh boxLattice(std::uint32_t cells, Split split)
{
    TetrahedralMesh mesh = latticeMesh(cells, cells, split, [](const Vector3d&) { return 0; });
    for (Eigen::Vector3d& position : mesh.positions)
        position = position.cwiseProduct(Eigen::Vector3d(1, 1.5f, 0.3f));
    return mesh;
}

TetrahedralMesh shakenLattice(float most)
{
    TetrahedralMesh mesh = latticeMesh(10, 10, Split::Six, [](const Vector3d&) { return 0; });
    std::mt19937 random(3);
    std::uniform_real_distribution<float> shift(-most, most);
    for (Eigen::Vector3d& position : mesh.positions)
        for (double& coordinate : position)
            if (coordinate > 0 && coordinate < 10)
                coordinate += shift(random);
    return mesh;
}

std::vector<EyePoint> eyesAtFaces(const TetrahedralMesh& mesh, std::size_t count, std::mt19937& random)
{
    std::uniform_real_distribution<double> anywhere(-4, 4), aside(-1, 1);
    std::uniform_int_distribution<int> nearness(9, 17);
    std::vector<EyePoint> eyes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& cell = mesh.tetrahedra[random() % mesh.tetrahedra.size()];
        const auto& corners = cornersOfFace[random() % 4];
        const auto at = [&](std::size_t corner) -> Vector3d {
            return mesh.positions[cell[corners[corner]]].cast<double>();
        };
        // Quarters are exact on lattices; with both none it is a vertex, with one none the line of an edge.
        const auto share = [&] { return random() % 2 == 0 ? anywhere(random) : std::round(anywhere(random)) / 4; };
        const double one = random() % 4 == 0 ? 0 : share(), other = random() % 2 == 0 ? 0 : share();
        const Vector3d along = one * (at(1) - at(0)) + other * (at(2) - at(0));
        eyes[i].perspective = i % 2 == 0 || along.isZero();
        eyes[i].place = eyes[i].perspective ? Vector3d(at(0) + along) : along;
        if (random() % 4 != 0)
            eyes[i].place += std::pow(10.0, -nearness(random)) * Vector3d(aside(random), aside(random), aside(random));
    }
    return eyes;
}

FacesInOrder checkFaces(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency, const EyePoint& eye,
                        std::span<const std::uint32_t> ranks)
{
    FacesInOrder faces;
    for (std::size_t cell = 0; cell < ranks.size(); ++cell)
        for (std::size_t face = 0; face < 4; ++face) {
            const std::uint32_t neighbour = adjacency.neighbours[cell][face];
            const int side = exactSide(mesh, cell, face, eye);
            if (neighbour == FaceAdjacency::none || side == 0)
                continue;
            ++faces.compared;
            const std::uint32_t other = ranks[FaceAdjacency::cellOf(neighbour)];
            faces.wrong += side > 0 ? (other < ranks[cell] ? 0 : 1) : (other > ranks[cell] ? 0 : 1);
        }
    return faces;
}

} // namespace tetra::testing
