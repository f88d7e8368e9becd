// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_layout.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

namespace tetra {

namespace {

constexpr std::uint64_t integerBytes = 4;
constexpr std::uint64_t markBytes = 4;
constexpr std::uint64_t mostPadding = 511; ///< files are filled up to whole blocks
constexpr std::int32_t mostGrids = 10000;
constexpr std::uint64_t mostPoints = std::uint64_t(1) << 32;
constexpr std::uint64_t numbersOfAState = 4; ///< Mach number, angle of attack, Reynolds number, time
constexpr std::uint64_t coordinates = 3;

/// The sizes of a grid as points along each axis; nothing if they are no sizes.
template <class Number> std::optional<std::array<std::uint32_t, 3>> sizeOf(std::span<const Number> numbers)
{
    std::array<std::uint32_t, 3> size{1, 1, 1};
    std::uint64_t points = 1;
    for (std::size_t axis = 0; axis < numbers.size(); ++axis) {
        const auto number = static_cast<double>(numbers[axis]);
        if (!(number >= 1 && number <= std::numeric_limits<std::int32_t>::max()))
            return std::nullopt;
        size[axis] = static_cast<std::uint32_t>(number);
        if (size[axis] != number || __builtin_mul_overflow(points, std::uint64_t(size[axis]), &points) ||
            points > mostPoints)
            return std::nullopt;
    }
    return size;
}

/// What comes before the data of the first grid, as one way of reading it has it.
struct Front {
    std::vector<std::array<std::uint32_t, 3>> sizes;
    std::uint64_t bytes = 0;
};

/// Takes integers from the beginning of a file, record by record; nothing once something does not fit.
class FrontReader {
public:
    FrontReader(std::span<const std::byte> bytes, const Plot3dLayout& layout, std::uint32_t dimensions)
        : bytes_(bytes), layout_(layout), dimensions_(dimensions)
    {
    }

    std::optional<Front> read()
    {
        Front front;
        std::uint64_t grids = 1;
        if (layout_.multiGrid) {
            const auto count = record(1);
            if (count.empty() || count[0] < 1 || count[0] > mostGrids)
                return std::nullopt;
            grids = static_cast<std::uint64_t>(count[0]);
        }
        const auto numbers = record(grids * dimensions_);
        if (numbers.empty())
            return std::nullopt;
        for (std::uint64_t grid = 0; grid < grids; ++grid) {
            const auto size = sizeOf(std::span<const std::int32_t>(numbers).subspan(grid * dimensions_, dimensions_));
            if (!size)
                return std::nullopt;
            front.sizes.push_back(*size);
        }
        front.bytes = offset_;
        return front;
    }

private:
    /// The integers of the next record; empty if it is not one of so many.
    std::vector<std::int32_t> record(std::uint64_t count)
    {
        const std::uint64_t payload = count * integerBytes;
        const std::uint64_t marks = layout_.recordMarks ? 2 * markBytes : 0;
        if (bytes_.size() - offset_ < payload + marks)
            return {};
        if (layout_.recordMarks && (next() != payload || !skipTo(payload)))
            return {};
        std::vector<std::int32_t> numbers;
        for (std::uint64_t i = 0; i < count; ++i)
            numbers.push_back(static_cast<std::int32_t>(next()));
        if (layout_.recordMarks)
            next();
        return numbers;
    }
    /// Whether the mark behind a record of `payload` bytes that begins here repeats its length.
    bool skipTo(std::uint64_t payload) const
    {
        return static_cast<std::uint32_t>(plot3dInteger(bytes_, offset_ + payload, layout_.order)) == payload;
    }
    std::uint32_t next()
    {
        const std::int32_t number = plot3dInteger(bytes_, offset_, layout_.order);
        offset_ += integerBytes;
        return static_cast<std::uint32_t>(number);
    }

    std::span<const std::byte> bytes_;
    const Plot3dLayout& layout_;
    std::uint32_t dimensions_;
    std::uint64_t offset_ = 0;
};

std::uint64_t pointsOf(const std::array<std::uint32_t, 3>& size)
{
    return std::uint64_t(size[0]) * size[1] * size[2];
}

/// What a number takes: bytes, and in a text one number.
std::uint64_t integerLength(const Plot3dLayout& layout)
{
    return layout.text ? 1 : integerBytes;
}

std::uint64_t realLength(const Plot3dLayout& layout)
{
    return layout.text ? 1 : layout.realBytes;
}

/// What one grid's records take.
std::uint64_t gridLength(const Plot3dLayout& layout, Plot3dKind kind, std::uint64_t points, std::uint64_t dimensions)
{
    const std::uint64_t marks = layout.recordMarks ? 2 * markBytes : 0;
    if (kind == Plot3dKind::Grid)
        return marks + points * (dimensions * realLength(layout) + (layout.iblank ? integerLength(layout) : 0));
    return 2 * marks + (numbersOfAState + (dimensions + 2) * points) * realLength(layout);
}

/// One way of reading the file, and how long it would be: in bytes, of a text in numbers.
struct Candidate {
    Plot3dLayout layout;
    std::uint64_t length = 0;
};

/// The layout with and without iblank.
void addCandidates(Plot3dLayout layout, Plot3dKind kind, std::uint64_t frontLength, std::uint64_t dimensions,
                   std::vector<Candidate>& found)
{
    for (const bool iblank : {false, true}) {
        if (iblank && kind == Plot3dKind::Solution)
            continue;
        layout.iblank = iblank;
        std::uint64_t length = frontLength;
        for (const auto& size : layout.sizes)
            length += gridLength(layout, kind, pointsOf(size), dimensions);
        found.push_back({layout, length});
    }
}

std::vector<Candidate> candidates(std::span<const std::byte> firstBytes, Plot3dKind kind, std::uint32_t dimensions)
{
    std::vector<Candidate> found;
    for (const std::endian order : {std::endian::little, std::endian::big})
        for (const bool marks : {false, true})
            for (const bool multi : {false, true}) {
                Plot3dLayout layout{.order = order, .recordMarks = marks, .multiGrid = multi};
                const auto front = FrontReader(firstBytes, layout, dimensions).read();
                if (!front)
                    continue;
                layout.sizes = front->sizes;
                for (const std::uint32_t realBytes : {4u, 8u}) {
                    layout.realBytes = realBytes;
                    addCandidates(layout, kind, front->bytes, dimensions, found);
                }
            }
    return found;
}

std::vector<Candidate> candidates(const Plot3dText& text, Plot3dKind kind, std::uint32_t dimensions)
{
    const std::span<const double> numbers = text.numbers;
    std::vector<Candidate> found;
    for (const bool multi : {false, true}) {
        Plot3dLayout layout{.text = true, .multiGrid = multi, .realBytes = text.singlePrecision ? 4u : 8u};
        const double grids = !multi ? 1 : numbers.empty() ? 0 : numbers[0];
        if (!(grids >= 1 && grids <= mostGrids))
            continue;
        const std::uint64_t first = multi ? 1 : 0, front = first + static_cast<std::uint64_t>(grids) * dimensions;
        if (front > numbers.size())
            continue;
        for (std::uint64_t at = first; at < front; at += dimensions)
            if (const auto size = sizeOf(numbers.subspan(at, dimensions)))
                layout.sizes.push_back(*size);
        if (layout.sizes.size() * dimensions == front - first)
            addCandidates(layout, kind, front, dimensions, found);
    }
    return found;
}

bool zerosFrom(std::span<const std::byte> firstBytes, std::uint64_t offset)
{
    return offset >= firstBytes.size() ||
           std::ranges::all_of(firstBytes.subspan(offset), [](std::byte byte) { return byte == std::byte{}; });
}

bool isSolid(const Plot3dLayout& layout)
{
    return std::ranges::all_of(layout.sizes, [](const auto& size) { return std::ranges::min(size) >= 2; });
}

std::string sizeText(const std::array<std::uint32_t, 3>& size)
{
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

/// Why no layout fits a file of this length; `flat` are those of two-dimensional grids.
Error explain(const std::vector<Candidate>& all, const std::vector<Candidate>& flat, std::uint64_t length)
{
    if (std::ranges::find(flat, length, &Candidate::length) != flat.end())
        return {ErrorKind::BadInput, Message::say("it holds a two-dimensional grid. TAn takes volumes: grids with "
                                                  "at least two points along each of three axes.")};
    const Candidate* nearest = nullptr;
    for (const Candidate& candidate : all)
        if (isSolid(candidate.layout) && (nearest == nullptr || candidate.length < nearest->length))
            nearest = &candidate;
    if (nearest == nullptr)
        return {ErrorKind::BadInput,
                Message::say("it is not a PLOT3D file: it does not begin with the sizes of its grids. If it is "
                             "of another program, export VTK, or a table of points with values.")};
    const std::string size = sizeText(nearest->layout.sizes[0]);
    const Message wanted =
        nearest->layout.text
            ? Message::say("it begins like a grid of %1 points, which takes %2 numbers or more, and has %3", size,
                           nearest->length, length)
            : Message::say("it begins like a grid of %1 points, which takes %2 bytes or more, and has %3", size,
                           nearest->length, length);
    constexpr std::uint64_t hardlyCut = 1000; // so much of a file is not lost
    if (nearest->layout.text && nearest->length / hardlyCut > length)
        return {ErrorKind::BadInput,
                Message::say("%1: it is of another format that begins with whole numbers, such as a surface of "
                             "MOVIE.BYU, or only the beginning of a grid. Export its data as PLOT3D, .vtu or a table.",
                             wanted)};
    if (nearest->length > length)
        return {ErrorKind::BadInput, Message::say("%1: it is cut short. Copy the file again.", wanted)};
    return {ErrorKind::BadInput, Message::say("%1, which fits no kind of PLOT3D file.", wanted)};
}

} // namespace

std::int32_t plot3dInteger(std::span<const std::byte> bytes, std::uint64_t offset, std::endian order)
{
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return static_cast<std::int32_t>(order == std::endian::native ? number : __builtin_bswap32(number));
}

Plot3dBlock plot3dBlock(const Plot3dLayout& layout, Plot3dKind kind, std::size_t grid)
{
    const std::uint64_t mark = layout.recordMarks ? markBytes : 0;
    const std::uint64_t integer = integerLength(layout), real = realLength(layout);
    std::uint64_t offset =
        (layout.multiGrid ? integer + 2 * mark : 0) + 2 * mark + layout.sizes.size() * coordinates * integer;
    for (std::size_t before = 0; before < grid; ++before)
        offset += gridLength(layout, kind, pointsOf(layout.sizes[before]), coordinates);
    Plot3dBlock block;
    block.points = pointsOf(layout.sizes[grid]);
    block.reals = offset + mark + (kind == Plot3dKind::Solution ? numbersOfAState * real + 2 * mark : 0);
    block.state = offset + mark;
    if (layout.iblank)
        block.iblank = block.reals + coordinates * block.points * real;
    return block;
}

Result<Plot3dLayout> findPlot3dLayout(std::span<const std::byte> firstBytes, std::uint64_t fileBytes, Plot3dKind kind)
{
    const std::vector<Candidate> all = candidates(firstBytes, kind, 3);
    const Candidate* best = nullptr;
    for (const Candidate& candidate : all)
        if (candidate.length <= fileBytes && fileBytes - candidate.length <= mostPadding &&
            zerosFrom(firstBytes, candidate.length) && (best == nullptr || candidate.length > best->length))
            best = &candidate;
    if (best == nullptr)
        return explain(all, candidates(firstBytes, kind, 2), fileBytes);
    Plot3dLayout layout = best->layout;
    layout.padding = fileBytes - best->length;
    return layout;
}

Result<Plot3dLayout> findPlot3dLayout(const Plot3dText& text, Plot3dKind kind)
{
    const std::vector<Candidate> all = candidates(text, kind, 3);
    const auto fitting = std::ranges::find(all, text.numbers.size(), &Candidate::length);
    if (fitting == all.end())
        return explain(all, candidates(text, kind, 2), text.numbers.size());
    return fitting->layout;
}

} // namespace tetra
