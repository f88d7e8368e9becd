// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/block_queue.h"

namespace tetra {

std::size_t drawCellsWithExtras(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                                int columns)
{
    return drawCellsWith<KernelFeatures::All>(cells, shading, blocks, columns);
}

void drawSurfacesBehind(const TileShading& shading, std::size_t lane, SampleBlock& block, BlockLimits& limits)
{
    while (limits.next[lane] > -farBound && block.transmittance[lane] > opaqueThreshold)
        drawSurface(shading.fragments, shading.perspective, lane, block, limits);
}

} // namespace tetra
