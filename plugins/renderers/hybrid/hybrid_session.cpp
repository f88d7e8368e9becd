// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/hybrid/hybrid_session.h"

#include "plugins/api/boundary_parameters.h"
#include "plugins/renderers/hybrid/hybrid_renderer.h"

namespace tetra {

HybridSession::HybridSession(std::shared_ptr<const TetrahedralMesh> mesh, const Eigen::AlignedBox3d& bounds,
                             std::vector<Parameter> defaults)
    : HybridSession(std::make_shared<OrderedMesh>(std::move(mesh)), bounds, std::move(defaults))
{
}

HybridSession::HybridSession(const std::shared_ptr<OrderedMesh>& mesh, const Eigen::AlignedBox3d& bounds,
                             std::vector<Parameter> defaults)
    : bounds_(bounds), defaults_(std::move(defaults)), boundary_(mesh->original()), surfaces_(mesh), volume_(mesh)
{
}

Result<std::shared_ptr<const Scene>> HybridSession::prepare(const ParameterValues& values, const Camera&,
                                                            const Progress& progress)
{
    auto scene = startScene(defaults_, values, bounds_);
    if (!scene)
        return scene.error();
    const auto order = hybridOrderOf(parameterValue<std::string>(defaults_, values, orderId));
    if (!order)
        return order.error();
    scene->hybridOrder = *order;
    // First what puts the mesh in spatial order: surfaces are quicker then.
    auto volume = volume_.update(parameterValue<TransferFunction>(defaults_, values, transferId),
                                 parameterValue<bool>(defaults_, values, shadedId), progress.part(0, 0.4));
    if (!volume)
        return volume.error();
    scene->volume = *std::move(volume);
    auto surfaces = surfaces_.update(parameterValue<std::vector<Isovalue>>(defaults_, values, isovaluesId),
                                     progress.part(0.4, 0.8));
    if (!surfaces)
        return surfaces.error();
    scene->surfaces = *std::move(surfaces);
    if (const Status added = addBoundary(boundary_, defaults_, values, progress.part(0.8, 1), *scene); !added)
        return added.error();
    return std::make_shared<const Scene>(*std::move(scene));
}

} // namespace tetra
