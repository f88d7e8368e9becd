// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/plot3d/plot3d_file.h"

#include <tan/data.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The scalars that a solution gives, by the names that the user chooses them by: the five stored quantities and what
/// follows from them for a perfect gas with the ratio of specific heats 1.4, in PLOT3D's dimensionless units.
std::span<const std::string_view> plot3dArrayNames();

/// A grid of a solution, and its points that do not count, as of blankedPoints().
struct Plot3dGrid {
    std::size_t number = 0;
    std::vector<std::uint8_t> blanked{};
};

/// A scalar of every point.
struct Plot3dArray {
    std::string name;
    std::vector<ScalarField> values; ///< of each grid, in single precision if the solution was and they fit
};

/// The array called `name`; or for "automatic" the first one that varies over these grids together, density first, then
/// pressure. Errors (naming the arrays that can be taken): it is the same everywhere; it is no number anywhere.
Result<Plot3dArray> readPlot3dArray(const Plot3dFile& solution, std::span<const Plot3dGrid> grids,
                                    const std::string& name, const Progress& progress);

} // namespace tetra
