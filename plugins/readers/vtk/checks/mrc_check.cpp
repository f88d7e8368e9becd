// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://www.ccpem.ac.uk/mrc_format/mrc2014.php
#include "plugins/readers/vtk/checks/format_checks.h"

#include <cstring>

namespace tetra {

Result<CheckedFile> checkMrc(const std::filesystem::path& path)
{
    constexpr std::size_t headerBytes = 1024;
    constexpr std::size_t modeWord = 3, extensionWord = 23, stampByte = 212;
    constexpr std::byte bigEndianStamp{17};
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const auto bytes = (*file)->bytes();
    if (bytes.size() < headerBytes)
        return cutShort(Message::say("it"), bytes.size(), headerBytes);
    if (bytes[stampByte] == bigEndianStamp)
        return Error{ErrorKind::BadInput,
                     Message::say("its numbers have the byte order of other machines (big endian), which VTK reads "
                                  "wrongly. Write it anew on this machine.")};
    const auto word = [&](std::size_t index) {
        std::int32_t value = 0;
        std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
        return value;
    };
    std::uint64_t samples = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (word(axis) < 1)
            return wrongHeader(Message::say("its header says that it has %1 points along an axis.", word(axis)));
        samples = boundedProduct(samples, static_cast<std::uint64_t>(word(axis)));
    }
    std::uint64_t sampleBytes = 0;
    switch (word(modeWord)) { // those that VTK reads
    case 0: sampleBytes = 1; break;
    case 1: sampleBytes = 2; break;
    case 2:
    case 3:
    case 6: sampleBytes = 4; break;
    case 4: sampleBytes = 8; break;
    case 16: sampleBytes = 3; break;
    default:
        return Error{
            ErrorKind::BadInput,
            Message::say("its samples are of mode %1, which VTK does not read. Write it with mode 2 (floating point).",
                         word(modeWord))};
    }
    if (word(extensionWord) < 0)
        return wrongHeader(Message::say("its header says that an extension of less than no bytes follows."));
    const std::uint64_t needed =
        boundedSum(headerBytes + static_cast<std::uint64_t>(word(extensionWord)), boundedProduct(samples, sampleBytes));
    if (needed > bytes.size())
        return cutShort(Message::say("it"), bytes.size(), needed);
    return CheckedFile{.bytes = bytes.size()};
}

} // namespace tetra
