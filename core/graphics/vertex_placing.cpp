// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/vertex_placing.h"

#include "core/base/simd.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr std::size_t edgesFetchedAhead = 24;
constexpr std::size_t blockSize = 64;

using Components = std::array<std::array<float, blockSize>, 3>;

/// The edges of some vertices, and what becomes of them, component by component. Edges are walked inwards: whatever the
/// numbers of their ends are, the vertex is at the same place to the last bit.
struct VertexBlock {
    std::array<std::array<std::uint32_t, 2>, blockSize> ends; ///< the one outside first
    std::array<std::array<float, blockSize>, 2> values;
    std::array<Components, 2> positions;
    std::array<Components, 2> gradients;
    Components placed;
    Components normals;
    std::array<std::uint8_t, blockSize> findings; ///< bit 0, 1: it lies in the first, second end; bit 2: no normal
};

void load(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients, std::span<const EdgeKey> edges,
          double isovalue, std::size_t first, std::size_t count, VertexBlock& block)
{
    for (std::size_t i = 0; i < count; ++i) {
        for (const std::uint32_t end : endsOf(edges[std::min(first + i + edgesFetchedAhead, edges.size() - 1)])) {
            __builtin_prefetch(&mesh.positions[end]);
            __builtin_prefetch(&mesh.values[end]);
            __builtin_prefetch(&gradients[end]);
        }
        const auto [a, b] = endsOf(edges[first + i]);
        // Which end is inside is hard to predict, so that decides no branch.
        const std::uint32_t isFirstInside = static_cast<double>(mesh.values[a]) >= isovalue ? 1 : 0;
        const std::uint32_t swap = (a ^ b) & (0 - isFirstInside);
        const std::array ends = {a ^ swap, b ^ swap};
        block.ends[i] = ends;
        for (std::size_t end = 0; end < 2; ++end) {
            block.values[end][i] = mesh.values[ends[end]];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block.positions[end][axis][i] = mesh.positions[ends[end]][static_cast<int>(axis)];
                block.gradients[end][axis][i] = gradients[ends[end]][static_cast<int>(axis)];
            }
        }
    }
}

/// An end that the vertex coincides with counts alone: the other's gradient may not be finite. Squares of floats
/// neither vanish nor overflow in doubles.
TETRA_SIMD_CLONES void compute(VertexBlock& block, double isovalue)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < blockSize; ++i) {
        const double value = double(block.values[0][i]);
        const double between = (isovalue - value) / (double(block.values[1][i]) - value);
        const double fraction = between >= 0 && between <= 1 ? between : 0.5;
        unsigned notFirst = 0, notSecond = 0;
        double square = 0;
        double directions[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float from = block.positions[0][axis][i], to = block.positions[1][axis][i];
            const auto place = static_cast<float>(double(from) + fraction * (double(to) - double(from)));
            block.placed[axis][i] = place;
            notFirst |= place != from ? 1u : 0u;
            notSecond |= place != to ? 1u : 0u;
            const double first = double(block.gradients[0][axis][i]), second = double(block.gradients[1][axis][i]);
            const double mean = (1 - fraction) * first + fraction * second;
            directions[axis] = fraction <= 0 ? first : fraction >= 1 ? second : mean;
            square += directions[axis] * directions[axis];
        }
        const bool known = square > 0 && square < infinity;
        const double scale = -1 / std::sqrt(known ? square : 1.0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            block.normals[axis][i] = known ? static_cast<float>(directions[axis] * scale) : 0.0f;
        block.findings[i] = static_cast<std::uint8_t>((notFirst ^ 1u) | (notSecond ^ 1u) << 1 | (known ? 0u : 4u));
    }
}

void storeBlock(const VertexBlock& block, std::size_t first, std::size_t count, TriangleMesh& surface,
                PlacingFindings& found)
{
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t vertex = first + i;
        surface.positions[vertex] = {block.placed[0][i], block.placed[1][i], block.placed[2][i]};
        surface.normals[vertex] = {block.normals[0][i], block.normals[1][i], block.normals[2][i]};
        const unsigned findings = block.findings[i];
        if (findings == 0)
            continue;
        found.normalsMissing = found.normalsMissing || (findings & 4) != 0;
        if ((findings & 3) != 0)
            found.ties.push_back({block.ends[i][(findings & 1) != 0 ? 0 : 1], static_cast<std::uint32_t>(vertex)});
    }
}

} // namespace

PlacingFindings placeVertices(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                              std::span<const EdgeKey> edges, double isovalue, TriangleMesh& surface)
{
    surface.positions.resize(edges.size());
    surface.normals.resize(edges.size());
    tbb::enumerable_thread_specific<PlacingFindings> found;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 1 << 10), [&](const auto& range) {
        PlacingFindings& mine = found.local();
        VertexBlock block{};
        for (std::size_t first = range.begin(); first < range.end(); first += blockSize) {
            const std::size_t count = std::min(blockSize, range.end() - first);
            load(mesh, gradients, edges, isovalue, first, count, block);
            compute(block, isovalue);
            storeBlock(block, first, count, surface, mine);
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
