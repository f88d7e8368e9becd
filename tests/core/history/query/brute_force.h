// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace tetra {

/// The answers to queries by going through the whole history again and again, straight from the definitions.
class BruteForce {
public:
    explicit BruteForce(const Model& model);

    struct Answer {
        std::vector<bool> sites;
        std::vector<std::uint64_t> tetrahedra; ///< numbers in the history
        double scale = 1;
    };
    Answer smallestClosedSet(const MeshQuery& query, bool fromFirstMesh = false) const;
    /// The last of the sets, from coarse to fine, before the first that has too many tetrahedra.
    std::optional<Answer> closedSetWithin(const MeshQuery& query) const;

    /// The corners of a tetrahedron, its creator first.
    std::array<std::uint32_t, 4> corners(std::uint64_t tetrahedron) const;

private:
    std::vector<bool> groupClosure(std::vector<bool> sites, const std::vector<double>& scales, double most) const;
    std::vector<double> scalesOf(const MeshQuery& query) const;
    Answer meshOf(std::vector<bool> sites) const;

    const Model& model_;
    std::vector<std::uint32_t> creators_;
    std::vector<std::uint32_t> groups_; ///< of each site
};

} // namespace tetra
