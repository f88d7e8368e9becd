// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"

#include <tan/packed.h>

#include <filesystem>

namespace tetra {

/// What packing gave: "packed", an object with the method, the sizes and what takes them; and lines of the text.
void addPacking(const PackReport& report, std::uint64_t unpackedBytes, Outcome& outcome);

} // namespace tetra
