// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/volume_tile.h"

#include "core/render/volume/block_queue.h"

namespace tetra {

std::size_t drawCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    if (shading.lit)
        return drawLitCells(cells, shading, blocks, columns);
    if (shading.extras)
        return drawCellsWithExtras(cells, shading, blocks, columns);
    if (shading.depth)
        return drawCellsWith<KernelFeatures::Depth>(cells, shading, blocks, columns);
    return drawCellsWith<KernelFeatures::None>(cells, shading, blocks, columns);
}

} // namespace tetra
