// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/collapsible_mesh.h"
#include "core/decimate/decimated_mesh.h"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tetra {

/// Collapses vertices, the one of the smallest exact key first, until none can go below `stopKey`. A queue whose
/// entries are looked at again when they come to its head after something around them has changed. Error: cancelled.
Status decimateByExactError(DecimatedMesh& mesh, double stopKey, const Progress& progress);

/// The paper's order (R11): each vertex goes onto the neighbour of the most similar gradient, the most similar ones
/// first; boundary vertices of irregular meshes by their distance from the plane that fits their boundary neighbours
/// best. The exact key is tested before a collapse is done (S11); a vertex that cannot go is looked at again when its
/// star has changed. Error: cancelled.
Status decimateByEstimates(DecimatedMesh& mesh, double warpingWeight, double stopKey, const Progress& progress);

/// Rounds of collapses whose stars share no tetrahedron, smallest exact key first; a round has the keys up to a bound
/// that is doubled when nothing below it is left. The dependencies of the history are as shallow as the rounds are few.
/// Error: cancelled.
Status decimateInRounds(DecimatedMesh& mesh, double stopKey, const Progress& progress);

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
