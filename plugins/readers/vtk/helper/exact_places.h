// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <vtkDataObject.h>
#include <vtkPointSet.h>

#include <span>
#include <vector>

namespace tetra {

// VTK's readers of some formats keep places in single precision, whatever their files say.

/// Gives data the places of its file, three numbers a point, if VTK's are these, rounded. Whether they are.
bool setExactPlaces(vtkPointSet& data, std::span<const double> places);

/// Undoes the rounding of places that stand in a file with six digits, as those of EnSight in text do: of such numbers
/// single precision loses nothing. Parts with places of more digits keep VTK's.
void setSixDigitPlaces(vtkDataObject& data);

/// Says so of places that are still in single precision, and by how much they may be off.
void tellSinglePrecision(vtkDataObject& data, std::vector<Message>& leftOut);

} // namespace tetra
