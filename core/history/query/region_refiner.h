// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/block_division.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace tetra {

/// The blocks in which a model was built, each a Delaunay mesh of its box: they follow from the initial sites, the
/// corners of all blocks. None if points cannot be inserted into such a model's meshes: it is no regular lattice, not
/// Delaunay, too large for exact arithmetic, weighted, or its initial sites are others.
std::optional<BlockDivision> focusDivision(const Model& model);

/// Meshes with a sharp focus, by insertion: the Delaunay mesh of any subset
/// of the points is well defined, so the sites of the fine mesh that lie in the region are inserted into the coarse
/// mesh, in the history's order, block by block (of a box, those one step outside, too); then in rounds, wherever a
/// sample's error is still larger than the field allows, the worst sample of that tetrahedron, until none is. What is a
/// tetrahedron of the fine mesh is known to be good enough; the others are looked at on all threads that TBB may use.
/// For regular lattices whose file holds all samples. The coarse mesh with its adjacency is kept from query to query
/// and restored by copying; a region that moves a little keeps the sites it leaves, up to a quarter of all. Used from
/// one thread at a time.
class RegionRefiner {
public:
    /// Whether the model allows it: a regular lattice, unweighted, not too large, its file with all samples.
    static bool fits(const Model& model);
    /// `model` fits and outlives it.
    explicit RegionRefiner(const Model& model);
    ~RegionRefiner();
    RegionRefiner(RegionRefiner&&) noexcept;
    RegionRefiner& operator=(RegionRefiner&&) noexcept;

    /// How many sites would be inserted for this ramp (inner < outer); cheap.
    std::uint64_t sitesInside(const SpaceRamp& error);

    /// The mesh for the ramp: every sample's error at most error.at(). Deterministic but for the sites that an earlier,
    /// overlapping region left, which `fresh` rules out. `reuse`: a result whose buffers may be used again.
    Result<ExtractedMesh> extract(const SpaceRamp& error, bool fresh, const Progress& progress = {},
                                  ExtractedMesh reuse = {});

private:
    class Work;
    std::unique_ptr<Work> work_;
};

} // namespace tetra
