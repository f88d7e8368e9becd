// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/scene.h"
#include "core/graphics/volume/volume_mesh.h"
#include "core/mesh/ordered_mesh.h"

#include <memory>

namespace tetra {

/// Makes volumes of one mesh for a transfer function that changes: the mesh is put in spatial order and made ready
/// once, the function when it is another one. Used from one thread at a time.
class VolumeMaker {
public:
    explicit VolumeMaker(std::shared_ptr<OrderedMesh> mesh);
    explicit VolumeMaker(std::shared_ptr<const TetrahedralMesh> mesh);

    /// Errors: those of inSpatialOrder(), makeVolumeMesh() and makeVolumeTransfer(), cancelled.
    Result<Volume> update(const TransferFunction& function, bool shaded, const Progress& progress = {});

private:
    Status makeMesh(const Progress& progress);
    Status makeTransfer(const TransferFunction& function);

    std::shared_ptr<OrderedMesh> tetrahedra_;
    std::shared_ptr<const VolumeMesh> mesh_;
    TransferFunction function_; ///< that `transfer_` was made from
    std::shared_ptr<const VolumeTransfer> transfer_;
};

} // namespace tetra
