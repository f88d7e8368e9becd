// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace tetra {

/// Writes a file that is in memory already, safely (FileWriter).
Status writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> content);

} // namespace tetra
