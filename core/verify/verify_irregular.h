// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/cell_check.h"

#include <span>

namespace tetra {

/// The rest of verifyCells() of irregular data: cells that conform and have volume lie on one another nowhere; their
/// boundary, `faces`, is a manifold that does not meet itself, with the original's components, surfaces and Euler
/// characteristics (S12); the original vertices that lie in no cell keep the error that is claimed, too, and those of
/// the original's boundary the warping (R4, R5, FORMAT.md). `inside` is what the check of all cells found. Says how far
/// the boundary goes from the original's (S13), which is judged only if the model's parameter `distance` claims it.
Status verifyIrregular(const MeshToVerify& mesh, CellFindings& inside, std::span<const BoundaryFace> faces,
                       LevelReport& verdict, const Progress& progress);

} // namespace tetra
