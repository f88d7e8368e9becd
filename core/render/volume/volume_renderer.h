// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/order/visibility_order.h"
#include "core/render/view_transform.h"
#include "core/render/volume/volume_mesh.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>
#include <tan/render.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>

namespace tetra {

/// Direct volume rendering of a tetrahedral mesh on the CPU (R20, R22): the volume-rendering integral of the
/// piecewise-linear field through a piecewise-linear transfer function, exact in each cell, along one ray a sample
/// (S15). A mesh, its transfer function and a visibility order are made once each and used while they fit:
///
///     const auto mesh = makeVolumeMesh(tetrahedra);
///     const auto transfer = makeVolumeTransfer(*tetrahedra, function);
///     const auto order = orderForCamera(*mesh, camera, options);
///     const auto picture = drawVolume(*mesh, *transfer, *order, camera, options);
///
/// While the camera hardly moves the order can be used again: orderDrift() says how little it moved.

struct VolumeOptions {
    int width = 512; ///< in samples, at most largestPictureSide
    int height = 512;
    int threads = 0;    ///< 0 or too many means all of the machine
    bool depth = false; ///< make `depth` too
};

/// A picture over nothing: rows from top to bottom.
struct VolumePicture {
    int width = 0;
    int height = 0;
    Buffer<std::array<float, 4>> samples; ///< red, green, blue times opacity, and opacity
    /// If wanted: the distance from the eye along the view's axis, in the units of the dataset, at which half of the
    /// light from behind is gone; infinity where it never is.
    Buffer<float> depth;
    std::size_t drawnCells = 0; ///< once for each tile of the picture that a cell was drawn in
};

/// The order in which the cells are to be drawn for a camera: orderByAdjacency(), with the gaps of a domain that is not
/// convex as they are in each sample of the picture. For a convex domain it depends on the place of the eye alone (in
/// orthographic views on the direction), for others on the whole camera and the picture's size. Errors: wrong options,
/// cancelled, not enough memory.
Result<VisibilityOrder> orderForCamera(const VolumeMesh& mesh, const Camera& camera, const VolumeOptions& options,
                                       const Progress& progress = {});

/// Draws the cells in `order`, whichever it is: front to back. A cell that is not finite, has no
/// volume or a value that is not finite is left out. O(cells + samples they cover), the same picture with any number of
/// threads. Errors: wrong options, an order or a transfer function of another mesh, cancelled, not enough memory.
Result<VolumePicture> drawVolume(const VolumeMesh& mesh, const VolumeTransfer& transfer, const VisibilityOrder& order,
                                 const Camera& camera, const VolumeOptions& options, const Progress& progress = {});

/// The visibility order of the last picture, kept for the next one of the same mesh (S14). Does not keep the mesh
/// alive. Used from one thread at a time.
class CachedOrder {
public:
    /// What an order is wanted for.
    struct Request {
        std::shared_ptr<const VolumeMesh> mesh;
        Camera camera;
        VolumeView whole; ///< of the whole picture
        SampleRectangle part;
        double tolerance = 0; ///< PictureOptions::orderTolerance
    };

    /// Makes an order, unless the last one fits: for the same mesh and a camera that is within the tolerance. Domains
    /// that are not convex have gaps that are different in each sample: there without tolerance it must have been made
    /// for the very same samples. On all threads of the current arena. Errors: cancelled. May throw std::bad_alloc.
    Status prepare(const Request& request, const Progress& progress);

    std::span<const std::uint32_t> cells() const noexcept { return order_.cells; }
    std::size_t brokenCycles() const noexcept { return order_.brokenCycles; }
    std::size_t cutCells() const noexcept { return order_.pieces.cutCells; }
    /// The volume, of the mesh that the order was made for, with the cells that cells() names: the pieces of cut ones
    /// come after its own. O(cells) where cells were cut. Not to be ordered again. May throw std::bad_alloc.
    Volume withPieces(const Volume& volume) const;
    /// Whether the last call found the order fitting.
    bool reused() const noexcept { return reused_; }

private:
    bool fits(const Request& request) const;

    std::weak_ptr<const VolumeMesh> mesh_;
    Camera camera_;
    Eigen::Vector2i pictureSize_{0, 0};
    SampleRectangle part_;
    VisibilityOrder order_;
    std::shared_ptr<const VolumeMesh> cut_; ///< the mesh with the pieces of cut cells; null if there are none
    bool reused_ = false;
};

} // namespace tetra
