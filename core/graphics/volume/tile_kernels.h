// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/block_queue.h"

namespace tetra {

/// Each kernel is a function of its own for each instruction set: compilers take long over large ones.
template <bool perspective, Extras extras>
std::size_t drawByFours(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    return drawCellsBy<perspective, extras, 4>(cells, shading, blocks, columns);
}

#if defined(TETRA_SIMD_16)
template <bool perspective, Extras extras> TETRA_SIMD_8 std::size_t
drawByEights(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    return drawCellsBy<perspective, extras, 8>(cells, shading, blocks, columns);
}
template <bool perspective, Extras extras> TETRA_SIMD_16 std::size_t
drawBySixteens(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    return drawCellsBy<perspective, extras, 16>(cells, shading, blocks, columns);
}
#endif

/// By as many rays at a time as the machine can do.
template <bool perspective, Extras extras> std::size_t
drawOnThisMachine(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
#if defined(TETRA_SIMD_16)
    if (hasSimd16())
        return drawBySixteens<perspective, extras>(cells, shading, blocks, columns);
    if (hasSimd8())
        return drawByEights<perspective, extras>(cells, shading, blocks, columns);
#endif
    return drawByFours<perspective, extras>(cells, shading, blocks, columns);
}

template <Extras extras> std::size_t drawCellsWith(std::span<const CellSetup> cells, const TileShading& shading,
                                                   SampleBlock* blocks, int columns)
{
    return shading.perspective ? drawOnThisMachine<true, extras>(cells, shading, blocks, columns)
                               : drawOnThisMachine<false, extras>(cells, shading, blocks, columns);
}

/// In a source of its own, as it takes long to compile.
std::size_t drawCellsWithExtras(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                                int columns);

} // namespace tetra
