// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/query/error_field.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/mesh.h>
#include <tan/query.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Whether a tetrahedron can contain a value of one of the ranges, ends included. Without ranges it can.
bool canContain(const std::array<float, 4>& values, std::span<const ValueRange> ranges);

/// On which sides of a box many places lie, for tests of the tetrahedra between them that look at few coordinates.
class BoxSides {
public:
    BoxSides() = default;
    /// `positions` live as long as this. All lie outside of a box whose least corner is not the least.
    BoxSides(const Box& box, std::span<const Eigen::Vector3d> positions);

    enum class Place { Inside, Outside, Across }; ///< wholly within; wholly beyond a face of the box; anything else
    Place placeOf(const std::array<std::uint32_t, 4>& tetrahedron) const
    {
        const auto [a, b, c, d] = tetrahedron;
        if ((sides_[a] | sides_[b] | sides_[c] | sides_[d]) == 0)
            return Place::Inside;
        return (sides_[a] & sides_[b] & sides_[c] & sides_[d]) != 0 ? Place::Outside : Place::Across;
    }
    /// Whether they have a common point.
    bool meets(const std::array<std::uint32_t, 4>& tetrahedron) const;

private:
    Box box_;
    std::span<const Eigen::Vector3d> positions_;
    std::vector<std::uint8_t> sides_; ///< a bit for each face of the box that the place lies beyond
};

/// Keeps the tetrahedra that can contain a value of one of the ranges, ends included, or all if there are no ranges;
/// vertices stay as they are. Error: cancelled; what is left of the mesh is then good for nothing.
Status keepValues(TetrahedralMesh& mesh, std::span<const ValueRange> ranges, const Progress& progress = {});

/// Keeps what the window asks for. Cutting is exact in its combinatorics: a vertex on the border is within, equal edges
/// are cut at the same place, and the quadrilaterals of neighbours get the same diagonal, so the result conforms. It
/// adds vertices behind the others, with values interpolated along their edges, and never makes a tetrahedron without
/// volume from one with volume, but for rounding. A window whose least corner is not the least is empty. Gives how many
/// of the mesh's tetrahedra are kept, whole or in part. Errors: cancelled, out of memory; what is left of the mesh is
/// then good for nothing.
Result<std::uint64_t> keepWindow(TetrahedralMesh& mesh, const Window& window, const Progress& progress = {});

/// Removes vertices that no tetrahedron uses, keeping the order of the others, and renumbers. Vertices behind the last
/// one of `sites`, which cutting made, get ExtractedMesh::noSite; the others are counted as `keptSites`.
void dropUnusedVertices(ExtractedMesh& mesh);

} // namespace tetra
