// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>

namespace tetra {

/// Something with a key, for radixSort.
struct KeyedIndex {
    std::uint32_t key;
    std::uint32_t index;
};

/// Sorts by the lowest `keyBits` bits of the keys, which must hold all that differs; what has the same key stays in
/// order. O(items), on all threads of the current arena, with as much memory again. Incomplete if cancelled. May throw
/// std::bad_alloc.
void radixSort(Buffer<KeyedIndex>& items, int keyBits, const Progress& progress = {});

} // namespace tetra
