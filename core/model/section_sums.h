// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/checksum.h"
#include "core/model/format.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The checksums of a section that is written piece by piece: of all of it, and of each of its chunks. Members that
/// take bytes may throw std::bad_alloc.
class SectionSums {
public:
    void add(std::span<const std::byte> bytes);
    std::uint64_t ofWhole() const noexcept { return whole_.value(); }
    /// Of everything added so far; the last chunk may be a short one.
    std::vector<std::uint64_t> ofChunks() const;

private:
    Checksum whole_;
    Checksum chunk_;
    std::uint64_t inChunk_ = 0; ///< bytes of the chunk that is not full yet
    std::vector<std::uint64_t> full_;
};

/// What the section ChunkSums holds, of all sections before it in the table.
class ChunkSums {
public:
    ChunkSums() : elements_{format::chunkBytes} {}

    void append(const SectionSums& sums);
    std::span<const std::byte> bytes() const noexcept { return std::as_bytes(std::span(elements_)); }

private:
    std::vector<std::uint64_t> elements_;
};

} // namespace tetra
