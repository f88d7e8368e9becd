// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/hdf5_request.h"
#include "plugins/readers/hdf5/helper/hdf5_arrays.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What the file says of one dimension of an array.
struct AxisSays {
    std::string name{};                          ///< "z"; empty without one
    std::optional<std::vector<double>> values{}; ///< coordinates along it
    bool areSingle = false;                      ///< these have the precision of floats
    bool areMiddles = false;                     ///< of bins, whose edges the file says
    std::string unit{};                          ///< of them
};

/// What each dimension of an array is for.
struct ArrayAxes {
    std::vector<AxisSays> says;         ///< of each dimension, the slowest first
    std::array<std::size_t, 3> space{}; ///< numbers of dimensions, the slowest first
    std::array<std::size_t, 3> world{}; ///< which of x, y, z (0, 1, 2) each of these runs along
    std::optional<std::size_t> time{}, channel{}, component{};
    std::vector<std::size_t> further{};
    bool timeIsGuessed = false;      ///< the file does not say so; likewise the others
    bool componentIsGuessed = false; ///< by its few entries
    bool spaceIsGuessed = false;     ///< not all three have names that say x, y and z
};

/// By dimension scales, labels of dimensions, vigra's axistags and the axes of NeXus. Without names the last dimension
/// is x; of four or more the last holds components if it has fewest entries, 2 to 9, and a further one before the last
/// three is time. Errors (BadInput): names leave fewer than three dimensions of space.
Result<ArrayAxes> axesOf(hid_t file, const Hdf5Array& array);

/// "time", or "d2" for the second dimension.
std::string axisName(const ArrayAxes& axes, std::size_t dimension);

/// What is read of the array for a request.
struct ArrayPart {
    std::vector<hsize_t> first;               ///< of each dimension
    std::vector<hsize_t> count;               ///< more than 1 in space alone
    std::optional<std::uint64_t> component{}; ///< from 0; nothing for the magnitude of several
    std::uint64_t components = 1;
    std::vector<Taken> taken{}; ///< in the order of TakenPart
};

/// "it has 3 channels, and number 4 is asked for with 'channel'."
Error noSuchNumber(const Message& what, std::uint64_t there, const std::string& asked, const char* option);

/// Errors (WrongUsage): there is no such step, channel, component, or number along a further dimension.
Result<ArrayPart> partOf(const Hdf5Array& array, const ArrayAxes& axes, const Hdf5Request& request);

} // namespace tetra
