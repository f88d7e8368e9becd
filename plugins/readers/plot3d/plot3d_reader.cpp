// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_reader.h"

#include "plugins/api/cells_parameters.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/plot3d/plot3d_arrays.h"
#include "plugins/readers/plot3d/plot3d_names.h"

#include <tan/data.h>
#include <tan/zones.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace tetra {

namespace {

namespace fs = std::filesystem;

/// The two files of a dataset.
struct Pair {
    fs::path grid;
    fs::path solution;
    Plot3dSource opened; ///< the one of them that the user opened
};

std::string namesText(const std::vector<fs::path>& names)
{
    std::string list;
    for (const fs::path& name : names)
        list += (list.empty() ? "" : ", ") + name.filename().string();
    return list;
}

bool isSolution(const Plot3dSource& source)
{
    return !findPlot3dLayout(source, Plot3dKind::Grid) && findPlot3dLayout(source, Plot3dKind::Solution);
}

Result<Pair> findPair(const fs::path& path, const std::string& solutionGiven, const Progress& progress)
{
    const auto source = loadPlot3d(path, progress);
    if (!source)
        return source.error();
    if (!solutionGiven.empty()) {
        const fs::path solution(solutionGiven);
        return Pair{path, solution.is_absolute() ? solution : path.parent_path() / solution, *source};
    }
    if (isSolution(*source)) {
        const fs::path grid = firstExisting(gridNames(path));
        if (grid.empty())
            return inPlot3dFile(path, Message::say("it is a PLOT3D solution, and its grid is not next to it (%1). Open "
                                                   "the grid, and give it the solution.",
                                                   namesText(gridNames(path))));
        return Pair{grid, path, *source};
    }
    const fs::path solution = firstExisting(solutionNames(path));
    if (solution.empty())
        if (const auto grid = findPlot3dLayout(*source, Plot3dKind::Grid); !grid)
            return inPlot3dFile(path, grid.error().message);
    if (solution.empty())
        return inPlot3dFile(path,
                            Message::say("it is a grid without values, and no solution is next to it (%1). Say where "
                                         "it is with 'solution', or give it one of these names.",
                                         namesText(solutionNames(path))),
                            ErrorKind::WrongUsage);
    return Pair{path, solution, *source};
}

/// The file of the pair that is of this kind, read if it was not opened yet.
Result<Plot3dFile> openOf(const Pair& pair, Plot3dKind kind, const Progress& progress)
{
    const fs::path& path = kind == Plot3dKind::Grid ? pair.grid : pair.solution;
    const auto source = path == pair.opened.file->path() ? pair.opened : loadPlot3d(path, progress);
    return source ? openPlot3d(*source, kind) : source.error();
}

struct OpenPair {
    Plot3dFile grid;
    Plot3dFile solution;
    std::vector<std::size_t> numbers; ///< of the grids that are taken, and of their solutions
};

Result<OpenPair> openPair(const Pair& pair, std::int64_t wanted, const Progress& progress)
{
    const auto grid = openOf(pair, Plot3dKind::Grid, progress);
    if (!grid)
        return grid.error();
    const auto numbers = chooseGrids(*grid, wanted);
    if (!numbers)
        return numbers.error();
    const auto solution = openOf(pair, Plot3dKind::Solution, progress);
    if (!solution)
        return solution.error();
    if (solution->layout.sizes != grid->layout.sizes)
        return inPlot3dFile(pair.solution, Message::say("it is the solution of another grid: its sizes differ from "
                                                        "those of '%1'. Choose another one with 'solution'.",
                                                        pair.grid.string()));
    return OpenPair{*grid, *solution, *numbers};
}

Result<std::vector<Eigen::Vector3d>> readPositions(const Plot3dFile& grid, std::size_t number, const Progress& progress)
{
    std::vector<Eigen::Vector3d> positions(pointCountOf(grid, number));
    std::vector<double> component;
    const Status read = forPieces(positions.size(), progress, [&](std::uint64_t first, std::uint64_t count) -> Status {
        component.resize(count);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (const Status got = readComponent(grid, number, axis, first, component); !got)
                return got;
            for (std::size_t i = 0; i < count; ++i)
                positions[first + i][static_cast<Eigen::Index>(axis)] = component[i];
        }
        return {};
    });
    if (!read)
        return read.error();
    return positions;
}

/// Cells with a corner that is blanked out are holes; null if there are none.
std::shared_ptr<const std::vector<GridCell>> cellsWithout(std::span<const std::uint8_t> blanked, const Lattice& lattice)
{
    if (blanked.empty())
        return nullptr;
    std::vector<GridCell> cells;
    cells.reserve(lattice.cellCount());
    const auto& size = lattice.size;
    for (std::uint32_t k = 0; k + 1 < size[2]; ++k)
        for (std::uint32_t j = 0; j + 1 < size[1]; ++j)
            for (std::uint32_t i = 0; i + 1 < size[0]; ++i) {
                std::uint8_t hides = 0;
                for (std::uint32_t corner = 0; corner < 8; ++corner)
                    hides |= blanked[lattice.index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2))];
                cells.push_back(hides != 0 ? GridCell::Blanked : GridCell::Kept);
            }
    return std::make_shared<const std::vector<GridCell>>(std::move(cells));
}

/// Of the flow; of several grids that of the first, as a rule that of all.
void tellState(const OpenPair& pair, std::vector<Message>& leftOut)
{
    const std::array<double, 4> state = flowState(pair.solution, pair.numbers.front());
    if (std::ranges::any_of(state, [](double number) { return std::isfinite(number) && std::abs(number) > 0; }))
        leftOut.push_back(Message::say(
            "The solution states: Mach number %1, angle of attack %2, Reynolds number %3, time %4. They are not used.",
            formatNumber(state[0]), formatNumber(state[1]), formatNumber(state[2]), formatNumber(state[3])));
}

/// What was taken of what the two files offer.
void tellChoices(const OpenPair& pair, std::int64_t wanted, const std::string& arrayName, const std::string& taken,
                 std::vector<Taken>& choices, std::vector<Message>& leftOut)
{
    const std::size_t count = pair.grid.layout.sizes.size();
    if (!taken.empty())
        choices.push_back({TakenPart::Array, taken, arrayName == "automatic"});
    tellState(pair, leftOut);
    if (count == 1)
        return;
    choices.push_back({TakenPart::Block, wanted == 0 ? Message::say("all %1 grids", count)
                                                     : Message::say("grid %1 of %2", wanted, count)});
    if (wanted != 0)
        leftOut.push_back(Message::say("It holds %1 grids; the others are not read.", count));
}

/// One grid, with its holes.
Result<Dataset> zoneOf(const OpenPair& pair, const Plot3dGrid& grid, const ScalarField& values,
                       const Progress& progress)
{
    auto positions = readPositions(pair.grid, grid.number, progress);
    if (!positions)
        return positions.error();
    Dataset zone;
    zone.domain = DomainClass::Curvilinear;
    zone.lattice.size = pair.grid.layout.sizes[grid.number];
    zone.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(*std::move(positions));
    zone.values = values;
    zone.source.name = std::to_string(grid.number + 1);
    if (std::ranges::min(zone.lattice.size) >= 2)
        zone.cells = cellsWithout(grid.blanked, zone.lattice);
    return zone;
}

/// What the user asks for.
struct Wanted {
    std::int64_t grid = 0;
    std::string array;
    ParameterValues values;                      ///< of which those of cellsParameters() count for a mesh
    std::optional<Eigen::AlignedBox3d> region{}; ///< of a mesh
};

/// All grids as one mesh.
Result<Dataset> meshOf(const OpenPair& pair, const std::vector<Dataset>& zones, const Source& source,
                       const Wanted& wanted, const Progress& progress)
{
    constexpr double joined = 0.3;
    const auto refused = [&](const Error& error) {
        if (error.kind != ErrorKind::BadInput)
            return error;
        return inPlot3dFile(
            pair.grid.path(),
            Message::say(
                "its %1 grids do not make a mesh together. %2 Alternatively choose one of them: 'grid' from 1 to %3.",
                zones.size(), error.message, zones.size()));
    };
    auto together = joinZones(zones, progress.part(0, joined));
    if (!together)
        return refused(together.error());
    together->complex.region = wanted.region;
    if (const Status understood = applyCellsParameters(wanted.values, together->complex); !understood)
        return understood.error();
    auto mesh = irregularDataset(together->complex, together->values, source, progress.part(joined, 1));
    if (!mesh)
        return refused(mesh.error());
    mesh->remarks.insert(mesh->remarks.begin(), together->remarks.begin(), together->remarks.end());
    return mesh;
}

Result<Dataset> readDataset(const fs::path& path, const OpenPair& pair, const Wanted& wanted, const Progress& progress)
{
    constexpr double haveValues = 0.4, haveZones = 0.6;
    std::vector<Plot3dGrid> grids;
    for (const std::size_t number : pair.numbers)
        grids.push_back({number, blankedPoints(pair.grid, number)});
    const auto array = readPlot3dArray(pair.solution, grids, wanted.array, progress.part(0, haveValues));
    if (!array)
        return array.error();
    Source source{
        .name = pair.grid.path().filename().string() + ", " + array->name, .path = path, .valueName = array->name};
    tellChoices(pair, wanted.grid, wanted.array, array->name, source.taken, source.leftOut);
    std::vector<Dataset> zones;
    for (std::size_t i = 0; i < grids.size(); ++i) {
        auto zone = zoneOf(pair, grids[i], array->values[i], progress.part(haveValues, haveZones));
        if (!zone)
            return zone.error();
        zones.push_back(*std::move(zone));
    }
    if (zones.size() > 1)
        return meshOf(pair, zones, source, wanted, progress.part(haveZones, 1));
    Dataset dataset = std::move(zones.front());
    dataset.source = std::move(source);
    if (const Status usable = hasHoles(dataset) ? Status() : checkGrid(dataset); !usable)
        return inPlot3dFile(pair.grid.path(), usable.error().message);
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

std::vector<std::string> gridTexts(const Plot3dLayout& layout)
{
    std::vector<std::string> texts;
    for (const auto& size : layout.sizes)
        texts.push_back(std::to_string(texts.size() + 1) + ": " + std::to_string(size[0]) + " x " +
                        std::to_string(size[1]) + " x " + std::to_string(size[2]));
    return texts;
}

Result<FileContents> contentsOf(const Pair& pair, std::int64_t wanted, const std::string& arrayName,
                                const Progress& progress)
{
    FileContents contents{.domain = DomainClass::Curvilinear, .untold = {"unit"}};
    for (const std::string_view name : plot3dArrayNames())
        contents.arrays.push_back({.name = std::string(name)});
    const auto grid = openOf(pair, Plot3dKind::Grid, progress.part(0, 0.5));
    if (!grid)
        return grid.error();
    if (grid->layout.sizes.size() > 1)
        contents.blocks = gridTexts(grid->layout);
    const auto open = openPair({pair.grid, pair.solution, grid->source}, wanted, progress.part(0.5, 1));
    if (!open)
        return open.error();
    contents.type = open->solution.layout.realBytes == 4 ? SampleType::Float32 : SampleType::Float64;
    // Which array "automatic" takes depends on the values.
    tellChoices(*open, wanted, arrayName, arrayName == "automatic" ? std::string() : arrayName, contents.taken,
                contents.leftOut);
    if (open->numbers.size() > 1)
        return contents;
    contents.lattice.size = open->grid.layout.sizes[open->numbers.front()];
    contents.points = contents.lattice.pointCount();
    return contents;
}

} // namespace

std::vector<std::string> Plot3dReader::nameFilters() const
{
    return {Message::marked("PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)")};
}

namespace {

/// Of a file, or of what is in the one with ".gz" of this name if there is only that; less a multiple of 4 GiB then.
std::uint64_t bytesOf(fs::path path)
{
    std::error_code problem;
    const std::uint64_t bytes = fs::file_size(path, problem);
    if (!problem)
        return bytes;
    const auto packed = MappedFile::open(path += ".gz");
    constexpr std::size_t sizeBytes = 4; // the last ones, the lowest first
    if (!packed || (*packed)->bytes().size() < sizeBytes)
        return 0;
    std::uint64_t size = 0;
    for (std::size_t place = 0; place < sizeBytes; ++place)
        size |= std::uint64_t((*packed)->bytes().last(sizeBytes)[place]) << 8 * place;
    return size;
}

/// Whether what comes first is a record as Fortran writes them: its length, so many bytes, and its length again. Of a
/// grid that is how many grids there are, or its three sizes.
bool beginsWithARecord(std::span<const std::byte> firstBytes)
{
    constexpr std::size_t lengthBytes = 4, oneNumber = 4, threeNumbers = 12;
    for (const std::size_t length : {oneNumber, threeNumbers}) {
        if (firstBytes.size() < lengthBytes + length + lengthBytes)
            continue;
        const auto first = firstBytes.first(lengthBytes), again = firstBytes.subspan(lengthBytes + length, lengthBytes);
        std::array<std::byte, lengthBytes> little{std::byte(length)}, big{};
        big.back() = std::byte(length);
        for (const auto& mark : {little, big})
            if (std::ranges::equal(first, mark) && std::ranges::equal(again, mark))
                return true;
    }
    return false;
}

} // namespace

double Plot3dReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr std::array<std::string_view, 7> ownNames = {".x", ".g", ".grd", ".p3d", ".q", ".qsol", ".xyz"};
    constexpr double binary = 0.9, text = 0.85, toSayWhatIsWrong = 0.2;
    for (const Plot3dKind kind : {Plot3dKind::Grid, Plot3dKind::Solution})
        if (findPlot3dLayout(firstBytes, bytesOf(path), kind))
            return binary;
    const std::string ending = fileEnding(path);
    if (std::ranges::find(ownNames, ending) == ownNames.end())
        return 0;
    if (looksLikePlot3dText(firstBytes))
        return text;
    const bool mayBeAnything = ending == ".xyz" && !beginsWithARecord(firstBytes);
    return mayBeAnything ? 0 : toSayWhatIsWrong;
}

std::vector<Parameter> Plot3dReader::parameters() const
{
    Parameter array;
    array.id = "array";
    array.label = Message::marked("Values");
    array.explanation = Message::marked("Which scalar of the solution: automatic takes the density, or, if that is the "
                                        "same everywhere, the first that varies.");
    array.defaultValue = std::string("automatic");
    array.choices = {Message::marked("automatic")};
    for (const std::string_view name : plot3dArrayNames())
        array.choices.emplace_back(name);
    Parameter solution;
    solution.id = "solution";
    solution.label = Message::marked("Solution file");
    solution.explanation =
        Message::marked("The PLOT3D solution of the grid; by default the one next to it with a matching name.");
    solution.defaultValue = std::string();
    Parameter grid;
    grid.id = "grid";
    grid.label = Message::marked("Grid");
    grid.explanation = Message::marked("Which grid of a PLOT3D file with several, from 1; 0 joins all into one mesh.");
    grid.defaultValue = std::int64_t(0);
    grid.minimum = 0;
    grid.maximum = 10000;
    std::vector<Parameter> all = {array, solution, grid, unitParameter()};
    std::ranges::move(cellsParameters(), std::back_inserter(all));
    return all;
}

namespace {

Result<Dataset> readPair(const std::vector<Parameter>& all, const fs::path& path, const ParameterValues& values,
                         const std::optional<Eigen::AlignedBox3d>& region, const Progress& progress)
{
    const Wanted wanted{parameterValue<std::int64_t>(all, values, "grid"),
                        parameterValue<std::string>(all, values, "array"), values, region};
    const auto pair = findPair(path, parameterValue<std::string>(all, values, "solution"), progress.part(0, 0.2));
    if (!pair)
        return pair.error();
    const auto open = openPair(*pair, wanted.grid, progress.part(0.2, 0.4));
    if (!open)
        return open.error();
    auto dataset = readDataset(path, *open, wanted, progress.part(0.4, 1));
    if (dataset)
        dataset->lengthUnit = placementText(values, "unit");
    return dataset;
}

} // namespace

Result<Dataset> Plot3dReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    return readPair(parameters(), path, values, std::nullopt, progress);
}

Result<Dataset> Plot3dReader::readAround(const Eigen::AlignedBox3d& region, const fs::path& path,
                                         const ParameterValues& values, const Progress& progress) const
{
    return readPair(parameters(), path, values, region, progress);
}

std::vector<fs::path> Plot3dReader::companions(const fs::path& path, const ParameterValues& values) const
{
    fs::path solution = parameterValue<std::string>(parameters(), values, "solution");
    if (solution.empty())
        return isSolutionName(path) ? gridNames(path) : solutionNames(path);
    if (fileEnding(solution) == ".gz")
        solution.replace_extension();
    return {path.parent_path() / solution};
}

Result<FileContents> Plot3dReader::probe(const fs::path& path, const ParameterValues& values,
                                         const Progress& progress) const
{
    const auto all = parameters();
    const auto pair = findPair(path, parameterValue<std::string>(all, values, "solution"), progress.part(0, 0.5));
    if (!pair)
        return pair.error();
    return contentsOf(*pair, parameterValue<std::int64_t>(all, values, "grid"),
                      parameterValue<std::string>(all, values, "array"), progress.part(0.5, 1));
}

} // namespace tetra
