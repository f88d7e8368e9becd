// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// An array of a dataset that could be its scalar.
struct VtkArray {
    std::string name;
    vtkDataArray* array = nullptr; ///< of the dataset, which owns it; null where only the header was looked at
    bool perCell = false;
    bool active = false; ///< the file marks it as the scalar
    bool isHelping =
        false; ///< numbers of points, owners, normals ...: taken only if named, or if there is nothing else
    bool isUnnamed = false; ///< the file does not name it: `name` is a number
    int components = 1;
    std::optional<ValueRange> range{}; ///< that the header tells of an array that was not read
};

/// Those with one number, or several, for each point or each cell: first the points', in the file's order.
std::vector<VtkArray> arraysOf(vtkDataSet& data);

/// What an array of VTK may be for that makes it a helping one: attribute types of vtkDataSetAttributes.
inline constexpr std::array helpingRoles{vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TCOORDS,
                                         vtkDataSetAttributes::GLOBALIDS, vtkDataSetAttributes::PEDIGREEIDS,
                                         vtkDataSetAttributes::HIGHERORDERDEGREES};

/// Of arrays that other programs write for themselves: numbers of points, owners ...
bool isHelpingArray(std::string_view name);

/// "Its array 'b' has 3 values for 8 points ...": a sentence for each that arraysOf() leaves out for its length.
std::vector<Message> arraysOfOtherLength(vtkDataSet& data);

/// By name or number from 1, or for "automatic" (and an empty text): the one that the file marks, else the first;
/// arrays of points before those of cells, one component before several, and what is the same everywhere only if there
/// is nothing else.
Result<VtkArray> chooseArray(const std::vector<VtkArray>& arrays, const std::string& wanted);

/// One number for each element of an array.
struct VtkSamples {
    SampleType type = SampleType::Float32;
    Buffer<std::byte> samples;
    std::string name;               ///< the array's and the component's
    std::vector<Message> remarks{}; ///< if they are not what stands in the file
};

/// `component` is a number from 0 or "magnitude", which counts for several components only. Types that TAn does not
/// have become wider ones, magnitudes floating point.
Result<VtkSamples> samplesOf(const VtkArray& array, const std::string& component);

/// The same as doubles.
std::vector<double> toDoubles(const VtkSamples& samples);

} // namespace tetra
