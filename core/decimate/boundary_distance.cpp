// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/boundary_distance.h"

#include <algorithm>
#include <limits>

namespace tetra {

BoundaryDistance::BoundaryDistance(std::span<const Eigen::Vector3d> positions,
                                   std::span<const SurfaceTriangle> original)
    : positions_(positions), original_(original.begin(), original.end()), surface_(positions_, original_)
{
}

/// Distances change no faster than places; that to one triangle, which is convex, is largest at a corner.
BoundaryDistance::Piece BoundaryDistance::looked(const std::array<Eigen::Vector3d, 3>& corners, std::uint32_t hint,
                                                 double& found) const
{
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    const NearestTriangle::Found next = surface_.nearest(middle, hint);
    found = std::max(found, next.distance);
    double size = 0, atCorners = 0;
    for (const Eigen::Vector3d& corner : corners) {
        size = std::max(size, (corner - middle).norm());
        atCorners = std::max(atCorners, surface_.distanceTo(next.triangle, corner));
    }
    return {std::min(next.distance + size, atCorners), corners, next.triangle};
}

double BoundaryDistance::bound(const SurfaceTriangle& triangle, double known, double enough, double tooMuch)
{
    constexpr std::size_t mostPieces = 96, mostKnown = std::size_t(1) << 20;
    constexpr double closeEnough = 1.05;
    SurfaceTriangle key = triangle;
    std::ranges::sort(key);
    if (const auto entry = known_.find(key); entry != known_.end())
        known = std::min(known, entry->second);
    if (known <= enough)
        return known;
    double found = 0;
    pieces_ = {looked({positions_[triangle[0]], positions_[triangle[1]], positions_[triangle[2]]}, 0, found)};
    std::size_t count = 1;
    while (pieces_.front().bound > std::max(enough, closeEnough * found) && found <= tooMuch && count < mostPieces) {
        const Piece piece = pieces_.front();
        std::ranges::pop_heap(pieces_, {}, &Piece::bound);
        pieces_.pop_back();
        const auto& [a, b, c] = piece.corners;
        const Eigen::Vector3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
        for (const auto& part :
             {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
            pieces_.push_back(looked(part, piece.near, found));
            std::ranges::push_heap(pieces_, {}, &Piece::bound);
        }
        count += 4;
    }
    known = std::min(known, pieces_.front().bound);
    if (known_.size() >= mostKnown)
        known_.clear();
    known_[key] = known;
    return known;
}

} // namespace tetra
