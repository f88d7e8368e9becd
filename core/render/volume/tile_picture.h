// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/tiles.h"
#include "core/render/volume/border_fragments.h"
#include "core/render/volume/cell_setup.h"
#include "core/render/volume/clip_bounds.h"
#include "core/render/volume/model_tile.h"
#include "core/render/volume/projected_vertices.h"
#include "core/render/volume/volume_tile.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>

#include <functional>
#include <span>
#include <vector>

namespace tetra {

/// Samples a side of a tile, at most: its blocks, 48 bytes a sample, fit the second-level cache many times, and few
/// cells lie in more than one tile.
inline constexpr int volumeTileSide = 64;

/// The fine volume of a focus in a tile.
struct FocusTile {
    const FocusRays* rays = nullptr;
    const SetupSource* source = nullptr; ///< with the other volume's segments
    std::span<const BinnedCell> cells;   ///< front to back
    /// Where the vertices of both volumes are, to tell the cells that lie in the region as a whole.
    std::span<const Eigen::Vector3d> positions, finePositions;
};

/// What is drawn in a tile along with cells. The bounds and the surfaces are of the same view.
struct TileSurroundings {
    const ClipBounds* clips = nullptr;          ///< if any
    const SurfaceFragments* surfaces = nullptr; ///< if any
    bool splitCells = true;                     ///< !Volume::wholeCells
    bool depth = false;                         ///< wanted
    const FocusTile* focus = nullptr;           ///< if any
    const TileModel* model = nullptr;           ///< if any; without a focus
};

/// A tile that was drawn, row by row.
struct DrawnTile {
    std::span<const PremultipliedColour> colours; ///< over nothing
    std::span<const float> depth;                 ///< of VolumePicture, if wanted
    std::size_t cells = 0;                        ///< drawn before all was opaque
    std::size_t fragments = 0;                    ///< samples times cells, as far as they were looked at
};

/// Draws into the blocks of a tile, so many a row and so many rows.
using BlockDrawing = std::function<void(const TileShading& shading, SampleBlock* blocks, int columns, int rows)>;

/// Draws tile after tile, in memory of its own; one object a thread.
class VolumeTilePainter {
public:
    VolumeTilePainter(const SetupSource& source, const VolumeView& view);

    /// `cells` front to back. The result is valid until the next call; incomplete if cancelled. May throw
    /// std::bad_alloc.
    DrawnTile paint(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                    const TileSurroundings& surroundings, const Progress& progress);

    /// The same of blocks that `draw` fills, front to back, with the segments of the source. Without a focus and a
    /// model.
    DrawnTile paintBlocks(const SampleRectangle& tile, const TileSurroundings& surroundings, const BlockDrawing& draw);

private:
    void clear(const SampleRectangle& tile);
    void setLimits(const SampleRectangle& tile, const TileSurroundings& surroundings);
    void draw(const SetupSource& source, std::span<const BinnedCell> cells, const SampleRectangle& tile,
              const TileShading& shading, const Progress& progress, DrawnTile& drawn);
    bool setIntervals(const SampleRectangle& tile, const FocusRays& rays);
    void collectBorderOf(const SampleRectangle& tile, std::span<const BinnedCell> cells, const FocusTile& focus,
                         bool fine, const Progress& progress);
    void putBorderAmong(const SampleRectangle& tile, const SurfaceFragments* surfaces);
    void drawWithFocus(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                       const TileSurroundings& surroundings, const Progress& progress, DrawnTile& drawn);
    void drawTotals(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                    const TileSurroundings& surroundings, const Progress& progress, DrawnTile& drawn);
    void endAtOpaque(const SurfaceFragments& surfaces);
    void takeTotals(const TileShading& shading);
    TileShading shadingOf(const SampleRectangle& tile, const TileSurroundings& surroundings);
    TileFrame frameOf(const SampleRectangle& tile) const;
    bool allOpaque();
    void finish(const SampleRectangle& tile, const TileShading& shading);

    SetupSource source_;
    const VolumeView& view_;
    std::vector<SampleBlock> blocks_;
    std::vector<BlockLimits> limits_; ///< of the blocks, if there were any
    std::vector<CellSetup> setups_;
    std::vector<CellLight> lights_;
    std::size_t firstLit_ = 0;                          ///< all blocks before it are opaque
    std::vector<BlockTotal> totals_;                    ///< of the blocks, if there is a model
    std::vector<std::vector<BlockInterval>> intervals_; ///< of the blocks, if the tile meets a focus: FocusRays'
    std::vector<BorderFragment> border_;                ///< of the tile
    SurfaceFragments amongBorder_;                      ///< surfaces, and the border's fragments
    std::vector<PremultipliedColour> colours_;
    std::vector<float> depth_;
};

} // namespace tetra
