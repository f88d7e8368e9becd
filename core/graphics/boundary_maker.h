// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/scene.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/transfer/transfer_function.h"

#include <memory>

namespace tetra {

/// What the boundary of a mesh looks like.
struct BoundaryLook {
    Colour colour{0.60f, 0.64f, 0.70f}; ///< nearly grey, so that it is no value's colour, and seen on light and dark
    float opacity = 1;                  ///< in (0, 1]
    bool backFacesOnly = false;         ///< what faces the eye is left out, so that one sees into the domain
};

/// Makes the boundary of one mesh, in a look that changes: extracted once, coloured anew for another transfer function.
/// Used from one thread at a time.
class BoundaryMaker {
public:
    explicit BoundaryMaker(std::shared_ptr<const TetrahedralMesh> mesh) : mesh_(std::move(mesh)) {}

    /// Errors: those of extractBoundary(), an opacity outside (0, 1].
    Result<Surface> plain(const BoundaryLook& look, const Progress& progress = {});
    /// In the colours of the field's values (colouredByValue()). Errors: the same, and those of
    /// checkTransferFunction().
    Result<Surface> coloured(const TransferFunction& function, const BoundaryLook& look, const Progress& progress = {});

private:
    std::shared_ptr<const TetrahedralMesh> mesh_;
    std::shared_ptr<const TriangleMesh> boundary_;
    TransferFunction function_; ///< that `coloured_` has its colours from
    std::shared_ptr<const TriangleMesh> coloured_;
};

} // namespace tetra
