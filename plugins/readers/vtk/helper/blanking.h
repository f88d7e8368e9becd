// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>

#include <cstdint>
#include <vector>

namespace tetra {

/// One number a cell, not 0 for those that are no part of the domain: hidden ones, ones at hidden points, and copies of
/// cells of another piece. Empty if there are none.
std::vector<std::uint8_t> blankedCells(vtkDataSet& data);

} // namespace tetra
