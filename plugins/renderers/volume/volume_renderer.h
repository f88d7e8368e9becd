// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

namespace tetra {

/// Direct volume rendering (R20). Its parameters are "transfer", "shaded", "clip" and "outline"
/// (plugins/api/scene_parameters.h), and the boundary's (plugins/api/boundary_parameters.h).
class VolumeRenderer : public Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override;
    std::unique_ptr<RendererSession> open(std::shared_ptr<const TetrahedralMesh> mesh,
                                          const Eigen::AlignedBox3d& bounds) const override;
};

} // namespace tetra
