// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/arrays/bov_file.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <map>

namespace tetra {

namespace {

/// The lines `KEY: value`, by their keys in capitals.
using BovHeader = std::map<std::string, std::string, std::less<>>;

std::string capitals(std::string_view text)
{
    std::string capital(text);
    std::ranges::transform(capital, capital.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return capital;
}

Result<BovHeader> bovHeader(std::string_view text)
{
    constexpr std::size_t mostLines = 10'000;
    BovHeader header;
    HeaderLines lines(text);
    while (const auto line = lines.next()) {
        const std::string_view said = trimmed(*line);
        if (said.empty() || said.front() == '#')
            continue;
        const std::size_t colon = said.find(':');
        if (colon == std::string_view::npos || lines.number() > mostLines || said.find('\0') != std::string_view::npos)
            return Error{ErrorKind::BadInput,
                         Message::say("line %1 of its header, '%2', is not 'KEY: value'. Correct or remove it.",
                                      lines.number(), printable(said))};
        header[capitals(trimmed(said.substr(0, colon)))] = std::string(trimmed(said.substr(colon + 1)));
    }
    return header;
}

std::string_view bovValue(const BovHeader& header, std::string_view key)
{
    const auto found = header.find(key);
    return found == header.end() ? std::string_view() : std::string_view(found->second);
}

/// The three numbers of a line; none without the line.
template <class Number>
Result<std::optional<std::array<Number, 3>>> bovThree(const BovHeader& header, const std::string& key)
{
    const std::string_view text = bovValue(header, key);
    if (text.empty())
        return std::optional<std::array<Number, 3>>();
    const auto numbers = parseThree<Number>(key, text);
    if (!numbers)
        return Error{ErrorKind::BadInput,
                     Message::say("its %1, '%2', is not three numbers. Correct the line.", key, printable(text))};
    return std::optional(*numbers);
}

Error bovMissing(const std::string& key)
{
    return {ErrorKind::BadInput, Message::say("its header has no line '%1:'. Add it.", key)};
}

Error bovWrong(const std::string& key, std::string_view value)
{
    return {ErrorKind::BadInput,
            Message::say("its %1, '%2', is not understood. Correct the line.", key, printable(value))};
}

bool isTrue(std::string_view value)
{
    return lowerCase(value) == "true" || value == "1";
}

/// Types by the beginnings of their names: FLOAT and FLOATS are one.
std::optional<StoredType> bovType(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, StoredType>, 9> names{{{"FLOAT", StoredType::Float32},
                                                                            {"REAL", StoredType::Float32},
                                                                            {"DOUBLE", StoredType::Float64},
                                                                            {"BYTE", StoredType::UInt8},
                                                                            {"CHAR", StoredType::UInt8},
                                                                            {"UCHAR", StoredType::UInt8},
                                                                            {"SHORT", StoredType::Int16},
                                                                            {"INT", StoredType::Int32},
                                                                            {"LONG", StoredType::Int64}}};
    for (const auto& [begin, type] : names)
        if (capitals(name).starts_with(begin))
            return type;
    return {};
}

Status takeTypes(const BovHeader& header, StoredVolume& volume)
{
    const std::string_view format = bovValue(header, "DATA_FORMAT");
    if (format.empty())
        return bovMissing("DATA_FORMAT");
    const auto type = bovType(format);
    if (!type)
        return bovWrong("DATA_FORMAT", format);
    volume.type = *type;
    const std::string order = capitals(bovValue(header, "DATA_ENDIAN"));
    if (!order.empty() && order != "LITTLE" && order != "BIG")
        return bovWrong("DATA_ENDIAN", order);
    if (!order.empty())
        volume.order = order == "LITTLE" ? std::endian::little : std::endian::big;
    else if (storedSize(*type) > 1)
        volume.remarks.push_back(
            Message::say("The file does not state the byte order of its numbers: that of this computer was assumed."));
    return {};
}

/// Bytes stand for numbers between two others, where the header names these.
Status takeScale(const BovHeader& header, StoredVolume& volume)
{
    double least = 0, most = 1;
    bool isSaid = false;
    for (const std::string prefix : {"VARIABLE_PALETTE_", "VARIABLE_"})
        for (const bool isMost : {false, true}) {
            const std::string key = prefix + (isMost ? "MAX" : "MIN");
            const std::string_view text = bovValue(header, key);
            if (text.empty())
                continue;
            const auto number = parseHeaderNumber(text);
            if (!number)
                return bovWrong(key, text);
            (isMost ? most : least) = *number;
            isSaid = true;
        }
    constexpr double largestByte = 255;
    if (isSaid && volume.type == StoredType::UInt8) {
        volume.intercept = least;
        volume.slope = (most - least) / largestByte;
        volume.remarks.push_back(
            Message::say("Its bytes from 0 to 255 were converted to the numbers from %1 to %2, as it states.",
                         formatNumber(least), formatNumber(most)));
    }
    return {};
}

/// The number of components; 2 for complex numbers.
Result<std::uint32_t> bovComponents(const BovHeader& header)
{
    constexpr std::uint32_t most = 1'000'000;
    const std::string text = capitals(bovValue(header, "DATA_COMPONENTS"));
    if (text.empty() || text.starts_with("COMPLEX"))
        return std::uint32_t(text.empty() ? 1 : 2);
    const auto number = parseNumber<std::uint32_t>(text);
    return number && *number > 0 && *number <= most ? Result<std::uint32_t>(*number)
                                                    : bovWrong("DATA_COMPONENTS", text);
}

/// BRICK_SIZE is the size of the whole: from the first point to the last one, or of all cells.
Status placeBov(const BovHeader& header, StoredVolume& volume)
{
    const auto whole = bovThree<double>(header, "BRICK_SIZE"), origin = bovThree<double>(header, "BRICK_ORIGIN");
    if (!whole || !origin)
        return whole ? origin.error() : whole.error();
    const std::string_view centering = bovValue(header, "CENTERING");
    const bool isOfCells = lowerCase(centering).find("zon") != std::string::npos;
    if (!centering.empty() && !isOfCells && lowerCase(centering).find("nod") == std::string::npos)
        return bovWrong("CENTERING", centering);
    volume.taken.push_back({TakenPart::Places,
                            isOfCells ? Message::say("the middles of the cells") : Message::say("the points"),
                            centering.empty()});
    volume.arrays.front().perCell = isOfCells;
    volume.untold = untoldPlacement(whole->has_value(), origin->has_value(), false);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double steps = volume.lattice.size[axis] - (isOfCells ? 0.0 : 1.0);
        if (*whole)
            volume.lattice.spacing[static_cast<Eigen::Index>(axis)] = (**whole)[axis] / steps;
        if (*origin)
            volume.lattice.origin[static_cast<Eigen::Index>(axis)] = (**origin)[axis];
    }
    if (isOfCells) {
        volume.stepsToOrigin = Eigen::Vector3d::Constant(0.5);
        volume.lattice.origin += volume.lattice.spacing / 2;
    }
    return {};
}

/// The name in which the number of a brick stands, of a brick that is the only one.
Result<std::string> bovFileName(const BovHeader& header, const std::array<std::uint32_t, 3>& size)
{
    const std::string name(bovValue(header, "DATA_FILE"));
    if (name.empty())
        return bovMissing("DATA_FILE");
    const std::size_t begin = name.find('%');
    const std::size_t end = begin == std::string::npos ? begin : name.find_first_not_of("0123456789", begin + 1);
    if (end == std::string::npos || name[end] != 'd')
        return name;
    const auto brick = bovThree<std::uint64_t>(header, "DATA_BRICKLETS");
    if (!brick)
        return brick.error();
    if (*brick && **brick != std::array<std::uint64_t, 3>{size[0], size[1], size[2]})
        return Error{ErrorKind::BadInput,
                     Message::say("its data are divided among several files, '%1'. Join them into one, or save the "
                                  "volume from VisIt as VTK.",
                                  printable(name))};
    constexpr std::size_t mostDigits = 20;
    const auto digits = parseNumber<std::size_t>(name.substr(begin + 1, end - begin - 1)).value_or(1);
    return name.substr(0, begin) + std::string(std::clamp<std::size_t>(digits, 1, mostDigits), '0') +
           name.substr(end + 1);
}

bool isGzipName(const std::string& name)
{
    return lowerCase(name).find(".gz") != std::string::npos;
}

Status takeFile(const VolumeRequest& request, const BovHeader& header, StoredVolume& volume)
{
    if (isTrue(bovValue(header, "HAS_BOUNDARY")))
        return Error{ErrorKind::BadInput, Message::say("its bricks repeat the values of their neighbours "
                                                       "(HAS_BOUNDARY), which is not read. Save the volume from VisIt "
                                                       "as VTK.")};
    const auto name = bovFileName(header, volume.lattice.size);
    if (!name)
        return name.error();
    const std::string_view offset = bovValue(header, "BYTE_OFFSET");
    const auto skipped = parseNumber<std::int64_t>(offset);
    constexpr std::int64_t farthest = std::int64_t(1) << 62;
    if (!offset.empty() && (!skipped || *skipped > farthest))
        return bovWrong("BYTE_OFFSET", offset);
    const auto bytes = static_cast<std::uint64_t>(std::max<std::int64_t>(skipped.value_or(0), 0));
    const bool isPacked = isGzipName(*name);
    (isPacked ? volume.unpackedOffset : volume.offset) = bytes;
    volume.files = {{request.path.parent_path() / *name, isPacked ? StoredPacking::Zlib : StoredPacking::None}};
    return {};
}

/// Lines that say nothing of what is read, or are used elsewhere.
void tellUnused(const BovHeader& header, StoredVolume& volume)
{
    constexpr std::array<std::string_view, 23> known = {"TIME",
                                                        "CYCLE",
                                                        "DATA_FILE",
                                                        "DATA_SIZE",
                                                        "DATA_FORMAT",
                                                        "DATA_COMPONENTS",
                                                        "DATA_BRICKLETS",
                                                        "VARIABLE",
                                                        "HAS_BOUNDARY",
                                                        "DATA_ENDIAN",
                                                        "VARIABLE_PALETTE_MIN",
                                                        "VARIABLE_PALETTE_MAX",
                                                        "VARIABLE_MIN",
                                                        "VARIABLE_MAX",
                                                        "BRICK_ORIGIN",
                                                        "BRICK_SIZE",
                                                        "VARIABLE_BRICK_MIN",
                                                        "VARIABLE_BRICK_MAX",
                                                        "CENTERING",
                                                        "BYTE_OFFSET",
                                                        "DIVIDE_BRICK",
                                                        "DATA_BRICKLET",
                                                        "BRICKLET_SIZE"};
    for (const auto& [key, value] : header)
        if (std::ranges::find(known, key) == known.end())
            volume.leftOut.push_back(Message::say("Its line '%1: %2' is not used.", printable(key), printable(value)));
}

} // namespace

bool looksLikeBov(std::string_view beginning)
{
    const std::string capital = capitals(beginning);
    return capital.find("DATA_FILE:") != std::string::npos && capital.find("DATA_SIZE:") != std::string::npos;
}

Result<StoredVolume> describeBov(const VolumeRequest& request)
{
    const auto header = bovHeader(request.text());
    if (!header)
        return header.error();
    StoredVolume volume;
    const auto components = bovComponents(*header);
    if (!components)
        return components.error();
    volume.components = *components;
    volume.arrays = {{.name = std::string(bovValue(*header, "VARIABLE")), .components = static_cast<int>(*components)}};
    const auto size = bovThree<std::uint64_t>(*header, "DATA_SIZE");
    if (!size || !*size)
        return size ? bovMissing("DATA_SIZE") : size.error();
    if (const Status typed = takeTypes(*header, volume); !typed)
        return typed.error();
    if (const Status set = setStoredSize(volume, **size, 1); !set)
        return set.error();
    if (const Status scaled = takeScale(*header, volume); !scaled)
        return scaled.error();
    if (const auto array = takeArray(volume, request.values); !array)
        return array.error();
    if (const Status chosen = takeComponent(volume, request.values); !chosen)
        return chosen.error();
    if (const Status placed = placeBov(*header, volume); !placed)
        return placed.error();
    if (const Status opened = takeFile(request, *header, volume); !opened)
        return opened.error();
    tellUnused(*header, volume);
    return volume;
}

std::vector<std::filesystem::path> companionsOfBov(const VolumeRequest& request)
{
    const auto header = bovHeader(request.text());
    const std::string_view name = header ? bovValue(*header, "DATA_FILE") : std::string_view();
    if (name.empty() || isGzipName(std::string(name)))
        return {};
    return {request.path.parent_path() / name};
}

} // namespace tetra
