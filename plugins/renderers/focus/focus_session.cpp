// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/focus/focus_session.h"

#include "plugins/api/boundary_parameters.h"

namespace tetra {

FocusSession::FocusSession(std::shared_ptr<const TetrahedralMesh> mesh, std::optional<FocusMesh> focus,
                           const Eigen::AlignedBox3d& bounds, std::vector<Parameter> defaults)
    : bounds_(bounds), defaults_(std::move(defaults)), boundary_(mesh), volume_(std::move(mesh)),
      focus_(std::move(focus))
{
    if (focus_)
        fine_.emplace(focus_->mesh);
}

Result<std::shared_ptr<const Scene>> FocusSession::prepare(const ParameterValues& values, const Camera&,
                                                           const Progress& progress)
{
    auto scene = startScene(defaults_, values, bounds_);
    if (!scene)
        return scene.error();
    const auto function = parameterValue<TransferFunction>(defaults_, values, transferId);
    const bool shaded = parameterValue<bool>(defaults_, values, shadedId);
    auto volume = volume_.update(function, shaded, progress.part(0, 0.4));
    if (!volume)
        return volume.error();
    scene->volume = *std::move(volume);
    if (focus_) {
        auto fine = fine_->update(function, shaded, progress.part(0.4, 0.8));
        if (!fine)
            return fine.error();
        scene->focus = FocusVolume{*std::move(fine), focus_->region, focus_->border};
    }
    if (const Status added = addBoundary(boundary_, defaults_, values, progress.part(0.8, 1), *scene); !added)
        return added.error();
    return std::make_shared<const Scene>(*std::move(scene));
}

} // namespace tetra
