// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/exact_places.h"

#include "plugins/readers/vtk/helper/leaves.h"

#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace tetra {
namespace {

/// The number of six digits that single precision has rounded to this one; nothing if it had more.
std::optional<double> ofSixDigits(float rounded)
{
    constexpr int digitsBehindPoint = 5;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), static_cast<double>(rounded),
                                   std::chars_format::scientific, digitsBehindPoint);
    double number = 0;
    std::from_chars(text.data(), end.ptr, number);
    return static_cast<float>(number) == rounded ? std::optional(number) : std::nullopt;
}

/// An array of the same numbers with six digits; null if one of them had more, or it is not of single precision.
vtkSmartPointer<vtkDoubleArray> sixDigitArray(vtkDataArray* array)
{
    if (array == nullptr || array->GetDataType() != VTK_FLOAT)
        return nullptr;
    const auto exact = vtkSmartPointer<vtkDoubleArray>::New();
    exact->SetNumberOfComponents(array->GetNumberOfComponents());
    exact->SetNumberOfTuples(array->GetNumberOfTuples());
    const auto* rounded = static_cast<const float*>(array->GetVoidPointer(0));
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) {
        const auto number = ofSixDigits(rounded[i]);
        if (!number)
            return nullptr;
        exact->SetValue(i, *number);
    }
    return exact;
}

/// The arrays of places that a part has; null ones where there are none.
std::vector<vtkDataArray*> placeArrays(vtkDataSet& data)
{
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data))
        return {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()};
    auto* points = vtkPointSet::SafeDownCast(&data);
    return {points == nullptr || points->GetPoints() == nullptr ? nullptr : points->GetPoints()->GetData()};
}

} // namespace

bool setExactPlaces(vtkPointSet& data, std::span<const double> places)
{
    constexpr double rounding = std::numeric_limits<float>::epsilon();
    vtkPoints* points = data.GetPoints();
    if (points == nullptr || points->GetDataType() != VTK_FLOAT ||
        static_cast<std::uint64_t>(points->GetNumberOfPoints()) * 3 != places.size())
        return false;
    const auto* rounded = static_cast<const float*>(points->GetVoidPointer(0));
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!(std::abs(places[i] - static_cast<double>(rounded[i])) <=
              rounding * std::abs(places[i]) + std::numeric_limits<float>::min()))
            return false;
    const auto exact = vtkSmartPointer<vtkDoubleArray>::New();
    exact->SetNumberOfComponents(3);
    exact->SetNumberOfTuples(points->GetNumberOfPoints());
    std::ranges::copy(places, exact->GetPointer(0));
    const auto replaced = vtkSmartPointer<vtkPoints>::New();
    replaced->SetData(exact);
    data.SetPoints(replaced);
    return true;
}

void setSixDigitPlaces(vtkDataObject& data)
{
    for (const VtkLeaf& leaf : leavesOf(data))
        if (auto* grid = vtkRectilinearGrid::SafeDownCast(leaf.data)) {
            const auto x = sixDigitArray(grid->GetXCoordinates()), y = sixDigitArray(grid->GetYCoordinates()),
                       z = sixDigitArray(grid->GetZCoordinates());
            if (x == nullptr || y == nullptr || z == nullptr)
                continue;
            grid->SetXCoordinates(x);
            grid->SetYCoordinates(y);
            grid->SetZCoordinates(z);
        } else if (auto* points = vtkPointSet::SafeDownCast(leaf.data); points != nullptr && points->GetPoints()) {
            const auto exact = sixDigitArray(points->GetPoints()->GetData());
            if (exact == nullptr)
                continue;
            const auto replaced = vtkSmartPointer<vtkPoints>::New();
            replaced->SetData(exact);
            points->SetPoints(replaced);
        }
}

void tellSinglePrecision(vtkDataObject& data, std::vector<Message>& leftOut)
{
    double farthest = 0;
    for (const VtkLeaf& leaf : leavesOf(data))
        for (vtkDataArray* array : placeArrays(*leaf.data))
            if (array != nullptr && array->GetDataType() == VTK_FLOAT)
                for (int component = 0; component < array->GetNumberOfComponents(); ++component) {
                    std::array<double, 2> range{};
                    array->GetRange(range.data(), component);
                    if (range[0] <= range[1])
                        farthest = std::max({farthest, std::abs(range[0]), std::abs(range[1])});
                }
    if (farthest > 0)
        leftOut.push_back(
            Message::say("VTK reads its positions in single precision: they may be up to %1 from those in the file.",
                         formatNumber(farthest * std::numeric_limits<float>::epsilon() / 2)));
}

} // namespace tetra
