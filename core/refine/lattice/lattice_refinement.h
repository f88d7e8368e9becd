// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/lattice_samples.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>
#include <tan/build.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>

namespace tetra {

class SavedState;

struct LatticeRefinementOptions {
    std::array<std::uint32_t, 3> size{2, 2, 2}; ///< points along each axis, at least two
    Eigen::Vector3d spacing{1, 1, 1};           ///< the Delaunay criterion holds in physical space
    double valueExtent = 1;                     ///< largest minus smallest value; only the speed depends on it
    double stopError = 0;                       ///< stop at the first mesh with no larger error, in units of the values
    /// That the refinement goes on from, if there is one, and keeps up to date; of this lattice and these options.
    SavedState* state = nullptr;
};

struct LatticeRefinementResult {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
    float finalKey = 0;
};

/// Greedy refinement of a regular lattice (3.1, R8): starting from the eight corners, inserts the point of the largest
/// error until no point's error exceeds the stop. Ties go to the first point of the lattice, so the history depends on
/// nothing but the data. The history goes to `sink` while it is made, then sink.finish(). One thread; about 500 bytes a
/// site. Errors: too large a lattice, refused memory, the sink's, cancelled.
Result<LatticeRefinementResult> refineLattice(const LatticeRefinementOptions& options, const LatticeSamples& samples,
                                              HistorySink& sink, const Progress& progress = {});

/// One box of a lattice, to be refined by itself.
struct LatticeBoxOptions {
    std::array<std::uint32_t, 3> latticeSize{2, 2, 2}; ///< points along each axis of the whole lattice
    LatticeBox box;                                    ///< at least two points along each axis
    /// The same for all boxes that share faces: latticeMetric() of the largest of them.
    LatticeMetric metric{1, 1, 1};
    /// Which diagonals the start has on the box's faces; must alternate from box to box along each axis.
    bool centreAtOrigin = true;
    double valueExtent = 1;      ///< of the whole lattice; only the speed depends on it
    double stopError = 0;        ///< in units of the values
    SavedState* state = nullptr; ///< LatticeRefinementOptions
};

/// Refines boxes one after another in the same memory, each as refineLattice() does. Boxes that share a face have the
/// same sites on it, each with the same running key, and the same triangles at every running key (R10, S3): which face
/// point is next depends on the face alone, because a point's error is the same float in every box and tetrahedron that
/// holds it, and equal errors go to the first point of the lattice. An object belongs to one thread; several work on
/// one lattice at once. Memory as for the largest box so far.
class LatticeRefiner {
public:
    LatticeRefiner();
    ~LatticeRefiner();
    LatticeRefiner(LatticeRefiner&&) noexcept;
    LatticeRefiner& operator=(LatticeRefiner&&) noexcept;

    /// `samples` are those of the whole lattice; of them only the box is read. HistoryStep::point counts in the whole
    /// lattice, sites and tetrahedra are numbered in the box. Errors: as refineLattice(), and a box that sticks out.
    Result<LatticeRefinementResult> refine(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                           HistorySink& sink, const Progress& progress = {});

private:
    class State;
    std::unique_ptr<State> state_;
};

} // namespace tetra
