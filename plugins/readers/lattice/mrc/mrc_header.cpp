// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/mrc/mrc_header.h"

#include "plugins/readers/lattice/headers/header_numbers.h"

#include <algorithm>
#include <cstring>

namespace tetra {

namespace {

// Where things stand, in bytes.
constexpr std::size_t sizePlace = 0, modePlace = 12, startPlace = 16, gridPlace = 28, cellPlace = 40, anglesPlace = 52,
                      axesPlace = 64, leastPlace = 76, mostPlace = 80, groupPlace = 88, extensionPlace = 92,
                      skewPlace = 96, imodPlace = 152, imodFlagsPlace = 156, originPlace = 196, stampPlace = 208,
                      machinePlace = 212;

template <class T, class To>
void readThree(std::span<const std::byte> header, std::size_t place, std::endian order, std::array<To, 3>& numbers)
{
    for (std::size_t i = 0; i < 3; ++i)
        numbers[i] = numberAt<T>(header, place + i * sizeof(T), order);
}

bool makesSense(std::span<const std::byte> header, std::endian order)
{
    constexpr std::int32_t largestMode = 101;
    std::array<std::int32_t, 3> size{}, axes{};
    readThree<std::int32_t>(header, sizePlace, order, size);
    readThree<std::int32_t>(header, axesPlace, order, axes);
    const auto mode = numberAt<std::int32_t>(header, modePlace, order);
    return mode >= 0 && mode <= largestMode && std::ranges::all_of(size, [](auto n) { return n > 0; }) &&
           std::ranges::all_of(axes, [](auto axis) { return axis >= 0 && axis <= 3; });
}

struct Order {
    std::endian order = std::endian::little;
    bool isGuessed = false;
};

Order orderOf(std::span<const std::byte> header)
{
    constexpr std::byte ofBig{0x11}, ofLittle{0x44};
    const std::byte stamp = header[machinePlace];
    const std::endian stamped = stamp == ofBig ? std::endian::big : std::endian::little;
    const std::endian other = stamped == std::endian::big ? std::endian::little : std::endian::big;
    const bool isOther = !makesSense(header, stamped) && makesSense(header, other);
    return {isOther ? other : stamped, isOther || (stamp != ofBig && stamp != ofLittle)};
}

} // namespace

bool looksLikeMrc(std::span<const std::byte> firstBytes)
{
    constexpr std::string_view stamp = "MAP";
    return firstBytes.size() >= stampPlace + stamp.size() &&
           std::memcmp(firstBytes.data() + stampPlace, stamp.data(), stamp.size()) == 0 &&
           (firstBytes.size() == stampPlace + stamp.size() || firstBytes[stampPlace + stamp.size()] == std::byte(' ') ||
            firstBytes[stampPlace + stamp.size()] == std::byte(0));
}

Result<MrcHeader> parseMrcHeader(std::span<const std::byte> file)
{
    constexpr std::int32_t imodStamp = 1146047817; // "IMOD"
    if (file.size() < mrcHeaderBytes)
        return Error{ErrorKind::BadInput, Message::say("it has %1 bytes, and the header of a map alone has %2. It is "
                                                       "cut short, or not a map: copy the file again.",
                                                       file.size(), mrcHeaderBytes)};
    const auto [order, isGuessed] = orderOf(file);
    MrcHeader header{.order = order, .isOrderGuessed = isGuessed};
    const auto whole = [&](std::size_t place) { return numberAt<std::int32_t>(file, place, order); };
    readThree<std::int32_t>(file, sizePlace, order, header.size);
    header.mode = whole(modePlace);
    readThree<std::int32_t>(file, startPlace, order, header.start);
    readThree<std::int32_t>(file, gridPlace, order, header.grid);
    readThree<float>(file, cellPlace, order, header.cell);
    readThree<float>(file, anglesPlace, order, header.angles);
    readThree<std::int32_t>(file, axesPlace, order, header.axes);
    header.least = static_cast<double>(numberAt<float>(file, leastPlace, order));
    header.most = static_cast<double>(numberAt<float>(file, mostPlace, order));
    header.spaceGroup = whole(groupPlace);
    header.extensionBytes = whole(extensionPlace);
    header.skew = whole(skewPlace);
    readThree<float>(file, originPlace, order, header.origin);
    header.isOfImod = whole(imodPlace) == imodStamp;
    header.imodFlags = header.isOfImod ? whole(imodFlagsPlace) : 0;
    return header;
}

} // namespace tetra
