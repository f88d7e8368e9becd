// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd_fields.h"

#include <tan/base.h>
#include <tan/data.h>

namespace tetra {

/// Makes a lattice out of the fields that describe the axes: dimension, sizes, kinds, spacings, axis mins and maxs,
/// centers, space directions and space origin. Axes beyond three are accepted if they hold one point.
///
/// Space directions must be at right angles; their lengths are the spacing. The lattice stands along its own axes: a
/// turned volume has the origin turned with it, so that distances and volumes are those of the space. What is unknown
/// (NaN, in the format's way of saying) becomes spacing 1 and origin 0.
Result<Lattice> nrrdLattice(const NrrdFields& fields);

} // namespace tetra
