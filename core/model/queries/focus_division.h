// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/block_division.h"
#include "core/model/model.h"

#include <optional>

namespace tetra {

/// The blocks in which a model was built, each a Delaunay mesh of its box: they follow from the initial sites, the
/// corners of all blocks. None if points cannot be inserted into such a model's meshes: it is no regular lattice, not
/// Delaunay, too large for exact arithmetic, weighted, or its initial sites are others.
std::optional<BlockDivision> focusDivision(const Model& model);

} // namespace tetra
