// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/model/extraction.h"
#include "core/model/model.h"

#include <cstdint>

namespace tetra {

/// The most accurate mesh that a uniform query can give, no finer than asked, before the first one that has more than
/// `budget` tetrahedra. Reads what the file says of its meshes' sizes, as far as that goes. Error: WrongUsage if even
/// the coarsest mesh has more.
Result<MeshSize> meshSizeWithin(const Model& model, const Accuracy& asked, std::uint64_t budget);

} // namespace tetra
