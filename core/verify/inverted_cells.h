// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/history/model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// How many tetrahedra are inverted in physical space in each of several meshes, those of the first `sites` sites (S5):
/// none but of curvilinear data. Exact; O(tetrahedra) for these, on all threads. Error: the file is inconsistent; of
/// indices that are merely wrong the count is.
Result<std::vector<std::uint64_t>> countInverted(const Model& model, std::span<const std::uint32_t> sites);

} // namespace tetra
