// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/collapsible_mesh.h"
#include "core/decimate/decimated_mesh.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

namespace tetra {

/// Collapses vertices, the one of the smallest exact key first, until none can go below `stopKey`. A queue whose
/// entries are looked at again when they come to its head after something around them has changed. Error: cancelled, or
/// `state` does not fit. If there is a `state`, as DecimationOptions::state.
Status decimateByExactError(DecimatedMesh& mesh, double stopKey, const Progress& progress, SavedState* state = nullptr);

/// The gradient of the field at a vertex of the input's mesh: the mean of the gradients of the tetrahedra around it,
/// weighted by their solid angles there (3.1.2). In the space that errors are measured in.
Eigen::Vector3d vertexGradient(const DecimatedMesh& mesh, std::uint32_t vertex);

/// What the paper expects of the loss of a vertex (3.1.2).
struct CollapseEstimate {
    std::uint32_t target = DecimatedMesh::none; ///< the neighbour of the most similar gradient; none: it stays
    double gradientDifference = std::numeric_limits<double>::infinity(); ///< how much its gradient differs
    /// Of a boundary vertex, how far it lies from the plane that fits its neighbours on the boundary best, in physical
    /// space; 0 inside, and where nothing can warp.
    double planeDistance = 0;
};

/// `gradients`: of all vertices. Targets are those that DecimatedMesh::mayMove() allows; among equals the first.
CollapseEstimate estimateCollapse(const DecimatedMesh& mesh, std::span<const Eigen::Vector3d> gradients,
                                  std::uint32_t vertex);

/// The paper's order (R11, 3.1.2): the vertex goes first that is expected to do the least harm, by the difference of
/// gradients while the mesh is worse off in error, by the distance from the plane while it is worse off in warping.
/// The exact key is tested before a collapse is done (S11); a vertex that cannot go is looked at again when its
/// star has changed. `state` and errors as above.
Status decimateByEstimates(DecimatedMesh& mesh, double warpingWeight, double stopKey, const Progress& progress,
                           SavedState* state = nullptr);

/// Rounds of collapses whose stars share no tetrahedron, smallest exact key first; a round has the keys up to a bound
/// that is doubled when nothing below it is left. The dependencies of the history are as shallow as the rounds are few.
/// `state` and errors as above.
Status decimateInRounds(DecimatedMesh& mesh, double stopKey, const Progress& progress, SavedState* state = nullptr);

/// Collapses in order of their keys, and of their vertices where these are equal. In place of one large heap, whose
/// every step waits for memory, those of some 1 % of the range of keys at hand lie sorted, so that it is known which
/// come next and what they need can be fetched ahead; those farther off wait unsorted.
class CollapseQueue {
public:
    struct Entry {
        float key; ///< not below 0
        std::uint32_t vertex;
        std::uint32_t target;
        std::uint32_t version;
        bool comesAfter(const Entry& other) const { return std::tie(key, vertex) > std::tie(other.key, other.vertex); }
    };

    /// May throw std::bad_alloc.
    CollapseQueue() : classes_(classCount) {}

    /// Any key, also one below what was taken last. May throw std::bad_alloc.
    void push(const Entry& entry);
    bool empty() const noexcept { return size_ == 0; }
    /// The key of the first. The queue is not empty.
    float leastKey();
    /// Takes the first. The queue is not empty.
    Entry pop();
    /// The vertex of the entry `distance` after the first, but for those pushed lately; `otherwise` if it is not known.
    std::uint32_t vertexAhead(std::size_t distance, std::uint32_t otherwise) const
    {
        return distance < sorted_.size() ? sorted_[sorted_.size() - 1 - distance].vertex : otherwise;
    }

    void archive(StateArchive& archive) { archive(classes_, open_, sorted_, late_, size_); }

private:
    static constexpr int classBits = 17; ///< of a key's lowest that do not count: 64 classes an octave
    static constexpr std::size_t classCount = std::size_t(1) << (31 - classBits);

    static std::size_t classOf(float key);
    void openNextClass();
    bool lateIsFirst() const;

    std::vector<std::vector<Entry>> classes_; ///< by key; empty up to the open one
    std::size_t open_ = 0;                    ///< the class whose entries are sorted, or were pushed since
    std::vector<Entry> sorted_;               ///< the first at the end
    std::vector<Entry> late_;                 ///< a heap of those of the open class and lower ones pushed since
    std::size_t size_ = 0;
};

} // namespace tetra
