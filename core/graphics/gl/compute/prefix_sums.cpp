// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/prefix_sums.h"

namespace tetra {
namespace {

/// As in sums.comp.
constexpr std::size_t countsPerInvocation = 8;
constexpr std::size_t perBlock = 256 * countsPerInvocation;

std::size_t invocationsFor(std::size_t count)
{
    return (count + countsPerInvocation - 1) / countsPerInvocation;
}

} // namespace

void PrefixSums::run(const ComputeContext& context, const GlProgram& program, const StorageBuffer& numbers,
                     std::size_t count)
{
    std::vector<std::size_t> counts{count};
    while (counts.back() > perBlock)
        counts.push_back((counts.back() + perBlock - 1) / perBlock);
    if (blocks_.size() < counts.size())
        blocks_.resize(counts.size());
    const auto level = [&](std::size_t i) { return i == 0 ? &numbers : &blocks_[i - 1]; };
    const auto runLevel = [&](std::size_t i) {
        program.set("count", static_cast<unsigned>(counts[i]));
        bindStorage(context, {level(i), level(i + 1)});
        runFor(context, invocationsFor(counts[i]));
    };
    program.use();
    program.set("adding", 0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        blocks_[i].reserve(context, (counts[i] / perBlock + 1) * sizeof(unsigned));
        runLevel(i);
    }
    program.set("adding", 1);
    for (std::size_t i = counts.size() - 1; i-- > 0;)
        runLevel(i);
}

} // namespace tetra
