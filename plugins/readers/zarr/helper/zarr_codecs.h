// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/zarr/helper/zarr_numbers.h"

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// What was done with the bytes of a chunk when it was written, one after the other.
struct ZarrCodec {
    enum class Kind : std::uint8_t { Zlib, Gzip, Zstd, Blosc, Checksum, Shuffle, Delta };
    Kind kind = Kind::Zlib;
    std::size_t elementSize = 1;           ///< of Shuffle, and of Delta
    bool isBigEndian = false;              ///< of Delta's numbers
    ZarrNumber number = ZarrNumber::UInt8; ///< of Delta
};

/// Undoes what was done with chunks; its memory is taken once.
class ChunkUnpacking {
public:
    /// The `expected` bytes of numbers that `packed` becomes, those of `packed` itself if nothing was done with it.
    /// They stay until the next call. Never takes more memory than a chunk of that size can need. The error is a
    /// sentence about the chunk, "it". May throw std::bad_alloc.
    Result<std::span<const std::byte>> unpack(std::span<const std::byte> packed, std::span<const ZarrCodec> codecs,
                                              std::uint64_t expected);

private:
    Buffer<std::byte> one_, other_;
};

/// CRC-32C, the checksum of Castagnoli.
std::uint32_t castagnoliChecksum(std::span<const std::byte> bytes) noexcept;

} // namespace tetra
