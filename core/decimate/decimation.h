// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/build.h>

#include <Eigen/Core>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace tetra {

class SavedState;

/// A conforming mesh to be decimated, with a value at each point. Owns nothing.
struct DecimationMesh {
    /// Where the points lie in the space that tetrahedra are positive and errors are measured in: of lattices and
    /// curvilinear grids the computational one (R5).
    std::span<const Eigen::Vector3d> positions;
    /// Of curvilinear data where the points lie in physical space, that warpings are measured in (R4); else empty.
    std::span<const Eigen::Vector3d> physical;
    std::span<const double> values; ///< finite, one for each point
    std::span<const float> weights; ///< that errors and warpings are multiplied by (R6), in (0, 1]; empty: 1
    std::span<const std::array<std::uint32_t, 4>> tetrahedra; ///< positive, every point in one of them
    /// Whether the domain is the box of the positions, as of lattices and curvilinear grids: its boundary is kept
    /// exactly, so that there is no warping but that of `physical`.
    bool box = false;
    /// Of curvilinear data: most corners of the grid's cells are negative in physical space, so that tetrahedra which
    /// are positive there are inverted (S5).
    bool leftHanded = false;
};

struct DecimationOptions {
    DecimationOrder order = DecimationOrder::ExactError;
    /// Units of the values for a unit of length: the key of a mesh is the larger of its error and this times its
    /// warping (S4). Positive if there can be warping.
    double warpingWeight = 0;
    /// Of irregular meshes: whether the distance of every place of a mesh's boundary from the original one counts as
    /// warping, too, unweighted (S13); else only that of the original boundary's points from the mesh's, as in the
    /// paper.
    bool twoSided = false;
    /// No collapse lets the key rise above it. Infinite: down to the coarsest mesh.
    double stopKey = std::numeric_limits<double>::infinity();
    /// That the decimation goes on from, if there is one, and keeps up to date; of this mesh and these options.
    SavedState* state = nullptr;
    // As in BuildTarget.
    std::function<void(const std::function<Status(HistorySink& history)>& hand)> preview{};
    const std::atomic<bool>* keepWhenCancelled = nullptr;
};

struct DecimationResult {
    std::uint32_t sites = 0;        ///< all points
    std::uint32_t initialSites = 0; ///< of the coarsest mesh
    std::uint64_t tetrahedra = 0;   ///< all that ever lived
    std::uint64_t evaluations = 0;  ///< collapses that were tried out
    bool stoppedEarly = false;      ///< cancelled, and kept
};

/// Half-edge collapse judged by the exact resulting error and warping (R11, S11, S12), to the end or to `stopKey`; the
/// history of vertex splits, coarse first, then goes to `sink` with delaunay = false, and sink.finish(). Every mesh on
/// the way is conforming, positive, keeps the domain's components, holes and cavities, and its boundary does not meet
/// itself but where the input's does (C10). One that is cancelled and kept ends where it is, as by a stopKey. One
/// thread. Errors: numbers out of range, more than 2^32 - 2 points, refused memory (decimationBytes() beforehand), the
/// sink's, cancelled.
Result<DecimationResult> decimate(const DecimationMesh& mesh, const DecimationOptions& options, HistorySink& sink,
                                  const Progress& progress = {});

/// About the largest memory that decimate() takes for a mesh of this size, besides its input.
std::uint64_t decimationBytes(std::uint64_t points, std::uint64_t tetrahedra);

} // namespace tetra
