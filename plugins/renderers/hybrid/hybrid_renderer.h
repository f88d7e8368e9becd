// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

namespace tetra {

inline constexpr const char* orderId = "order";

/// Isosurfaces in a volume (R21). Its parameters are "transfer", "isovalues", "shaded", "order", "clip" and "outline";
/// all but "order" are those of plugins/api/scene_parameters.h; and the boundary's
/// (plugins/api/boundary_parameters.h).
class HybridRenderer : public Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override;
    std::unique_ptr<RendererSession> open(std::shared_ptr<const TetrahedralMesh> mesh,
                                          const Eigen::AlignedBox3d& bounds) const override;
};

/// What a value of "order" means. Errors (WrongUsage): a text that is none of the choices.
Result<HybridOrder> hybridOrderOf(const std::string& text);

} // namespace tetra
