// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/spatial_order.h"

#include <memory>

namespace tetra {

/// A mesh and, from when it is first asked for, the same mesh in spatial order. Share it between all that use the mesh.
/// Used from one thread at a time.
class OrderedMesh {
public:
    explicit OrderedMesh(std::shared_ptr<const TetrahedralMesh> mesh) : original_(std::move(mesh)) {}

    const std::shared_ptr<const TetrahedralMesh>& original() const noexcept { return original_; }
    bool isOrdered() const noexcept { return ordered_ != nullptr; }
    /// Errors: those of inSpatialOrder().
    Result<std::shared_ptr<const TetrahedralMesh>> ordered(const Progress& progress = {});

private:
    std::shared_ptr<const TetrahedralMesh> original_;
    std::shared_ptr<const TetrahedralMesh> ordered_;
};

} // namespace tetra
