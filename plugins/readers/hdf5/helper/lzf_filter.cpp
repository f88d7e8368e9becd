// SPDX-License-Identifier: GPL-3.0-or-later
// The format: http://software.schmorp.de/pkg/liblzf.html, and h5py's lzf_filter.c for the three numbers beside it.
#include "plugins/readers/hdf5/helper/lzf_filter.h"

#include "plugins/readers/hdf5/helper/hdf5_filters.h"

#include <hdf5.h>

#include <algorithm>

namespace tetra {
namespace {

/// The library's interface: gives the bytes of the unpacked block, which takes the place of the packed one, or 0.
std::size_t runLzf(unsigned flags, std::size_t count, const unsigned numbers[], std::size_t bytes,
                   std::size_t* allocated, void** block)
{
    constexpr std::size_t chunkBytesAt = 2; // behind two versions
    if ((flags & H5Z_FLAG_REVERSE) == 0 || count <= chunkBytesAt || numbers[chunkBytesAt] == 0)
        return 0;
    constexpr std::size_t checksumBytes = 4; // that may have been put behind the chunk before it was packed
    const std::size_t least = numbers[chunkBytesAt], most = least + checksumBytes;
    void* unpacked = H5allocate_memory(most, false);
    if (unpacked == nullptr)
        return 0;
    const auto written =
        unpackLzf({static_cast<const unsigned char*>(*block), bytes}, {static_cast<unsigned char*>(unpacked), most});
    if (!written || *written < least) {
        H5free_memory(unpacked);
        return 0;
    }
    H5free_memory(*block);
    *block = unpacked;
    *allocated = most;
    return *written;
}

} // namespace

std::optional<std::size_t> unpackLzf(std::span<const unsigned char> from, std::span<unsigned char> to) noexcept
{
    constexpr std::size_t literals = 32; // control bytes below are the number of bytes to copy, less 1
    std::size_t in = 0, out = 0;
    while (in < from.size()) {
        const std::size_t control = from[in++];
        if (control < literals) {
            const std::size_t length = control + 1;
            if (length > from.size() - in || length > to.size() - out)
                return std::nullopt;
            std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(in), length,
                        to.begin() + static_cast<std::ptrdiff_t>(out));
            in += length;
            out += length;
            continue;
        }
        std::size_t length = control >> 5U;
        if (length == 7) { // the highest says that more follows
            if (in == from.size())
                return std::nullopt;
            length += from[in++];
        }
        length += 2;
        if (in == from.size())
            return std::nullopt;
        const std::size_t back = ((control & 31U) << 8U) + from[in++] + 1;
        if (back > out || length > to.size() - out)
            return std::nullopt;
        for (std::size_t i = 0; i < length; ++i, ++out) // what is copied may reach into the copy
            to[out] = to[out - back];
    }
    return out;
}

void registerLzfFilter()
{
    static const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, lzfFilter, 0, 1, "lzf", nullptr, nullptr, runLzf};
    H5Zregister(&filter);
}

} // namespace tetra
