// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/places.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/netcdf/helper/axes.h"
#include "plugins/readers/netcdf/helper/stored_values.h"
#include "plugins/readers/netcdf/helper/wrf_places.h"

#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tetra {
namespace {

using World = std::array<WorldCoordinate, 3>;

/// What the file offers for the places of a field.
struct Offered {
    std::array<WorldCoordinate, 3> alone;                 ///< of each dimension of space, along it alone
    std::array<AxisRole, 3> roles{};                      ///< of these
    std::array<std::optional<WorldCoordinate>, 3> curved; ///< of x, y, z: along several dimensions
};

/// The variables that the file names for the places of a field besides those of its dimensions.
std::vector<const NetCdfVariable*> namedCoordinates(const NetCdfFile& file, const NetCdfField& field)
{
    std::vector<const NetCdfVariable*> found;
    for (const std::string& name : wordsOf(file.text(*field.variable, "coordinates")))
        if (const NetCdfVariable* variable = file.findFrom(*field.variable, name);
            variable != nullptr && NetCdfFile::isNumeric(*variable))
            found.push_back(variable);
    if (found.empty())
        found = wrfCoordinates(file, field);
    return found;
}

Offered offeredFor(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part)
{
    Offered offered;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t dimension = field.variable->dimensions[field.space[axis]];
        const NetCdfVariable* own = coordinateOf(file, *field.variable, dimension);
        offered.alone[axis] =
            own != nullptr ? *coordinateFor(file, field, part, *own) : WorldCoordinate{.along = {axis}};
        offered.roles[axis] = roleOf(file, *field.variable, dimension);
    }
    for (const NetCdfVariable* variable : namedCoordinates(file, field)) {
        const AxisRole role = roleOf(file, *variable);
        const auto coordinate = coordinateFor(file, field, part, *variable);
        if (!coordinate || coordinate->along.empty() || role > AxisRole::Z)
            continue;
        if (coordinate->along.size() > 1)
            offered.curved[static_cast<std::size_t>(role)] = coordinate;
        else if (offered.alone[coordinate->along[0]].variable == nullptr) {
            offered.alone[coordinate->along[0]] = *coordinate;
            offered.roles[coordinate->along[0]] = role;
        }
    }
    return offered;
}

/// Which axis of the world each dimension runs along: as their coordinates say, each once; for those that do not say,
/// what is left, z for the slowest.
std::array<std::size_t, 3> axesOfDimensions(const Offered& offered)
{
    constexpr std::size_t none = 3;
    std::array<std::size_t, 3> axes{none, none, none};
    const bool isTold = std::ranges::any_of(offered.alone, [](const auto& one) { return one.variable != nullptr; });
    for (std::size_t dimension = 0; isTold && dimension < 3; ++dimension) {
        const auto axis = static_cast<std::size_t>(offered.roles[dimension]);
        if (offered.roles[dimension] <= AxisRole::Z && std::ranges::find(axes, axis) == axes.end())
            axes[dimension] = axis;
    }
    for (std::size_t& axis : axes)
        for (std::size_t free = none; axis == none && free-- > 0;)
            if (std::ranges::find(axes, free) == axes.end())
                axis = free;
    return axes;
}

/// Curved x and y over the same dimensions come before those of the dimensions; the dimension that they leave is z.
World worldOf(const Offered& offered)
{
    World world;
    std::array<std::size_t, 3> axes = axesOfDimensions(offered);
    const auto& [x, y, z] = offered.curved;
    const bool isCurved = x && y && std::ranges::is_permutation(x->along, y->along);
    if (isCurved)
        for (std::size_t dimension = 0; dimension < 3; ++dimension) // the one that is left, else the slowest
            if (std::ranges::find(x->along, dimension) == x->along.end() || x->along.size() == 3) {
                const auto former = std::ranges::find(axes, std::size_t(2));
                std::swap(axes[dimension], *former);
                break;
            }
    for (std::size_t dimension = 0; dimension < 3; ++dimension)
        world[axes[dimension]] = offered.alone[dimension];
    if (isCurved) {
        world[0] = *x;
        world[1] = *y;
    }
    if (z)
        world[2] = *z;
    return world;
}

/// Whether the coordinates are equal steps within the rounding of their type.
bool isUniform(const WorldCoordinate& coordinate, double& first, double& step)
{
    if (coordinate.along.size() != 1 || coordinate.values.size() < 2)
        return false;
    const std::vector<double>& values = coordinate.values;
    const bool isSingle = coordinate.variable != nullptr && coordinate.variable->type == NC_FLOAT;
    first = values.front();
    step = (values.back() - first) / static_cast<double>(values.size() - 1);
    const double unit = isSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
    const double rounding = 4 * unit * std::max(std::abs(first), std::abs(values.back()));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(std::abs(values[i] - (first + static_cast<double>(i) * step)) <= rounding))
            return false;
    return step != 0 && rounding < std::abs(step) / 100;
}

void findLattice(FieldPlaces& places)
{
    Eigen::Matrix3d steps = Eigen::Matrix3d::Zero();
    Eigen::Vector3d first{0, 0, 0};
    std::array<bool, 3> isUsed{};
    places.isLattice = true;
    for (std::size_t axis = 0; axis < 3 && places.isLattice; ++axis) {
        const auto row = static_cast<Eigen::Index>(axis);
        double step = 0;
        places.isLattice = isUniform(places.world[axis], first[row], step);
        if (!places.isLattice)
            return;
        const std::size_t dimension = places.world[axis].along[0];
        steps(row, 2 - static_cast<Eigen::Index>(dimension)) = step;
        places.isLattice = !std::exchange(isUsed[dimension], true);
    }
    if (places.isLattice)
        placeBySteps(places.lattice, steps, first);
}

Status readCoordinates(const NetCdfFile& file, const NetCdfField& field, World& world)
{
    for (WorldCoordinate& coordinate : world) {
        if (coordinate.variable == nullptr) {
            coordinate.values.resize(lengthOf(file, field, field.space[coordinate.along[0]]));
            for (std::size_t at = 0; at < coordinate.values.size(); ++at)
                coordinate.values[at] = static_cast<double>(at);
            continue;
        }
        auto values = readValues(file, *coordinate.variable, coordinate.part);
        if (!values)
            return values.error();
        coordinate.values = *std::move(values);
    }
    return {};
}

/// Longitudes that begin anew go on instead, so that neighbours stay beside each other.
void continueLongitudes(const NetCdfFile& file, FieldPlaces& places)
{
    constexpr double turn = 360;
    for (WorldCoordinate& coordinate : places.world) {
        if (coordinate.variable == nullptr || coordinate.along.size() != 1 ||
            !file.text(*coordinate.variable, "units").starts_with("degree") ||
            roleOf(file, *coordinate.variable) != AxisRole::X)
            continue;
        bool changed = false;
        for (std::size_t at = 1; at < coordinate.values.size(); ++at) {
            const double turns = std::round((coordinate.values[at] - coordinate.values[at - 1]) / turn);
            changed = changed || (std::isfinite(turns) && turns != 0);
            coordinate.values[at] -= std::isfinite(turns) ? turns * turn : 0;
        }
        if (changed)
            places.remarks.push_back(Message::say(
                "Its longitudes '%1' start again within it: they were continued in full turns of 360 degrees.",
                printable(coordinate.variable->path)));
    }
}

Message nameOf(const NetCdfFile& file, const NetCdfField& field, const WorldCoordinate& coordinate)
{
    if (coordinate.variable != nullptr)
        return Message(printable(coordinate.variable->path));
    return Message::say(
        "numbers of '%1'",
        printable(file.dimensions()[field.variable->dimensions[field.space[coordinate.along[0]]]].name));
}

void tell(const NetCdfFile& file, const NetCdfField& field, FieldPlaces& places)
{
    std::array<std::string, 3> units;
    std::size_t told = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const NetCdfVariable* variable = places.world[axis].variable) {
            ++told;
            units[axis] = file.text(*variable, "units");
            if (file.text(*variable, "positive") == "down")
                places.leftOut.push_back(Message::say(
                    "Its coordinate '%1' counts downwards; it is used as z unchanged, so that up is where z decreases.",
                    printable(variable->path)));
        }
    const bool isOne = units[0] == units[1] && units[1] == units[2];
    if (isOne)
        places.lengthUnit = units[0];
    else if (told == 3)
        places.remarks.push_back(
            Message::say("Its units differ from axis to axis: %1. Its numbers were used as they are, without a unit.",
                         printable(units[0] + ", " + units[1] + ", " + units[2])));
    places.untold = untoldPlacement(told > 0, told > 0, !places.lengthUnit.empty());
    if (told > 0)
        places.taken.push_back(
            {TakenPart::Places,
             Message::say("%1, %2, %3", nameOf(file, field, places.world[0]), nameOf(file, field, places.world[1]),
                          nameOf(file, field, places.world[2])),
             told < 3});
    if (const std::string mapping = file.text(*field.variable, "grid_mapping"); !mapping.empty())
        places.leftOut.push_back(Message::say(
            "It states which map projection its coordinates belong to ('%1'), which is not used.", printable(mapping)));
}

} // namespace

std::optional<WorldCoordinate> coordinateFor(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part,
                                             const NetCdfVariable& variable)
{
    WorldCoordinate coordinate{.variable = &variable};
    for (const std::size_t dimension : variable.dimensions) {
        const auto& all = field.variable->dimensions;
        const auto place = std::ranges::find(all, dimension) - all.begin();
        const auto axis = std::ranges::find(field.space, std::size_t(place)) - field.space.begin();
        if (place == std::ssize(all) && file.dimensions()[dimension].length != 1)
            return std::nullopt;
        if (axis < 3 && std::ranges::find(coordinate.along, std::size_t(axis)) != coordinate.along.end())
            return std::nullopt;
        if (axis < 3)
            coordinate.along.push_back(std::size_t(axis));
        const bool isPlace = place < std::ssize(all) && axis == 3;
        coordinate.part.first.push_back(isPlace ? part.part.first[std::size_t(place)] : 0);
        coordinate.part.count.push_back(axis < 3 ? file.dimensions()[dimension].length : 1);
    }
    return coordinate;
}

Result<FieldPlaces> placesOf(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part)
{
    FieldPlaces places{.world = worldOf(offeredFor(file, field, part))};
    const auto size = sizeOf(file, field);
    if (const Status fits = checkLatticeSize(size); !fits)
        return fits.error();
    for (std::size_t axis = 0; axis < 3; ++axis)
        places.lattice.size[axis] = static_cast<std::uint32_t>(size[axis]);
    if (const Status read = readCoordinates(file, field, places.world); !read)
        return read.error();
    continueLongitudes(file, places);
    tell(file, field, places);
    if (const Status placed = placeByGeopotential(file, field, part, places); !placed)
        return placed.error();
    findLattice(places);
    return places;
}

std::vector<Eigen::Vector3d> positionsOf(const NetCdfFile& file, const NetCdfField& field, const FieldPlaces& places)
{
    const std::array<std::uint64_t, 3> size{lengthOf(file, field, field.space[0]),
                                            lengthOf(file, field, field.space[1]),
                                            lengthOf(file, field, field.space[2])};
    std::vector<Eigen::Vector3d> positions(size[0] * size[1] * size[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const WorldCoordinate& coordinate = places.world[axis];
        std::array<std::uint64_t, 3> strides{};
        std::uint64_t stride = 1;
        for (auto dimension = coordinate.along.rbegin(); dimension != coordinate.along.rend(); ++dimension) {
            strides[*dimension] = stride;
            stride *= size[*dimension];
        }
        std::size_t point = 0;
        for (std::uint64_t slow = 0; slow < size[0]; ++slow)
            for (std::uint64_t middle = 0; middle < size[1]; ++middle)
                for (std::uint64_t fast = 0; fast < size[2]; ++fast, ++point)
                    positions[point][static_cast<Eigen::Index>(axis)] =
                        coordinate.values[slow * strides[0] + middle * strides[1] + fast * strides[2]];
    }
    return positions;
}

} // namespace tetra
