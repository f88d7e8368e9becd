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
    /// The mesh of the blocks' corners. Errors: too large a lattice, refused memory, cancelled.
    static Result<std::unique_ptr<ReplayMesh>> make(const Lattice& lattice, SampleType type, std::uint32_t blockCells,
                                                    const Progress& progress);
    ReplayMesh(const ReplayMesh&) = delete;
    ReplayMesh& operator=(const ReplayMesh&) = delete;

    const BlockDivision& division() const noexcept { return division_; }
    const LocalDelaunay& delaunay() const noexcept { return delaunay_; }
    SampleType type() const noexcept { return type_; }
    std::uint64_t pointCount() const noexcept { return pointCount_; }
    /// The corners of the blocks, by rising numbers; the mesh's first vertices have their places here as numbers.
    std::span<const std::uint32_t> corners() const noexcept { return corners_; }
    /// The mesh of these alone, by their places.
    std::span<const std::array<std::uint32_t, 4>> start() const noexcept { return start_; }
    /// Back to that.
    void restart() { delaunay_.restore(); }

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

    /// Adds sites; `slots` are none, or those that expect() told of the mesh before. Errors: the mesh grew beyond what
    /// was reserved, cancelled.
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
        : division_(lattice.size, blockCells), type_(type), pointCount_(lattice.pointCount())
    {
    }
    Status prepare(const Lattice& lattice, const Progress& progress);

    BlockDivision division_;
    SampleType type_;
    std::uint64_t pointCount_;
    LocalDelaunay delaunay_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::array<std::uint32_t, 4>> start_;
    std::shared_ptr<std::byte> samples_;
    std::vector<float> errors_;               ///< of the tetrahedron in each slot ...
    std::vector<PackedPoint> worst_;          ///< ... and the point that has it
    std::vector<std::uint32_t> lastMeasured_; ///< slots
    double largestSample_ = 0;
};

} // namespace tetra
