// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_file.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace tetra {

namespace {

constexpr MarkedText readingUcd = Message::marked("Reading");

std::string_view nextWord(std::string_view& line)
{
    constexpr std::string_view blanks = " \t\r,";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

/// The lines that say something, without the comments before the mesh.
class UcdLines {
public:
    explicit UcdLines(std::string_view text) : text_(text) {}
    bool next(std::string_view& line)
    {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            line = text_.substr(at_, end - at_);
            at_ = std::min(end + 1, text_.size());
            ++number_;
            if (!line.starts_with('#') && line.find_first_not_of(" \t\r") != std::string_view::npos)
                return true;
        }
        return false;
    }
    std::uint64_t number() const { return number_; }
    std::uint64_t bytesLeft() const { return text_.size() - at_; }
    double fraction() const { return static_cast<double>(at_) / static_cast<double>(text_.size() + 1); }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::uint64_t number_ = 0;
};

/// The five numbers of the first line.
struct UcdCounts {
    std::uint64_t points = 0, cells = 0, perPoint = 0, perCell = 0;
};

bool parseCounts(std::string_view line, UcdCounts& counts)
{
    std::uint64_t perModel = 0;
    for (std::uint64_t* number : {&counts.points, &counts.cells, &counts.perPoint, &counts.perCell, &perModel}) {
        const auto parsed = parseNumber<std::uint64_t>(nextWord(line));
        if (!parsed)
            return false;
        *number = *parsed;
    }
    return nextWord(line).empty();
}

struct UcdShape {
    std::string_view name;
    CellShape shape;
    std::uint32_t corners;
};
constexpr std::array<UcdShape, 8> shapes = {{{"tet", CellShape::Tetrahedron, 4},
                                             {"hex", CellShape::Hexahedron, 8},
                                             {"prism", CellShape::Prism, 6},
                                             {"pyr", CellShape::Pyramid, 5},
                                             {"pt", CellShape::Flat, 1},
                                             {"line", CellShape::Flat, 2},
                                             {"tri", CellShape::Flat, 3},
                                             {"quad", CellShape::Flat, 4}}};

class UcdReading {
public:
    UcdReading(std::string_view text, const Progress& progress) : lines_(text), progress_(progress) {}

    Status head()
    {
        std::string_view line;
        if (!lines_.next(line) || !parseCounts(line, counts_))
            return wrong(Message::say("the first line is not five numbers: of points, of cells, of values per point, "
                                      "per cell and of the model"));
        // A line of a point has at least nine characters, one of a cell eight.
        if (counts_.points > lines_.bytesLeft() / 8 || counts_.cells > lines_.bytesLeft() / 7)
            return wrong(Message::say("it is too short for %1 points and %2 cells", counts_.points, counts_.cells));
        return {};
    }
    const UcdCounts& counts() const { return counts_; }
    bool joinsPoints() const { return joinsPoints_; } ///< as far as cells() went

    Status points(std::vector<Eigen::Vector3d>& positions)
    {
        positions.reserve(counts_.points);
        numbers_.reserve(counts_.points);
        for (std::uint64_t point = 0; point < counts_.points; ++point) {
            std::string_view line;
            if (const Status status = step(line, Message::marked("points"), point, counts_.points); !status)
                return status;
            const auto number = parseNumber<std::int64_t>(nextWord(line));
            Eigen::Vector3d position;
            bool complete = number.has_value();
            for (double& coordinate : position) {
                const auto parsed = parseNumber<double>(nextWord(line));
                complete = complete && parsed;
                coordinate = parsed.value_or(0);
            }
            if (!complete)
                return wrong(Message::say("a point is not its number and three coordinates"));
            if (!numbers_.emplace(*number, point).second)
                return wrong(Message::say("the number of a point appears twice"));
            positions.push_back(position);
        }
        return {};
    }

    Status cells(CellComplex& complex)
    {
        complex.offsets = {0};
        for (std::uint64_t cell = 0; cell < counts_.cells; ++cell) {
            std::string_view line;
            if (const Status status = step(line, Message::marked("cells"), cell, counts_.cells); !status)
                return status;
            const auto number = parseNumber<std::int64_t>(nextWord(line));
            std::string_view name = nextWord(line);
            if (parseNumber<std::int64_t>(name)) // the material may be missing
                name = nextWord(line);
            const auto shape = std::ranges::find(shapes, name, &UcdShape::name);
            if (!number || shape == shapes.end())
                return wrong(Message::say("a cell is not its number, its material and its shape: pt, line, tri, quad, "
                                          "tet, pyr, prism or hex"));
            if (const Status status = corners(line, *shape, complex); !status)
                return status;
            cellNumbers_.emplace(*number, cell);
        }
        return {};
    }

    /// The names and the numbers of components of the values of points or of cells; goes past the head of their part.
    Status arrays(std::uint64_t perItem, bool perCell, std::vector<FileArray>& found)
    {
        if (perItem == 0)
            return {};
        std::string_view line;
        if (!lines_.next(line))
            return wrong(Message::say("the list of values is missing"));
        const auto count = parseNumber<std::uint64_t>(nextWord(line));
        if (!count || *count == 0 || *count > perItem || *count > line.size())
            return wrong(
                Message::say("the line before the values does not hold their number and how many components each has"));
        std::uint64_t sum = 0;
        std::vector<FileArray> arrays(*count);
        for (FileArray& array : arrays) {
            const auto components = parseNumber<std::uint32_t>(nextWord(line));
            if (!components || *components == 0 || *components > perItem)
                return wrong(Message::say(
                    "the line before the values does not hold their number and how many components each has"));
            array.components = static_cast<int>(*components);
            array.perCell = perCell;
            sum += *components;
        }
        if (sum != perItem)
            return wrong(Message::say("the components of the values do not add up to what the first line states"));
        for (FileArray& array : arrays) {
            if (!lines_.next(line))
                return wrong(Message::say("the name of a value is missing"));
            const std::string_view name = line.substr(0, line.find_first_of(",\r"));
            array.name = std::string(name.substr(0, name.find_last_not_of(" \t") + 1));
            line.remove_prefix(std::min(line.find(','), line.size()));
            array.unit = nextWord(line);
        }
        found.insert(found.end(), arrays.begin(), arrays.end());
        return {};
    }

    /// `first`: the place of the array among the numbers of a line. component -1: the magnitude.
    Status values(bool perCell, std::uint64_t first, int components, int component, std::vector<double>& values)
    {
        const std::uint64_t count = perCell ? counts_.cells : counts_.points;
        const auto& numbers = perCell ? cellNumbers_ : numbers_;
        values.assign(count, std::numeric_limits<double>::quiet_NaN());
        for (std::uint64_t item = 0; item < count; ++item) {
            std::string_view line;
            if (const Status status = step(line, Message::marked("values"), item, count); !status)
                return status;
            const auto number = parseNumber<std::int64_t>(nextWord(line));
            const auto place = number ? numbers.find(*number) : numbers.end();
            if (place == numbers.end())
                return wrong(Message::say("a value belongs to a number that no point or cell has"));
            for (std::uint64_t skipped = 0; skipped < first; ++skipped)
                nextWord(line);
            double squares = 0;
            for (int i = 0; i < components; ++i) {
                const auto value = parseNumber<double>(nextWord(line));
                if (!value)
                    return wrong(Message::say("a value is missing or not a number"));
                squares += *value * *value;
                if (i == component)
                    values[place->second] = *value;
            }
            if (component < 0)
                values[place->second] = std::sqrt(squares);
        }
        return {};
    }

    Status skipLines(std::uint64_t count)
    {
        std::string_view line;
        for (std::uint64_t i = 0; i < count; ++i)
            if (!lines_.next(line))
                return wrong(Message::say("the file ends early"));
        return {};
    }

private:
    Error wrong(const Message& what) const
    {
        return {ErrorKind::BadInput, Message::say("line %1: %2.", lines_.number(), what)};
    }

    Status step(std::string_view& line, MarkedText what, std::uint64_t done, std::uint64_t count)
    {
        constexpr std::uint64_t linesBetweenReports = 1 << 15;
        if (done % linesBetweenReports == 0) {
            if (progress_.cancelled())
                return cancelledError(readingUcd);
            progress_.report(lines_.fraction(), readingUcd);
        }
        if (lines_.next(line))
            return {};
        return wrong(Message::say("the file ends after %1 of %2 %3", done, count, what));
    }

    Status corners(std::string_view line, const UcdShape& shape, CellComplex& complex)
    {
        std::array<std::uint64_t, 8> corners{};
        for (std::uint32_t i = 0; i < shape.corners; ++i) {
            const auto corner = parseNumber<std::int64_t>(nextWord(line));
            const auto place = corner ? numbers_.find(*corner) : numbers_.end();
            if (place == numbers_.end())
                return wrong(Message::say("a corner of a cell is not the number of a point"));
            // The apex of a pyramid comes first.
            const bool pyramid = shape.shape == CellShape::Pyramid;
            corners[pyramid ? (i + shape.corners - 1) % shape.corners : i] = place->second;
        }
        if (!nextWord(line).empty())
            return wrong(Message::say("a cell has more corners than its shape"));
        joinsPoints_ = joinsPoints_ || (shape.shape == CellShape::Flat && shape.corners > 1);
        complex.shapes.push_back(shape.shape);
        complex.corners.insert(complex.corners.end(), corners.begin(), corners.begin() + shape.corners);
        complex.offsets.push_back(complex.corners.size());
        return {};
    }

    UcdLines lines_;
    const Progress& progress_;
    UcdCounts counts_;
    bool joinsPoints_ = false;
    std::unordered_map<std::int64_t, std::uint64_t> numbers_;
    std::unordered_map<std::int64_t, std::uint64_t> cellNumbers_;
};

/// Without a choice: `arrays` are those of the points, unless there are none.
bool isGuess(const std::vector<FileArray>& arrays, const UcdCounts& counts)
{
    return arrays.size() > 1 || (counts.perPoint > 0 && counts.perCell > 0);
}

bool isBinaryUcd(std::string_view bytes)
{
    return bytes.starts_with('\7');
}

Error binaryUcd()
{
    return {ErrorKind::BadInput, Message::say("it is a binary UCD file, and only text is read. Write it as text, or as "
                                              ".vtu, for instance with ParaView.")};
}

} // namespace

bool looksLikeUcd(std::string_view firstBytes)
{
    if (isBinaryUcd(firstBytes)) // to say what it is
        return true;
    UcdLines lines(firstBytes);
    std::string_view line;
    UcdCounts counts;
    return lines.next(line) && parseCounts(line, counts);
}

Result<CellsFile> readUcd(std::string_view bytes, const CellsRequest& request, const Progress& progress)
{
    if (isBinaryUcd(bytes))
        return binaryUcd();
    UcdReading reading(bytes, progress);
    CellsFile file;
    if (const Status status = reading.head(); !status)
        return status.error();
    if (const Status status = reading.points(file.complex.positions); !status)
        return status.error();
    if (const Status status = reading.cells(file.complex); !status)
        return status.error();
    file.joinsPoints = reading.joinsPoints();
    std::vector<FileArray> arrays;
    for (const bool perCell : {false, true}) {
        const std::uint64_t perItem = perCell ? reading.counts().perCell : reading.counts().perPoint;
        const std::size_t firstArray = arrays.size();
        if (const Status status = reading.arrays(perItem, perCell, arrays); !status)
            return status.error();
        std::uint64_t place = 0;
        for (std::size_t i = firstArray; i < arrays.size(); ++i) {
            if (request.array.empty() || arrays[i].name == request.array) {
                const auto component = componentOf(request, arrays[i].components);
                if (!component)
                    return component.error();
                file.values.perCell = perCell;
                if (const Status status =
                        reading.values(perCell, place, arrays[i].components, *component, file.values.values);
                    !status)
                    return status.error();
                file.arrayName = takenName(arrays[i], *component);
                file.taken = takenOf(request, arrays[i], *component, isGuess(arrays, reading.counts()));
                return file;
            }
            place += static_cast<std::uint64_t>(arrays[i].components);
        }
        if (perItem > 0)
            if (const Status status = reading.skipLines(perCell ? reading.counts().cells : reading.counts().points);
                !status)
                return status.error();
    }
    return unknownArray(request.array, arrays);
}

Result<FileContents> probeUcd(std::string_view bytes, const CellsRequest& request)
{
    if (isBinaryUcd(bytes))
        return binaryUcd();
    UcdReading reading(bytes, {});
    if (const Status status = reading.head(); !status)
        return status.error();
    const UcdCounts& counts = reading.counts();
    FileContents contents;
    contents.domain = DomainClass::Irregular;
    contents.points = counts.points;
    contents.cells = counts.cells;
    contents.type = SampleType::Float32;
    if (const Status status = reading.skipLines(counts.points + counts.cells); !status)
        return status.error();
    if (const Status status = reading.arrays(counts.perPoint, false, contents.arrays); !status)
        return status.error();
    if (counts.perCell > 0 && counts.perPoint > 0)
        if (const Status status = reading.skipLines(counts.points); !status)
            return status.error();
    if (const Status status = reading.arrays(counts.perCell, true, contents.arrays); !status)
        return status.error();
    const auto chosen = request.array.empty() ? contents.arrays.begin()
                                              : std::ranges::find(contents.arrays, request.array, &FileArray::name);
    if (chosen == contents.arrays.end())
        return request.array.empty() ? Result<FileContents>(contents) : unknownArray(request.array, contents.arrays);
    const auto component = componentOf(request, chosen->components);
    if (!component)
        return component.error();
    contents.taken = takenOf(request, *chosen, *component, contents.arrays.size() > 1);
    return contents;
}

} // namespace tetra
