// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// Unpacks gzip data (RFC 1952), several members in a row included, or zlib data (RFC 1950), of `skip` + content.size()
/// + `behind` bytes, and keeps those of `content`. Errors: neither of them, damaged (the checksum is tested), cut
/// short, more or fewer bytes in it than that, not enough memory, cancelled. Zeros after the last member are padding;
/// what follows zlib data is not looked at. Linear in the unpacked size.
Status unpackPart(std::span<const std::byte> packed, std::uint64_t skip, std::span<std::byte> content,
                  std::uint64_t behind, const Progress& progress);

/// No gzip or zlib data of this many bytes unpack to more: the formats pack at most 1032 to one.
constexpr std::uint64_t largestUnpackedSize(std::uint64_t packedBytes)
{
    return packedBytes > (std::uint64_t(1) << 52) ? std::uint64_t(1) << 62 : packedBytes * 1032;
}

} // namespace tetra
