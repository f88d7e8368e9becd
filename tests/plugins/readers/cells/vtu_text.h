// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace tetra {

/// A small .vtu file, of a tetrahedron and a pyramid, whose parts tests replace.
struct VtuText {
    std::string fileAttributes = R"(type="UnstructuredGrid" version="0.1" byte_order="LittleEndian")";
    std::string counts = R"(NumberOfPoints="6" NumberOfCells="2")";
    std::string pointDataAttributes;
    std::string pointData = R"(<DataArray type="Float32" Name="heat" format="ascii">1 2 3 4 5 6</DataArray>)";
    std::string cellData;
    std::string positions = R"(<DataArray type="Float32" NumberOfComponents="3" format="ascii">
        0 0 0 1 0 0 1 1 0 0 1 0 .5 .5 1 2 0.5 0.5</DataArray>)";
    std::string connectivity =
        R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 4 1 5 2 4</DataArray>)";
    std::string offsets = R"(<DataArray type="Int32" Name="offsets" format="ascii">5 9</DataArray>)";
    std::string types = R"(<DataArray type="UInt8" Name="types" format="ascii">14 10</DataArray>)";
    std::string after;

    std::string text() const
    {
        return "<?xml version=\"1.0\"?>\n<!-- made > by hand -->\n<VTKFile " + fileAttributes +
               ">\n<UnstructuredGrid>\n<Piece " + counts + ">\n<PointData" + pointDataAttributes + ">" + pointData +
               "</PointData>\n<CellData>" + cellData + "</CellData>\n<Points>" + positions + "</Points>\n<Cells>" +
               connectivity + offsets + types + "</Cells>\n</Piece>\n</UnstructuredGrid>\n" + after + "</VTKFile>\n";
    }
};

inline std::filesystem::path writtenFile(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

} // namespace tetra
