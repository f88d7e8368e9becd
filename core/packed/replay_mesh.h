// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/insertion/local_delaunay.h"
#include "core/refine/insertion/sample_scan.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/lattice_samples.h"

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// The mesh of a replayed model while its sites enter it, and the samples as far as they are known. Allocations throw
/// std::bad_alloc.
class ReplayMesh {
public:
    /// How the mesh is kept: as one, or of many blocks a number of these together, so that threads share the work of
    /// add(). Then there is no watch, no restart(), and nothing to pack with.
    enum class Kept : std::uint8_t { AsOne, InParts };
    /// The mesh of the blocks' corners. Errors: too large a lattice, refused memory, cancelled.
    static Result<std::unique_ptr<ReplayMesh>> make(const Lattice& lattice, SampleType type, std::uint32_t blockCells,
                                                    Kept kept, const Progress& progress);
    ReplayMesh(const ReplayMesh&) = delete;
    ReplayMesh& operator=(const ReplayMesh&) = delete;

    const BlockDivision& division() const noexcept { return division_; }
    SampleType type() const noexcept { return type_; }
    std::uint64_t pointCount() const noexcept { return pointCount_; }
    /// The corners of the blocks, by rising numbers; the mesh's first vertices have their places here as numbers.
    std::span<const std::uint32_t> corners() const noexcept { return corners_; }
    /// The mesh of these alone, by their places.
    std::span<const std::array<std::uint32_t, 4>> start() const noexcept { return start_; }
    /// Back to that.
    void restart() { parts_.front()->delaunay.restore(); }

    /// One of `type` a point, all zero at first; those of the vertices must be known before expect().
    std::span<std::byte> samples() noexcept { return {samples_.get(), pointCount_ * sampleSize(type_)}; }
    const std::shared_ptr<std::byte>& sharedSamples() const noexcept { return samples_; }
    template <class T> std::span<T> samplesAs() noexcept { return {reinterpret_cast<T*>(samples_.get()), pointCount_}; }

    struct Expectations {
        std::vector<double> values;
        std::vector<std::uint32_t> slots; ///< of tetrahedra that have the points
    };
    /// What the mesh says of the samples of points. It depends on the mesh alone, not on which of several tetrahedra
    /// has a point, and is the same bits on every machine. On all threads.
    Status expect(std::span<const std::uint32_t> points, Expectations& expected, const Progress& progress) const;

    /// Adds sites; `slots` are none, or those that expect() told of the mesh before. On all threads if it is kept in
    /// parts. Errors: the mesh grew beyond what was reserved, cancelled.
    Status add(std::span<const std::uint32_t> points, std::span<const std::uint32_t> slots, const Progress& progress,
               InsertionWatch* watch = nullptr);

    // For those who pack: all samples are known.

    /// The largest error of each tetrahedron that changed since it was last measured. On all threads. Errors:
    /// cancelled.
    Status measure(const Progress& progress);
    /// A bound on the error of the mesh as it was measured, in units of the values.
    float error() const;
    /// Sites that entered together, by rising numbers, and what the mesh before them said of their samples.
    struct Round {
        std::vector<std::uint32_t> points;
        std::vector<double> expected;
    };
    /// Adds the worst point of each tetrahedron of a larger error than `limit`, in the lattice's order, but for those
    /// whose tetrahedron an earlier one destroyed. `everywhere`: not only where something changed before it was last
    /// measured. Errors: as add().
    Status addWorst(float limit, bool everywhere, Round& round, const Progress& progress);

private:
    ReplayMesh(const Lattice& lattice, SampleType type, std::uint32_t blockCells)
        : division_(lattice.size, blockCells), type_(type), pointCount_(lattice.pointCount()), lattice_(lattice.size)
    {
    }
    Status prepare(const Lattice& lattice, Kept kept, const Progress& progress);
    void divide(Kept kept);
    Status load(const std::vector<std::array<PackedPoint, 4>>& start, const LatticeMetric& metric,
                const Progress& progress);

    /// A box of whole blocks.
    struct Part {
        LatticeBox box;
        std::uint32_t first = 0; ///< the number of the box's first point
        LocalDelaunay delaunay;  ///< of the box's points
    };
    struct PartPoint {
        PackedPoint point = 0; ///< in the part
        std::uint32_t slot = 0;
    };
    std::uint32_t partAlong(std::size_t axis, std::uint32_t coordinate) const
    {
        return std::min(coordinate / partEdges_[axis], partCounts_[axis] - 1);
    }
    Status addToParts(std::span<const std::uint32_t> points, std::span<const std::uint32_t> slots,
                      const Progress& progress);

    BlockDivision division_;
    SampleType type_;
    std::uint64_t pointCount_;
    PackedLattice lattice_;
    std::array<std::uint32_t, 3> partEdges_{}; ///< in cells
    std::array<std::uint32_t, 3> partCounts_{1, 1, 1};
    std::vector<std::unique_ptr<Part>> parts_;
    std::vector<std::vector<PartPoint>> entering_; ///< each part
    std::vector<std::uint32_t> corners_;
    std::vector<std::array<std::uint32_t, 4>> start_;
    std::shared_ptr<std::byte> samples_;
    std::vector<float> errors_;               ///< of the tetrahedron in each slot ...
    std::vector<PackedPoint> worst_;          ///< ... and the point that has it
    std::vector<std::uint32_t> lastMeasured_; ///< slots
    double largestSample_ = 0;
};

} // namespace tetra
