// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/model/queries/error_field.h"

#include <cstdint>

namespace tetra {

/// Cuts a mesh off at a box, whose faces are rounded to floats as vertices are: so the new vertices lie in them
/// exactly. One plane after the other; what is cut are the edges from one side of a plane to the other. Tetrahedra that
/// lie in the box stay first and in order; those that are cut follow. Gives how many of the mesh's tetrahedra there is
/// something left of. Errors: cancelled, out of resource. May throw std::bad_alloc.
Result<std::uint64_t> cutAtWindow(TetrahedralMesh& mesh, const Box& box, const Progress& progress);

} // namespace tetra
