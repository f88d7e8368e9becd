// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/isosurface.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace tetra {
namespace {

/// Sums over the tetrahedra of a vertex: six times volume times gradient, and six times volume.
struct GradientSum {
    Eigen::Vector3f gradient{0, 0, 0};
    float volume = 0;
};

/// Position and value of a vertex, side by side: in a mesh in order of construction each corner is a cache miss, and
/// so it is one instead of two.
struct Corner {
    Eigen::Vector3f position;
    float value;
};

Buffer<Corner> makeCorners(const TetrahedralMesh& mesh)
{
    Buffer<Corner> corners(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, corners.size(), 1 << 15), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            corners[v] = {mesh.positions[v], mesh.values[v]};
    });
    return corners;
}

GradientSum termOf(const Corner& first, const Corner& second, const Corner& third, const Corner& fourth)
{
    const Eigen::Vector3d origin = first.position.cast<double>();
    const Eigen::Vector3d b = second.position.cast<double>() - origin;
    const Eigen::Vector3d c = third.position.cast<double>() - origin;
    const Eigen::Vector3d d = fourth.position.cast<double>() - origin;
    const double value = first.value;
    const Eigen::Vector3d normal = c.cross(d);
    const Eigen::Vector3d gradient =
        (second.value - value) * normal + (third.value - value) * d.cross(b) + (fourth.value - value) * b.cross(c);
    return {gradient.cast<float>(), static_cast<float>(b.dot(normal))};
}

/// Asks for the memory of a tetrahedron that comes some turns later.
void prefetch(const std::array<std::uint32_t, 4>& sites, const Buffer<Corner>& corners, const GradientSum* sums)
{
#if defined(__GNUC__)
    for (const std::uint32_t vertex : sites) {
        __builtin_prefetch(&corners[vertex]);
        __builtin_prefetch(&sums[vertex], 1);
    }
#endif
}

/// Adds up for the vertices in [first, last) only, in the order of the tetrahedra: the sums are the same bit for bit
/// however the vertices are shared out, without locks. The price is that a tetrahedron between two threads' vertices
/// is computed by both.
void sumOver(const TetrahedralMesh& mesh, const Buffer<Corner>& corners, std::uint32_t first, std::uint32_t last,
             GradientSum* sums)
{
    constexpr std::size_t ahead = 12;
    const std::size_t count = mesh.tetrahedra.size();
    const auto isMine = [&](std::uint32_t vertex) { return vertex - first < last - first; };
    for (std::size_t t = 0; t < count; ++t) {
        if (t + ahead < count)
            prefetch(mesh.tetrahedra[t + ahead], corners, sums);
        const auto& sites = mesh.tetrahedra[t];
        if (std::ranges::none_of(sites, isMine))
            continue;
        const GradientSum term = termOf(corners[sites[0]], corners[sites[1]], corners[sites[2]], corners[sites[3]]);
        for (const std::uint32_t vertex : sites) {
            if (!isMine(vertex))
                continue;
            sums[vertex].gradient += term.gradient;
            sums[vertex].volume += term.volume;
        }
    }
}

} // namespace

Buffer<Eigen::Vector3f> vertexGradients(const TetrahedralMesh& mesh)
{
    const std::size_t count = mesh.positions.size();
    Buffer<Eigen::Vector3f> gradients(count);
    const Buffer<Corner> corners = makeCorners(mesh);
    std::vector<GradientSum> sums(count);
    const auto shares = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    tbb::parallel_for(std::size_t(0), shares, [&](std::size_t share) {
        const std::size_t first = count * share / shares;
        const std::size_t last = count * (share + 1) / shares;
        sumOver(mesh, corners, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), sums.data());
        for (std::size_t v = first; v < last; ++v)
            gradients[v] =
                sums[v].volume > 0 ? Eigen::Vector3f(sums[v].gradient / sums[v].volume) : Eigen::Vector3f(0, 0, 0);
    });
    return gradients;
}

} // namespace tetra
