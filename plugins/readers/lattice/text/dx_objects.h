// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// The regular positions of a grid, of any number of dimensions: `class gridpositions`.
struct DxGrid {
    std::vector<std::uint64_t> counts;
    std::vector<double> origin;
    std::vector<std::vector<double>> steps; ///< of each index, the last of which runs fastest
};

/// Numbers: `class array`.
struct DxArray {
    std::string type = "float"; ///< with "unsigned" or "signed" in front if that is said
    bool isComplex = false;
    std::uint64_t components = 1; ///< of each item
    std::uint64_t items = 0;
    bool isText = true;
    std::optional<std::endian> order{};
    std::string file{};                     ///< that has them, by the name in the text; empty: this one
    std::uint64_t firstByte = 0;            ///< of that file
    std::optional<std::uint64_t> endByte{}; ///< of data that follow, behind their last byte
    std::optional<std::uint64_t> offset{};  ///< of this file, from the end of its header
    bool hasData = false;
};

/// A field: which objects are its components.
struct DxField {
    std::string name;                                           ///< "" if it has only a number
    std::map<std::string, std::string, std::less<>> components; ///< "data", "positions" ...: the object's name
};

/// All objects of a file that say something of grids.
struct DxObjects {
    std::map<std::string, DxGrid, std::less<>> grids;
    std::map<std::string, DxArray, std::less<>> arrays;
    std::vector<std::string> arrayOrder;                          ///< the names of the arrays, as they come
    std::vector<DxField> fields;                                  ///< in their order
    std::map<std::string, std::string, std::less<>> otherClasses; ///< of objects that are none of these
    std::uint64_t headerBytes = 0;                                ///< up to where offsets count from
};

/// The type of the numbers of an array; none of texts and unknown ones.
std::optional<StoredType> dxNumberType(std::string_view type);

/// Takes the text of an OpenDX file apart, as far as its header goes; numbers among it are passed over. Errors say what
/// is not understood. Linear in the size of the file, and memory in that of the header.
Result<DxObjects> parseDxObjects(std::string_view text);

} // namespace tetra
