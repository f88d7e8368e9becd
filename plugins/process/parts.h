// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <string>
#include <vector>

namespace tetra {

/// What is wrong with all parts of a mesh together, as the error says, and that the parameter 'part' takes one of these
/// instead. The same error if there are not several.
Error errorOfParts(const Error& error, const std::vector<std::string>& parts);

} // namespace tetra
