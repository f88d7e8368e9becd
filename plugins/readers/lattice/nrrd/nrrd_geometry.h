// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd/nrrd_fields.h"

#include <tan/base.h>
#include <tan/data.h>

#include <string>
#include <vector>

namespace tetra {

/// Makes a lattice out of the fields that describe the axes: dimension, sizes, kinds, spacings, axis mins and maxs,
/// centers, space directions and space origin. Its axes are those that hold points (nrrdRoles()).
///
/// Space directions are the steps of its frame, whichever way they run, if they do not lie in a plane. What is unknown
/// (NaN, in the format's way of saying) becomes spacing 1 and origin 0.
Result<Lattice> nrrdLattice(const NrrdFields& fields);

/// Whether the header says the spacing of the axes, and where the first point lies: what it does not say are 1 and 0.
bool tellsNrrdSpacing(const NrrdFields& fields);
bool tellsNrrdOrigin(const NrrdFields& fields);

/// StoredVolume::stepsToOrigin.
Eigen::Vector3d nrrdStepsToOrigin(const NrrdFields& fields);

/// What the header says that a picture or a file of a mesh does not show: a left-handed space, units that differ from
/// axis to axis.
std::vector<Message> nrrdPlaceRemarks(const NrrdFields& fields);

/// Dataset::space, if the header says how the axes lie in it.
std::string nrrdSpace(const NrrdFields& fields);

/// Dataset::lengthUnit: that of the space, else of the axes, if it is the same for all that hold points.
std::string nrrdLengthUnit(const NrrdFields& fields);

} // namespace tetra
