// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/plot3d/plot3d_file.h"

#include <tan/data.h>

#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// The scalars that a solution gives, by the names that the user chooses them by: the five stored quantities and what
/// follows from them for a perfect gas with the ratio of specific heats 1.4, in PLOT3D's dimensionless units.
std::span<const std::string_view> plot3dArrayNames();

/// A scalar of every point.
struct Plot3dArray {
    std::string name;
    ScalarField values; ///< in single precision if the solution was and they fit
};

/// The array called `name`; or for "automatic" the first one that is defined everywhere and varies, density first, then
/// pressure. `blanked` is as of blankedPoints(): what the array is there does not matter. Errors (naming the arrays
/// that can be taken): it is the same everywhere; it is not a number somewhere.
Result<Plot3dArray> readPlot3dArray(const Plot3dFile& solution, std::size_t grid, const std::string& name,
                                    std::span<const std::uint8_t> blanked, const Progress& progress);

} // namespace tetra
