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

GradientSum termOf(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& sites)
{
    const Eigen::Vector3d origin = mesh.positions[sites[0]].cast<double>();
    const Eigen::Vector3d b = mesh.positions[sites[1]].cast<double>() - origin;
    const Eigen::Vector3d c = mesh.positions[sites[2]].cast<double>() - origin;
    const Eigen::Vector3d d = mesh.positions[sites[3]].cast<double>() - origin;
    const double value = mesh.values[sites[0]];
    const Eigen::Vector3d normal = c.cross(d);
    const Eigen::Vector3d gradient = (mesh.values[sites[1]] - value) * normal +
                                     (mesh.values[sites[2]] - value) * d.cross(b) +
                                     (mesh.values[sites[3]] - value) * b.cross(c);
    return {gradient.cast<float>(), static_cast<float>(b.dot(normal))};
}

/// Adds up for the vertices in [first, last) only, in the order of the tetrahedra: the sums are the same bit for bit
/// however the vertices are shared out, without locks. The price is that a tetrahedron between two threads' vertices
/// is computed by both.
void sumOver(const TetrahedralMesh& mesh, std::uint32_t first, std::uint32_t last, GradientSum* sums)
{
    const auto isMine = [&](std::uint32_t vertex) { return vertex - first < last - first; };
    for (const auto& sites : mesh.tetrahedra) {
        if (std::ranges::none_of(sites, isMine))
            continue;
        const GradientSum term = termOf(mesh, sites);
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
    std::vector<GradientSum> sums(count);
    const auto shares = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    tbb::parallel_for(std::size_t(0), shares, [&](std::size_t share) {
        const std::size_t first = count * share / shares;
        const std::size_t last = count * (share + 1) / shares;
        sumOver(mesh, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), sums.data());
        for (std::size_t v = first; v < last; ++v)
            gradients[v] =
                sums[v].volume > 0 ? Eigen::Vector3f(sums[v].gradient / sums[v].volume) : Eigen::Vector3f(0, 0, 0);
    });
    return gradients;
}

} // namespace tetra
