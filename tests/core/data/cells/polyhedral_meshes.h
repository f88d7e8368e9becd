// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_complex.h"
#include "core/data/cells/cell_split.h"

#include <tan/data.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <vector>

namespace tetra {

using PolyhedronFaces = std::vector<std::vector<std::uint64_t>>;

/// Meshes with polyhedra, by the faces of each, whose volumes are known. The faces of a cell come in any order, from
/// any point on and in any orientation; the numbers of points have nothing to do with their places.
class PolyhedralMesh {
public:
    explicit PolyhedralMesh(std::uint32_t seed) : random_(seed) { complex_.offsets = {0}; }

    /// The number of the point at a place: the same for the same place.
    std::uint64_t point(const Eigen::Vector3d& place)
    {
        const auto [found, isNew] =
            points_.emplace(std::array{place[0], place[1], place[2]}, complex_.positions.size());
        if (isNew)
            complex_.positions.push_back(place);
        return found->second;
    }
    void add(PolyhedronFaces faces)
    {
        std::ranges::shuffle(faces, random_);
        for (std::vector<std::uint64_t>& face : faces) {
            std::ranges::rotate(face, face.begin() + std::ptrdiff_t(random_() % face.size()));
            if (random_() % 2 == 0)
                std::ranges::reverse(face);
            complex_.corners.push_back(face.size());
            complex_.corners.insert(complex_.corners.end(), face.begin(), face.end());
        }
        close(CellShape::Polyhedron);
    }
    void add(CellShape shape, const std::vector<std::uint64_t>& corners)
    {
        complex_.corners.insert(complex_.corners.end(), corners.begin(), corners.end());
        close(shape);
    }
    /// As it was made, the points in the order in which cells first had them.
    const CellComplex& inOrder() const { return complex_; }
    /// With the points numbered anew, at random.
    CellComplex complex()
    {
        std::vector<std::uint64_t> numbers(complex_.positions.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = i;
        std::ranges::shuffle(numbers, random_);
        CellComplex result = complex_;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            result.positions[numbers[i]] = complex_.positions[i];
        for (std::size_t cell = 0; cell < result.shapes.size(); ++cell)
            renumber(result, cell, numbers);
        return result;
    }
    std::uint32_t random(std::uint32_t below) { return random_() % below; }

private:
    void close(CellShape shape)
    {
        complex_.shapes.push_back(shape);
        complex_.offsets.push_back(complex_.corners.size());
    }
    static void renumber(CellComplex& complex, std::size_t cell, const std::vector<std::uint64_t>& numbers)
    {
        const bool faces = complex.shapes[cell] == CellShape::Polyhedron;
        std::uint64_t pointsLeft = 0;
        for (std::uint64_t i = complex.offsets[cell]; i < complex.offsets[cell + 1]; ++i) {
            std::uint64_t& corner = complex.corners[i];
            if (faces && pointsLeft == 0) {
                pointsLeft = corner;
                continue;
            }
            corner = numbers[corner];
            --pointsLeft;
        }
    }

    std::mt19937 random_;
    std::map<std::array<double, 3>, std::uint64_t> points_;
    CellComplex complex_;
};

/// The faces of a linear cell.
inline PolyhedronFaces facesOfCell(CellShape shape, std::span<const std::uint64_t> corners)
{
    PolyhedronFaces faces;
    for (const CellTopology::Face& face : cellTopology(shape).faces) {
        faces.emplace_back();
        for (std::uint32_t i = 0; i < face.count; ++i)
            faces.back().push_back(corners[face.corners[i]]);
    }
    return faces;
}

/// The same mesh with some of its cells, one in `every`, as polyhedra, and its points numbered anew.
inline CellComplex withPolyhedra(const CellComplex& cells, std::uint32_t every, std::uint32_t seed)
{
    PolyhedralMesh mesh(seed);
    for (std::size_t cell = 0; cell < cells.shapes.size(); ++cell) {
        std::vector<std::uint64_t> corners;
        for (std::uint64_t i = cells.offsets[cell]; i < cells.offsets[cell + 1]; ++i)
            corners.push_back(mesh.point(cells.positions[cells.corners[i]]));
        if (mesh.random(every) == 0)
            mesh.add(facesOfCell(cells.shapes[cell], corners));
        else
            mesh.add(cells.shapes[cell], corners);
    }
    return mesh.complex();
}

/// A box of cubes of side 2, `size` along each axis, of which those that `isFine` are eight cubes instead, as
/// hexahedra. The others are polyhedra: where a neighbour is fine a side is four faces, and edges have a point in the
/// middle where a cell around them is fine. Volume 8 size^3.
inline PolyhedralMesh refinedCubes(int size, std::uint32_t seed, const std::function<bool(int, int, int)>& isFine)
{
    using Place = Eigen::Vector3i;
    PolyhedralMesh mesh(seed);
    const auto fine = [&](const Place& cell) {
        return (cell.array() >= 0).all() && (cell.array() < size).all() && isFine(cell[0], cell[1], cell[2]);
    };
    const auto pointAt = [&](const Place& place) { return mesh.point(place.cast<double>()); };
    // Of the cells around the middle of an edge or a face, in steps of half a cell.
    const auto anyFineAround = [&](const Place& middle) {
        for (int corner = 0; corner < 8; ++corner) {
            Place cell;
            for (int axis = 0; axis < 3; ++axis) {
                const int side = corner >> axis & 1;
                cell[axis] = middle[axis] % 2 != 0 ? middle[axis] / 2 : middle[axis] / 2 - side;
            }
            if (fine(cell))
                return true;
        }
        return false;
    };
    const auto addCube = [&](const Place& low) {
        std::vector<std::uint64_t> corners;
        for (std::uint32_t i = 0; i < 8; ++i) {
            const std::uint32_t voxel = hexahedronCorner(i);
            corners.push_back(pointAt(low + Place(int(voxel & 1), int(voxel >> 1 & 1), int(voxel >> 2))));
        }
        mesh.add(CellShape::Hexahedron, corners);
    };
    const auto addCoarse = [&](const Place& cell) {
        PolyhedronFaces faces;
        const Place low = 2 * cell;
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side) {
                Place u = Place::Zero(), v = Place::Zero(), origin = low, beyond = cell;
                u[(axis + 1) % 3] = 1;
                v[(axis + 2) % 3] = 1;
                origin[axis] += 2 * side;
                beyond[axis] += 2 * side - 1;
                if (fine(beyond)) {
                    for (int i = 0; i < 2; ++i)
                        for (int j = 0; j < 2; ++j) {
                            const Place at = origin + i * u + j * v;
                            faces.push_back({pointAt(at), pointAt(at + u), pointAt(at + u + v), pointAt(at + v)});
                        }
                    continue;
                }
                faces.emplace_back();
                const std::array<Place, 5> around = {origin, origin + 2 * u, origin + 2 * u + 2 * v, origin + 2 * v,
                                                     origin};
                for (std::size_t i = 0; i < 4; ++i) {
                    faces.back().push_back(pointAt(around[i]));
                    const Place middle = (around[i] + around[i + 1]) / 2;
                    if (anyFineAround(middle))
                        faces.back().push_back(pointAt(middle));
                }
            }
        mesh.add(faces);
    };
    for (int k = 0; k < size; ++k)
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i) {
                const Place cell(i, j, k);
                if (!fine(cell)) {
                    addCoarse(cell);
                    continue;
                }
                for (int part = 0; part < 8; ++part)
                    addCube(2 * cell + Place(part & 1, part >> 1 & 1, part >> 2));
            }
    return mesh;
}

/// The cells of the points of a lattice of cubes of side 4 and of the middles of these cubes: truncated octahedra of
/// volume 32, with six squares and eight hexagons each. `count` along each axis, and their inner ones.
inline PolyhedralMesh truncatedOctahedra(int count, std::uint32_t seed, std::uint32_t& cells)
{
    PolyhedralMesh mesh(seed);
    std::vector<Eigen::Vector3d> corners;
    for (int zero = 0; zero < 3; ++zero)
        for (int order = 0; order < 2; ++order)
            for (int signs = 0; signs < 4; ++signs) {
                Eigen::Vector3d corner(0, 0, 0);
                corner[(zero + 1 + order) % 3] = signs & 1 ? 1 : -1;
                corner[(zero + 2 - order) % 3] = signs & 2 ? 2 : -2;
                corners.push_back(corner);
            }
    std::vector<std::pair<Eigen::Vector3d, double>> planes; // normal, and what it gives on the face
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1})
            planes.emplace_back(sign * Eigen::Vector3d::Unit(axis), 2);
    for (int signs = 0; signs < 8; ++signs)
        planes.emplace_back(Eigen::Vector3d(signs & 1 ? 1 : -1, signs & 2 ? 1 : -1, signs & 4 ? 1 : -1), 3);
    const auto addAt = [&](const Eigen::Vector3d& centre) {
        PolyhedronFaces faces;
        for (const auto& [normal, offset] : planes) {
            std::vector<Eigen::Vector3d> around;
            for (const Eigen::Vector3d& corner : corners)
                if (normal.dot(corner) == offset)
                    around.push_back(corner);
            Eigen::Vector3d middle(0, 0, 0);
            for (const Eigen::Vector3d& corner : around)
                middle += corner / double(around.size());
            const Eigen::Vector3d u = (around[0] - middle).normalized(), v = normal.normalized().cross(u);
            std::ranges::sort(around, {}, [&](const Eigen::Vector3d& corner) {
                return std::atan2(v.dot(corner - middle), u.dot(corner - middle));
            });
            faces.emplace_back();
            for (const Eigen::Vector3d& corner : around)
                faces.back().push_back(mesh.point(centre + corner));
        }
        mesh.add(faces);
        ++cells;
    };
    cells = 0;
    for (int k = 0; k < count; ++k)
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < count; ++i) {
                addAt(4 * Eigen::Vector3d(i, j, k));
                if (std::max({i, j, k}) + 1 < count)
                    addAt(4 * Eigen::Vector3d(i, j, k) + Eigen::Vector3d(2, 2, 2));
            }
    return mesh;
}

/// Blocks of 2 x 2 x 1, each of a cell in the shape of an L, which is concave, and the cube that it leaves, as a
/// hexahedron: `size` along each axis. Volume 4 size^3.
inline PolyhedralMesh lShapes(int size, std::uint32_t seed)
{
    PolyhedralMesh mesh(seed);
    constexpr std::array<std::array<int, 2>, 8> around = {
        {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}};
    for (int k = 0; k < size; ++k)
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i) {
                const auto at = [&](int x, int y, int z) {
                    return mesh.point(Eigen::Vector3d(2 * i + x, 2 * j + y, k + z));
                };
                PolyhedronFaces faces(2);
                for (std::size_t n = 0; n < around.size(); ++n) {
                    const auto& [x, y] = around[n];
                    const auto& [nextX, nextY] = around[(n + 1) % around.size()];
                    faces[0].push_back(at(x, y, 0));
                    faces[1].push_back(at(x, y, 1));
                    faces.push_back({at(x, y, 0), at(nextX, nextY, 0), at(nextX, nextY, 1), at(x, y, 1)});
                }
                mesh.add(faces);
                mesh.add(CellShape::Hexahedron, {at(1, 1, 0), at(2, 1, 0), at(2, 2, 0), at(1, 2, 0), at(1, 1, 1),
                                                 at(2, 1, 1), at(2, 2, 1), at(1, 2, 1)});
            }
    return mesh;
}

} // namespace tetra
