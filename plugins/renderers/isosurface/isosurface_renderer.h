// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

namespace tetra {

/// The parameters "isovalues" (std::vector<Isovalue>), by default the middle of `range`, and "outline" (bool).
std::vector<Parameter> isosurfaceParameters(const ValueRange& range);

/// Isosurfaces by marching tetrahedra, several at once (R19), and the domain's outline.
class IsosurfaceRenderer : public Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return isosurfaceParameters(field.range);
    }
    std::unique_ptr<RendererSession> open(std::shared_ptr<const TetrahedralMesh> mesh,
                                          const Eigen::AlignedBox3d& bounds) const override;
};

} // namespace tetra
