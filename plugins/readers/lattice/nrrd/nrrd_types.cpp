// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd/nrrd_types.h"

#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace tetra {

namespace {

struct NamedType {
    std::string_view name;
    StoredType type;
};

constexpr std::array<NamedType, 42> typeNames = {{{"signed char", StoredType::Int8},
                                                  {"int8", StoredType::Int8},
                                                  {"int8_t", StoredType::Int8},
                                                  {"uchar", StoredType::UInt8},
                                                  {"unsigned char", StoredType::UInt8},
                                                  {"uint8", StoredType::UInt8},
                                                  {"uint8_t", StoredType::UInt8},
                                                  {"short", StoredType::Int16},
                                                  {"short int", StoredType::Int16},
                                                  {"signed short", StoredType::Int16},
                                                  {"signed short int", StoredType::Int16},
                                                  {"int16", StoredType::Int16},
                                                  {"int16_t", StoredType::Int16},
                                                  {"ushort", StoredType::UInt16},
                                                  {"unsigned short", StoredType::UInt16},
                                                  {"unsigned short int", StoredType::UInt16},
                                                  {"uint16", StoredType::UInt16},
                                                  {"uint16_t", StoredType::UInt16},
                                                  {"int", StoredType::Int32},
                                                  {"signed int", StoredType::Int32},
                                                  {"int32", StoredType::Int32},
                                                  {"int32_t", StoredType::Int32},
                                                  {"uint", StoredType::UInt32},
                                                  {"unsigned int", StoredType::UInt32},
                                                  {"uint32", StoredType::UInt32},
                                                  {"uint32_t", StoredType::UInt32},
                                                  {"float", StoredType::Float32},
                                                  {"float32", StoredType::Float32},
                                                  {"double", StoredType::Float64},
                                                  {"float64", StoredType::Float64},
                                                  {"longlong", StoredType::Int64},
                                                  {"long long", StoredType::Int64},
                                                  {"long long int", StoredType::Int64},
                                                  {"signed long long", StoredType::Int64},
                                                  {"signed long long int", StoredType::Int64},
                                                  {"int64", StoredType::Int64},
                                                  {"int64_t", StoredType::Int64},
                                                  {"ulonglong", StoredType::UInt64},
                                                  {"unsigned long long", StoredType::UInt64},
                                                  {"unsigned long long int", StoredType::UInt64},
                                                  {"uint64", StoredType::UInt64},
                                                  {"uint64_t", StoredType::UInt64}}};

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

Result<StoredType> parseStoredType(std::string_view name)
{
    const std::string wanted = normalised(name);
    if (const auto found = std::ranges::find(typeNames, wanted, &NamedType::name); found != typeNames.end())
        return found->type;
    if (wanted == "block")
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "its type is 'block', which does not describe the samples. Convert them to a number type first.")};
    return Error{ErrorKind::BadInput, Message::say("its type '%1' is not known. Use uint8, int8, uint16, int16, "
                                                   "uint32, int32, int64, uint64, float or double.",
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
                 Message::say("its byte order '%1' is not known. Use little or big.", printable(name))};
}

Result<StoredPacking> parsePacking(std::string_view name)
{
    constexpr std::array<std::string_view, 1> raw = {"raw"};
    constexpr std::array<std::string_view, 2> gzip = {"gz", "gzip"};
    constexpr std::array<std::string_view, 3> text = {"txt", "text", "ascii"};
    const std::string wanted = normalised(name);
    if (contains(raw, wanted))
        return StoredPacking::None;
    if (contains(gzip, wanted))
        return StoredPacking::Zlib;
    if (contains(text, wanted))
        return StoredPacking::Text;
    return Error{
        ErrorKind::BadInput,
        Message::say("its encoding '%1' is not read. Save it with the encoding raw, gzip or ascii.", printable(name))};
}

} // namespace tetra
