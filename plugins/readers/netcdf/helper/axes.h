// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/netcdf/helper/netcdf_file.h"

#include <tan/base.h>

namespace tetra {

/// Along which axis of the world a coordinate counts.
enum class AxisRole : std::uint8_t { X, Y, Z, Time, Unknown };

/// By its attributes (axis, standard_name, units, positive; chapter 4 of the conventions CF), else by its name.
AxisRole roleOf(const NetCdfFile& file, const NetCdfVariable& coordinate);

/// The variable of a dimension's own name that has nothing but this dimension, seen from `from`; null without one.
const NetCdfVariable* coordinateOf(const NetCdfFile& file, const NetCdfVariable& from, std::size_t dimension);

/// The same, or without it a variable of times along the dimension alone.
const NetCdfVariable* timesAlong(const NetCdfFile& file, const NetCdfVariable& from, std::size_t dimension);

AxisRole roleOf(const NetCdfFile& file, const NetCdfVariable& from, std::size_t dimension);

/// The words of the attribute "coordinates", or of another list of names.
std::vector<std::string> wordsOf(const std::string& list);

} // namespace tetra
