// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <tan/render.h>

namespace tetra {

/// Keeps what VolumeCache and BoundaryCache keep: another transfer function leaves the mesh as it is, another shading
/// or clip plane both.
class VolumeSession : public RendererSession {
public:
    /// `defaults` are the parameters for this mesh.
    VolumeSession(std::shared_ptr<const TetrahedralMesh> mesh, const Eigen::AlignedBox3d& bounds,
                  std::vector<Parameter> defaults);

    /// The camera does not matter: the back end puts the cells in order.
    Result<std::shared_ptr<const Scene>> prepare(const ParameterValues& values, const Camera& camera,
                                                 const Progress& progress) override;

private:
    Eigen::AlignedBox3d bounds_;
    std::vector<Parameter> defaults_;
    BoundaryCache boundary_;
    VolumeCache volume_;
};

} // namespace tetra
