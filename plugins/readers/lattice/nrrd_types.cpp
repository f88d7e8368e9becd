// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd_types.h"

#include "plugins/readers/lattice/field_text.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace tetra {

namespace {

struct NamedType {
    std::string_view name;
    SampleType type;
};

constexpr std::array<NamedType, 30> typeNames = {{{"signed char", SampleType::Int8},
                                                  {"int8", SampleType::Int8},
                                                  {"int8_t", SampleType::Int8},
                                                  {"uchar", SampleType::UInt8},
                                                  {"unsigned char", SampleType::UInt8},
                                                  {"uint8", SampleType::UInt8},
                                                  {"uint8_t", SampleType::UInt8},
                                                  {"short", SampleType::Int16},
                                                  {"short int", SampleType::Int16},
                                                  {"signed short", SampleType::Int16},
                                                  {"signed short int", SampleType::Int16},
                                                  {"int16", SampleType::Int16},
                                                  {"int16_t", SampleType::Int16},
                                                  {"ushort", SampleType::UInt16},
                                                  {"unsigned short", SampleType::UInt16},
                                                  {"unsigned short int", SampleType::UInt16},
                                                  {"uint16", SampleType::UInt16},
                                                  {"uint16_t", SampleType::UInt16},
                                                  {"int", SampleType::Int32},
                                                  {"signed int", SampleType::Int32},
                                                  {"int32", SampleType::Int32},
                                                  {"int32_t", SampleType::Int32},
                                                  {"uint", SampleType::UInt32},
                                                  {"unsigned int", SampleType::UInt32},
                                                  {"uint32", SampleType::UInt32},
                                                  {"uint32_t", SampleType::UInt32},
                                                  {"float", SampleType::Float32},
                                                  {"float32", SampleType::Float32},
                                                  {"double", SampleType::Float64},
                                                  {"float64", SampleType::Float64}}};

constexpr std::array<std::string_view, 12> wideIntegers = {
    "longlong", "long long", "long long int", "signed long long",   "signed long long int",
    "int64",    "int64_t",   "ulonglong",     "unsigned long long", "unsigned long long int",
    "uint64",   "uint64_t"};

/// In lower case, with single blanks.
std::string normalised(std::string_view name)
{
    std::string result;
    for (const std::string_view word : split(name, " \t"))
        result += (result.empty() ? "" : " ") + lowerCase(word);
    return result;
}

bool contains(std::span<const std::string_view> names, std::string_view name)
{
    return std::ranges::find(names, name) != names.end();
}

} // namespace

Result<SampleType> parseSampleType(std::string_view name)
{
    const std::string wanted = normalised(name);
    if (const auto found = std::ranges::find(typeNames, wanted, &NamedType::name); found != typeNames.end())
        return found->type;
    if (contains(wideIntegers, wanted))
        return Error{ErrorKind::BadInput,
                     Message::say("its type is '%1'. Integers of 64 bits are not read, since computing with them is "
                                  "not exact: convert the samples to int32 or double first.",
                                  wanted)};
    if (wanted == "block")
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "its type is 'block', which says nothing about the samples. Convert them to a number type first.")};
    return Error{
        ErrorKind::BadInput,
        Message::say(
            "its type '%1' is not known. There are uint8, int8, uint16, int16, uint32, int32, float and double.",
            printable(name))};
}

Result<std::endian> parseByteOrder(std::string_view name)
{
    const std::string wanted = normalised(name);
    if (wanted == "little")
        return std::endian::little;
    if (wanted == "big")
        return std::endian::big;
    return Error{ErrorKind::BadInput,
                 Message::say("its byte order '%1' is not known. There are little and big.", printable(name))};
}

Result<SampleEncoding> parseSampleEncoding(std::string_view name)
{
    constexpr std::array<std::string_view, 1> raw = {"raw"};
    constexpr std::array<std::string_view, 2> gzip = {"gz", "gzip"};
    constexpr std::array<std::string_view, 3> text = {"txt", "text", "ascii"};
    const std::string wanted = normalised(name);
    if (contains(raw, wanted))
        return SampleEncoding::Raw;
    if (contains(gzip, wanted))
        return SampleEncoding::Gzip;
    if (contains(text, wanted))
        return SampleEncoding::Text;
    return Error{
        ErrorKind::BadInput,
        Message::say("its encoding '%1' is not read. Save it with the encoding raw, gzip or ascii.", printable(name))};
}

} // namespace tetra
