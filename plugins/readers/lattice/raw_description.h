// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/lattice/sample_layout.h"

#include <tan/base.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetra {

/// What must be known of a raw file: size, type, byte-order, skip, spacing, origin, unit.
std::vector<Parameter> rawParameters();

/// Whether they say how many points there are, without which nothing is known of a raw file.
bool describesSize(const ParameterValues& values);

/// The layout that the user's parameters describe, all but where it lies. `fileName` and `fileBytes` help to make a
/// good error text when the size is not given. Errors: ErrorKind::WrongUsage for what is missing or cannot be
/// understood.
Result<SampleLayout> rawLayout(const ParameterValues& values, std::string_view fileName, std::uint64_t fileBytes);

} // namespace tetra
