// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/query.h>

#include <cstdint>

namespace tetra {

/// Tetrahedra of several meshes at once, each with its life (R14): alive in the mesh of the first N sites if
/// birth <= N < death (S2). The birth is the number of sites with its creator as the last, the death that with its
/// destroyer, or Model::never. Both may lie within a batch, where no query's mesh is; every life holds the end of one.
struct HistoryPart {
    TetrahedralMesh mesh; ///< vertices are the first sites; the tetrahedra overlap: they are no mesh together
    Buffer<std::uint32_t> births;
    Buffer<std::uint32_t> deaths;
    Buffer<float> birthErrors; ///< the same as ExtractedMesh has them
    Buffer<float> deathErrors;
    MeshSize coarse; ///< the meshes at the two ends
    MeshSize fine;
};

/// All tetrahedra that are alive at some accuracy between the two, ends included, which may come in any order. In the
/// order of the file, so of birth. Errors as of extractPrefix().
Result<HistoryPart> extractHistory(const Model& model, const Accuracy& one, const Accuracy& other,
                                   const Progress& progress = {});

/// What of a part the lives, values and window of a query with a range choose (R17), without the vertices that none of
/// it uses; nothing is read of the model. O(vertices + tetrahedra). May throw std::bad_alloc. Error: cancelled.
Result<ExtractedMesh> chooseLives(const HistoryPart& part, const MeshQuery& query, const Progress& progress = {});

} // namespace tetra
