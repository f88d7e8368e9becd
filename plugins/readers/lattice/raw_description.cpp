// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/raw_description.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/raw_guess.h"

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
         {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float", "double"}},
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

Result<SampleLayout> rawLayout(const ParameterValues& values, std::string_view fileName, std::uint64_t fileBytes)
{
    const std::vector<Parameter> parameters = rawParameters();
    const auto text = [&](const std::string& id) { return parameterValue<std::string>(parameters, values, id); };
    const auto skip = parameterValue<std::int64_t>(parameters, values, "skip");
    if (skip < 0)
        return wrongUsage(Message::say("the number of bytes to skip cannot be negative."));
    SampleLayout layout;
    layout.skippedBytes = static_cast<std::uint64_t>(skip);
    if (!describesSize(values))
        return sizeIsMissing(fileName, fileBytes - std::min(fileBytes, layout.skippedBytes));
    const auto size = parseThree<std::uint64_t>("size", text("size"));
    if (!size)
        return size.error();
    if (const Status checked = checkLatticeSize(*size); !checked)
        return checked.error();
    for (std::size_t axis = 0; axis < 3; ++axis)
        layout.lattice.size[axis] = static_cast<std::uint32_t>((*size)[axis]);
    const Result<SampleType> type = parseSampleType(text("type"));
    if (!type)
        return wrongUsage(type.error().message);
    layout.type = *type;
    const Result<std::endian> order = parseByteOrder(text("byte-order"));
    if (!order)
        return wrongUsage(order.error().message);
    layout.order = *order;
    layout.untold = untoldPlacement(false, false, false);
    return layout;
}

} // namespace tetra
