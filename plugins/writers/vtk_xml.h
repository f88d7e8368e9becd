// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_output.h"
#include "plugins/writers/mesh_file.h"

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

/// An array of a VTK XML file.
struct XmlArray {
    std::string name;
    std::string_view type; ///< vtkXmlType()
    std::uint64_t bytes = 0;
    int components = 1;
    std::function<Status(MeshOutput& out)> write; ///< exactly `bytes` bytes, little endian
};

/// PointData, Points, Cells ..., with its arrays.
struct XmlElement {
    std::string name;
    std::string attributes; ///< with a blank before each
    std::vector<XmlArray> arrays;
};

/// A grid of one piece. `numbers` are the piece's attributes: how many points it has, and so on.
struct XmlGrid {
    std::string type; ///< UnstructuredGrid, PolyData
    std::string numbers;
    MeshFacts facts;
    std::vector<XmlElement> elements;
};

/// About how large the file will be.
std::uint64_t bytesOf(const XmlGrid& grid);

/// Writes the whole file: appended raw, little endian, 64-bit headers, the arrays in the order of the elements.
Status writeVtkXml(MeshOutput& out, const XmlGrid& grid);

/// Text as the value of an attribute. What XML cannot hold becomes a question mark.
std::string xmlAttribute(std::string_view text);

template <class T> constexpr std::string_view vtkXmlType()
{
    if constexpr (std::is_same_v<T, float>)
        return "Float32";
    else if constexpr (std::is_same_v<T, double>)
        return "Float64";
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return "UInt8";
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return "UInt16";
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return "UInt32";
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return "Int32";
    else
        return "Int64";
}

/// An array that lies in memory as in the file.
template <class T> XmlArray xmlArray(std::string name, std::span<const T> values)
{
    return {std::move(name), vtkXmlType<T>(), values.size_bytes(), 1,
            [values](MeshOutput& out) { return out.bytes(std::as_bytes(values)); }};
}

/// An array whose values make(index) gives.
template <class Value, class Make> XmlArray madeXmlArray(std::string name, std::uint64_t count, Make make)
{
    return {std::move(name), vtkXmlType<Value>(), count * sizeof(Value), 1, [count, make](MeshOutput& out) {
                return out.records(count, sizeof(Value), [&](std::uint64_t index, std::byte* where) {
                    putNumber(where, static_cast<Value>(make(index)));
                });
            }};
}

} // namespace tetra
