// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_split.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// How a polyhedron is cut into tetrahedra so that neighbours agree without knowing of each other. The triangles of a
/// face follow from its points alone: it is fanned from the smallest of them from which no triangle is flat or turned
/// over, which is the rule of splitCell() wherever that gives triangles at all. The cell is then what one of its
/// corners sees, if one sees all triangles that it is not a corner of from their inner sides; or what a search finds
/// (fillCavity()); or what a new point in its middle sees.

/// Calls visit(points) for each face of a polyhedron that stands as in CellShape::Polyhedron. False if the last one is
/// not whole.
template <class Number, class Visit> bool forFaces(std::span<const Number> faces, const Visit& visit)
{
    while (!faces.empty()) {
        const std::uint64_t count = faces.front();
        if (count >= faces.size())
            return false;
        visit(faces.subspan(1, count));
        faces = faces.subspan(count + 1);
    }
    return true;
}

/// Whether a quadrilateral has the diagonal that its smallest node is not on: only that one cuts it into two triangles
/// with areas on the same side.
bool needsOtherDiagonal(std::span<const Eigen::Vector3d> positions, const CellPolygon& quadrilateral);

/// The quadrilaterals among the faces of a polyhedron.
std::vector<CellPolygon> quadrilateralsOf(std::span<const std::uint32_t> faces);

struct PolyhedronSurface {
    enum class Kind : std::uint8_t {
        Closed,
        Open, ///< an edge is not in two faces, a face has a point twice, or the faces are no single surface
        Flat  ///< without volume
    };
    Kind kind = Kind::Closed;
    CellSurface triangles{}; ///< of a closed one, seen from outside counterclockwise
};

/// Of faces in any order and orientation, which have three points at least. `other` says which quadrilaterals have the
/// other diagonal; none if it is empty. O(n log n) of all points of faces, but for faces of which many fans fail.
PolyhedronSurface polyhedronSurface(std::span<const Eigen::Vector3d> positions, std::span<const std::uint32_t> faces,
                                    const OtherDiagonal& other);

/// Positive tetrahedra between the first of `corners` that sees the surface and its other triangles. Nothing if none
/// does.
std::optional<CellPieces> cutFromCorner(std::span<const Eigen::Vector3d> positions,
                                        std::span<const std::uint32_t> corners, const CellSurface& surface);

/// A point that sees all triangles from their inner sides: the mean of the corners, or else one that is far from the
/// planes of all of them. Nothing if none was found.
std::optional<Eigen::Vector3d> pointInside(std::span<const Eigen::Vector3d> positions,
                                           std::span<const std::uint32_t> corners, const CellSurface& surface);

/// Whether a point sees all triangles so. Exact.
bool seesAll(std::span<const Eigen::Vector3d> positions, const CellSurface& surface, const Eigen::Vector3d& point);

/// The tetrahedra between a point of this number and all triangles.
CellPieces cutFromPoint(const CellSurface& surface, std::uint32_t point);

/// The mean of some points.
Eigen::Vector3d meanOf(std::span<const Eigen::Vector3d> positions, std::span<const std::uint32_t> points);

/// The value at a place among points, of the linear function that fits their values best: the mean of these at the mean
/// of the points. Never beyond their range. `values` has one for each position.
double valueAmong(std::span<const Eigen::Vector3d> positions, std::span<const std::uint32_t> points,
                  std::span<const double> values, const Eigen::Vector3d& place);

} // namespace tetra
