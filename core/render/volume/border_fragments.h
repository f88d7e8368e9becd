// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_tile.h"
#include "core/render/volume/volume_view.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// The weights of a focus along the rays of a tile, in plain numbers: a place along the ray through a sample, from the
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

/// The rays of a view through a focus (FocusVolume). Places along a ray are w (VolumeView).
class FocusRays {
public:
    /// enter <= in <= out <= leave. Between `in` and `out` the weight of the fine volume is 1; before `enter` and
    /// after `leave` it is 0. A ray that stays out of the region but not out of its border has in == out.
    struct RayInterval {
        double enter, in, out, leave;
        bool meets() const noexcept { return enter < leave; } ///< else the ray stays out of both
    };

    FocusRays(const FocusVolume& focus, const VolumeView& view);

    RayInterval at(int column, int row) const;
    /// Of the fine volume. Columns and rows count from the given ones.
    FocusWeights weightsFrom(int column, int row) const;
    /// A place in the units of the dataset lies in the region.
    bool holds(const Eigen::Vector3f& place) const;

private:
    struct Ray {
        Eigen::Vector3d start, direction; ///< from the region's centre; of w
    };
    Ray rayOf(int column, int row) const;
    /// Where the ray is in the region grown by `margin`, or in something somewhat larger; empty if last <= first.
    std::pair<double, double> within(const Ray& ray, double margin) const;

    std::variant<Box, Sphere> region_;
    double border_;
    bool perspective_;
    double nearest_; ///< w
    double firstX_, firstY_;
    Eigen::Vector3d centre_;
    Eigen::Vector3d halfSize_{0, 0, 0}; ///< of a box
    double radius_ = 0;                 ///< of a ball
    Eigen::Vector3d origin_;            ///< what has the image (0, 0, 0), from the centre
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
    FocusWeights weights; ///< from the tile's first sample
    SampleRectangle tile;
    std::span<const BlockInterval> intervals; ///< for each block
    std::span<const SampleBlock> blocks;
    int columns = 0; ///< blocks a row
    const ScaledSegment* segments = nullptr;
    bool perspective = true;
};

/// Adds what `cells` show in the border, weighted as those of the fine volume or of the other, in no order: the ways
/// are no longer than a cell and a quarter of the border, so that cells of both volumes may be drawn one after the
/// other where they lie in the same place.
void collectBorder(std::span<const CellSetup> cells, bool fine, const BorderTile& tile,
                   std::vector<BorderFragment>& fragments);

} // namespace tetra
