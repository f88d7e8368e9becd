// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/volume/volume_session.h"

#include "plugins/api/boundary_parameters.h"

namespace tetra {

VolumeSession::VolumeSession(std::shared_ptr<const TetrahedralMesh> mesh, const Eigen::AlignedBox3d& bounds,
                             std::vector<Parameter> defaults)
    : bounds_(bounds), defaults_(std::move(defaults)), boundary_(mesh), volume_(std::move(mesh))
{
}

Result<std::shared_ptr<const Scene>> VolumeSession::prepare(const ParameterValues& values, const Camera&,
                                                            const Progress& progress)
{
    auto scene = startScene(defaults_, values, bounds_);
    if (!scene)
        return scene.error();
    auto volume = volume_.update(parameterValue<TransferFunction>(defaults_, values, transferId),
                                 parameterValue<bool>(defaults_, values, shadedId), progress.part(0, 0.8));
    if (!volume)
        return volume.error();
    scene->volume = *std::move(volume);
    if (const Status added = addBoundary(boundary_, defaults_, values, progress.part(0.8, 1), *scene); !added)
        return added.error();
    return std::make_shared<const Scene>(*std::move(scene));
}

} // namespace tetra
