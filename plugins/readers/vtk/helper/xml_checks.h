// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace tetra {

/// What VTK does not look at in a file of a grid (ImageData, RectilinearGrid, StructuredGrid), and would fill with
/// zeros or defaults: pieces that leave out part of the whole, and a spacing or an origin that are not three numbers.
/// Reads the file up to its appended data.
Status checkXmlGrid(const std::string& path, std::string_view type);

/// The value of `name="..."` in an element; empty without it.
std::string_view xmlAttribute(std::string_view element, std::string_view name);

} // namespace tetra
