// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/writers/mesh_file.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace tetra {

/// The head of a binary little-endian PLY file. Line breaks in texts and blanks in names are repaired.
class PlyHead {
public:
    PlyHead& comment(std::string_view text);
    /// A comment each.
    PlyHead& facts(const MeshFacts& facts);
    PlyHead& element(std::string_view name, std::uint64_t count);
    /// Of the element before; `type` is PLY's word for it.
    PlyHead& property(std::string_view type, std::string_view name);
    /// The list of vertices of a face or a cell: a uchar, and as many ints.
    PlyHead& vertexList();

    std::string text() const { return text_ + "end_header\n"; }

private:
    std::string text_ = "ply\nformat binary_little_endian 1.0\n";
};

/// More vertices cannot be numbered by an int.
inline constexpr std::size_t mostPlyVertices = std::numeric_limits<std::int32_t>::max();

} // namespace tetra
