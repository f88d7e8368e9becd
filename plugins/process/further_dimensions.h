// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <map>
#include <string>

namespace tetra {

/// "member=3, type=1": numbers from 1 by the names of dimensions. Error (WrongUsage): what is not understood.
Result<std::map<std::string, std::uint64_t>> parseFurtherDimensions(const std::string& text);

} // namespace tetra
