// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/volume_renderer.h"
#include "core/graphics/volume/volume_view.h"

#include <optional>
#include <span>

namespace tetra {

/// The visibility order of a mesh, used again while it fits the camera.
class MeshOrder {
public:
    /// Whether the order had to be made, as it does not fit: within `tolerance` degrees (PictureOptions), or exactly if
    /// that is 0. Errors: those of orderForCamera().
    Result<bool> fit(const VolumeMesh& mesh, const Camera& camera, const VolumeOptions& options, double tolerance,
                     const Progress& progress);

    /// Empty before fit().
    std::span<const std::uint32_t> cells() const noexcept { return order_.cells; }
    std::size_t brokenCycles() const noexcept { return order_.brokenCycles; }

private:
    bool fits(const VolumeMesh& mesh, const Camera& camera, const VolumeView& view, double tolerance) const;

    VisibilityOrder order_;
    Camera camera_;
    std::optional<VolumeView> view_; ///< that it was made for
};

} // namespace tetra
