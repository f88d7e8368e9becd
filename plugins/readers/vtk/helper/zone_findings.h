// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <vtkDataSet.h>

#include <string>
#include <vector>

namespace tetra {

/// A structured grid with cells of three dimensions, and the values that are taken of it.
struct VtkZone {
    std::string name;
    vtkDataSet* data = nullptr;
    VtkSamples samples;
};

/// Grids as one mesh of hexahedra, whose points on one place become one later (tan/zones.h); the remarks say how they
/// fit together. The values of all are of points, or of cells (`perCell`), which stay those of the cells. Zones are
/// emptied one by one, so that little is there twice. Errors: those of joinZones().
Result<VtkFindings> zoneFindings(std::vector<VtkZone> zones, bool perCell);

} // namespace tetra
