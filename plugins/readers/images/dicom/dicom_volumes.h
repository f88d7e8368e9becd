// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/images/dicom/dicom_header.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// A picture of a series, by numbers from 0: of a header in the series, and of a frame in it.
struct DicomPicture {
    std::size_t file = 0;
    std::size_t frame = 0;
};

/// Pictures of one size and direction of which no two lie on one place, along their normal.
struct DicomVolume {
    std::vector<DicomPicture> pictures{};
    Message name{};         ///< by what it differs from others that lie on its place: "echo 4.6"; may be empty
    bool isGuessed = false; ///< nothing in the files says which picture of a place belongs to which volume
};

struct DicomVolumes {
    std::vector<DicomVolume> volumes{};
    std::size_t opened = 0; ///< the one with the first picture of the file that was opened
    std::size_t others = 0; ///< pictures that belong to no volume, as overviews
    std::size_t copies = 0; ///< files that are copies of others
};

/// The volumes that the pictures of one series make: those of the opened file's size and direction first. `opened` is a
/// number in `series`. The error says what is wrong with "it", the opened file.
Result<DicomVolumes> volumesOf(std::span<const DicomHeader> series, std::size_t opened);

/// Where a volume lies. Millimetres.
struct DicomPlaces {
    Lattice lattice{};                     ///< its size, and all of it if there are no slices
    std::vector<Eigen::Vector3d> slices{}; ///< the first points of each, if no lattice has them
    std::string space{}, lengthUnit{};
    std::vector<std::string> untold{};
    std::vector<Message> remarks{};
    std::optional<Message> guess{}; ///< what was assumed, and where it was taken from
};

/// Positions and directions as the pictures tell them; distances of slices without positions are guessed from their
/// thickness. Slices that are missing or lie unevenly stay where they are, with a remark.
DicomPlaces placesOf(std::span<const DicomHeader> series, const DicomVolume& volume);

/// Where all points of slices lie, the first index fastest.
std::vector<Eigen::Vector3d> positionsOf(const DicomPlaces& places);

} // namespace tetra
