// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/lattice.h"
#include "core/history/model.h"
#include "core/history/query/coarse_mesh.h"
#include "core/history/query/error_field.h"
#include "core/history/query/mesh_query.h"
#include "core/refine/insertion/sample_scan.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/packed_lattice.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// The bounding boxes of many tetrahedra, side by side so that all are compared with a box at a glance: 12 bytes each.
class TetrahedronBoxes {
public:
    /// May throw std::bad_alloc, as the others.
    void assign(const PackedLattice& lattice, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                std::span<const PackedPoint> vertices);

    /// Appends the numbers of those that may have a point in common with the box; never too few. O(tetrahedra), some
    /// thousand million a second.
    void findMeeting(const std::array<std::int32_t, 3>& first, const std::array<std::int32_t, 3>& last,
                     std::vector<std::uint32_t>& found) const;

private:
    std::array<Buffer<std::uint16_t>, 3> first_;
    std::array<Buffer<std::uint16_t>, 3> last_;
};

/// A ramp in space at the points of a lattice, in units of the values: exactly what ErrorField::at() says there.
class FocusLimits final : public ErrorLimits {
public:
    FocusLimits(const SpaceRamp& ramp, const Lattice& lattice, double valueExtent);

    double at(const std::array<std::uint32_t, 3>& point) const override
    {
        if (!quick_)
            return fieldAt(point);
        return inside_[0][point[0]] && inside_[1][point[1]] && inside_[2][point[2]] ? least : most;
    }
    /// Whether a site should be a vertex before anything is looked at: the mesh before it was not good enough here or,
    /// of a box, one step away. Without what lies next to a border more would have to be repaired, which takes longer.
    bool askFor(const std::array<std::uint32_t, 3>& point, double runningError) const
    {
        if (!quick_) {
            const double limit = fieldAt(point);
            return limit < most && runningError > limit;
        }
        bool near = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            near &= static_cast<std::int32_t>(point[axis]) >= firstAsked[axis] &&
                    static_cast<std::int32_t>(point[axis]) <= lastAsked[axis];
        return near && runningError > least;
    }
    /// All such sites lie between these two.
    std::array<std::int32_t, 3> firstAsked{0, 0, 0};
    std::array<std::int32_t, 3> lastAsked{-1, -1, -1};
    /// Whether a limit below the largest can hold in a cube of points: false only if not.
    bool mayHoldIn(const std::array<std::uint32_t, 3>& first, std::uint32_t edge) const;
    /// Whether the limits are the least in a box of points and the largest in all others.
    bool isBox() const noexcept { return quick_; }

private:
    double fieldAt(const std::array<std::uint32_t, 3>& point) const;
    void findRange();

    ErrorField field_;
    Lattice lattice_;
    double extent_ = 0;
    bool quick_ = false;
    std::array<std::vector<char>, 3> inside_; ///< along each axis, if quick
};

/// The blocks in which a model was built, each a Delaunay mesh of its box: they follow from the initial sites, the
/// corners of all blocks. None if points cannot be inserted into such a model's meshes: it is no regular lattice, not
/// Delaunay, too large for exact arithmetic, weighted, or its initial sites are others.
std::optional<BlockDivision> focusDivision(const Model& model);

/// The sites of a lattice model by where they lie: cells of 8^3 points, each with its sites in rising order. 8 bytes a
/// site. Making it takes two passes over the sites.
class SiteGrid {
public:
    static constexpr std::uint32_t edge = 8;
    struct Site {
        std::uint32_t number;
        PackedPoint point;
    };

    SiteGrid() = default;
    /// Of points given by their indices in the lattice. None if an index is too large.
    static std::optional<SiteGrid> make(const PackedLattice& lattice, std::span<const std::uint32_t> points);

    /// Calls visit(first point, sites) for each cell that has points between the two, ends included.
    template <class Visit> void forEachCell(const std::array<std::int32_t, 3>& first,
                                            const std::array<std::int32_t, 3>& last, Visit&& visit) const
    {
        for (std::int32_t z = first[2] / step; z <= floorOf(last[2]); ++z)
            for (std::int32_t y = first[1] / step; y <= floorOf(last[1]); ++y)
                for (std::int32_t x = first[0] / step; x <= floorOf(last[0]); ++x)
                    visit(std::array<std::uint32_t, 3>{std::uint32_t(x) * edge, std::uint32_t(y) * edge,
                                                       std::uint32_t(z) * edge},
                          cell((std::uint64_t(z) * counts_[1] + std::uint64_t(y)) * counts_[0] + std::uint64_t(x)));
    }
    /// The site at a point, or none.
    std::optional<std::uint32_t> siteAt(const PackedLattice& lattice, PackedPoint point) const;

private:
    static constexpr std::int32_t step = edge;
    static std::int32_t floorOf(std::int32_t coordinate) { return coordinate < 0 ? -1 : coordinate / step; }
    std::span<const Site> cell(std::uint64_t number) const
    {
        return std::span(sites_).subspan(starts_[number], starts_[number + 1] - starts_[number]);
    }

    std::array<std::uint32_t, 3> counts_{};
    std::vector<std::uint32_t> starts_{0};
    Buffer<Site> sites_;
};

/// The tetrahedra of a prefix of the history, to ask for one by its sites: what a mesh has in common with the prefix's
/// keeps the prefix's error. 8 bytes for each tetrahedron that is alive, made in one pass.
class TetrahedronSet {
public:
    TetrahedronSet() = default;
    /// Of the first `sites` sites, but only what those from `firstCreator` on created. Errors: a damaged file,
    /// cancelled.
    static Result<TetrahedronSet> make(const Model& model, std::uint32_t firstCreator, std::uint32_t sites,
                                       const Progress& progress);

    std::uint32_t firstCreator() const noexcept { return firstCreator_; }
    std::uint32_t siteCount() const noexcept { return siteCount_; }

    /// Whether the tetrahedron is in the prefix's mesh; any order of sites, some of which may be no sites. Tetrahedra
    /// that are not are taken for others with a probability of 2^-60.
    bool holds(const std::array<std::uint32_t, 4>& sites) const;

    /// Fetches what holds() will look at.
    void prefetch(const std::array<std::uint32_t, 4>& sites) const
    {
        if (const std::uint32_t creator = std::ranges::max(sites); creator >= firstCreator_ && creator < siteCount_)
            __builtin_prefetch(keys_.data() + starts_[creator - firstCreator_]);
    }

private:
    static std::uint64_t keyOf(std::uint64_t a, std::uint64_t b, std::uint64_t c)
    {
        // Symmetric, and what is equal in all three is the same set.
        return (a + b + c) * 0x9e3779b97f4a7c15 + (a * b + b * c + c * a) * 0xbf58476d1ce4e5b9 +
               a * b * c * 0x94d049bb133111eb;
    }

    std::uint32_t firstCreator_ = 0;
    std::uint32_t siteCount_ = 0;
    std::vector<std::uint32_t> starts_; ///< of each creator's keys
    std::vector<std::uint64_t> keys_;
};

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

/// What is kept from query to query: the coarse mesh, refined for the last of them, and what is known of its errors.
class RegionRefiner::Work {
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
    Status readBounds(std::uint32_t sites);
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
    Buffer<float> coarseBounds_;         ///< on the errors of its tetrahedra
    std::optional<TetrahedronSet> fine_; ///< of the mesh within
    Buffer<float> bounds_;               ///< on the error in each slot, infinite if not known
    std::vector<std::uint32_t> slots_;

    std::optional<SpaceRamp> present_; ///< what the mesh keeps now
    std::optional<FocusLimits> presentLimits_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()
    std::vector<SiteGrid::Site> missing_;
    std::vector<SiteGrid::Site> sortScratch_;
    std::vector<PackedPoint> points_;
    std::vector<WorstSample> worst_;
    std::vector<WorstSample> others_;
};

} // namespace tetra
