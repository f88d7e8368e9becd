// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/block_choice.h"

#include "core/base/text.h"
#include "core/data/lattice.h"
#include "core/refine/lattice/packed_lattice.h"

namespace tetra {

namespace {

/// A good compromise: the mesh has a few percent more sites than a whole one, and its memory stays in the cache.
constexpr std::uint32_t defaultCells = 32;
/// The most that refining a lattice as a whole takes, history included.
constexpr std::uint64_t bytesAPoint = 600;
/// Beyond that many points blocks are quicker by more than their sites cost (docs/performance.md).
constexpr std::uint64_t mostPointsAsWhole = 1 << 22;
/// Each block is a file until they are merged.
constexpr std::uint64_t mostBlocks = 1 << 17;

Error wrongBlock(const std::string& text)
{
    return {ErrorKind::WrongUsage,
            "The block size '" + text + "' is neither \"automatic\" nor \"none\" nor a number of cells of at least 1."};
}

bool isLarge(std::uint64_t points, std::uint64_t usableBytes)
{
    return points > mostPointsAsWhole || (usableBytes > 0 && points * bytesAPoint > usableBytes / 2);
}

bool fitsAsWhole(const Lattice& lattice, std::uint64_t usableBytes)
{
    return !isLarge(lattice.pointCount(), usableBytes) && latticeMetric(lattice.size, lattice.spacing).ok();
}

std::uint64_t blockCount(const Lattice& lattice, std::uint32_t cells)
{
    std::uint64_t count = 1;
    for (const std::uint32_t size : lattice.size)
        count *= (size - 2) / cells + 1;
    return count;
}

} // namespace

Parameter blockParameter()
{
    Parameter block;
    block.id = "block";
    block.label = "Block";
    block.explanation =
        "The cells along an edge of the blocks that are refined independently, in memory for a few of them; 'none' "
        "refines the dataset as a whole; 'automatic' takes blocks where a lattice is large. The blocks of a "
        "curvilinear "
        "grid are refined together, all in memory.";
    block.unit = "cells";
    block.defaultValue = std::string("automatic");
    block.words = {"automatic", "none"};
    block.onlyWith.id = domainId;
    for (const DomainClass domain : {DomainClass::RegularLattice, DomainClass::Curvilinear})
        block.onlyWith.values.emplace_back(std::string(domainClassName(domain)));
    return block;
}

bool takesBlocks(const std::string& text, std::uint64_t points, std::uint64_t usableBytes)
{
    return text == "automatic" ? isLarge(points, usableBytes) : text != "none";
}

Result<std::optional<std::uint32_t>> givenBlocks(const std::string& text)
{
    if (text == "none" || text == "automatic")
        return std::optional<std::uint32_t>();
    const auto cells = parseNumber<std::uint32_t>(text);
    if (!cells || *cells == 0)
        return wrongBlock(text);
    return cells;
}

Result<std::optional<std::uint32_t>> chooseBlocks(const std::string& text, const Lattice& lattice,
                                                  std::uint64_t usableBytes)
{
    const auto cells = givenBlocks(text);
    if (!cells)
        return cells;
    if (text == "automatic" && !fitsAsWhole(lattice, usableBytes))
        return std::optional(defaultCells);
    if (!*cells)
        return cells;
    if (const std::uint64_t count = blockCount(lattice, **cells); count > mostBlocks)
        return Error{ErrorKind::WrongUsage, "Blocks of " + text + " cells cut this dataset into " +
                                                std::to_string(count) + " pieces; " + std::to_string(mostBlocks) +
                                                " are the most. Choose larger blocks."};
    return cells;
}

} // namespace tetra
