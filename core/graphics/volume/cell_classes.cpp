// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/cell_classes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetra {
namespace {

/// The segment of values from a vertex's upwards, and that of values downwards; they differ at a knot.
struct VertexClass {
    std::uint16_t up = CellClass::nothing;
    std::uint16_t down = CellClass::nothing;
};

/// For each segment, how many before it are not transparent.
std::vector<std::uint32_t> countVisible(std::span<const TransferSegment> segments)
{
    std::vector<std::uint32_t> before = {0};
    for (const TransferSegment& segment : segments)
        before.push_back(before.back() + (segment.transparent() ? 0 : 1));
    return before;
}

Buffer<VertexClass> classifyVertices(const TetrahedralMesh& mesh, std::span<const TransferSegment> segments)
{
    std::vector<double> knots;
    for (std::size_t i = 1; i < segments.size(); ++i)
        knots.push_back(segments[i].begin);
    Buffer<VertexClass> classes(mesh.values.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, classes.size(), 1 << 14), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            classes[v] = {};
            const double value = mesh.values[v];
            if (!std::isfinite(value) || !mesh.positions[v].allFinite())
                continue;
            classes[v].up = static_cast<std::uint16_t>(std::ranges::upper_bound(knots, value) - knots.begin());
            classes[v].down = static_cast<std::uint16_t>(std::ranges::lower_bound(knots, value) - knots.begin());
        }
    });
    return classes;
}

} // namespace

Buffer<CellClass> classifyCells(const TetrahedralMesh& mesh, std::span<const TransferSegment> segments)
{
    const std::vector<std::uint32_t> visibleBefore = countVisible(segments);
    const Buffer<VertexClass> vertices = classifyVertices(mesh, segments);
    Buffer<CellClass> classes(mesh.tetrahedra.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, classes.size(), 1 << 14), [&](const auto& range) {
        for (std::size_t cell = range.begin(); cell != range.end(); ++cell) {
            const auto& [a, b, c, d] = mesh.tetrahedra[cell];
            const VertexClass &va = vertices[a], &vb = vertices[b], &vc = vertices[c], &vd = vertices[d];
            classes[cell] = {};
            if (std::max({va.up, vb.up, vc.up, vd.up}) == CellClass::nothing)
                continue;
            const std::uint16_t first = std::min({va.up, vb.up, vc.up, vd.up});
            const std::uint16_t last = std::max({first, va.down, vb.down, vc.down, vd.down});
            if (visibleBefore[last + 1u] > visibleBefore[first])
                classes[cell] = {first, last};
        }
    });
    return classes;
}

} // namespace tetra
