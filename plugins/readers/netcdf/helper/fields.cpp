// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/fields.h"

#include "plugins/api/time_steps.h"
#include "plugins/process/further_dimensions.h"
#include "plugins/readers/netcdf/helper/axes.h"
#include "plugins/readers/netcdf/helper/stored_values.h"

#include <algorithm>
#include <set>

namespace tetra {
namespace {

/// The variables that say where others lie: coordinate variables, and those that attributes name as such.
std::set<const NetCdfVariable*> coordinatesIn(const NetCdfFile& file)
{
    std::set<const NetCdfVariable*> found;
    for (const NetCdfVariable& variable : file.variables()) {
        for (const std::size_t dimension : variable.dimensions)
            if (const NetCdfVariable* coordinate = coordinateOf(file, variable, dimension))
                found.insert(coordinate);
        for (const char* attribute : {"coordinates", "bounds", "climatology", "ancillary_variables"})
            for (const std::string& name : wordsOf(file.text(variable, attribute)))
                if (const NetCdfVariable* named = file.findFrom(variable, name))
                    found.insert(named);
    }
    return found;
}

/// Which dimensions are those of space: the last three, but those first whose coordinates are of space.
std::optional<NetCdfField> fieldOf(const NetCdfFile& file, const NetCdfVariable& variable)
{
    NetCdfField field{.variable = &variable};
    const std::set<std::size_t> different(variable.dimensions.begin(), variable.dimensions.end());
    if (different.size() < variable.dimensions.size()) // a matrix
        return std::nullopt;
    std::vector<std::size_t> candidates;
    std::vector<AxisRole> roles;
    for (const std::size_t dimension : variable.dimensions)
        roles.push_back(roleOf(file, variable, dimension));
    for (std::size_t place = 0; place < variable.dimensions.size(); ++place) {
        if (roles[place] == AxisRole::Time && !field.time)
            field.time = place;
        else if (file.dimensions()[variable.dimensions[place]].length > 1)
            candidates.push_back(place);
    }
    while (candidates.size() > 3) {
        const auto unknown =
            std::ranges::find(candidates, AxisRole::Unknown, [&](std::size_t place) { return roles[place]; });
        const auto further = unknown == candidates.end() ? candidates.begin() : unknown;
        field.further.push_back(*further);
        candidates.erase(further);
    }
    if (candidates.size() < 3)
        return std::nullopt;
    std::ranges::copy(candidates, field.space.begin());
    return field;
}

Message dimensionsText(const NetCdfFile& file, const NetCdfVariable& variable)
{
    std::string names;
    for (const std::size_t dimension : variable.dimensions)
        names += (names.empty() ? "" : ", ") + printable(file.dimensions()[dimension].name);
    return Message("'" + printable(variable.path) + "' (" + names + ")");
}

/// Whether the file is of a convention of meshes without a grid, whose name is given; else empty.
std::string meshConvention(const NetCdfFile& file)
{
    const bool isUgrid = std::ranges::any_of(file.variables(), [&](const NetCdfVariable& variable) {
        return file.text(variable, "cf_role") == "mesh_topology";
    });
    if (isUgrid)
        return "UGRID";
    return file.length("nCells") && file.length("nVertices") ? "MPAS" : "";
}

/// What people call the values: "Temperature"; empty if the file does not say.
std::string longNameOf(const NetCdfFile& file, const NetCdfVariable& variable)
{
    const std::string name = file.text(variable, "long_name");
    return name.empty() ? file.text(variable, "standard_name") : name;
}

Error unknownField(const NetCdfFile& file, const std::vector<NetCdfField>& fields, const std::string& wanted)
{
    constexpr std::size_t mostNamed = 40;
    Message names;
    for (std::size_t at = 0; at < std::min(mostNamed, fields.size()); ++at) {
        const std::string longName = printable(longNameOf(file, *fields[at].variable));
        const Message name("'" + printable(fields[at].variable->path) + "'" +
                           (longName.empty() ? "" : " (" + longName + ")"));
        names = names.empty() ? name : Message::say("%1, %2", names, name);
    }
    if (fields.size() > mostNamed)
        names = Message::say("%1 and %2 more", names, fields.size() - mostNamed);
    return {ErrorKind::WrongUsage, Message::say("it has no variable '%1' with three dimensions of space. Choose one of "
                                                "these: %2.",
                                                printable(wanted), names)};
}

} // namespace

std::vector<NetCdfField> fieldsOf(const NetCdfFile& file)
{
    const auto coordinates = coordinatesIn(file);
    std::vector<NetCdfField> fields;
    for (const NetCdfVariable& variable : file.variables())
        if (NetCdfFile::isNumeric(variable))
            if (auto field = fieldOf(file, variable)) {
                field->isCoordinate = coordinates.contains(&variable);
                fields.push_back(std::move(*field));
            }
    std::ranges::stable_sort(fields, {}, &NetCdfField::isCoordinate);
    return fields;
}

Error noFields(const NetCdfFile& file)
{
    constexpr std::size_t mostNamed = 12;
    if (const std::string convention = meshConvention(file); !convention.empty())
        return {ErrorKind::BadInput, Message::say("it is a mesh that follows the conventions %1, which are not read. "
                                                  "Convert it to .vtu, for instance with ParaView.",
                                                  convention)};
    const auto coordinates = coordinatesIn(file);
    Message names;
    std::size_t count = 0;
    for (const NetCdfVariable& variable : file.variables()) {
        if (coordinates.contains(&variable) || variable.dimensions.empty() || ++count > mostNamed)
            continue;
        const Message name = dimensionsText(file, variable);
        names = names.empty() ? name : Message::say("%1, %2", names, name);
    }
    if (count == 0)
        return {ErrorKind::BadInput,
                Message::say("it holds no variables other than coordinates. Write it with values.")};
    if (count > mostNamed)
        names = Message::say("%1 and %2 more", names, count - mostNamed);
    return {ErrorKind::BadInput,
            Message::say("none of its variables has numbers along three dimensions of space with two points or more: "
                         "%1. TAn takes volumes: choose a file of several levels, or join files along one.",
                         names)};
}

Result<NetCdfField> chooseField(const NetCdfFile& file, const std::vector<NetCdfField>& fields,
                                const std::string& wanted)
{
    const NetCdfVariable* exact = file.find(wanted);
    const auto isExact = [&](const NetCdfField& field) { return field.variable == exact; };
    if (const auto found = std::ranges::find_if(fields, isExact); exact != nullptr && found != fields.end())
        return *found;
    const auto isNamed = [&](const NetCdfField& field) { return field.variable->name == wanted; };
    if (std::ranges::count_if(fields, isNamed) == 1)
        return *std::ranges::find_if(fields, isNamed);
    for (const char* attribute : {"standard_name", "long_name"}) {
        const auto isCalled = [&](const NetCdfField& field) { return file.text(*field.variable, attribute) == wanted; };
        if (exact == nullptr && std::ranges::count_if(fields, isCalled) == 1)
            return *std::ranges::find_if(fields, isCalled);
    }
    if (exact != nullptr)
        return Error{ErrorKind::WrongUsage,
                     NetCdfFile::isNumeric(*exact)
                         ? Message::say("its variable %1 does not extend along three dimensions of space with two "
                                        "points or more. Choose one that does.",
                                        dimensionsText(file, *exact))
                         : Message::say("its variable '%1' is of the type %2, which is not a number. Choose another "
                                        "one.",
                                        printable(exact->path), NetCdfFile::typeName(exact->type))};
    if (const auto number = parseNumber<std::uint64_t>(wanted); number && *number >= 1 && *number <= fields.size())
        return fields[*number - 1];
    return unknownField(file, fields, wanted);
}

std::uint64_t lengthOf(const NetCdfFile& file, const NetCdfField& field, std::size_t place)
{
    return file.dimensions()[field.variable->dimensions[place]].length;
}

std::array<std::uint64_t, 3> sizeOf(const NetCdfFile& file, const NetCdfField& field)
{
    return {lengthOf(file, field, field.space[2]), lengthOf(file, field, field.space[1]),
            lengthOf(file, field, field.space[0])};
}

Result<std::vector<double>> timesOf(const NetCdfFile& file, const NetCdfField& field)
{
    if (!field.time)
        return std::vector<double>();
    const std::size_t dimension = field.variable->dimensions[*field.time];
    if (const NetCdfVariable* times = timesAlong(file, *field.variable, dimension))
        return readValues(file, *times, file.whole(*times));
    constexpr std::uint64_t mostCounted = 1'000'000;
    std::vector<double> numbers(std::min(mostCounted, file.dimensions()[dimension].length));
    for (std::size_t at = 0; at < numbers.size(); ++at)
        numbers[at] = static_cast<double>(at);
    return numbers;
}

Result<FieldPart> partOf(const NetCdfFile& file, const NetCdfField& field, const NetCdfRequest& request)
{
    FieldPart found{.part = file.whole(*field.variable)};
    for (std::size_t& count : found.part.count)
        count = 1;
    for (const std::size_t place : field.space)
        found.part.count[place] = lengthOf(file, field, place);
    const auto steps = field.time ? static_cast<std::int64_t>(lengthOf(file, field, *field.time)) : std::int64_t(1);
    if (steps == 0)
        return Error{ErrorKind::BadInput,
                     Message::say("it has no time step: nothing was written along its dimension '%1'.",
                                  printable(file.dimensions()[field.variable->dimensions[*field.time]].name))};
    if (request.timeStep < 1 || request.timeStep > steps)
        return noSuchTimeStep(static_cast<std::uint64_t>(steps), request.timeStep);
    found.timeIndex = static_cast<std::size_t>(request.timeStep - 1);
    if (field.time)
        found.part.first[*field.time] = found.timeIndex;

    auto indices = parseFurtherDimensions(request.index);
    if (!indices)
        return indices.error();
    Message blocks;
    bool guessed = false;
    for (const std::size_t place : field.further) {
        const std::string& name = file.dimensions()[field.variable->dimensions[place]].name;
        const std::uint64_t length = lengthOf(file, field, place);
        const auto given = indices->find(name);
        const std::uint64_t number = given == indices->end() ? 1 : given->second;
        if (number > length)
            return Error{ErrorKind::WrongUsage,
                         Message::say("it has %1 numbers along '%2', and %3 was requested with 'index'.", length,
                                      printable(name), number)};
        guessed = guessed || given == indices->end();
        if (given != indices->end())
            indices->erase(given);
        found.part.first[place] = static_cast<std::size_t>(number - 1);
        const Message block = Message::say("%1 %2 of %3", printable(name), number, length);
        blocks = blocks.empty() ? block : Message::say("%1, %2", blocks, block);
    }
    if (!indices->empty())
        return Error{ErrorKind::WrongUsage,
                     Message::say("its variable %1 has no further dimension '%2', which was requested with 'index'.",
                                  dimensionsText(file, *field.variable), printable(indices->begin()->first))};
    if (!blocks.empty())
        found.taken.push_back({TakenPart::Block, blocks, guessed});
    return found;
}

} // namespace tetra
