// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/findings.h"

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/helper/cell_findings.h"
#include "plugins/readers/vtk/helper/grid_findings.h"

#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace tetra {
namespace {

struct Chosen {
    VtkArray array;
    VtkSamples samples;
};

Result<Chosen> choose(vtkDataSet& data, const VtkRequest& request)
{
    const auto array = chooseArray(arraysOf(data), request.array);
    if (!array)
        return array.error();
    auto samples = samplesOf(*array, request.component);
    if (!samples)
        return samples.error();
    return Chosen{*array, *std::move(samples)};
}

/// Whether a mesh has cells of three dimensions.
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

Result<VtkFindings> findingsOfOne(vtkDataSet& data, const VtkRequest& request)
{
    auto chosen = choose(data, request);
    if (!chosen)
        return chosen.error();
    if (const auto grid = gridOf(data))
        return gridFindings(data, *grid, chosen->array, std::move(chosen->samples));
    if (auto* mesh = vtkUnstructuredGrid::SafeDownCast(&data); mesh != nullptr && isVolume(data)) {
        VtkFindings found;
        found.remarks = chosen->samples.remarks;
        if (const Status added = addCells(*mesh, chosen->array, chosen->samples, found); !added)
            return added.error();
        return found;
    }
    auto found = pointFindings(data, chosen->array, chosen->samples);
    const vtkIdType cells = data.GetNumberOfCells();
    if (found && cells > 0 && data.GetCellType(0) != VTK_VERTEX && data.GetCellType(0) != VTK_POLY_VERTEX)
        found->remarks.push_back(
            Message::say("What joins its points (lines, polygons) was left out: they are scattered points."));
    return found;
}

/// The same array of another part; nothing if it has none.
std::optional<VtkArray> sameArray(vtkDataSet& data, const VtkArray& wanted)
{
    for (const VtkArray& array : arraysOf(data))
        if (array.name == wanted.name && array.perCell == wanted.perCell)
            return array;
    return std::nullopt;
}

/// Puts all irregular meshes together that have the array of the first one with it.
Result<VtkFindings> findingsOfMeshes(const std::vector<VtkLeaf>& meshes, const VtkRequest& request)
{
    Result<Chosen> first = Error{};
    for (const VtkLeaf& leaf : meshes)
        if (first = choose(*leaf.data, request); first)
            break;
    if (!first)
        return first.error();
    VtkFindings found;
    std::size_t without = 0;
    for (const VtkLeaf& leaf : meshes) {
        const auto array = sameArray(*leaf.data, first->array);
        without += !array;
        if (!array)
            continue;
        const auto samples = samplesOf(*array, request.component);
        if (!samples)
            return samples.error();
        if (const Status added = addCells(*vtkUnstructuredGrid::SafeDownCast(leaf.data), *array, *samples, found);
            !added)
            return added.error();
    }
    found.remarks.insert(found.remarks.begin(), first->samples.remarks.begin(), first->samples.remarks.end());
    if (without > 0)
        found.remarks.push_back(
            Message::say("%1 of its parts have no '%2' and were left out.", without, printable(first->array.name)));
    return found;
}

} // namespace

Result<VtkFindings> findingsOf(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    if (leaves.empty())
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    if (!request.part.empty()) {
        const auto leaf = chooseLeaf(leaves, request.part);
        if (!leaf)
            return leaf.error();
        return findingsOfOne(*leaf->data, request);
    }
    if (leaves.size() == 1)
        return findingsOfOne(*leaves[0].data, request);

    std::vector<VtkLeaf> meshes;
    std::ranges::copy_if(leaves, std::back_inserter(meshes), [](const VtkLeaf& leaf) {
        return vtkUnstructuredGrid::SafeDownCast(leaf.data) != nullptr && isVolume(*leaf.data);
    });
    const auto grid = std::ranges::find_if(leaves, [](const VtkLeaf& leaf) { return isVolume(*leaf.data); });
    const VtkLeaf& first = grid == leaves.end() ? leaves.front() : *grid;
    const bool asMeshes = !meshes.empty() && meshes.front().data == first.data;
    auto found = asMeshes ? findingsOfMeshes(meshes, request) : findingsOfOne(*first.data, request);
    if (found && !asMeshes)
        found->remarks.push_back(
            Message::say("It contains %1 parts; this is the one called '%2'. Choose another one with 'part'.",
                         leaves.size(), printable(first.name)));
    else if (found && meshes.size() < leaves.size())
        found->remarks.push_back(
            Message::say("%1 of its parts are no irregular meshes and were left out.", leaves.size() - meshes.size()));
    return found;
}

} // namespace tetra
