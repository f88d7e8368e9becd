// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/isosurface/isosurface_session.h"

#include "plugins/api/boundary_parameters.h"

namespace tetra {

IsosurfaceSession::IsosurfaceSession(std::shared_ptr<const TetrahedralMesh> mesh, const Eigen::AlignedBox3d& bounds,
                                     std::vector<Parameter> defaults)
    : bounds_(bounds), defaults_(std::move(defaults)), boundary_(mesh), surfaces_(std::move(mesh))
{
}

Result<std::shared_ptr<const Scene>> IsosurfaceSession::prepare(const ParameterValues& values, const Camera&,
                                                                const Progress& progress)
{
    auto scene = startScene(defaults_, values, bounds_);
    if (!scene)
        return scene.error();
    auto surfaces =
        surfaces_.update(parameterValue<std::vector<Isovalue>>(defaults_, values, isovaluesId), progress.part(0, 0.8));
    if (!surfaces)
        return surfaces.error();
    scene->surfaces = *std::move(surfaces);
    if (const Status added = addBoundary(boundary_, defaults_, values, progress.part(0.8, 1), *scene); !added)
        return added.error();
    return std::make_shared<const Scene>(*std::move(scene));
}

} // namespace tetra
