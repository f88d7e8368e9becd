// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/render/tiles.h"
#include "core/render/volume/cell_setup.h"

#include <span>

namespace tetra {

/// blockWidth x blockHeight samples of a picture, row by row.
struct alignas(64) SampleBlock {
    Float8 red, green, blue; ///< light that reached the eye so far
    Float8 transmittance;    ///< what part of the light behind would reach it
    Float8 ray;              ///< length along the ray for one unit of w
    Float8 depth;            ///< w where `transmittance` fell to a half; `noDepth` before
};

inline constexpr float noDepth = 1e30f;

/// Less light than this from behind is none: a sixteenth of an 8-bit step at most.
inline constexpr float opaqueThreshold = 1.0f / 16384;

/// What surfaces and clip planes do to the rays of a block; q as in CellSetup.
struct alignas(64) BlockLimits {
    Float8 front, back;     ///< the rays are drawn between them only
    Float8 next;            ///< of the next surface that a ray meets, -farBound if none
    std::uint32_t place[8]; ///< of that surface in TileShading::fragments
};

struct TileModel;

/// What all cells of a picture share.
struct TileShading {
    const ScaledSegment* segments = nullptr;
    float nearestBound = farBound; ///< of the near plane: 1 / w
    bool perspective = true;
    bool depth = false;               ///< keep `depth` of the blocks
    bool lit = false;                 ///< cells have CellSetup::light
    float perFullGradient = 0;        ///< of SetupSource, of cells that are lit
    bool extras = false;              ///< there may be limits: one for each block. The near plane is in them
    float firstX = 0, firstY = 0;     ///< the tile's first sample, from the centre of the picture
    float slopePerSample[2] = {0, 0}; ///< right and down for one unit of w, from sample to sample; 0 if orthographic
    BlockLimits* limits = nullptr;
    const SurfaceFragment* fragments = nullptr; ///< SurfaceFragments; with limits
    bool splitCells = true;           ///< surfaces are drawn where they are, else before the cell that they are in
    const TileModel* model = nullptr; ///< if any: drawCellsByModel()
};

/// Draws cells front to back into the blocks of a tile, `columns` a row. Returns how often a block was drawn into.
std::size_t drawCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns);

/// Draws the surfaces behind all cells, of one ray of a block.
void drawSurfacesBehind(const TileShading& shading, std::size_t lane, SampleBlock& block, BlockLimits& limits);

} // namespace tetra
