// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/scalar_field.h"
#include "core/history/query/error_field.h"
#include "core/history/query/mesh_query.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// Whether a tetrahedron can contain a value of one of the ranges, ends included. Without ranges it can.
bool canContain(const std::array<float, 4>& values, std::span<const ValueRange> ranges);

/// On which sides of a box many places lie, for tests of the tetrahedra between them that look at few coordinates.
class BoxSides {
public:
    BoxSides() = default;
    /// `positions` live as long as this. All lie outside of a box whose least corner is not the least.
    BoxSides(const Box& box, std::span<const Eigen::Vector3f> positions);

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
    std::span<const Eigen::Vector3f> positions_;
    std::vector<std::uint8_t> sides_; ///< a bit for each face of the box that the place lies beyond
};

/// The vertex on each of many edges: a table with open addressing, 12 to 48 bytes an edge.
class EdgeVertices {
public:
    /// The vertex on the edge from `smaller` to `larger`, which is set to `otherwise` if there is none yet.
    std::uint32_t on(std::uint32_t smaller, std::uint32_t larger, std::uint32_t otherwise)
    {
        if (2 * (count_ + 1) > entries_.size())
            grow();
        Entry& entry = entryOf(std::uint64_t(smaller) << 32 | larger);
        if (entry.edge == none) {
            entry = {std::uint64_t(smaller) << 32 | larger, otherwise};
            ++count_;
        }
        return entry.vertex;
    }

private:
    static constexpr std::uint64_t none = 0; ///< no edge goes from vertex 0 to itself
    struct Entry {
        std::uint64_t edge = none;
        std::uint32_t vertex = 0;
    };

    /// That of the edge, or the empty one where it belongs.
    Entry& entryOf(std::uint64_t edge)
    {
        const std::uint64_t mask = entries_.size() - 1;
        std::uint64_t place = (edge * 0x9e3779b97f4a7c15) >> 32;
        while (entries_[place & mask].edge != none && entries_[place & mask].edge != edge)
            ++place;
        return entries_[place & mask];
    }

    void grow()
    {
        std::vector<Entry> before(entries_.empty() ? 1024 : 2 * entries_.size());
        std::swap(before, entries_);
        for (const Entry& entry : before)
            if (entry.edge != none)
                entryOf(entry.edge) = entry;
    }

    std::vector<Entry> entries_;
    std::uint64_t count_ = 0;
};

/// Up to three tetrahedra that part of another one is made of.
struct TetrahedronPieces {
    int count = 0;
    std::array<std::array<std::uint32_t, 4>, 3> tetrahedra;

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) { tetrahedra[count++] = {a, b, c, d}; }
};

// Quadrilaterals are split by the diagonal from their vertex of least number: so neighbours do the same.

/// A prism with the bottom a, b, c and the top d, e, f, where (a, b, c, d) is positive, as positive tetrahedra.
TetrahedronPieces splitPrism(const std::array<std::uint32_t, 6>& prism);

/// A pyramid with the base a, b, c, d, in this order around it, where (a, b, top, c) is positive, likewise.
TetrahedronPieces splitPyramid(const std::array<std::uint32_t, 4>& base, std::uint32_t top);

/// Sorts the vertices so that their sides fall, but for those that are not positive if there is only one that is, which
/// come in any order. Orientation is kept.
void orderBySigns(std::array<std::uint32_t, 4>& tetrahedron, std::array<int, 4>& sides);

/// Cuts a mesh off at a box, whose faces are rounded to floats as vertices are: so the new vertices lie in them
/// exactly. One plane after the other; what is cut are the edges from one side of a plane to the other. Tetrahedra that
/// lie in the box stay first and in order; those that are cut follow. Gives how many of the mesh's tetrahedra there is
/// something left of. Errors: cancelled, out of resource. May throw std::bad_alloc.
Result<std::uint64_t> cutAtWindow(TetrahedralMesh& mesh, const Box& box, const Progress& progress);

/// Keeps the tetrahedra that can contain a value of one of the ranges, ends included, or all if there are no ranges;
/// vertices stay as they are. Error: cancelled; what is left of the mesh is then good for nothing.
Status keepValues(TetrahedralMesh& mesh, std::span<const ValueRange> ranges, const Progress& progress = {});

/// Keeps what the window asks for. Cutting is exact in its combinatorics: a vertex on the border is within, equal edges
/// are cut at the same place, and the quadrilaterals of neighbours get the same diagonal, so the result conforms. It
/// adds vertices behind the others, with values interpolated along their edges, and never makes a tetrahedron without
/// volume from one with volume, but for rounding: a window that cuts is rounded to floats. A window whose least corner
/// is not the least is empty. Gives how many of the mesh's tetrahedra are kept, whole or in part. Errors: cancelled,
/// out of memory; what is left of the mesh is then good for nothing.
Result<std::uint64_t> keepWindow(TetrahedralMesh& mesh, const Window& window, const Progress& progress = {});

/// Removes vertices that no tetrahedron uses, keeping the order of the others, and renumbers. Vertices behind the last
/// one of `sites`, which cutting made, get ExtractedMesh::noSite; the others are counted as `keptSites`.
void dropUnusedVertices(ExtractedMesh& mesh);

} // namespace tetra
