// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace tetra {

/// The content of a small file: a session, a transfer function, a camera. Errors: it cannot be read, or has more than
/// 64 MiB.
Result<std::string> readTextFile(const std::filesystem::path& path);

/// Whole or not at all.
Status writeTextFile(const std::filesystem::path& path, std::string_view text);

} // namespace tetra
