// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/selection.h"

#include "plugins/readers/vtk/helper/grid_findings.h"

#include <vtkCellTypes.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

Result<VtkSelection> selectOne(const std::vector<VtkPart>& parts, std::size_t part, const VtkRequest& request)
{
    const auto array = chooseArray(parts[part].arrays, request.array);
    if (!array)
        return array.error();
    return VtkSelection{.parts = {part}, .array = *array};
}

std::optional<VtkArray> sameArrayOf(const std::vector<VtkArray>& arrays, const VtkArray& wanted)
{
    for (const VtkArray& array : arrays)
        if (array.name == wanted.name && array.perCell == wanted.perCell)
            return array;
    return std::nullopt;
}

/// Those of the volumes that have the array of the first one with one.
Result<VtkSelection> selectVolumes(const std::vector<VtkPart>& parts, const std::vector<std::size_t>& volumes,
                                   const VtkRequest& request)
{
    Result<VtkArray> array = Error{};
    for (const std::size_t part : volumes)
        if (array = chooseArray(parts[part].arrays, request.array); array)
            break;
    if (!array)
        return array.error();
    VtkSelection selection{.parts = {}, .array = *array};
    for (const std::size_t part : volumes)
        (sameArrayOf(parts[part].arrays, *array) ? selection.parts : selection.partsWithoutArray).push_back(part);
    const std::size_t first = selection.parts.front();
    const bool isGrid = !parts[first].isMesh;
    if (isGrid && !request.joinsGrids && selection.parts.size() > 1) {
        selection.parts = {first};
        selection.isGuess = true;
    }
    selection.joinsVolumes = selection.parts.size() > 1 || !isGrid;
    return selection;
}

} // namespace

bool isVolume(vtkDataSet& data)
{
    if (const auto grid = gridOf(data))
        return std::ranges::min(grid->lattice.size) > 1;
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(&data);
    for (vtkIdType cell = 0; mesh != nullptr && cell < mesh->GetNumberOfCells(); ++cell)
        if (mesh->GetCellType(cell) > VTK_QUAD)
            return true;
    return false;
}

bool isMesh(vtkDataSet& data)
{
    return vtkUnstructuredGrid::SafeDownCast(&data) != nullptr;
}

std::optional<VtkArray> sameArray(vtkDataSet& data, const VtkArray& wanted)
{
    return sameArrayOf(arraysOf(data), wanted);
}

Result<VtkSelection> selectParts(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    std::vector<VtkPart> parts;
    for (const VtkLeaf& leaf : leaves) // of a single one it does not matter, and may take long to find out
        parts.push_back({arraysOf(*leaf.data), leaves.size() > 1 && isVolume(*leaf.data), isMesh(*leaf.data)});
    return selectParts(leaves, parts, request);
}

Result<VtkSelection> selectParts(const std::vector<VtkLeaf>& leaves, const std::vector<VtkPart>& parts,
                                 const VtkRequest& request)
{
    if (leaves.empty())
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    if (!request.part.empty()) {
        const auto part = chooseLeaf(leaves, request.part);
        return part ? selectOne(parts, *part, request) : part.error();
    }
    if (leaves.size() == 1)
        return selectOne(parts, 0, request);
    std::vector<std::size_t> volumes;
    for (std::size_t part = 0; part < parts.size(); ++part)
        if (parts[part].isVolume)
            volumes.push_back(part);
    if (!volumes.empty())
        return selectVolumes(parts, volumes, request);
    auto first = selectOne(parts, 0, request);
    if (first)
        first->isGuess = true;
    return first;
}

} // namespace tetra
