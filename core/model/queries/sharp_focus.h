// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/queries/mesh_query.h"

#include <memory>

namespace tetra {

/// Meshes with a sharp focus, by insertion: the Delaunay mesh of any subset
/// of the points is well defined, so the sites of the fine mesh that lie in the region are inserted into the coarse
/// mesh, in the history's order, block by block (of a box, those one step outside, too); then in rounds, wherever a
/// sample's error is still larger than the field allows, the worst sample of that tetrahedron, until none is. What is a
/// tetrahedron of the fine mesh is known to be good enough; the others are looked at on all threads that TBB may use.
/// For regular lattices whose file holds all samples. The coarse mesh with its adjacency is kept from query to query
/// and restored by copying; a region that moves a little keeps the sites it leaves, up to a quarter of all. Used from
/// one thread at a time.
class SharpFocus {
public:
    /// Whether the model allows it: a regular lattice, unweighted, not too large, its file with all samples.
    static bool fits(const Model& model);
    /// `model` fits and outlives it.
    explicit SharpFocus(const Model& model);
    ~SharpFocus();
    SharpFocus(SharpFocus&&) noexcept;
    SharpFocus& operator=(SharpFocus&&) noexcept;

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
