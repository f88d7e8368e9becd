// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd_fields.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// What a NRRD header says of one axis. Numbers that are missing or not finite are unknown.
struct NrrdAxis {
    std::uint64_t size = 0;
    std::string kind; ///< lower case, empty if unknown
    bool centeredInCells = false;
    std::optional<double> spacing, minimum, maximum;
    std::optional<Eigen::Vector3d> direction;
};

/// The axes in the header's order, fastest first. Errors: missing or wrong dimension and sizes, lists of another length
/// than the dimension, words that are no numbers, directions of a space that has not three dimensions.
Result<std::vector<NrrdAxis>> parseNrrdAxes(const NrrdFields& fields);

/// "(1, 2.5, -3)", as in space origin and space directions; nothing if it is not three numbers.
std::optional<Eigen::Vector3d> parseNrrdVector(std::string_view text);

} // namespace tetra
