// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/vtk/helper/cgns_headers.h"
#include "plugins/readers/vtk/helper/provenance.h"

namespace tetra {

/// What the headers of a CGNS file tell: zones and their sizes, arrays with their units, and which of them would be
/// read. Nothing if they tell no zone with points. Neither ranges nor whether a grid is rectilinear: that would take
/// its numbers.
std::optional<FileContents> contentsOfCgns(const CgnsNode& root, const VtkRequest& request);

/// The arrays of all zones, each once: VTK by itself offers those of the first zone.
std::vector<VtkArray> arraysOfCgns(const CgnsNode& root);

/// Adds the unit of the array that was taken, and those of all arrays: "kg/m^3", as powers stand at the array and units
/// there or further up.
void tellCgnsUnit(const CgnsNode& root, Provenance& provenance);
void addCgnsUnits(const CgnsNode& root, std::vector<FileArray>& arrays);

} // namespace tetra
