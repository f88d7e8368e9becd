// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_reader.h"

#include "plugins/readers/plot3d/plot3d_arrays.h"
#include "plugins/readers/plot3d/plot3d_names.h"

#include <tan/data.h>

#include <algorithm>

namespace tetra {

namespace {

namespace fs = std::filesystem;

/// The two files of a dataset.
struct Pair {
    fs::path grid;
    fs::path solution;
};

std::string namesText(const std::vector<fs::path>& names)
{
    std::string list;
    for (const fs::path& name : names)
        list += (list.empty() ? "" : ", ") + name.filename().string();
    return list;
}

bool isSolution(const fs::path& path)
{
    const auto file = MappedFile::open(path);
    return file && !findPlot3dLayout((*file)->bytes(), (*file)->bytes().size(), Plot3dKind::Grid) &&
           findPlot3dLayout((*file)->bytes(), (*file)->bytes().size(), Plot3dKind::Solution);
}

Result<Pair> findPair(const fs::path& path, const std::string& solutionGiven)
{
    if (!solutionGiven.empty()) {
        const fs::path solution(solutionGiven);
        return Pair{path, solution.is_absolute() ? solution : path.parent_path() / solution};
    }
    if (isSolution(path)) {
        const fs::path grid = firstExisting(gridNames(path));
        if (grid.empty())
            return inPlot3dFile(path, Message::say("it is a PLOT3D solution, and its grid is not beside it (%1). Open "
                                                   "the grid, and give it the solution.",
                                                   namesText(gridNames(path))));
        return Pair{grid, path};
    }
    const fs::path solution = firstExisting(solutionNames(path));
    if (solution.empty())
        return inPlot3dFile(path,
                            Message::say("it is a grid without values, and no solution is beside it (%1). Say where it "
                                         "is with 'solution', or give it one of these names.",
                                         namesText(solutionNames(path))),
                            ErrorKind::WrongUsage);
    return Pair{path, solution};
}

struct OpenPair {
    Plot3dFile grid;
    Plot3dFile solution;
    std::size_t number = 0; ///< of the grid, and of its solution
};

Result<OpenPair> openPair(const Pair& pair, std::int64_t wanted)
{
    const auto grid = openPlot3d(pair.grid, Plot3dKind::Grid);
    if (!grid)
        return grid.error();
    const auto number = chooseGrid(*grid, wanted);
    if (!number)
        return number.error();
    const auto solution = openPlot3d(pair.solution, Plot3dKind::Solution);
    if (!solution)
        return solution.error();
    if (solution->layout.sizes != grid->layout.sizes)
        return inPlot3dFile(pair.solution, Message::say("it is the solution of another grid: its sizes are not those "
                                                        "of '%1'. Choose another one with 'solution'.",
                                                        pair.grid.string()));
    return OpenPair{*grid, *solution, *number};
}

Result<PointPositions> readPositions(const OpenPair& pair, const Progress& progress)
{
    if (const std::uint64_t blanked = blankedPoints(pair.grid, pair.number); blanked > 0)
        return inPlot3dFile(pair.grid.file->path(),
                            Message::say("%1 of its points are blanked out (iblank 0), so that its domain has holes, "
                                         "which cannot be refined. Take the part without them.",
                                         blanked));
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double begin = static_cast<double>(axis) / 3;
        const auto component = readComponent(pair.grid, pair.number, axis, progress.part(begin, begin + 1. / 3));
        if (!component)
            return component.error();
        positions->resize(component->size());
        for (std::size_t point = 0; point < component->size(); ++point)
            (*positions)[point][static_cast<Eigen::Index>(axis)] = (*component)[point];
    }
    return PointPositions(std::move(positions));
}

/// Single precision if the solution was.
Result<ScalarField> fieldOf(const Plot3dArray& array, std::uint32_t realBytes)
{
    const SampleType type = realBytes == 4 ? SampleType::Float32 : SampleType::Float64;
    auto samples = allocateSamples(type, array.values.size());
    if (!samples)
        return samples.error();
    if (type == SampleType::Float32)
        std::ranges::transform(array.values, reinterpret_cast<float*>(samples->get()),
                               [](double value) { return static_cast<float>(value); });
    else
        std::ranges::copy(array.values, reinterpret_cast<double*>(samples->get()));
    return ScalarField(type, array.values.size(), *std::move(samples));
}

Result<Dataset> readDataset(const fs::path& path, const OpenPair& pair, const std::string& arrayName,
                            const Progress& progress)
{
    const auto positions = readPositions(pair, progress.part(0, 0.35));
    if (!positions)
        return positions.error();
    const auto array = readPlot3dArray(pair.solution, pair.number, arrayName, progress.part(0.35, 0.9));
    if (!array)
        return array.error();
    const auto values = fieldOf(*array, pair.solution.layout.realBytes);
    if (!values)
        return values.error();
    Dataset dataset;
    dataset.domain = DomainClass::Curvilinear;
    dataset.lattice.size = pair.grid.layout.sizes[pair.number];
    dataset.positions = *positions;
    dataset.values = *values;
    dataset.source = {pair.grid.file->path().filename().string() + ", " + array->name, path, 0};
    if (const Status usable = checkGrid(dataset); !usable)
        return inPlot3dFile(pair.grid.file->path(), usable.error().message);
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

Result<FileContents> contentsOf(const Pair& pair, std::int64_t wanted)
{
    FileContents contents{.domain = DomainClass::Curvilinear};
    for (const std::string_view name : plot3dArrayNames())
        contents.arrays.push_back({.name = std::string(name)});
    const auto grid = openPlot3d(pair.grid, Plot3dKind::Grid);
    if (!grid)
        return grid.error();
    if (grid->layout.sizes.size() > 1) {
        contents.blocks = gridTexts(grid->layout);
        if (wanted == 0)
            return contents;
    }
    const auto open = openPair(pair, wanted);
    if (!open)
        return open.error();
    contents.lattice.size = open->grid.layout.sizes[open->number];
    contents.points = contents.lattice.pointCount();
    contents.type = open->solution.layout.realBytes == 4 ? SampleType::Float32 : SampleType::Float64;
    return contents;
}

} // namespace

std::vector<std::string> Plot3dReader::nameFilters() const
{
    return {Message::marked("PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)")};
}

double Plot3dReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr std::array<std::string_view, 6> ownNames = {".x", ".g", ".grd", ".p3d", ".q", ".qsol"};
    std::error_code problem;
    const std::uint64_t bytes = fs::file_size(path, problem);
    if (!problem)
        for (const Plot3dKind kind : {Plot3dKind::Grid, Plot3dKind::Solution})
            if (findPlot3dLayout(firstBytes, bytes, kind))
                return 0.9;
    return std::ranges::find(ownNames, fileEnding(path)) != ownNames.end() ? 0.2 : 0; // to say what is wrong
}

std::vector<Parameter> Plot3dReader::parameters() const
{
    Parameter array;
    array.id = "array";
    array.label = Message::marked("Values");
    array.explanation =
        Message::marked("Which scalar of the solution: automatic takes the density, or if that is the same everywhere "
                        "the first that varies.");
    array.defaultValue = std::string("automatic");
    array.choices = {Message::marked("automatic")};
    for (const std::string_view name : plot3dArrayNames())
        array.choices.emplace_back(name);
    Parameter solution;
    solution.id = "solution";
    solution.label = Message::marked("Solution file");
    solution.explanation =
        Message::marked("The PLOT3D solution of the grid; without it the one beside it with a matching name.");
    solution.defaultValue = std::string();
    Parameter grid;
    grid.id = "grid";
    grid.label = Message::marked("Grid");
    grid.explanation = Message::marked("Which grid of a PLOT3D file that holds several, from 1; 0 takes the only one.");
    grid.defaultValue = std::int64_t(0);
    grid.minimum = 0;
    grid.maximum = 10000;
    return {array, solution, grid};
}

Result<Dataset> Plot3dReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    const auto all = parameters();
    const auto pair = findPair(path, parameterValue<std::string>(all, values, "solution"));
    if (!pair)
        return pair.error();
    const auto open = openPair(*pair, parameterValue<std::int64_t>(all, values, "grid"));
    if (!open)
        return open.error();
    return readDataset(path, *open, parameterValue<std::string>(all, values, "array"), progress);
}

Result<FileContents> Plot3dReader::probe(const fs::path& path, const ParameterValues& values,
                                         const Progress& /*progress*/) const
{
    const auto all = parameters();
    const auto pair = findPair(path, parameterValue<std::string>(all, values, "solution"));
    if (!pair)
        return pair.error();
    return contentsOf(*pair, parameterValue<std::int64_t>(all, values, "grid"));
}

} // namespace tetra
