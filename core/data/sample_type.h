// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace tetra {

/// The type of a sample as it stands in a file and in memory. The numbers are part of the `.tan` format.
enum class SampleType : std::uint8_t {
    UInt8 = 0,
    Int8 = 1,
    UInt16 = 2,
    Int16 = 3,
    UInt32 = 4,
    Int32 = 5,
    Float32 = 6,
    Float64 = 7
};

constexpr std::size_t sampleSize(SampleType type) noexcept
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

constexpr bool isInteger(SampleType type) noexcept
{
    return type < SampleType::Float32;
}

/// The name that NRRD and the command line use: "uint8", "int16", "float", "double" ...
constexpr std::string_view sampleTypeName(SampleType type) noexcept
{
    constexpr std::string_view names[] = {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float", "double"};
    return names[static_cast<std::size_t>(type)];
}

/// Calls `function.operator()<T>()` with the C++ type of `type` and returns what it returns.
template <class Function> decltype(auto) visitSampleType(SampleType type, Function&& function)
{
    switch (type) {
    case SampleType::UInt8: return function.template operator()<std::uint8_t>();
    case SampleType::Int8: return function.template operator()<std::int8_t>();
    case SampleType::UInt16: return function.template operator()<std::uint16_t>();
    case SampleType::Int16: return function.template operator()<std::int16_t>();
    case SampleType::UInt32: return function.template operator()<std::uint32_t>();
    case SampleType::Int32: return function.template operator()<std::int32_t>();
    case SampleType::Float32: return function.template operator()<float>();
    case SampleType::Float64: break;
    }
    return function.template operator()<double>();
}

} // namespace tetra
