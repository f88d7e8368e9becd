// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

namespace tetra {

/// A volume in two resolutions, blended at the border of the focus (R24, S18); without a focus in one. Its parameters
/// are "transfer", "shaded", "clip" and "outline" of plugins/api/scene_parameters.h, and those of
/// plugins/api/boundary_parameters.h, for the boundary of the mesh outside.
class FocusRenderer : public Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override;
    std::unique_ptr<RendererSession> open(std::shared_ptr<const TetrahedralMesh> mesh,
                                          const Eigen::AlignedBox3d& bounds) const override;
    bool blendsFocus() const override { return true; }
    std::unique_ptr<RendererSession> openWithFocus(std::shared_ptr<const TetrahedralMesh> mesh, FocusMesh focus,
                                                   const Eigen::AlignedBox3d& bounds) const override;
};

} // namespace tetra
