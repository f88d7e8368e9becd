// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/block_queue.h"

namespace tetra {

std::size_t drawLitCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    return drawCellsWith<KernelFeatures::Lit>(cells, shading, blocks, columns);
}

} // namespace tetra
