// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/isosurface/isosurface_renderer.h"

#include "plugins/api/boundary_parameters.h"
#include "plugins/renderers/isosurface/isosurface_session.h"

namespace tetra {

std::vector<Parameter> IsosurfaceRenderer::parameters(const FieldExtent& field) const
{
    return {
        isovaluesParameter(field),        boundaryParameter(), boundaryOpacityParameter(), boundaryFarSideParameter(),
        boundaryTransferParameter(field), clipParameter(),     outlineParameter()};
}

std::unique_ptr<RendererSession> IsosurfaceRenderer::open(std::shared_ptr<const TetrahedralMesh> mesh,
                                                          const Eigen::AlignedBox3d& bounds) const
{
    auto defaults = parameters(extentOf(*mesh, bounds));
    return std::make_unique<IsosurfaceSession>(std::move(mesh), bounds, std::move(defaults));
}

} // namespace tetra
