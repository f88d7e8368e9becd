// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Clip planes as text, "nx,ny,nz,offset" each, separated by ';': where nx x + ny y + nz z >= offset is shown. No text
/// is no plane. Errors (WrongUsage): four finite numbers each, the first three of them not all zero; the text says
/// which plane is wrong.
Result<std::vector<ClipPlane>> parseClipPlanes(std::string_view text);

/// The text that parseClipPlanes() reads as these planes.
std::string clipPlanesText(std::span<const ClipPlane> planes);

} // namespace tetra
