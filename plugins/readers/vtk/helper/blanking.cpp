// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/blanking.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace tetra {
namespace {

/// The ghost flags of points or cells; null without them.
vtkUnsignedCharArray* flagsOf(vtkDataSetAttributes& attributes, vtkIdType count)
{
    auto* flags = vtkUnsignedCharArray::SafeDownCast(attributes.GetArray(vtkDataSetAttributes::GhostArrayName()));
    return flags != nullptr && flags->GetNumberOfTuples() == count && flags->GetNumberOfComponents() == 1 ? flags
                                                                                                          : nullptr;
}

bool hasHiddenPoint(vtkDataSet& data, vtkIdType cell, vtkUnsignedCharArray& flags, vtkIdList& corners)
{
    data.GetCellPoints(cell, &corners);
    return std::any_of(corners.begin(), corners.end(), [&](vtkIdType point) {
        return (flags.GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    });
}

} // namespace

std::vector<std::uint8_t> blankedCells(vtkDataSet& data)
{
    const vtkIdType cells = data.GetNumberOfCells();
    vtkUnsignedCharArray* cellFlags = flagsOf(*data.GetCellData(), cells);
    vtkUnsignedCharArray* pointFlags = flagsOf(*data.GetPointData(), data.GetNumberOfPoints());
    if (cellFlags == nullptr && pointFlags == nullptr)
        return {};
    constexpr unsigned char outside = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
    const vtkNew<vtkIdList> corners;
    std::vector<std::uint8_t> blanked(static_cast<std::size_t>(cells), 0);
    for (vtkIdType cell = 0; cell < cells; ++cell)
        blanked[static_cast<std::size_t>(cell)] =
            (cellFlags != nullptr && (cellFlags->GetValue(cell) & outside) != 0) ||
            (pointFlags != nullptr && hasHiddenPoint(data, cell, *pointFlags, *corners));
    if (std::ranges::find(blanked, 1) == blanked.end())
        return {};
    return blanked;
}

} // namespace tetra
