// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_file.h"
#include "plugins/readers/cells/vtu_cells.h"
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
/// Numbers of points and cells, and orders of cells, which are taken only if there is nothing else.
constexpr std::array<std::string_view, 8> helpingNames = {
    "vtkGhostLevels",  "vtkOriginalPointIds", "vtkOriginalCellIds", "GlobalNodeId",
    "GlobalElementId", "PedigreeNodeId",      "PedigreeElementId",  "HigherOrderDegrees"};

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
        return Error{ErrorKind::BadInput, Message::say("a piece claims to have more values than possible.")};
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

/// Whether an array has one value everywhere, as far as the file tells its range, or it may be read. One that cannot be
/// read has not: reading it says what is wrong.
bool isConstant(const VtuHead& head, const FileArray& array, bool mayRead)
{
    std::optional<double> first;
    for (const VtuPiece& piece : head.pieces) {
        const auto& among = arraysOf(piece, array.perCell);
        const auto found = std::ranges::find(among, array.name, &VtuArray::name);
        if (found == among.end())
            return false;
        const auto range = rangeOf(*found);
        if (!range && !mayRead)
            return false;
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

/// Whether the file says that this array is the one.
bool isActive(const VtuHead& head, const FileArray& array)
{
    return array.name == (array.perCell ? head.activeCells : head.activePoints);
}

/// The array that is taken without a choice; null without arrays. Looks into arrays only if it may.
const FileArray* automatic(const VtuHead& head, const std::vector<FileArray>& arrays, bool mayRead)
{
    std::vector<const FileArray*> order;
    for (const FileArray& array : arrays)
        order.push_back(&array);
    std::ranges::stable_sort(order, {}, [&](const FileArray* array) {
        return std::array{isHelping(*array), array->perCell, !isActive(head, *array), array->components > 1};
    });
    if (order.size() > 1)
        for (const FileArray* array : order)
            if (isHelping(*array) == isHelping(*order.front()) && !isConstant(head, *array, mayRead))
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
        for (Message& remark : remarksOn(notes_))
            file_.remarks.push_back(std::move(remark));
        file_.joinsPoints = notes_.joinsPoints;
        return std::move(file_);
    }

private:
    Status add(const VtuPiece& piece)
    {
        if (piece.points == 0 && piece.cells == 0)
            return {};
        const std::size_t firstPoint = file_.complex.positions.size();
        if (piece.points > std::numeric_limits<std::uint64_t>::max() / 3)
            return Error{ErrorKind::BadInput, Message::say("a piece claims to have more points than possible.")};
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
        const auto nodes = addVtuCells(head_, piece, firstPoint, file_.complex, notes_);
        if (!nodes)
            return nodes.error();
        return addBlanked(piece, nodes->ends, nodes->nodes);
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
            file_.remarks.push_back(Message::say(
                "Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits."));
    }

    const VtuHead& head_;
    const ChosenArray& chosen_;
    int component_;
    VtuCellNotes notes_;
    CellsFile file_;
};

std::vector<Taken> takenOf(const VtuHead& head, const CellsRequest& request, const FileArray& array, int component)
{
    const std::vector<FileArray> arrays = arraysOf(head);
    const auto candidates = std::ranges::count_if(arrays, [](const FileArray& other) { return !isHelping(other); });
    return takenOf(request, array, component, !isActive(head, array) && (candidates > 1 || isHelping(array)));
}

std::vector<Message> leftOutOf(const VtuHead& head)
{
    const auto time = head.time.type.empty() ? std::nullopt : std::optional(readDoubles(head, head.time, 1));
    if (!time || !*time)
        return {};
    return {Message::say("It states the time %1.", formatNumber((**time)[0]))};
}

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
    auto file = VtuReading(*head, *chosen, *component).run(progress);
    if (file) {
        file->taken = takenOf(*head, request, chosen->array, *component);
        file->leftOut = leftOutOf(*head);
    }
    return file;
}

Result<FileContents> probeVtu(std::string_view bytes, const CellsRequest& request)
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
    contents.leftOut = leftOutOf(*head);
    const auto chosen = choose(*head, request, false);
    if (!chosen)
        return request.array.empty() ? Result<FileContents>(contents) : chosen.error();
    contents.type = chosen->type;
    const auto component = componentOf(request, chosen->array.components);
    if (!component)
        return component.error();
    contents.taken = takenOf(*head, request, chosen->array, *component);
    return contents;
}

namespace {

/// Of the element that such a file begins with; empty without it.
std::string vtkXmlAttribute(std::string_view firstBytes, std::string_view name)
{
    const std::size_t element = firstBytes.find("<VTKFile");
    if (element == std::string_view::npos)
        return {};
    const auto tag = XmlTags(firstBytes.substr(element)).next();
    return tag ? tag->attribute(name) : std::string();
}

} // namespace

std::string vtkXmlType(std::string_view firstBytes)
{
    return vtkXmlAttribute(firstBytes, "type");
}

bool isPackedOtherwise(std::string_view firstBytes)
{
    const std::string compressor = vtkXmlAttribute(firstBytes, "compressor");
    return !compressor.empty() && compressor != "vtkZLibDataCompressor";
}

} // namespace tetra
