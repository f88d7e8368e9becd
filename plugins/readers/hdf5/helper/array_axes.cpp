// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/array_axes.h"

#include "plugins/api/time_steps.h"
#include "plugins/process/further_dimensions.h"
#include "plugins/readers/hdf5/helper/attributes.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <initializer_list>

namespace tetra {
namespace {

enum class AxisRole : std::uint8_t { X, Y, Z, Time, Channel, Unknown };

AxisRole roleOf(const std::string& name)
{
    std::string lowered = name;
    std::ranges::transform(lowered, lowered.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const auto isOneOf = [&](std::initializer_list<std::string_view> words) {
        return std::ranges::find(words, std::string_view(lowered)) != words.end();
    };
    if (isOneOf({"x", "xc", "lon", "longitude", "easting"}))
        return AxisRole::X;
    if (isOneOf({"y", "yc", "lat", "latitude", "northing"}))
        return AxisRole::Y;
    if (isOneOf({"z", "zc", "lev", "level", "depth", "height", "altitude", "slice"}))
        return AxisRole::Z;
    if (isOneOf({"t", "time", "times", "frame", "timestep"}))
        return AxisRole::Time;
    return isOneOf({"c", "ch", "channel", "channels"}) ? AxisRole::Channel : AxisRole::Unknown;
}

/// The numbers of an array of one dimension, if it has as many as the dimension it is for, or one more: edges of bins,
/// which become their middles.
void readCoordinates(hid_t coordinates, std::uint64_t length, AxisSays& says)
{
    const Hdf5Id type(H5Dget_type(coordinates), H5Tclose), space(H5Dget_space(coordinates), H5Sclose);
    const H5T_class_t kind = type ? H5Tget_class(type) : H5T_NO_CLASS;
    const hssize_t count = space ? H5Sget_simple_extent_npoints(space) : 0;
    const bool areEdges = count == hssize_t(length) + 1;
    constexpr std::uint64_t most = std::uint64_t(1) << 32; // points along an axis
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Sget_simple_extent_ndims(space) != 1 || length >= most ||
        (count != hssize_t(length) && !areEdges) || H5Dget_storage_size(coordinates) == 0)
        return;
    std::vector<double> values(static_cast<std::size_t>(count));
    if (H5Dread(coordinates, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        return;
    if (areEdges) {
        for (std::size_t at = 0; at < length; ++at)
            values[at] = (values[at] + values[at + 1]) / 2;
        values.pop_back();
    }
    says.values = std::move(values);
    says.areMiddles = areEdges;
    says.areSingle = kind == H5T_FLOAT && H5Tget_size(type) <= 4;
    says.unit = attributeText(coordinates, "units");
}

std::string lastPartOf(const std::string& path)
{
    return path.substr(path.rfind('/') + 1);
}

std::string nameOfObject(hid_t object)
{
    constexpr std::size_t most = 1024;
    std::string name(most, '\0');
    const ssize_t length = H5Iget_name(object, name.data(), most);
    name.resize(length > 0 ? std::min(most - 1, std::size_t(length)) : 0);
    return lastPartOf(name);
}

/// The names of axes that NeXus has for an array: of its group, or as it once was of the array.
std::vector<std::string> nexusAxes(hid_t array, hid_t group, const std::string& name)
{
    if (attributeText(group, "signal") == name)
        return attributeTexts(group, "axes");
    std::string text = attributeText(array, "axes"); // "z:y:x", "[z,y,x]"
    std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == ' '; });
    std::vector<std::string> names;
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of(":,"), text.size());
        names.push_back(text.substr(0, end));
        text.erase(0, end + 1);
    }
    return names;
}

/// The keys of vigra's description of axes, as ilastik writes it: JSON.
std::vector<std::string> vigraAxes(hid_t array)
{
    const std::string text = attributeText(array, "axistags");
    const QJsonArray axes =
        QJsonDocument::fromJson(QByteArray::fromStdString(text)).object().value(QLatin1String("axes")).toArray();
    std::vector<std::string> names;
    for (const auto& axis : axes)
        names.push_back(axis.toObject().value(QLatin1String("key")).toString().toStdString());
    return names;
}

void addNames(const std::vector<std::string>& names, std::vector<AxisSays>& says)
{
    for (std::size_t dimension = 0; names.size() == says.size() && dimension < says.size(); ++dimension)
        if (says[dimension].name.empty() && names[dimension] != ".")
            says[dimension].name = names[dimension];
}

std::vector<AxisSays> whatIsSaid(hid_t file, const Hdf5Array& array)
{
    std::vector<AxisSays> says(array.size.size());
    const Hdf5Id opened = openArray(file, array.path);
    const std::string parent = array.path.substr(0, std::max<std::size_t>(1, array.path.rfind('/')));
    const Hdf5Id group = openGroup(file, parent);
    if (!opened || !group)
        return says;
    const auto scales = dimensionScales(opened);
    for (std::size_t dimension = 0; dimension < std::min(scales.size(), says.size()); ++dimension)
        if (!scales[dimension].empty()) {
            readCoordinates(scales[dimension].front(), array.size[dimension], says[dimension]);
            says[dimension].name = nameOfObject(scales[dimension].front());
        }
    const auto labels = attributeTexts(opened, "DIMENSION_LABELS"); // which say more than the names of scales
    for (std::size_t dimension = 0; labels.size() == says.size() && dimension < says.size(); ++dimension)
        if (roleOf(labels[dimension]) != AxisRole::Unknown || says[dimension].name.empty())
            says[dimension].name = labels[dimension];
    addNames(vigraAxes(opened), says);
    const auto axes = nexusAxes(opened, group, lastPartOf(array.path));
    addNames(axes, says);
    for (std::size_t dimension = 0; axes.size() == says.size() && dimension < says.size(); ++dimension) {
        const bool isThere = !axes[dimension].empty() && axes[dimension].find('/') == std::string::npos &&
                             H5Lexists(group, axes[dimension].c_str(), H5P_DEFAULT) > 0;
        const Hdf5Id coordinates(isThere ? H5Oopen(group, axes[dimension].c_str(), H5P_DEFAULT) : H5I_INVALID_HID,
                                 H5Oclose);
        if (coordinates && H5Iget_type(coordinates) == H5I_DATASET && !says[dimension].values)
            readCoordinates(coordinates, array.size[dimension], says[dimension]);
    }
    return says;
}

/// Of more than three dimensions those that are not of space.
void setAside(const Hdf5Array& array, const std::vector<AxisRole>& roles, std::vector<std::size_t>& candidates,
              ArrayAxes& axes)
{
    constexpr std::uint64_t mostComponents = 9;
    const auto isOfSpace = [&](std::size_t dimension) { return roles[dimension] <= AxisRole::Z; };
    if (candidates.size() > 3 && roles[candidates.back()] == AxisRole::Unknown && array.element.components == 1) {
        const std::uint64_t entries = array.size[candidates.back()];
        const bool isShortest = std::all_of(candidates.begin(), candidates.end() - 1,
                                            [&](std::size_t dimension) { return array.size[dimension] > entries; });
        const std::size_t named = static_cast<std::size_t>(std::ranges::count_if(candidates, isOfSpace));
        if (entries <= mostComponents && (isShortest || named == 3)) {
            axes.component = candidates.back();
            axes.componentIsGuessed = true;
            candidates.pop_back();
        }
    }
    while (candidates.size() > 3) {
        const auto unknown = std::ranges::find_if_not(candidates, isOfSpace);
        const auto next = unknown == candidates.end() ? candidates.begin() : unknown;
        if (!axes.time) {
            axes.time = *next;
            axes.timeIsGuessed = true;
        } else {
            axes.further.push_back(*next);
        }
        candidates.erase(next);
    }
}

/// As names say, each of x, y and z once; what is left without one is what is left, z for the slowest.
void orient(const std::vector<AxisRole>& roles, ArrayAxes& axes)
{
    constexpr std::size_t none = 3;
    axes.world = {none, none, none};
    for (std::size_t place = 0; place < 3; ++place) {
        const auto role = static_cast<std::size_t>(roles[axes.space[place]]);
        if (role < none && std::ranges::find(axes.world, role) == axes.world.end())
            axes.world[place] = role;
    }
    axes.spaceIsGuessed = std::ranges::find(axes.world, none) != axes.world.end();
    for (std::size_t& axis : axes.world)
        for (std::size_t free = none; axis == none && free-- > 0;)
            if (std::ranges::find(axes.world, free) == axes.world.end())
                axis = free;
}

Status takeComponent(const Hdf5Array& array, const ArrayAxes& axes, const Hdf5Request& request, ArrayPart& part)
{
    part.components = axes.component ? array.size[*axes.component] : array.element.components;
    const bool isMagnitude = request.component.empty() || request.component == "magnitude";
    if (part.components == 1) {
        part.component = 0;
        return isMagnitude || request.component == "0"
                   ? Status()
                   : Status(noSuchNumber(Message::say("component"), 1, request.component, "component"));
    }
    const bool isGuess = !request.componentIsGiven || axes.componentIsGuessed;
    if (isMagnitude) {
        part.taken.push_back({TakenPart::Component, Message::say("magnitude of %1", part.components), isGuess});
        return {};
    }
    const auto number = parseNumber<std::uint64_t>(request.component);
    if (!number || *number >= part.components)
        return noSuchNumber(Message::say("components, counted from 0"), part.components, request.component,
                            "component");
    part.component = *number;
    const Message taken = Message::say("%1 of %2, from 0", *number, part.components);
    part.taken.push_back({TakenPart::Component,
                          array.element.members.empty()
                              ? taken
                              : Message::say("%1: %2", taken, printable(array.element.members[*number])),
                          axes.componentIsGuessed});
    return {};
}

Status takeFurther(const Hdf5Array& array, const ArrayAxes& axes, const Hdf5Request& request, ArrayPart& part)
{
    auto numbers = parseFurtherDimensions(request.index);
    if (!numbers)
        return numbers.error();
    Message blocks;
    bool isGuess = false;
    for (const std::size_t dimension : axes.further) {
        const std::string name = axisName(axes, dimension);
        const auto given = numbers->find(name);
        const std::uint64_t number = given == numbers->end() ? 1 : given->second;
        if (number > array.size[dimension])
            return noSuchNumber(Message::say("numbers along '%1'", printable(name)), array.size[dimension],
                                std::to_string(number), "index");
        isGuess |= given == numbers->end();
        numbers->erase(name);
        part.first[dimension] = number - 1;
        const Message block = Message::say("%1 %2 of %3", printable(name), number, array.size[dimension]);
        blocks = blocks.empty() ? block : Message::say("%1, %2", blocks, block);
    }
    if (!numbers->empty())
        return Error{ErrorKind::WrongUsage,
                     Message::say("its array %1 has no further dimension '%2', which was requested with 'index'.",
                                  arrayText(array), printable(numbers->begin()->first))};
    if (!blocks.empty())
        part.taken.push_back({TakenPart::Block, blocks, isGuess});
    return {};
}

Status takeChannel(const Hdf5Array& array, const ArrayAxes& axes, const Hdf5Request& request, ArrayPart& part)
{
    const std::uint64_t channels = axes.channel ? array.size[*axes.channel] : 1;
    const auto number =
        request.channel.empty() ? std::optional<std::uint64_t>(1) : parseNumber<std::uint64_t>(request.channel);
    if (!number || *number < 1 || *number > channels)
        return noSuchNumber(Message::say("channels"), channels, request.channel, "channel");
    if (!axes.channel)
        return {};
    part.first[*axes.channel] = *number - 1;
    part.taken.push_back({TakenPart::Channel, Message::say("%1 of %2", *number, channels), request.channel.empty()});
    return {};
}

Status takeTime(const Hdf5Array& array, const ArrayAxes& axes, const Hdf5Request& request, ArrayPart& part)
{
    const std::uint64_t steps = axes.time ? array.size[*axes.time] : 1;
    if (request.timeStep < 1 || std::uint64_t(request.timeStep) > steps)
        return noSuchTimeStep(steps, request.timeStep);
    if (!axes.time)
        return {};
    const auto step = static_cast<std::uint64_t>(request.timeStep);
    part.first[*axes.time] = step - 1;
    Message taken = Message::say("%1 of %2", step, steps);
    if (const AxisSays& says = axes.says[*axes.time]; says.values) {
        const std::string time = formatNumber((*says.values)[step - 1]);
        taken = says.unit.empty() ? Message::say("%1, time %2", taken, time)
                                  : Message::say("%1, time %2 (%3)", taken, time, printable(says.unit));
    }
    part.taken.push_back({TakenPart::TimeStep, taken, !request.timeIsGiven || axes.timeIsGuessed});
    return {};
}

} // namespace

Error noSuchNumber(const Message& what, std::uint64_t there, const std::string& asked, const char* option)
{
    return {ErrorKind::WrongUsage, Message::say("it has %1 %2, and number %3 was requested with '%4'.", there, what,
                                                printable(asked), option)};
}

std::string axisName(const ArrayAxes& axes, std::size_t dimension)
{
    const std::string& name = axes.says[dimension].name;
    return name.empty() ? "d" + std::to_string(dimension + 1) : name;
}

Result<ArrayAxes> axesOf(hid_t file, const Hdf5Array& array)
{
    ArrayAxes axes{.says = whatIsSaid(file, array)};
    std::vector<AxisRole> roles;
    std::vector<std::size_t> candidates;
    for (std::size_t dimension = 0; dimension < array.size.size(); ++dimension) {
        roles.push_back(roleOf(axes.says[dimension].name));
        if (array.size[dimension] < 2)
            continue;
        if (roles.back() == AxisRole::Time && !axes.time)
            axes.time = dimension;
        else if (roles.back() == AxisRole::Channel && !axes.channel)
            axes.channel = dimension;
        else
            candidates.push_back(dimension);
    }
    if (candidates.size() < 3)
        return Error{ErrorKind::BadInput,
                     Message::say("its array %1 has fewer than three dimensions of space: the others are time or "
                                  "channels. TAn reads volumes: choose another array, or write one.",
                                  arrayText(array))};
    setAside(array, roles, candidates, axes);
    std::ranges::copy(candidates, axes.space.begin());
    orient(roles, axes);
    return axes;
}

Result<ArrayPart> partOf(const Hdf5Array& array, const ArrayAxes& axes, const Hdf5Request& request)
{
    ArrayPart part;
    part.first.assign(array.size.size(), 0);
    part.count.assign(array.size.size(), 1);
    for (const std::size_t dimension : axes.space)
        part.count[dimension] = array.size[dimension];
    for (const auto take : {takeComponent, takeFurther, takeChannel, takeTime})
        if (const Status taken = take(array, axes, request, part); !taken)
            return taken.error();
    return part;
}

} // namespace tetra
