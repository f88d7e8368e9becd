// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace tetra {

/// The part of MappedFile that lives beside the signal handler: which mappings there are and which of them are damaged.
/// All functions are thread-safe.

/// Guards `mapping`, page-aligned and not empty, until unguardMapping(). Returns its index, or -1 if the table is full.
int guardMapping(std::span<const std::byte> mapping);
/// No thread may still be reading the mapping. Comes before munmap.
void unguardMapping(int index) noexcept;
/// True if a read in the mapping found no file behind it.
bool isMappingDamaged(int index) noexcept;

} // namespace tetra
