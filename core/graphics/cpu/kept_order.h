// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/camera.h"
#include "core/graphics/sample_rectangle.h"
#include "core/graphics/volume/visibility_order.h"
#include "core/graphics/volume/volume_mesh.h"
#include "core/graphics/volume/volume_view.h"

#include <memory>
#include <span>

namespace tetra {

/// The visibility order of the last picture, kept for the next one of the same mesh (S14). Does not keep the mesh
/// alive. Used from one thread at a time.
class KeptOrder {
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
    /// Whether the last call found the order fitting.
    bool reused() const noexcept { return reused_; }

private:
    bool fits(const Request& request) const;

    std::weak_ptr<const VolumeMesh> mesh_;
    Camera camera_;
    Eigen::Vector2i pictureSize_{0, 0};
    SampleRectangle part_;
    VisibilityOrder order_;
    bool reused_ = false;
};

} // namespace tetra
