// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_file.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

namespace tetra {

namespace {

template <class Real, class Bits> double realAt(const std::byte* place, std::endian order)
{
    Bits bits = 0;
    std::memcpy(&bits, place, sizeof bits);
    if (order != std::endian::native)
        bits = sizeof bits == 4 ? static_cast<Bits>(__builtin_bswap32(static_cast<std::uint32_t>(bits)))
                                : static_cast<Bits>(__builtin_bswap64(static_cast<std::uint64_t>(bits)));
    return static_cast<double>(std::bit_cast<Real>(bits));
}

/// Checks the length before and behind a record of `payload` bytes at `offset`.
bool marksFit(const Plot3dFile& file, std::uint64_t offset, std::uint64_t payload)
{
    const auto mark = [&](std::uint64_t at) {
        return static_cast<std::uint32_t>(plot3dInteger(file.source.file->bytes(), at, file.layout.order));
    };
    const auto length = static_cast<std::uint32_t>(payload); // records beyond 4 GiB have what is left of it
    return mark(offset - 4) == length && mark(offset + payload) == length;
}

bool allMarksFit(const Plot3dFile& file)
{
    for (std::size_t grid = 0; grid < file.layout.sizes.size(); ++grid) {
        const Plot3dBlock block = plot3dBlock(file.layout, file.kind, grid);
        const std::uint64_t reals = (file.kind == Plot3dKind::Grid ? 3 : 5) * block.points * file.layout.realBytes;
        if (!marksFit(file, block.reals, reals + (file.layout.iblank ? 4 * block.points : 0)))
            return false;
        const std::uint64_t state = std::uint64_t(4) * file.layout.realBytes;
        if (file.kind == Plot3dKind::Solution && !marksFit(file, block.reals - 8 - state, state))
            return false;
    }
    return true;
}

bool endsInZeros(const Plot3dFile& file)
{
    return std::ranges::all_of(file.source.file->bytes().last(file.layout.padding),
                               [](std::byte byte) { return byte == std::byte{}; });
}

Error changedMeanwhile(const std::filesystem::path& path)
{
    return inPlot3dFile(path, Message::say("it changed while it was read. Read it again."));
}

} // namespace

Error inPlot3dFile(const std::filesystem::path& path, const Message& text, ErrorKind kind)
{
    return {kind, Message::say("Cannot read '%1': %2", path.string(), text), path};
}

Result<Plot3dSource> loadPlot3d(const std::filesystem::path& path, const Progress& progress)
{
    constexpr std::size_t looked = 4096;
    const auto mapped = MappedFile::open(path);
    if (!mapped)
        return mapped.error();
    const std::span<const std::byte> bytes = (*mapped)->bytes();
    if (bytes.empty())
        return inPlot3dFile(path, Message::say("it is empty. Get or make the file again."));
    if (!isPlot3dText(bytes.first(std::min(looked, bytes.size()))))
        return Plot3dSource{*mapped, nullptr};
    auto text = readPlot3dText(bytes, progress);
    if ((*mapped)->damaged())
        return changedMeanwhile(path);
    if (!text)
        return text.error().kind == ErrorKind::BadInput ? inPlot3dFile(path, text.error().message) : text.error();
    return Plot3dSource{*mapped, std::make_shared<const Plot3dText>(*std::move(text))};
}

Result<Plot3dLayout> findPlot3dLayout(const Plot3dSource& source, Plot3dKind kind)
{
    const std::span<const std::byte> bytes = source.file->bytes();
    return source.text ? findPlot3dLayout(*source.text, kind) : findPlot3dLayout(bytes, bytes.size(), kind);
}

Result<Plot3dFile> openPlot3d(const Plot3dSource& source, Plot3dKind kind)
{
    const std::filesystem::path& path = source.file->path();
    const auto layout = findPlot3dLayout(source, kind);
    if (!layout)
        return inPlot3dFile(path, layout.error().message);
    Plot3dFile file{source, kind, *layout};
    if (file.layout.recordMarks && !allMarksFit(file))
        return inPlot3dFile(
            path,
            Message::say("the lengths of its Fortran records do not fit the sizes of its grids. Copy the file again."));
    if (!endsInZeros(file))
        return inPlot3dFile(path, Message::say("%1 bytes too many follow its data. Check that it is a PLOT3D file.",
                                               file.layout.padding));
    return file;
}

Result<std::vector<std::size_t>> chooseGrids(const Plot3dFile& file, std::int64_t wanted)
{
    const std::size_t count = file.layout.sizes.size();
    const std::filesystem::path& path = file.path();
    if (wanted == 0 && count > 1) {
        std::vector<std::size_t> all(count);
        std::iota(all.begin(), all.end(), std::size_t(0));
        return all;
    }
    if (wanted > static_cast<std::int64_t>(count))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' has no grid %2: it holds %3.", path.string(), wanted, count), path};
    const std::size_t grid = wanted == 0 ? 0 : static_cast<std::size_t>(wanted - 1);
    const auto& size = file.layout.sizes[grid];
    if (std::ranges::min(size) < 2)
        return inPlot3dFile(
            path,
            Message::say(
                "its grid has %1 x %2 x %3 points. TAn takes volumes: at least two points along each of three axes.",
                size[0], size[1], size[2]));
    return std::vector{grid};
}

std::uint64_t pointCountOf(const Plot3dFile& file, std::size_t grid)
{
    return plot3dBlock(file.layout, file.kind, grid).points;
}

namespace {

/// Of a binary file, from an offset in bytes.
void readReals(const Plot3dFile& file, std::uint64_t offset, std::span<double> to)
{
    const std::uint32_t realBytes = file.layout.realBytes;
    const std::byte* place = file.source.file->bytes().data() + offset;
    for (double& real : to) {
        real = realBytes == 4 ? realAt<float, std::uint32_t>(place, file.layout.order)
                              : realAt<double, std::uint64_t>(place, file.layout.order);
        place += realBytes;
    }
}

} // namespace

Status readComponent(const Plot3dFile& file, std::size_t grid, std::size_t number, std::uint64_t first,
                     std::span<double> to)
{
    const Plot3dBlock block = plot3dBlock(file.layout, file.kind, grid);
    const std::uint64_t begin = number * block.points + first;
    if (file.source.text) {
        std::copy_n(file.source.text->numbers.data() + block.reals + begin, to.size(), to.begin());
        return {};
    }
    readReals(file, block.reals + begin * file.layout.realBytes, to);
    return file.source.file->damaged() ? Status(changedMeanwhile(file.path())) : Status();
}

std::array<double, 4> flowState(const Plot3dFile& solution, std::size_t grid)
{
    std::array<double, 4> state{};
    const std::uint64_t begin = plot3dBlock(solution.layout, solution.kind, grid).state;
    if (solution.source.text)
        std::copy_n(solution.source.text->numbers.data() + begin, state.size(), state.begin());
    else
        readReals(solution, begin, state);
    return state;
}

std::vector<std::uint8_t> blankedPoints(const Plot3dFile& file, std::size_t grid)
{
    const Plot3dBlock block = plot3dBlock(file.layout, file.kind, grid);
    if (block.iblank == 0)
        return {};
    std::vector<std::uint8_t> blanked(block.points);
    for (std::uint64_t point = 0; point < block.points; ++point)
        blanked[point] = file.source.text ? file.source.text->numbers[block.iblank + point] == 0
                                          : plot3dInteger(file.source.file->bytes(), block.iblank + 4 * point,
                                                          file.layout.order) == 0;
    if (std::ranges::find(blanked, 1) == blanked.end())
        return {};
    return blanked;
}

} // namespace tetra
