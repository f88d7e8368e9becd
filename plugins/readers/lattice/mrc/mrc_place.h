// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/mrc/mrc_header.h"
#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Puts the lattice of a map where its header says, in angstrom: the columns, rows and sections run along the axes of
/// the cell that MAPC, MAPR and MAPS name, the cell's a along x and its b in the plane of x and y, as crystallography
/// has it; the first sample lies at ORIGIN if that is not zero, else where NXSTART, NYSTART and NZSTART say. What was
/// taken and what was not is told in `volume`, and what the header does not tell.
void placeMrc(const MrcHeader& header, StoredVolume& volume);

} // namespace tetra
