// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/order/topological_sort.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetra {

/// When cycles hold back what is not taken: the cells among which they are to be looked for, which are neither before
/// all cycles nor behind them. What lies behind is left by `front`, in order. `front` and `back` have taken all that is
/// free at their ends, or at `back` half of the `cells`. `front` takes no more, and `back` is not needed any more. May
/// throw std::bad_alloc.
std::vector<std::uint32_t> heldByCycles(std::size_t cells, TopologicalSort& front, TopologicalSort& back);

} // namespace tetra
