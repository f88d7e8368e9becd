// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/error_queue.h"
#include "core/mesh/lattice_delaunay.h"
#include "core/mesh/lattice_refinement.h"
#include "core/mesh/point_pool.h"
#include "core/mesh/relocation.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The work behind LatticeRefiner, box after box in the same memory: the mesh, the buckets of points inside its
/// tetrahedra, and the queue of their errors. One thread. Allocations throw std::bad_alloc.
class BoxRefinement {
public:
    /// `samples` are those of the box alone. After an error the next run starts afresh.
    Result<LatticeRefinementResult> run(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                        HistorySink& sink, const Progress& progress);

private:
    static constexpr std::uint32_t none = 0xffffffff;
    /// What is kept for each slot besides its geometry.
    struct SlotState {
        std::uint32_t history; ///< its tetrahedron's number in the history
        std::uint32_t bucket;  ///< none if no point is inside
    };

    Status start();
    Status distributeStart();
    Status addCorners();
    Result<LatticeRefinementResult> refine(const Progress& progress);
    Status insertWorst(PointBucket worst);
    void fetchAhead() const;
    void collectDestroyed(PackedPoint apex);
    void fillBuckets(std::span<const std::uint32_t> slots);
    std::uint32_t takeBucketNumber();
    std::span<const PointBucket> buckets() const { return {buckets_.data(), bucketCount_}; }
    bool counts(float error) const { return error > options_.stopError; }
    std::uint64_t wholeIndex(PackedPoint point) const;

    LatticeBoxOptions options_;
    const LatticeSamples* samples_ = nullptr;
    HistorySink* sink_ = nullptr;
    PackedLattice lattice_{{2, 2, 2}};
    LatticeDelaunay delaunay_;
    PointPool pool_;
    ReservedArray<PointBucket> buckets_;
    std::uint32_t bucketCount_ = 0; ///< in use or once used
    std::vector<std::uint32_t> freeBuckets_;
    ErrorQueue queue_;
    ReservedArray<SlotState> slots_;
    Star startStar_;
    Relocation relocation_;
    std::uint64_t pointsAboveStop_ = 0; ///< points in tetrahedra that must still be refined: what is left to do
    std::uint32_t siteCount_ = 0;
    std::uint64_t tetrahedronCount_ = 0;

    Buffer<PackedPoint> points_;
    Buffer<std::uint32_t> filledFaces_;
    Buffer<std::uint32_t> places_;
    std::vector<std::uint32_t> destroyedHistory_;
    std::vector<std::uint32_t> destroyedBuckets_;
    std::vector<HistoryTetrahedron> starHistory_;
    std::array<float, LatticeDelaunay::startCount> startErrors_{};
};

} // namespace tetra
