// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <QJsonValue>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The types of numbers that arrays of Zarr have and TAn reads. Truth values are UInt8.
enum class ZarrNumber : std::uint8_t {
    UInt8,
    Int8,
    UInt16,
    Int16,
    UInt32,
    Int32,
    UInt64,
    Int64,
    Float16,
    Float32,
    Float64
};

/// Bytes of a number in a chunk.
std::size_t storedSize(ZarrNumber number) noexcept;

/// Bytes of a number in memory: halves are kept as floats.
std::size_t keptSize(ZarrNumber number) noexcept;

/// The type of the samples that come of it; nothing of 64-bit integers, where it depends on the numbers.
std::optional<SampleType> sampleTypeOf(ZarrNumber number) noexcept;

/// Of version 2: the type and the order of bytes of "<u2"; nothing if TAn does not read such numbers.
struct ZarrNumberText {
    ZarrNumber number = ZarrNumber::UInt8;
    bool isBigEndian = false;
};
std::optional<ZarrNumberText> zarrNumberOfVersion2(std::string_view text);

/// Of version 3: the type called "uint16".
std::optional<ZarrNumber> zarrNumberOfVersion3(std::string_view name);

/// The float that has the value of a half.
float floatOfHalf(std::uint16_t half) noexcept;

/// A number of the metadata in the bytes of memory: a number, a truth value, "NaN", "Infinity", "-Infinity", or of
/// version 3 the bits of a floating point number ("0x7fc00000"). Nothing if it is none, or does not fit the type.
std::optional<std::vector<std::byte>> keptNumber(ZarrNumber number, const QJsonValue& value);

/// Such bytes as a text for messages.
std::string keptNumberText(ZarrNumber number, const std::vector<std::byte>& bytes);

} // namespace tetra
