// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd/nrrd_fields.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
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
    bool runsThroughTime = false; ///< its direction leads along the fourth axis of a space with time
};

struct NrrdVector {
    Eigen::Vector3d place;
    double time = 0;
};

/// The axes in the header's order, fastest first. Errors: missing or wrong dimension and sizes, lists of another length
/// than the dimension, words that are no numbers, directions of a space that has not three dimensions.
Result<std::vector<NrrdAxis>> parseNrrdAxes(const NrrdFields& fields);

/// What the axes hold, by their numbers.
struct NrrdRoles {
    std::array<std::size_t, 3> points{};
    std::optional<std::size_t> components; ///< of vectors, colours, matrices ...
    std::optional<std::size_t> steps;      ///< time steps, or a list of volumes
};

/// By their kinds; an axis that has none is taken for points, but where three others have directions in space and it
/// has not, it holds components if it runs fastest, else steps. Axes of one point hold nothing if there are more than
/// three. Errors: not exactly three hold points; several hold components, or steps.
Result<NrrdRoles> nrrdRoles(const std::vector<NrrdAxis>& axes);

/// Whether `space` or `space dimension` say that vectors have a fourth component.
bool nrrdSpaceHasTime(const NrrdFields& fields);

/// "(1, 2.5, -3)", as in space origin and space directions, or "(1, 2.5, -3, 0)" in a space with time; nothing if it is
/// not three or four numbers.
std::optional<NrrdVector> parseNrrdVector(std::string_view text, bool withTime);

} // namespace tetra
