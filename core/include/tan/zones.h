// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/zones.h: several structured grids as one mesh, as CGNS, PLOT3D and multi-block files of VTK hold them.

#include <tan/base.h>
#include <tan/data.h>

#include <span>
#include <vector>

namespace tetra {

/// A mesh of hexahedra, for irregularDataset().
struct JoinedZones {
    CellComplex complex; ///< the cells of all zones, one zone after the other, the first index running fastest
    ComplexValues values;
    std::vector<Message> remarks; ///< how the zones fit together, for Dataset::remarks
};

/// Puts grids together, regular or curvilinear ones in which each point has a value (not finite: a hole),
/// Dataset::cells a GridCell for each cell, if there are any that are not kept. Where two zones meet, their points on
/// one place become one point when irregularDataset() makes the mesh; the remarks count the faces that fit together in
/// this way, and those that lie against another zone without having the same points, where the mesh has a seam. Zones
/// that overlap are not told here: irregularDataset() finds overlapping cells. Zones without cells (a single point
/// along an axis) are left out, and counted. Values have the zones' type, or double precision if these differ.
///
/// Errors: no zone, or none with cells; data on no lattice (BadInput); more memory than there is, which is told
/// beforehand, or more points than can be numbered (OutOfResource); cancelled. May throw std::bad_alloc. One thread,
/// O(n log n); safe from any thread.
TAN_API Result<JoinedZones> joinZones(std::span<const Dataset> zones, const Progress& progress = {});

} // namespace tetra
