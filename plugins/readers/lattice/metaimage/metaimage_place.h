// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/metaimage/metaimage_header.h"
#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Puts the lattice of a MetaImage of three dimensions or more where its header says, in coordinates of ITK's
/// convention: to the left, to the back and to the head. By ElementSpacing or ElementSize, TransformMatrix, whose rows
/// are the directions of the axes, and Offset; or by the other names that they have (Orientation, Rotation; Position,
/// Origin). What is not there: spacing 1, along the axes, origin 0. AnatomicalOrientation adds nothing to that; a
/// remark says where it contradicts it. Times of steps are those of the fourth axis. Errors: fields with too few
/// numbers; a fourth axis that leads through space.
Status placeMetaImage(const MetaHeader& header, std::size_t dimensions, StoredVolume& volume);

/// The times of so many steps along the fourth axis; none if its spacing is not told. Errors: fields with too few
/// numbers.
Result<std::vector<double>> metaTimes(const MetaHeader& header, std::uint64_t steps);

} // namespace tetra
