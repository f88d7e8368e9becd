// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_file.h"
#include "plugins/readers/cells/vtu_data.h"
#include "plugins/readers/cells/vtu_head.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr MarkedText readingVtu = Message::marked("Reading");
constexpr std::string_view ghostName = "vtkGhostType";

CellShape shapeOf(std::uint64_t vtkType)
{
    switch (vtkType) {
    case 10: return CellShape::Tetrahedron;
    case 11: return CellShape::Voxel;
    case 12: return CellShape::Hexahedron;
    case 13: return CellShape::Prism;
    case 14: return CellShape::Pyramid;
    case 24: return CellShape::QuadraticTetrahedron;
    case 25: return CellShape::QuadraticHexahedron;
    case 26: return CellShape::QuadraticPrism;
    case 27: return CellShape::QuadraticPyramid;
    case 29: return CellShape::TriquadraticHexahedron;
    // Vertices, lines, strips and polygons, straight and curved.
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
    case 21:
    case 22:
    case 23:
    case 28:
    case 30:
    case 34:
    case 35:
    case 36: return CellShape::Flat;
    default: return CellShape::Polyhedron;
    }
}

bool isScalar(const VtuArray& array)
{
    return sampleTypeOf(array) && array.name != ghostName;
}

/// Which array of a piece is the one asked for.
struct ChosenArray {
    bool perCell = false;
    std::string name;
    int components = 1;
    SampleType type = SampleType::Float32;
};

std::vector<FileArray> arraysOf(const VtuHead& head)
{
    std::vector<FileArray> arrays;
    for (const bool perCell : {false, true})
        for (const VtuArray& array : perCell ? head.pieces[0].cellArrays : head.pieces[0].pointArrays) {
            if (!isScalar(array))
                continue;
            FileArray found{.name = array.name, .components = array.components, .perCell = perCell, .range = {}};
            const auto minimum = parseNumber<double>(array.rangeMinimum.substr(0, array.rangeMinimum.find(' ')));
            const auto maximum = parseNumber<double>(array.rangeMaximum.substr(0, array.rangeMaximum.find(' ')));
            if (minimum && maximum && array.components == 1)
                found.range = ValueRange{*minimum, *maximum};
            arrays.push_back(std::move(found));
        }
    return arrays;
}

Result<ChosenArray> choose(const VtuHead& head, const CellsRequest& request)
{
    const std::vector<FileArray> arrays = arraysOf(head);
    const auto find = [&](bool perCell, const std::string& name) {
        return std::ranges::find_if(arrays, [&](const FileArray& array) {
            return array.perCell == perCell && (name.empty() || array.name == name);
        });
    };
    auto found = arrays.end();
    for (const bool perCell : {false, true}) {
        const std::string& active = perCell ? head.activeCells : head.activePoints;
        if (found == arrays.end())
            found = find(perCell, request.array.empty() ? active : request.array);
        if (found == arrays.end() && request.array.empty())
            found = find(perCell, {});
    }
    if (found == arrays.end())
        return unknownArray(request.array, arrays);
    const auto& among = found->perCell ? head.pieces[0].cellArrays : head.pieces[0].pointArrays;
    const auto array = std::ranges::find(among, found->name, &VtuArray::name);
    return ChosenArray{found->perCell, found->name, found->components, *sampleTypeOf(*array)};
}

class VtuReading {
public:
    VtuReading(const VtuHead& head, const ChosenArray& chosen, int component)
        : head_(head), chosen_(chosen), component_(component)
    {
        file_.complex.offsets = {0};
        file_.values.perCell = chosen.perCell;
        file_.arrayName = chosen.name;
        file_.values.type = component < 0 && isInteger(chosen.type) ? SampleType::Float64 : chosen.type;
    }

    Result<CellsFile> run(const Progress& progress)
    {
        for (std::size_t piece = 0; piece < head_.pieces.size(); ++piece) {
            if (const Status status = add(head_.pieces[piece]); !status)
                return status.error();
            if (progress.cancelled())
                return cancelledError(readingVtu);
            progress.report(static_cast<double>(piece + 1) / static_cast<double>(head_.pieces.size()), readingVtu);
        }
        return std::move(file_);
    }

private:
    Status add(const VtuPiece& piece)
    {
        if (piece.points == 0 && piece.cells == 0)
            return {};
        const std::size_t firstPoint = file_.complex.positions.size();
        if (piece.points > std::numeric_limits<std::uint64_t>::max() / 3)
            return Error{ErrorKind::BadInput, Message::say("a piece says that it has more points than there can be.")};
        if (piece.positions.components != 3)
            return Error{ErrorKind::BadInput, Message::say("its points do not have three coordinates each.")};
        const auto positions = readDoubles(head_, piece.positions, 3 * piece.points);
        if (!positions)
            return positions.error();
        for (std::size_t i = 0; i < positions->size(); i += 3)
            file_.complex.positions.emplace_back((*positions)[i], (*positions)[i + 1], (*positions)[i + 2]);
        if (const Status status = addValues(piece); !status)
            return status;
        return piece.cells == 0 ? Status() : addCells(piece, firstPoint);
    }

    Status addValues(const VtuPiece& piece)
    {
        const auto& among = chosen_.perCell ? piece.cellArrays : piece.pointArrays;
        const auto array = std::ranges::find(among, chosen_.name, &VtuArray::name);
        if (array == among.end() || array->components != chosen_.components)
            return Error{ErrorKind::BadInput,
                         Message::say("not every piece has the array '%1'.", printable(chosen_.name))};
        const std::uint64_t count = chosen_.perCell ? piece.cells : piece.points;
        const auto components = static_cast<std::uint64_t>(chosen_.components);
        if (count > std::numeric_limits<std::uint64_t>::max() / components)
            return Error{ErrorKind::BadInput, Message::say("a piece says that it has more values than there can be.")};
        const auto numbers = readDoubles(head_, *array, count * components);
        if (!numbers)
            return numbers.error();
        for (std::uint64_t item = 0; item < count; ++item) {
            const std::span tuple = std::span(*numbers).subspan(item * components, components);
            double value = 0;
            if (component_ >= 0)
                value = tuple[static_cast<std::size_t>(component_)];
            else
                for (const double part : tuple)
                    value = std::hypot(value, part);
            file_.values.values.push_back(value);
        }
        return {};
    }

    Status addCells(const VtuPiece& piece, std::uint64_t firstPoint)
    {
        const auto offsets = readIntegers(head_, piece.offsets, piece.cells);
        if (!offsets)
            return offsets.error();
        if (!std::ranges::is_sorted(*offsets))
            return Error{ErrorKind::BadInput, Message::say("the offsets of its cells do not rise.")};
        const auto corners = readIntegers(head_, piece.connectivity, offsets->back());
        if (!corners)
            return corners.error();
        const auto types = readIntegers(head_, piece.types, piece.cells);
        if (!types)
            return types.error();
        CellComplex& complex = file_.complex;
        const std::uint64_t firstCorner = complex.corners.size();
        for (const std::uint64_t corner : *corners) {
            if (corner >= piece.points)
                return Error{ErrorKind::BadInput, Message::say("a cell has the corner %1 of %2 points.",
                                                               static_cast<std::int64_t>(corner), piece.points)};
            complex.corners.push_back(firstPoint + corner);
        }
        for (std::uint64_t cell = 0; cell < piece.cells; ++cell) {
            complex.offsets.push_back(firstCorner + (*offsets)[cell]);
            complex.shapes.push_back(shapeOf((*types)[cell]));
        }
        return addGhosts(piece);
    }

    /// Copies of cells that another piece has, and hidden ones.
    Status addGhosts(const VtuPiece& piece)
    {
        constexpr std::uint64_t duplicate = 1, hidden = 32;
        const auto array = std::ranges::find(piece.cellArrays, ghostName, &VtuArray::name);
        if (array == piece.cellArrays.end() && file_.complex.blanked.empty())
            return {};
        file_.complex.blanked.resize(file_.complex.shapes.size());
        if (array == piece.cellArrays.end())
            return {};
        const auto ghosts = readIntegers(head_, *array, piece.cells);
        if (!ghosts)
            return ghosts.error();
        for (std::uint64_t cell = 0; cell < piece.cells; ++cell)
            if (((*ghosts)[cell] & (duplicate | hidden)) != 0)
                file_.complex.blanked[file_.complex.shapes.size() - piece.cells + cell] = 1;
        return {};
    }

    const VtuHead& head_;
    const ChosenArray& chosen_;
    int component_;
    CellsFile file_;
};

} // namespace

Result<CellsFile> readVtu(std::string_view bytes, const CellsRequest& request, const Progress& progress)
{
    const auto head = parseVtuHead(bytes);
    if (!head)
        return head.error();
    const auto chosen = choose(*head, request);
    if (!chosen)
        return chosen.error();
    const auto component = componentOf(request, chosen->components);
    if (!component)
        return component.error();
    return VtuReading(*head, *chosen, *component).run(progress);
}

Result<FileContents> probeVtu(std::string_view bytes)
{
    const auto head = parseVtuHead(bytes);
    if (!head)
        return head.error();
    FileContents contents;
    contents.domain = DomainClass::Irregular;
    for (const VtuPiece& piece : head->pieces) {
        contents.points += piece.points;
        contents.cells += piece.cells;
    }
    contents.arrays = arraysOf(*head);
    if (const auto chosen = choose(*head, {}))
        contents.type = chosen->type;
    return contents;
}

} // namespace tetra
