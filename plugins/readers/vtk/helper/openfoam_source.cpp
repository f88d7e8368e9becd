// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/openfoam_source.h"

#include "plugins/readers/vtk/foam_dimensions.h"
#include "plugins/readers/vtk/foam_points.h"
#include "plugins/readers/vtk/helper/exact_places.h"
#include "plugins/readers/vtk/helper/leaves.h"

#include <vtkDataObject.h>
#include <vtkDummyController.h>
#include <vtkInformation.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPOpenFOAMReader.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

/// What the folder of a case holds.
struct FoamCase {
    bool hasMesh = false;
    double lastTime = -1; ///< before all, if there is no folder of a time
    std::vector<fs::path> processors{};
    bool isCollated = false; ///< several processors share a folder
};

bool isFolder(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// Of the case itself, or of one of its regions.
bool hasFoamMesh(const fs::path& folder)
{
    if (isFolder(folder / "constant/polyMesh"))
        return true;
    std::error_code ignored;
    return std::ranges::any_of(pathsIn(folder / "constant", ignored),
                               [](const fs::path& region) { return isFolder(region / "polyMesh"); });
}

FoamCase lookAtCase(const fs::path& folder)
{
    FoamCase found{.hasMesh = hasFoamMesh(folder)};
    std::error_code ignored;
    for (const fs::path& path : pathsIn(folder, ignored)) {
        const std::string name = path.filename().string();
        if (const auto time = parseNumber<double>(name); time && isFolder(path))
            found.lastTime = std::max(found.lastTime, *time);
        if (name.starts_with("processors"))
            found.isCollated = true;
        else if (name.starts_with("processor") && parseNumber<std::uint32_t>(name.substr(9)) && isFolder(path))
            found.processors.push_back(path);
    }
    std::ranges::sort(found.processors, {}, [](const fs::path& path) { // 10 is behind 9
        return parseNumber<std::uint32_t>(path.filename().string().substr(9)).value_or(0);
    });
    return found;
}

/// The names of the zones of cells: in their file, each stands before a '{' and "type".
std::vector<std::string> cellZones(const fs::path& folder)
{
    constexpr std::string_view blanks = " \t\r\n";
    std::vector<std::string> names;
    const auto file = MappedFile::open(folder / "constant/polyMesh/cellZones");
    if (!file)
        return names;
    const std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
    for (auto brace = text.find('{'); brace != std::string_view::npos; brace = text.find('{', brace + 1)) {
        const auto inside = text.find_first_not_of(blanks, brace + 1);
        const auto end = text.substr(0, brace).find_last_not_of(blanks);
        if (inside == std::string_view::npos || end == std::string_view::npos ||
            !text.substr(inside).starts_with("type"))
            continue;
        const auto start = text.substr(0, end).find_last_of(" \t\r\n(;}");
        names.emplace_back(text.substr(start + 1, end - start));
    }
    return names;
}

/// "patch/walls" as "walls", "/solid/patch/walls" as "solid/walls"; empty for what is no patch.
std::string patchName(std::string name)
{
    constexpr std::string_view word = "patch/";
    const auto place = name.find(word);
    if (place == std::string::npos)
        return {};
    name.erase(place, word.size());
    return name.starts_with('/') ? name.substr(1) : name;
}

void tellLeftOut(vtkOpenFOAMReader& reader, const fs::path& folder, std::vector<Message>& leftOut)
{
    std::vector<std::string> patches;
    for (int number = 0; number < reader.GetNumberOfPatchArrays(); ++number)
        if (const std::string name = patchName(reader.GetPatchArrayName(number)); !name.empty())
            patches.push_back(name);
    if (!patches.empty())
        leftOut.push_back(Message::say("The patches of its boundary are not read: %1.", namesToldOf(patches)));
    if (const auto zones = cellZones(folder); !zones.empty())
        leftOut.push_back(Message::say("Its zones of cells are not distinguished: %1.", namesToldOf(zones)));
    if (reader.GetNumberOfLagrangianArrays() > 0)
        leftOut.push_back(Message::say("Its clouds of particles are not read."));
}

/// The newest file of points that counts at this time, of a mesh in `region`, empty for that of the case itself.
std::optional<fs::path> pointsAt(const fs::path& folder, const fs::path& region, double time)
{
    std::optional<fs::path> newest;
    double newestTime = 0;
    std::error_code ignored;
    const auto consider = [&](const fs::path& at, double since) {
        for (const char* name : {"points", "points.gz"})
            if (const fs::path file = at / region / "polyMesh" / name;
                fs::exists(file, ignored) && (!newest || since >= newestTime)) {
                newest = file;
                newestTime = since;
            }
    };
    consider(folder / "constant", -std::numeric_limits<double>::infinity());
    for (const fs::path& path : pathsIn(folder, ignored))
        if (const auto since = parseNumber<double>(path.filename().string()); since && *since <= time)
            consider(path, *since);
    return newest;
}

/// The meshes of a case: of regions, and of the case itself, which has no name.
std::vector<fs::path> regionsOf(const fs::path& folder)
{
    std::vector<fs::path> regions{{}};
    std::error_code ignored;
    for (const fs::path& path : pathsIn(folder / "constant", ignored))
        if (isFolder(path / "polyMesh"))
            regions.push_back(path.filename());
    return regions;
}

/// Gives each part the places of its files, which VTK has rounded: those of the folders (of a case, or of all its
/// processors) and of the region that agree with VTK's.
void refinePlaces(vtkDataObject& data, std::span<const fs::path> folders)
{
    const double time = data.GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()) != 0
                            ? data.GetInformation()->Get(vtkDataObject::DATA_TIME_STEP())
                            : std::numeric_limits<double>::infinity();
    const std::vector<fs::path> regions = regionsOf(folders.front());
    for (const VtkLeaf& leaf : leavesOf(data)) {
        auto* part = vtkPointSet::SafeDownCast(leaf.data);
        for (std::size_t region = 0; part != nullptr && region < regions.size(); ++region) {
            std::vector<double> places;
            for (const fs::path& folder : folders) {
                const auto file = pointsAt(folder, regions[region], time);
                const auto more =
                    file ? readFoamPoints(*file, static_cast<std::uint64_t>(part->GetNumberOfPoints())) : std::nullopt;
                if (more)
                    places.insert(places.end(), more->begin(), more->end());
            }
            if (setExactPlaces(*part, places))
                break;
        }
    }
}

/// The unit of the field that is taken, which its file tells at any time and in any region.
void tellUnit(const fs::path& folder, Provenance& provenance)
{
    const auto array = std::ranges::find(provenance.taken, TakenPart::Array, &Taken::part);
    if (array == provenance.taken.end())
        return;
    const std::string field = array->what.text();
    std::error_code ignored;
    for (const fs::path& time : pathsIn(folder, ignored)) {
        if (!parseNumber<double>(time.filename().string()))
            continue;
        for (const fs::path& region : regionsOf(folder))
            for (const char* const packing : {"", ".gz"})
                if (const std::string unit = foamUnitOfFile(time / region / (field + packing)); !unit.empty()) {
                    addTaken({TakenPart::Unit, printable(unit), false}, provenance);
                    return;
                }
    }
}

Error lacksMesh(const FoamCase& found, const fs::path& folder)
{
    if (found.isCollated)
        return {ErrorKind::BadInput,
                Message::say("its case is decomposed into folders that several processors share (processors2 ...), "
                             "which VTK 9.1 does not read. Run reconstructPar, and open it again.")};
    return {ErrorKind::BadInput,
            Message::say("its case has no mesh: there is no 'constant/polyMesh' in '%1', and no folder of a processor. "
                         "The file must lie in the folder of the case, beside 'constant' and 'system'.",
                         folder.string())};
}

} // namespace

Result<VtkSource> makeOpenFoamSource(const std::string& path)
{
    const fs::path opened = path;
    const bool isControl = opened.filename() == "controlDict";
    const fs::path folder = isControl ? opened.parent_path().parent_path() : opened.parent_path();
    const FoamCase found = lookAtCase(folder);
    if (!found.hasMesh && found.processors.empty())
        return lacksMesh(found, folder);
    bool isDecomposed = !found.hasMesh;
    for (const fs::path& processor : found.processors)
        isDecomposed |= lookAtCase(processor).lastTime > found.lastTime;

    vtkSmartPointer<vtkOpenFOAMReader> reader;
    if (isDecomposed) {
        const auto parallel = vtkSmartPointer<vtkPOpenFOAMReader>::New();
        parallel->SetController(vtkSmartPointer<vtkDummyController>::New()); // it reads all parts in this process
        parallel->SetCaseType(vtkPOpenFOAMReader::DECOMPOSED_CASE);
        reader = parallel;
    } else {
        reader = vtkSmartPointer<vtkOpenFOAMReader>::New();
    }
    reader->SetFileName(path.c_str());
    reader->SkipZeroTimeOff();
    reader->DecomposePolyhedraOff();
    reader->CreateCellToPointOff();
    VtkSource source{.reader = reader};
    source.selectArrays = [reader] {
        reader->EnableAllCellArrays();
        reader->EnableAllPointArrays();
    };
    source.refine = [folders = isDecomposed ? found.processors : std::vector{folder}](vtkDataObject& data) {
        refinePlaces(data, folders);
    };
    source.tell = [reader, folder, fields = isDecomposed ? found.processors.front() : folder, isDecomposed,
                   hasMesh = found.hasMesh, processors = found.processors.size()](Provenance& provenance) {
        if (isDecomposed)
            addTaken({TakenPart::Block, Message::say("the folders of %1 processors", processors), false}, provenance);
        if (isDecomposed && hasMesh)
            provenance.leftOut.push_back(
                Message::say("Its case as a whole is not read: the folders of its processors contain later times."));
        else if (processors > 0 && !isDecomposed)
            provenance.leftOut.push_back(
                Message::say("The folders of its %1 processors are not read: the case as a whole is.", processors));
        tellUnit(fields, provenance);
        tellLeftOut(*reader, folder, provenance.leftOut);
    };
    return source;
}

} // namespace tetra
