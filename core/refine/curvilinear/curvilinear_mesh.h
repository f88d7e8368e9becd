// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/reserved_array.h"
#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/refine/lattice/error_queue.h"
#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/point_pool.h"
#include "core/refine/lattice/star.h"

#include <tan/base.h>
#include <tan/build.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <vector>

namespace tetra {

/// How much of its circumsphere a tetrahedron fills, from 0 for a sliver; the same for all sizes.
inline float fatness(const DelaunayTetrahedron& tetrahedron)
{
    const auto& sphere = tetrahedron.sphere;
    const double determinant = tetrahedron.determinant();
    const double squaredDiameter =
        (sphere[0] * sphere[0] + sphere[1] * sphere[1] + sphere[2] * sphere[2]) / (determinant * determinant);
    return static_cast<float>(determinant * determinant / (squaredDiameter * squaredDiameter * squaredDiameter));
}

/// The flipped tetrahedra that wait for their cure, the fattest first: a point in the middle of a fat one takes the
/// slivers around it along, which then need none of their own (on an O-grid 10 to 20 % fewer sites than ordered by key,
/// size or age). Ties go by the last vertex. Entries of tetrahedra that have died are dropped when they are met.
class FlipQueue {
public:
    /// `history` is the tetrahedron's number in the history, by which it is known whether it still lives.
    void push(float fatness, PackedPoint vertex, std::uint32_t slot, std::uint32_t history)
    {
        entries_.push({std::uint64_t(std::bit_cast<std::uint32_t>(fatness)) << 32 | ~vertex, slot, history});
    }

    static constexpr std::uint32_t none = 0xffffffff;
    /// The slot of the foremost tetrahedron that `alive(slot, history)` says lives, or none. It stays in the queue.
    void clear() { entries_ = Entries(); }
    template <class Alive> std::uint32_t top(const Alive& alive)
    {
        while (!entries_.empty() && !alive(entries_.top().slot, entries_.top().history))
            entries_.pop();
        return entries_.empty() ? none : entries_.top().slot;
    }

    void archive(StateArchive& archive) { archive(entries_); }

private:
    struct Entry {
        std::uint64_t order;
        std::uint32_t slot;
        std::uint32_t history;
        bool operator<(const Entry& other) const
        {
            return order != other.order ? order < other.order : history > other.history;
        }
    };
    struct Entries : std::priority_queue<Entry> {
        void archive(StateArchive& archive) { archive(c); }
    };
    Entries entries_;
};

/// Which of a star's tetrahedra each point of its cavity lies in. Exact (S8); a point on a shared face goes to one of
/// them by a fixed rule (S9), that of locateInStar().
class StarPlacement {
public:
    /// The points must lie in the star. They may be in any order; the apex is passed over.
    void run(const PackedLattice& lattice, const Star& star, std::span<const PackedPoint> points);

    /// Face f of the star contains the points placed()[offsets()[f]] up to offsets()[f + 1].
    std::span<const PackedPoint> placed() const noexcept { return placed_; }
    std::span<const std::uint32_t> offsets() const noexcept { return offsets_; }
    /// The coordinates of each placed point relative to the apex, the fourth 0.
    std::span<const std::array<float, 4>> coordinates() const noexcept { return placedCoordinates_; }

private:
    void gatherCoordinates(const PackedLattice& lattice, PackedPoint apex, std::span<const PackedPoint> points);
    void sortByOwner(std::size_t faceCount);

    Buffer<PackedPoint> points_;
    Buffer<float> x_, y_, z_;
    Buffer<std::int32_t> owners_;
    Buffer<PackedPoint> placed_;
    Buffer<std::array<float, 4>> placedCoordinates_;
    std::vector<std::uint32_t> offsets_;
    Buffer<std::array<float, 12>> planes_;
};

/// Distributes the points of a cavity over the tetrahedra of its star and finds their warpings and errors (R4, R5), the
/// inner loop of curvilinear refinement: the position and the value of a point less what the barycentric weights of
/// computational space make of its tetrahedron's vertices, all four components in one vector.
class CurvilinearRedistribution {
public:
    /// The points must lie in the star. They may be in any order; the apex is passed over.
    void run(const CurvilinearGrid& grid, const Star& star, std::span<const PackedPoint> points);

    /// Face f of the star contains the points placed()[offsets()[f]] up to offsets()[f + 1].
    std::span<const PackedPoint> placed() const noexcept { return placement_.placed(); }
    std::span<const std::uint32_t> offsets() const noexcept { return placement_.offsets(); }
    /// The squares of (error * determinant) and of (warping * determinant) of each placed point, weighted
    /// (R6).
    std::span<const double> scaledSquaredErrors() const noexcept { return squaredErrors_; }
    std::span<const double> scaledSquaredWarpings() const noexcept { return squaredWarpings_; }

private:
    void weigh(const CurvilinearGrid& grid);

    StarPlacement placement_;
    Buffer<PhysicalPoint> link_;
    Buffer<double> squaredErrors_;
    Buffer<double> squaredWarpings_;
};

/// By which the points of a tetrahedron are compared.
enum class CurvilinearSelection {
    Normalised, ///< one key, the larger of the error and the warping weight times the warping (S4)
    Paper       ///< errors and warpings apart, each in its own units (3.1)
};

/// A refinable mesh of a curvilinear grid or of a block of one: Delaunay in computational space, each tetrahedron with
/// the points inside it, their accuracies, and whether lifting flips it. Keeps what is worst; what to insert is the
/// caller's choice. One thread; some 600 bytes a site. Allocations throw std::bad_alloc.
///
/// Blocks that share a face agree about it (S4) if they insert a point of it only as the worst() one or at a place in
/// the order that the caller fixes for all of them: the triangles on a face depend on nothing but the points on it and
/// their order, the accuracy of a point on it on nothing but the vertices of the triangle, edge or vertex that it lies
/// in, of which it is the same float in every block; and of points of equal keys the first comes first.
class CurvilinearMesh {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    struct Options {
        double warpingWeight = 1;  ///< units of the values for a unit of length
        double largestError = 1;   ///< the extent of the values; only the speed depends on it
        double largestWarping = 1; ///< the extent of the positions; likewise
        double stopKey = 0;        ///< points of larger keys are what is left to do
        CurvilinearSelection selection = CurvilinearSelection::Normalised;
        std::array<std::uint32_t, 3> size{2, 2, 2}; ///< of the whole grid, in whose order the history names points
        LatticeBox box;                             ///< of it the part that the grid given to start() has
        bool centreAtOrigin = true;                 ///< LatticeBoxOptions
    };

    /// Makes the corners of the grid the first sites and hands them to `sink`. May be called again with another grid,
    /// in the same memory; `grid` must outlive what is done with it. Errors: too large a grid, refused memory, the
    /// sink's.
    Status start(const CurvilinearGrid& grid, const Options& options, HistorySink& sink);

    /// A point and a tetrahedron whose circumsphere has it strictly inside.
    struct Candidate {
        PackedPoint point = 0;
        std::uint32_t slot = none;
        float measure = 0; ///< its key, error or warping
        bool exists() const noexcept { return slot != none; }
    };
    /// The point of the largest key, or with the paper's selection of the largest error. Measures of 0 do not count.
    Candidate worst();
    /// With the paper's selection: the point of the largest warping.
    Candidate worstWarping();
    /// The cure of the foremost flipped tetrahedron that may not stay so, the deepest point in its circumsphere (S5);
    /// of a block the deepest that no other block has, if there is one. None if there is no such tetrahedron: then all
    /// of inverted() are those that the grid itself makes (CurvilinearGrid::allowsInverted()).
    Candidate flipped();
    /// The point of the whole grid, which is one of the block. Does not exist if it is a site already.
    Candidate at(std::uint64_t wholePoint);

    /// Whether another block has the point too.
    bool isShared(PackedPoint point) const noexcept;
    /// The point's number in the whole grid.
    std::uint64_t wholeIndex(PackedPoint point) const noexcept;

    /// Inserts the candidate's point and hands the step to `sink`.
    Status insert(const Candidate& candidate, float keyBefore, HistorySink& sink);

    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::uint64_t tetrahedronCount() const noexcept { return tetrahedronCount_; } ///< all that ever lived
    /// By slots; dead ones have the determinant 0.
    std::span<const DelaunayTetrahedron> tetrahedra() const noexcept { return delaunay_.tetrahedra(); }
    std::uint64_t inverted() const noexcept { return inverted_; }     ///< flipped ones alive
    std::uint64_t degenerate() const noexcept { return degenerate_; } ///< alive and without volume (S6)
    /// Points in tetrahedra of keys above the stop.
    std::uint64_t pointsAboveStop() const noexcept { return pointsAboveStop_; }
    /// How many points the last insertion moved.
    std::uint64_t pointsMoved() const noexcept { return points_.size(); }
    /// Drops what is stale from the queues; worth calling now and then.
    void sweep();
    /// The key of a mesh or tetrahedron of that error and warping: a bound, as they are.
    float keyOf(float error, float warping) const;

    /// What changes after start().
    void archive(StateArchive& archive);

private:
    /// What is kept for each slot besides its geometry.
    struct SlotState {
        std::uint32_t history = none; ///< its tetrahedron's number in the history; none while it has none
        std::uint32_t bucket = none;  ///< none if no point is inside
        std::int32_t orientation = 1; ///< of the tetrahedron in physical space, relative to the grid's
    };
    /// Bounds on a tetrahedron's own error, warping and key.
    struct Accuracy {
        float error = 0;
        float warping = 0;
        float key = 0;
    };
    /// Of the points in a tetrahedron.
    struct WorstPoints {
        Accuracy accuracy;
        PackedPoint byKey = 0;
        PackedPoint byError = 0;   ///< of no meaning but with the paper's selection
        PackedPoint byWarping = 0; ///< likewise
    };

    Status reserve();
    void distribute(std::uint32_t slot, std::span<const PackedPoint> points);
    Status addCorners(HistorySink& sink);
    void collectDestroyed();
    Accuracy fillBucket(std::uint32_t slot, std::size_t face, double determinant);
    WorstPoints worstOf(std::uint32_t slot, std::size_t face, double determinant) const;
    Accuracy accuracyOnFace(std::uint32_t slot, PackedPoint point) const;
    void prefetchNext();
    void noteOrientation(std::uint32_t slot);
    std::uint32_t takeBucketNumber();

    const CurvilinearGrid* grid_ = nullptr;
    Options options_;
    std::array<std::array<bool, 2>, 3> shared_{}; ///< whether other blocks lie before and behind along each axis
    bool anyShared_ = false;
    LatticeDelaunay delaunay_;
    PointPool pool_;
    std::vector<PointBucket> buckets_;        ///< with the worst point by key or error
    std::vector<PointBucket> warpingBuckets_; ///< with the paper's selection the same with the worst by warping
    std::vector<std::uint32_t> freeBuckets_;
    ErrorQueue queue_;
    ErrorQueue warpingQueue_;
    FlipQueue flips_;
    ReservedArray<SlotState> slots_;
    CurvilinearRedistribution redistribution_;
    Star startStar_;

    std::uint32_t siteCount_ = 0;
    std::uint64_t tetrahedronCount_ = 0;
    std::uint64_t inverted_ = 0;
    std::uint64_t degenerate_ = 0;
    std::uint64_t pointsAboveStop_ = 0;

    std::uint32_t hint_ = 0; ///< a live slot
    std::uint32_t nextSlot_ = 0;
    std::vector<PackedPoint> points_; ///< of the last insertion's cavity
    std::vector<std::uint32_t> destroyedHistory_;
    std::vector<HistoryTetrahedron> starHistory_;
    std::array<Accuracy, LatticeDelaunay::startCount> startAccuracies_{};
};

} // namespace tetra
