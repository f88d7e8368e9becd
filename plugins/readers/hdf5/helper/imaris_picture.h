// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/helper/hdf5_arrays.h"

#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// Which array of a picture of Imaris: "/DataSet/ResolutionLevel 0/TimePoint 2/Channel 1/Data" is {0, 2, 1}.
struct ImarisPlace {
    std::uint64_t level = 0; ///< of detail, 0 is the finest
    std::uint64_t time = 0;
    std::uint64_t channel = 0;
};
std::optional<ImarisPlace> imarisPlace(const std::string& path);

/// How many levels, times and channels a file has; nothing if it is none of Imaris.
struct ImarisPicture {
    std::uint64_t levels = 0;
    std::uint64_t times = 0;
    std::uint64_t channels = 0;
};
std::optional<ImarisPicture> imarisPictureOf(const Hdf5Listing& listing);

/// The request with the path of the array that its time and its channel ask for, of the finest level; as it stands if
/// it names an array. Errors (WrongUsage): there is no such time or channel.
Result<Hdf5Request> requestInImaris(const ImarisPicture& picture, const Hdf5Request& request);

/// What of an array are voxels, the slowest dimension first: Imaris fills up the last chunk along each. Its own size
/// where nothing else is said.
std::vector<std::uint64_t> imarisSize(hid_t file, const Hdf5Array& array);

/// Where the middles of the voxels lie: Imaris says where the picture begins and ends. Nothing if the array is none of
/// Imaris, or if the file does not say that.
struct ImarisFrame {
    Eigen::Vector3d origin;
    Eigen::Vector3d spacing;
    std::string unit; ///< of lengths
};
std::optional<ImarisFrame> imarisFrameOf(hid_t file, const Hdf5Array& array);

/// The level, the time and the channel that were taken, where there are several; a time and a channel that nobody asked
/// for are guesses.
void tellImaris(hid_t file, const ImarisPicture& picture, const Hdf5Array& array, const Hdf5Request& request,
                std::vector<Taken>& taken, std::vector<Message>& leftOut);

} // namespace tetra
