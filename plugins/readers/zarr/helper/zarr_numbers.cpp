// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace tetra {
namespace {

struct NumberNames {
    ZarrNumber number;
    std::string_view version2; ///< without the order of bytes
    std::string_view version3;
    std::size_t stored;
};
constexpr std::array<NumberNames, 12> numberNames = {{{ZarrNumber::UInt8, "u1", "uint8", 1},
                                                      {ZarrNumber::UInt8, "b1", "bool", 1},
                                                      {ZarrNumber::Int8, "i1", "int8", 1},
                                                      {ZarrNumber::UInt16, "u2", "uint16", 2},
                                                      {ZarrNumber::Int16, "i2", "int16", 2},
                                                      {ZarrNumber::UInt32, "u4", "uint32", 4},
                                                      {ZarrNumber::Int32, "i4", "int32", 4},
                                                      {ZarrNumber::UInt64, "u8", "uint64", 8},
                                                      {ZarrNumber::Int64, "i8", "int64", 8},
                                                      {ZarrNumber::Float16, "f2", "float16", 2},
                                                      {ZarrNumber::Float32, "f4", "float32", 4},
                                                      {ZarrNumber::Float64, "f8", "float64", 8}}};

template <class T> std::vector<std::byte> bytesOf(T value)
{
    std::vector<std::byte> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

template <class T> T valueOf(const std::vector<std::byte>& bytes)
{
    T value{};
    std::memcpy(&value, bytes.data(), std::min(bytes.size(), sizeof value));
    return value;
}

/// A JSON number, or one of those that JSON has no number for.
std::optional<double> doubleOf(const QJsonValue& value)
{
    if (value.isBool())
        return value.toBool() ? 1 : 0;
    if (value.isDouble())
        return value.toDouble();
    const QString text = value.toString();
    if (text == QLatin1String("NaN"))
        return std::numeric_limits<double>::quiet_NaN();
    if (text == QLatin1String("Infinity") || text == QLatin1String("-Infinity"))
        return (text.startsWith('-') ? -1 : 1) * std::numeric_limits<double>::infinity();
    return std::nullopt;
}

/// The bits of a floating point number of so many bytes: "0x7fc00000".
std::optional<std::uint64_t> bitsOf(const QJsonValue& value, std::size_t bytes)
{
    const std::string text = value.toString().toStdString();
    if (!text.starts_with("0x") || text.size() != 2 + 2 * bytes)
        return std::nullopt;
    std::uint64_t bits = 0;
    const auto [end, problem] = std::from_chars(text.data() + 2, text.data() + text.size(), bits, 16);
    return problem == std::errc() && end == text.data() + text.size() ? std::optional(bits) : std::nullopt;
}

template <class T> std::optional<std::vector<std::byte>> wholeNumber(const QJsonValue& value)
{
    const auto number = doubleOf(value);
    if (!number || !(std::floor(*number) == *number))
        return std::nullopt;
    // The largest whole number of 64 bits is no double; the power of two above it is.
    constexpr double end = 2.0 * (std::uint64_t(1) << (std::numeric_limits<T>::digits - 1));
    if (*number >= end)
        return sizeof(T) == 8 && *number == end ? std::optional(bytesOf(std::numeric_limits<T>::max())) : std::nullopt;
    if (*number < static_cast<double>(std::numeric_limits<T>::min()))
        return std::nullopt;
    if (std::abs(*number) < 9e15)
        return bytesOf(static_cast<T>(*number));
    const qint64 exact = value.toInteger(0); // what is above is a double already
    return bytesOf(exact != 0 ? static_cast<T>(exact) : static_cast<T>(*number));
}

} // namespace

std::size_t storedSize(ZarrNumber number) noexcept
{
    return std::ranges::find(numberNames, number, &NumberNames::number)->stored;
}

std::size_t keptSize(ZarrNumber number) noexcept
{
    return number == ZarrNumber::Float16 ? sizeof(float) : storedSize(number);
}

std::optional<SampleType> sampleTypeOf(ZarrNumber number) noexcept
{
    switch (number) {
    case ZarrNumber::UInt8: return SampleType::UInt8;
    case ZarrNumber::Int8: return SampleType::Int8;
    case ZarrNumber::UInt16: return SampleType::UInt16;
    case ZarrNumber::Int16: return SampleType::Int16;
    case ZarrNumber::UInt32: return SampleType::UInt32;
    case ZarrNumber::Int32: return SampleType::Int32;
    case ZarrNumber::Float16:
    case ZarrNumber::Float32: return SampleType::Float32;
    case ZarrNumber::Float64: return SampleType::Float64;
    case ZarrNumber::UInt64:
    case ZarrNumber::Int64: break;
    }
    return std::nullopt;
}

std::optional<ZarrNumberText> zarrNumberOfVersion2(std::string_view text)
{
    if (text.size() != 3 || std::string_view("<>|=").find(text[0]) == std::string_view::npos)
        return std::nullopt;
    const auto* found = std::ranges::find(numberNames, text.substr(1), &NumberNames::version2);
    if (found == numberNames.end() || (text[0] == '|' && found->stored > 1))
        return std::nullopt;
    return ZarrNumberText{found->number, text[0] == '>'};
}

std::optional<ZarrNumber> zarrNumberOfVersion3(std::string_view name)
{
    const auto* found = std::ranges::find(numberNames, name, &NumberNames::version3);
    return found == numberNames.end() ? std::nullopt : std::optional(found->number);
}

float floatOfHalf(std::uint16_t half) noexcept
{
    constexpr int mostExponent = 31, bias = 15, fractionBits = 10;
    const int exponent = half >> fractionBits & mostExponent;
    const int fraction = half & 0x3ff;
    const float sign = (half & 0x8000) != 0 ? -1.0F : 1.0F;
    if (exponent == mostExponent)
        return fraction != 0 ? std::numeric_limits<float>::quiet_NaN() : sign * std::numeric_limits<float>::infinity();
    const int whole = exponent == 0 ? fraction : fraction + 0x400;
    return sign * std::ldexp(static_cast<float>(whole), std::max(exponent, 1) - bias - fractionBits);
}

std::optional<std::vector<std::byte>> keptNumber(ZarrNumber number, const QJsonValue& value)
{
    const auto bits = bitsOf(value, storedSize(number));
    const auto floating = doubleOf(value);
    switch (number) {
    case ZarrNumber::UInt8: return wholeNumber<std::uint8_t>(value);
    case ZarrNumber::Int8: return wholeNumber<std::int8_t>(value);
    case ZarrNumber::UInt16: return wholeNumber<std::uint16_t>(value);
    case ZarrNumber::Int16: return wholeNumber<std::int16_t>(value);
    case ZarrNumber::UInt32: return wholeNumber<std::uint32_t>(value);
    case ZarrNumber::Int32: return wholeNumber<std::int32_t>(value);
    case ZarrNumber::UInt64: return wholeNumber<std::uint64_t>(value);
    case ZarrNumber::Int64: return wholeNumber<std::int64_t>(value);
    case ZarrNumber::Float16:
        if (bits)
            return bytesOf(floatOfHalf(static_cast<std::uint16_t>(*bits)));
        [[fallthrough]];
    case ZarrNumber::Float32:
        if (bits)
            return bytesOf(std::bit_cast<float>(static_cast<std::uint32_t>(*bits)));
        return floating ? std::optional(bytesOf(static_cast<float>(*floating))) : std::nullopt;
    case ZarrNumber::Float64: break;
    }
    if (bits)
        return bytesOf(std::bit_cast<double>(*bits));
    return floating ? std::optional(bytesOf(*floating)) : std::nullopt;
}

std::string keptNumberText(ZarrNumber number, const std::vector<std::byte>& bytes)
{
    switch (number) {
    case ZarrNumber::UInt8: return std::to_string(valueOf<std::uint8_t>(bytes));
    case ZarrNumber::Int8: return std::to_string(valueOf<std::int8_t>(bytes));
    case ZarrNumber::UInt16: return std::to_string(valueOf<std::uint16_t>(bytes));
    case ZarrNumber::Int16: return std::to_string(valueOf<std::int16_t>(bytes));
    case ZarrNumber::UInt32: return std::to_string(valueOf<std::uint32_t>(bytes));
    case ZarrNumber::Int32: return std::to_string(valueOf<std::int32_t>(bytes));
    case ZarrNumber::UInt64: return std::to_string(valueOf<std::uint64_t>(bytes));
    case ZarrNumber::Int64: return std::to_string(valueOf<std::int64_t>(bytes));
    case ZarrNumber::Float16:
    case ZarrNumber::Float32: return formatNumber(valueOf<float>(bytes));
    case ZarrNumber::Float64: break;
    }
    return formatNumber(valueOf<double>(bytes));
}

} // namespace tetra
