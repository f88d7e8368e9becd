// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <tan/render.h>

#include <optional>

namespace tetra {

/// Keeps what VolumeCache keeps of both meshes, and the boundary of the one outside.
class FocusSession : public RendererSession {
public:
    /// `defaults` are the parameters for this mesh.
    FocusSession(std::shared_ptr<const TetrahedralMesh> mesh, std::optional<FocusMesh> focus,
                 const Eigen::AlignedBox3d& bounds, std::vector<Parameter> defaults);

    /// The camera does not matter: the back end puts the cells in order.
    Result<std::shared_ptr<const Scene>> prepare(const ParameterValues& values, const Camera& camera,
                                                 const Progress& progress) override;

private:
    Eigen::AlignedBox3d bounds_;
    std::vector<Parameter> defaults_;
    BoundaryCache boundary_;
    VolumeCache volume_;
    std::optional<FocusMesh> focus_;
    std::optional<VolumeCache> fine_; ///< of the focus
};

} // namespace tetra
