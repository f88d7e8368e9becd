// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <vector>

namespace tetra {

/// A device that EGL lists.
struct EglDevice {
    bool isSoftware = false;  ///< draws on the processor
    bool showsScreen = false; ///< the card that the machine started with: windows are drawn by it
};

/// In which order to try the cards, as indices: the screen's first, or with `prime` as in the environment variable
/// DRI_PRIME (a number above 0) the others first; else as EGL lists them. Software is left out.
inline std::vector<std::size_t> cardOrder(const std::vector<EglDevice>& devices, std::string_view prime)
{
    std::vector<std::size_t> order(devices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::erase_if(order, [&](std::size_t index) { return devices[index].isSoftware; });
    const bool wantsOther = !prime.empty() && prime.front() >= '1' && prime.front() <= '9';
    std::ranges::stable_partition(order, [&](std::size_t index) { return devices[index].showsScreen != wantsOther; });
    return order;
}

} // namespace tetra
