// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A node of a CGNS file. What is long, coordinates and values, is not read.
struct CgnsNode {
    std::string name;
    std::string label;             ///< "Zone_t"
    std::string type;              ///< of its data: "R8"; "MT" if it has none
    std::vector<double> numbers{}; ///< its data, of nodes that tell sizes and powers
    std::string text{};            ///< its data, of nodes that tell words
    std::vector<CgnsNode> children{};

    /// The first child of this label; null if there is none.
    const CgnsNode* child(std::string_view childLabel) const;
};

/// The root, with bases, zones, solutions and arrays, and the units, of a file as CGNS's library writes it (HDF5 or
/// ADF). Nothing if the library cannot read it, or if it has more nodes than are looked at: then VTK alone tells what
/// the file holds, without units.
std::optional<CgnsNode> readCgnsHeaders(const std::string& path);

} // namespace tetra
