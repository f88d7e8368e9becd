// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/query.h>

#include <optional>

namespace tetra {

/// Tetrahedra of several meshes at once, each with its life (R14): alive in the mesh of the first N sites if
/// birth <= N < death (S2). The birth is the number of sites with its creator as the last, the death that with its
/// destroyer, or Model::never. Both may lie within a batch, where no query's mesh is; every life holds the end of one.
struct HistoryPart {
    TetrahedralMesh mesh; ///< vertices are the first sites; the tetrahedra overlap: they are no mesh together
    Buffer<std::uint32_t> births;
    Buffer<std::uint32_t> deaths;
    MeshSize coarse; ///< the meshes at the two ends
    MeshSize fine;
};

/// All tetrahedra that are alive at some accuracy between the two, ends included, which may come in any order; of
/// these, only those that can contain a value of `values` (empty: all), and that have a point in common with the window
/// or lie in it (a window that cuts is refused, WrongUsage: what is cut has no life). In the order of the file, so of
/// birth. Other errors as of extractPrefix().
TAN_INTERNAL Result<HistoryPart> extractHistory(const Model& model, const Accuracy& one, const Accuracy& other,
                                                std::span<const ValueRange> values, const std::optional<Window>& window,
                                                const Progress& progress = {});

} // namespace tetra
