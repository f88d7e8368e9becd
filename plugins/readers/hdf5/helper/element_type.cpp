// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/element_type.h"

#include <algorithm>
#include <array>

namespace tetra {
namespace {

constexpr std::uint64_t mostComponents = 64;

NumberKind integerKind(std::size_t bytes, bool isSigned)
{
    if (bytes == 0 || bytes > 8)
        return NumberKind::None;
    if (bytes == 1)
        return isSigned ? NumberKind::Int8 : NumberKind::UInt8;
    if (bytes == 2)
        return isSigned ? NumberKind::Int16 : NumberKind::UInt16;
    if (bytes <= 4)
        return isSigned ? NumberKind::Int32 : NumberKind::UInt32;
    return isSigned ? NumberKind::Int64 : NumberKind::UInt64;
}

std::string numberText(NumberKind kind, const std::string& name, std::size_t bytes)
{
    return kind == NumberKind::Float && bytes == 4    ? "float"
           : kind == NumberKind::Double && bytes == 8 ? "double"
                                                      : name + std::to_string(8 * bytes);
}

ElementType integerType(hid_t type)
{
    const std::size_t bytes = H5Tget_size(type);
    const bool isSigned = H5Tget_sign(type) == H5T_SGN_2;
    const NumberKind kind = integerKind(bytes, isSigned);
    return {.kind = kind, .text = numberText(kind, isSigned ? "int" : "uint", bytes)};
}

ElementType floatType(hid_t type)
{
    const std::size_t bytes = H5Tget_size(type);
    const NumberKind kind = bytes <= 4 ? NumberKind::Float : NumberKind::Double;
    return {.kind = kind, .losesDigits = bytes > 8, .text = numberText(kind, "float", bytes)};
}

/// Several numbers of one kind: of different ones, doubles.
void join(ElementType& all, const ElementType& one)
{
    all.kind = all.kind == NumberKind::None || all.kind == one.kind ? one.kind : NumberKind::Double;
    all.losesDigits |= one.losesDigits;
}

ElementType recordType(hid_t type)
{
    const int count = H5Tget_nmembers(type);
    ElementType record{.text = "records"};
    if (count < 1 || std::uint64_t(count) > mostComponents)
        return record;
    for (unsigned at = 0; at < static_cast<unsigned>(count); ++at) {
        const Hdf5Id member(H5Tget_member_type(type, at), H5Tclose);
        const H5T_class_t kind = member ? H5Tget_class(member) : H5T_NO_CLASS;
        char* name = H5Tget_member_name(type, at);
        if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || name == nullptr) {
            H5free_memory(name);
            return {.text = "records"};
        }
        join(record, elementTypeOf(member));
        record.members.emplace_back(name);
        H5free_memory(name);
    }
    record.components = std::uint64_t(count);
    std::string names;
    for (const std::string& name : record.members)
        names += (names.empty() ? "" : ", ") + name;
    record.text = "records of " + names;
    return record;
}

ElementType arrayType(hid_t type)
{
    const Hdf5Id base(H5Tget_super(type), H5Tclose);
    const int rank = H5Tget_array_ndims(type);
    ElementType element = base ? elementTypeOf(base) : ElementType{};
    if (rank < 1 || rank > H5S_MAX_RANK || element.kind == NumberKind::None || element.components != 1)
        return {.text = "arrays"};
    element.shape.resize(static_cast<std::size_t>(rank));
    H5Tget_array_dims2(type, element.shape.data());
    for (const hsize_t length : element.shape) {
        if (length == 0 || length > mostComponents / element.components)
            return {.text = "arrays"};
        element.components *= length;
    }
    element.text = std::to_string(element.components) + " x " + element.text;
    return element;
}

} // namespace

std::size_t numberBytes(NumberKind kind)
{
    return visitNumber(kind, []<class T>() { return sizeof(T); });
}

hid_t memoryType(NumberKind kind)
{
    switch (kind) {
    case NumberKind::Int8: return H5T_NATIVE_INT8;
    case NumberKind::UInt8: return H5T_NATIVE_UINT8;
    case NumberKind::Int16: return H5T_NATIVE_INT16;
    case NumberKind::UInt16: return H5T_NATIVE_UINT16;
    case NumberKind::Int32: return H5T_NATIVE_INT32;
    case NumberKind::UInt32: return H5T_NATIVE_UINT32;
    case NumberKind::Int64: return H5T_NATIVE_INT64;
    case NumberKind::UInt64: return H5T_NATIVE_UINT64;
    case NumberKind::Float: return H5T_NATIVE_FLOAT;
    default: return H5T_NATIVE_DOUBLE;
    }
}

ElementType elementTypeOf(hid_t type)
{
    switch (H5Tget_class(type)) {
    case H5T_INTEGER: return integerType(type);
    case H5T_FLOAT: return floatType(type);
    case H5T_ENUM: {
        const Hdf5Id base(H5Tget_super(type), H5Tclose); // truth values, labels
        return base ? integerType(base) : ElementType{};
    }
    case H5T_COMPOUND: return recordType(type);
    case H5T_ARRAY: return arrayType(type);
    case H5T_STRING: return {.text = "text"};
    case H5T_REFERENCE: return {.text = "references"};
    default: return {.text = "of another type"};
    }
}

} // namespace tetra
