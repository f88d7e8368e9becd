// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace tetra {

/// Sorts a vector and leaves each of its elements once. O(n log n).
template <class Vector> void sortUnique(Vector& elements)
{
    std::ranges::sort(elements);
    const auto repeated = std::ranges::unique(elements);
    elements.erase(repeated.begin(), repeated.end());
}

} // namespace tetra
