// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/raw_description.h"

#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/raw_guess.h"

#include <string>

namespace tetra {

namespace {

Error wrongUsage(const Message& text)
{
    return {ErrorKind::WrongUsage, text};
}

/// Three numbers with 'x', commas or blanks between them.
template <class Number> Result<std::array<Number, 3>> parseThree(const std::string& id, const std::string& text)
{
    const std::vector<std::string_view> words = split(text, "xX*, \t");
    std::array<Number, 3> numbers{};
    bool understood = words.size() == 3;
    for (std::size_t i = 0; understood && i < 3; ++i) {
        const auto number = parseNumber<Number>(words[i]);
        understood = number.has_value();
        numbers[i] = number.value_or(Number{});
    }
    if (!understood)
        return wrongUsage(
            Message::say("'%1' for '%2' is not understood. Give three numbers, along x, y and z, as in 64x64x32.",
                         printable(text), id));
    return numbers;
}

Result<Eigen::Vector3d> parsePlace(const std::string& id, const std::string& text)
{
    const auto numbers = parseThree<double>(id, text);
    if (!numbers)
        return numbers.error();
    return Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
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

Status parsePlacement(const std::vector<Parameter>& parameters, const ParameterValues& values, Lattice& lattice)
{
    const auto spacing = parsePlace("spacing", parameterValue<std::string>(parameters, values, "spacing"));
    if (!spacing)
        return spacing.error();
    const auto origin = parsePlace("origin", parameterValue<std::string>(parameters, values, "origin"));
    if (!origin)
        return origin.error();
    lattice.spacing = *spacing;
    lattice.origin = *origin;
    return checkLatticePlacement(lattice);
}

} // namespace

std::vector<Parameter> rawParameters()
{
    const std::string text;
    return {
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
        {"spacing",
         Message::marked("Spacing"),
         Message::marked("Raw files: the distance of neighbouring points along x, y and z, as in 1x1x2.5."),
         "",
         std::string("1x1x1"),
         0,
         0,
         {}},
        {"origin",
         Message::marked("Origin"),
         Message::marked("Raw files: the position of the first point, as in 0,0,0."),
         "",
         std::string("0,0,0"),
         0,
         0,
         {}},
    };
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
    if (const Status placed = parsePlacement(parameters, values, layout.lattice); !placed)
        return placed.error();
    return layout;
}

} // namespace tetra
