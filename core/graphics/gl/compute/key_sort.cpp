// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/key_sort.h"

#include <utility>

namespace tetra {
namespace {

/// As in digits.comp.
constexpr std::size_t keysPerInvocation = 16;
constexpr std::size_t digitValues = 16;
constexpr unsigned bitsPerDigit = 4;
constexpr std::size_t bytesPerPair = 2 * sizeof(unsigned);

std::size_t runsFor(std::size_t count)
{
    return (count + keysPerInvocation - 1) / keysPerInvocation;
}

} // namespace

void KeySort::reserve(const ComputeContext& context, std::size_t count)
{
    pairs_.reserve(context, count * bytesPerPair);
    other_.reserve(context, count * bytesPerPair);
    counts_.reserve(context, runsFor(count) * digitValues * sizeof(unsigned));
}

void KeySort::run(const ComputeContext& context, const ComputePrograms& programs, std::size_t count, unsigned bits)
{
    const std::size_t runs = runsFor(count);
    for (unsigned shift = 0; shift < bits && count > 0; shift += bitsPerDigit) {
        for (const bool placing : {false, true}) {
            programs.digits->use();
            programs.digits->set("count", static_cast<unsigned>(count));
            programs.digits->set("shift", shift);
            programs.digits->set("placing", placing ? 1 : 0);
            bindStorage(context, {&pairs_, &other_, &counts_});
            runFor(context, runs);
            if (!placing)
                sums_.run(context, *programs.sums, counts_, runs * digitValues);
        }
        std::swap(pairs_, other_);
    }
}

} // namespace tetra
