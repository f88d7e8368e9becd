// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/insertion/local_delaunay.h"
#include "core/refine/insertion/sample_scan.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/lattice_samples.h"
#include "core/refine/lattice/point_location.h"

#include <tan/base.h>
#include <tan/data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetra {

/// The linear interpolation at a point of a tetrahedron, whose weights the point's volumes are. Of integers of up to 16
/// bits it is one division of exact integers; of others the weights are reduced fractions, and only vertices of a
/// weight count, in the lattice's order: so a point on a face gets the same from both sides.
template <class T, class SampleAt> double interpolatedAt(const SampleAt& sampleAt,
                                                         const std::array<PackedPoint, 4>& vertices,
                                                         const std::array<std::int64_t, 4>& volumes)
{
    const std::int64_t whole = volumes[0] + volumes[1] + volumes[2] + volumes[3];
    if (whole == 0) // no mesh has it
        return 0;
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += volumes[i] * static_cast<std::int64_t>(sampleAt(vertices[i]));
        return static_cast<double>(sum) / static_cast<double>(whole);
    } else {
        std::array<std::pair<PackedPoint, std::int64_t>, 4> weights;
        std::int64_t divisor = whole;
        for (std::size_t i = 0; i < 4; ++i) {
            weights[i] = {vertices[i], volumes[i]};
            divisor = std::gcd(divisor, volumes[i]);
        }
        std::ranges::sort(weights);
        double sum = 0, first = 0;
        bool begun = false;
        for (const auto& [vertex, weight] : weights) {
            if (weight == 0)
                continue;
            const auto value = static_cast<double>(sampleAt(vertex));
            if (!begun)
                first = value;
            begun = true;
            const std::int64_t part = weight / divisor;
            sum += static_cast<double>(part) * (value - first);
        }
        const std::int64_t parts = whole / divisor;
        const double result = first + sum / static_cast<double>(parts);
        return std::isfinite(result) ? result : first;
    }
}

/// What tetrahedra of a lattice, of which each has one of the points, say of their samples: ReplayMesh::expect(). On
/// all threads.
void interpolateIn(const PackedLattice& lattice, SampleType type, const std::byte* samples,
                   std::span<const std::array<PackedPoint, 4>> tetrahedra, std::span<const std::uint32_t> points,
                   std::vector<double>& expected);

/// The mesh of the corners of a lattice's blocks.
struct BlockStart {
    std::vector<std::uint32_t> corners; ///< points of the lattice, by rising numbers
    /// By their places in these, LatticeDelaunay::startCount of each block.
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
};
/// `firstIsOdd`: ReplayMesh::Shape's. Errors: too large a lattice, refused memory.
Result<BlockStart> startOfBlocks(const BlockDivision& division, const LatticeMetric& metric, bool firstIsOdd);

/// The mesh of a replayed lattice, or of a box of its blocks, while sites enter it, and the samples as far as they are
/// known. Points are numbered in the box. Allocations throw std::bad_alloc.
class ReplayMesh {
public:
    struct Shape {
        std::array<std::uint32_t, 3> size{2, 2, 2}; ///< points along each axis
        std::uint32_t blockCells = 0;               ///< along an edge of a block; 0: one block
        LatticeMetric metric{1, 1, 1};              ///< latticeMetric() of the lattice's first block
        bool firstIsOdd = false;                    ///< the box's first block (BlockDivision::odd())
        bool shared = false;                        ///< other threads are at work on other boxes
    };
    /// Whether the mesh of a whole lattice can be kept: in address space, and in the numbers of its tetrahedra.
    static bool fits(const Lattice& lattice, std::uint32_t blockCells);
    /// The mesh of the blocks' corners. `samples`: one of `type` a point, which others may use, too; null if nothing is
    /// asked that needs them. Errors: too large a lattice, refused memory, cancelled.
    static Result<std::unique_ptr<ReplayMesh>> make(const Shape& shape, SampleType type,
                                                    std::shared_ptr<std::byte> samples, const Progress& progress);
    ReplayMesh(const ReplayMesh&) = delete;
    ReplayMesh& operator=(const ReplayMesh&) = delete;

    SampleType type() const noexcept { return type_; }
    const PackedLattice& lattice() const noexcept { return delaunay_.lattice(); }
    std::uint64_t pointCount() const noexcept { return pointCount_; }
    /// The corners of the blocks, by rising numbers; the mesh's first vertices have their places here as numbers.
    std::span<const std::uint32_t> corners() const noexcept { return corners_; }

    /// Its tetrahedra, in slots.
    const LatticeDelaunay& delaunay() const noexcept { return delaunay_.mesh(); }

    /// Those of the vertices must be known before expect().
    std::span<std::byte> samples() noexcept { return {samples_.get(), pointCount_ * sampleSize(type_)}; }
    template <class T> std::span<T> samplesAs() noexcept { return {reinterpret_cast<T*>(samples_.get()), pointCount_}; }

    struct Expectations {
        std::vector<double> values;
        std::vector<std::uint32_t> slots; ///< of tetrahedra that have the points
    };
    /// What the mesh says of the samples of points. It depends on the mesh alone, not on which of several tetrahedra
    /// has a point, and is the same bits on every machine. On all threads, unless they are shared.
    Status expect(std::span<const std::uint32_t> points, Expectations& expected, const Progress& progress) const;

    /// Adds sites; `slots` are none, or those that expect() told of the mesh before. Errors: the mesh grew beyond what
    /// was reserved, cancelled.
    Status add(std::span<const std::uint32_t> points, std::span<const std::uint32_t> slots, const Progress& progress);

    // For those who pack: all samples are known.

    /// The largest error of each tetrahedron that changed since it was last measured. On all threads, unless they are
    /// shared. Errors: cancelled.
    Status measure(const Progress& progress);
    /// A bound on the error of the mesh as it was measured, in units of the values.
    float error() const;
    /// The worst point of each tetrahedron of a larger error than `limit`, of those that are `eligible`, as found.
    /// `everywhere`: not only where something changed before it was last measured.
    void findWorst(float limit, bool everywhere, const std::function<bool(std::uint32_t point)>& eligible,
                   std::vector<WorstSample>& found) const;
    /// Whether its tetrahedron is still there, and it is no site.
    bool stands(const WorstSample& sample) const { return tetra::stands(delaunay_, sample); }
    /// What that tetrahedron says of its sample, as expect().
    double expectedAt(const WorstSample& sample) const;
    /// Makes it a site. Errors: the mesh grew beyond what was reserved.
    Status add(const WorstSample& sample);

private:
    ReplayMesh(const Shape& shape, SampleType type, std::shared_ptr<std::byte> samples);
    Status prepare(const Shape& shape, const Progress& progress);

    SampleType type_;
    std::uint64_t pointCount_;
    bool shared_;
    LocalDelaunay delaunay_;
    std::vector<std::uint32_t> corners_;
    std::shared_ptr<std::byte> samples_;
    std::vector<float> errors_;               ///< of the tetrahedron in each slot ...
    std::vector<PackedPoint> worst_;          ///< ... and the point that has it
    std::vector<std::uint32_t> lastMeasured_; ///< slots
    double largestSample_ = 0;
};

} // namespace tetra
