// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_tile.h"
#include "core/render/volume/volume_view.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// The weights of a region along the rays of a tile, in plain numbers: a place along the ray through a sample, from the
/// region's centre, is start + w * direction, and both are affine in the sample's column and row in the tile.
struct FocusWeights {
    struct Affine {
        std::array<float, 3> origin, perColumn, perRow;
    };
    Affine start, direction;
    std::array<float, 3> halfSize{0, 0, 0}; ///< of a box
    float radius = 0;                       ///< of a ball
    float perBorder = 0;                    ///< 1 / border, very large if that is 0
};

/// The rays of a view through the regions of a focus. Places along a ray are w (VolumeView).
class FocusRays {
public:
    /// enter <= in <= out <= leave. Between `in` and `out` the weight of the fine volume is 1; just before `enter` and
    /// after `leave` it is 0, or another interval ends or begins there. A ray that stays out of a region but not out of
    /// its border has in == out.
    struct RayInterval {
        double enter, in, out, leave;
        bool meets() const noexcept { return enter < leave; } ///< else the ray stays out of both
    };

    FocusRays(std::span<const FocusRegion> regions, const VolumeView& view);

    /// The intervals of a ray, one behind the other, apart: of regions that lie in each other, or so near to each other
    /// that no place between them is without weight, as the ray meets them together.
    void intervalsAt(int column, int row, std::vector<RayInterval>& intervals) const;
    /// Of the fine volume, by each region. Columns and rows count from the given ones.
    std::vector<FocusWeights> weightsFrom(int column, int row) const;
    /// All of a cell has the weight 1, as it lies in one region.
    bool holds(const std::array<std::uint32_t, 4>& cell, std::span<const Eigen::Vector3d> positions) const;

private:
    struct Ray {
        Eigen::Vector3d start, direction; ///< from a region's centre; of w
    };
    struct PlacedRegion {
        bool isBall;
        double border;
        Eigen::Vector3d centre{0, 0, 0};
        Eigen::Vector3d halfSize{0, 0, 0}; ///< of a box
        double radius = 0;                 ///< of a ball
        Eigen::Vector3d origin{0, 0, 0};   ///< what has the image (0, 0, 0), from the centre
    };
    Ray rayOf(const PlacedRegion& region, int column, int row) const;
    RayInterval intervalOf(const PlacedRegion& region, int column, int row) const;
    FocusWeights weightsFrom(const PlacedRegion& region, int column, int row) const;
    /// Where the ray is in the region grown by `margin`, or in something somewhat larger; empty if last <= first.
    static std::pair<double, double> within(const PlacedRegion& region, const Ray& ray, double margin);

    std::vector<PlacedRegion> regions_;
    bool perspective_;
    double nearest_; ///< w
    double firstX_, firstY_;
    Eigen::Matrix3d worldFromImage_;
};

/// FocusRays::RayInterval of the rays of a block.
struct alignas(64) BlockInterval {
    Float8 enter, in, out, leave;
};

/// What a ray of a tile gathers on a short way through the border of a focus, as if it were a surface in the middle of
/// that way.
struct BorderFragment {
    std::uint32_t sample; ///< of the tile, row by row
    SurfaceFragment surface;
};

/// The blocks of a tile that a focus is drawn in.
struct BorderTile {
    std::span<const FocusWeights> weights; ///< of each region, from the tile's first sample
    SampleRectangle tile;
    std::span<const BlockInterval> intervals; ///< for each block
    std::span<const SampleBlock> blocks;
    int columns = 0;            ///< blocks a row
    const TileShading& shading; ///< of the volume that is drawn
};

/// Adds what `cells` show in the border, weighted as those of the fine volume or of the other, in no order: the ways
/// are no longer than a cell and a quarter of the border, so that cells of both volumes may be drawn one after the
/// other where they lie in the same place.
void collectBorder(std::span<const CellSetup> cells, bool fine, const BorderTile& tile,
                   std::vector<BorderFragment>& fragments);

} // namespace tetra
