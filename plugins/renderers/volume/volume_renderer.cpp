// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/volume/volume_renderer.h"

#include "plugins/api/boundary_parameters.h"
#include "plugins/renderers/volume/volume_session.h"

namespace tetra {

std::vector<Parameter> VolumeRenderer::parameters(const FieldExtent& field) const
{
    return {transferParameter(field),   shadedParameter(), boundaryParameter(), boundaryOpacityParameter(),
            boundaryFarSideParameter(), clipParameter(),   outlineParameter()};
}

std::unique_ptr<RendererSession> VolumeRenderer::open(std::shared_ptr<const TetrahedralMesh> mesh,
                                                      const Eigen::AlignedBox3d& bounds) const
{
    auto defaults = parameters(extentOf(*mesh, bounds));
    return std::make_unique<VolumeSession>(std::move(mesh), bounds, std::move(defaults));
}

} // namespace tetra
