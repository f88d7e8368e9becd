// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd_fields.h"
#include "plugins/readers/lattice/sample_layout.h"

#include <tan/base.h>

#include <string>

namespace tetra {

/// What a NRRD header means.
struct NrrdLayout {
    SampleLayout samples;
    std::string dataFile; ///< of a detached header, relative to the header's folder; empty: the data follow the header
};

/// Errors: what is missing, contradicts itself, or is not read (several data files, 64-bit integers, blocks,
/// encodings).
Result<NrrdLayout> nrrdLayout(const NrrdFields& fields);

} // namespace tetra
