// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds what unpacks the blocks of h5py's quick compression: two bytes for the room there is, and the block.
#include "plugins/readers/hdf5/helper/lzf_filter.h"
#include "tests/fuzz/fuzz_input.h"

#include <memory>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    constexpr std::size_t headBytes = 2;
    if (size < headBytes)
        return 0;
    const std::span block(bytes + headBytes, size - headBytes);
    const std::size_t room = bytes[0] + 256 * bytes[1];
    const std::unique_ptr<unsigned char[]> memory(new unsigned char[room]); // its ends are watched
    const std::span to(memory.get(), room);
    const auto written = unpackLzf(block, to);
    if (!written)
        return 0;
    require(*written <= room, "no more is written than there is room for");
    const std::unique_ptr<unsigned char[]> other(new unsigned char[room + 1]);
    require(unpackLzf(block, {other.get(), room + 1}) == written && std::equal(&to[0], &to[0] + *written, other.get()),
            "more room changes nothing");
    require(*written == 0 || !unpackLzf(block, to.first(*written - 1)), "less room is told");
    return 0;
}
