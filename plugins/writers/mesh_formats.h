// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/writers/mesh_file.h"

#include <cstddef>
#include <string_view>

namespace tetra {

/// One for each format of writeMeshFile(); the content's arrays have the right lengths.
Status writeVtu(const std::filesystem::path& path, const MeshContent& content, const Progress& progress);
Status writeVtk(const std::filesystem::path& path, const MeshContent& content, const Progress& progress);
Status writePlyMesh(const std::filesystem::path& path, const MeshContent& content, const Progress& progress);
Status writeBoundary(const std::filesystem::path& path, const MeshContent& content, const Progress& progress);

inline std::size_t valueCount(const NamedArray& array)
{
    return std::visit([](const auto& values) { return values.size(); }, array.values);
}
inline std::size_t valueBytes(const NamedArray& array)
{
    return std::visit([](const auto& values) { return sizeof(values[0]); }, array.values);
}
/// A number with its shortest digits, a text as it is.
std::string factText(const MeshFacts::value_type::second_type& fact);
/// About the size of the file, for progress.
std::uint64_t bytesOf(const MeshContent& content, std::size_t bytesOfCell);

inline constexpr MarkedText writingMesh = Message::marked("Writing the mesh");

} // namespace tetra
