// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/sight/surface_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace tetra {
namespace {

/// Crossings of one surface that are nearer to each other than this part of their distance are one, on an edge.
constexpr double sameCrossing = 1e-9;

/// Where a line passes through a triangle.
struct TriangleCrossing {
    double at;   ///< of SightLine
    double u, v; ///< weights of the second and the third corner
    bool front;  ///< the line comes from where the corners are seen counterclockwise
};

/// From either side (Möller and Trumbore).
std::optional<TriangleCrossing> crossing(const SightLine& line, const std::array<Eigen::Vector3d, 3>& corners)
{
    const Eigen::Vector3d one = corners[1] - corners[0];
    const Eigen::Vector3d other = corners[2] - corners[0];
    const Eigen::Vector3d across = line.direction.cross(other);
    const double volume = one.dot(across);
    if (volume == 0)
        return std::nullopt;
    const Eigen::Vector3d from = line.origin - corners[0];
    const double u = from.dot(across) / volume;
    const Eigen::Vector3d beside = from.cross(one);
    const double v = line.direction.dot(beside) / volume;
    if (u < 0 || v < 0 || u + v > 1)
        return std::nullopt;
    return TriangleCrossing{other.dot(beside) / volume, u, v, volume > 0};
}

double valueAtCrossing(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle,
                       const TriangleCrossing& met)
{
    if (mesh.values.empty())
        return 0;
    const double first = mesh.values[triangle[0]];
    return first + met.u * (mesh.values[triangle[1]] - first) + met.v * (mesh.values[triangle[2]] - first);
}

bool isSame(const SurfaceCrossing& one, const SurfaceCrossing& other)
{
    return one.surface == other.surface &&
           std::abs(one.at - other.at) <= sameCrossing * std::max(std::abs(one.at), std::abs(other.at));
}

} // namespace

std::vector<SurfaceCrossing> surfaceCrossings(const std::vector<Surface>& surfaces, const SightLine& line,
                                              const SightPart& part)
{
    std::vector<SurfaceCrossing> crossings;
    for (std::size_t surface = 0; surface < surfaces.size(); ++surface) {
        const TriangleMesh& mesh = *surfaces[surface].mesh;
        for (const auto& triangle : mesh.triangles) {
            const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
                return mesh.positions[triangle[i]].cast<double>();
            };
            const auto met = crossing(line, {corner(0), corner(1), corner(2)});
            if (met && part.contains(met->at) && !(met->front && surfaces[surface].backFacesOnly))
                crossings.push_back({met->at, surface, valueAtCrossing(mesh, triangle, *met)});
        }
    }
    std::ranges::sort(crossings, {}, [](const SurfaceCrossing& one) { return std::tuple(one.surface, one.at); });
    const auto doubled = std::ranges::unique(crossings, isSame);
    crossings.erase(doubled.begin(), doubled.end());
    std::ranges::stable_sort(crossings, {}, &SurfaceCrossing::at);
    return crossings;
}

} // namespace tetra
