// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/findings.h"
#include "plugins/readers/netcdf/helper/exodus_file.h"

namespace tetra {

/// What a block of elements is for TAn.
struct ExodusShape {
    CellShape shape = CellShape::Flat;
    std::uint64_t nodes = 0; ///< of each element, from the first, that are used
};

/// By its type's name and the number of nodes; nothing for elements of unknown shape.
std::optional<ExodusShape> shapeOf(const ExodusBlock& block);

/// Appends the block's cells, corners as numbers of nodes from 0, in VTK's order. Errors (BadInput): corners that are
/// not there, lists that are too short.
Status addBlock(const ExodusFile& exodus, const ExodusBlock& block, const ExodusShape& shape, FileFindings& found);

} // namespace tetra
