// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/cell_check.h"

#include <tan/base.h>
#include <tan/verify.h>

#include <span>

namespace tetra {

/// The error of a mesh of curvilinear data at each point's place in space (C12), weighted. `boundary`: all faces of one
/// cell only. Exact signs say which cells hold a place; cells without volume hold none. An Error only if cancelled. On
/// all threads; O(cells + points) times the depth of trees of their boxes.
Status measureErrorInSpace(const MeshToVerify& mesh, std::span<const BoundaryFace> boundary, ErrorInSpace& found,
                           const Progress& progress);

} // namespace tetra
