// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/plot3d_source.h"

#include <vtkMultiBlockPLOT3DReader.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

namespace tetra {
namespace {

namespace fs = std::filesystem;

struct TextLayout {
    bool several = false;
    bool blanking = false;
};

/// How many numbers a text has, and the first of them.
struct Numbers {
    std::uint64_t count = 0;
    std::vector<std::uint64_t> first;
};

/// Nothing if something else stands in it.
std::optional<Numbers> numbersOf(const fs::path& path)
{
    constexpr std::uint64_t most = 3 * 1000 + 1;
    Numbers numbers;
    std::ifstream file(path);
    for (std::string word; file >> word; ++numbers.count) {
        const auto number = parseNumber<double>(word);
        if (!number)
            return std::nullopt;
        if (numbers.first.size() < most)
            numbers.first.push_back(*number >= 1 && *number < 1e6 ? static_cast<std::uint64_t>(*number) : 0);
    }
    return numbers;
}

/// The points that `grids` grids have whose sizes begin at number `at`; 0 if those are no sizes.
std::uint64_t pointsOf(const Numbers& numbers, std::uint64_t at, std::uint64_t grids)
{
    if (grids == 0 || at + 3 * grids > numbers.first.size())
        return 0;
    std::uint64_t points = 0;
    for (std::uint64_t grid = 0; grid < grids; ++grid) {
        const std::uint64_t* size = numbers.first.data() + at + 3 * grid;
        points += size[0] * size[1] % (std::uint64_t(1) << 40) * size[2];
    }
    return points;
}

std::optional<TextLayout> layoutOf(const Numbers& numbers)
{
    for (const bool several : {false, true}) {
        const std::uint64_t grids = several && !numbers.first.empty() ? numbers.first[0] : 1;
        const std::uint64_t points = pointsOf(numbers, several ? 1 : 0, grids);
        for (const bool blanking : {false, true})
            if (points > 0 && numbers.count == (several ? 1 : 0) + 3 * grids + (blanking ? 4 : 3) * points)
                return TextLayout{several, blanking};
    }
    return std::nullopt;
}

bool isText(const fs::path& path)
{
    std::string start(4096, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    return start.find_first_not_of("0123456789+-.eEdD \t\r\n") == std::string::npos;
}

/// The file of the same name with one of these endings; empty if there is none.
fs::path beside(const fs::path& path, std::initializer_list<const char*> endings)
{
    for (const char* ending : endings) {
        fs::path other = path;
        std::error_code ignored;
        if (other.replace_extension(ending) != path && fs::is_regular_file(other, ignored))
            return other;
    }
    return {};
}

bool isSolutionName(const fs::path& path)
{
    return path.extension() == ".q" || path.extension() == ".Q";
}

struct Files {
    fs::path grid;
    fs::path values;
};

Result<Files> filesOf(const VtkRequest& request)
{
    const fs::path path = request.path;
    Files files{path, {}};
    if (isSolutionName(path))
        files = {beside(path, {".xyz", ".x", ".g", ".p3d"}), path};
    else if (!request.companion.empty())
        files.values = path.parent_path() / request.companion;
    else
        files.values = beside(path, {".q", ".Q", ".qsol", ".f", ".fun"});
    if (files.grid.empty())
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "it is a PLOT3D solution, and its grid (.xyz, .x, .g, .p3d) is not beside it. Open the grid.")};
    if (files.values.empty())
        return Error{ErrorKind::WrongUsage,
                     Message::say("it is a PLOT3D grid without values, and neither a solution (.q) nor a function file "
                                  "(.f, .fun) of its name is beside it. Name it with 'solution'.")};
    return files;
}

Status describeText(vtkMultiBlockPLOT3DReader& reader, const fs::path& grid)
{
    const auto numbers = numbersOf(grid);
    const auto layout = numbers ? layoutOf(*numbers) : std::nullopt;
    if (!layout)
        return Error{ErrorKind::BadInput, Message::say("it is a text, but not as many numbers stand in it as a PLOT3D "
                                                       "grid of its size has. It is damaged, or of another format.")};
    reader.BinaryFileOff();
    reader.SetMultiGrid(layout->several);
    reader.SetIBlanking(layout->blanking);
    return {};
}

} // namespace

Result<VtkSource> makePlot3dSource(const VtkRequest& request)
{
    const auto files = filesOf(request);
    if (!files)
        return files.error();
    const auto reader = vtkSmartPointer<vtkMultiBlockPLOT3DReader>::New();
    if (isText(files->grid)) {
        if (const Status described = describeText(*reader, files->grid); !described)
            return described.error();
    } else {
        reader->AutoDetectFormatOn();
    }
    reader->SetXYZFileName(files->grid.c_str());
    if (files->values.extension() == ".f" || files->values.extension() == ".fun")
        reader->SetFunctionFileName(files->values.c_str());
    else
        reader->SetQFileName(files->values.c_str());
    constexpr int pressure = 110;
    constexpr int temperature = 120;
    constexpr int velocityMagnitude = 153;
    for (const int function : {pressure, temperature, velocityMagnitude})
        reader->AddFunction(function);
    return VtkSource{.reader = reader};
}

} // namespace tetra
