// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/facing.h"

#include "core/graphics/volume/cell_geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace tetra {
namespace {

/// `count` at least 8 cells.
TETRA_SIMD_CLONES void faceCells(const std::array<std::uint32_t, 4>* tetrahedra, std::size_t count,
                                 const ProjectedVertex* vertices, bool perspective, std::uint8_t* facing)
{
    for (std::size_t first = 0; first < count; first += 8) {
        const std::size_t start = std::min(first, count - 8); // the last eight may overlap those before
        const std::array<std::uint32_t, 4>* cells[8];
        for (std::size_t lane = 0; lane < 8; ++lane)
            cells[lane] = tetrahedra + start + lane;
        CellCorners corners;
        CellPlanes planes;
        loadCorners(vertices, cells, corners);
        makePlanes(corners, planes);
        Int8 bits = {};
        for (int face = 0; face < 4; ++face) {
            // The eye is at (0, 0, 0), or at w = minus infinity.
            const Float8 outside = perspective ? planes.offset[face] : planes.w[face];
            bits |= ((outside > 0.0f) & (1 << face)) | ((outside < 0.0f) & (16 << face));
        }
        for (std::size_t lane = 0; lane < 8; ++lane)
            facing[start + lane] = static_cast<std::uint8_t>(bits[lane]);
    }
}

} // namespace

Buffer<std::uint8_t> faceFacing(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                std::span<const ProjectedVertex> vertices, bool perspective)
{
    Buffer<std::uint8_t> facing(tetrahedra.size());
    if (tetrahedra.size() < 8) {
        std::array<std::array<std::uint32_t, 4>, 8> padded{};
        std::array<std::uint8_t, 8> bits{};
        std::ranges::copy(tetrahedra, padded.begin());
        if (!tetrahedra.empty())
            faceCells(padded.data(), padded.size(), vertices.data(), perspective, bits.data());
        std::copy_n(bits.begin(), facing.size(), facing.begin());
        return facing;
    }
    constexpr std::size_t grain = 1 << 12;
    const std::size_t parts = std::max<std::size_t>(tetrahedra.size() / grain, 1);
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        const std::size_t begin = part * grain;
        const std::size_t end = part + 1 == parts ? tetrahedra.size() : begin + grain;
        faceCells(&tetrahedra[begin], end - begin, vertices.data(), perspective, &facing[begin]);
    });
    return facing;
}

} // namespace tetra
