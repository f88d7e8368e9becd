// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <filesystem>
#include <span>

namespace tetra {

/// How many bytes of a file readers want to see for their score, at most.
inline constexpr std::size_t shownToReaders = 4096;

/// The first bytes of a file, shownToReaders or all; none of an empty file. The error says what is wrong with the file:
/// missing, a folder, not readable; or that too many files are open.
Result<Buffer<std::byte>> firstBytesOf(const std::filesystem::path& path);

/// What is said of a file without a byte, unless it stands for others by its name.
Error emptyFile(const std::filesystem::path& path);

/// Whether a file is meant to be a TAn model: it ends in ".tan" or begins like one. False if it cannot be read.
bool isModelFile(const std::filesystem::path& path);

} // namespace tetra
