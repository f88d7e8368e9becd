// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/tetrahedral_mesh.h"

#include <optional>

namespace tetra {

/// A value within [least, largest] whose isosurface shows where the data have a surface: as the skin of a head or the
/// walls of a casting, rather than noise or scraps. Of all isosurfaces it is the one for which a product of two
/// functions of the contour spectrum is largest: the total gradient on it, which grows with its size, and a power
/// of the mean gradient, which tells a boundary between two materials from noise within one. (C. Bajaj, V. Pascucci, D.
/// Schikore: The contour spectrum, IEEE Visualization 1997.) Nothing where no value differs. The same for the same mesh
/// on every machine and any number of threads, but for rounding. O(cells).
std::optional<double> surfaceValue(const TetrahedralMesh& mesh, double least, double largest);

} // namespace tetra
