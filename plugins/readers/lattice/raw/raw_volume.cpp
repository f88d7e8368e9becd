// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/raw/raw_volume.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/nrrd/nrrd_types.h"
#include "plugins/readers/lattice/raw/raw_guess.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace tetra {

namespace {

Error wrongUsage(const Message& text)
{
    return {ErrorKind::WrongUsage, text};
}

Error sizeIsMissing(std::string_view fileName, std::uint64_t fileBytes)
{
    Message examples;
    for (const RawGuess& guess : guessRawLayouts(fileName, fileBytes)) {
        const std::string example = "--size " + std::to_string(guess.size[0]) + "x" + std::to_string(guess.size[1]) +
                                    "x" + std::to_string(guess.size[2]) + " --type " +
                                    std::string(sampleTypeName(guess.type));
        examples = examples.empty() ? Message(example) : Message::say("%1, or %2", examples, example);
    }
    if (examples.empty())
        examples = "--size 256x256x128 --type uint8";
    return wrongUsage(Message::say("it is raw data, whose %1 bytes do not say how they are laid out. Describe them: "
                                   "size and type at least, for example %2.",
                                   fileBytes, examples));
}

} // namespace

std::vector<Parameter> rawParameters()
{
    const std::string text;
    std::vector<Parameter> parameters{
        {"size",
         Message::marked("Size"),
         Message::marked("Raw files: the number of points along x (which runs fastest), y and z, as in 256x256x128."),
         Message::marked("points"),
         text,
         0,
         0,
         {}},
        {"type",
         Message::marked("Type"),
         Message::marked("Raw files: the type of a sample."),
         "",
         std::string("uint8"),
         0,
         0,
         {"uint8", "int8", "uint16", "int16", "uint32", "int32", "int64", "uint64", "float", "double"}},
        {"byte-order",
         Message::marked("Byte order"),
         Message::marked("Raw files: little (PC) or big endian, for types of more than one byte."),
         "",
         std::string("little"),
         0,
         0,
         {Message::marked("little"), Message::marked("big")}},
        {"skip",
         Message::marked("Skip"),
         Message::marked("Raw files: the length of a header before the samples."),
         Message::marked("bytes"),
         std::int64_t(0),
         0,
         1e15,
         {}},
    };
    std::ranges::move(placementParameters(), std::back_inserter(parameters));
    return parameters;
}

bool describesSize(const ParameterValues& values)
{
    return !trimmed(parameterValue<std::string>(rawParameters(), values, "size")).empty();
}

Result<StoredVolume> rawVolume(const VolumeRequest& request)
{
    const std::vector<Parameter> parameters = rawParameters();
    const auto text = [&](const std::string& id) {
        return parameterValue<std::string>(parameters, request.values, id);
    };
    const auto skip = parameterValue<std::int64_t>(parameters, request.values, "skip");
    if (skip < 0)
        return wrongUsage(Message::say("the number of bytes to skip cannot be negative."));
    StoredVolume volume;
    volume.offset = static_cast<std::uint64_t>(skip);
    const std::uint64_t bytes = request.file->bytes().size();
    if (!describesSize(request.values))
        return sizeIsMissing(request.path.filename().string(), bytes - std::min(bytes, volume.offset));
    const auto size = parseThree<std::uint64_t>("size", text("size"));
    if (!size)
        return size.error();
    const Result<StoredType> type = parseStoredType(text("type"));
    if (!type)
        return wrongUsage(type.error().message);
    volume.type = *type;
    if (const Status fits = setStoredSize(volume, *size, 1); !fits)
        return fits.error();
    const Result<std::endian> order = parseByteOrder(text("byte-order"));
    if (!order)
        return wrongUsage(order.error().message);
    volume.order = *order;
    volume.files = {{request.path}};
    volume.rest = StoredRest::Refused;
    volume.untold = untoldPlacement(false, false, false);
    return volume;
}

} // namespace tetra
