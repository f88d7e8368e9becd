// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/graphics/volume/cell_setup.h"

#include <span>

namespace tetra {

/// blockWidth x blockHeight samples of a picture, row by row.
struct alignas(64) SampleBlock {
    Float8 red, green, blue; ///< light that reached the eye so far
    Float8 light;            ///< what part of the light behind would reach it
    Float8 ray;              ///< length along the ray for one unit of w
    Float8 depth;            ///< w where `light` fell to a half; `noDepth` before
};

inline constexpr float noDepth = 1e30f;

/// Less light than this from behind is none: a sixteenth of an 8-bit step at most.
inline constexpr float darkness = 1.0f / 16384;

/// What all cells of a picture share.
struct TileShading {
    const ScaledSegment* segments = nullptr;
    float nearestBound = farBound; ///< of the near plane: 1 / w
    bool perspective = true;
    bool depth = false; ///< keep `depth` of the blocks
};

/// Draws cells front to back into the blocks of a tile, `columns` a row.
void drawCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns);

} // namespace tetra
