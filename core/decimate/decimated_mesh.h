// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/boundary_cost.h"
#include "core/decimate/boundary_surface.h"
#include "core/decimate/collapse_log.h"
#include "core/decimate/collapse_star.h"
#include "core/decimate/collapsible_mesh.h"
#include "core/decimate/decimation.h"
#include "core/decimate/vertex_star.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// The largest of many numbers, none below 0, that change one at a time: a tree of maxima of sixteen, which share a
/// line of the cache.
class KeyTournament {
public:
    /// All are 0. May throw std::bad_alloc.
    explicit KeyTournament(std::size_t count)
    {
        do {
            count = (count + width - 1) / width;
            levels_.emplace_back(width * std::max<std::size_t>(count, 1));
        } while (count > 1);
    }

    /// O(log count) at worst, a step or two where the number is far from the largest.
    void set(std::size_t index, float key)
    {
        for (std::vector<float>& level : levels_) {
            const float before = level[index];
            level[index] = key;
            if (before == key)
                return;
            const float* const group = level.data() + index / width * width;
            float others = 0;
            for (std::size_t i = 0; i < width; ++i)
                others = std::max(others, i == index % width ? 0 : group[i]);
            if (others >= std::max(before, key))
                return;
            key = std::max(key, others);
            index /= width;
        }
        largest_ = key;
    }
    void prefetch(std::size_t index) const { __builtin_prefetch(&levels_.front()[index]); }
    float largest() const noexcept { return largest_; }

    void archive(StateArchive& archive) { archive(levels_, largest_); }

private:
    static constexpr std::size_t width = 16;

    std::vector<std::vector<float>> levels_; ///< the numbers first
    float largest_ = 0;
};

/// A mesh on its way from the input to the coarsest, each tetrahedron with the removed points that are related to it
/// and bounds on their errors and warpings. Judges and does collapses; which and when is the caller's choice.
class DecimatedMesh {
public:
    static constexpr std::uint32_t none = CollapsibleMesh::none;

    /// `mesh` must outlive this and be sound. May throw std::bad_alloc.
    DecimatedMesh(const DecimationMesh& mesh, const DecimationOptions& options);

    std::uint32_t vertexCount() const noexcept { return static_cast<std::uint32_t>(input_.positions.size()); }

    /// A collapse and the largest key of the tetrahedra that it makes.
    struct Candidate {
        std::uint32_t target = none; ///< none: no collapse of the vertex is legal
        float key = 0;
        bool exists() const noexcept { return target != none; }
    };
    /// How far best() looks at what forbids collapses of boundary vertices of irregular meshes: what lies behind their
    /// neighbours takes long and seldom does, and collapse() asks for it anyway.
    enum class Legality { Whole, OfStar };
    /// Asks for the memory that looking at a vertex needs, step by step: each one needs what that before has fetched.
    void fetchAhead(std::uint32_t vertex, int step) const;
    static constexpr int fetchSteps = 3;

    /// The legal collapse of a vertex that has the smallest key; among equals the one that leaves the fewest
    /// tetrahedra, then the one onto the nearest target.
    Candidate best(std::uint32_t vertex, Legality legality = Legality::Whole);
    /// The collapse of a vertex onto a neighbour, if it is legal.
    Candidate judge(std::uint32_t vertex, std::uint32_t target);

    /// Does a collapse that best() named; nothing around the vertex has changed since. False, and nothing is done, if
    /// what lies behind its neighbours has come into the way on an irregular boundary, or makes the key larger.
    [[nodiscard]] bool collapse(std::uint32_t vertex, const Candidate& candidate);
    /// The vertices around the one that was removed last: their stars have changed.
    std::span<const std::uint32_t> touched() const noexcept { return touched_; }

    /// The key of the whole mesh.
    float key() const noexcept { return keys_.largest(); }
    std::uint64_t evaluations() const noexcept { return evaluations_; }
    std::uint64_t liveTetrahedra() const noexcept { return live_; }

    const CollapsibleMesh& tetrahedra() const noexcept { return mesh_; }
    const DecimationMesh& input() const noexcept { return input_; }
    /// Whether the vertex lies on the boundary of the mesh.
    bool onBoundary(std::uint32_t vertex) const noexcept { return sides_[vertex] != 0; }
    /// Whether the face of a tetrahedron opposite to a corner does.
    bool isOnBoundary(std::uint32_t slot, std::size_t corner) const noexcept;
    /// Whether coarser meshes may have a warping: not those of regular lattices.
    bool warps() const noexcept { return !warpings_.empty(); }
    /// A tetrahedron's own; 0 where nothing warps.
    float warpingOf(std::uint32_t slot) const { return warpings_.empty() ? 0 : warpings_[slot]; }

    /// Whether the boundary has nothing against a collapse onto a neighbour at first sight: in a box vertices stay on
    /// their sides, elsewhere boundary vertices on the boundary.
    bool mayMove(std::uint32_t vertex, std::uint32_t target) const;

    const CollapseLog& log() const noexcept { return log_; }
    std::vector<CollapseLog::Coarsest> coarsest() const;

    /// What collapses change: of a mesh of the same input.
    void archive(StateArchive& archive);

private:
    /// What a tetrahedron that a collapse makes gets of the star's points.
    struct Share {
        std::uint32_t* next = nullptr; ///< where the next one's number goes
        double error = 0;              ///< the largest
        double warping = 0;
        std::uint32_t count = 0;
    };

    static constexpr std::uint8_t locked = 0xff; ///< the mark of a vertex that stays

    void findSides();
    void findBoundary();
    bool movesOnBoundary(std::uint32_t vertex) const { return !input_.box && sides_[vertex] != 0; }
    double keyOfFacesAround() const;
    bool opens(std::uint32_t linkPlace) const;
    double evaluate(std::uint32_t linkPlace, double bound);
    Candidate bestOfCandidates(Legality legality);
    bool precedes(std::uint32_t linkPlace, std::uint32_t other) const;
    bool confirms(std::uint32_t linkPlace, Legality legality);
    bool boundaryAllows(std::uint32_t linkPlace);
    void setBoundaryChange(std::uint32_t linkPlace);
    bool swallows(std::uint32_t linkPlace);
    bool collapseOnBoundary(std::uint32_t linkPlace, float mostKey);
    void relateToBoundary();
    void raiseOwn(std::uint32_t slot);
    void setStar(std::uint32_t vertex);
    void boundCandidates();
    std::size_t nextCandidate(double least) const;
    void gatherPoints();
    void gatherSamples();
    void setFan(std::uint32_t linkPlace);
    bool inverts(std::uint32_t linkPlace) const;
    void logStar();
    void clearStates();
    void giveOutPoints();
    float keyOf(float error, float warping) const;

    const DecimationMesh input_;
    const std::vector<PlacedValue> placedValues_;
    const DecimationOptions options_;
    CollapseMeasure measure_;
    CollapsibleMesh mesh_;
    std::vector<float> warpings_; ///< own ones, by slot; empty where there are none
    IndexPool pool_;
    KeyTournament keys_;
    CollapseLog log_;
    std::vector<std::uint8_t> sides_; ///< by vertex: the sides of the box that it lies on, or 1 on another boundary
    BoundaryPoints boundaryPoints_;
    std::optional<BoundarySurface> boundary_; ///< of irregular meshes
    bool maySwallow_ = false; ///< its boundary has several pieces, of which one may come to lie inside of cells
    std::optional<BoundaryDistance> toOriginal_; ///< of irregular meshes, if it counts
    std::uint64_t evaluations_ = 0;
    std::uint64_t live_ = 0;

    VertexStar star_;
    LinkCondition linkCondition_;
    BoundaryCost boundaryCost_;
    std::vector<SurfaceTriangle> addedTriangles_;
    std::vector<SurfaceTriangle> removedTriangles_;
    std::vector<Tetrahedron> addedTetrahedra_;
    StarPoints points_;
    CollapseStar fan_;
    CollapseStar around_; ///< the star itself
    LinkSamples samples_;
    bool gathered_ = false;          ///< whether points_ is the star's
    bool sampled_ = false;           ///< whether samples_ are
    bool judging_ = false;           ///< whether boundaryCost_ is the star's
    std::uint32_t evaluated_ = none; ///< the place in the star's link that all of points_ were evaluated for last
    std::vector<std::uint32_t> candidates_; ///< places in the star's link
    std::vector<double> leastKeys_;         ///< of each candidate: a bound from below
    std::vector<std::uint32_t> touched_;
    std::vector<Share> shares_; ///< by face of the star
    std::vector<CollapseLog::Tetrahedron> logged_;
};

} // namespace tetra
