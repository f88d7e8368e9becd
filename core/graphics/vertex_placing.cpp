// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/vertex_placing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr std::size_t fetchedAhead = 16;

double crossingFraction(double first, double second, double isovalue)
{
    const double fraction = (isovalue - first) / (second - first);
    return fraction >= 0 && fraction <= 1 ? fraction : 0.5;
}

/// Against the gradient, or zero if that has no direction. Squares of floats neither vanish nor overflow in doubles.
Eigen::Vector3f normalOf(const Eigen::Vector3f& first, const Eigen::Vector3f& second, double fraction)
{
    Eigen::Vector3d gradient = (1 - fraction) * first.cast<double>() + fraction * second.cast<double>();
    // An end that the vertex coincides with counts alone: the other's gradient may not be finite.
    if (fraction <= 0)
        gradient = first.cast<double>();
    if (fraction >= 1)
        gradient = second.cast<double>();
    const double square = gradient.squaredNorm();
    if (!(square > 0) || std::isinf(square))
        return Eigen::Vector3f::Zero();
    return (gradient * (-1 / std::sqrt(square))).cast<float>();
}

} // namespace

PlacingFindings placeVertices(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                              std::span<const EdgeKey> edges, double isovalue, TriangleMesh& surface)
{
    surface.positions.resize(edges.size());
    surface.normals.resize(edges.size());
    tbb::enumerable_thread_specific<PlacingFindings> found;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 1 << 12), [&](const auto& range) {
        PlacingFindings& mine = found.local();
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            for (const std::uint32_t end : endsOf(edges[std::min(v + fetchedAhead, edges.size() - 1)])) {
                __builtin_prefetch(&mesh.positions[end]);
                __builtin_prefetch(&mesh.values[end]);
                __builtin_prefetch(&gradients[end]);
            }
            const auto [a, b] = endsOf(edges[v]);
            const double fraction = crossingFraction(double(mesh.values[a]), double(mesh.values[b]), isovalue);
            const Eigen::Vector3d from = mesh.positions[a].cast<double>();
            const Eigen::Vector3d to = mesh.positions[b].cast<double>();
            const Eigen::Vector3f position = (from + fraction * (to - from)).cast<float>();
            surface.positions[v] = position;
            if (position == mesh.positions[a] || position == mesh.positions[b])
                mine.ties.push_back({position == mesh.positions[a] ? a : b, static_cast<std::uint32_t>(v)});
            surface.normals[v] = normalOf(gradients[a], gradients[b], fraction);
            mine.normalsMissing = mine.normalsMissing || surface.normals[v].isZero(0);
        }
    });
    PlacingFindings all;
    for (const PlacingFindings& one : found) {
        all.ties.insert(all.ties.end(), one.ties.begin(), one.ties.end());
        all.normalsMissing = all.normalsMissing || one.normalsMissing;
    }
    std::ranges::sort(all.ties);
    return all;
}

} // namespace tetra
