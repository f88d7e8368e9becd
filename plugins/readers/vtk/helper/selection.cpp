// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/selection.h"

#include "plugins/readers/vtk/helper/grid_findings.h"

#include <vtkCellTypes.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

bool isMesh(const VtkLeaf& leaf)
{
    return vtkUnstructuredGrid::SafeDownCast(leaf.data) != nullptr && isVolume(*leaf.data);
}

Result<VtkSelection> selectOne(const std::vector<VtkLeaf>& leaves, std::size_t part, const VtkRequest& request)
{
    const auto array = chooseArray(arraysOf(*leaves[part].data), request.array);
    if (!array)
        return array.error();
    return VtkSelection{.parts = {part}, .array = *array};
}

Result<VtkSelection> selectMeshes(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    std::vector<std::size_t> meshes;
    for (std::size_t part = 0; part < leaves.size(); ++part)
        if (isMesh(leaves[part]))
            meshes.push_back(part);
    Result<VtkArray> array = Error{};
    for (const std::size_t part : meshes)
        if (array = chooseArray(arraysOf(*leaves[part].data), request.array); array)
            break;
    if (!array)
        return array.error();
    VtkSelection selection{.parts = {}, .array = *array, .joinsMeshes = true};
    for (const std::size_t part : meshes)
        (sameArray(*leaves[part].data, *array) ? selection.parts : selection.partsWithoutArray).push_back(part);
    return selection;
}

} // namespace

bool isVolume(vtkDataSet& data)
{
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(&data);
    if (mesh == nullptr)
        return gridOf(data).has_value();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
        if (mesh->GetCellType(cell) > VTK_QUAD)
            return true;
    return false;
}

std::optional<VtkArray> sameArray(vtkDataSet& data, const VtkArray& wanted)
{
    for (const VtkArray& array : arraysOf(data))
        if (array.name == wanted.name && array.perCell == wanted.perCell)
            return array;
    return std::nullopt;
}

Result<VtkSelection> selectParts(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    if (leaves.empty())
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    if (!request.part.empty()) {
        const auto part = chooseLeaf(leaves, request.part);
        return part ? selectOne(leaves, *part, request) : part.error();
    }
    if (leaves.size() == 1)
        return selectOne(leaves, 0, request);
    const auto volume = std::ranges::find_if(leaves, [](const VtkLeaf& leaf) { return isVolume(*leaf.data); });
    if (volume != leaves.end() && isMesh(*volume))
        return selectMeshes(leaves, request);
    return selectOne(leaves, volume == leaves.end() ? 0 : static_cast<std::size_t>(volume - leaves.begin()), request);
}

} // namespace tetra
