// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/mrc/mrc_volume.h"

#include "plugins/readers/lattice/mrc/mrc_header.h"
#include "plugins/readers/lattice/mrc/mrc_place.h"

#include <algorithm>

namespace tetra {

namespace {

void setType(StoredVolume& volume, StoredType type, std::uint32_t components = 1)
{
    volume.type = type;
    volume.components = components;
}

/// Mode 0: signed, as the format has said since 2014. IMOD says it by a flag; others wrote bytes from 0 to 255, which
/// the largest value of the header shows.
void setByteType(const MrcHeader& header, StoredVolume& volume)
{
    constexpr double largestSigned = 127, largest = 255;
    constexpr std::int32_t isSigned = 1;
    const bool isUnsignedOfImod = header.isOfImod && (header.imodFlags & isSigned) == 0;
    const bool showsUnsigned =
        !header.isOfImod && header.least >= 0 && header.most > largestSigned && header.most <= largest;
    setType(volume, isUnsignedOfImod || showsUnsigned ? StoredType::UInt8 : StoredType::Int8);
    if (isUnsignedOfImod)
        volume.remarks.push_back(
            Message::say("Its bytes were read as unsigned, from 0 to 255, as IMOD's flag states."));
    else if (showsUnsigned)
        volume.remarks.push_back(Message::say(
            "Its bytes were read as unsigned, from 0 to 255, because its header states that the largest value is %1.",
            formatNumber(header.most)));
}

Status setMode(const MrcHeader& header, StoredVolume& volume)
{
    constexpr std::int32_t packed = 101;
    switch (header.mode) {
    case 0: setByteType(header, volume); return {};
    case 1: setType(volume, StoredType::Int16); return {};
    case 2: setType(volume, StoredType::Float32); return {};
    case 3: setType(volume, StoredType::Int16, 2); break;
    case 4: setType(volume, StoredType::Float32, 2); break;
    case 6: setType(volume, StoredType::UInt16); return {};
    case 12: setType(volume, StoredType::Float16); return {};
    case 16: setType(volume, StoredType::UInt8, 3); return {};
    case packed:
        return Error{ErrorKind::BadInput,
                     Message::say("its samples have four bits each (mode 101), which is not read. Write it with bytes "
                                  "(mode 0), for instance with IMOD's 'newstack -mode 0'.")};
    default:
        return Error{ErrorKind::BadInput,
                     Message::say("its samples are of mode %1, which is not read. Write it with mode 2 (floating "
                                  "point).",
                                  header.mode)};
    }
    volume.remarks.push_back(Message::say("Its samples are complex numbers (mode %1), as of a Fourier transform: their "
                                          "places are not those of a body.",
                                          header.mode));
    return {};
}

/// How many volumes lie behind one another: of a stack of volumes MZ says how many sections each has.
std::uint64_t volumesOf(const MrcHeader& header)
{
    constexpr std::int32_t firstStackGroup = 401, lastStackGroup = 630;
    const std::int32_t sections = header.size[2], ofEach = header.grid[2];
    const bool isStack = header.spaceGroup >= firstStackGroup && header.spaceGroup <= lastStackGroup;
    return isStack && ofEach > 1 && sections % ofEach == 0 ? static_cast<std::uint64_t>(sections / ofEach) : 1;
}

void tellOfHeader(const MrcHeader& header, StoredVolume& volume)
{
    if (header.isOrderGuessed)
        volume.remarks.push_back(
            Message::say("The machine stamp of its header does not state the byte order: the one in which its numbers "
                         "are plausible was used, %1 endian.",
                         header.order == std::endian::big ? Message::say("big") : Message::say("little")));
    if (header.spaceGroup == 0 && header.grid[2] == 1 && header.size[2] > 1)
        volume.leftOut.push_back(Message::say("Its header states that it is a stack of %1 pictures and not a volume "
                                              "(space group 0, MZ 1); it was read as a volume.",
                                              header.size[2]));
}

} // namespace

Result<StoredVolume> mrcVolume(const VolumeRequest& request)
{
    const auto header = parseMrcHeader(request.file->bytes());
    if (!header)
        return header.error();
    StoredVolume volume;
    if (const Status known = setMode(*header, volume); !known)
        return known.error();
    if (std::ranges::any_of(header->size, [](auto points) { return points < 1; }) || header->extensionBytes < 0)
        return Error{ErrorKind::BadInput,
                     Message::say("its header claims %1 x %2 x %3 points, after an extension of %4 bytes. It is "
                                  "damaged, or not a map: copy or export it again.",
                                  header->size[0], header->size[1], header->size[2], header->extensionBytes)};
    const std::uint64_t volumes = volumesOf(*header);
    const auto points = [&](std::size_t axis) { return static_cast<std::uint64_t>(header->size[axis]); };
    if (const Status fits = setStoredSize(volume, {points(0), points(1), points(2) / volumes}, volumes); !fits)
        return fits.error();
    volume.order = header->order;
    volume.files = {{request.path}};
    volume.offset = mrcHeaderBytes + static_cast<std::uint64_t>(header->extensionBytes);
    if (const Status taken = takeComponent(volume, request.values); !taken)
        return taken.error();
    if (const Status taken = takeTimeStep(volume, request.values, volumes, volume.numbers / volumes); !taken)
        return taken.error();
    placeMrc(*header, volume);
    tellOfHeader(*header, volume);
    return volume;
}

} // namespace tetra
