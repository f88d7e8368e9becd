// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/tetrahedral_mesh.h"
#include "core/transfer/value_histogram.h"

namespace tetra {

/// How the values of a mesh share its volume, which does not depend on where its cells are small: the counts are parts
/// of 2^32 of the volume. In a cell all values between its smallest and its largest count alike. Cells that are not
/// finite and values outside of [least, largest] are not counted. No counts if the range is empty or not finite, or
/// there is no volume. O(cells + parts).
ValueHistogram volumeHistogram(const TetrahedralMesh& mesh, double least, double largest, int parts);

} // namespace tetra
