// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/curvilinear/curvilinear_mesh.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/lattice_samples.h"

#include <tan/base.h>
#include <tan/build.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

class SavedState;

struct CurvilinearRefinementOptions {
    /// Units of the values for a unit of length, more than 0: the key of a mesh is the larger of its error and this
    /// times its warping (S4).
    double warpingWeight = 1;
    double stopKey = 0;        ///< stop at the first consistent mesh with no larger key
    double valueExtent = 1;    ///< largest minus smallest value; only the speed depends on it
    double positionExtent = 1; ///< the diagonal of the positions' bounding box; likewise
    CurvilinearSelection selection = CurvilinearSelection::Normalised;
    /// Keep the error in space as well (C12), with the normalised selection.
    bool inSpace = false;
    /// That the refinement goes on from, if there is one, and keeps up to date; of this grid and these options.
    SavedState* state = nullptr;
    /// For those who make a history again, and know its sites only: all other points have the weight 0.
    const KnownOfGrid* known = nullptr;
};

struct CurvilinearRefinementResult {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
    float finalKey = 0;
    std::uint64_t inverted = 0;   ///< tetrahedra of the last mesh that stay flipped, as the grid itself is there (S5)
    std::uint64_t degenerate = 0; ///< tetrahedra of the last mesh without volume (S6)
};

/// Greedy refinement of a curvilinear grid in computational space (3.1, R8, R9): starting from the eight corners,
/// inserts the point of the largest key until no point's key exceeds the stop. Before that flipped tetrahedra are
/// cured, each by the deepest point in its circumsphere; the worst point inside would do only where there is one, and
/// needs more sites. So every mesh with a finite key is consistent: all that is flipped in it meets a cell that the
/// grid itself has folded, or is made of corners of one cell (CurvilinearGrid::allowsInverted(), S5).
///
/// With the paper's selection the mesh's warping against its error, both in their own units, decides whether the point
/// of the largest warping or of the largest error comes next.
///
/// To keep the error in space as well, the mesh goes down rung by rung, each a twentieth below the key that the last
/// one reached: refined in the grid to the rung, then the error in space is measured at all points (SpaceErrors), the
/// worst of each tetrahedron that is worse than the rung is inserted, and both again until neither is. Only the meshes
/// at the ends of rungs have a finite key, the larger of the two, so that it holds for every mesh that a query can
/// give.
///
/// Ties go to the first point of the grid, so the history depends on nothing but the data. The history goes to `sink`
/// while it is made, then sink.finish(). One thread, but for measuring; about 600 bytes a point. Errors: too large a
/// grid, refused memory, the sink's, cancelled.
///
/// `size`: points along each axis of the grid, at least two. `positions`: where they lie, one a point, all finite.
/// `samples`: their values, with weights that multiply errors and warpings or without (R6).
Result<CurvilinearRefinementResult> refineCurvilinear(const std::array<std::uint32_t, 3>& size,
                                                      std::span<const Eigen::Vector3d> positions,
                                                      const LatticeSamples& samples,
                                                      const CurvilinearRefinementOptions& options, HistorySink& sink,
                                                      const Progress& progress = {});

/// A site on a face between blocks that is inserted for no error of its own: one of the blocks needed it to cure a
/// flipped tetrahedron, when its running key was `key`. All blocks that have the point insert it at this key.
struct FaceCure {
    std::uint64_t point = 0; ///< of the whole grid
    float key = 0;
    std::uint32_t unused = 0; ///< so that all bytes have a value
};

/// The cures on the faces of each block, which grow from round to round until no block needs another (C7, S4).
class FaceCures {
public:
    explicit FaceCures(const BlockDivision& division) : division_(division), ofBlocks_(division.count()) {}

    /// By falling keys, then by points: the order of their insertion.
    std::span<const FaceCure> of(std::uint32_t block) const { return ofBlocks_[block]; }
    /// Tells all blocks that have the points. Of two keys for one point the larger one stays. The blocks that did not
    /// know all that already, in rising order.
    std::vector<std::uint32_t> add(std::span<const FaceCure> found);
    /// All points of the faces between blocks that these are on, from the first mesh on: of such a face no block can
    /// need a further one, so that the rounds come to an end.
    std::vector<FaceCure> wholeFacesOf(std::span<const FaceCure> found) const;
    /// Each once, by points.
    std::vector<FaceCure> all() const;

private:
    BlockDivision division_;
    std::vector<std::vector<FaceCure>> ofBlocks_;
};

/// One block of a curvilinear grid, to be refined by itself.
struct CurvilinearBoxOptions {
    std::array<std::uint32_t, 3> size{2, 2, 2}; ///< of the whole grid
    LatticeBox box;                             ///< at least two points along each axis
    bool centreAtOrigin = true;                 ///< LatticeBoxOptions
    CurvilinearFacts facts;                     ///< of the whole grid, as the following
    double warpingWeight = 1;
    double stopKey = 0;
    double valueExtent = 1;
    double positionExtent = 1;
};

/// Refines blocks of a curvilinear grid one after another in the same memory, each as refineCurvilinear() does with the
/// normalised key. Blocks that share a face have the same sites on it, each with the same running key, and the same
/// triangles at every running key (R10, S4), if all of them are given the same cures on it and find no others.
///
/// That is because which point of a face comes next depends on the face alone: a block inserts one if it is the worst
/// of the block, and so the worst of the face, with the same key in every block (CurvilinearMesh); or if it is a cure
/// that is known, before the first mesh that is better than the cure's key. Flipped tetrahedra are cured by points that
/// no other block has, which does not change the face, as long as there is one in the circumsphere.
///
/// An object belongs to one thread; several work on one grid at once. Memory as for the largest block so far.
class CurvilinearRefiner {
public:
    CurvilinearRefiner();
    ~CurvilinearRefiner();
    CurvilinearRefiner(CurvilinearRefiner&&) noexcept;
    CurvilinearRefiner& operator=(CurvilinearRefiner&&) noexcept;

    /// `positions` and `samples` are those of the whole grid; of them only the box is read. `known`: FaceCures::of()
    /// the block. To `found` cures on faces are appended that were not known but needed; if there are any, the history
    /// does not fit those of other blocks. HistoryStep::point counts in the whole grid, sites and tetrahedra are
    /// numbered in the block. Errors: as refineCurvilinear().
    Result<CurvilinearRefinementResult> refine(const CurvilinearBoxOptions& options,
                                               std::span<const Eigen::Vector3d> positions,
                                               const LatticeSamples& samples, std::span<const FaceCure> known,
                                               std::vector<FaceCure>& found, HistorySink& sink,
                                               const Progress& progress = {});

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace tetra
