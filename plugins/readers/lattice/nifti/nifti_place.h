// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nifti/nifti_header.h"
#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Puts the lattice of a NIfTI file where its header says: by the sform if its code is not 0, else by the qform, else
/// along its own axes with the distances of pixdim alone; in coordinates to the right, to the front and to the head.
/// What was taken and what was not is told in `volume`, and what the header does not tell.
void placeNifti(const NiftiHeader& header, StoredVolume& volume);

} // namespace tetra
