// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace tetra {

/// Whether a text is a unit as tables have them beside a name: "m", "kg/m^3", "deg C", "W m-2", "degrees_east". A guard
/// against taking what else stands in brackets, as in "U (magnitude)", for one; it computes nothing.
bool isUnit(std::string_view text);

/// Whether it is one of length: "mm", "metres", "ft".
bool isLengthUnit(std::string_view text);

/// Whether it is one of angles, as longitudes have: "deg", "degrees_north".
bool isAngleUnit(std::string_view text);

} // namespace tetra
