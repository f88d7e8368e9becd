// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/collapsible_mesh.h"
#include "core/mesh/decimation/index_pool.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// Which removed points of an irregular mesh are related to which triangle of its boundary: those outside, by their
/// projection (R5), and those of the original boundary, by their distance (R4), whether they lie in- or outside. The
/// distance of points outside counts as warping, too, so that there is always a place within it that bears the error.
class BoundaryPoints {
public:
    struct Relation {
        IndexPool::List outside;
        IndexPool::List ofBoundary;
        float error = 0;   ///< bound on those of the points outside
        float warping = 0; ///< bound on the distances of both
    };

    explicit BoundaryPoints(std::uint32_t triangles) : relations_(triangles) {}

    const Relation& operator[](std::uint32_t triangle) const
    {
        return relations_[triangle - CollapsibleMesh::firstTriangle];
    }
    std::span<const std::uint32_t> outside(std::uint32_t triangle) const { return pool_[(*this)[triangle].outside]; }
    std::span<const std::uint32_t> ofBoundary(std::uint32_t triangle) const
    {
        return pool_[(*this)[triangle].ofBoundary];
    }

    void clear(std::uint32_t triangle);
    void addOutside(std::uint32_t triangle, std::uint32_t point, float error, float warping);
    void addOfBoundary(std::uint32_t triangle, std::uint32_t point, float warping);
    /// Takes a point outside away. The bound stays.
    void takeOutside(std::uint32_t triangle, std::uint32_t point);

private:
    Relation& at(std::uint32_t triangle) { return relations_[triangle - CollapsibleMesh::firstTriangle]; }

    std::vector<Relation> relations_;
    IndexPool pool_;
};

} // namespace tetra
