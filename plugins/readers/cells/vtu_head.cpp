// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/vtu_head.h"

#include "plugins/readers/cells/xml_tags.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

Error bad(Message text)
{
    return {ErrorKind::BadInput, std::move(text)};
}

std::optional<std::uint64_t> numberOf(const XmlTag& tag, std::string_view key)
{
    std::string text = tag.attribute(key);
    std::erase(text, ' ');
    return parseNumber<std::uint64_t>(text);
}

/// How many words a text has.
std::size_t wordCount(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    std::size_t count = 0;
    for (auto at = text.find_first_not_of(blanks); at != std::string_view::npos;
         at = text.find_first_not_of(blanks, text.find_first_of(blanks, at)))
        ++count;
    return count;
}

class HeadParsing {
public:
    explicit HeadParsing(std::string_view bytes) : bytes_(bytes), tags_(bytes) {}

    Result<VtuHead> run()
    {
        const auto first = tags_.next();
        if (!first || first->name != "VTKFile")
            return bad(Message::say("it does not begin with <VTKFile>, so it is not a VTK XML file."));
        if (const Status status = fileTag(*first); !status)
            return status.error();
        while (const auto tag = tags_.next()) {
            if (tag->name == "AppendedData" && tag->opens) {
                if (const Status status = appended(*tag); !status)
                    return status.error();
                break;
            }
            ended_ = ended_ || (tag->name == "VTKFile" && !tag->opens);
            if (const Status status = element(*tag); !status)
                return status.error();
        }
        if (tags_.broken() || !ended_)
            return bad(Message::say("its XML is damaged or cut short."));
        return finish();
    }

private:
    Status fileTag(const XmlTag& tag)
    {
        if (tag.attribute("type") != "UnstructuredGrid")
            return bad(Message::say("it holds a %1, not an UnstructuredGrid. The VTK plugin reads those.",
                                    printable(tag.attribute("type"))));
        head_.bigEndian = tag.attribute("byte_order") == "BigEndian";
        head_.wideHeaders = tag.attribute("header_type") == "UInt64";
        const double version = parseNumber<double>(tag.attribute("version")).value_or(0);
        constexpr double newNumbers = 2.1;
        head_.exchangesLagrangeEdges = version < newNumbers;
        const std::string compressor = tag.attribute("compressor");
        head_.packed = compressor == "vtkZLibDataCompressor";
        if (!compressor.empty() && !head_.packed)
            return bad(Message::say("it is compressed with %1, and only zlib is supported. Save it with zlib, or as "
                                    ".vtk, for instance with ParaView.",
                                    printable(compressor)));
        return {};
    }

    Status element(const XmlTag& tag)
    {
        if (tag.opens && !tag.closes)
            inside_ = tag.name == "DataArray" ? inside_ : tag.name;
        else if (!tag.opens && tag.name == inside_)
            inside_ = {};
        if (!tag.opens)
            return {};
        if (tag.name == "UnstructuredGrid" && wordCount(tag.attribute("TimeValues")) > 1)
            return bad(Message::say("it holds several time steps. Save each as a file of its own, for instance with "
                                    "ParaView."));
        if (tag.name == "Piece")
            return piece(tag);
        if (head_.pieces.size() == 1 && tag.name == "PointData")
            head_.activePoints = tag.attribute("Scalars");
        if (head_.pieces.size() == 1 && tag.name == "CellData")
            head_.activeCells = tag.attribute("Scalars");
        if (tag.name == "DataArray" && (!head_.pieces.empty() || inside_ == "FieldData"))
            return array(tag);
        return {};
    }

    Status piece(const XmlTag& tag)
    {
        const auto points = numberOf(tag, "NumberOfPoints"), cells = numberOf(tag, "NumberOfCells");
        if (!points || !cells)
            return bad(Message::say("a piece does not say how many points and cells it has."));
        head_.pieces.push_back({.points = *points,
                                .cells = *cells,
                                .pointArrays = {},
                                .cellArrays = {},
                                .positions = {},
                                .connectivity = {},
                                .offsets = {},
                                .types = {},
                                .faces = {},
                                .faceOffsets = {},
                                .facePoints = {},
                                .faceEnds = {},
                                .cellFaces = {},
                                .cellFaceEnds = {}});
        return {};
    }

    Status array(const XmlTag& tag)
    {
        VtuArray array;
        array.name = tag.attribute("Name");
        array.type = tag.attribute("type");
        array.format = tag.attribute("format");
        array.rangeMinimum = tag.attribute("RangeMin");
        array.rangeMaximum = tag.attribute("RangeMax");
        const std::string components = tag.attribute("NumberOfComponents");
        constexpr int mostComponents = 1000;
        array.components = components.empty() ? 1 : parseNumber<int>(components).value_or(-1);
        if (array.components == 0)
            array.components = 1;
        if (array.components < 1 || array.components > mostComponents)
            return bad(Message::say("the array '%1' has %2 components.", printable(array.name), printable(components)));
        if (array.format == "appended") {
            const auto offset = numberOf(tag, "offset");
            if (!offset)
                return bad(Message::say("the array '%1' does not say where it is.", printable(array.name)));
            array.offset = *offset;
        } else {
            const std::size_t end = bytes_.find('<', tag.end);
            if (end == std::string_view::npos && !tag.closes)
                return bad(Message::say("the array '%1' does not end.", printable(array.name)));
            array.content = tag.closes ? std::string_view() : bytes_.substr(tag.end, end - tag.end);
        }
        place(std::move(array));
        return {};
    }

    void place(VtuArray array)
    {
        if (inside_ == "FieldData") {
            if (array.name == "TimeValue" || array.name == "TIME")
                head_.time = std::move(array);
            return;
        }
        VtuPiece& piece = head_.pieces.back();
        VtuArray* where = nullptr;
        if (inside_ == "PointData")
            where = &piece.pointArrays.emplace_back();
        else if (inside_ == "CellData")
            where = &piece.cellArrays.emplace_back();
        else if (inside_ == "Points")
            where = &piece.positions;
        else if (inside_ == "Cells" && array.name == "connectivity")
            where = &piece.connectivity;
        else if (inside_ == "Cells" && array.name == "offsets")
            where = &piece.offsets;
        else if (inside_ == "Cells" && array.name == "types")
            where = &piece.types;
        else if (inside_ == "Cells" && array.name == "faces")
            where = &piece.faces;
        else if (inside_ == "Cells" && array.name == "faceoffsets")
            where = &piece.faceOffsets;
        else if (inside_ == "Cells" && array.name == "face_connectivity")
            where = &piece.facePoints;
        else if (inside_ == "Cells" && array.name == "face_offsets")
            where = &piece.faceEnds;
        else if (inside_ == "Cells" && array.name == "polyhedron_to_faces")
            where = &piece.cellFaces;
        else if (inside_ == "Cells" && array.name == "polyhedron_offsets")
            where = &piece.cellFaceEnds;
        if (where != nullptr)
            *where = std::move(array);
    }

    Status appended(const XmlTag& tag)
    {
        constexpr std::string_view fileEnd = "</VTKFile>";
        if (!bytes_.substr(0, bytes_.find_last_not_of(" \t\r\n") + 1).ends_with(fileEnd))
            return bad(Message::say("it ends within its appended data. It is cut short: copy the file again."));
        ended_ = true;
        head_.appendedBase64 = tag.attribute("encoding") == "base64";
        const std::size_t mark = bytes_.find('_', tag.end);
        if (mark == std::string_view::npos)
            return bad(Message::say("its appended data do not begin."));
        const std::string_view data = bytes_.substr(mark + 1);
        const auto fill = [&](VtuArray& array) {
            if (array.format == "appended")
                array.content = array.offset < data.size() ? data.substr(array.offset) : std::string_view();
        };
        fill(head_.time);
        for (VtuPiece& piece : head_.pieces) {
            std::ranges::for_each(piece.pointArrays, fill);
            std::ranges::for_each(piece.cellArrays, fill);
            for (VtuArray* array :
                 {&piece.positions, &piece.connectivity, &piece.offsets, &piece.types, &piece.faces, &piece.faceOffsets,
                  &piece.facePoints, &piece.faceEnds, &piece.cellFaces, &piece.cellFaceEnds})
                fill(*array);
        }
        return {};
    }

    Result<VtuHead> finish()
    {
        if (head_.pieces.empty())
            return bad(Message::say("it has no piece with points and cells."));
        for (const VtuPiece& piece : head_.pieces)
            for (const auto& [array, name] :
                 {std::pair(&piece.positions, "Points"), std::pair(&piece.connectivity, "connectivity"),
                  std::pair(&piece.offsets, "offsets"), std::pair(&piece.types, "types")})
                if (piece.cells > 0 && array->type.empty())
                    return bad(Message::say("a piece has no array '%1'.", name));
        return std::move(head_);
    }

    std::string_view bytes_;
    XmlTags tags_;
    VtuHead head_;
    std::string_view inside_;
    bool ended_ = false; ///< the file does not end before its last element
};

} // namespace

Result<VtuHead> parseVtuHead(std::string_view bytes)
{
    return HeadParsing(bytes).run();
}

} // namespace tetra
