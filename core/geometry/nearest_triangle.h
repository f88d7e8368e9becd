// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangles.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// Says how far places are from a surface of triangles. O(n log^2 n) to build, then some microseconds a place. Safe to
/// ask from any number of threads; positions and triangles outlive it.
class NearestTriangle {
public:
    NearestTriangle(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles)
        : positions_(positions), triangles_(triangles),
          tree_(
              triangles.size(),
              [this](std::uint32_t triangle) {
                  Eigen::AlignedBox3d box;
                  for (const std::uint32_t corner : triangles_[triangle])
                      box.extend(positions_[corner]);
                  return box;
              },
              [this](std::uint32_t triangle, Eigen::Index axis) {
                  const auto& [a, b, c] = triangles_[triangle];
                  return positions_[a][axis] + positions_[b][axis] + positions_[c][axis];
              })
    {
    }

    struct Found {
        std::uint32_t triangle = 0;
        double distance = 0;
    };

    /// Of a surface that has triangles; the search begins with one of them, at its quickest with one that is near.
    Found nearest(const Eigen::Vector3d& place, std::uint32_t hint) const
    {
        Found best{hint, distanceTo(hint, place)};
        tree_.visitNearer(
            place, [&best] { return best.distance; },
            [&](std::uint32_t triangle) {
                if (const double distance = distanceTo(triangle, place); distance < best.distance)
                    best = {triangle, distance};
            });
        return best;
    }

    double distanceTo(std::uint32_t triangle, const Eigen::Vector3d& place) const
    {
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d from = positions_[triangles_[triangle][i]] - place;
            corners[i] = {from.x(), from.y(), from.z()};
        }
        const auto weights = nearestWeights(corners);
        Eigen::Vector3d to = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            to += weights[i] * Eigen::Vector3d(corners[i][0], corners[i][1], corners[i][2]);
        return to.norm();
    }

private:
    std::span<const Eigen::Vector3d> positions_;
    std::span<const SurfaceTriangle> triangles_;
    BoxTree tree_;
};

} // namespace tetra
