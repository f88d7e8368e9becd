// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/sample_scan.h"
#include "core/mesh/tetrahedron_boxes.h"
#include "core/model/queries/coarse_mesh.h"
#include "core/model/queries/fine_stars.h"
#include "core/model/queries/focus_limits.h"
#include "core/model/queries/sharp_focus.h"
#include "core/model/queries/site_grid.h"

#include <limits>
#include <optional>
#include <vector>

namespace tetra {

/// What is kept from query to query: the coarse mesh, refined for the last of them, and what is known of its errors.
class SharpFocus::Work {
public:
    explicit Work(const Model& model);

    std::uint64_t sitesInside(const SpaceRamp& error);
    Result<ExtractedMesh> extract(const SpaceRamp& error, bool fresh, const Progress& progress, ExtractedMesh reuse);
    /// An insertion may have been broken off: the mesh must be loaded again.
    void forget() noexcept
    {
        coarseSites_ = 0;
        present_.reset();
    }

private:
    struct Range {
        std::uint32_t coarse = 0; ///< sites of the mesh outside
        std::uint32_t fine = 0;   ///< and of the mesh within
        bool known = true;        ///< whether the mesh outside keeps its bound without looking
        bool fineKnown = true;    ///< likewise that within
    };

    Range rangeOf(const FocusLimits& limits) const;
    Status makeIndex();
    Status prepare();
    Status load(std::uint32_t sites, const Progress& progress);
    template <class Visit> void forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const;
    void findMissing(const FocusLimits& limits, const Range& range);
    bool canGoOn(const SpaceRamp& error, const FocusLimits& limits, const Range& range);
    Status insertMissing(const Progress& progress);
    Status repair(const FocusLimits& limits, const Progress& progress);
    void scan(const FocusLimits& limits, ScannedPart part, const Progress& progress, std::vector<WorstSample>& worst);
    void lookAtChanges(const FocusLimits& limits, bool mayBeKnown, const Progress& progress);
    void lookAtOthers(const FocusLimits& limits, bool outsideIsKnown, const Progress& progress);
    Status knowStars(const Range& range, const Progress& progress);
    void readBounds(std::uint32_t sites);
    std::array<std::uint32_t, 4> sitesOf(std::uint32_t slot) const;
    void write(ExtractedMesh& mesh) const;

    const Model& model_;
    LatticeSamples samples_;
    PackedLattice lattice_;
    bool prepared_ = false;
    std::optional<SiteGrid> sites_;
    LocalDelaunay mesh_;
    std::uint32_t coarseSites_ = 0; ///< of the mesh that is loaded
    CoarseMesh coarse_;             ///< without its tetrahedra
    TetrahedronBoxes coarseBoxes_;
    Buffer<float> coarseBounds_;    ///< on the errors of its tetrahedra
    std::optional<FineStars> fine_; ///< of the mesh within
    Buffer<float> bounds_;          ///< on the error in each slot, infinite if not known
    std::vector<std::uint32_t> slots_;

    std::optional<SpaceRamp> present_; ///< what the mesh keeps now
    std::optional<FocusLimits> presentLimits_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()
    std::vector<SiteGrid::Site> missing_;
    std::vector<SiteGrid::Site> sortRoom_;
    std::vector<PackedPoint> points_;
    std::vector<WorstSample> worst_;
    std::vector<WorstSample> others_;
};

} // namespace tetra
