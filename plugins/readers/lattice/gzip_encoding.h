// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"

#include <tan/base.h>

#include <cstddef>
#include <span>

namespace tetra {

/// Appends `content` to `file` as one gzip member (RFC 1952). Errors: the file's, not enough memory, cancelled.
Status writeGzip(std::span<const std::byte> content, FileWriter& file, const Progress& progress);

} // namespace tetra
