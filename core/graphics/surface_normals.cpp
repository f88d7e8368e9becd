// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/surface_normals.h"

#include <Eigen/Geometry>

#include <cmath>
#include <unordered_map>

namespace tetra {
namespace {

/// The unit vector of a direction, or zero if it has none. Scaled first, so that no square overflows or vanishes.
Eigen::Vector3f unitOrZero(const Eigen::Vector3d& direction)
{
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !direction.allFinite())
        return Eigen::Vector3f::Zero();
    return (direction / largest).normalized().cast<float>();
}

} // namespace

void fillNormalsFromTriangles(TriangleMesh& surface)
{
    std::unordered_map<std::uint32_t, Eigen::Vector3d> sums;
    for (std::size_t v = 0; v < surface.normals.size(); ++v)
        if (surface.normals[v].isZero(0))
            sums.emplace(static_cast<std::uint32_t>(v), Eigen::Vector3d::Zero());
    for (const auto& triangle : surface.triangles) {
        const Eigen::Vector3d corner = surface.positions[triangle[0]].cast<double>();
        const Eigen::Vector3d normal = (surface.positions[triangle[1]].cast<double>() - corner)
                                           .cross(surface.positions[triangle[2]].cast<double>() - corner);
        for (const std::uint32_t vertex : triangle)
            if (const auto sum = sums.find(vertex); sum != sums.end())
                sum->second += normal;
    }
    for (const auto& [vertex, sum] : sums) {
        const Eigen::Vector3f normal = unitOrZero(sum);
        surface.normals[vertex] = normal.isZero(0) ? Eigen::Vector3f::UnitZ() : normal;
    }
}

} // namespace tetra
