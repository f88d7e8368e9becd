// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

#include <string_view>

namespace tetra {

/// What VTK does not look at in a file of its XML formats before it works on it: elements nested or with attributes
/// without end, numbers of components that no array has, files that are missing; and of grids (ImageData,
/// RectilinearGrid, StructuredGrid) pieces that leave out part of the whole, and a spacing or an origin that are not
/// three numbers, in place of which it takes zeros. Reads the file up to its appended data, and those that it names.
Result<CheckedFile> checkXml(const std::filesystem::path& path);

/// What stands in the attribute "type" of the element VTKFile; empty without one in the first bytes of the file.
std::string xmlType(const std::filesystem::path& path);

} // namespace tetra
