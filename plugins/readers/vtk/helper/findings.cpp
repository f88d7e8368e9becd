// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/findings.h"

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/helper/cell_findings.h"
#include "plugins/readers/vtk/helper/grid_findings.h"
#include "plugins/readers/vtk/helper/provenance.h"
#include "plugins/readers/vtk/helper/selection.h"
#include "plugins/readers/vtk/helper/zone_findings.h"

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
            Message::say("The lines and polygons that join its points were left out: they are scattered points."));
    return found;
}

/// Puts volumes together that have the array: first the grids, then the irregular meshes.
Result<VtkFindings> findingsOfVolumes(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection,
                                      const VtkRequest& request)
{
    std::vector<VtkZone> zones;
    for (const std::size_t part : selection.parts) {
        if (isMesh(*leaves[part].data))
            continue;
        auto samples = samplesOf(*sameArray(*leaves[part].data, selection.array), request.component);
        if (!samples)
            return samples.error();
        zones.push_back({leaves[part].name, leaves[part].data, *std::move(samples)});
    }
    VtkFindings found;
    if (!zones.empty()) {
        auto joined = zoneFindings(std::move(zones), selection.array.perCell);
        if (!joined)
            return joined.error();
        found = *std::move(joined);
    }
    for (const std::size_t part : selection.parts) {
        vtkDataSet& data = *leaves[part].data;
        if (!isMesh(data))
            continue;
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

/// The same of a choice of parts.
Result<VtkFindings> findingsOfParts(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection,
                                    const VtkRequest& request)
{
    auto found = selection.joinsVolumes
                     ? findingsOfVolumes(leaves, selection, request)
                     : findingsOfOne(*leaves[selection.parts.front()].data, selection.array, request);
    if (!found)
        return found.error();
    Provenance provenance = provenanceOf(leaves, selection, request);
    found->taken = std::move(provenance.taken);
    found->leftOut = std::move(provenance.leftOut);
    return found;
}

} // namespace

Result<VtkFindings> findingsOf(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    const auto selection = selectParts(leaves, request);
    if (!selection)
        return selection.error();
    auto found = findingsOfParts(leaves, *selection, request);
    if (found || found.error().kind != ErrorKind::OutOfResource || !selection->joinsVolumes)
        return found;
    VtkRequest apart = request;
    apart.joinsGrids = false;
    const auto first = selectParts(leaves, apart);
    if (!first || first->joinsVolumes)
        return found;
    auto alone = findingsOfParts(leaves, *first, apart);
    if (alone)
        alone->leftOut.push_back(notJoinedText(found.error().message));
    return alone;
}

} // namespace tetra
