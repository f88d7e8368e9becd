// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/writers/mesh_file.h"

#include <limits>
#include <string>
#include <string_view>

namespace tetra {

/// What legacy VTK files of meshes and of surfaces have in common. Numbers are big endian.

/// The file up to its points: `title` in one line, `dataset` is VTK's word for its kind.
std::string vtkLegacyHead(std::string_view title, std::string_view dataset, const MeshFacts& facts);

/// A name in one word: blanks and whatever else could mislead a reader as %XX, which VTK turns back.
std::string vtkLegacyWord(std::string_view name);

/// Numbers of vertices and lengths of lists are ints.
inline constexpr auto mostVtkLegacyNumbers = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());

} // namespace tetra
