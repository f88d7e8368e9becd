// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_maker.h"

namespace tetra {
namespace {

constexpr std::string_view preparingVolume = "Preparing the volume";

} // namespace

VolumeMaker::VolumeMaker(std::shared_ptr<OrderedMesh> mesh) : tetrahedra_(std::move(mesh)) {}

VolumeMaker::VolumeMaker(std::shared_ptr<const TetrahedralMesh> mesh)
    : tetrahedra_(std::make_shared<OrderedMesh>(std::move(mesh)))
{
}

Status VolumeMaker::makeMesh(const Progress& progress)
{
    if (mesh_)
        return {};
    auto ordered = tetrahedra_->ordered(progress);
    if (!ordered)
        return ordered.error();
    auto made = makeVolumeMesh(*std::move(ordered));
    if (!made)
        return made.error();
    mesh_ = std::make_shared<const VolumeMesh>(*std::move(made));
    return {};
}

Status VolumeMaker::makeTransfer(const TransferFunction& function)
{
    if (transfer_ && function_ == function)
        return {};
    auto made = makeVolumeTransfer(*mesh_->mesh, function);
    if (!made)
        return made.error();
    transfer_ = std::make_shared<const VolumeTransfer>(*std::move(made));
    function_ = function;
    return {};
}

Result<Volume> VolumeMaker::update(const TransferFunction& function, bool shaded, const Progress& progress)
{
    progress.report(0, preparingVolume);
    if (progress.cancelled())
        return cancelledError(preparingVolume);
    if (const Status made = makeMesh(progress.part(0, 0.4)); !made)
        return made.error();
    progress.report(0.8, preparingVolume);
    if (progress.cancelled())
        return cancelledError(preparingVolume);
    if (const Status made = makeTransfer(function); !made)
        return made.error();
    progress.report(1, preparingVolume);
    return Volume{mesh_, transfer_, shaded};
}

} // namespace tetra
