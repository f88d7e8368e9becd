// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/arrays.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace tetra {
namespace {

constexpr std::array<std::string_view, 12> helpingNames = {
    "vtkGhostType", "vtkGhostLevels", "vtkOriginalPointIds", "vtkOriginalCellIds", "GlobalNodeId", "GlobalElementId",
    "ObjectId",     "PedigreeNodeId", "PedigreeElementId",   "GlobalNodeID",       "Material Id",  "IBlank"};

void addArrays(vtkDataSetAttributes& attributes, vtkIdType elements, bool perCell, std::vector<VtkArray>& arrays)
{
    for (int number = 0; number < attributes.GetNumberOfArrays(); ++number) {
        vtkDataArray* array = attributes.GetArray(number);
        if (array == nullptr || array->GetNumberOfTuples() != elements || array->GetNumberOfComponents() < 1 ||
            elements == 0)
            continue;
        const char* name = array->GetName();
        const bool isUnnamed = name == nullptr || *name == 0;
        VtkArray entry{.name = isUnnamed ? "array " + std::to_string(arrays.size() + 1) : name,
                       .array = array,
                       .perCell = perCell,
                       .active = array == attributes.GetScalars(),
                       .isHelping = !isUnnamed && isHelpingArray(name),
                       .isUnnamed = isUnnamed,
                       .components = array->GetNumberOfComponents()};
        for (const int role : helpingRoles)
            entry.isHelping = entry.isHelping || array == attributes.GetAbstractAttribute(role);
        arrays.push_back(std::move(entry));
    }
}

void addOtherLengths(vtkDataSetAttributes& attributes, vtkIdType elements, bool perCell, std::vector<Message>& told)
{
    for (int number = 0; number < attributes.GetNumberOfArrays(); ++number) {
        vtkDataArray* array = attributes.GetArray(number);
        if (array == nullptr || array->GetNumberOfTuples() == elements || array->GetNumberOfTuples() == 0 ||
            elements == 0)
            continue;
        const std::string name = printable(array->GetName() == nullptr ? "" : array->GetName());
        const auto values = array->GetNumberOfTuples();
        told.push_back(
            perCell
                ? Message::say("Its array '%1' has %2 values for %3 cells and is not read.", name, values, elements)
                : Message::say("Its array '%1' has %2 values for %3 points and is not read.", name, values, elements));
    }
}

bool isConstant(const VtkArray& entry)
{
    if (entry.array == nullptr)
        return entry.range && !(entry.range->minimum < entry.range->maximum);
    std::array<double, 2> range{};
    entry.array->GetRange(range.data(), entry.array->GetNumberOfComponents() > 1 ? -1 : 0);
    return !(range[0] < range[1]);
}

Message namesText(const std::vector<VtkArray>& arrays)
{
    Message text;
    for (const VtkArray& entry : arrays) {
        const Message name = entry.perCell ? Message::say("'%1' (of cells)", printable(entry.name))
                                           : Message("'" + printable(entry.name) + "'");
        text = text.empty() ? name : Message::say("%1, %2", text, name);
    }
    return text;
}

/// The type of TAn that holds all values of this type of VTK.
std::optional<SampleType> sampleTypeOf(int vtkType)
{
    static_assert(sizeof(int) == 4 && sizeof(short) == 2);
    switch (vtkType) {
    case VTK_UNSIGNED_CHAR: return SampleType::UInt8;
    case VTK_CHAR: return std::numeric_limits<char>::is_signed ? SampleType::Int8 : SampleType::UInt8;
    case VTK_SIGNED_CHAR: return SampleType::Int8;
    case VTK_UNSIGNED_SHORT: return SampleType::UInt16;
    case VTK_SHORT: return SampleType::Int16;
    case VTK_UNSIGNED_INT: return SampleType::UInt32;
    case VTK_INT: return SampleType::Int32;
    case VTK_FLOAT: return SampleType::Float32;
    case VTK_DOUBLE: return SampleType::Float64;
    case VTK_BIT: return SampleType::UInt8;
    default: return std::nullopt;
    }
}

/// 64-bit integers that all fit stay integers.
SampleType typeOf64Bits(vtkDataArray& array, int component)
{
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) {
        const double value = array.GetComponent(i, component);
        if (!(value >= std::numeric_limits<std::int32_t>::min() && value <= std::numeric_limits<std::int32_t>::max()))
            return SampleType::Float64;
    }
    return SampleType::Int32;
}

double magnitude(vtkDataArray& array, vtkIdType element)
{
    double sum = 0;
    for (int component = 0; component < array.GetNumberOfComponents(); ++component) {
        const double value = array.GetComponent(element, component);
        sum += value * value;
    }
    return std::sqrt(sum);
}

template <class Value> VtkSamples filled(vtkDataArray& array, SampleType type, const Value& value)
{
    VtkSamples result;
    result.type = type;
    const auto count = static_cast<std::size_t>(array.GetNumberOfTuples());
    result.samples.resize(count * sampleSize(type));
    visitSampleType(type, [&]<class T>() {
        T* samples = reinterpret_cast<T*>(result.samples.data());
        for (std::size_t i = 0; i < count; ++i)
            samples[i] = static_cast<T>(value(static_cast<vtkIdType>(i)));
    });
    return result;
}

VtkSamples magnitudeSamples(vtkDataArray& array)
{
    const SampleType type = array.GetDataType() == VTK_FLOAT ? SampleType::Float32 : SampleType::Float64;
    return filled(array, type, [&](vtkIdType i) { return magnitude(array, i); });
}

VtkSamples componentSamples(vtkDataArray& array, int component)
{
    const auto known = sampleTypeOf(array.GetDataType());
    const SampleType type = known ? *known : typeOf64Bits(array, component);
    VtkSamples result = filled(array, type, [&](vtkIdType i) { return array.GetComponent(i, component); });
    if (!known && type == SampleType::Float64)
        result.remarks.push_back(
            Message::say("Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits."));
    return result;
}

} // namespace

std::vector<VtkArray> arraysOf(vtkDataSet& data)
{
    std::vector<VtkArray> arrays;
    addArrays(*data.GetPointData(), data.GetNumberOfPoints(), false, arrays);
    addArrays(*data.GetCellData(), data.GetNumberOfCells(), true, arrays);
    return arrays;
}

bool isHelpingArray(std::string_view name)
{
    return std::ranges::find(helpingNames, name) != helpingNames.end();
}

std::vector<Message> arraysOfOtherLength(vtkDataSet& data)
{
    std::vector<Message> told;
    addOtherLengths(*data.GetPointData(), data.GetNumberOfPoints(), false, told);
    addOtherLengths(*data.GetCellData(), data.GetNumberOfCells(), true, told);
    return told;
}

Result<VtkArray> chooseArray(const std::vector<VtkArray>& arrays, const std::string& wanted)
{
    if (arrays.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("it has no array with a number for each point or cell. Write it with one, of "
                                  "points or cells that fill a volume.")};
    if (!wanted.empty() && wanted != "automatic") {
        if (const auto found = std::ranges::find(arrays, wanted, &VtkArray::name); found != arrays.end())
            return *found;
        if (const auto number = parseNumber<std::uint64_t>(wanted); number && *number >= 1 && *number <= arrays.size())
            return arrays[*number - 1];
        return Error{ErrorKind::WrongUsage,
                     Message::say("it has no array '%1'. Choose one of these: %2.", wanted, namesText(arrays))};
    }
    const auto rank = [](const VtkArray& entry) { // the smallest is taken, of equals the first
        return std::array{entry.isHelping, isConstant(entry), entry.perCell, !entry.active, entry.components > 1};
    };
    return *std::ranges::min_element(arrays, {}, rank);
}

Result<VtkSamples> samplesOf(const VtkArray& entry, const std::string& component)
{
    vtkDataArray& array = *entry.array;
    const int components = array.GetNumberOfComponents();
    const bool wantsMagnitude = component.empty() || component == "magnitude";
    const auto number = wantsMagnitude ? std::optional<std::uint32_t>(0) : parseNumber<std::uint32_t>(component);
    if (!number || *number >= static_cast<std::uint32_t>(components))
        return Error{ErrorKind::WrongUsage,
                     Message::say("its array '%1' has no component '%2'. Choose one from 0 to %3, or 'magnitude'.",
                                  printable(entry.name), component, components - 1)};
    VtkSamples result =
        components > 1 && wantsMagnitude ? magnitudeSamples(array) : componentSamples(array, static_cast<int>(*number));
    result.name = entry.name;
    if (components > 1)
        result.name += wantsMagnitude ? " (magnitude)" : " (component " + std::to_string(*number) + ")";
    return result;
}

std::vector<double> toDoubles(const VtkSamples& samples)
{
    std::vector<double> values;
    visitSampleType(samples.type, [&]<class T>() {
        const T* first = reinterpret_cast<const T*>(samples.samples.data());
        values.assign(first, first + samples.samples.size() / sizeof(T));
    });
    return values;
}

} // namespace tetra
