// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/model.h"

#include <cstdint>
#include <ranges>

namespace tetra {

/// The tetrahedra that a site created, by their numbers: empty if the file's offsets make no sense, which is found
/// where whole prefixes are read.
inline auto starOf(const Model& model, std::uint32_t site)
{
    std::uint64_t begin = model.starOffsets()[site];
    const std::uint64_t end = model.starOffsets()[site + std::size_t(1)];
    if (begin > end || end > model.tetrahedronCount())
        begin = end;
    return std::views::iota(begin, end);
}

} // namespace tetra
