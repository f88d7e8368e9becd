// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/model/model.h"
#include "core/model/queries/mesh_query.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// The dataset's point that each vertex of an extracted mesh is, for verification: the point of its site, or the one
/// that the mesh names. Position and value must be the dataset's, rounded to float, and no two vertices the same point;
/// what is not so is a failure. Empty if a vertex is no point.
std::vector<std::uint32_t> pointsOfVertices(const Model& model, const Dataset& original, const ExtractedMesh& mesh,
                                            std::vector<std::string>& failures);

} // namespace tetra
