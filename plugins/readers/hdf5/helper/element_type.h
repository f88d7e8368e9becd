// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/helper/hdf5_id.h"

#include <tan/data.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// The numbers that the library converts stored ones to: of their sign, and of at least their size.
enum class NumberKind : std::uint8_t { None, Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float, Double };

/// Calls `function.operator()<T>()` with the C++ type of a kind, which is not None.
template <class Function> decltype(auto) visitNumber(NumberKind kind, Function&& function)
{
    switch (kind) {
    case NumberKind::Int8: return function.template operator()<std::int8_t>();
    case NumberKind::UInt8: return function.template operator()<std::uint8_t>();
    case NumberKind::Int16: return function.template operator()<std::int16_t>();
    case NumberKind::UInt16: return function.template operator()<std::uint16_t>();
    case NumberKind::Int32: return function.template operator()<std::int32_t>();
    case NumberKind::UInt32: return function.template operator()<std::uint32_t>();
    case NumberKind::Int64: return function.template operator()<std::int64_t>();
    case NumberKind::UInt64: return function.template operator()<std::uint64_t>();
    case NumberKind::Float: return function.template operator()<float>();
    default: return function.template operator()<double>();
    }
}

std::size_t numberBytes(NumberKind kind);

/// The library's type of such a number in memory; not to be closed.
hid_t memoryType(NumberKind kind);

/// What an element of an array is.
struct ElementType {
    NumberKind kind = NumberKind::None; ///< None: not a number, nor several
    std::uint64_t components = 1;       ///< of which it consists
    std::vector<std::string> members{}; ///< their names, of records such as complex numbers; else empty
    std::vector<hsize_t> shape{};       ///< of elements that are arrays themselves; else empty
    bool losesDigits = false;           ///< stored numbers have more than a double
    std::string text{};                 ///< "float", "uint16", "2 x double", "text"
};

ElementType elementTypeOf(hid_t type);

} // namespace tetra
