// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/text/dx_file.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/text/dx_objects.h"

#include <algorithm>
#include <array>

namespace tetra {

namespace {

/// Values on positions: those of a field, or an array beside the only grid.
struct DxChoice {
    std::string name;
    const DxGrid* grid = nullptr;
    const DxArray* array = nullptr;
    std::string positionsClass; ///< of positions that are no grid
};

template <class Map> auto* valueOf(const Map& map, std::string_view name)
{
    const auto found = map.find(name);
    return found == map.end() ? nullptr : &found->second;
}

std::string componentOf(const DxField& field, std::string_view name)
{
    const auto* const value = valueOf(field.components, name);
    return value == nullptr ? std::string() : *value;
}

/// What some programs call every field says nothing.
std::string meaningOf(const std::string& fieldName)
{
    return fieldName == "regular positions regular connections" ? std::string() : fieldName;
}

DxChoice choiceOf(const DxObjects& objects, const DxField& field)
{
    const std::string positions = componentOf(field, "positions");
    DxChoice choice{meaningOf(field.name),
                    valueOf(objects.grids, positions),
                    valueOf(objects.arrays, componentOf(field, "data")),
                    {}};
    if (choice.grid == nullptr) {
        const auto* const other = valueOf(objects.otherClasses, positions);
        choice.positionsClass = other != nullptr                                ? *other
                                : valueOf(objects.arrays, positions) != nullptr ? "array"
                                                                                : std::string();
    }
    return choice;
}

std::vector<DxChoice> dxChoices(const DxObjects& objects)
{
    std::vector<DxChoice> choices;
    for (const DxField& field : objects.fields)
        if (const DxChoice choice = choiceOf(objects, field); choice.array != nullptr)
            choices.push_back(choice);
    if (choices.empty() && objects.grids.size() == 1) // some programs name no components, or no field
        for (const std::string& name : objects.arrayOrder)
            choices.push_back({{}, &objects.grids.begin()->second, valueOf(objects.arrays, name), {}});
    if (choices.size() == 1 && objects.fields.size() == 1)
        choices.front().name = meaningOf(objects.fields.front().name);
    return choices;
}

/// Each with a name of its own, by which it can be asked for.
void nameChoices(std::vector<DxChoice>& choices)
{
    for (std::size_t i = 0; choices.size() > 1 && i < choices.size(); ++i)
        if (choices[i].name.empty())
            choices[i].name = "field " + std::to_string(i + 1);
}

/// The places of the numbers: those of the points, or the middles of the cells.
void placeDx(const DxGrid& grid, bool isOfCells, StoredVolume& volume)
{
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    Eigen::Vector3d origin(0, 0, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto column = static_cast<Eigen::Index>(axis);
        if (!grid.origin.empty())
            origin[column] = grid.origin[axis];
        if (!grid.steps.empty())
            steps.col(column) = Eigen::Map<const Eigen::Vector3d>(grid.steps[axis].data());
    }
    if (isOfCells)
        origin += steps * Eigen::Vector3d(0.5, 0.5, 0.5);
    placeBySteps(volume.lattice, steps, origin);
    volume.untold = untoldPlacement(true, true, false);
}

Error noGrid(const DxChoice& choice)
{
    if (choice.positionsClass.empty())
        return {ErrorKind::BadInput, Message::say("its values have no positions in it. Export a field with its "
                                                  "positions, all in one file.")};
    return {ErrorKind::BadInput,
            Message::say("its positions are of the class '%1', and only 'gridpositions' are read, a regular grid. "
                         "Resample the field on a regular grid, or export its points as a table or its cells as .vtu.",
                         printable(choice.positionsClass))};
}

Status checkGridForm(const DxGrid& grid)
{
    if (grid.counts.size() != 3)
        return Error{
            ErrorKind::BadInput,
            Message::say("the number of dimensions of its grid is %1, and a volume has three. Export a field of three.",
                         grid.counts.size())};
    const bool isWhole = (grid.origin.empty() || grid.origin.size() == 3) &&
                         (grid.steps.empty() || grid.steps.size() == 3) &&
                         std::ranges::all_of(grid.steps, [](const auto& step) { return step.size() == 3; });
    if (!isWhole)
        return Error{ErrorKind::BadInput, Message::say("its 'gridpositions' do not have one 'origin' and three 'delta' "
                                                       "of three numbers each. Correct them.")};
    return {};
}

/// The size of the lattice that as many values fill, and whether these are of cells.
Status sizeDx(const DxChoice& choice, bool& isOfCells, StoredVolume& volume)
{
    const auto& counts = choice.grid->counts;
    std::array<std::uint64_t, 3> size{counts[0], counts[1], counts[2]};
    if (const Status set = setStoredSize(volume, size, 1); !set)
        return set;
    isOfCells = choice.array->items == volume.lattice.cellCount() && choice.array->items != volume.lattice.pointCount();
    if (isOfCells) {
        for (std::uint64_t& count : size)
            --count;
        volume.taken.push_back({TakenPart::Places, Message::say("the middles of the cells"), false});
        if (const Status set = setStoredSize(volume, size, 1); !set)
            return set;
    }
    setStrides(volume, volume.components, true);
    if (choice.array->items != volume.lattice.pointCount())
        return Error{ErrorKind::BadInput,
                     Message::say("its array has %1 items, and its grid %2 points. Correct the numbers, or export it "
                                  "again.",
                                  choice.array->items, volume.lattice.pointCount())};
    return {};
}

Status describeNumbers(const VolumeRequest& request, const DxObjects& objects, const DxArray& array,
                       StoredVolume& volume)
{
    const auto type = dxNumberType(array.type);
    if (!type || array.isComplex)
        return Error{ErrorKind::BadInput,
                     Message::say("its values are of the type '%1', which is not read. Export real numbers.",
                                  array.isComplex ? "complex" : printable(array.type))};
    if (!array.hasData)
        return Error{ErrorKind::BadInput,
                     Message::say("its array does not state where its data are. Export it again.")};
    volume.order = array.order.value_or(std::endian::native);
    if (!array.isText && !array.order && storedSize(*type) > 1)
        volume.remarks.push_back(
            Message::say("The file does not state the byte order of its numbers: that of this computer was assumed."));
    volume.offset = array.firstByte;
    volume.endByte = array.endByte;
    volume.rest = array.isText && array.endByte ? StoredRest::Refused : StoredRest::Ignored;
    if (array.offset) {
        constexpr std::uint64_t farthest = std::uint64_t(1) << 62;
        volume.offset = objects.headerBytes + std::min(*array.offset, farthest);
    }
    volume.files = {{array.file.empty() ? request.path : request.path.parent_path() / array.file,
                     array.isText ? StoredPacking::Text : StoredPacking::None}};
    return {};
}

} // namespace

bool looksLikeDx(std::string_view beginning)
{
    return beginning.find("object") != std::string_view::npos && beginning.find("class") != std::string_view::npos;
}

Result<StoredVolume> describeDx(const VolumeRequest& request)
{
    const auto objects = parseDxObjects(request.text());
    if (!objects)
        return objects.error();
    std::vector<DxChoice> choices = dxChoices(*objects);
    if (choices.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("it has no OpenDX field with data in it. Export one field with its positions and "
                                  "data, all in one file.")};
    nameChoices(choices);
    StoredVolume volume;
    for (const DxChoice& choice : choices)
        volume.arrays.push_back(
            {.name = choice.name,
             .components = static_cast<int>(std::min<std::uint64_t>(choice.array->components, 1u << 30))});
    const auto chosen = takeArray(volume, request.values);
    if (!chosen)
        return chosen.error();
    const DxChoice& choice = choices[*chosen];
    if (choice.grid == nullptr)
        return noGrid(choice);
    if (const Status whole = checkGridForm(*choice.grid); !whole)
        return whole.error();
    constexpr std::uint64_t mostComponents = 1'000'000;
    if (choice.array->components == 0 || choice.array->components > mostComponents)
        return Error{ErrorKind::BadInput,
                     Message::say("its array has the shape %1. Export it again.", choice.array->components)};
    volume.type = dxNumberType(choice.array->type).value_or(StoredType::Float64);
    volume.components = static_cast<std::uint32_t>(choice.array->components);
    bool isOfCells = false;
    if (const Status sized = sizeDx(choice, isOfCells, volume); !sized)
        return sized.error();
    volume.arrays[*chosen].perCell = isOfCells;
    if (const Status component = takeComponent(volume, request.values); !component)
        return component.error();
    placeDx(*choice.grid, isOfCells, volume);
    if (const Status described = describeNumbers(request, *objects, *choice.array, volume); !described)
        return described.error();
    if (choices.size() > 1)
        volume.leftOut.push_back(Message::say("It holds %1 fields; the others are not read.", choices.size()));
    return volume;
}

std::vector<std::filesystem::path> companionsOfDx(const VolumeRequest& request)
{
    std::vector<std::filesystem::path> paths;
    if (const auto objects = parseDxObjects(request.text()))
        for (const DxChoice& choice : dxChoices(*objects))
            if (!choice.array->file.empty())
                paths.push_back(request.path.parent_path() / choice.array->file);
    return paths;
}

} // namespace tetra
