// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/focus/focus_renderer.h"

#include "plugins/api/boundary_parameters.h"
#include "plugins/renderers/focus/focus_session.h"

namespace tetra {

std::vector<Parameter> FocusRenderer::parameters(const FieldExtent& field) const
{
    return {transferParameter(field),   shadedParameter(), boundaryParameter(), boundaryOpacityParameter(),
            boundaryFarSideParameter(), clipParameter(),   outlineParameter()};
}

std::unique_ptr<RendererSession> FocusRenderer::open(std::shared_ptr<const TetrahedralMesh> mesh,
                                                     const Eigen::AlignedBox3d& bounds) const
{
    auto defaults = parameters(extentOf(*mesh, bounds));
    return std::make_unique<FocusSession>(std::move(mesh), std::nullopt, bounds, std::move(defaults));
}

std::unique_ptr<RendererSession> FocusRenderer::openWithFocus(std::shared_ptr<const TetrahedralMesh> mesh,
                                                              FocusMesh focus, const Eigen::AlignedBox3d& bounds) const
{
    auto defaults = parameters(extentOf(*mesh, bounds));
    return std::make_unique<FocusSession>(std::move(mesh), std::move(focus), bounds, std::move(defaults));
}

} // namespace tetra
