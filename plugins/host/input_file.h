// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/result.h"

#include <cstddef>
#include <filesystem>

namespace tetra {

/// The first bytes of a file, as many as readers want to see for their score (up to 4096). The error says what is wrong
/// with the file: missing, a folder, not readable, empty.
Result<Buffer<std::byte>> firstBytesOf(const std::filesystem::path& path);

/// Whether a file is meant to be a TAn model: it ends in ".tan" or begins like one. False if it cannot be read.
bool isModelFile(const std::filesystem::path& path);

} // namespace tetra
