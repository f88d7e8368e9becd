// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_file.h"
#include "plugins/readers/cells/vtu_data.h"
#include "plugins/readers/cells/vtu_head.h"
#include "plugins/readers/cells/xml_tags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace tetra {

namespace {

constexpr MarkedText readingVtu = Message::marked("Reading");
constexpr std::string_view ghostName = "vtkGhostType";
/// Numbers of points and cells, which are taken only if there is nothing else.
constexpr std::array<std::string_view, 5> helpingNames = {"vtkGhostLevels", "vtkOriginalPointIds", "vtkOriginalCellIds",
                                                          "GlobalNodeId", "GlobalElementId"};

/// Nothing for shapes that are not known.
std::optional<CellShape> shapeOf(std::uint64_t vtkType)
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
    case 42: return CellShape::Polyhedron;
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
    case 36:
    case 68:
    case 69:
    case 70:
    case 75:
    case 76:
    case 77: return CellShape::Flat;
    default: return std::nullopt;
    }
}

/// The quadratic shape of so many corners, for cells that are called linear; nothing else has as many.
std::optional<CellShape> quadraticShape(CellShape shape, std::uint64_t corners)
{
    switch (shape) {
    case CellShape::Tetrahedron: return corners == 10 ? std::optional(CellShape::QuadraticTetrahedron) : std::nullopt;
    case CellShape::Pyramid: return corners == 13 ? std::optional(CellShape::QuadraticPyramid) : std::nullopt;
    case CellShape::Prism: return corners == 15 ? std::optional(CellShape::QuadraticPrism) : std::nullopt;
    case CellShape::Hexahedron: return corners == 20 ? std::optional(CellShape::QuadraticHexahedron) : std::nullopt;
    default: return std::nullopt;
    }
}

bool isScalar(const VtuArray& array)
{
    return sampleTypeOf(array) && array.name != ghostName;
}

/// Which array of a piece is the one asked for.
struct ChosenArray {
    FileArray array;
    SampleType type = SampleType::Float32;
    bool isLong = false; ///< integers of 64 bits
};

/// As the file says; nothing if it does not.
std::optional<ValueRange> rangeOf(const VtuArray& array)
{
    const auto minimum = parseNumber<double>(array.rangeMinimum.substr(0, array.rangeMinimum.find(' ')));
    const auto maximum = parseNumber<double>(array.rangeMaximum.substr(0, array.rangeMaximum.find(' ')));
    return minimum && maximum && array.components == 1 ? std::optional(ValueRange{*minimum, *maximum}) : std::nullopt;
}

const std::vector<VtuArray>& arraysOf(const VtuPiece& piece, bool perCell)
{
    return perCell ? piece.cellArrays : piece.pointArrays;
}

std::vector<FileArray> arraysOf(const VtuHead& head)
{
    std::vector<FileArray> arrays;
    for (const bool perCell : {false, true})
        for (const VtuArray& array : arraysOf(head.pieces[0], perCell))
            if (isScalar(array))
                arrays.push_back(
                    {.name = array.name, .components = array.components, .perCell = perCell, .range = rangeOf(array)});
    return arrays;
}

/// The values of a piece. component -1: the magnitude.
Result<std::vector<double>> valuesOf(const VtuHead& head, const VtuPiece& piece, const FileArray& wanted, int component)
{
    const auto& among = arraysOf(piece, wanted.perCell);
    const auto array = std::ranges::find(among, wanted.name, &VtuArray::name);
    if (array == among.end() || array->components != wanted.components)
        return Error{ErrorKind::BadInput, Message::say("not every piece has the array '%1'.", printable(wanted.name))};
    const std::uint64_t count = wanted.perCell ? piece.cells : piece.points;
    const auto components = static_cast<std::uint64_t>(wanted.components);
    if (count > std::numeric_limits<std::uint64_t>::max() / components)
        return Error{ErrorKind::BadInput, Message::say("a piece says that it has more values than there can be.")};
    auto numbers = readDoubles(head, *array, count * components);
    if (!numbers || components == 1)
        return numbers;
    std::vector<double> values(count);
    for (std::uint64_t item = 0; item < count; ++item) {
        const std::span tuple = std::span(*numbers).subspan(item * components, components);
        double squares = 0;
        for (const double part : tuple)
            squares += part * part;
        values[item] = component >= 0 ? tuple[static_cast<std::size_t>(component)] : std::sqrt(squares);
    }
    return values;
}

/// Whether an array has one value everywhere. One that cannot be read has not: reading it says what is wrong.
bool isConstant(const VtuHead& head, const FileArray& array)
{
    std::optional<double> first;
    for (const VtuPiece& piece : head.pieces) {
        const auto& among = arraysOf(piece, array.perCell);
        const auto found = std::ranges::find(among, array.name, &VtuArray::name);
        if (found == among.end())
            return false;
        const auto range = rangeOf(*found);
        const auto values = range ? std::vector{range->minimum, range->maximum} : valuesOf(head, piece, array, -1);
        if (!values)
            return false;
        for (const double value : *values) {
            if (first && (value < *first || value > *first))
                return false;
            first = value;
        }
    }
    return true;
}

bool isHelping(const FileArray& array)
{
    return std::ranges::find(helpingNames, array.name) != helpingNames.end();
}

/// The array that is taken without a choice; null without arrays. Looks into arrays only if it may.
const FileArray* automatic(const VtuHead& head, const std::vector<FileArray>& arrays, bool mayRead)
{
    std::vector<const FileArray*> order;
    for (const FileArray& array : arrays)
        order.push_back(&array);
    std::ranges::stable_sort(order, {}, [&](const FileArray* array) {
        const bool active = array->name == (array->perCell ? head.activeCells : head.activePoints);
        return std::array{isHelping(*array), array->perCell, !active, array->components > 1};
    });
    if (mayRead && order.size() > 1)
        for (const FileArray* array : order)
            if (isHelping(*array) == isHelping(*order.front()) && !isConstant(head, *array))
                return array;
    return order.empty() ? nullptr : order.front();
}

const FileArray* named(const std::vector<FileArray>& arrays, const std::string& wanted)
{
    if (const auto found = std::ranges::find(arrays, wanted, &FileArray::name); found != arrays.end())
        return &*found;
    const auto number = parseNumber<std::uint64_t>(wanted);
    return number && *number >= 1 && *number <= arrays.size() ? &arrays[*number - 1] : nullptr;
}

Result<ChosenArray> choose(const VtuHead& head, const CellsRequest& request, bool mayRead)
{
    const std::vector<FileArray> arrays = arraysOf(head);
    const FileArray* found = request.array.empty() ? automatic(head, arrays, mayRead) : named(arrays, request.array);
    if (found == nullptr)
        return unknownArray(request.array, arrays);
    const auto& among = arraysOf(head.pieces[0], found->perCell);
    const auto array = std::ranges::find(among, found->name, &VtuArray::name);
    return ChosenArray{*found, *sampleTypeOf(*array), array->type == "Int64" || array->type == "UInt64"};
}

class VtuReading {
public:
    VtuReading(const VtuHead& head, const ChosenArray& chosen, int component)
        : head_(head), chosen_(chosen), component_(component)
    {
        file_.complex.offsets = {0};
        file_.values.perCell = chosen.array.perCell;
        file_.arrayName = takenName(chosen.array, component);
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
        if (chosen_.isLong && component_ >= 0)
            shortenValues();
        remarkQuadratic();
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
        const auto values = valuesOf(head_, piece, chosen_.array, component_);
        if (!values)
            return values.error();
        file_.values.values.insert(file_.values.values.end(), values->begin(), values->end());
        return piece.cells == 0 ? Status() : addCells(piece, firstPoint);
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
            const auto shape = shapeOf((*types)[cell]);
            if (!shape)
                return Error{ErrorKind::BadInput, Message::say("it has cells of a shape that TAn does not know: %1. "
                                                               "Divide them into simpler ones.",
                                                               Message::say("number %1", (*types)[cell]))};
            const auto quadratic = quadraticShape(*shape, (*offsets)[cell] - (cell == 0 ? 0 : (*offsets)[cell - 1]));
            wronglyLinear_ += quadratic ? 1 : 0;
            constexpr std::uint64_t polyVertex = 2;
            file_.joinsPoints = file_.joinsPoints || (*types)[cell] > polyVertex;
            complex.offsets.push_back(firstCorner + (*offsets)[cell]);
            complex.shapes.push_back(quadratic.value_or(*shape));
        }
        return addBlanked(piece, *offsets, *corners);
    }

    /// Copies of cells that another piece has, hidden ones, and those at hidden points.
    Status addBlanked(const VtuPiece& piece, const std::vector<std::uint64_t>& offsets,
                      const std::vector<std::uint64_t>& corners)
    {
        constexpr std::uint64_t duplicateOrHidden = 1 | 32, hiddenPoint = 2, anyLevel = ~std::uint64_t(0);
        std::vector<std::uint8_t> blanked(piece.cells);
        for (const auto& [name, mask] :
             {std::pair(ghostName, duplicateOrHidden), std::pair(helpingNames[0], anyLevel)}) {
            const auto flags = flagsOf(piece.cellArrays, name, piece.cells);
            if (!flags)
                return flags.error();
            for (std::uint64_t cell = 0; cell < flags->size(); ++cell)
                blanked[cell] = blanked[cell] != 0 || ((*flags)[cell] & mask) != 0;
        }
        const auto flags = flagsOf(piece.pointArrays, ghostName, piece.points);
        if (!flags)
            return flags.error();
        if (!flags->empty())
            for (std::uint64_t cell = 0, corner = 0; cell < piece.cells; ++cell)
                for (; corner < offsets[cell]; ++corner)
                    blanked[cell] = blanked[cell] != 0 || ((*flags)[corners[corner]] & hiddenPoint) != 0;
        CellComplex& complex = file_.complex;
        if (complex.blanked.empty() && std::ranges::find(blanked, 1) == blanked.end())
            return {};
        complex.blanked.resize(complex.shapes.size() - piece.cells);
        complex.blanked.insert(complex.blanked.end(), blanked.begin(), blanked.end());
        return {};
    }

    /// Of points or cells; empty if the piece has none.
    Result<std::vector<std::uint64_t>> flagsOf(const std::vector<VtuArray>& among, std::string_view name,
                                               std::uint64_t count) const
    {
        const auto array = std::ranges::find(among, name, &VtuArray::name);
        if (array == among.end() || array->type != "UInt8" || array->components != 1)
            return std::vector<std::uint64_t>();
        return readIntegers(head_, *array, count);
    }

    /// Integers of 64 bits that all fit into 32.
    void shortenValues()
    {
        constexpr double least = std::numeric_limits<std::int32_t>::min(),
                         most = std::numeric_limits<std::int32_t>::max();
        if (std::ranges::all_of(file_.values.values, [](double value) { return value >= least && value <= most; }))
            file_.values.type = SampleType::Int32;
        else
            file_.remarks.push_back(Message::say("Its 64-bit integers became floating-point numbers of 53 bits."));
    }

    void remarkQuadratic()
    {
        if (wronglyLinear_ == 1)
            file_.remarks.push_back(
                Message::say("1 cell is called linear and has the corners of a quadratic one: it was taken as such."));
        else if (wronglyLinear_ > 1)
            file_.remarks.push_back(Message::say(
                "%1 cells are called linear and have the corners of quadratic ones: they were taken as such.",
                wronglyLinear_));
    }

    const VtuHead& head_;
    const ChosenArray& chosen_;
    int component_;
    std::uint64_t wronglyLinear_ = 0;
    CellsFile file_;
};

} // namespace

Result<CellsFile> readVtu(std::string_view bytes, const CellsRequest& request, const Progress& progress)
{
    const auto head = parseVtuHead(bytes);
    if (!head)
        return head.error();
    const auto chosen = choose(*head, request, true);
    if (!chosen)
        return chosen.error();
    const auto component = componentOf(request, chosen->array.components);
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
    if (const auto chosen = choose(*head, {}, false))
        contents.type = chosen->type;
    return contents;
}

std::string vtkXmlType(std::string_view firstBytes)
{
    const std::size_t element = firstBytes.find("<VTKFile");
    if (element == std::string_view::npos)
        return {};
    const auto tag = XmlTags(firstBytes.substr(element)).next();
    return tag ? tag->attribute("type") : std::string();
}

} // namespace tetra
