// SPDX-License-Identifier: GPL-3.0-or-later
// The dimensions and variables: WRF Users' Guide, chapter "WRF Output Fields".
#include "plugins/readers/netcdf/helper/wrf_places.h"

#include "plugins/readers/netcdf/helper/stored_values.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr std::array<std::string_view, 3> wrfNames = {"bottom_top", "south_north", "west_east"};

const std::string& dimensionName(const NetCdfFile& file, const NetCdfField& field, std::size_t axis)
{
    return file.dimensions()[field.variable->dimensions[field.space[axis]]].name;
}

/// Whether an axis of the field is this one of WRF, at the middles of cells or at their faces.
bool isWrfAxis(const NetCdfFile& file, const NetCdfField& field, std::size_t axis)
{
    const std::string& name = dimensionName(file, field, axis);
    return name == wrfNames[axis] || name == std::string(wrfNames[axis]) + "_stag";
}

bool isAtFaces(const NetCdfFile& file, const NetCdfField& field, std::size_t axis)
{
    return dimensionName(file, field, axis).ends_with("_stag");
}

struct Block {
    std::array<std::size_t, 3> size{};
    std::vector<double> values{};
    std::size_t at(std::size_t k, std::size_t j, std::size_t i) const { return (k * size[1] + j) * size[2] + i; }
};

/// Brought along an axis from faces to the middles between them (one fewer), or from middles to faces, where the first
/// and the last one have a neighbour on one side alone.
Block moved(const Block& from, std::size_t axis, std::size_t length)
{
    Block to{.size = from.size};
    to.size[axis] = length;
    to.values.resize(to.size[0] * to.size[1] * to.size[2]);
    const std::size_t last = from.size[axis] - 1;
    const bool toFaces = length > from.size[axis];
    for (std::size_t k = 0; k < to.size[0]; ++k)
        for (std::size_t j = 0; j < to.size[1]; ++j)
            for (std::size_t i = 0; i < to.size[2]; ++i) {
                std::array<std::size_t, 3> before{k, j, i}, behind{k, j, i};
                if (toFaces)
                    before[axis] -= before[axis] > 0 ? 1 : 0;
                else
                    ++behind[axis];
                behind[axis] = std::min(behind[axis], last);
                to.values[to.at(k, j, i)] = (from.values[from.at(before[0], before[1], before[2])] +
                                             from.values[from.at(behind[0], behind[1], behind[2])]) /
                                            2;
            }
    return to;
}

/// PH or PHB at its own points, for the field's time step; nothing if it is not what WRF writes.
Result<std::optional<Block>> geopotential(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part,
                                          std::string_view name)
{
    const NetCdfVariable* variable = file.findFrom(*field.variable, name);
    if (variable == nullptr || !NetCdfFile::isNumeric(*variable) || variable->dimensions.size() != 4 || !field.time ||
        variable->dimensions[0] != field.variable->dimensions[*field.time])
        return std::optional<Block>();
    Block block;
    NetCdfPart wanted = file.whole(*variable);
    wanted.first[0] = part.timeIndex;
    wanted.count[0] = 1;
    std::ranges::copy(wanted.count.begin() + 1, wanted.count.end(), block.size.begin());
    constexpr std::array<std::string_view, 3> names = {"bottom_top_stag", "south_north", "west_east"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t length = lengthOf(file, field, field.space[axis]);
        const bool isClose = block.size[axis] >= 2 && block.size[axis] + 1 >= length && block.size[axis] <= length + 1;
        if (file.dimensions()[variable->dimensions[axis + 1]].name != names[axis] || !isClose)
            return std::optional<Block>();
    }
    auto values = readValues(file, *variable, wanted);
    if (!values)
        return values.error();
    block.values = *std::move(values);
    return std::optional(std::move(block));
}

} // namespace

std::vector<const NetCdfVariable*> wrfCoordinates(const NetCdfFile& file, const NetCdfField& field)
{
    if (!isWrfAxis(file, field, 1) || !isWrfAxis(file, field, 2))
        return {};
    const std::string ending = isAtFaces(file, field, 2) ? "_U" : isAtFaces(file, field, 1) ? "_V" : "";
    std::vector<const NetCdfVariable*> found;
    for (const char* name : {"XLONG", "XLAT"})
        if (const NetCdfVariable* variable = file.findFrom(*field.variable, name + ending);
            variable != nullptr && NetCdfFile::isNumeric(*variable))
            found.push_back(variable);
    return found;
}

Status placeByGeopotential(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part, FieldPlaces& places)
{
    constexpr double gravity = 9.81; // as WRF has it
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!isWrfAxis(file, field, axis))
            return {};
    if (places.world[2].variable != nullptr)
        return {};
    const auto perturbation = geopotential(file, field, part, "PH");
    if (!perturbation)
        return perturbation.error();
    const auto base = geopotential(file, field, part, "PHB");
    if (!base)
        return base.error();
    if (!*perturbation || !*base || (*perturbation)->size != (*base)->size)
        return {};
    Block height = **base;
    for (std::size_t point = 0; point < height.values.size(); ++point)
        height.values[point] = (height.values[point] + (*perturbation)->values[point]) / gravity;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const std::size_t length = lengthOf(file, field, field.space[axis]); length != height.size[axis])
            height = moved(height, axis, length);
    places.world[2] = {.variable = nullptr, .along = {0, 1, 2}, .values = std::move(height.values)};
    std::erase_if(places.taken, [](const Taken& taken) { return taken.part == TakenPart::Places; });
    const auto name = [&](std::size_t axis) {
        const NetCdfVariable* variable = places.world[axis].variable;
        return variable == nullptr ? Message::say("numbers") : Message(printable(variable->path));
    };
    places.taken.push_back(
        {TakenPart::Places, Message::say("%1, %2, height (PH + PHB) / 9.81 in m", name(0), name(1)), true});
    return {};
}

} // namespace tetra
