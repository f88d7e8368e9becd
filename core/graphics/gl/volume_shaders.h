// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

namespace tetra {

/// The text of a vertex shader that draws cells, of which `last` is the last part.
std::string cellVertexShader(const char* last);

/// What cells are drawn with, wherever they come from.
std::array<const char*, 3> volumeFragmentShaders();

} // namespace tetra
