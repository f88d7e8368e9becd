// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/decimate/test_meshes.h"
#include "tests/core/history/irregular/irregular_models.h"

namespace tetra {

/// Twelve points: a model of more takes seconds to verify once its bytes are garbage.
inline Dataset smallPart()
{
    TestMesh mesh = latticeMesh({3, 2, 2}, LatticeCut::Six, 4);
    return datasetOfTetrahedra(std::move(mesh.positions), mesh.values, std::move(mesh.tetrahedra));
}

} // namespace tetra
