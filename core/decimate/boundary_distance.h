// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"
#include "core/geometry/nearest_triangle.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace tetra {

/// How far triangles between points of a mesh are from its original boundary: the direction that the paper's warping
/// leaves out (S13).
class BoundaryDistance {
public:
    /// `positions` outlive it; `original` is not empty.
    BoundaryDistance(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> original);
    BoundaryDistance(BoundaryDistance&&) = default; // not copied: the tree looks at the triangles
    BoundaryDistance& operator=(BoundaryDistance&&) = default;

    /// A bound that no place of the triangle exceeds, `known` at most, which is one. The triangle is cut up only until
    /// the bound is `enough`, or a place is farther than `tooMuch`, or a twentieth more than what was found, or there
    /// are dozens of pieces. What was found is kept for the next time. Some microseconds a piece.
    double bound(const SurfaceTriangle& triangle, double known, double enough, double tooMuch);

    void archive(StateArchive& archive) { archive(known_); }

private:
    /// A piece of a triangle, no place of which is farther than `bound`.
    struct Piece {
        double bound = 0;
        std::array<Eigen::Vector3d, 3> corners;
        std::uint32_t near = 0; ///< of the original
    };
    struct KeyHash {
        std::size_t operator()(const SurfaceTriangle& key) const noexcept
        {
            std::uint64_t hash = 0;
            for (const std::uint32_t corner : key)
                hash = (hash ^ corner) * 0x9e3779b97f4a7c15 + (hash >> 29);
            return hash;
        }
    };

    Piece looked(const std::array<Eigen::Vector3d, 3>& corners, std::uint32_t hint, double& found) const;

    std::span<const Eigen::Vector3d> positions_;
    std::vector<SurfaceTriangle> original_;
    NearestTriangle surface_;                                    ///< of `original_`
    std::unordered_map<SurfaceTriangle, double, KeyHash> known_; ///< by corners in increasing order
    std::vector<Piece> pieces_;
};

} // namespace tetra
