// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/number_text.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace tetra {

/// What a piece of work needs of memory or of a disk, for messages: "12 MB", "1.3 GB", rounded up.
inline std::string neededBytesText(std::uint64_t bytes)
{
    const auto size = static_cast<double>(bytes);
    return bytes < 1'000'000'000 ? formatNumber(std::ceil(size / 1e6)) + " MB"
                                 : formatNumber(std::ceil(size / 1e8) / 10) + " GB";
}

} // namespace tetra
