// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/queries/field_judge.h"

#include <cstdint>

namespace tetra {

/// The mesh of a prefix that moves to another prefix by what differs: what died or is not born yet is taken out, what
/// came to life put in its place. The order of the tetrahedra is therefore any. Besides the mesh it keeps birth and
/// death of each of its tetrahedra, 8 bytes. After an error the next mesh is extracted afresh.
class PrefixMesh {
public:
    /// Makes `out` the mesh of the first `sites` sites, which end a group. `out` is what the last call left, unchanged,
    /// or anything if forget() was called. `places` of all these sites.
    Status moveTo(const Model& model, std::uint32_t sites, const SitePlaces& places, const Progress& progress,
                  ExtractedMesh& out);
    void forget() noexcept { sites_ = 0; }

private:
    Status extract(const Model& model, std::uint32_t sites, const Progress& progress, ExtractedMesh& out);
    void noteLives(const Model& model, const ExtractedMesh& out);
    void refine(const Model& model, std::uint32_t sites, ExtractedMesh& out);
    void coarsen(const Model& model, std::uint32_t sites, ExtractedMesh& out);
    bool startReplacing(const Model& model, std::uint32_t sites, ExtractedMesh& out);
    void add(const Model& model, std::uint64_t tetrahedron, std::uint32_t creator, bool alive, ExtractedMesh& out);
    void closeGaps(ExtractedMesh& out);

    std::uint32_t sites_ = 0; ///< of the present mesh; 0: none
    bool livesKnown_ = false;
    bool consistent_ = true;
    Buffer<std::uint32_t> births_;
    Buffer<std::uint32_t> deaths_;
    Buffer<std::uint32_t> going_;   ///< places in the mesh of those that go, ascending
    Buffer<std::uint32_t> places_;  ///< for those that arrive
    Buffer<std::uint32_t> revived_; ///< places in a part of the history
    std::uint64_t arriving_ = 0;
    std::uint64_t filled_ = 0; ///< of the places, those that are taken
};

} // namespace tetra
