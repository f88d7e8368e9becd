// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/netcdf/helper/places.h"

namespace tetra {

/// Files of the model WRF, which follow a convention of their own: dimensions are called bottom_top, south_north and
/// west_east, "_stag" those at the faces of cells.

/// XLONG and XLAT for the points of a field of WRF that does not name its coordinates; none of other fields.
std::vector<const NetCdfVariable*> wrfCoordinates(const NetCdfFile& file, const NetCdfField& field);

/// Gives a field of WRF over bottom_top heights for z, (PH + PHB) / 9.81 m/s2 of its time step, brought to its points
/// as the mean of the two around: a guess. Changes nothing of other fields, or without PH and PHB. Errors: the
/// library's.
Status placeByGeopotential(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part,
                           FieldPlaces& places);

} // namespace tetra
