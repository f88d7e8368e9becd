// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/bench_report.h"
#include "tests/bench/rendering_scenes.h"

#include <vector>

namespace tetra {

/// Isosurfaces at the middle of the range, merged points and normals both, of the mesh in spatial order by its index;
/// beside VTK's unless `vtk` is false. On one thread and on two.
std::vector<BenchCase> isosurfaceCases(const BenchMesh& mesh, int runs, bool vtk);

/// Spatial order, matching of faces and visibility order for one camera, in tetrahedra a second, on one thread and on
/// two.
std::vector<BenchCase> orderCases(const BenchMesh& mesh, int runs);

} // namespace tetra
