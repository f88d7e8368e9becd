// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/metaimage/metaimage_volume.h"

#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/metaimage/metaimage_files.h"
#include "plugins/readers/lattice/metaimage/metaimage_header.h"
#include "plugins/readers/lattice/metaimage/metaimage_place.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tetra {

namespace {

using Sizes = std::vector<std::uint64_t>;

/// In files a long has 4 bytes, whatever the machine.
Result<StoredType> storedTypeOf(std::string_view type)
{
    constexpr std::string_view array = "_ARRAY";
    const std::string_view single = type.ends_with(array) ? type.substr(0, type.size() - array.size()) : type;
    constexpr std::array<std::pair<std::string_view, StoredType>, 12> known = {{{"MET_CHAR", StoredType::Int8},
                                                                                {"MET_UCHAR", StoredType::UInt8},
                                                                                {"MET_SHORT", StoredType::Int16},
                                                                                {"MET_USHORT", StoredType::UInt16},
                                                                                {"MET_INT", StoredType::Int32},
                                                                                {"MET_UINT", StoredType::UInt32},
                                                                                {"MET_LONG", StoredType::Int32},
                                                                                {"MET_ULONG", StoredType::UInt32},
                                                                                {"MET_LONG_LONG", StoredType::Int64},
                                                                                {"MET_ULONG_LONG", StoredType::UInt64},
                                                                                {"MET_FLOAT", StoredType::Float32},
                                                                                {"MET_DOUBLE", StoredType::Float64}}};
    const auto* const entry = std::ranges::find(known, single, &std::pair<std::string_view, StoredType>::first);
    if (entry != known.end())
        return entry->second;
    return Error{ErrorKind::BadInput,
                 type.empty()
                     ? Message::say("its header does not state its ElementType. It is cut short: copy the file again.")
                     : Message::say("its samples are of the type '%1', which is not read. Write them as "
                                    "MET_INT, MET_FLOAT or MET_DOUBLE.",
                                    printable(type))};
}

Result<Sizes> sizesOf(const MetaHeader& header)
{
    constexpr std::int64_t mostDimensions = 10; // as the library
    const auto dimensions = metaWholeNumber(header.text("NDims"));
    const std::string_view kind = header.text("ObjectType");
    if (!kind.empty() && kind != "Image" && !header.has("DimSize"))
        return Error{ErrorKind::BadInput,
                     Message::say("it holds no image: its ObjectType is '%1'. TAn reads only images of this format.",
                                  printable(kind))};
    if (!dimensions)
        return wrongMetaHeader(Message::say("its header has no NDims."));
    if (*dimensions < 3 || *dimensions > mostDimensions)
        return Error{ErrorKind::BadInput, Message::say("it has %1 dimensions, and a volume has three. Write its "
                                                       "pictures as one volume, or a part of it with three.",
                                                       *dimensions)};
    const auto words = split(header.text("DimSize"), " \t\r\n\v\f");
    Sizes sizes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(*dimensions); ++i) {
        const auto size = i < words.size() ? metaWholeNumber(words[i]) : std::nullopt;
        if (!size || *size < 1 || *size > std::int64_t(1) << 31)
            return wrongMetaHeader(Message::say("its DimSize is '%1' and not %2 numbers of points.",
                                                printable(header.text("DimSize")), *dimensions));
        sizes.push_back(static_cast<std::uint64_t>(*size));
    }
    return sizes;
}

Status setType(const MetaHeader& header, StoredVolume& volume)
{
    const std::string_view type = header.text("ElementType"), channelsText = header.text("ElementNumberOfChannels");
    const auto stored = storedTypeOf(type);
    if (!stored)
        return stored.error();
    const auto channels = channelsText.empty() ? std::optional<std::int64_t>(1) : metaWholeNumber(channelsText);
    if (!channels || *channels < 1 || *channels > 1'000'000)
        return wrongMetaHeader(Message::say("its ElementNumberOfChannels is '%1'.", printable(channelsText)));
    volume.type = *stored;
    volume.mayBeWider = type.starts_with("MET_LONG") ? *stored == StoredType::Int32
                                                     : type.starts_with("MET_ULONG") && *stored == StoredType::UInt32;
    volume.components = static_cast<std::uint32_t>(*channels);
    return {};
}

StoredPacking packingOf(const MetaHeader& header)
{
    if (!header.text("BinaryData").empty() && !header.isTrue("BinaryData")) // MetaIO: binary without it
        return StoredPacking::Text;
    return header.isTrue("CompressedData") ? StoredPacking::Zlib : StoredPacking::None;
}

/// Where a field does not say it, it is the order of the machine that reads.
void setOrder(const MetaHeader& header, StoredPacking packing, StoredVolume& volume)
{
    constexpr std::array names = {"ElementByteOrderMSB", "BinaryDataByteOrderMSB"}; // the last counts
    bool isTold = storedSize(volume.type) == 1 || packing == StoredPacking::Text;
    for (const char* name : names)
        if (header.has(name)) {
            volume.order = header.isTrue(name) ? std::endian::big : std::endian::little;
            isTold = true;
        }
    if (!isTold)
        volume.remarks.push_back(Message::say(
            "Its header does not state the byte order of its numbers: that of this machine was assumed, %1 endian.",
            volume.order == std::endian::big ? Message::say("big") : Message::say("little")));
}

/// Where in each file the samples, or what they are packed in, begin and end.
Status setPlaceInFile(const MetaHeader& header, StoredPacking packing, StoredVolume& volume)
{
    const bool isLocal = isLocalMetaImage(header);
    volume.offset = isLocal ? header.end : 0;
    if (const auto text = header.text("CompressedDataSize"); !text.empty() && packing == StoredPacking::Zlib)
        volume.packedBytes = static_cast<std::uint64_t>(std::max<std::int64_t>(0, metaWholeNumber(text).value_or(0)));
    const auto text = header.text("HeaderSize");
    if (text.empty())
        return {};
    const auto size = metaWholeNumber(text);
    if (!size || *size < -1)
        return wrongMetaHeader(Message::say("its HeaderSize is '%1'.", printable(text)));
    if (*size < 0 && packing != StoredPacking::None)
        return wrongMetaHeader(
            Message::say("its HeaderSize is -1, which has no meaning where samples are packed or text."));
    volume.atEndOfFile = *size < 0;
    if (*size < 0)
        volume.offset = 0;
    else if (*size > 0 && (packing != StoredPacking::Zlib || volume.packedBytes > 0)) // else as the library does
        volume.offset = static_cast<std::uint64_t>(*size);
    return {};
}

/// What the header says besides, and is not used.
void tellOthers(const MetaHeader& header, StoredVolume& volume)
{
    const auto slope = metaNumbers(header, {"ElementToIntensityFunctionSlope"}, 1);
    const auto offset = metaNumbers(header, {"ElementToIntensityFunctionOffset"}, 1);
    const double factor = slope && *slope ? (**slope)[0] : 1, added = offset && *offset ? (**offset)[0] : 0;
    if (factor != 1 || added != 0)
        volume.leftOut.push_back(Message::say(
            "Its header states how intensities follow from samples (times %1, plus %2), which was not applied.",
            formatNumber(factor), formatNumber(added)));
    if (const auto centre = metaNumbers(header, {"CenterOfRotation"}, 3);
        centre && *centre && std::ranges::any_of(**centre, [](double part) { return part != 0; }))
        volume.leftOut.push_back(Message::say("Its CenterOfRotation was not used: a sample lies at Offset plus its "
                                              "directions times its distances, as in ITK."));
}

Status setSteps(const MetaHeader& header, const Sizes& sizes, const ParameterValues& values, StoredVolume& volume)
{
    std::uint64_t steps = 1;
    for (const std::uint64_t size : std::span(sizes).subspan(3))
        steps = cappedProduct(steps, size);
    if (const Status fits = setStoredSize(volume, {sizes[0], sizes[1], sizes[2]}, steps); !fits)
        return fits;
    if (sizes.size() == 4) {
        auto times = metaTimes(header, steps);
        if (!times)
            return times.error();
        volume.timeSteps = *std::move(times);
    }
    if (const Status taken = takeComponent(volume, values); !taken)
        return taken;
    return takeTimeStep(volume, values, steps, volume.numbers / steps);
}

} // namespace

Result<StoredVolume> metaImageVolume(const VolumeRequest& request)
{
    const auto header = metaHeaderOf(request.text());
    if (!header)
        return header.error();
    const auto sizes = sizesOf(*header);
    if (!sizes)
        return sizes.error();
    StoredVolume volume;
    if (const Status known = setType(*header, volume); !known)
        return known.error();
    if (const Status known = setSteps(*header, *sizes, request.values, volume); !known)
        return known.error();
    const StoredPacking packing = packingOf(*header);
    setOrder(*header, packing, volume);
    volume.isTextOfMetaIo = true;
    volume.rest = packing == StoredPacking::Text ? StoredRest::Ignored : StoredRest::Told;
    if (const Status known = setPlaceInFile(*header, packing, volume); !known)
        return known.error();
    if (const Status placed = placeMetaImage(*header, sizes->size(), volume); !placed)
        return placed.error();
    tellOthers(*header, volume);
    auto files = metaDataFiles(*header, request.text(), *sizes, request.path, packing);
    if (!files)
        return files.error();
    volume.files = *std::move(files);
    return volume;
}

std::vector<std::filesystem::path> metaImageCompanions(const VolumeRequest& request)
{
    const auto header = metaHeaderOf(request.text());
    const auto sizes = header ? sizesOf(*header) : header.error();
    const auto names = sizes ? metaDataFileNames(*header, request.text(), *sizes) : sizes.error();
    return names && names->size() == 1 ? std::vector<std::filesystem::path>{request.path.parent_path() / names->front()}
                                       : std::vector<std::filesystem::path>();
}

bool looksLikeMetaImage(std::string_view firstBytes)
{
    const auto hasField = [&](std::string_view name) {
        for (auto place = firstBytes.find(name); place != std::string_view::npos;
             place = firstBytes.find(name, place + 1))
            if ((place == 0 || firstBytes[place - 1] == '\n') &&
                trimmed(firstBytes.substr(place + name.size(), 8)).starts_with('='))
                return true;
        return false;
    };
    return hasField("NDims") && hasField("DimSize") && hasField("ElementType");
}

} // namespace tetra
