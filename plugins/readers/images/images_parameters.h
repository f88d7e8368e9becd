// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/images/images_request.h"

namespace tetra {

/// What can be chosen of pictures.
std::vector<Parameter> imagesParameters();

/// The choices as the program takes them; path and format are left to be filled in.
ImagesRequest imagesRequest(const ParameterValues& values);

} // namespace tetra
