// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/hdf5_request.h"
#include "plugins/readers/hdf5/helper/element_type.h"
#include "plugins/readers/hdf5/helper/hdf5_id.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// An array of a file, as its header says.
struct Hdf5Array {
    std::string path;                  ///< "/fields/density"
    std::vector<std::uint64_t> size{}; ///< of its dimensions, the slowest first; empty for one that lies elsewhere
    ElementType element{};
    bool liesElsewhere = false; ///< its values are those of other files, or of other arrays
    bool isShown = false;       ///< NeXus: the signal of its group
};

/// What groups and arrays a file holds.
struct Hdf5Listing {
    std::vector<Hdf5Array> arrays{}; ///< by hard links, each once, in the order of their paths
    std::vector<Message> leftOut{};  ///< what was not looked at: links into other files, groups too deep
};

/// Opens a file of which all is read; after that this process can open no other. Errors (BadInput): the library's; of
/// formats inside HDF5 that have readers, or rules, of their own.
Result<Hdf5Id> openHdf5(const std::string& path);

/// Goes through all groups, each once however often it is linked.
Hdf5Listing listingOf(hid_t file);

/// Whether it has numbers along three dimensions with two points or more.
bool isVolume(const Hdf5Array& array);

/// "'/fields/density' (9 x 7 x 5, float)".
Message arrayText(const Hdf5Array& array);

/// "'/a' (9 x 7 x 5, float), '/b' (6 x 4 x 5, uint8) and 2 more".
Message arraysText(const std::vector<const Hdf5Array*>& arrays);

/// The array that is asked for, or that the file shows (NeXus), else the largest volume; `isGuess`: among several of
/// them. Errors: there is none, with what there is (BadInput); none of that name or number (WrongUsage).
struct ChosenArray {
    const Hdf5Array* array = nullptr;
    bool isGuess = false;
};
Result<ChosenArray> chooseArray(hid_t file, const Hdf5Listing& listing, const Hdf5Request& request);

} // namespace tetra
