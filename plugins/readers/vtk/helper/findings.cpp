// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/findings.h"

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/helper/cell_findings.h"
#include "plugins/readers/vtk/helper/grid_findings.h"
#include "plugins/readers/vtk/helper/provenance.h"
#include "plugins/readers/vtk/helper/selection.h"

#include <vtkCellType.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace tetra {
namespace {

Result<VtkFindings> findingsOfOne(vtkDataSet& data, const VtkArray& array, const VtkRequest& request)
{
    auto samples = samplesOf(array, request.component);
    if (!samples)
        return samples.error();
    if (const auto grid = gridOf(data))
        return gridFindings(data, *grid, array, *std::move(samples));
    if (auto* mesh = vtkUnstructuredGrid::SafeDownCast(&data); mesh != nullptr && isVolume(data)) {
        VtkFindings found;
        found.remarks = samples->remarks;
        if (const Status added = addCells(*mesh, array, *samples, found); !added)
            return added.error();
        return found;
    }
    auto found = pointFindings(data, array, *samples);
    const vtkIdType cells = data.GetNumberOfCells();
    if (found && cells > 0 && data.GetCellType(0) != VTK_VERTEX && data.GetCellType(0) != VTK_POLY_VERTEX)
        found->remarks.push_back(
            Message::say("What joins its points (lines, polygons) was left out: they are scattered points."));
    return found;
}

/// Puts irregular meshes together that have the array.
Result<VtkFindings> findingsOfMeshes(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection,
                                     const VtkRequest& request)
{
    VtkFindings found;
    for (const std::size_t part : selection.parts) {
        vtkDataSet& data = *leaves[part].data;
        const auto array = sameArray(data, selection.array);
        const auto samples = samplesOf(*array, request.component);
        if (!samples)
            return samples.error();
        for (const Message& remark : samples->remarks)
            if (std::ranges::find(found.remarks, remark) == found.remarks.end())
                found.remarks.push_back(remark);
        if (const Status added = addCells(*vtkUnstructuredGrid::SafeDownCast(&data), *array, *samples, found); !added)
            return added.error();
    }
    return found;
}

} // namespace

Result<VtkFindings> findingsOf(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    const auto selection = selectParts(leaves, request);
    if (!selection)
        return selection.error();
    auto found = selection->joinsMeshes
                     ? findingsOfMeshes(leaves, *selection, request)
                     : findingsOfOne(*leaves[selection->parts.front()].data, selection->array, request);
    if (!found)
        return found.error();
    Provenance provenance = provenanceOf(leaves, *selection, request);
    found->taken = std::move(provenance.taken);
    found->leftOut = std::move(provenance.leftOut);
    return found;
}

} // namespace tetra
