// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/cell_check.h"

#include <tan/base.h>
#include <tan/verify.h>

#include <span>

namespace tetra {

/// The error of a mesh of curvilinear data at each point's place in space (C12), weighted, into the verdict; of a level
/// of a model that claims to keep it what exceeds the claim is a failure, but for points outside all cells if a place
/// on the boundary within the claimed warping has a value that is near enough. `boundary`: all faces of one cell only.
/// Exact signs say which cells hold a place; cells without volume hold none. An Error only if cancelled. On all
/// threads; O(cells + points) times the depth of trees of their boxes.
Status verifyErrorInSpace(const MeshToVerify& mesh, std::span<const BoundaryFace> boundary, LevelReport& verdict,
                          const Progress& progress);

} // namespace tetra
